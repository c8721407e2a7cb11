#include "signal/sar/focusing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"
#include "core/task/worker_pool.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/echo_records.hpp"
#include "signal/sar/focus_frame.hpp"
#include "signal/sar/work_matrix.hpp"

namespace sarsim::signal {

namespace {

std::unique_ptr<RowFocuser> make_row_focuser(const FocusFrame& frame) {
  switch (frame.options.method) {
    case FocusMethod::range_doppler: return make_range_doppler(frame);
    case FocusMethod::chirp_scaling: return make_chirp_scaling(frame);
    case FocusMethod::omega_k: break;
  }
  return make_omega_k(frame);
}

// The weights of pulses: the azimuth window where it is not one over a Doppler band.
std::vector<float> pulse_weights(const FocusFrame& frame) {
  std::vector<float> weights(frame.pulses, 1.0F);
  if (frame.options.doppler_bandwidth_hz > 0.0) return weights;
  const auto weight = weight_of(frame.options.azimuth_window);
  const double count = static_cast<double>(frame.pulses);
  for (std::size_t p = 0; p < frame.pulses; ++p)
    weights[p] = static_cast<float>(weight((static_cast<double>(p) + 0.5) / count - 0.5));
  return weights;
}

// The weights of bins of a range spectrum, with the scale of the transforms over range.
std::vector<float> range_weights(const FocusFrame& frame) {
  std::vector<float> weights(frame.range_size, static_cast<float>(1.0 / static_cast<double>(frame.range_size)));
  if (frame.options.range_window.kind == SarWindow::Kind::rectangular) return weights;
  const auto weight = weight_of(frame.options.range_window);
  const double scale = 1.0 / mean_weight(frame.options.range_window);
  for (std::size_t k = 0; k < weights.size(); ++k)
    weights[k] *= static_cast<float>(scale * weight(frame.range_hz(k) / std::abs(frame.waveform.bandwidth_hz)));
  return weights;
}

// What a row of the azimuth spectrum is multiplied by, apart from what depends on range.
struct DopplerRow {
  double hz = 0.0;
  double sine = 0.0;    ///< Of the direction at the carrier; beyond 1 if the Doppler frequency is that of higher ones.
  double cosine = 1.0;  ///< D there.
  double kept = 0.0;    ///< By the window over the Doppler band.
  float weight = 0.0F;  ///< 0 for frequencies that no direction has.
};

std::vector<DopplerRow> doppler_rows(const FocusFrame& frame) {
  const double band_hz = frame.options.doppler_bandwidth_hz;
  const auto weight = weight_of(frame.options.azimuth_window);
  // Omega-k weighs the frequencies of a row each by its own direction.
  const bool by_frequency = frame.options.method == FocusMethod::omega_k;
  const double most = by_frequency ? max_sine * (1.0 + frame.half_band_share()) : max_sine;
  std::vector<DopplerRow> rows(frame.image_rows);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    DopplerRow& row = rows[k];
    row.hz = frame.doppler_hz(k);
    row.sine = frame.sine(row.hz + frame.motion_doppler_hz(frame.waveform.carrier_hz));
    if (!(std::abs(row.sine) < most)) continue;
    row.cosine = std::sqrt(std::max(1.0 - row.sine * row.sine, 1.0 - max_sine * max_sine));
    row.kept = band_hz > 0.0 ? weight((row.hz - frame.options.doppler_centroid_hz) / band_hz) : 1.0;
    const double whole = row.kept / overlap_of(frame.waveform, row.hz);
    row.weight = static_cast<float>(by_frequency ? whole : whole / std::pow(row.cosine, 1.5));
  }
  return rows;
}

// 1/sqrt(rate of the Doppler frequency) of a target at 1 m, without the power of D.
double unit_chirp(const FocusFrame& frame) { return std::sqrt(0.5 * frame.wavelength_m()) / frame.track.speed_mps; }

// Time in which a Doppler frequency is passed, relative to that at the carrier in the plane across track: the mean of
// (f0/F) D^-3 over the frequencies F of the pulse, each with its own direction.
double swept(const FocusFrame& frame, double sine) {
  constexpr int steps = 16;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double stretch = 1.0 + frame.half_band_share() * ((2.0 * i + 1.0) / steps - 1.0);
    const double there = std::min(std::abs(sine) / stretch, max_sine);
    sum += 1.0 / (stretch * std::pow(1.0 - there * there, 1.5));
  }
  return sum / steps;
}

// What makes the peak of a target at 1 m the weighted mean of its echoes, times the inverse of the transform's size: by
// stationary phase the spectrum of echoes a(t) is prf a/sqrt(rate), and df = rate dt.
double amplitude_scale(const FocusFrame& frame, const std::vector<float>& pulses, const std::vector<DopplerRow>& rows) {
  const double size = static_cast<double>(frame.azimuth_size);
  if (frame.options.doppler_bandwidth_hz <= 0.0) {
    const double aperture_s = std::accumulate(pulses.begin(), pulses.end(), 0.0) * frame.track.interval_s;
    return unit_chirp(frame) / (size * aperture_s);
  }
  double sum = 0.0;
  for (const DopplerRow& row : rows)
    if (row.kept > 0.0) sum += row.kept * swept(frame, row.sine);
  return 1.0 / (sum * frame.prf_hz() * unit_chirp(frame));
}

FocusedImage empty_image(const FocusFrame& frame) {
  FocusedImage image;
  image.frame = {.plane = ImagePlane::slant_range,
                 .origin_m = frame.track.origin_m + frame.azimuth_zero_m * frame.track.along,
                 .along = frame.track.along,
                 .speed_mps = frame.track.speed_mps};
  image.azimuth = frame.shown_azimuth;
  image.azimuth.first_m -= frame.azimuth_zero_m;
  image.range = frame.shown_range;
  image.carrier_hz = frame.waveform.carrier_hz;
  image.light_speed_mps = frame.waveform.light_speed_mps;
  return image;
}

class Focuser {
 public:
  Focuser(const EchoRows& echoes, const FocusOptions& options, const core::WorkControl& control,
          core::ProgressReport progress)
      : echoes_(echoes),
        frame_(focus_frame(echoes, options)),
        control_(control),
        matrix_(frame_.image_rows, frame_.row_length(), options.memory_bytes, options.scratch_folder),
        counter_(std::move(progress), (frame_.pulses + frame_.image_rows) * frame_.row_length() + passes_over_columns(),
                 frame_.row_length()),
        azimuth_fft_(frame_.azimuth_size),
        image_fft_(frame_.image_rows) {}

  FocusedRows carry_out() {
    load();
    matrix_.each_column(
        0, frame_.range_size, control_, counter_,
        [&](std::size_t bin, std::span<std::complex<float>> column) {
          azimuth_fft_.forward(column.first(frame_.azimuth_size));
          if (frame_.unfolds) unfold(bin, column);
        },
        frame_.pulses);
    const std::unique_ptr<RowFocuser> focuser = make_row_focuser(frame_);
    focus_all_rows(*focuser);
    focus_all_columns(*focuser);
    return result();
  }

 private:
  [[nodiscard]] std::size_t passes_over_columns() const {
    return frame_.image_rows * (frame_.range_size + frame_.shown_range.count);
  }

  // Range spectra of the pulses; the rows beyond them are 0.
  void load() {
    const core::BasicFft<float> fft(frame_.range_size);
    const std::vector<float> pulses = pulse_weights(frame_);
    const std::vector<float> bins = range_weights(frame_);
    const auto load_row = [&](std::size_t p, std::span<std::complex<float>> whole) {
      const auto row = whole.first(frame_.range_size);
      echoes_.read(p, row.first(frame_.samples));
      std::fill(row.begin() + static_cast<std::ptrdiff_t>(frame_.samples), row.end(), std::complex<float>());
      fft.forward(row);
      scale_row(row, bins, pulses[p]);
    };
    matrix_.each_row(0, frame_.pulses, control_, counter_, load_row);
  }

  // Doppler frequencies grow with the range frequency: the pulses tell those within half their repetition frequency of
  // where the centroid is there, of all that the image holds.
  void unfold(std::size_t bin, std::span<std::complex<float>> column) const {
    const std::vector<std::complex<float>> sampled(column.begin(),
                                                   column.begin() + static_cast<std::ptrdiff_t>(frame_.azimuth_size));
    const double stretch = 1.0 + frame_.range_hz(bin) / frame_.waveform.carrier_hz;
    const double middle_hz = stretch * frame_.options.doppler_centroid_hz;
    const double step_hz = frame_.prf_hz() / static_cast<double>(frame_.azimuth_size);
    const auto size = static_cast<std::ptrdiff_t>(frame_.azimuth_size);
    for (std::size_t k = 0; k < column.size(); ++k) {
      const double hz = frame_.doppler_hz(k);
      column[k] = {};
      if (!(std::abs(hz - middle_hz) <= 0.5 * frame_.prf_hz())) continue;
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(std::llround(hz / step_hz)) % size;
      column[k] = sampled[static_cast<std::size_t>(at < 0 ? at + size : at)];
    }
  }

  void focus_all_rows(const RowFocuser& focuser) {
    const std::vector<DopplerRow> rows = doppler_rows(frame_);
    core::WorkerPool<RowRoom> rooms([&] { return std::make_unique<RowRoom>(frame_); });
    const auto focus_row = [&](std::size_t k, std::span<std::complex<float>> row) {
      if (rows[k].weight != 0.0F)
        rooms.lend([&](RowRoom& room) { focuser.focus(frame_.doppler_hz(k), row, room); });
      else
        std::ranges::fill(row, std::complex<float>());
    };
    matrix_.each_row(0, frame_.image_rows, control_, counter_, focus_row);
  }

  // Phases and weights of columns, along Doppler frequencies.
  struct ColumnTables {
    FrequencyRuns runs;
    std::array<std::vector<double>, 2> cosine_at_knots;
    std::vector<float> sine, weight;
  };

  // D at a Doppler frequency; that of the last direction beyond it.
  [[nodiscard]] double cosine_at(double doppler_hz) const {
    const double sine = frame_.sine(doppler_hz + frame_.motion_doppler_hz(frame_.waveform.carrier_hz));
    return std::sqrt(std::max(1.0 - sine * sine, 1.0 - max_sine * max_sine));
  }

  [[nodiscard]] ColumnTables column_tables(const std::vector<DopplerRow>& rows) const {
    ColumnTables tables{.runs = frame_.doppler_runs(), .cosine_at_knots = {}, .sine = {}, .weight = {}};
    for (std::size_t i = 0; i < tables.runs.size(); ++i)
      tables.cosine_at_knots[i] =
          knots_of(tables.runs[i].count, [&](double row) { return cosine_at(tables.runs[i].hz(row)); });
    for (const DopplerRow& row : rows) {
      tables.sine.push_back(static_cast<float>(row.sine));
      tables.weight.push_back(row.weight);
    }
    return tables;
  }

  // The azimuth spectrum of the image at a range.
  void focus_column(const RowFocuser& focuser, const ColumnTables& tables, double range_m, double flown, double size,
                    std::span<std::complex<float>> column, std::span<float> turns) const {
    constexpr double stationary_phase_turns = 0.125;  // of the spectrum of a chirp: pi/4
    const auto turns_of = [&](double cosine) {
      return focuser.azimuth_turns(range_m, cosine) + stationary_phase_turns + flown * range_m / cosine;
    };
    for (std::size_t i = 0; i < tables.runs.size(); ++i) {
      const FrequencyRun& run = tables.runs[i];
      std::vector<double> knots = tables.cosine_at_knots[i];
      for (double& knot : knots) knot = turns_of(knot);
      sample_turns(
          knots, [&](double row) { return turns_of(cosine_at(run.hz(row))); }, turns.subspan(run.begin, run.count));
    }
    // What lies beyond the image would come back on its other side, and noise from there with it: weights fall to 0
    // over the outer half of what responses are blurred by.
    const FocusFrame::Sines seen = frame_.sines_at(range_m);
    weigh_column(column, turns,
                 {.sine = tables.sine,
                  .weight = tables.weight,
                  .low = static_cast<float>(seen.low),
                  .high = static_cast<float>(seen.high),
                  .low_edge = static_cast<float>(seen.low_edge),
                  .high_edge = static_cast<float>(seen.high_edge),
                  .scale = static_cast<float>(size)});
  }

  void focus_all_columns(const RowFocuser& focuser) {
    const std::vector<DopplerRow> rows = doppler_rows(frame_);
    const ColumnTables tables = column_tables(rows);
    const double scale = amplitude_scale(frame_, pulse_weights(frame_), rows);
    const bool band = frame_.options.doppler_bandwidth_hz > 0.0;
    const double flown = flown_turns_per_m();
    core::WorkerPool<std::vector<float>> rooms([&] { return std::make_unique<std::vector<float>>(frame_.image_rows); });
    const auto focus = [&](std::size_t n, std::span<std::complex<float>> column) {
      const double range_m = frame_.range.at(static_cast<double>(n));
      // On the track itself, and before it, there is nothing to be focused.
      if (!(range_m > 0.0)) {
        std::ranges::fill(column, std::complex<float>());
        return;
      }
      const double spread = std::sqrt(range_m);
      rooms.lend([&](std::vector<float>& turns) {
        focus_column(focuser, tables, range_m, flown, band ? scale / spread : scale * spread, column, turns);
      });
      image_fft_.inverse(column);
    };
    matrix_.each_column(frame_.hidden_columns, frame_.hidden_columns + frame_.shown_range.count, control_, counter_,
                        focus);
  }

  // The antenna flies on while an echo is under way: its light time is 2 d/c longer by V^2/c^2 of itself, besides what
  // belongs to Doppler. Turns for each metre of distance; none where all of it is below a millionth of a turn.
  [[nodiscard]] double flown_turns_per_m() const {
    const double share = std::pow(frame_.track.speed_mps / frame_.waveform.light_speed_mps, 2);
    const double turns = radar::turns_per_m(frame_.waveform.carrier_hz, frame_.waveform.light_speed_mps) * share;
    const double farthest_m = frame_.range.at(static_cast<double>(frame_.range.count));
    return turns * farthest_m < 1e-6 ? 0.0 : turns;
  }

  FocusedRows result() {
    FocusedRows focused;
    focused.image = empty_image(frame_);
    focused.rows = focused.image.azimuth.count;
    focused.columns = focused.image.range.count;
    focused.on_disk = matrix_.on_disk();
    const auto size = static_cast<std::ptrdiff_t>(frame_.image_rows);
    const std::ptrdiff_t from = frame_.first_row + static_cast<std::ptrdiff_t>(frame_.hidden_rows);
    const std::ptrdiff_t first = (from % size + size) % size;
    const std::size_t column = frame_.hidden_columns;
    const auto matrix = std::make_shared<const WorkMatrix>(std::move(matrix_));
    focused.copy = [matrix, first, size, column](std::size_t row, std::span<std::complex<float>> out) {
      const std::ptrdiff_t at = (first + static_cast<std::ptrdiff_t>(row)) % size;
      matrix->read_row(static_cast<std::size_t>(at), column, out);
    };
    return focused;
  }

  const EchoRows& echoes_;
  FocusFrame frame_;
  core::WorkControl control_;
  WorkMatrix matrix_;
  WorkCounter counter_;
  core::BasicFft<float> azimuth_fft_;
  core::BasicFft<float> image_fft_;
};

// Rows are made from the record to the area, so that one that is far away is as large as one that is wide.
void check_area(const EchoRows& echoes, const AxisInterval& area, const StraightTrack& track,
                core::Problems& problems) {
  constexpr double max_samples = 0x1p40;
  const double step_m = track.speed_mps * track.interval_s;
  const double first_m = track.speed_mps * track.time_s(0.0);
  const double last_m = track.speed_mps * track.time_s(static_cast<double>(echoes.track.size()) - 1.0);
  const double columns = static_cast<double>(std::max<std::size_t>(echoes.columns, 1));
  const double rows = (std::max(area.last_m, last_m) - std::min(area.first_m, first_m)) / step_m;
  if (rows * columns <= max_samples) return;  // False for what is not a number.
  const double max_m = max_samples / columns * step_m;
  problems.push_back(
      core::error("the image area is too long in azimuth, or too far from the record")
          .found(fmt::format("{:.6g} to {:.6g} m, {:.3g} samples from the record on", area.first_m, area.last_m,
                             rows * columns))
          .expected(fmt::format("an area from {:.6g} to {:.6g} m at most, {:.3g} samples with the record",
                                last_m - max_m, first_m + max_m, max_samples))
          .hint("give a smaller area, near the record"));
}

void check_options(const EchoRows& echoes, const FocusOptions& options, const StraightTrack& track,
                   core::Problems& problems) {
  if (options.azimuth_area) check_area(echoes, *options.azimuth_area, track, problems);
  const double prf_hz = 1.0 / track.interval_s;
  if (!(options.doppler_bandwidth_hz >= 0.0 && options.doppler_bandwidth_hz <= prf_hz))
    problems.push_back(core::error("the processed Doppler bandwidth exceeds the PRF")
                           .found(fmt::format("{:.6g} Hz", options.doppler_bandwidth_hz))
                           .expected(fmt::format("0 to {:.6g} Hz, the pulse repetition frequency", prf_hz)));
  // Of a band so narrow no line of the spectrum may be left.
  const double min_hz = 2.0 * prf_hz / static_cast<double>(echoes.rows);
  if (options.doppler_bandwidth_hz > 0.0 && options.doppler_bandwidth_hz < min_hz)
    problems.push_back(
        core::error("the Doppler bandwidth is narrower than what the recorded pulses can resolve in Doppler")
            .found(fmt::format("{:.6g} Hz", options.doppler_bandwidth_hz))
            .expected(fmt::format("at least {:.3g} Hz, twice the pulse repetition frequency over the number of "
                                  "pulses, or 0 for the whole spectrum",
                                  min_hz)));
  const double max_hz = radar::turns_of(track.speed_mps, echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps);
  if (const double centroid_hz = std::abs(options.doppler_centroid_hz); !(centroid_hz < max_sine * max_hz))
    problems.push_back(
        core::error("no look direction has this Doppler centroid")
            .found(fmt::format("{:.6g} Hz", centroid_hz))
            .expected(fmt::format("below {:.6g} Hz, twice the speed over the wavelength", max_sine * max_hz))
            .hint("check the centroid"));
}

// What only the methods in the frequency domain mind.
void check_spectrum(const EchoRows& echoes, const FocusOptions& options, const StraightTrack& track,
                    core::Problems& problems) {
  const SarWaveform& waveform = echoes.waveform;
  const double max_hz = radar::turns_of(max_sine * track.speed_mps, waveform.carrier_hz, waveform.light_speed_mps);
  const double reached_hz = std::abs(options.doppler_centroid_hz) + 0.5 * options.doppler_bandwidth_hz;
  if (std::abs(options.doppler_centroid_hz) < max_hz && !(reached_hz < max_hz))
    problems.push_back(core::error("the Doppler band reaches beyond that of any look direction")
                           .found(fmt::format("{:.6g} Hz", reached_hz))
                           .expected(fmt::format("below {:.6g} Hz, twice the speed over the wavelength", max_hz))
                           .hint("check the centroid, and keep a smaller band"));
  if (options.method != FocusMethod::chirp_scaling) return;
  // Rows are not to become many times longer; but short ones may.
  constexpr double max_times = 8.0;
  constexpr double short_row = 32768.0;
  const double dispersed = dispersed_samples(waveform);
  if (dispersed <= std::max(max_times * static_cast<double>(echoes.columns), short_row)) return;
  problems.push_back(
      core::error("the sampling rate is too far above the bandwidth for chirp scaling: it lengthens the rows too much")
          .found(fmt::format("{:.6g} samples", dispersed))
          .expected(
              fmt::format("up to {:.0f} times the row's {} samples, or {:.0f}", max_times, echoes.columns, short_row))
          .hint("use omega-k or range-Doppler, or sample at about 1.5 times the bandwidth"));
}

void check_waveform(const SarWaveform& waveform, core::Problems& problems) {
  if (!(waveform.carrier_hz > 0.0 && waveform.light_speed_mps > 0.0 && waveform.sample_rate_hz > 0.0))
    problems.push_back(core::error("carrier, sampling rate and speed of light must be above 0")
                           .found(fmt::format("{:.6g} Hz", waveform.carrier_hz)));
  if (const double band_hz = std::abs(waveform.bandwidth_hz); !(band_hz > 0.0 && band_hz <= waveform.sample_rate_hz))
    problems.push_back(core::error("the pulse's bandwidth does not fit the sampling rate")
                           .found(fmt::format("{:.6g} Hz", band_hz))
                           .expected(fmt::format("above 0 and at most {:.6g} Hz", waveform.sample_rate_hz))
                           .hint("sample faster, or use a pulse of a smaller bandwidth"));
}

void check_track(const EchoRows& echoes, const StraightTrack& track, core::Problems& problems) {
  if (track.worst_interval_s > 0.01 * track.interval_s) {
    problems.push_back(core::error("the pulses are not evenly spaced, as frequency-domain algorithms require")
                           .found(fmt::format("{:.6g} s", track.worst_interval_s))
                           .expected(fmt::format("within {:.3g} s", 0.01 * track.interval_s))
                           .hint("use back projection")
                           .at("", 0, track_field));
  }
  const double limit_m = radar::wavelength_of(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps) / 16.0;
  if (track.worst_position_m <= limit_m) return;
  problems.push_back(
      core::warning("focus.track-not-straight",
                    "the antenna deviates from the straight line at constant speed that focusing assumes")
          .found(fmt::format("{:.6g} m", track.worst_position_m))
          .expected(fmt::format("at most {:.3g} m, 1/16 of the wavelength", limit_m))
          .hint("use motion compensation or back-projection")
          .at("", 0, track_field));
}

// What prevents any method; the track, if a line can be fitted to it.
std::pair<core::Problems, std::optional<StraightTrack>> common_problems(const EchoRows& echoes,
                                                                        const FocusOptions& options) {
  core::Problems problems;
  check_waveform(echoes.waveform, problems);
  if (echoes.columns < 1)
    problems.push_back(core::error("there are no samples to focus").found("0").expected("at least 1"));
  if (echoes.track.size() < 2) {
    problems.push_back(
        core::error("too few pulses to focus").found(fmt::format("{}", echoes.track.size())).expected("at least 2"));
    return {std::move(problems), std::nullopt};
  }
  const StraightTrack track = fit_straight(echoes.track);
  if (!(track.speed_mps > 0.0)) {
    problems.push_back(core::error("the antenna does not move")
                           .found(fmt::format("{:.6g} m/s", track.speed_mps))
                           .expected("a speed above 0")
                           .hint("put the radar on a platform that follows a trajectory"));
    return {std::move(problems), std::nullopt};
  }
  if (!core::has_errors(problems)) check_options(echoes, options, track, problems);
  return {std::move(problems), track};
}

}  // namespace

core::Problems problems_of_focusing(const EchoRows& echoes, const FocusOptions& options) {
  auto [problems, track] = common_problems(echoes, options);
  if (!track) return problems;
  if (!echoes.carriers_hz.empty()) {
    const auto [low, high] = std::ranges::minmax(echoes.carriers_hz);
    problems.push_back(core::error("the carrier changes from pulse to pulse, up to")
                           .found(fmt::format("{:.6g} Hz", high))
                           .expected(fmt::format("{:.6g} Hz alone", low))
                           .hint("use back-projection, which uses the carrier of each pulse"));
  }
  const bool sound = !core::has_errors(problems);
  check_track(echoes, *track, problems);
  if (sound) check_spectrum(echoes, options, *track, problems);
  return problems;
}

core::Problems problems_of_focusing_in_time(const EchoRows& echoes, const FocusOptions& options) {
  core::Problems problems = common_problems(echoes, options).first;
  if (echoes.columns == 1)
    problems.push_back(
        core::error("back projection interpolates between samples").found("1 sample in a row").expected("at least 2"));
  return problems;
}

FocusedRows rows_of(const std::shared_ptr<const FocusedImage>& image) {
  const std::shared_ptr<const std::vector<std::complex<float>>> values(image, &image->values);
  return {core::rows_in_memory(values, image->azimuth.count, image->range.count),
          {.frame = image->frame,
           .azimuth = image->azimuth,
           .range = image->range,
           .carrier_hz = image->carrier_hz,
           .light_speed_mps = image->light_speed_mps,
           .values = {}},
          false};
}

FocusedImage in_memory(const FocusedRows& rows) {
  FocusedImage image = rows.image;
  image.values.resize(rows.rows * rows.columns);
  for (std::size_t r = 0; r < rows.rows; ++r)
    rows.read(r, std::span(image.values).subspan(r * rows.columns, rows.columns));
  return image;
}

FocusedImage image_of(const EchoRows& echoes, const FocusOptions& options) {
  return empty_image(focus_frame(echoes, options));
}

FocusedRows focus_rows(const EchoRows& echoes, const FocusOptions& options, const core::WorkControl& control,
                       const core::ProgressReport& progress) {
  CORE_EXPECT(echoes.rows == echoes.track.size());
  for (const core::Problem& problem : problems_of_focusing(echoes, options))
    if (problem.severity == core::Severity::error) throw std::invalid_argument(core::to_string(problem));
  return Focuser(echoes, options, control, progress).carry_out();
}

FocusedImage focus(const SarEchoes& echoes, const FocusOptions& options, const core::WorkControl& control) {
  CORE_EXPECT(echoes.volts.size() == echoes.track.size() * echoes.samples);
  return in_memory(focus_rows(rows_of(echoes), options, control));
}

double measured_doppler_centroid_hz(const EchoRows& echoes, double near_hz, const core::WorkControl& control) {
  CORE_EXPECT(echoes.rows == echoes.track.size());
  CORE_EXPECT(std::isfinite(near_hz));
  constexpr std::size_t grain = 16;
  const std::size_t steps = echoes.track.size() - 1;
  std::vector<std::complex<double>> sums((steps + grain - 1) / grain);
  core::parallel_ranges(steps, grain, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::complex<float>> earlier(echoes.columns);
    std::vector<std::complex<float>> later(echoes.columns);
    echoes.read(begin, earlier);
    for (std::size_t p = begin; p < end; ++p) {
      echoes.read(p + 1, later);
      for (std::size_t n = 0; n < later.size(); ++n)
        sums[begin / grain] += std::complex<double>(later[n]) * std::conj(std::complex<double>(earlier[n]));
      std::swap(earlier, later);
    }
  });
  const std::complex<double> sum = std::accumulate(sums.begin(), sums.end(), std::complex<double>());
  const double prf_hz = 1.0 / fit_straight(echoes.track).interval_s;
  const double base_hz = std::arg(sum) / (2.0 * core::pi) * prf_hz;
  return base_hz + std::round((near_hz - base_hz) / prf_hz) * prf_hz;
}

double doppler_centroid_hz(const SarWaveform& waveform, double speed_mps, double squint_rad) {
  CORE_EXPECT(waveform.light_speed_mps > 0.0);
  CORE_EXPECT(speed_mps >= 0.0);
  CORE_EXPECT(std::isfinite(squint_rad));
  return radar::turns_of(speed_mps * std::sin(squint_rad), waveform.carrier_hz, waveform.light_speed_mps);
}

}  // namespace sarsim::signal

#include "signal/stepped/stepped_isar.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/maths/turns.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/work_matrix.hpp"

namespace sarsim::signal {

namespace {

core::Vec3 unit(const core::Vec3& v) { return (1.0 / core::norm(v)) * v; }

core::Vec3 sight(const TrackPoint& antenna) { return unit(-antenna.position_m); }

// Delay of a point of the target's frame, and how fast it recedes.
PulseMotion echo_of(const TrackPoint& antenna, const core::Vec3& point_m, double light_speed_mps) {
  const core::Vec3 r = antenna.position_m - point_m;
  const double distance_m = core::norm(r);
  const double speed_mps = core::dot(r, antenna.velocity_mps) / distance_m;
  return {radar::moving_delay_of(radar::there_and_back(distance_m), speed_mps, light_speed_mps), speed_mps};
}

// Weights of the bursts, sum 1.
std::vector<double> burst_weights(const WindowFunction& window, std::size_t bursts) {
  std::vector<double> weights(bursts, 1.0);
  double sum = 0.0;
  for (std::size_t b = 0; b < bursts; ++b) {
    if (window && bursts > 1) weights[b] = window(static_cast<double>(b) / static_cast<double>(bursts - 1));
    sum += weights[b];
  }
  if (!(std::abs(sum) > 1e-12)) throw std::invalid_argument("images of a turning target: the weights cancel");
  for (double& w : weights) w /= sum;
  return weights;
}

std::size_t bursts_of(const SteppedBand& band, const IsarEchoes& echoes, std::size_t pulses) {
  const std::size_t bursts = pulses / band.waveform().burst_pulses();
  if (bursts == 0 || pulses % band.waveform().burst_pulses() != 0 ||
      echoes.values.size() != bursts * band.values_per_burst())
    throw std::invalid_argument("images of a turning target: the echoes are not those of whole bursts");
  return bursts;
}

FocusedImage empty_image(const ProfileMaker& maker, const IsarPlane& plane, const ImageAxis& cross_range) {
  FocusedImage image;
  image.frame = {ImagePlane::ground_grid, {}, plane.cross_range, plane.range, 0.0};
  image.azimuth = cross_range;
  image.range = {maker.axis().first_m - plane.range_m, maker.axis().step_m, maker.axis().count, 0.0};
  image.carrier_hz = maker.band().centre_hz();
  image.light_speed_mps = maker.band().waveform().light_speed_mps;
  image.values.resize(cross_range.count * image.range.count);
  return image;
}

// Adds the cells of a pulse, turned by `delay_s` at each cell's frequency and by `turns` more.
void add_turned(const SteppedBand& band, std::size_t pulse, std::span<const std::complex<double>> values,
                double delay_s, double turns, std::complex<double> factor, std::span<std::complex<double>> joined) {
  const std::size_t first = band.first_cell(pulse);
  std::complex<double> turn = factor * core::turned_exactly(band.frequency_hz(first) * delay_s + turns);
  const std::complex<double> next = core::turned_exactly(band.cell_hz() * delay_s);
  for (std::size_t k = 0; k < band.pulse_cells(); ++k) {
    const std::complex<double> here = core::product(turn, band.weight(first + k));
    for (std::size_t g = 0; g < band.gates(); ++g)
      joined[g * band.cells() + first + k] += core::product(here, values[g * band.pulse_cells() + k]);
    turn = core::product(turn, next);
  }
}

// What the Doppler shift does to a compressed chirp: a delay of its baseband, and turns.
struct Coupling {
  double early_s = 0.0;
  double turns = 0.0;
};

Coupling coupling_of(const SteppedWaveform& w, double carrier_hz, double speed_mps) {
  if (w.sweep_rate_hz_per_s == 0.0) return {};
  const double doppler_hz = radar::doppler_of(speed_mps, carrier_hz, w.light_speed_mps);
  const double early_s = doppler_hz / w.sweep_rate_hz_per_s;
  return {early_s, carrier_hz * early_s + 0.5 * doppler_hz * early_s};
}

// A pulse as a function of delay: sum over its cells of w value exp(2 pi j (nu - middle) t), tabulated. The middle is a
// cell, so that the table repeats after 1/cell_hz.
class PulseTable {
 public:
  explicit PulseTable(const ProfileMaker& maker)
      : maker_(maker), fft_(core::good_fft_size(table_oversampling * maker.band().pulse_cells())) {}

  void load(std::size_t pulse, std::span<const std::complex<double>> values) {
    const SteppedBand& band = maker_.band();
    const std::size_t cells = band.pulse_cells();
    const std::size_t first = band.first_cell(pulse);
    values_ = values;
    middle_hz_ = band.frequency_hz(first + cells / 2);
    if (cells == 1) {
      single_ = maker_.weights()[first] * band.weight(first);
      return;
    }
    table_.assign(fft_.size(), {});
    for (std::size_t k = 0; k < cells; ++k) {
      const std::size_t place = k >= cells / 2 ? k - cells / 2 : fft_.size() - cells / 2 + k;
      table_[place] = maker_.weights()[first + k] * band.weight(first + k) * values[k];
    }
    fft_.inverse(table_);
    table_.push_back(table_.front());
  }

  // At a delay, turned by exp(2 pi j (middle t + turns)).
  [[nodiscard]] std::complex<double> at(double delay_s, double turns) const {
    const SteppedBand& band = maker_.band();
    const std::size_t gate = band.gate_of(delay_s);
    if (gate == band.gates()) return 0.0;
    const auto turn = std::complex<double>(core::turned(turns + middle_hz_ * delay_s));
    if (band.pulse_cells() == 1) return core::product(core::product(single_, values_[gate]), turn);
    const double periods = delay_s * band.cell_hz();
    const double index = (periods - std::floor(periods)) * static_cast<double>(table_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(index), table_.size() - 2);
    const double share = index - static_cast<double>(i);
    return core::product((1.0 - share) * table_[i] + share * table_[i + 1], turn);
  }

 private:
  static constexpr std::size_t table_oversampling = 16;  // Straight lines between entries: error (pi/16)^2/8.

  const ProfileMaker& maker_;
  core::Fft fft_;
  std::span<const std::complex<double>> values_;
  std::vector<std::complex<double>> table_;
  std::complex<double> single_;  // What weighs the only cell of a pulse.
  double middle_hz_ = 0.0;
};

}  // namespace

IsarPlane plane_of(std::span<const TrackPoint> seen) {
  if (seen.size() < 2) throw std::invalid_argument("images of a turning target: fewer than two pulses");
  const TrackPoint& middle = seen[seen.size() / 2];
  const core::Vec3 first = sight(seen.front());
  const core::Vec3 last = sight(seen.back());
  IsarPlane plane;
  plane.range = sight(middle);
  plane.range_m = core::norm(middle.position_m);
  plane.turn_rad = std::atan2(core::norm(core::cross(first, last)), core::dot(first, last));
  const double span_s = seen.back().time_s - seen.front().time_s;
  if (span_s > 0.0) plane.rate_radps = plane.turn_rad / span_s;
  const core::Vec3 swept = last - first - core::dot(last - first, plane.range) * plane.range;
  // Without turning any direction will do.
  const core::Vec3 aside = std::abs(plane.range.z) < 0.9 ? core::Vec3{0.0, 0.0, 1.0} : core::Vec3{1.0, 0.0, 0.0};
  plane.cross_range = core::norm(swept) > 0.0 ? unit(swept) : unit(core::cross(plane.range, aside));
  plane.lever.reserve(seen.size());
  for (const TrackPoint& antenna : seen) plane.lever.push_back(core::dot(plane.cross_range, sight(antenna)));
  return plane;
}

std::vector<PulseMotion> motion_of_origin(std::span<const TrackPoint> seen, double light_speed_mps) {
  CORE_EXPECT(!seen.empty());
  CORE_EXPECT(light_speed_mps > 0.0);
  std::vector<PulseMotion> motion;
  motion.reserve(seen.size());
  if (seen.empty()) return motion;
  // The middle one is where the image is to be: at the range, not at the delay, of the origin.
  const double middle_s = radar::delay_of(core::norm(seen[seen.size() / 2].position_m), light_speed_mps);
  for (const TrackPoint& antenna : seen) {
    motion.push_back(echo_of(antenna, {}, light_speed_mps));
    motion.back().delay_s -= middle_s;
  }
  return motion;
}

FocusedImage isar_range_doppler(const ProfileMaker& maker, const IsarEchoes& echoes, const IsarPlane& plane,
                                const ImageAxis& cross_range, const core::WorkControl& control,
                                const core::ProgressReport& progress) {
  CORE_EXPECT(cross_range.count == 0 || cross_range.step_m != 0.0);
  const SteppedBand& band = maker.band();
  const SteppedWaveform& w = band.waveform();
  const std::size_t bursts = bursts_of(band, echoes, plane.lever.size());
  if (echoes.motion.size() != plane.lever.size())
    throw std::invalid_argument("images of a turning target: not one motion for each pulse");
  const std::vector<double> weights = burst_weights(echoes.window, bursts);
  FocusedImage image = empty_image(maker, plane, cross_range);
  WorkCounter counter(progress, image.values.size(), image.range.count);
  core::parallel_ranges(cross_range.count, 1, control, [&](std::size_t row, std::size_t) {
    std::vector<std::complex<double>> joined(band.gates() * band.cells());
    const double x_m = cross_range.at(static_cast<double>(row));
    for (std::size_t p = 0; p < plane.lever.size(); ++p) {
      const std::size_t in_burst = p % w.burst_pulses();
      const double carrier_hz = w.carrier_hz(w.step_of(in_burst));
      const Coupling coupling = coupling_of(w, carrier_hz, echoes.motion[p].speed_mps);
      const double delay_s = echoes.motion[p].delay_s + radar::delay_of(x_m * plane.lever[p], w.light_speed_mps);
      add_turned(band, in_burst, echoes.values.subspan(p * band.values_per_pulse(), band.values_per_pulse()),
                 delay_s - coupling.early_s, coupling.turns, weights[p / w.burst_pulses()], joined);
    }
    std::vector<std::complex<double>> profile(image.range.count);
    maker.transform(joined, profile);
    for (std::size_t i = 0; i < profile.size(); ++i)
      image.values[row * profile.size() + i] = std::complex<float>(profile[i]);
    counter.add(profile.size());
  });
  return image;
}

FocusedImage isar_back_projection(const ProfileMaker& maker, const IsarEchoes& echoes, std::span<const TrackPoint> seen,
                                  const IsarPlane& plane, const ImageAxis& cross_range,
                                  const core::WorkControl& control, const core::ProgressReport& progress) {
  const SteppedBand& band = maker.band();
  const SteppedWaveform& w = band.waveform();
  const std::size_t bursts = bursts_of(band, echoes, seen.size());
  const std::vector<double> weights = burst_weights(echoes.window, bursts);
  FocusedImage image = empty_image(maker, plane, cross_range);
  const std::size_t columns = image.range.count;
  WorkCounter counter(progress, image.values.size(), columns);
  const TrackPoint& middle = seen[seen.size() / 2];
  constexpr std::size_t rows_at_once = 32;  // A pulse's table is made for each of them.
  core::parallel_ranges(cross_range.count, rows_at_once, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::complex<double>> sums((end - begin) * columns);
    std::vector<core::Vec3> points(sums.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t row = begin + i / columns;
      const std::size_t column = i % columns;
      points[i] = cross_range.at(static_cast<double>(row)) * plane.cross_range +
                  image.range.at(static_cast<double>(column)) * plane.range;
    }
    PulseTable table(maker);
    for (std::size_t p = 0; p < seen.size(); ++p) {
      if (control.stop != nullptr && control.stop->requested()) throw core::Interrupted();
      const std::size_t in_burst = p % w.burst_pulses();
      const double carrier_hz = w.carrier_hz(w.step_of(in_burst));
      table.load(in_burst, echoes.values.subspan(p * band.values_per_pulse(), band.values_per_pulse()));
      for (std::size_t i = 0; i < points.size(); ++i) {
        const PulseMotion echo = echo_of(seen[p], points[i], w.light_speed_mps);
        const Coupling coupling = coupling_of(w, carrier_hz, echo.speed_mps);
        sums[i] += weights[p / w.burst_pulses()] * table.at(echo.delay_s - coupling.early_s, coupling.turns);
      }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const double path_m = core::norm(middle.position_m - points[i]);
      sums[i] *= core::turned_exactly(-radar::turns_of(path_m, image.carrier_hz, w.light_speed_mps));
      image.values[begin * columns + i] = std::complex<float>(sums[i]);
    }
    counter.add(sums.size());
  });
  return image;
}

}  // namespace sarsim::signal

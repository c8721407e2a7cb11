#include "workflow/search/search_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "radar/path/path.hpp"
#include "signal/search/canceller.hpp"
#include "signal/search/cfar_calibration.hpp"
#include "signal/search/detection_peaks.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::size_t group_pulses = 256;

// Intervals that are worked on together: enough pulses to keep the threads busy.
std::size_t group_intervals(const SearchOptions& options) {
  return std::max<std::size_t>(1, group_pulses / std::max(options.step_pulses(), options.pulses));
}

std::size_t pulses_of_group(const SearchOptions& options, std::size_t intervals) {
  return (intervals - 1) * options.step_pulses() + options.recorded_pulses();
}

// Works out the intervals of a group on the pulses that it holds.
class IntervalGroups {
 public:
  IntervalGroups(const PulseRows& rows, const SearchOptions& options, const core::WorkControl& control)
      : rows_(rows),
        options_(options),
        control_(control),
        geometry_(*rows.acquisition->scene, rows.acquisition->link),
        interval_(coherent_interval(options)),
        weights_(signal::pulse_weights(interval_)),
        cfar_(detector_of(rows, options)),
        prf_hz_(1.0 / rows.acquisition->link.repetition.mean_interval_s()) {
    interval_.step = options.step_pulses();
  }

  std::vector<SearchInterval> work_out(std::size_t first_interval, std::size_t count) {
    const std::size_t first = first_interval * options_.step_pulses();
    take_pulses(first, pulses_of_group(options_, count));
    // The pulses behind the canceller's, as its output numbers them.
    const std::span<const std::complex<float>> moving = cancelled_pulses();
    std::vector<signal::RangeDopplerMap> maps =
        signal::range_doppler_maps(moving, rows_.samples(), prf_hz_, interval_, control_);
    std::vector<SearchInterval> intervals(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
      SearchInterval& interval = intervals[i];
      interval.number = first_interval + i;
      interval.first_pulse = first + maps[i].first_pulse;
      interval.map = std::move(maps[i]);
      look(interval);
    }
    if (options_.detect) detect(intervals, moving);
    return intervals;
  }

 private:
  // Reads what is not there from the group before.
  void take_pulses(std::size_t first, std::size_t count) {
    const std::size_t samples = rows_.samples();
    const std::size_t held_end = first_held_ + pulses_.size() / samples;
    const std::size_t known = first >= first_held_ && first < held_end ? std::min(held_end - first, count) : 0;
    if (known > 0)
      std::copy_n(pulses_.begin() + static_cast<std::ptrdiff_t>((first - first_held_) * samples), known * samples,
                  pulses_.begin());
    pulses_.resize(count * samples);
    first_held_ = first;
    core::parallel_ranges(count - known, 4, control_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = known + begin; p < known + end; ++p)
        rows_.read(first + p, std::span(pulses_).subspan(p * samples, samples));
    });
  }

  std::span<const std::complex<float>> cancelled_pulses() {
    if (options_.canceller == 0) return pulses_;
    cancelled_ = signal::cancelled(pulses_, rows_.samples(), options_.canceller);
    return cancelled_;
  }

  // Where radar and beam are in the middle of an interval: between its two middle pulses.
  void look(SearchInterval& interval) {
    const std::size_t pulses = options_.recorded_pulses();
    const auto at = [&](std::size_t pulse) {
      geometry_.set_pulse(rows_.number(interval.first_pulse + pulse));
      return geometry_.send_time_s();
    };
    interval.time_s = 0.5 * (at(0) + at(pulses - 1));
    at((pulses - 1) / 2);
    const core::Vec3 radar_m = geometry_.radar_pose().position_world_m;
    const core::Vec3 beam = geometry_.pointing().axis_world();
    at(pulses / 2);
    interval.radar_world_m = 0.5 * (radar_m + geometry_.radar_pose().position_world_m);
    const core::Vec3 both = beam + geometry_.pointing().axis_world();
    interval.beam_world = core::norm(both) > 0.0 ? (1.0 / core::norm(both)) * both : beam;
    interval.half_sector_rad = half_sector_rad(interval);
  }

  // From the middle to either end in steps that are far shorter than a turn unless the interval is many turns long.
  double half_sector_rad(const SearchInterval& interval) {
    constexpr std::size_t max_steps = 64;
    const std::size_t last = options_.recorded_pulses() - 1;
    double farthest_rad = 0.0;
    for (const std::size_t end : {std::size_t{0}, last}) {
      double before_rad = core::azimuth_rad(interval.beam_world);
      double swept_rad = 0.0;
      const double pulses = static_cast<double>(end) - 0.5 * static_cast<double>(last);
      const std::size_t steps = std::min(last + 1, max_steps);
      for (std::size_t step = 1; step <= steps; ++step) {
        const double pulse =
            0.5 * static_cast<double>(last) + pulses * static_cast<double>(step) / static_cast<double>(steps);
        geometry_.set_pulse(rows_.number(interval.first_pulse + static_cast<std::size_t>(std::llround(pulse))));
        const double here_rad = core::azimuth_rad(geometry_.pointing().axis_world());
        swept_rad += std::remainder(here_rad - before_rad, 2.0 * core::pi);
        before_rad = here_rad;
        farthest_rad = std::max(farthest_rad, std::abs(swept_rad));
      }
    }
    return farthest_rad;
  }

  void detect(std::vector<SearchInterval>& intervals, std::span<const std::complex<float>> moving) const {
    if (intervals.size() == 1) {
      detect_in(intervals[0], moving, control_);
      return;
    }
    core::parallel_ranges(intervals.size(), 1, control_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) detect_in(intervals[i], moving, {1, control_.stop});
    });
  }

  void detect_in(SearchInterval& interval, std::span<const std::complex<float>> moving,
                 const core::WorkControl& control) const {
    const std::vector<float> power = signal::power_of(interval.map);
    std::vector<signal::CfarDetection> found = signal::detect_cfar(power, rows_.samples(), cfar_, control);
    if (!options_.all_cells) found = signal::peaks_of(found, power, rows_.samples());
    for (const signal::CfarDetection& cell : found) interval.detections.push_back(detection_of(interval, cell, moving));
  }

  [[nodiscard]] SearchDetection detection_of(const SearchInterval& interval, const signal::CfarDetection& cell,
                                             std::span<const std::complex<float>> moving) const {
    SearchDetection detection;
    detection.interval = interval.number;
    detection.row = cell.row;
    detection.column = cell.column;
    detection.time_s = interval.time_s;
    detection.azimuth_rad = core::azimuth_rad(interval.beam_world);
    detection.magnitude_v = std::sqrt(cell.power);
    detection.threshold_v = std::sqrt(cell.threshold);
    const double noise_w = signal::noise_power(cell, cfar_);
    detection.snr = noise_w > 0.0 ? cell.power / noise_w : std::numeric_limits<double>::infinity();
    refine(interval, moving, detection);
    return detection;
  }

  // Range and Doppler between the cells.
  void refine(const SearchInterval& interval, std::span<const std::complex<float>> moving,
              SearchDetection& detection) const {
    const std::size_t samples = rows_.samples();
    const auto line = std::span(interval.map.values).subspan(detection.row * samples, samples);
    detection.range_m = range_at(options_.all_cells ? static_cast<double>(detection.column)
                                                    : signal::peak_place(line, detection.column));
    if (options_.pulses < 2) return;
    detection.doppler_hz = interval.map.doppler_hz(detection.row);
    if (!options_.all_cells) {
      std::vector<std::complex<double>> pulses(options_.pulses);
      const std::size_t first = interval.first_pulse - first_held_;
      for (std::size_t p = 0; p < pulses.size(); ++p)
        pulses[p] = weights_[p] * std::complex<double>(moving[(first + p) * samples + detection.column]);
      const double reach = 0.6 / static_cast<double>(options_.rows());
      detection.doppler_hz = prf_hz_ * signal::peak_frequency(pulses, detection.doppler_hz / prf_hz_, reach);
      detection.doppler_hz -= prf_hz_ * std::floor(detection.doppler_hz / prf_hz_ + 0.5);
    }
    detection.speed_mps =
        receding_speed_mps(*rows_.acquisition, rows_.number(interval.first_pulse), detection.doppler_hz);
  }

  [[nodiscard]] double range_at(double column) const {
    const auto before = static_cast<std::size_t>(column);
    const std::size_t after = std::min(before + 1, rows_.samples() - 1);
    const double share = column - static_cast<double>(before);
    return rows_.range_m[before] + share * (rows_.range_m[after] - rows_.range_m[before]);
  }

  const PulseRows& rows_;
  const SearchOptions& options_;
  const core::WorkControl& control_;
  simulate::PulseGeometry geometry_;
  signal::CoherentInterval interval_;
  std::vector<double> weights_;
  signal::CfarOptions cfar_;
  double prf_hz_;
  std::size_t first_held_ = 0;
  std::vector<std::complex<float>> pulses_;  // from first_held_ on
  std::vector<std::complex<float>> cancelled_;
};

}  // namespace

double receding_speed_mps(const simulate::Acquisition& acquisition, std::int64_t pulse, double doppler_hz) {
  const double wavelength_m =
      radar::wavelength_of(acquisition.link.carrier.carrier_hz(pulse), acquisition.light_speed_mps());
  return radar::speed_of(doppler_hz, wavelength_m);
}

std::size_t interval_count(const SearchOptions& options, std::size_t pulses) {
  if (pulses < options.recorded_pulses()) return 0;
  return (pulses - options.recorded_pulses()) / options.step_pulses() + 1;
}

signal::CoherentInterval coherent_interval(const SearchOptions& options) {
  signal::CoherentInterval interval;
  interval.pulses = options.pulses;
  interval.step = options.step;
  interval.frequencies = options.frequencies;
  // The weight at (p + 1/2)/N: no pulse is lost to a weight of 0 at the ends.
  if (options.window.kind != signal::SarWindow::Kind::rectangular)
    interval.window = [weight = signal::weight_of(options.window), n = static_cast<double>(options.pulses)](double x) {
      return weight((x - 0.5) * (n - 1.0) / n);
    };
  return interval;
}

signal::CfarOptions detector_of(const PulseRows& rows, const SearchOptions& options) {
  signal::CfarOptions cfar = options.cfar;
  if (options.detector_known) return cfar;
  signal::NoiseCorrelation noise{rows.noise_correlation, {1.0}};
  if (cfar.reference_rows > 0) {
    // The rows of a map are a transform: their correlation is that of the squared weights.
    noise.along_rows.assign(options.rows(), 0.0);
    std::ranges::transform(signal::pulse_weights(coherent_interval(options)), noise.along_rows.begin(),
                           [](double w) { return w * w; });
    core::Fft(noise.along_rows.size()).forward(noise.along_rows);
    const std::complex<double> power = noise.along_rows[0];
    for (std::complex<double>& rho : noise.along_rows) rho /= power;
  }
  const auto squared = [](const std::vector<std::complex<double>>& correlation) {
    std::vector<double> powers(correlation.size());
    std::ranges::transform(correlation, powers.begin(), [](const std::complex<double>& rho) { return std::norm(rho); });
    return powers;
  };
  cfar.independence = signal::independence(squared(noise.along_columns), squared(noise.along_rows), cfar);
  cfar.calibration = signal::cfar_calibration(noise, cfar, options.rows(), rows.samples());
  return cfar;
}

void each_interval(const PulseRows& rows, const SearchOptions& options, const core::WorkControl& control,
                   const core::ProgressReport& progress, const std::function<void(const SearchInterval&)>& consume) {
  if (options.pulses == 0) throw std::invalid_argument("intervals without pulses");
  const std::size_t count = interval_count(options, rows.pulses());
  const std::size_t at_once = group_intervals(options);
  IntervalGroups groups(rows, options, control);
  for (std::size_t first = 0; first < count; first += at_once) {
    if (control.stop != nullptr && control.stop->requested()) throw core::Interrupted();
    const std::size_t end = std::min(first + at_once, count);
    for (const SearchInterval& interval : groups.work_out(first, end - first)) consume(interval);
    if (progress) progress({end, count, options.step_pulses() * rows.samples()});
  }
}

double interval_bytes(const SearchOptions& options, std::size_t pulses, std::size_t samples) {
  const std::size_t intervals = std::clamp<std::size_t>(interval_count(options, pulses), 1, group_intervals(options));
  const auto held = static_cast<double>(pulses_of_group(options, intervals)) * (options.canceller > 0 ? 2.0 : 1.0);
  const auto mapped = static_cast<double>(intervals * options.rows());
  // Of a map also the power.
  return static_cast<double>(samples) * (8.0 * held + 12.0 * mapped);
}

}  // namespace sarsim::workflow

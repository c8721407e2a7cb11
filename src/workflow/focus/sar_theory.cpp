#include "workflow/focus/sar_theory.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <mutex>
#include <span>
#include <utility>

#include "core/maths/constants.hpp"
#include "radar/path/path.hpp"
#include "signal/measure/aperture_response.hpp"
#include "signal/measure/image_quality.hpp"
#include "signal/sar/ground_grid.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/target_aspects.hpp"
#include "workflow/focus/tone_response.hpp"

namespace sarsim::workflow {

namespace {

// Whose pulses an image is made of.
enum class Domain {
  frequency,  // as they were sent
  resampled,  // interpolated to even places along the line
  time,       // as they were sent, each with its true Doppler frequency
};

// The part that each look has in the image of its target.
class LookWeights {
 public:
  LookWeights(const TargetAspects& looks, const signal::FocusOptions& options, std::size_t pulses, Domain domain)
      : looks_(looks),
        options_(options),
        pulses_(static_cast<double>(pulses)),
        weight_(signal::weight_of(options.azimuth_window)),
        domain_(domain) {}

  [[nodiscard]] Domain domain() const { return domain_; }
  [[nodiscard]] double of(std::size_t i, std::span<const TargetAspect> seen) const {
    const double from_centroid_hz = seen[i].doppler_hz - options_.doppler_centroid_hz;
    if (options_.doppler_bandwidth_hz > 0.0)
      return weight_(from_centroid_hz / options_.doppler_bandwidth_hz) * density(i, seen);
    return weight_((pulse(i, seen) + 0.5) / pulses_ - 0.5) * density(i, seen);
  }
  /// Whether its Doppler frequency is taken for what it is.
  [[nodiscard]] bool sampled(const TargetAspect& look) const {
    return domain_ == Domain::time ||
           std::abs(look.doppler_hz - options_.doppler_centroid_hz) <= 0.5 / looks_.track().interval_s;
  }

 private:
  // That stands at the look's place in the image's record.
  [[nodiscard]] double pulse(std::size_t i, std::span<const TargetAspect> seen) const {
    const auto sent = static_cast<double>(looks_.pulse(i));
    const double length_s = seen.back().time_s - seen.front().time_s;
    if (domain_ != Domain::resampled || !(length_s > 0.0)) return sent;
    return (seen[i].time_s - seen.front().time_s) / length_s * static_cast<double>(looks_.pulse(seen.size() - 1));
  }
  // Of evenly spaced pulses where those that were sent stand this far apart, in parts of the mean.
  [[nodiscard]] double density(std::size_t i, std::span<const TargetAspect> seen) const {
    const double length_s = seen.back().time_s - seen.front().time_s;
    if (domain_ != Domain::resampled || !(length_s > 0.0)) return 1.0;
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, seen.size() - 1);
    return (seen[after].time_s - seen[before].time_s) / static_cast<double>(after - before) *
           static_cast<double>(seen.size() - 1) / length_s;
  }

  const TargetAspects& looks_;
  const signal::FocusOptions& options_;
  double pulses_;
  std::function<double(double)> weight_;
  Domain domain_;
};

// Sine of the angle by which the beam's middle looks ahead.
double centroid_sine(const TargetAspects& looks, const signal::FocusOptions& options,
                     const signal::SarWaveform& waveform) {
  return radar::range_of_cycle(waveform.carrier_hz, waveform.light_speed_mps) * options.doppler_centroid_hz /
         looks.track().speed_mps;
}

// Sum of the weights that focusing divides by: over the pulses that it uses; in the frequency domain, over those that
// sweep the whole of a band, flown or not.
double sum_of_weights(const TargetAspects& looks, const LookWeights& weights, const signal::FocusOptions& options,
                      const signal::SarWaveform& waveform, std::span<const TargetAspect> seen, double range_m) {
  if (options.doppler_bandwidth_hz <= 0.0 || weights.domain() == Domain::time) {
    double sum = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) sum += weights.of(i, seen);
    return sum;
  }
  const double wavelength_m = radar::wavelength_of(waveform.carrier_hz, waveform.light_speed_mps);
  const double speed = looks.track().speed_mps;
  const double sine = centroid_sine(looks, options, waveform);
  const double rate_hzps = 2.0 * speed * speed * std::pow(1.0 - sine * sine, 1.5) / (wavelength_m * range_m);
  const double interval_s = looks.track().interval_s * static_cast<double>(looks.pulse(1));
  return signal::mean_weight(options.azimuth_window) * options.doppler_bandwidth_hz / (rate_hzps * interval_s);
}

bool is_plain_chirp(const radar::Pulse& pulse) {
  return pulse.kind == radar::Pulse::Kind::chirp && pulse.envelope == radar::Pulse::Envelope::rectangular;
}

// Of the radar, over the pulse, where it is in compressed data; nothing for an even one.
signal::WindowFunction recorded_window(const simulate::Acquisition& acquisition) {
  if (!acquisition.reception.is_compressed()) return {};
  constexpr int points = 64;
  for (int i = 0; i <= points; ++i)
    if (acquisition.link.window(static_cast<double>(i) / points) != 1.0) return acquisition.link.window;
  return {};
}

// What weighs the samples of a pulse: windows over the band of a chirp are windows over its time.
signal::WindowFunction pulse_weight(const simulate::Acquisition& acquisition, const signal::SarWindow& window) {
  const signal::WindowFunction recorded = recorded_window(acquisition);
  if (acquisition.link.pulse.kind != radar::Pulse::Kind::chirp) return recorded;
  return [recorded, focused = signal::weight_of(window)](double x) {
    return focused(std::clamp(x, 0.0, 1.0) - 0.5) * (recorded ? recorded(x) : 1.0);
  };
}

std::optional<signal::ResponseFigures> range_theory(const simulate::Acquisition& acquisition,
                                                    const signal::SarWaveform& waveform,
                                                    const signal::SarWindow& window) {
  const double band_hz = std::abs(waveform.bandwidth_hz);
  // A pulse of less than a cycle of its sweep is no chirp: its length gives the resolution.
  if (!is_plain_chirp(acquisition.link.pulse) || !(band_hz * waveform.pulse_width_s >= 1.0)) return std::nullopt;
  // Sampled so coarsely, it is nothing but ghosts of itself.
  constexpr double min_sampling = 1.0 / 16.0;
  if (!(waveform.sample_rate_hz >= min_sampling * band_hz)) return std::nullopt;
  signal::ResponseFigures figures = signal::theoretical_figures(
      window, band_hz * waveform.pulse_width_s, waveform.sample_rate_hz / band_hz, recorded_window(acquisition));
  const double cell_m = radar::range_of_cycle(band_hz, waveform.light_speed_mps);
  figures.width *= cell_m;
  figures.null *= cell_m;
  return figures;
}

// The compressed pulse over range, as the aperture of a target sums it up. Made when a target needs it.
class RangePulse {
 public:
  RangePulse(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes, const signal::SarWindow& window)
      : acquisition_(acquisition), waveform_(echoes.waveform), window_(window) {
    // The band that stepped carriers fill together has no theory of its response.
    if (echoes.carriers_hz.empty()) figures_ = range_theory(acquisition, waveform_, window);
  }

  /// Of a narrow aperture; nothing where the pulse has no theory.
  [[nodiscard]] const std::optional<signal::ResponseFigures>& figures() const { return figures_; }
  [[nodiscard]] const signal::SarWaveform& waveform() const { return waveform_; }
  [[nodiscard]] signal::ApertureBand band() const {
    return {radar::turns_per_m(waveform_.carrier_hz, waveform_.light_speed_mps),
            radar::turns_per_m(std::abs(waveform_.bandwidth_hz), waveform_.light_speed_mps)};
  }
  /// @param coherence  of what folds over the sampled band, see `UsedLooks`
  [[nodiscard]] const signal::SampledResponse& response(double coherence) const {
    constexpr double half = 0.5;
    return coherence > half ? table(signal::BeyondSampling::folded) : table(signal::BeyondSampling::lost);
  }
  /// What is left of the peak where what folds adds up with that coherence, in parts.
  [[nodiscard]] double kept(double coherence) const {
    constexpr double whole = 0.999;
    if (!figures_ || coherence > whole) return 1.0;
    const auto peak = [this](signal::BeyondSampling beyond) {
      const signal::SampledResponse& response = table(beyond);
      return std::abs(response.values[response.peak]);
    };
    const double lost = peak(signal::BeyondSampling::lost) / peak(signal::BeyondSampling::folded);
    return lost + coherence * (1.0 - lost);
  }

 private:
  [[nodiscard]] const signal::SampledResponse& table(signal::BeyondSampling beyond) const {
    const bool lost = beyond == signal::BeyondSampling::lost;
    std::call_once(lost ? lost_made_ : folded_made_, [&] { (lost ? lost_ : folded_) = made(beyond); });
    return lost ? lost_ : folded_;
  }
  [[nodiscard]] signal::SampledResponse made(signal::BeyondSampling beyond) const {
    constexpr double max_time_bandwidth = 2048.0;  // Sidelobes within 60 cells change by less than 1e-3 beyond it.
    const double band_hz = std::abs(waveform_.bandwidth_hz);
    return signal::theoretical_response(window_, std::min(band_hz * waveform_.pulse_width_s, max_time_bandwidth),
                                        waveform_.sample_rate_hz / band_hz, recorded_window(acquisition_), beyond);
  }

  const simulate::Acquisition& acquisition_;
  const signal::SarWaveform& waveform_;
  const signal::SarWindow& window_;
  std::optional<signal::ResponseFigures> figures_;
  mutable std::once_flag folded_made_, lost_made_;
  mutable signal::SampledResponse folded_, lost_;
};

// What is known of an image for the theory of its targets.
struct ImageGeometry {
  signal::ResponseAxes axes{};                 // of the cuts
  std::optional<signal::ImageFrame> ground{};  // of a ground grid
  std::optional<signal::ImageFrame> slant{};   // the line that fits the track, where there is a ground grid
  std::vector<core::Vec3> antennas_m{};        // of the looks, where there is a ground grid
};

// The looks that a target's image is made of.
struct UsedLooks {
  std::vector<std::size_t> numbers;
  std::vector<double> parts;  // weight times amplitude, of each
  double sum = 0.0;
  double whole = 0.0;      // the same had all been recorded
  std::size_t middle = 0;  // look number
  /// Of the part of the pulse's spectrum that folds over the sampled band: as the echo migrates through samples, it
  /// turns by a cycle for each. 1: it adds up, 0: its mean is 0.
  double coherence = 1.0;
};

UsedLooks used_looks(const LookWeights& weights, std::span<const TargetAspect> seen, double sample_rate_hz) {
  UsedLooks used;
  double moment = 0.0, whole_moment = 0.0;
  std::complex<double> folded;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double part = weights.of(i, seen) * seen[i].amplitude;
    if (!(part > 0.0) || !weights.sampled(seen[i])) continue;
    used.whole += part;
    whole_moment += part * static_cast<double>(i);
    if (!(seen[i].share > 0.0)) continue;
    used.numbers.push_back(i);
    used.parts.push_back(part * seen[i].share);
    used.sum += used.parts.back();
    moment += used.parts.back() * static_cast<double>(i);
    const double samples = (seen[i].delay_s - seen.front().delay_s) * sample_rate_hz;
    folded += std::polar(used.parts.back(), 2.0 * core::pi * (samples - std::round(samples)));
  }
  if (used.sum > 0.0) used.coherence = std::abs(folded) / used.sum;
  if (used.whole > 0.0)
    used.middle =
        static_cast<std::size_t>(std::llround(used.sum > 0.0 ? moment / used.sum : whole_moment / used.whole));
  return used;
}

// The looks of a target as a cut through its image has them.
class CutLooks {
 public:
  CutLooks(const UsedLooks& used, std::span<const TargetAspect> seen, double sine_per_hz, const ImageGeometry& image,
           const signal::ImagePlace& on_image)
      : used_(used), seen_(seen), sine_per_hz_(sine_per_hz), image_(image) {
    if (image.ground)
      point_m_ =
          image.ground->origin_m + on_image.azimuth_m * image.ground->along + on_image.range_m * image.ground->across;
  }

  [[nodiscard]] std::vector<signal::ApertureLook> along(const signal::ImagePlace& direction) const {
    std::vector<signal::ApertureLook> looks;
    looks.reserve(used_.numbers.size());
    for (std::size_t i = 0; i < used_.numbers.size(); ++i)
      looks.push_back({slope(used_.numbers[i], direction), used_.parts[i]});
    return looks;
  }

 private:
  // How the distance grows with a step in that direction.
  [[nodiscard]] double slope(std::size_t look, const signal::ImagePlace& direction) const {
    if (image_.ground) {
      const core::Vec3 sight_m = point_m_ - image_.antennas_m[look];
      return core::dot(sight_m,
                       direction.azimuth_m * image_.ground->along + direction.range_m * image_.ground->across) /
             core::norm(sight_m);
    }
    const double sine = std::clamp(sine_per_hz_ * seen_[look].doppler_hz, -1.0, 1.0);
    return direction.azimuth_m * sine + direction.range_m * std::sqrt(1.0 - sine * sine);
  }

  const UsedLooks& used_;
  std::span<const TargetAspect> seen_;
  double sine_per_hz_;
  const ImageGeometry& image_;
  core::Vec3 point_m_;
};

// Whether range and azimuth are one rectangle of wave numbers. The curvature of the aperture moves its ends by less
// than a hundredth; the relative bandwidth changes the farthest side lobe that counts by less than a fortieth, the
// first by less than a thousandth.
bool is_separable(const std::vector<signal::ApertureLook>& along_sight, const signal::ApertureBand& band) {
  constexpr double part = 0.01;
  constexpr double relative_band = 0.02;
  const auto [least, most] = std::ranges::minmax(along_sight, {}, &signal::ApertureLook::slope);
  return band.carrier_per_m * (most.slope - least.slope) < part * band.band_per_m &&
         band.band_per_m < relative_band * band.carrier_per_m;
}

std::optional<signal::ResponseFigures> figures_of_looks(const std::vector<signal::ApertureLook>& looks,
                                                        double carrier_per_m) {
  std::vector<Tone> tones;
  tones.reserve(looks.size());
  for (const signal::ApertureLook& look : looks) tones.push_back({carrier_per_m * look.slope, look.weight});
  return figures_of_tones(tones);
}

// @param even_band  a Doppler band is kept, the same at all frequencies of the pulse: azimuth does not widen with them
void set_figures(const CutLooks& cuts, const UsedLooks& used, const ImageGeometry& image, const RangePulse& pulse,
                 bool even_band, TargetTheory& theory) {
  const std::vector<signal::ApertureLook> azimuth = cuts.along(image.axes.azimuth);
  const signal::ApertureBand band = pulse.band();
  // A pulse of which a part is missing has another spectrum.
  constexpr double unseen = 1e-3;
  if (!pulse.figures() || !(used.sum > (1.0 - unseen) * used.whole)) {
    theory.azimuth = figures_of_looks(azimuth, band.carrier_per_m);
    return;
  }
  const std::vector<signal::ApertureLook> range = cuts.along(image.axes.range);
  // Where what folds is lost, the pulse is another one than that of the figures.
  constexpr double same_pulse = 0.998;
  if (!image.ground && is_separable(range, band) && (used.coherence > 0.5 || pulse.kept(0.0) > same_pulse)) {
    theory.azimuth = figures_of_looks(azimuth, band.carrier_per_m);
    theory.range = pulse.figures();
    return;
  }
  const signal::SampledResponse& response = pulse.response(used.coherence);
  theory.azimuth =
      even_band ? figures_of_looks(azimuth, band.carrier_per_m) : signal::aperture_figures(azimuth, band, response);
  theory.range = signal::aperture_figures(range, band, response);
}

signal::ImagePlace plus(const signal::ImagePlace& a, const signal::ImagePlace& b) {
  return {a.azimuth_m + b.azimuth_m, a.range_m + b.range_m};
}
signal::ImagePlace minus(const signal::ImagePlace& a, const signal::ImagePlace& b) {
  return {a.azimuth_m - b.azimuth_m, a.range_m - b.range_m};
}

// What a target is in an image, for all targets of a plan.
class Theories {
 public:
  Theories(const TargetAspects& looks, const LookWeights& weights, const signal::EchoRows& echoes,
           const signal::FocusOptions& options, const RangePulse& pulse, const ImageGeometry& image)
      : looks_(looks), weights_(weights), echoes_(echoes), options_(options), pulse_(pulse), image_(image) {}

  [[nodiscard]] TargetTheory of(std::size_t number, std::span<const TargetAspect> seen) const {
    TargetTheory theory;
    theory.target = number;
    const UsedLooks used = used_looks(weights_, seen, echoes_.waveform.sample_rate_hz);
    if (!(used.whole > 0.0)) return theory;
    const TargetAspect& middle = seen[used.middle];
    theory.place = looks_.place(middle, middle.doppler_hz);
    if (!(used.sum > 0.0)) {
      theory.unrecorded = true;
      if (image_.ground) theory.place = lay_on_ground(number, used, shift_by_air(middle), theory.place);
      return theory;
    }
    theory.amplitude = pulse_.kept(used.coherence) * used.sum /
                       sum_of_weights(looks_, weights_, options_, echoes_.waveform, seen, theory.place.range_m);
    const std::optional<TargetBlur> blur = blur_by_motion(number, used, seen, theory.place);
    if (blur) theory.place.azimuth_m += blur->azimuth_m;
    signal::ImagePlace on_image = theory.place;
    const signal::ImagePlace shift = shift_by_air(middle);
    if (image_.ground) on_image = lay_on_ground(number, used, shift, theory.place);
    const std::complex<double> left = blur ? blur->kept : left_by_air(used, seen, theory.place, shift);
    theory.amplitude *= std::abs(left);
    theory.phase_rad = std::remainder(std::arg(left) - 2.0 * core::pi * turns_of(theory.place.range_m), 2.0 * core::pi);
    const double per_hz =
        radar::range_of_cycle(echoes_.waveform.carrier_hz, echoes_.waveform.light_speed_mps) / looks_.track().speed_mps;
    set_figures(CutLooks(used, seen, per_hz, image_, on_image), used, image_, pulse_,
                options_.doppler_bandwidth_hz > 0.0 && weights_.domain() != Domain::time, theory);
    if (blur) blur_figures(CutLooks(used, seen, per_hz, image_, on_image), *blur, theory);
    theory.place = on_image;
    if (image_.ground) theory.centre = centre_on_ground(used, seen, per_hz, on_image);
    return theory;
  }

 private:
  // What is left of the wave vector of the looks' middle besides that of closest approach, along the ground.
  [[nodiscard]] signal::SpectrumCentre centre_on_ground(const UsedLooks& used, std::span<const TargetAspect> seen,
                                                        double sine_per_hz, const signal::ImagePlace& on_image) const {
    const signal::ImageFrame& grid = *image_.ground;
    const core::Vec3& line = image_.slant->along;
    double doppler_hz = 0.0;
    for (std::size_t i = 0; i < used.numbers.size(); ++i)
      doppler_hz += used.parts[i] / used.sum * seen[used.numbers[i]].doppler_hz;
    const double sine = std::clamp(doppler_hz * sine_per_hz, -1.0, 1.0);
    const core::Vec3 point_m =
        grid.origin_m + on_image.azimuth_m * grid.along + on_image.range_m * grid.across - image_.slant->origin_m;
    const core::Vec3 sight_m = point_m - core::dot(point_m, line) * line;
    const double sight = core::norm(sight_m);
    const core::Vec3 centre = doppler_hz / looks_.track().speed_mps * line +
                              (sight > 0.0 ? turns_of(std::sqrt(1.0 - sine * sine) - 1.0) / sight : 0.0) * sight_m;
    return {core::dot(centre, grid.along), core::dot(centre, grid.across)};
  }

  [[nodiscard]] double turns_of(double range_m) const {
    return radar::turns_of(range_m, echoes_.waveform.carrier_hz, echoes_.waveform.light_speed_mps);
  }

  // What its own motion makes of a target's peak; nothing for one that rests, or behind an atmosphere.
  [[nodiscard]] std::optional<TargetBlur> blur_by_motion(std::size_t number, const UsedLooks& used,
                                                         std::span<const TargetAspect> seen,
                                                         const signal::ImagePlace& place) const {
    if (seen[used.middle].late_m != 0.0 || looks_.resting_place(number)) return std::nullopt;
    const double speed_mps = looks_.track().speed_mps;
    std::vector<BlurredLook> looks;
    looks.reserve(used.numbers.size());
    for (std::size_t i = 0; i < used.numbers.size(); ++i) {
      const TargetAspect& look = seen[used.numbers[i]];
      const double at_rest_m = std::hypot(place.range_m, place.azimuth_m - speed_mps * look.time_s);
      looks.push_back({look.doppler_hz / speed_mps, used.parts[i], look.distance_m - at_rest_m});
    }
    return blur_of(looks, pulse_.band().carrier_per_m, pulse_.band().band_per_m);
  }

  // The responses of a target that moves: range is not predicted where its echoes walk through a quarter of a cell.
  void blur_figures(const CutLooks& cuts, const TargetBlur& blur, TargetTheory& theory) const {
    constexpr double max_walk_cells = 0.25;
    const std::vector<signal::ApertureLook> azimuth = cuts.along(image_.axes.azimuth);
    std::vector<Tone> tones;
    tones.reserve(azimuth.size());
    for (std::size_t i = 0; i < azimuth.size(); ++i)
      tones.push_back({pulse_.band().carrier_per_m * azimuth[i].slope, blur.parts[i]});
    theory.azimuth = figures_of_tones(tones);
    if (blur.walk_m * pulse_.band().band_per_m > max_walk_cells) theory.range.reset();
  }

  // By how much the atmosphere moves a target, about the line.
  [[nodiscard]] signal::ImagePlace shift_by_air(const TargetAspect& look) const {
    if (look.late_m == 0.0) return {};
    const TargetAspect vacuum = look.in_vacuum();
    return minus(looks_.place(look, look.doppler_hz), looks_.place(vacuum, vacuum.doppler_hz));
  }

  // Whether the antenna is so far off the line that fits the track, as on a circle, that the line tells nothing.
  [[nodiscard]] bool leaves_line(const UsedLooks& used, const core::Vec3& point_m) const {
    constexpr double share = 0.05;  // of the distance
    const signal::ImageFrame& line = *image_.slant;
    return std::ranges::any_of(used.numbers, [&](std::size_t look) {
      const core::Vec3 from_origin_m = image_.antennas_m[look] - line.origin_m;
      const core::Vec3 off_m = from_origin_m - core::dot(from_origin_m, line.along) * line.along;
      return core::norm(off_m) > share * core::norm(image_.antennas_m[look] - point_m);
    });
  }
  // The mean of the places in the plane that are as far from each look's antenna and in its direction.
  [[nodiscard]] signal::ImagePlace laid_by_looks(const UsedLooks& used, const core::Vec3& point_m,
                                                 double above_m) const {
    const signal::ImageFrame& grid = *image_.ground;
    const core::Vec3 up = core::cross(grid.along, grid.across);
    const core::Vec3 below_m = point_m - above_m * up;
    core::Vec3 mean_m;
    for (std::size_t i = 0; i < used.numbers.size(); ++i) {
      const core::Vec3& antenna_m = image_.antennas_m[used.numbers[i]];
      const double height_m = core::dot(antenna_m - below_m, up);
      const core::Vec3 level_m = below_m - (antenna_m - height_m * up);
      const double level = core::norm(level_m);
      const core::Vec3 sight_m = point_m - antenna_m;
      const double reach_m = std::sqrt(std::max(0.0, core::dot(sight_m, sight_m) - height_m * height_m));
      mean_m = mean_m + used.parts[i] / used.sum * (level > 0.0 ? reach_m / level - 1.0 : 0.0) * level_m;
    }
    return signal::place_of(grid, below_m + mean_m);
  }

  // What the atmosphere makes of the sum of the looks besides moving the target: the carrier is ahead of the delay, and
  // the way through air grows along the aperture in another way than the distance from the place where the target
  // appears.
  [[nodiscard]] std::complex<double> left_by_air(const UsedLooks& used, std::span<const TargetAspect> seen,
                                                 const signal::ImagePlace& place,
                                                 const signal::ImagePlace& shift) const {
    if (seen[used.middle].late_m == 0.0) return 1.0;
    const signal::ImagePlace is_at = minus(place, shift);
    std::complex<double> sum;
    for (std::size_t i = 0; i < used.numbers.size(); ++i) {
      const TargetAspect& look = seen[used.numbers[i]];
      const auto distance_m = [&](const signal::ImagePlace& from) {
        return std::hypot(from.range_m, from.azimuth_m - looks_.track().speed_mps * look.time_s);
      };
      const double turns = look.ahead_turns - turns_of(look.late_m - (distance_m(place) - distance_m(is_at)));
      sum += std::polar(used.parts[i], 2.0 * core::pi * turns);
    }
    return sum / used.sum;
  }

  // Where a target appears on the ground: where it is, if it rests in the plane of the grid, but for the atmosphere;
  // else where the line has its distance.
  // @param shift          by the atmosphere, about the line
  // @param[in,out] slant  its place about the line
  [[nodiscard]] signal::ImagePlace lay_on_ground(std::size_t number, const UsedLooks& used,
                                                 const signal::ImagePlace& shift, signal::ImagePlace& slant) const {
    constexpr double in_plane_m = 1e-3;
    const signal::ImageFrame& grid = *image_.ground;
    const auto on_ground = [&](const signal::ImagePlace& place) {
      return signal::place_on_ground(grid, *image_.slant, place);
    };
    if (weights_.domain() != Domain::time) return on_ground(slant);
    const auto point_m = looks_.resting_place(number);
    if (!point_m) return on_ground(slant);
    const double above_m = core::dot(*point_m - grid.origin_m, core::cross(grid.along, grid.across));
    const signal::ImagePlace is_at = signal::place_of(*image_.slant, *point_m);
    slant = plus(is_at, shift);
    if (!(std::abs(above_m) < in_plane_m))
      return leaves_line(used, *point_m) ? laid_by_looks(used, *point_m, above_m) : on_ground(slant);
    const signal::ImagePlace in_plane = signal::place_of(grid, *point_m);
    const bool moved = shift.azimuth_m != 0.0 || shift.range_m != 0.0;
    return moved ? plus(in_plane, minus(on_ground(slant), on_ground(is_at))) : in_plane;
  }

  const TargetAspects& looks_;
  const LookWeights& weights_;
  const signal::EchoRows& echoes_;
  const signal::FocusOptions& options_;
  const RangePulse& pulse_;
  const ImageGeometry& image_;
};

std::vector<TargetTheory> theories_on(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                      const signal::FocusOptions& options, bool time_domain, ImageGeometry image,
                                      const core::WorkControl& control) {
  const TargetAspects looks(acquisition, echoes, pulse_weight(acquisition, options.range_window));
  const Domain domain = time_domain ? Domain::time : echoes.compensated ? Domain::resampled : Domain::frequency;
  const LookWeights weights(looks, options, echoes.track.size(), domain);
  if (image.ground) image.antennas_m = looks.antennas();
  const RangePulse pulse(acquisition, echoes, options.range_window);
  const Theories theory(looks, weights, echoes, options, pulse, image);
  std::vector<TargetTheory> theories(listed_targets(*acquisition.scene));
  looks.each(control, [&](std::size_t t, std::span<const TargetAspect> seen) {
    if (t < theories.size()) theories[t] = theory.of(t, seen);
  });
  return theories;
}

// The cuts of an image of slant range that is sampled about the beam's centre.
signal::ResponseAxes axes_about_centroid(const signal::EchoRows& echoes, const signal::FocusOptions& options) {
  const double sine = radar::range_of_cycle(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps) *
                      options.doppler_centroid_hz / signal::fit_straight(echoes.track).speed_mps;
  if (!(std::abs(sine) > 0.01 && std::abs(sine) < 1.0)) return {};
  const double cosine = std::sqrt(1.0 - sine * sine);
  return {{sine, cosine}, {cosine, -sine}};
}

}  // namespace

std::size_t listed_targets(const simulate::ResolvedScene& scene) {
  const std::size_t all = scene.scatterers.size();
  const std::size_t targets = scene.scatterers.targets();
  return all - targets > max_examined_targets ? targets : all;
}

std::vector<TargetTheory> theory_of_targets(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                            const signal::FocusOptions& options, bool time_domain,
                                            const core::WorkControl& control) {
  return theories_on(acquisition, echoes, options, time_domain, {.axes = axes_about_centroid(echoes, options)},
                     control);
}

std::vector<TargetTheory> theory_on_image(const FocusedEchoes& focused, const signal::FocusedImage& image,
                                          const core::WorkControl& control) {
  const signal::ImageFrame& frame = image.frame;
  signal::EchoRows echoes = focused.echoes;
  echoes.compensated = focused.time_domain || focused.compensated;
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  ImageGeometry geometry{.axes = signal::response_axes(image)};
  if (frame.plane == signal::ImagePlane::ground_grid) {
    geometry.ground = frame;
    geometry.slant = {.plane = signal::ImagePlane::slant_range,
                      .origin_m = track.origin_m,
                      .along = track.along,
                      .speed_mps = track.speed_mps};
  }
  std::vector<TargetTheory> theories =
      theories_on(focused.acquisition, echoes, focused.options, focused.time_domain, std::move(geometry), control);
  // Compensated pulses lie elsewhere along the line, and so does the image's origin.
  if (frame.plane == signal::ImagePlane::slant_range)
    for (TargetTheory& theory : theories)
      theory.place.azimuth_m -= core::dot(frame.origin_m - track.origin_m, track.along);
  return theories;
}

}  // namespace sarsim::workflow

#include "workflow/focus/flown_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "radar/path/path.hpp"
#include "signal/sar/ground_sight.hpp"
#include "signal/sar/reference_track.hpp"
#include "workflow/focus/seen_spectrum.hpp"
#include "workflow/focus/target_aspects.hpp"
#include "workflow/focus/target_sights.hpp"

namespace sarsim::workflow {

namespace {

// Of a target, with the mean amplitude of its echoes.
struct FlownSpectrum {
  double amplitude = 0.0;
  std::optional<signal::ImageSpectrum> spectrum;
};

// How the distances to a point of an image change with its coordinates.
class GroundGridPoint {
 public:
  GroundGridPoint(const signal::ImageFrame& image, const signal::ReferenceTrack& line, const core::Vec3& point_m)
      : image_(image), point_m_(point_m) {
    const double distance_m = signal::distance_from(line, point_m);
    const double speed2 = core::dot(line.velocity_mps, line.velocity_mps);
    const core::Vec3 r = point_m - line.position_m;
    const core::Vec3 across = r - (core::dot(r, line.velocity_mps) / speed2) * line.velocity_mps;
    const core::Vec3 away = distance_m > 0.0 ? (1.0 / distance_m) * across : core::Vec3{};
    baseband_ = slopes_along(away);
  }

  // Those from an antenna.
  [[nodiscard]] signal::SeenSlopes slopes_from(const core::Vec3& antenna_m) const {
    const core::Vec3 r = point_m_ - antenna_m;
    return slopes_along((1.0 / core::norm(r)) * r);
  }
  // Those of the distance that the image's phases are taken from.
  [[nodiscard]] const signal::SeenSlopes& baseband() const { return baseband_; }

 private:
  [[nodiscard]] signal::SeenSlopes slopes_along(const core::Vec3& direction) const {
    return {core::dot(direction, image_.along), core::dot(direction, image_.across), 0.0};
  }

  const signal::ImageFrame& image_;
  core::Vec3 point_m_;
  signal::SeenSlopes baseband_;
};

// The point of level ground that has a target's azimuth and range, wherever the target is: there its echoes add up. An
// antenna on the line sees it as if it were anywhere around the line; only what the antenna strays by meets the ground,
// which is steeper in range than any antenna resolves where it lies straight below.
class SlantPoint {
 public:
  SlantPoint(const signal::GroundSight& sight, const core::Vec3& point_m, double cell_m)
      : sight_(sight),
        foot_m_(sight.foot_of(point_m)),
        range_m_(core::norm(point_m - foot_m_)),
        at_m_(sight.point_at(foot_m_, range_m_)),
        tangents_(sight.tangents_at(foot_m_, range_m_, std::min(cell_m, 0.5 * range_m_))) {}

  [[nodiscard]] signal::SeenSlopes slopes_from(const core::Vec3& antenna_m) const {
    const core::Vec3 on_line_m = sight_.foot_of(antenna_m);
    const core::Vec3 strays_m = antenna_m - on_line_m;
    const double distance_m = core::norm(at_m_ - antenna_m);
    return {(core::dot(foot_m_ - on_line_m, sight_.ahead()) - core::dot(strays_m, tangents_.along)) / distance_m,
            (range_m_ - core::dot(strays_m, tangents_.across)) / distance_m, 0.0};
  }
  [[nodiscard]] static signal::SeenSlopes baseband() { return {0.0, 1.0, 0.0}; }

 private:
  const signal::GroundSight& sight_;
  core::Vec3 foot_m_;
  double range_m_;
  core::Vec3 at_m_;
  signal::GroundSight::Tangents tangents_;
};

class FlownImage {
 public:
  FlownImage(const signal::EchoRows& echoes, const signal::ImageFrame& image, const core::Vec3& scene_m,
             const DopplerBand& kept)
      : echoes_(echoes), image_(image), kept_(kept), line_(signal::fitted_track(echoes.track)), scene_m_(scene_m) {}

  [[nodiscard]] FlownSpectrum spectrum_of(std::span<const PulseSight> sights) const {
    const core::Vec3& point_m = sights[sights.size() / 2].point_m;
    if (image_.plane == signal::ImagePlane::ground_grid)
      return spectrum_of(sights, GroundGridPoint(image_, line_, point_m));
    const signal::SarWaveform& wave = echoes_.waveform;
    const signal::GroundSight sight(line_, scene_m_, 0.0);
    const double cell_m = 0.5 * wave.light_speed_mps / std::max(std::abs(wave.bandwidth_hz), 1.0);
    return spectrum_of(sights, SlantPoint(sight, point_m, cell_m));
  }

 private:
  template <class Point>
  [[nodiscard]] FlownSpectrum spectrum_of(std::span<const PulseSight> sights, const Point& point) const {
    constexpr double min_used = 0.05;  // of the echoes: what is beyond counts as part of all of them
    std::vector<signal::SeenSlopes> seen;
    seen.reserve(sights.size());
    double all = 0.0;
    double used = 0.0;
    for (const PulseSight& sight : sights) {
      all += sight.amplitude;
      const core::Vec3 r = sight.point_m - sight.antenna_m;
      if (!(sight.amplitude > 0.0) || !is_kept((1.0 / core::norm(r)) * r)) continue;
      seen.push_back(point.slopes_from(sight.antenna_m));
      seen.back().weight = sight.amplitude;
      used += sight.amplitude;
    }
    if (!(used > min_used * all)) return {};
    return {used / static_cast<double>(sights.size()),
            signal::spectrum_of(seen, point.baseband(), echoes_.waveform, left_out_of_image * all / used)};
  }

  [[nodiscard]] bool is_kept(const core::Vec3& direction) const {
    if (kept_.width_hz <= 0.0) return true;
    const signal::SarWaveform& wave = echoes_.waveform;
    const double doppler_hz =
        radar::turns_per_m(wave.carrier_hz, wave.light_speed_mps) * core::dot(direction, line_.velocity_mps);
    return std::abs(doppler_hz - kept_.centroid_hz) <= 0.5 * kept_.width_hz;
  }

  const signal::EchoRows& echoes_;
  const signal::ImageFrame& image_;
  const DopplerBand& kept_;
  signal::ReferenceTrack line_;
  core::Vec3 scene_m_;
};

}  // namespace

std::optional<signal::ImageSpectrum> flown_spectrum(const simulate::Acquisition& acquisition,
                                                    const signal::EchoRows& recorded, const signal::ImageFrame& image,
                                                    const core::Vec3& scene_m, const DopplerBand& kept,
                                                    const core::WorkControl& control) {
  constexpr SightLimits limits{max_examined_targets, 257};
  constexpr double weakest = 0.01;
  signal::EchoRows echoes = recorded;
  if (!echoes.carriers_hz.empty()) {
    const auto [low, high] = std::ranges::minmax(echoes.carriers_hz);
    echoes.waveform.bandwidth_hz = std::abs(echoes.waveform.bandwidth_hz) + high - low;
  }
  const std::size_t every = target_stride(acquisition, limits);
  if (every == 0) return std::nullopt;
  const FlownImage flown(echoes, image, scene_m, kept);
  std::vector<FlownSpectrum> targets((acquisition.scene->scatterers.size() + every - 1) / every);
  each_target_in_sight(acquisition, echoes, limits, control,
                       [&](std::size_t target, std::span<const PulseSight> sights) {
                         targets[target / every] = flown.spectrum_of(sights);
                       });
  double strongest = 0.0;
  for (const FlownSpectrum& target : targets) strongest = std::max(strongest, target.amplitude);
  std::optional<signal::ImageSpectrum> all;
  for (const FlownSpectrum& target : targets)
    if (target.spectrum && target.amplitude >= weakest * strongest)
      all = all ? signal::joined(*all, *target.spectrum) : *target.spectrum;
  return all;
}

}  // namespace sarsim::workflow

#include "workflow/focus/flown_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "radar/path/path.hpp"
#include "signal/sar/ground_sight.hpp"
#include "signal/sar/reference_track.hpp"
#include "workflow/focus/target_sights.hpp"

namespace sarsim::workflow {

namespace {

// Of a target, with the mean amplitude of its echoes.
struct FlownSpectrum {
  double amplitude = 0.0;
  std::optional<signal::ImageSpectrum> spectrum;
};

// How a point of the image moves with its coordinates, and how the distance does that phases are taken from.
struct ImageSlopes {
  core::Vec3 azimuth, range;
  signal::SeenSlopes baseband;
};

class FlownImage {
 public:
  FlownImage(const signal::EchoRows& echoes, const signal::ImageFrame& image, const core::Vec3& scene_m,
             const DopplerBand& kept)
      : echoes_(echoes), image_(image), kept_(kept), line_(signal::fitted_track(echoes.track)), scene_m_(scene_m) {}

  [[nodiscard]] FlownSpectrum spectrum_of(std::span<const PulseSight> sights) const {
    constexpr double beyond = 0.003;
    constexpr double least_used = 0.05;  // of the echoes: what is beyond counts as part of all of them
    const ImageSlopes slopes = slopes_at(sights[sights.size() / 2].point_m);
    std::vector<signal::SeenSlopes> seen;
    seen.reserve(sights.size());
    double all = 0.0;
    double used = 0.0;
    for (const PulseSight& sight : sights) {
      all += sight.amplitude;
      const core::Vec3 r = sight.point_m - sight.antenna_m;
      const core::Vec3 direction = (1.0 / core::norm(r)) * r;
      if (!(sight.amplitude > 0.0) || !is_kept(direction)) continue;
      seen.push_back({core::dot(direction, slopes.azimuth), core::dot(direction, slopes.range), sight.amplitude});
      used += sight.amplitude;
    }
    if (!(used > least_used * all)) return {};
    return {used / static_cast<double>(sights.size()),
            signal::spectrum_of(seen, slopes.baseband, echoes_.waveform, beyond * all / used)};
  }

 private:
  [[nodiscard]] bool is_kept(const core::Vec3& direction) const {
    if (kept_.width_hz <= 0.0) return true;
    const signal::SarWaveform& wave = echoes_.waveform;
    const double doppler_hz =
        radar::turns_per_m(wave.carrier_hz, wave.light_speed_mps) * core::dot(direction, line_.velocity_mps);
    return std::abs(doppler_hz - kept_.centroid_hz) <= 0.5 * kept_.width_hz;
  }

  [[nodiscard]] ImageSlopes slopes_at(const core::Vec3& point_m) const {
    if (image_.plane == signal::ImagePlane::ground_grid) {
      const double distance_m = signal::distance_from(line_, point_m);
      const double speed2 = core::dot(line_.velocity_mps, line_.velocity_mps);
      const core::Vec3 r = point_m - line_.position_m;
      const core::Vec3 across = r - (core::dot(r, line_.velocity_mps) / speed2) * line_.velocity_mps;
      const core::Vec3 away = distance_m > 0.0 ? (1.0 / distance_m) * across : core::Vec3{};
      return {image_.along, image_.across, {core::dot(away, image_.along), core::dot(away, image_.across), 0.0}};
    }
    const signal::GroundSight sight(line_, scene_m_, 0.0);
    const core::Vec3 foot_m = sight.foot_of(point_m);
    const auto [along, across] = sight.tangents_at(foot_m, core::norm(point_m - foot_m));
    return {along, across, {0.0, 1.0, 0.0}};
  }

  const signal::EchoRows& echoes_;
  const signal::ImageFrame& image_;
  const DopplerBand& kept_;
  signal::ReferenceTrack line_;
  core::Vec3 scene_m_;
};

}  // namespace

std::optional<signal::ImageSpectrum> flown_spectrum(const simulate::Plan& plan, const signal::EchoRows& recorded,
                                                    const signal::ImageFrame& image, const core::Vec3& scene_m,
                                                    const DopplerBand& kept, const core::WorkControl& control) {
  constexpr SightLimits limits{most_examined_targets, 257};
  constexpr double weakest = 0.01;
  signal::EchoRows echoes = recorded;
  if (!echoes.carriers_hz.empty()) {
    const auto [low, high] = std::ranges::minmax(echoes.carriers_hz);
    echoes.waveform.bandwidth_hz = std::abs(echoes.waveform.bandwidth_hz) + high - low;
  }
  const std::size_t every = target_stride(plan, limits);
  if (every == 0) return std::nullopt;
  const FlownImage flown(echoes, image, scene_m, kept);
  std::vector<FlownSpectrum> targets((plan.scene->scatterers.size() + every - 1) / every);
  each_target_in_sight(plan, echoes, limits, control, [&](std::size_t target, std::span<const PulseSight> sights) {
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

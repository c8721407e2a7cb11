#include "workflow/focus/target_sights.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::workflow {

namespace {

// Targets that are looked at together. Each pulse means a pose of every platform: with many of them it should serve
// many targets.
std::size_t sights_at_once(const simulate::Acquisition& acquisition) {
  return std::clamp<std::size_t>(acquisition.scene->platforms.size(), 8, 128);
}

// Whether the samples of a pulse begin before an echo ends and end after it begins.
bool is_recorded(const signal::EchoRows& echoes, double delay_s) {
  const double spare_s = 1.0 / echoes.waveform.sample_rate_hz;
  const double last_s = echoes.first_delay_s + static_cast<double>(echoes.columns) / echoes.waveform.sample_rate_hz;
  return delay_s > echoes.first_delay_s - spare_s && delay_s < last_s;
}

}  // namespace

std::size_t target_stride(const simulate::Acquisition& acquisition, const SightLimits& limits) {
  return (acquisition.scene->scatterers.size() + limits.targets - 1) / limits.targets;
}

void each_target_in_sight(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                          const SightLimits& limits, const core::WorkControl& control,
                          const std::function<void(std::size_t target, std::span<const PulseSight> sights)>& body) {
  const std::size_t every = target_stride(acquisition, limits);
  const std::size_t step = (echoes.track.size() + limits.pulses - 1) / limits.pulses;
  if (every == 0 || step == 0) return;
  const std::size_t looks = (echoes.track.size() + step - 1) / step;
  const std::size_t targets = (acquisition.scene->scatterers.size() + every - 1) / every;
  core::parallel_ranges(targets, sights_at_once(acquisition), control, [&](std::size_t begin, std::size_t end) {
    std::vector<PulseSight> sights((end - begin) * looks);
    simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
    for (std::size_t look = 0; look < looks; ++look) {
      const std::size_t pulse = look * step;
      geometry.set_pulse(acquisition.timing.pulses.first + static_cast<std::int64_t>(pulse));
      const radar::Pointing pointing = geometry.pointing();
      for (std::size_t t = begin; t < end; ++t) {
        const simulate::Scatterer& scatterer = acquisition.scene->scatterers[t * every];
        const simulate::ScattererView view = geometry.view(t * every, pointing);
        sights[(t - begin) * looks + look] = {
            pulse, echoes.track[pulse].position_m,
            radar::world_position_m(geometry.pose(scatterer.platform), scatterer.position_m),
            is_recorded(echoes, view.delay_s) ? std::abs(view.amplitude_sqrt_w) : 0.0};
      }
    }
    for (std::size_t t = begin; t < end; ++t)
      body(t * every, std::span<const PulseSight>(sights).subspan((t - begin) * looks, looks));
  });
}

}  // namespace sarsim::workflow

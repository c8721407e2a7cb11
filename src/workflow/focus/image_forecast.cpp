#include "workflow/focus/image_forecast.hpp"

#include <memory>

#include "core/report/problem.hpp"
#include "simulate/resolve/resolved.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/focus/sar_theory.hpp"

namespace sarsim::workflow {

std::optional<ImageForecast> forecast_image(const scene::Scene& scene, std::size_t simulation, std::size_t target,
                                            const core::WorkControl& control) {
  scene::Scene alone = scene;
  alone.targets = {scene.targets.at(target)};
  alone.clouds.clear();
  alone.surfaces.clear();
  const auto resolved = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(alone, control));
  FocusInput input = focus_input_of(alone, simulation, resolved);
  if (core::has_errors(input.problems)) return std::nullopt;
  input.echoes.compensated = true;  // Where the track is not straight, they will be.
  signal::FocusOptions options;
  options.doppler_centroid_hz = geometric_doppler_centroid_hz(*input.acquisition);
  const std::vector<TargetTheory> theories =
      theory_of_targets(*input.acquisition, input.echoes, options, false, control);
  if (theories.empty() || !(theories.front().amplitude > 0.0) || !theories.front().azimuth) return std::nullopt;
  const TargetTheory& theory = theories.front();
  constexpr double even_spectrum = 0.886;  // Width of sin(x)/x at half its power.
  ImageForecast forecast{target, theory.azimuth->width, {}, theory.place.range_m, 0.0};
  if (theory.range) forecast.range_width_m = theory.range->width;
  const double wavelength_m = input.echoes.waveform.light_speed_mps / input.echoes.waveform.carrier_hz;
  forecast.aperture_m = even_spectrum * wavelength_m * forecast.range_m / (2.0 * forecast.azimuth_width_m);
  return forecast;
}

}  // namespace sarsim::workflow

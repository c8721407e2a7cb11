#include "simulate/plan/engine.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "simulate/plan/cost_of_pulse.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::array<std::pair<Engine, std::string_view>, 4> names{{{Engine::automatic, "auto"},
                                                                    {Engine::reference, "reference"},
                                                                    {Engine::direct, "direct"},
                                                                    {Engine::spectral, "spectral"}}};

}  // namespace

std::string_view name_of(Engine engine) {
  return std::ranges::find(names, engine, &std::pair<Engine, std::string_view>::first)->second;
}

std::optional<Engine> engine_from_name(std::string_view name) {
  const auto found = std::ranges::find(names, name, &std::pair<Engine, std::string_view>::second);
  if (found == names.end()) return std::nullopt;
  return found->first;
}

EngineChoice choose_engine(Engine wanted, const Acquisition& acquisition) {
  const Reception& reception = acquisition.reception;
  const double tolerance = acquisition.scene->options.tolerance;
  CORE_EXPECT(reception.raw_grid.interval_s > 0.0);
  CORE_EXPECT(tolerance > 0.0);
  CORE_EXPECT(acquisition.timing.pulses.count() > 0);
  if (wanted != Engine::automatic) return {wanted, "asked for"};
  if (simd_level() == "scalar") return {Engine::reference, "this processor has no usable SIMD"};
  const PulseCost cost(*acquisition.scene, acquisition.link, reception.pulse, reception.raw_grid, tolerance);
  const double direct_ns = cost.direct_ns();
  // Few echoes of short pulses: not worth asking what the transform would cost.
  if (direct_ns < 20e3)
    return {Engine::direct,
            fmt::format("{:.0f} echoes a pulse of {:.0f} samples are few", cost.echoes(), cost.samples())};
  const SpectralEstimate spectral = cost.spectral(acquisition.timing.pulses);
  constexpr std::size_t largest_transform = std::size_t{1} << 27U;
  const bool direct =
      spectral.cost.doppler_terms > 20 || spectral.cost.transform_size > largest_transform || direct_ns <= spectral.ns;
  const std::string transforms =
      spectral.in_bins
          ? fmt::format("{} transforms of {} points", spectral.cost.bin_transforms, spectral.cost.bin_points)
          : fmt::format("transforms of {} points with {} Doppler terms", spectral.cost.transform_size,
                        spectral.cost.doppler_terms);
  return {direct ? Engine::direct : Engine::spectral,
          fmt::format("{:.0f} echoes a pulse of {:.0f} samples cost {} than {}", cost.echoes(), cost.samples(),
                      direct ? "less" : "more", transforms)};
}

}  // namespace sarsim::simulate

#include "simulate/plan/engine.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "simulate/plan/row_kernel.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::string_view automatic_name = "auto";

}  // namespace

std::string_view name_of(Engine engine) {
  return engine == Engine::automatic ? automatic_name : row_kernel(engine).name;
}

std::vector<std::pair<std::string, Engine>> named_engines() {
  std::vector<std::pair<std::string, Engine>> engines{{std::string(automatic_name), Engine::automatic}};
  for (const RowKernelKind& kind : row_kernels()) engines.emplace_back(kind.name, kind.engine);
  std::rotate(engines.begin() + 1, engines.begin() + 2, engines.end());  // the reference is for comparison: last
  return engines;
}

std::optional<Engine> engine_from_name(std::string_view name) {
  for (const auto& [known, engine] : named_engines())
    if (known == name) return engine;
  return std::nullopt;
}

EngineChoice choose_engine(Engine wanted, const Acquisition& acquisition) {
  const Reception& reception = acquisition.reception;
  const double tolerance = acquisition.scene->options.tolerance;
  CORE_EXPECT(reception.raw_grid.interval_s > 0.0);
  CORE_EXPECT(tolerance > 0.0);
  CORE_EXPECT(acquisition.timing.pulses.count() > 0);
  if (wanted != Engine::automatic) return {wanted, "asked for"};
  if (simd_level() == "scalar") return {Engine::reference, "this processor has no usable SIMD"};
  const PulseCost pulse(*acquisition.scene, acquisition.link, reception.pulse, reception.raw_grid, tolerance);
  const std::span<const RowKernelKind> fast = row_kernels().subspan(1);
  const RowKernelKind* best = &fast.front();
  double best_ns = best->cost(pulse, acquisition.timing.pulses).pulse_ns;
  // Few echoes of short pulses: not worth asking what others would cost.
  constexpr double little_ns = 20e3;
  if (best_ns < little_ns)
    return {best->engine,
            fmt::format("{:.0f} echoes a pulse of {:.0f} samples are few", pulse.echoes(), pulse.samples())};
  std::string others;
  for (const RowKernelKind& kind : fast.subspan(1)) {
    const KernelCost cost = kind.cost(pulse, acquisition.timing.pulses);
    const bool better = cost.reaches && cost.pulse_ns < best_ns;
    others += fmt::format("{}{} than {}", others.empty() ? "" : ", ", better ? "more" : "less", cost.work);
    if (!better) continue;
    best = &kind;
    best_ns = cost.pulse_ns;
  }
  return {best->engine,
          fmt::format("{:.0f} echoes a pulse of {:.0f} samples cost {}", pulse.echoes(), pulse.samples(), others)};
}

}  // namespace sarsim::simulate

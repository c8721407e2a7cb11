#include <benchmark/benchmark.h>

#include <cmath>

#include "signal/sar/focusing.hpp"
#include "signal/sar/sar_test_scene.hpp"

namespace sarsim::signal {
namespace {

// 4096 pulses of 4096 samples at the thesis' geometry, the pulses close enough to sample what their track spans.
const SarEchoes& large_echoes() {
  static const SarEchoes echoes = [] {
    sar_test::Setting setting;
    setting.prf_hz = 1200.0;
    setting.pulses = 4096;
    setting.swath_m = 4096.0 * 0.5 * setting.waveform.light_speed_mps / setting.waveform.sample_rate_hz + 0.1;
    const core::Vec3 point = sar_test::point_at(setting, 0.0, setting.closest_m());
    return sar_test::make_echoes(setting, {{point, 1.0, {}}});
  }();
  return echoes;
}

void focus_large(benchmark::State& state, FocusMethod method) {
  const SarEchoes& echoes = large_echoes();
  const core::WorkControl control{.threads = static_cast<unsigned>(state.range(0))};
  for (auto _ : state) {
    const FocusedRows image = focus_rows(rows_of(echoes), {.method = method}, control);
    benchmark::DoNotOptimize(image.image.azimuth.count);
  }
  state.counters["samples"] = benchmark::Counter(
      static_cast<double>(echoes.volts.size()) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void range_doppler(benchmark::State& state) { focus_large(state, FocusMethod::range_doppler); }
void chirp_scaling(benchmark::State& state) { focus_large(state, FocusMethod::chirp_scaling); }
void omega_k(benchmark::State& state) { focus_large(state, FocusMethod::omega_k); }

BENCHMARK(range_doppler)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(chirp_scaling)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(omega_k)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace sarsim::signal

// What a pixel costs per pulse in back-projection. Every case is held against the double-precision definition at a few
// points before it is timed.
//
//   items_per_second   pixels times pulses

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "core/maths/window.hpp"
#include "signal/sar/sar_test_support.hpp"

namespace sarsim::signal {
namespace {

struct Case {
  std::string name;
  std::size_t side = 1000;  // of the image, pixels
  std::size_t pulses = 1000;
  double spacing_m = 1.0;
  BackProjectionOptions options;
  unsigned threads = 1;
};

SarEchoes echoes_of(const Case& c) {
  SarEchoes echoes = test::thesis_echoes(c.pulses, 600.0);
  echoes.samples = 1024;
  echoes.first_delay_s -= 384.0 / echoes.waveform.sample_rate_hz;
  test::write_echoes(echoes, {{{0.0, 0.0, 0.0}}, {{30.0, -20.0, 0.0}}, {{-120.0, 210.0, 0.0}}}, echoes.track);
  return echoes;
}

PointGrid grid_of(const Case& c, std::size_t side) {
  const double reach_m = 0.5 * static_cast<double>(side) * c.spacing_m;
  return {{-reach_m, -reach_m, 0.0}, {c.spacing_m, 0.0, 0.0}, {0.0, c.spacing_m, 0.0}, side, side};
}

// Largest difference from the reference, of the largest value, on a small image about a target.
double error_of(const SarEchoes& echoes, const Case& c) {
  PointGrid grid = grid_of(c, 8);
  const auto expected = test::reference_back_projection(echoes, grid);
  const auto got = back_project(echoes, grid, {}, {c.threads, nullptr});
  double error = 0.0;
  for (std::size_t i = 0; i < got.size(); ++i)
    error = std::max(error, std::abs(std::complex<double>(got[i]) - expected[i]));
  return error;
}

void back_projection(benchmark::State& state, const Case& c, std::int64_t targets) {
  const SarEchoes echoes = echoes_of(c);
  const PointGrid grid = grid_of(c, c.side);
  if (targets != 0) hwy::SetSupportedTargetsForTest(targets);
  const double error = error_of(echoes, c);
  if (!(error < 1e-3)) {
    state.SkipWithError(("differs from the reference by " + std::to_string(error)).c_str());
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    const auto image = back_project(echoes, grid, c.options, {c.threads, nullptr});
    benchmark::DoNotOptimize(image.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(c.side * c.side * c.pulses));
  state.counters["error"] = error;
  hwy::SetSupportedTargetsForTest(0);
}

const bool registered = [] {
  const double quarter_rad = 0.02;
  std::vector<Case> cases(5);
  cases[0].name = "all_pulses";
  cases[1].name = "beam";
  cases[1].options.aperture = BackProjectionOptions::Aperture::beam;
  cases[1].options.beam_rad = quarter_rad;
  cases[2].name = "beam_window";
  cases[2].options = cases[1].options;
  cases[2].options.azimuth_window = [](double x) { return core::hamming_window(x); };
  cases[3].name = "fine_pixels";
  cases[3].spacing_m = 0.1;
  cases[4].name = "two_threads";
  cases[4].threads = 2;
  for (const Case& c : cases) {
    for (const auto& [name, targets] :
         {std::pair<const char*, std::int64_t>{"best", 0}, {"avx2", HWY_AVX2}, {"sse4", HWY_SSE4}})
      benchmark::RegisterBenchmark((c.name + "/" + name).c_str(), back_projection, c, targets)
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime()
          ->UseRealTime();
  }
  return true;
}();

}  // namespace
}  // namespace sarsim::signal

// What an echo costs in each kernel. Every case is compared with the reference before it is timed.
//
//   items_per_second   echoes
//   echo_samples       echoes times samples of a pulse, per second

#include <benchmark/benchmark.h>
#include <hwy/targets.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "core/maths/constants.hpp"
#include "core/maths/random.hpp"
#include "radar/echo/direct_kernel.hpp"
#include "radar/echo/spectral_kernel.hpp"
#include "radar/echo/strengths.hpp"
#include "radar/echo/view_geometry.hpp"

namespace sarsim::radar {
namespace {

constexpr double interval_s = 1e-8;
constexpr double carrier_hz = 5e9;

struct Workload {
  EchoPulse pulse;
  SampleGrid grid;
  EchoBatch echoes;
  double samples = 0.0;  // of a pulse
};

enum class Band { hard_edged, limited };

// What makes a pulse more than a tone.
enum class Shape { none, ramps, curve_8, curve_200, user_8, user_200, user_2000, low_pass_100, band_limited, cut };

core::Interpolator curve(core::Interpolation method, int knots) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> value(0.3, 1.0);
  core::SampledFunction f;
  f.method = method;
  for (int i = 0; i < knots; ++i) f.knots.push_back({static_cast<double>(i) / (knots - 1), value(random)});
  return core::Interpolator(f);
}

void give_user_pulse(Pulse& pulse, core::Interpolation method, int knots) {
  pulse.kind = Pulse::Kind::user;
  pulse.sweep_hz = 0.0;
  pulse.in_phase = curve(method, knots);
  pulse.quadrature = curve(method, knots);
}

void give_shape(EchoPulse& echo, Shape shape) {
  Pulse& pulse = echo.pulse;
  const auto limit = [&](double kept_width_s) {
    echo.band_limited.emplace(pulse, 0.5 / interval_s, 1.0 / interval_s, kept_width_s);
  };
  switch (shape) {
    case Shape::none: break;
    case Shape::ramps:
      pulse.envelope = Pulse::Envelope::linear;
      pulse.rise_s = pulse.fall_s = 0.1 * pulse.width_s;
      break;
    case Shape::curve_8:
    case Shape::curve_200:
      pulse.envelope = Pulse::Envelope::user;
      pulse.envelope_gain = curve(core::Interpolation::linear, shape == Shape::curve_8 ? 8 : 200);
      break;
    case Shape::user_8: give_user_pulse(pulse, core::Interpolation::cubic, 8); break;
    case Shape::user_200: give_user_pulse(pulse, core::Interpolation::linear, 200); break;
    case Shape::user_2000: give_user_pulse(pulse, core::Interpolation::linear, 2000); break;
    case Shape::low_pass_100: give_user_pulse(pulse, core::Interpolation::low_pass, 100); break;
    case Shape::band_limited: limit(0.0); break;
    case Shape::cut: limit(pulse.width_s); break;
  }
}

// Echoes whose pulses lie inside the row; `cycles` of Doppler over the pulse at the most, of either sign.
Workload workload(Pulse::Kind kind, double samples, std::size_t echo_count, double cycles = 0.0,
                  Band band = Band::hard_edged) {
  Workload w;
  w.samples = samples;
  w.pulse.pulse.kind = kind;
  w.pulse.pulse.width_s = samples * interval_s;
  w.pulse.pulse.sweep_hz = kind == Pulse::Kind::chirp ? 0.8 / interval_s : 0.0;
  if (kind == Pulse::Kind::code) w.pulse.pulse.code = barker_code(6);
  if (band == Band::limited) w.pulse.band_limited.emplace(w.pulse.pulse, 0.5 / interval_s, 1.0 / interval_s, 0.0);
  w.grid = {40e-6, interval_s, static_cast<std::size_t>(4.0 * samples)};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> position(0.0, 3.0 * samples), unit(-1.0, 1.0);
  const double largest_doppler = cycles / (carrier_hz * w.pulse.pulse.width_s);
  for (std::size_t k = 0; k < echo_count; ++k)
    w.echoes.add(w.grid.first_s + position(random) * interval_s, unit(random), largest_doppler * unit(random));
  return w;
}

// Error of a row of the first few echoes over sqrt(sum |a|^2 ||p||^2); all of them would take the reference too long.
template <class Kernel>
double error_of(Kernel& kernel, const Workload& w) {
  const std::size_t few = std::min<std::size_t>(w.echoes.size(), 200);
  EchoBatch echoes;
  double strength = 0.0;
  for (std::size_t k = 0; k < few; ++k) {
    echoes.add(w.echoes.delay_s[k], w.echoes.amplitude_sqrt_w[k], w.echoes.doppler[k]);
    strength += w.echoes.amplitude_sqrt_w[k] * w.echoes.amplitude_sqrt_w[k];
  }
  std::vector<std::complex<double>> got(w.grid.count), expected(w.grid.count);
  kernel.add(got, carrier_hz, echoes);
  add_echoes(expected, w.grid, w.pulse, carrier_hz, echoes);
  double error = 0.0;
  for (std::size_t n = 0; n < got.size(); ++n) error += std::norm(got[n] - expected[n]);
  return std::sqrt(error / (strength * w.samples));
}

void count(benchmark::State& state, const Workload& w) {
  const double echoes = static_cast<double>(state.iterations()) * static_cast<double>(w.echoes.size());
  state.SetItemsProcessed(static_cast<std::int64_t>(echoes));
  state.counters["echo_samples"] = benchmark::Counter(echoes * w.samples, benchmark::Counter::kIsRate);
}

template <class Kernel>
void time_kernel(benchmark::State& state, Kernel& kernel, const Workload& w, double promise) {
  const double error = error_of(kernel, w);
  if (!(error < promise)) {
    state.SkipWithError(("differs from the reference by " + std::to_string(error)).c_str());
    return;
  }
  std::vector<std::complex<double>> row(w.grid.count);
  for ([[maybe_unused]] auto _ : state) {
    kernel.add(row, carrier_hz, w.echoes);
    benchmark::DoNotOptimize(row.data());
    benchmark::ClobberMemory();
  }
  count(state, w);
  state.counters["error"] = error;
}

void reference(benchmark::State& state, Pulse::Kind kind, double samples) {
  const Workload w = workload(kind, samples, 50);
  std::vector<std::complex<double>> row(w.grid.count);
  for ([[maybe_unused]] auto _ : state) {
    add_echoes(row, w.grid, w.pulse, carrier_hz, w.echoes);
    benchmark::DoNotOptimize(row.data());
  }
  count(state, w);
}
BENCHMARK_CAPTURE(reference, chirp_1000, Pulse::Kind::chirp, 1000.0);
BENCHMARK_CAPTURE(reference, mono_1000, Pulse::Kind::mono, 1000.0);

void direct(benchmark::State& state, Pulse::Kind kind, double samples, double cycles, double promise) {
  const Workload w = workload(kind, samples, 1000, cycles);
  DirectKernel kernel(w.pulse, w.grid, promise);
  time_kernel(state, kernel, w, promise);
}
BENCHMARK_CAPTURE(direct, chirp_1000, Pulse::Kind::chirp, 1000.0, 0.0, 1e-6);
BENCHMARK_CAPTURE(direct, chirp_1000_moving, Pulse::Kind::chirp, 1000.0, 0.1, 1e-6);
BENCHMARK_CAPTURE(direct, chirp_1000_double, Pulse::Kind::chirp, 1000.0, 0.0, 1e-9);
BENCHMARK_CAPTURE(direct, chirp_10000, Pulse::Kind::chirp, 10000.0, 0.0, 1e-6);
BENCHMARK_CAPTURE(direct, mono_1000, Pulse::Kind::mono, 1000.0, 0.0, 1e-6);
BENCHMARK_CAPTURE(direct, barker_1000, Pulse::Kind::code, 1000.0, 0.0, 1e-6);

struct ShapedCase {
  std::string name;
  Shape shape;
  double samples;
  double cycles;  // of Doppler over the pulse
  double promise;
};

Workload shaped_workload(const ShapedCase& c, std::size_t echo_count) {
  Workload w = workload(Pulse::Kind::chirp, c.samples, echo_count, c.cycles);
  give_shape(w.pulse, c.shape);
  return w;
}

void shaped(benchmark::State& state, const ShapedCase& c, std::int64_t targets) {
  const Workload w = shaped_workload(c, 1000);
  if (targets != 0) hwy::SetSupportedTargetsForTest(targets);
  DirectKernel kernel(w.pulse, w.grid, c.promise);
  time_kernel(state, kernel, w, c.promise);
  hwy::SetSupportedTargetsForTest(0);
}

void shaped_reference(benchmark::State& state, const ShapedCase& c) {
  const Workload w = shaped_workload(c, 20);
  std::vector<std::complex<double>> row(w.grid.count);
  for ([[maybe_unused]] auto _ : state) {
    add_echoes(row, w.grid, w.pulse, carrier_hz, w.echoes);
    benchmark::DoNotOptimize(row.data());
  }
  count(state, w);
}

// Making a kernel: what a thread pays once.
void shaped_set_up(benchmark::State& state, const ShapedCase& c) {
  const Workload w = shaped_workload(c, 1);
  for ([[maybe_unused]] auto _ : state) {
    DirectKernel kernel(w.pulse, w.grid, c.promise);
    benchmark::DoNotOptimize(&kernel);
  }
}

// Every shape with the best instruction set and with AVX2, against the reference and what a kernel costs to make.
const bool shapes_registered = [] {
  const std::vector<ShapedCase> cases{{"chirp_1000", Shape::none, 1000.0, 0.0, 1e-6},
                                      {"chirp_10000", Shape::none, 10000.0, 0.0, 1e-6},
                                      {"ramps_1000", Shape::ramps, 1000.0, 0.0, 1e-6},
                                      {"ramps_1000_double", Shape::ramps, 1000.0, 0.0, 1e-9},
                                      {"curve_8_1000", Shape::curve_8, 1000.0, 0.0, 1e-6},
                                      {"curve_200_1000", Shape::curve_200, 1000.0, 0.0, 1e-6},
                                      {"user_8_1000", Shape::user_8, 1000.0, 0.0, 1e-6},
                                      {"user_8_1000_moving", Shape::user_8, 1000.0, 0.1, 1e-6},
                                      {"user_8_1000_double", Shape::user_8, 1000.0, 0.0, 1e-9},
                                      {"user_200_1000", Shape::user_200, 1000.0, 0.0, 1e-6},
                                      {"user_2000_1000", Shape::user_2000, 1000.0, 0.0, 1e-6},
                                      {"low_pass_100_1000", Shape::low_pass_100, 1000.0, 0.0, 1e-6},
                                      {"band_limited_100", Shape::band_limited, 100.0, 0.0, 1e-6},
                                      {"band_limited_1000", Shape::band_limited, 1000.0, 0.0, 1e-6},
                                      {"band_limited_1000_moving", Shape::band_limited, 1000.0, 0.1, 1e-6},
                                      {"band_limited_1000_double", Shape::band_limited, 1000.0, 0.0, 1e-9},
                                      {"band_limited_10000", Shape::band_limited, 10000.0, 0.0, 1e-6},
                                      {"cut_1000", Shape::cut, 1000.0, 0.0, 1e-6}};
  for (const ShapedCase& c : cases) {
    benchmark::RegisterBenchmark(("shaped/" + c.name).c_str(), shaped, c, 0);
    benchmark::RegisterBenchmark(("shaped_avx2/" + c.name).c_str(), shaped, c, HWY_AVX2);
    benchmark::RegisterBenchmark(("shaped_reference/" + c.name).c_str(), shaped_reference, c);
    if (c.shape != Shape::none)
      benchmark::RegisterBenchmark(("shaped_set_up/" + c.name).c_str(), shaped_set_up, c)
          ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

void spectral(benchmark::State& state, Band band, double cycles, double promise, std::int64_t targets = 0) {
  if (targets != 0) hwy::SetSupportedTargetsForTest(targets);
  const Workload w = workload(Pulse::Kind::chirp, 1000.0, 20000, cycles, band);
  SpectralKernel kernel(w.pulse, w.grid, promise);
  time_kernel(state, kernel, w, promise);
  const double span = cycles == 0.0 ? 0.0 : 2.0 * cycles / (carrier_hz * w.pulse.pulse.width_s);
  state.counters["terms"] = static_cast<double>(
      SpectralKernel::cost(w.pulse, w.grid, promise, carrier_hz, -0.5 * span, 0.5 * span).doppler_terms);
  hwy::SetSupportedTargetsForTest(0);
}
BENCHMARK_CAPTURE(spectral, limited_1e_3, Band::limited, 0.0, 1e-3);
BENCHMARK_CAPTURE(spectral, limited_1e_6, Band::limited, 0.0, 1e-6);
BENCHMARK_CAPTURE(spectral, limited_1e_9, Band::limited, 0.0, 1e-9);
BENCHMARK_CAPTURE(spectral, hard_1e_3, Band::hard_edged, 0.0, 1e-3);
BENCHMARK_CAPTURE(spectral, hard_1e_6, Band::hard_edged, 0.0, 1e-6);
BENCHMARK_CAPTURE(spectral, hard_1e_9, Band::hard_edged, 0.0, 1e-9);
BENCHMARK_CAPTURE(spectral, limited_1e_6_hundredth_of_a_cycle, Band::limited, 0.01, 1e-6);
BENCHMARK_CAPTURE(spectral, limited_1e_6_tenth_of_a_cycle, Band::limited, 0.1, 1e-6);
BENCHMARK_CAPTURE(spectral, limited_1e_6_one_cycle, Band::limited, 1.0, 1e-6);
BENCHMARK_CAPTURE(spectral, hard_1e_6_tenth_of_a_cycle, Band::hard_edged, 0.1, 1e-6);
BENCHMARK_CAPTURE(spectral, limited_1e_6_avx2, Band::limited, 0.0, 1e-6, HWY_AVX2);
BENCHMARK_CAPTURE(spectral, hard_1e_6_avx2, Band::hard_edged, 0.0, 1e-6, HWY_AVX2);
BENCHMARK_CAPTURE(spectral, hard_1e_6_tenth_of_a_cycle_avx2, Band::hard_edged, 0.1, 1e-6, HWY_AVX2);

// Making a kernel: what a thread pays once.
void spectral_set_up(benchmark::State& state, double promise) {
  const Workload w = workload(Pulse::Kind::chirp, 1000.0, 1);
  std::vector<std::complex<double>> row(w.grid.count);
  for ([[maybe_unused]] auto _ : state) {
    SpectralKernel kernel(w.pulse, w.grid, promise);
    kernel.add(row, carrier_hz, w.echoes);
    benchmark::DoNotOptimize(row.data());
  }
}
BENCHMARK_CAPTURE(spectral_set_up, hard_1e_6, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spectral_set_up, hard_1e_9, 1e-9)->Unit(benchmark::kMillisecond);

template <class Real>
void gather(benchmark::State& state) {
  const Workload w = workload(Pulse::Kind::chirp, 1000.0, 20000, 0.1);
  const RowFrame frame{carrier_hz, w.grid.first_s, interval_s, -1e9, 1e9};
  Strengths<Real> out;
  gather_strengths(w.echoes, frame, out);
  for (std::size_t k = 0; k < w.echoes.size(); ++k) {
    const double cycles = carrier_hz * w.echoes.delay_s[k];
    const std::complex<double> expected =
        w.echoes.amplitude_sqrt_w[k] * std::polar(1.0, -2.0 * core::pi * (cycles - std::round(cycles)));
    if (!(std::abs(std::complex<double>(out.strength[k]) - expected) < 1e-6))
      return state.SkipWithError("a strength differs from its formula");
  }
  for ([[maybe_unused]] auto _ : state) {
    gather_strengths(w.echoes, frame, out);
    benchmark::DoNotOptimize(out.strength.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(w.echoes.size()));
}
BENCHMARK_TEMPLATE(gather, float);
BENCHMARK_TEMPLATE(gather, double);

using Law = PointArrays::Law;
using Offsets = AntennaView::Offsets;

core::Interpolator curve_of(core::Interpolation method) {
  core::SampledFunction function{method, {}};
  for (int i = 0; i <= 36; ++i) function.knots.push_back({5.0 * i, -0.2 * i - (i % 4 == 3 ? 6.0 : 0.0)});
  return core::Interpolator(function);
}

CurveTables tables_of(core::Interpolation method) {
  const core::Interpolator curve = curve_of(method);
  return tabulate(std::array{&curve}, 0.2e-6);
}

PointArrays random_points(std::size_t count, Law law) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-500.0, 500.0);
  PointArrays points;
  points.law = law;
  for (std::size_t i = 0; i < count; ++i) {
    points.x_m.push_back(place(random));
    points.y_m.push_back(place(random));
    points.z_m.push_back(0.1 * place(random));
    points.root_rcs_m.push_back(1.0);
    if (law == Law::isotropic) continue;
    points.normal_x.push_back(0.0);
    points.normal_y.push_back(-0.6);
    points.normal_z.push_back(0.8);
    if (law == Law::curve) points.curve_cell.push_back(0.0);
  }
  return points;
}

PointArrays random_points_with_jitter(std::size_t count, Law law) {
  PointArrays points = random_points(count, law);
  PointJitter& jitter = points.jitter;
  for (std::size_t i = 0; i < count; ++i) {
    for (auto* column : {&jitter.x_stddev_m, &jitter.y_stddev_m, &jitter.z_stddev_m, &jitter.rcs_stddev_m2})
      column->push_back(0.1);
    jitter.position_key.push_back(core::RandomStream(1, core::RandomKind::target_position, i).key());
    jitter.rcs_m2.push_back(1.0);
    jitter.rcs_key.push_back(core::RandomStream(1, core::RandomKind::target_rcs, i).key());
    if (law == Law::isotropic) continue;
    jitter.azimuth_rad.push_back(3.0);
    jitter.elevation_rad.push_back(0.6);
    jitter.azimuth_stddev_rad.push_back(0.1);
    jitter.elevation_stddev_rad.push_back(0.1);
    jitter.pointing_key.push_back(core::RandomStream(1, core::RandomKind::target_pointing, i).key());
  }
  return points;
}

AntennaView sinx_antenna(Offsets offsets = Offsets::antenna_frame) {
  AntennaView antenna;
  antenna.offsets = offsets;
  antenna.roots = offsets == Offsets::world_angles;
  antenna.cut.fill(2.5);
  return antenna;
}

AntennaView user_antenna(core::Interpolation method, Offsets offsets = Offsets::antenna_frame) {
  AntennaView antenna;
  antenna.offsets = offsets;
  antenna.curves = tables_of(method);
  antenna.curve_cell.fill(0.0);
  return antenna;
}

void sight(benchmark::State& state, const PointArrays& points, const AntennaView& antenna,
           core::Interpolation reflectivity) {
  ViewFrame frame;
  frame.origin_m = {100.0, 3000.0, -1000.0};
  frame.radar_mps = frame.radar_slope_mps = {100.0, 0.0, 0.0};
  frame.light_speed_mps = core::exact_light_speed_mps;
  frame.amplitude_scale = 1e-3;
  frame.axis_azimuth_rad = 0.03;
  frame.axis_elevation_rad = -0.3;
  const CurveTables curves = tables_of(reflectivity);
  EchoBatch echoes;
  for (std::size_t i = 0; i < points.size(); ++i) echoes.add(0.0, -1.0, 0.0);
  if (!write_echoes(points, {0, points.size()}, frame, antenna, curves, echoes, 0))
    return state.SkipWithError("an echo is impossible");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = core::norm(frame.origin_m + core::Vec3{points.x_m[i], points.y_m[i], points.z_m[i]});
    const double delay = 2.0 * distance / core::exact_light_speed_mps;
    const double bound = points.jitter.position_key.empty() ? 1e-6 : 1e-3;  // the radar flies on, 2 V/c
    if (!(std::abs(echoes.delay_s[i] - delay) < bound * delay)) return state.SkipWithError("a delay is wrong");
  }
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(write_echoes(points, {0, points.size()}, frame, antenna, curves, echoes, 0));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
constexpr std::size_t many = 20000;
BENCHMARK_CAPTURE(sight, isotropic, random_points(many, Law::isotropic), AntennaView{}, {});
BENCHMARK_CAPTURE(sight, cosine_law, random_points(many, Law::cosine), AntennaView{}, {});
BENCHMARK_CAPTURE(sight, sinx_beam, random_points(many, Law::isotropic), sinx_antenna(), {});
BENCHMARK_CAPTURE(sight, classic_sinx_beam, random_points(many, Law::isotropic), sinx_antenna(Offsets::world_angles),
                  {});
BENCHMARK_CAPTURE(sight, user_antenna_linear, random_points(many, Law::isotropic),
                  user_antenna(core::Interpolation::linear), {});
BENCHMARK_CAPTURE(sight, user_antenna_cubic, random_points(many, Law::isotropic),
                  user_antenna(core::Interpolation::cubic), {});
BENCHMARK_CAPTURE(sight, user_antenna_low_pass, random_points(many, Law::isotropic),
                  user_antenna(core::Interpolation::low_pass), {});
BENCHMARK_CAPTURE(sight, classic_user_antenna_linear, random_points(many, Law::isotropic),
                  user_antenna(core::Interpolation::linear, Offsets::world_angles), {});
BENCHMARK_CAPTURE(sight, user_reflectivity_linear, random_points(many, Law::curve), AntennaView{},
                  core::Interpolation::linear);
BENCHMARK_CAPTURE(sight, user_reflectivity_low_pass, random_points(many, Law::curve), AntennaView{},
                  core::Interpolation::low_pass);
BENCHMARK_CAPTURE(sight, deviations_of_position_and_rcs, random_points_with_jitter(many, Law::isotropic), AntennaView{},
                  {});
BENCHMARK_CAPTURE(sight, deviations_of_everything, random_points_with_jitter(many, Law::cosine), AntennaView{}, {});

}  // namespace
}  // namespace sarsim::radar

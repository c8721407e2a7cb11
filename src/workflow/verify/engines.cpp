#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "simulate/plan/row_maker.hpp"
#include "simulate/resolve/simd_level.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/scenes.hpp"
#include "workflow/verify/textbook.hpp"

namespace sarsim::workflow::verify {

namespace {

using Row = std::vector<std::complex<double>>;

// Targets on a platform that passes and turns, seen by a chirp.
scene::Scene busy_scene(std::size_t targets, scene::PulseDefinition pulse, double tolerance) {
  scene::Scene scene = radar_at_origin();
  scene.options.pulse = pulse;
  scene.options.tolerance = tolerance;
  scene::Radar& radar = scene.radars[0];
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 50e6;
  radar.pulse_width_s = 4e-6;
  scene::Platform& ship = add_mover(scene, "Ship", {3000.0, 0.0, 0.0}, {12.0, 60.0, 0.0});
  ship.rotation_rate[2] = core::Angle::from_deg(5.0);
  for (std::size_t i = 0; i < targets; ++i) {
    const auto place = static_cast<double>(i);
    add_target(scene, {std::fmod(7.31 * place, 400.0), std::fmod(3.17 * place, 120.0), std::fmod(place, 9.0)},
               0.5 + std::fmod(0.11 * place, 2.0), "Ship");
  }
  set_window(scene, 2900.0, 4200.0, 75e6);
  set_pulses(scene, 0, 7);
  return scene;
}

// Root of the sum of |a|^2 over the echoes of a row that touch it.
double strength_v(const simulate::Plan& plan, std::size_t row) {
  simulate::PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
  geometry.set_pulse(plan.acquisition.timing.first_pulse_of_row(row));
  radar::EchoBatch echoes;
  geometry.echoes(echoes);
  double squares = 0.0;
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const radar::SampleSpan on =
        radar::touched_samples(plan.acquisition.reception.pulse, plan.acquisition.reception.raw_grid, echoes.delay_s[k],
                               plan.acquisition.reception.pulse.clock_of(echoes, k));
    if (on.begin < on.end) squares += echoes.amplitude_sqrt_w[k] * echoes.amplitude_sqrt_w[k];
  }
  return std::sqrt(squares);
}

// The plain sum of a scene, which is slow: once for all engines and tolerances.
struct PlainRows {
  std::vector<Row> rows;
  std::vector<double> norms_v;  // Of each row, sqrt(sum |a|^2 |p|^2).
};

PlainRows plain_rows_of(const scene::Scene& scene) {
  const simulate::Plan plan = simulate::make_plan(scene, 0, nullptr, simulate::Engine::reference);
  simulate::RowMaker maker(plan);
  const double samples =
      plan.acquisition.reception.pulse.pulse.width_s / plan.acquisition.reception.raw_grid.interval_s;
  PlainRows plain;
  for (std::size_t row = 0; row < plan.acquisition.timing.rows; ++row) {
    maker.make_row(row, plain.rows.emplace_back(plan.acquisition.reception.columns));
    plain.norms_v.push_back(std::sqrt(samples) * strength_v(plan, row));
  }
  return plain;
}

// The largest over the pulses of |s - s_ref|/sqrt(sum |a|^2 |p|^2): what --tolerance promises.
double relative_error(const scene::Scene& scene, simulate::Engine engine, const PlainRows& plain) {
  const simulate::Plan fast = simulate::make_plan(scene, 0, nullptr, engine);
  simulate::RowMaker maker(fast);
  Row found(fast.acquisition.reception.columns);
  double worst = 0.0;
  for (std::size_t row = 0; row < plain.rows.size(); ++row) {
    maker.make_row(row, found);
    double error = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) error += std::norm(found[i] - plain.rows[row][i]);
    worst = std::max(worst, std::sqrt(error) / plain.norms_v[row]);
  }
  return worst;
}

void measure_accuracy(Record& record) {
  const std::size_t targets = record.quick() ? 60 : 400;
  std::vector<double> tolerances{1e-3, 1e-6, 1e-9};
  if (!record.quick()) tolerances = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
  Chart chart{{}, "Errors of the fast engines", "--tolerance", "relative error", {}, true, true};
  Curve allowed{"allowed", tolerances, tolerances, false};
  for (const scene::PulseDefinition pulse : {scene::PulseDefinition::ideal, scene::PulseDefinition::band_limited}) {
    const PlainRows plain = plain_rows_of(busy_scene(targets, pulse, 1e-6));
    for (const simulate::RowKernelKind& kind : simulate::row_kernels().subspan(1)) {
      const simulate::Engine engine = kind.engine;
      const std::string name = fmt::format("{}, {} pulses", simulate::name_of(engine),
                                           pulse == scene::PulseDefinition::ideal ? "ideal" : "band-limited");
      Curve curve{name, {}, {}, true};
      for (const double tolerance : tolerances) {
        const double error = relative_error(busy_scene(targets, pulse, tolerance), engine, plain);
        curve.x.push_back(tolerance);
        curve.y.push_back(std::max(error, 1e-17));
        record.at_most(fmt::format("Error of {} at {:g}", name, tolerance), "", tolerance, error,
                       "the plain sum in double precision");
      }
      chart.curves.push_back(std::move(curve));
    }
  }
  chart.curves.push_back(std::move(allowed));
  record.chart(std::move(chart));
}

// --simd LEVEL: all that this program and this processor have.
void measure_levels(Record& record) {
  const std::size_t targets = record.quick() ? 20 : 100;
  std::vector<scene::PulseDefinition> pulses{scene::PulseDefinition::ideal};
  if (!record.quick()) pulses.push_back(scene::PulseDefinition::band_limited);
  std::vector<scene::Scene> busy;
  std::vector<PlainRows> plain;
  for (const scene::PulseDefinition pulse : pulses)
    plain.push_back(plain_rows_of(busy.emplace_back(busy_scene(targets, pulse, 1e-6))));
  for (const std::string& level : simulate::simd_levels()) {
    const simulate::SimdLevelScope scope(level);
    for (const simulate::RowKernelKind& kind : simulate::row_kernels().subspan(1)) {
      const simulate::Engine engine = kind.engine;
      double worst = simulate::simd_level() == level ? 0.0 : 1.0;
      for (std::size_t i = 0; i < busy.size(); ++i) worst = std::max(worst, relative_error(busy[i], engine, plain[i]));
      record.at_most(fmt::format("Error of {} with --simd {} at 1e-06", simulate::name_of(engine), level), "", 1e-6,
                     worst, "the plain sum in double precision");
    }
  }
}

void measure_textbook(Record& record) {
  const scene::Scene scene = busy_scene(40, scene::PulseDefinition::ideal, 1e-6);
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  simulate::RowMaker rows(plan);
  Row got(plan.acquisition.reception.columns);
  rows.make_row(3, got);
  simulate::PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
  geometry.set_pulse(plan.acquisition.timing.first_pulse_of_row(3));
  radar::EchoBatch echoes;
  geometry.echoes(echoes);
  Row expected(plan.acquisition.reception.columns);
  add_textbook_echoes(expected, plan.acquisition.reception.raw_grid, plan.acquisition.reception.pulse,
                      geometry.carrier_hz(), echoes);
  double error = 0.0;
  double power = 0.0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    error += std::norm(got[i] - expected[i]);
    power += std::norm(expected[i]);
  }
  record.at_most("Plain sum against a textbook's listing", "", 1e-9, std::sqrt(error / power),
                 "one sine and one cosine for each echo and sample");
}

scene::Scene noisy_scene() {
  scene::Scene scene = busy_scene(50, scene::PulseDefinition::ideal, 1e-6);
  scene.radars[0].noise_temperature_k = 300.0;
  for (scene::Target& target : scene.targets) target.traits.edit().rcs_stddev_m2 = 0.1;
  scene.platforms.back().position_stddev_m = {0.01, 0.01, 0.01};
  set_pulses(scene, 0, 63);
  return scene;
}

double differing(const Row& a, const Row& b) {
  double count = a.size() == b.size() ? 0.0 : 1.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += a[i] == b[i] ? 0.0 : 1.0;
  return count;
}

void measure_repeatability(Record& record) {
  const scene::Scene scene = noisy_scene();
  const auto recorded_by = [&](unsigned threads) {
    raster::RunControl control;
    control.threads = threads;
    control.stop = record.rules().stop;
    return sarsim::simulate::record(simulate::make_plan(scene, 0, nullptr, simulate::Engine::automatic), control)
        .samples;
  };
  const Row alone = recorded_by(1);
  record.near("Samples that differ between 1 and 4 threads", "", 0.0, differing(alone, recorded_by(4)), 0.0,
              "same input, same bytes");
  scene::Scene later = scene;
  set_pulses(later, 20, 29);
  const Row part =
      sarsim::simulate::record(simulate::make_plan(later, 0, nullptr, simulate::Engine::automatic)).samples;
  const std::size_t columns = part.size() / 10;
  const Row same(alone.begin() + static_cast<std::ptrdiff_t>(20 * columns),
                 alone.begin() + static_cast<std::ptrdiff_t>(30 * columns));
  record.near("Samples that differ when ten pulses are recorded alone", "", 0.0, differing(part, same), 0.0,
              "noise belongs to pulse and sample");
}

}  // namespace

void measure_engines(Record& record) {
  measure_textbook(record);
  measure_accuracy(record);
  measure_levels(record);
  measure_repeatability(record);
}

}  // namespace sarsim::workflow::verify

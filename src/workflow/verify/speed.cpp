#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include <fmt/format.h>

#include "core/task/clock.hpp"
#include "simulate/plan/row_maker.hpp"
#include "simulate/resolve/simd_level.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/scenes.hpp"
#include "workflow/verify/textbook.hpp"

namespace sarsim::workflow::verify {

namespace {

using Row = std::vector<std::complex<double>>;

// The machine may do other things as well: the best of several tries says most about the program.
double best_s(int tries, const std::function<void()>& work) {
  double best = 1e300;
  for (int i = 0; i < tries; ++i) {
    const double begin_s = core::now_s();
    work();
    best = std::min(best, core::now_s() - begin_s);
  }
  return best;
}

scene::Scene crowd(std::size_t targets) {
  scene::Scene scene = radar_at_origin();
  scene::Radar& radar = scene.radars[0];
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 50e6;
  radar.pulse_width_s = 5e-6;
  scene::Platform& field = add_mover(scene, "Field", {5000.0, 0.0, 0.0}, {3.0, 40.0, 0.0});
  field.rotation_rate[2] = core::Angle::from_deg(1.0);
  for (std::size_t i = 0; i < targets; ++i) {
    const auto place = static_cast<double>(i);
    add_target(scene, {std::fmod(7.31 * place, 900.0), std::fmod(3.17 * place, 500.0), 0.0}, 1.0, "Field");
  }
  set_window(scene, 4800.0, 6900.0, 75e6);
  set_pulses(scene, 0, 7);
  return scene;
}

// Seconds of a pulse by the textbook's listing; a part of the echoes is enough.
double textbook_pulse_s(const simulate::Plan& plan) {
  simulate::PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
  geometry.set_pulse(plan.acquisition.timing.first_pulse_of_row(0));
  radar::EchoBatch echoes;
  geometry.echoes(echoes);
  radar::EchoBatch part;
  const std::size_t stride = echoes.size() / 300 + 1;
  for (std::size_t k = 0; k < echoes.size(); k += stride)
    part.add(echoes.delay_s[k], echoes.amplitude_sqrt_w[k], echoes.doppler[k]);
  Row row(plan.acquisition.reception.raw_grid.count);
  const double seconds = best_s(3, [&] {
    add_textbook_echoes(row, plan.acquisition.reception.raw_grid, plan.acquisition.reception.pulse,
                        geometry.carrier_hz(), part);
  });
  return seconds * static_cast<double>(echoes.size()) / static_cast<double>(part.size());
}

double engine_pulse_s(const simulate::Plan& plan) {
  simulate::RowMaker rows(plan);
  Row row(plan.acquisition.reception.columns);
  rows.make_row(0, row);
  const double seconds = best_s(5, [&] {
    for (std::size_t i = 0; i < plan.acquisition.timing.rows; ++i) rows.make_row(i, row);
  });
  return seconds / static_cast<double>(plan.acquisition.timing.rows);
}

}  // namespace

void measure_speed(Record& record) {
  Chart chart{{},  fmt::format("Time of a pulse on one thread, {}", simulate::simd_level()), "targets", "s", {}, true,
              true};
  Curve textbook{"textbook's loop", {}, {}, false};
  Curve engine{"sarsim", {}, {}, false};
  for (const std::size_t targets : {std::size_t{30}, std::size_t{1000}, std::size_t{30000}}) {
    const scene::Scene scene = crowd(targets);
    const simulate::Plan plan = simulate::make_plan(scene, 0, nullptr, simulate::Engine::automatic);
    const double fast_s = engine_pulse_s(plan);
    const double slow_s = textbook_pulse_s(plan);
    textbook.x.push_back(static_cast<double>(targets));
    textbook.y.push_back(slow_s);
    engine.x.push_back(static_cast<double>(targets));
    engine.y.push_back(fast_s);
    record.at_least(fmt::format("{} targets: times as fast as a textbook's loop", targets), "", 3.0, slow_s / fast_s,
                    fmt::format("{} engine, {}, one thread; the loop takes one sine and one cosine for each echo and "
                                "sample",
                                simulate::name_of(plan.engine.engine), simulate::simd_level()));
  }
  chart.curves = {textbook, engine};
  record.chart(std::move(chart));
}

}  // namespace sarsim::workflow::verify

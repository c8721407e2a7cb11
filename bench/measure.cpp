// Times the engines on the first simulation of a script, one thread, next to the textbook loop, and checks them against
// the reference first. Prints one JSON object.
//
//   measure SCENE.scr [PULSES] [ENGINE] [TOLERANCE] [SIMD] [SIMD]

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "core/maths/constants.hpp"
#include "scene/script/reader.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/plan/row_maker.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace {

using namespace sarsim::core;
using namespace sarsim::radar;
using namespace sarsim::scene;
using namespace sarsim::simulate;
using Row = std::vector<std::complex<double>>;

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

SampleSpan touched_by(const Plan& plan, const EchoBatch& echoes, std::size_t k) {
  return touched_samples(plan.acquisition.reception.pulse, plan.acquisition.reception.raw_grid, echoes.delay_s[k],
                         plan.acquisition.reception.pulse.clock_of(echoes, k));
}

// What a textbook's listing does: for every echo and sample one sine and one cosine in double precision.
void textbook_row(const Plan& plan, double carrier_hz, const EchoBatch& echoes, Row& row) {
  const double rate = plan.acquisition.reception.pulse.pulse.sweep_rate_hz_per_s();
  const double width = plan.acquisition.reception.pulse.pulse.width_s;
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const double tau = echoes.delay_s[k];
    const double a = echoes.amplitude_sqrt_w[k];
    const double doppler = echoes.doppler[k];
    const SampleSpan on = touched_by(plan, echoes, k);
    for (std::size_t n = on.begin; n < on.end; ++n) {
      const double u =
          plan.acquisition.reception.raw_grid.time_s(n) - tau + plan.acquisition.reception.pulse.lead_s - 0.5 * width;
      const double mod = 0.5 * rate * u * u;
      const double phase = 2.0 * pi * (mod - carrier_hz * tau - doppler * (carrier_hz * u + mod));
      row[n] += std::complex<double>(a * std::cos(phase), a * std::sin(phase));
    }
  }
}

// Largest relative error per pulse, || s - s_ref || / sqrt(sum |a|^2 N).
double error_against_reference(const Plan& plan, const Plan& reference, std::size_t rows) {
  RowMaker fast(plan);
  RowMaker slow(reference);
  PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
  EchoBatch echoes;
  Row a(plan.acquisition.reception.columns), b(plan.acquisition.reception.columns);
  double worst = 0.0;
  for (std::size_t r = 0; r < rows; ++r) {
    fast.make_row(r, a);
    slow.make_row(r, b);
    geometry.set_pulse(plan.acquisition.timing.first_pulse_of_row(r));
    geometry.echoes(echoes);
    double strength = 0.0;
    for (std::size_t k = 0; k < echoes.size(); ++k) {
      const SampleSpan on = touched_by(plan, echoes, k);
      if (on.begin < on.end) strength += echoes.amplitude_sqrt_w[k] * echoes.amplitude_sqrt_w[k];
    }
    double error = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) error += std::norm(a[n] - b[n]);
    const double samples =
        plan.acquisition.reception.pulse.pulse.width_s / plan.acquisition.reception.raw_grid.interval_s;
    if (strength > 0.0) worst = std::max(worst, std::sqrt(error / (strength * samples)));
  }
  return worst;
}

double best_of(int tries, const std::function<void()>& work) {
  double best = 1e300;
  for (int i = 0; i < tries; ++i) {
    const double begin = now_s();
    work();
    best = std::min(best, now_s() - begin);
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "measure SCENE.scr [PULSES] [ENGINE] [TOLERANCE] [SIMD]\n");
    return 2;
  }
  ScriptReading reading = read_script_file(argv[1]);
  if (has_errors(reading.problems)) {
    std::fprintf(stderr, "%s\n", to_string(reading.problems.front()).c_str());
    return 2;
  }
  const std::size_t wanted = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 20;
  const Engine engine = argc > 3 ? engine_from_name(argv[3]).value_or(Engine::automatic) : Engine::automatic;
  if (argc > 4) reading.scene.options.tolerance = std::strtod(argv[4], nullptr);
  if (argc > 5 && !use_simd_level(argv[5])) {
    std::fprintf(stderr, "no SIMD level %s here\n", argv[5]);
    return 2;
  }
  const auto resolved = std::make_shared<const ResolvedScene>(resolve(reading.scene));
  const Plan plan = make_plan(reading.scene, 0, resolved, engine);
  const Plan reference = make_plan(reading.scene, 0, resolved, Engine::reference);
  const std::size_t rows = std::min(plan.acquisition.timing.rows, wanted);

  const double error = error_against_reference(plan, reference, std::min<std::size_t>(rows, 2));
  RowMaker maker(plan);
  Row row(plan.acquisition.reception.columns);
  maker.make_row(0, row);
  const double seconds = best_of(7, [&] {
    for (std::size_t r = 0; r < rows; ++r) maker.make_row(r, row);
  });

  PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
  EchoBatch echoes;
  geometry.set_pulse(plan.acquisition.timing.first_pulse_of_row(0));
  geometry.echoes(echoes);
  double touching = 0.0;
  double echo_samples = 0.0;
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const SampleSpan on = touched_by(plan, echoes, k);
    touching += on.begin < on.end ? 1.0 : 0.0;
    echo_samples += static_cast<double>(on.end - on.begin);
  }
  Row textbook(plan.acquisition.reception.raw_grid.count);
  // A part of the echoes is enough where there are many.
  EchoBatch part;
  const std::size_t stride = echoes.size() / 2000 + 1;
  double part_samples = 0.0;
  for (std::size_t k = 0; k < echoes.size(); k += stride) {
    part.add(echoes.delay_s[k], echoes.amplitude_sqrt_w[k], echoes.doppler[k]);
    const SampleSpan on = touched_by(plan, echoes, k);
    part_samples += static_cast<double>(on.end - on.begin);
  }
  const double textbook_s = best_of(3, [&] { textbook_row(plan, geometry.carrier_hz(), part, textbook); });
  const double per_pulse_s = seconds / static_cast<double>(rows);
  const double textbook_pulse_s = textbook_s * (part_samples > 0.0 ? echo_samples / part_samples : 0.0);
  std::printf(
      "{\"engine\": \"%s\", \"simd\": \"%s\", \"error\": %.3g, \"echoes\": %.0f, \"echo_samples\": %.0f, \"pulse_s\": "
      "%.6g, "
      "\"ns_per_echo\": %.4g, \"ns_per_echo_sample\": %.4g, \"textbook_pulse_s\": %.6g, "
      "\"textbook_ns_per_echo_sample\": %.4g, "
      "\"ratio\": %.5g}\n",
      std::string(name_of(plan.engine.engine)).c_str(), simd_level().c_str(), error, touching, echo_samples,
      per_pulse_s, 1e9 * per_pulse_s / std::max(touching, 1.0), 1e9 * per_pulse_s / std::max(echo_samples, 1.0),
      textbook_pulse_s, 1e9 * textbook_pulse_s / std::max(echo_samples, 1.0), textbook_pulse_s / per_pulse_s);
  return 0;
}

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "core/maths/constants.hpp"
#include "radar/receiver/converter.hpp"
#include "workflow/verify/counts.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/moments.hpp"
#include "workflow/verify/response.hpp"
#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

namespace {

// What is expected is written out here, not taken from radar/path, which made what is found.
constexpr double carrier_hz = 1e9;
constexpr double wavelength_m = core::exact_light_speed_mps / carrier_hz;

// sqrt(P lambda^2 sigma/((4 pi)^3 d^4)) of the radar of `radar_at_origin`.
double amplitude_v(double range_m, double rcs_m2 = 1.0) {
  return std::sqrt(1000.0 * rcs_m2) * wavelength_m / (std::pow(4.0 * core::pi, 1.5) * range_m * range_m);
}

// Looks at one target in the middle of a raw pulse of 5 us.
std::complex<double> echo_of(const core::Vec3& position_m, double rcs_m2 = 1.0) {
  scene::Scene scene = radar_at_origin();
  add_target(scene, position_m, rcs_m2);
  const double range_m = std::sqrt(core::dot(position_m, position_m));
  set_window(scene, range_m + 100.0, range_m + 200.0, 4e6);
  return recorded(scene).samples.front();
}

void measure_radar_equation(Record& record) {
  const double expected_v = amplitude_v(1000.0);
  record.near("Amplitude of 1 m2 at 1 km", "V", expected_v, std::abs(echo_of({1000.0, 0.0, 0.0})), 1e-12 * expected_v,
              "sqrt(P lambda^2 sigma/((4 pi)^3 d^4))");
  record.near("Amplitude at 1 km over that at 3 km", "", 9.0,
              std::abs(echo_of({0.0, 600.0, 800.0})) / std::abs(echo_of({0.0, 1800.0, 2400.0})), 1e-11, "d^-2");
  record.near("Amplitude of 4 m2 over that of 1 m2", "", 2.0,
              std::abs(echo_of({1000.0, 0.0, 0.0}, 4.0)) / std::abs(echo_of({1000.0, 0.0, 0.0})), 1e-12, "sqrt(sigma)");
  const double turns = std::remainder(2.0 * 1000.0 / wavelength_m, 1.0);
  record.near("Phase of a target at 1 km", "deg", -360.0 * turns,
              core::deg_per_rad * std::arg(echo_of({1000.0, 0.0, 0.0})), 1e-6, "-2 pi f 2 d/c");
  double worst_rad = 0.0;
  for (int i = 1; i <= 20; ++i) {
    const double range_m = 1000.0 + 0.37 * i;
    const double expected_rad = -2.0 * core::pi * std::remainder(2.0 * range_m / wavelength_m, 1.0);
    worst_rad = std::max(worst_rad, std::abs(wrapped_rad(std::arg(echo_of({range_m, 0.0, 0.0})) - expected_rad)));
  }
  record.at_most("Largest error of the phase at 20 ranges", "deg", 1e-6, core::deg_per_rad * worst_rad,
                 "delays are never rounded to samples");
}

void measure_doppler(Record& record) {
  constexpr double speed_mps = 50.0;
  scene::Scene scene = radar_at_origin();
  scene.radars[0].carrier_hz = carrier_hz;
  add_mover(scene, "Car", {1000.0, 0.0, 0.0}, {speed_mps, 0.0, 0.0});
  add_target(scene, {0.0, 0.0, 0.0}, 1.0, "Car");
  set_window(scene, 1200.0, 1300.0, 4e6);
  set_pulses(scene, 0, 1);
  const auto samples = column(recorded(scene), 0);
  // The delay is 2 d/(c - v), so d = v/PRF more make 2 v/((c - v) PRF) more of it; within the pulse the echo is shifted
  // by 2 v f/c, which the same sample sees that much later.
  const double later_s = 2.0 * speed_mps / ((core::exact_light_speed_mps - speed_mps) * 1000.0);
  const double shift_hz = 2.0 * speed_mps * carrier_hz / core::exact_light_speed_mps;
  const double expected_rad = wrapped_rad(-2.0 * core::pi * (carrier_hz - shift_hz) * later_s);
  record.near("Phase step of 50 m/s at 1 GHz and 1 kHz", "deg", core::deg_per_rad * expected_rad,
              core::deg_per_rad * wrapped_rad(std::arg(samples[1]) - std::arg(samples[0])), 1e-5,
              "-2 pi f 2 v/((c - v) PRF), Doppler within the pulse");
}

void measure_antenna(Record& record) {
  scene::Scene scene = radar_at_origin();
  scene::Radar& radar = scene.radars[0];
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(10.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(10.0);
  const double offset_rad = 5.0 / core::deg_per_rad;
  add_target(scene, {1000.0 * std::sin(offset_rad), 1000.0 * std::cos(offset_rad), 0.0});
  set_window(scene, 1100.0, 1200.0, 4e6);
  const double x = 0.88 * core::pi * std::sin(offset_rad) / (10.0 / core::deg_per_rad);
  record.near("Two-way gain of a sin(x)/x beam half a width off", "dB", 40.0 * std::log10(std::sin(x) / x),
              20.0 * std::log10(std::abs(recorded(scene).samples.front()) / amplitude_v(1000.0)), 1e-9,
              "x = 0.88 pi sin(offset)/width, one way");
}

constexpr double bandwidth_hz = 50e6;
constexpr double fine = 64.0;  // samples per 1/B

scene::Scene chirp(double time_bandwidth) {
  scene::Scene scene = radar_at_origin();
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = bandwidth_hz;
  scene.radars[0].pulse_width_s = time_bandwidth / bandwidth_hz;
  scene.simulations[0].sample_rate_hz = fine * bandwidth_hz;
  return scene;
}

// Autocorrelation of a chirp of rectangular envelope (Cook and Bernfeld 1967).
double autocorrelation(double lag_s, double width_s) {
  if (lag_s == 0.0) return 1.0;
  const double x = core::pi * bandwidth_hz * lag_s;
  return std::abs(std::sin(x * (1.0 - std::abs(lag_s) / width_s)) / x);
}

double level_db(double ratio) { return 20.0 * std::log10(std::max(ratio, 1e-5)); }

void measure_compression(Record& record) {
  constexpr double time_bandwidth = 100.0;
  const double width_s = time_bandwidth / bandwidth_hz;
  const Response r = point_response(chirp(time_bandwidth), 8 * 64);
  double worst = 0.0;
  Curve measured{"simulated", {}, {}, false};
  Curve theory{"theory", {}, {}, true};
  for (std::size_t i = 0; i < r.amplitude.size(); ++i) {
    const double expected = autocorrelation(r.delay_s(i), width_s);
    worst = std::max(worst, std::abs(r.amplitude[i] - expected));
    measured.x.push_back(r.delay_s(i) * bandwidth_hz);
    measured.y.push_back(level_db(r.amplitude[i]));
    if (i % 8 != 0) continue;
    theory.x.push_back(measured.x.back());
    theory.y.push_back(level_db(expected));
  }
  // A sum over N samples for an integral, and lags to the left that overlap by one sample less.
  const double samples = fine * time_bandwidth;
  record.at_most("Compressed chirp: largest deviation from its autocorrelation", "",
                 1.0 / samples + core::pi * 8.0 / (6.0 * samples * samples), worst,
                 "sin(pi B s (1 - |s|/Tp))/(pi B s), Cook and Bernfeld 1967");
  record.near("Compressed chirp: peak side lobe, B Tp = 100", "dB", -13.39, side_lobe_db(r), 0.02, "same formula");
  record.near("Compressed chirp: half-power width times B", "", 0.8845, half_power_width_s(r) * bandwidth_hz, 0.0005,
              "same formula");
  record.chart({{},
                "A chirp after the matched filter, B Tp = 100",
                "delay times bandwidth",
                "dB",
                {measured, theory},
                false,
                false});
}

void measure_windows(Record& record) {
  struct Weighting {
    const char* name;
    scene::Radar::Window window;
    double side_lobe_db;
    double width;
  };
  // The longer the chirp, the nearer its spectrum is to the rectangle that the textbooks weight.
  const double time_bandwidth = 20000.0;
  for (const Weighting& w : {Weighting{"Hanning", scene::Radar::Window::hanning, -31.47, 1.441},
                             Weighting{"Hamming", scene::Radar::Window::hamming, -42.68, 1.303},
                             Weighting{"Bartlett", scene::Radar::Window::bartlett, -26.52, 1.276}}) {
    scene::Scene scene = chirp(time_bandwidth);
    scene.simulations[0].sample_rate_hz = 32.0 * bandwidth_hz;
    scene.radars[0].window = w.window;
    scene.radars[0].hanning_pedestal = 0.0;
    const Response r = point_response(scene, 8 * 32);
    record.near(std::string(w.name) + " window: peak side lobe", "dB", w.side_lobe_db, side_lobe_db(r), 0.06,
                "Harris 1978");
    record.near(std::string(w.name) + " window: half-power width times B", "", w.width,
                half_power_width_s(r) * bandwidth_hz, 0.001, "Harris 1978");
  }
}

void measure_codes(Record& record) {
  scene::Scene scene = radar_at_origin();
  scene.radars[0].pulse = scene::Radar::Pulse::barker;
  scene.radars[0].barker_code = 6;
  scene.radars[0].pulse_width_s = 1.3e-6;
  scene.simulations[0].sample_rate_hz = 100e6;
  record.near("Barker code of 13: peak side lobe", "dB", -20.0 * std::log10(13.0),
              side_lobe_db(point_response(scene, 150)), 0.005, "1/13");
}

void measure_converter(Record& record) {
  scene::Scene scene = chirp(4000.0);
  add_target(scene, {1100.0, 0.0, 0.0});
  add_target(scene, {1137.3, 0.0, 0.0}, 0.4);
  set_window(scene, 1000.0, 15000.0, 1.7 * bandwidth_hz);
  const auto volts = recorded(scene).samples;
  double largest_v = 0.0;
  for (const auto& v : volts) largest_v = std::max(largest_v, std::abs(v));
  const double lsb_v = largest_v / 2047.0;
  const auto counts = converted(volts, 12, lsb_v);
  double squares = 0.0;
  std::size_t number = 0;
  for (std::size_t i = 0; i < volts.size(); ++i) {
    if (volts[i] == 0.0) continue;
    squares += std::norm(counts[i] - volts[i] / lsb_v);
    number += 2;
  }
  const auto n = static_cast<double>(number);
  // The square of an error that is spread evenly over one count has the mean 1/12 and the variance 1/180.
  record.near("Quantisation noise of I and Q", "LSB^2", 1.0 / 12.0, squares / n, gate_sigmas / std::sqrt(180.0 * n),
              "evenly spread over one count");
}

}  // namespace

void measure_closed_forms(Record& record) {
  measure_radar_equation(record);
  measure_doppler(record);
  measure_antenna(record);
  measure_compression(record);
  if (!record.quick()) measure_windows(record);
  measure_codes(record);
  measure_converter(record);
}

}  // namespace sarsim::workflow::verify

#include "workflow/verify/thesis_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "radar/receiver/converter.hpp"
#include "scene/script/reader.hpp"
#include "simulate/run/run.hpp"
#include "workflow/verify/counts.hpp"
#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

namespace {

using Samples = std::vector<std::complex<double>>;

double largest_v(const scene::Scene& scene) { return recorded(scene).report.maximum_v; }

// Angle of the strongest sample, in degrees within (-180, 180].
double phase_deg(const Samples& samples) { return core::deg_per_rad * std::arg(samples[peak_index(samples)]); }

// ---- Chapter 3 and 4 ------------------------------------------------------------------------------------------

// Table 3.1.
scene::Scene chapter_3(scene::Profile profile) {
  scene::Scene scene = radar_at_origin(profile);
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 50e6;
  scene.radars[0].pulse_width_s = 5e-6;
  add_target(scene, {3000.0, 0.0, 0.0}, 3.0);
  set_window(scene, 2500.0, 4500.0, 100e6);
  return scene;
}

// The example of 4.4: monochrome, 1 us, 100 K, 1 m^2 at 1 km; sampled at the pulse's bandwidth 1/Tp.
scene::Scene section_4_4(scene::Profile profile) {
  scene::Scene scene = radar_at_origin(profile);
  scene.radars[0].pulse_width_s = 1e-6;
  add_target(scene, {1000.0, 0.0, 0.0});
  set_window(scene, 0.0, 2000.0, 1e6);
  return scene;
}

double noise_stddev_4_4_v(scene::Profile profile) {
  scene::Scene scene = section_4_4(profile);
  scene.radars[0].noise_temperature_k = 100.0;
  return simulate::make_plan(scene, 0).acquisition.reception.noise_stddev_v;
}

// N of (4.1): in the classic profile that of I and of Q, in the physical one that of both together at fs = 1/Tp.
double noise_power_4_4_w(scene::Profile profile) {
  const double stddev_v = noise_stddev_4_4_v(profile);
  return stddev_v * stddev_v * (profile == scene::Profile::classic ? 1.0 : 2.0);
}

double signal_power_4_4_w(scene::Profile profile) {
  const double amplitude_v = largest_v(section_4_4(profile));
  return amplitude_v * amplitude_v;
}

// Section 4.5.1: a pulse of 1 us sampled at 500 MHz, in a window of a thousand samples.
double samples_on_4_5_1(scene::Profile profile) {
  scene::Scene scene = section_4_4(profile);
  set_window(scene, 900.0, 1199.7925, 500e6);
  const simulate::Recording recording = recorded(scene);
  return static_cast<double>(recording.samples.size() - recording.report.zero);
}

double pulse_length_4_5_1_m(scene::Profile profile) {
  scene::Scene scene = section_4_4(profile);
  set_window(scene, 900.0, 1199.7925, 500e6);
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  return samples_on_4_5_1(profile) *
         (plan.acquisition.reception.column_range_m[1] - plan.acquisition.reception.column_range_m[0]);
}

// Section 4.5.2: a recording whose largest magnitude is 6.39369e-5 mV, LSB left to be estimated.
scene::Scene section_4_5_2(scene::Profile profile) {
  scene::Scene scene = section_4_4(profile);
  const double amplitude_v = largest_v(scene);
  scene.radars[0].power_w *= std::pow(6.39369e-8 / amplitude_v, 2);
  return scene;
}

double lsb_4_5_2_mv(scene::Profile profile) {
  return 1e3 * simulate::resolved_lsb_v(simulate::make_plan(section_4_5_2(profile), 0), {});
}

double code_4_5_2(scene::Profile profile) {
  const Samples one{{1.2e-8, 0.0}};
  return converted(one, 8, 1e-3 * lsb_4_5_2_mv(profile))[0].real() + radar::full_scale_count(8);
}

// The window of figure 4.9: 120 MHz, 1279 m, 400 Hz, 1.279 s.
simulate::Plan figure_4_9(scene::Profile profile) {
  scene::Scene scene = radar_at_origin(profile);
  scene.radars[0].prf_hz = 400.0;
  add_target(scene, {5600.0, 0.0, 0.0});
  set_window(scene, 5000.0, 6279.0, 120e6);
  scene.simulations[0].time_start_s = -0.64;
  scene.simulations[0].time_end_s = 0.639;
  return simulate::make_plan(scene, 0);
}

// ---- Appendix A.2 ---------------------------------------------------------------------------------------------

// 53 samples need 4 MHz: 20 times 1/Tp. (The 8 MHz of the text count a Nyquist rate of 2/Tp and would give 107.)
scene::Scene appendix_a2(scene::Profile profile) {
  scene::Scene scene = radar_at_origin(profile);
  add_target(scene, {1000.0, 0.0, 0.0});
  return scene;
}

std::complex<double> counts_a2(scene::Profile profile, double lsb_mv) {
  const simulate::Recording recording = recorded(appendix_a2(profile));
  return converted(recording.samples, 8, 1e-3 * lsb_mv)[peak_index(recording.samples)];
}

// Sampled at 100 times 1/Tp, with a window that starts a whole number of samples before the echo.
Samples compressed_a2(scene::Profile profile) {
  scene::Scene scene = appendix_a2(profile);
  const double light_speed_mps = simulate::make_plan(scene, 0).acquisition.scene->conventions.light_speed_mps;
  set_window(scene, 1000.0 - 4000.0 * light_speed_mps / (2.0 * 400e6), 1750.0, 400e6);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  return recorded(scene).samples;
}

double compressed_gain_a2(scene::Profile profile) {
  const Samples compressed = compressed_a2(profile);
  return std::abs(compressed[peak_index(compressed)]) / largest_v(appendix_a2(profile));
}

double compressed_turn_a2_deg(scene::Profile profile) {
  return phase_deg(compressed_a2(profile)) - phase_deg(recorded(appendix_a2(profile)).samples);
}

// ---- Appendix A.3 ---------------------------------------------------------------------------------------------

scene::Scene appendix_a3(scene::Profile profile, const std::vector<double>& offsets_m) {
  scene::Scene scene = radar_at_origin(profile);
  scene::Radar& radar = scene.radars[0];
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 100e6;
  radar.pulse_width_s = 2.5e-6;
  radar.carrier_hz = 0.5e9;
  add_mover(scene, "Test", {300.0, 0.0, 0.0}, {50.0, 0.0, 0.0});
  for (const double offset_m : offsets_m) add_target(scene, {offset_m, 0.0, 0.0}, 1.0, "Test");
  set_window(scene, 296.0, 312.0, 20e9);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  return scene;
}

// Mean turn per pulse of the compressed echo over the first nine pulses, looked at where the first one peaks.
double phase_step_a3_rad(scene::Profile profile) {
  scene::Scene scene = appendix_a3(profile, {0.0});
  set_pulses(scene, 0, 8);
  const simulate::Recording recording = recorded(scene);
  const Samples first(recording.samples.begin(),
                      recording.samples.begin() + static_cast<std::ptrdiff_t>(recording.report.columns));
  const Samples pulses = column(recording, peak_index(first));
  double turn_rad = 0.0;
  for (std::size_t i = 1; i < pulses.size(); ++i)
    turn_rad += wrapped_rad(std::arg(pulses[i]) - std::arg(pulses[i - 1]));
  return turn_rad / static_cast<double>(pulses.size() - 1);
}

// Distance from the peak of a compressed point to its first zero.
double resolution_a3_m(scene::Profile profile) {
  const scene::Scene scene = appendix_a3(profile, {0.0});
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  const Samples samples = recorded(scene).samples;
  const std::size_t peak = peak_index(samples);
  std::size_t zero = peak;
  while (std::norm(samples[zero + 1]) < std::norm(samples[zero])) ++zero;
  return plan.acquisition.reception.column_range_m[zero] - plan.acquisition.reception.column_range_m[peak];
}

// Range of the strongest sample between two ranges.
double peak_a3_m(scene::Profile profile, double from_m, double to_m) {
  const scene::Scene scene = appendix_a3(profile, {0.0, 8.0});
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  Samples samples = recorded(scene).samples;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (plan.acquisition.reception.column_range_m[i] < from_m || plan.acquisition.reception.column_range_m[i] > to_m)
      samples[i] = 0.0;
  return plan.acquisition.reception.column_range_m[peak_index(samples)];
}

// ---- Appendix A.4 ---------------------------------------------------------------------------------------------

// The beam meets the target's azimuth of 45 deg at 1.875 s, which is pulse 750.
scene::Scene appendix_a4(scene::Profile profile) {
  scene::Scene scene = radar_at_origin(profile);
  scene::Radar& radar = scene.radars[0];
  radar.prf_hz = 400.0;
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(30.0);
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(1.0);
  radar.beam = scene::Radar::Beam::rotating;
  radar.beam_elevation = core::Angle::from_deg(30.0);
  radar.beam_rate = core::Angle::from_deg(24.0);
  add_target(scene, {1000.0, 1000.0, 816.0});
  set_window(scene, 1600.0, 2400.0, 1e6);
  set_pulses(scene, 690, 810);
  return scene;
}

// Slow time at a range inside the pulse.
Samples passage_a4(scene::Profile profile) { return column(recorded(appendix_a4(profile)), 2); }

double phase_a4_deg(scene::Profile profile) {
  const double phase = phase_deg(passage_a4(profile));
  return phase < 0.0 ? phase + 360.0 : phase;
}

double side_lobe_a4_db(scene::Profile profile) {
  const Samples passage = passage_a4(profile);
  std::size_t i = peak_index(passage);
  const double peak = std::abs(passage[i]);
  while (std::norm(passage[i + 1]) < std::norm(passage[i])) ++i;
  double side = 0.0;
  for (; i < passage.size(); ++i) side = std::max(side, std::abs(passage[i]));
  return core::amplitude_db(side / peak);
}

// Width at half amplitude of the compressed echo: of the triangle with base c Tp it is c Tp/2.
double resolution_a4_m(scene::Profile profile) {
  scene::Scene scene = appendix_a4(profile);
  set_pulses(scene, 750, 750);
  set_window(scene, 600.0, 2600.0, 100e6);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  const Samples samples = recorded(scene).samples;
  const double half = 0.5 * std::abs(samples[peak_index(samples)]);
  const auto wide = std::ranges::count_if(samples, [half](const auto& s) { return std::abs(s) >= half; });
  return static_cast<double>(wide) *
         (plan.acquisition.reception.column_range_m[1] - plan.acquisition.reception.column_range_m[0]);
}

// ---- Figure 7.5 -----------------------------------------------------------------------------------------------

// Its numbers in the dialect of 1997: three angles straight after the alignment, twelve fields of the simulation.
constexpr const char* figure_7_5_script = R"(
$PLATFORM EARTH STATIONARY 0 0 0  0 0 0  STDDEV 0 0 0  STDDEV 0 0 0
$PLATFORM PLANE TRAJECTORY CUBIC CUBIC CUBIC INLINE
  2  0 100  1 -100
  1  0 -10000
  1  0 2000
  NOT_ALIGNED  0 0 0  STDDEV 0 0 0  STDDEV 0 0 0
$TARGET EARTH  0 -100 0  0 0 0  1 0  ISOTROPIC
$RADAR RADAR1 PLANE CHIRP 0.1 800 RECT CONSTANT 300 SINGLE 5.3 1 0 0
  SINX 30 30 SAME FIXED -11.3 0 RECT NO_STC
$SIMULATION RADAR1 10010 10510 -0.5 1.499 8 0.15 1.68257E-07 ASCII RAW SIM1.ASC BEGIN
)";

simulate::Plan figure_7_5(scene::Profile profile) {
  scene::ScriptReading reading = scene::read_script(figure_7_5_script, "figure-7.5.scr", {});
  reading.scene.options.profile = profile;
  return simulate::make_plan(reading.scene, 0);
}

ThesisNumber made(std::string name, std::function<double(scene::Profile)> value) {
  ThesisNumber number;
  number.name = std::move(name);
  number.value = std::move(value);
  return number;
}

void add_chapters_3_and_4(std::vector<ThesisNumber>& numbers) {
  const auto add = [&](const char* name, std::function<double(scene::Profile)> value) {
    numbers.push_back(made(name, std::move(value)));
  };
  add("Chapter3Power", [](scene::Profile p) { return std::pow(largest_v(chapter_3(p)), 2); });
  add("Chapter3Magnitude", [](scene::Profile p) { return 1e3 * largest_v(chapter_3(p)); });
  add("Section44SignalPower", signal_power_4_4_w);
  add("Section44NoisePower", noise_power_4_4_w);
  add("Section44Snr", [](scene::Profile p) { return signal_power_4_4_w(p) / noise_power_4_4_w(p); });
  add("Section44NoiseVoltage", [](scene::Profile p) { return std::sqrt(noise_power_4_4_w(p)); });
  add("Section44AmplitudeRatio",
      [](scene::Profile p) { return std::sqrt(signal_power_4_4_w(p) / noise_power_4_4_w(p)); });
  add("Section451Samples", samples_on_4_5_1);
  add("Section451Length", pulse_length_4_5_1_m);
  add("Section452Lsb", lsb_4_5_2_mv);
  add("Section452Code", code_4_5_2);
  add("Figure49Samples",
      [](scene::Profile p) { return static_cast<double>(figure_4_9(p).acquisition.reception.columns); });
  add("Figure49Pulses", [](scene::Profile p) { return static_cast<double>(figure_4_9(p).acquisition.timing.rows); });
}

void add_appendix(std::vector<ThesisNumber>& numbers) {
  const auto add = [&](const char* name, std::function<double(scene::Profile)> value) {
    numbers.push_back(made(name, std::move(value)));
  };
  add("A1Samples", [](scene::Profile p) { return static_cast<double>(recorded(appendix_a2(p)).report.columns); });
  add("A1Spacing", [](scene::Profile p) {
    const simulate::Plan plan = simulate::make_plan(appendix_a2(p), 0);
    return plan.acquisition.reception.column_range_m[1] - plan.acquisition.reception.column_range_m[0];
  });
  add("A1CountI", [](scene::Profile p) { return counts_a2(p, 1.67572e-6).real(); });
  add("A1CountQ", [](scene::Profile p) { return counts_a2(p, 1.67572e-6).imag(); });
  add("A2CountI", [](scene::Profile p) { return counts_a2(p, 1.72599475e-6).real(); });
  add("A2CountQ", [](scene::Profile p) { return counts_a2(p, 1.72599475e-6).imag(); });
  add("A2Power", [](scene::Profile p) { return std::pow(largest_v(appendix_a2(p)), 2); });
  add("A2Magnitude", [](scene::Profile p) { return 1e3 * largest_v(appendix_a2(p)); });
  add("A2Phase", [](scene::Profile p) { return phase_deg(recorded(appendix_a2(p)).samples); });
  add("A2CompressedGain", compressed_gain_a2);
  add("A2CompressedTurn", compressed_turn_a2_deg);
  add("A3PhaseStep", phase_step_a3_rad);
  add("A3Resolution", resolution_a3_m);
  add("A3FirstPeak", [](scene::Profile p) { return peak_a3_m(p, 296.0, 304.0); });
  add("A3SecondPeak", [](scene::Profile p) { return peak_a3_m(p, 304.0, 312.0); });
  add("A4Power", [](scene::Profile p) { return std::pow(largest_v(appendix_a4(p)), 2); });
  add("A4Magnitude", [](scene::Profile p) { return 1e3 * largest_v(appendix_a4(p)); });
  add("A4Phase", phase_a4_deg);
  add("A4SideLobe", side_lobe_a4_db);
  add("A4Resolution", resolution_a4_m);
}

// What both profiles give, derived from the formulas of docs/theory/echo-model.md; docs/theory/thesis-numbers.md says
// what the thesis prints. Bound by a test to that page.
struct Derivation {
  const char* name;
  const char* what;
  const char* unit;
  double classic;
  double physical;
  double tolerance;
};
constexpr Derivation rows[] = {
    {"Chapter3Power", "Chapter 3: received power, 3 m2 at 3 km", "W", 1.677445e-15, 1.677444e-15, 1e-21},
    {"Chapter3Magnitude", "Chapter 3: amplitude", "mV", 4.09566e-5, 4.09566e-5, 1e-10},
    {"Section44SignalPower", "4.4: received power", "W", 4.529100e-14, 4.529099e-14, 1e-20},
    {"Section44NoisePower", "4.4: noise power N = kTB", "W", 1.38e-15, 1.380649e-15, 1e-21},
    {"Section44NoiseVoltage", "4.4: noise voltage", "V", 3.71484e-8, 3.71571e-8, 1e-13},
    {"Section44Snr", "4.4: signal to noise, power", "", 32.82, 32.80, 0.005},
    {"Section44AmplitudeRatio", "4.4: signal to noise, amplitude", "", 5.729, 5.727, 0.0005},
    {"Section451Samples", "4.5.1: samples of 1 us at 500 MHz", "", 500, 500, 0},
    {"Section451Length", "4.5.1: their length on the range axis", "m", 149.896, 149.896, 0.001},
    {"Section452Lsb", "4.5.2: LSB for a maximum of 6.39369e-5 mV, 8 bits", "mV", 5.0344e-7, 5.0344e-7, 5e-12},
    {"Section452Code", "4.5.2: code written for 1.2e-5 mV", "", 151, 151, 0},
    {"Figure49Samples", "Figure 4.9: samples of 1279 m at 120 MHz", "", 1024, 1024, 0},
    {"Figure49Pulses", "Figure 4.9: pulses of 1.279 s at 400 Hz", "", 512, 512, 0},
    {"Figure75Samples", "Figure 7.5: samples of 500 m at 150 MHz", "", 500, 500, 0},
    {"Figure75Pulses", "Figure 7.5: pulses", "", 600, 600, 0},
    {"A1Samples", "A.1: samples of 2 km", "", 53, 53, 0},
    {"A1Spacing", "A.1: distance of samples", "m", 37.736, 37.474, 0.001},
    {"A1CountI", "A.1: count I at an LSB of 1.67572e-6 mV", "", -25, -25, 0},
    {"A1CountQ", "A.1: count Q", "", -125, -124, 0},
    {"A2CountI", "A.2: count I", "", -24, -25, 0},
    {"A2CountQ", "A.2: count Q", "", -121, -121, 0},
    {"A2Power", "A.2: received power, 1 m2 at 1 km", "W", 4.529100e-14, 4.529099e-14, 1e-20},
    {"A2Magnitude", "A.2: amplitude", "mV", 2.12817e-4, 2.12817e-4, 1e-9},
    {"A2Phase", "A.2: phase", "deg", -101.149, -101.485, 0.0005},
    {"A2CompressedGain", "A.2: compressed peak over raw amplitude", "", 2.5e-6, 1, 1e-9},
    {"A2CompressedTurn", "A.2: turn of the phase by compression", "deg", 0, 0, 1e-6},
    {"A3PhaseStep", "A.3: phase step per pulse", "rad", -1.04792, -1.04792, 1e-5},
    {"A3Resolution", "A.3: range resolution, peak to first zero", "m", 1.505, 1.505, 0.008},
    {"A3FirstPeak", "A.3: first peak", "m", 300, 300, 0.09},
    {"A3SecondPeak", "A.3: second peak", "m", 308, 308, 0.09},
    {"A4Power", "A.4: received power in the beam's middle", "W", 6.37292e-15, 6.37292e-15, 2e-20},
    {"A4Magnitude", "A.4: amplitude in the beam's middle", "mV", 7.98306e-5, 7.98306e-5, 1e-10},
    {"A4Phase", "A.4: phase", "deg", 179.94, 179.39, 0.005},
    {"A4SideLobe", "A.4: first side lobe over slow time", "dB", -13.26, -26.5, 0.1},
    {"A4Resolution", "A.4: resolution of a 5 us pulse", "m", 749.48, 749.48, 3},
};

ThesisNumber completed(ThesisNumber number) {
  const auto* const row = std::ranges::find_if(rows, [&](const Derivation& r) { return number.name == r.name; });
  if (row == std::end(rows)) throw std::logic_error("no value is expected of " + number.name);
  number.what = row->what;
  number.unit = row->unit;
  number.classic = row->classic;
  number.physical = row->physical;
  number.tolerance = row->tolerance;
  return number;
}

}  // namespace

std::vector<ThesisNumber> thesis_numbers() {
  std::vector<ThesisNumber> numbers;
  add_chapters_3_and_4(numbers);
  numbers.push_back(made("Figure75Samples", [](scene::Profile p) {
    return static_cast<double>(figure_7_5(p).acquisition.reception.columns);
  }));
  numbers.push_back(made("Figure75Pulses",
                         [](scene::Profile p) { return static_cast<double>(figure_7_5(p).acquisition.timing.rows); }));
  add_appendix(numbers);
  for (ThesisNumber& number : numbers) number = completed(std::move(number));
  return numbers;
}

}  // namespace sarsim::workflow::verify

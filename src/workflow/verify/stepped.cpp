#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "core/maths/constants.hpp"
#include "signal/measure/image_quality.hpp"
#include "signal/stepped/profile_maker.hpp"
#include "signal/stepped/stepped_isar.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/moments.hpp"
#include "workflow/verify/own_path.hpp"
#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

namespace {

constexpr double first_hz = 9e9;
constexpr double step_hz = 5e6;
constexpr int burst_steps = 32;
constexpr double unambiguous_m = 0.5 * core::exact_light_speed_mps / step_hz;

// Synthetic range profiles that the simulation makes.
void measure_recorded_profile(Record& record) {
  scene::Scene scene = radar_at_origin();
  scene::Radar& radar = scene.radars[0];
  radar.carrier = scene::Radar::Carrier::stepped;
  radar.carrier_hz = first_hz;
  radar.carrier_step_hz = step_hz;
  radar.carrier_steps = burst_steps;
  radar.pulses_per_step = 2;
  radar.pulse_width_s = 0.2e-6;
  // Five bins before the first gate, which is the fifth from the end of its profile.
  constexpr double gate_m = 1015.0;
  constexpr double echo_m = gate_m - 5.0 * unambiguous_m / burst_steps;
  add_target(scene, {echo_m, 0.0, 0.0});
  set_window(scene, gate_m, gate_m + 15.0, 20e6);
  set_pulses(scene, 0, 2 * burst_steps - 1);
  scene.simulations[0].processing = scene::Processing::srp;
  double amplitude_v = 0.0;  // The mean of the radar equation over the carriers.
  for (int n = 0; n < burst_steps; ++n)
    amplitude_v += std::sqrt(1000.0) * core::exact_light_speed_mps / (first_hz + n * step_hz) /
                   (std::pow(4.0 * core::pi, 1.5) * echo_m * echo_m) / burst_steps;
  const auto samples = recorded(scene).samples;
  const std::complex<double> expected = std::polar(
      amplitude_v, -2.0 * core::pi * std::remainder(first_hz * 2.0 * echo_m / core::exact_light_speed_mps, 1.0));
  record.at_most("Recorded range profile: deviation of a target's bin", "", 1e-7,
                 std::abs(samples.at(burst_steps - 5) / expected - 1.0),
                 "the mean of its echoes, at the first carrier");
}

signal::SteppedWaveform waveform(double first_gate_m, std::size_t gates) {
  signal::SteppedWaveform w;
  w.first_carrier_hz = first_hz;
  w.carrier_step_hz = step_hz;
  w.steps = burst_steps;
  w.pulse_width_s = 200e-9;
  w.sample_rate_hz = 10e6;
  w.first_sample_s = 2.0 * first_gate_m / core::exact_light_speed_mps;
  w.samples = gates;
  w.seen_from_s = -100e-9;
  w.seen_to_s = 100e-9;
  w.light_speed_mps = core::exact_light_speed_mps;
  return w;
}

// The echoes of one point of amplitude 1, pulse by pulse 125 us apart about t = 0.
std::vector<std::complex<double>> burst_values(const signal::SteppedBand& band, const Motion& point,
                                               std::size_t bursts) {
  const signal::SteppedWaveform& w = band.waveform();
  std::vector<std::complex<double>> values;
  for (std::size_t p = 0; p < bursts * w.steps; ++p) {
    const double time_s = 125e-6 * (static_cast<double>(p) - 0.5 * static_cast<double>(bursts * w.steps));
    const long double delay_s = two_way_s(at_rest({}), point, time_s);
    const double turns = static_cast<double>(std::remainder(w.carrier_hz(p % w.steps) * delay_s, 1.0L));
    std::vector<std::complex<double>> row(w.samples);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double t = w.first_sample_s + static_cast<double>(i) / w.sample_rate_hz - static_cast<double>(delay_s);
      if (t >= w.seen_from_s && t < w.seen_to_s) row[i] = std::polar(1.0, -2.0 * core::pi * turns);
    }
    std::vector<std::complex<double>> placed(band.values_per_pulse());
    band.place(p % w.steps, row, placed);
    values.insert(values.end(), placed.begin(), placed.end());
  }
  return values;
}

void measure_profile(Record& record) {
  constexpr double range_m = 5003.3;
  const signal::SteppedBand band(waveform(4970.0, 6));
  const signal::ProfileMaker maker(band, {}, 4980.0, 5020.0, 16);
  std::vector<std::complex<double>> profile(maker.axis().count);
  maker.make(burst_values(band, at_rest({range_m, 0.0L, 0.0L}), 1), {}, profile);
  const auto peak = signal::peak_near(profile, maker.axis(), range_m, 2.0);
  record.near("Range profile: range of a target", "m", range_m, peak ? peak->range_m : 0.0, 0.001, "2 R/c");
  record.near("Range profile: amplitude of a target", "", 1.0, peak ? peak->amplitude : 0.0, 1e-3,
              "the mean of its echoes");
  const double middle_hz = first_hz + 0.5 * (burst_steps - 1) * step_hz;
  const double expected_rad =
      -2.0 * core::pi * std::remainder(2.0 * range_m * middle_hz / core::exact_light_speed_mps, 1.0);
  record.near("Range profile: error of the phase", "rad", 0.0,
              peak ? wrapped_rad(peak->phase_rad - expected_rad) : core::pi, 0.01,
              "-4 pi f R/c, f the middle of the band");
  // Half power of Dirichlet's kernel sin(pi S x)/(S sin(pi x)).
  constexpr double cells = burst_steps;
  double half = 0.3 / cells;
  for (int i = 0; i < 50; ++i) {
    const double k = std::sin(core::pi * cells * half) / (cells * std::sin(core::pi * half));
    half += (k - std::sqrt(0.5)) * half;  // The kernel falls by about 1.3/half there.
  }
  record.near("Range profile: half-power width", "m", 2.0 * half * unambiguous_m, peak ? peak->width_m : 0.0,
              0.005 * unambiguous_m / cells, "Dirichlet's kernel");
}

constexpr long double turn_rate_radps = 0.05L;

// The antenna as a target sees it that stands at (0, 5 km, 0) and turns about z.
signal::TrackPoint seen_at(double time_s) {
  const Place antenna{0.0L, -5000.0L, 0.0L};
  const Place z{0.0L, 0.0L, 1.0L};
  const Place there = turned(antenna, z, -turn_rate_radps * time_s);
  const Place moving = -turn_rate_radps * cross_of(z, there);
  const auto vector = [](const Place& p) {
    return core::Vec3{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
  };
  return {time_s, vector(there), vector(moving)};
}

void measure_turning(Record& record) {
  const std::size_t bursts = record.quick() ? 32 : 64;
  const Place fixed{6.0L, 4.0L, 0.0L};
  const signal::SteppedBand band(waveform(4955.0, 7));
  const auto values = burst_values(
      band,
      [&](long double t) {
        return Place{0.0L, 5000.0L, 0.0L} + turned(fixed, {0.0L, 0.0L, 1.0L}, turn_rate_radps * t);
      },
      bursts);
  std::vector<signal::TrackPoint> seen;
  for (std::size_t p = 0; p < bursts * burst_steps; ++p)
    seen.push_back(seen_at(125e-6 * (static_cast<double>(p) - 0.5 * static_cast<double>(bursts * burst_steps))));
  const signal::IsarPlane plane = signal::plane_of(seen);
  const auto motion = signal::motion_of_origin(seen, core::exact_light_speed_mps);
  const signal::ProfileMaker maker(band, {}, plane.range_m - 4.0, plane.range_m + 12.0, 4);
  const signal::IsarEchoes echoes{values, motion, {}};
  const signal::ImageAxis across{-6.0, 0.4, 61};
  const core::WorkControl control{1, record.rules().stop};
  const double cell_m = 0.5 * core::exact_light_speed_mps / first_hz /
                        (static_cast<double>(turn_rate_radps) * 125e-6 * static_cast<double>(seen.size()));
  const auto measure = [&](const std::string& name, const signal::FocusedImage& image) {
    const auto found = signal::measure_point(image, signal::reader_of(image), {6.0, 4.0}, 0.6);
    record.near(name + ": cross-range of a point", "m", 6.0, found ? found->place.azimuth_m : 0.0, 0.02 * cell_m,
                "the point's place on the target");
    record.near(name + ": range of a point", "m", 4.0, found ? found->place.range_m : 0.0, 0.02,
                "the point's place on the target");
    record.near(name + ": amplitude of a point", "", 1.0, found ? found->amplitude : 0.0, 0.02,
                "the mean of its echoes");
  };
  measure("Turning target, range-Doppler", signal::isar_range_doppler(maker, echoes, plane, across, control));
  measure("Turning target, back-projection", signal::isar_back_projection(maker, echoes, seen, plane, across, control));
}

}  // namespace

void measure_stepped(Record& record) {
  for (const auto measure : {measure_recorded_profile, measure_profile, measure_turning}) measure(record);
}

}  // namespace sarsim::workflow::verify

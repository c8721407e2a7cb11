#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "scene/model/scene.hpp"

namespace sarsim::scene::test {

/// Scenes of random content for tests: every alternative of every field, numbers of all sizes and precisions, names
/// that need quotes. Only what a script can say: members off the chosen path keep their initial values.
class RandomScenes {
 public:
  explicit RandomScenes(std::uint64_t seed) : engine_(seed) {}

  Scene scene() {
    Scene scene;
    fill(scene.platforms, [this] { return platform(); });
    fill(scene.surfaces, [this] { return surface(); });
    fill(scene.targets, [this] { return target(); });
    fill(scene.radars, [this] { return radar(); });
    fill(scene.simulations, [this] { return simulation(); });
    fill(scene.geometries, [this] { return geometry(); });
    if (coin()) scene.options.profile = Profile::classic;
    if (coin()) scene.options.seed = engine_();
    if (coin()) scene.options.pulse = PulseDefinition::band_limited;
    if (coin()) scene.options.tolerance = positive();
    return scene;
  }

  /// A number that a scene may hold: zero, a typed-looking decimal, a whole number, or all 64 bits at random.
  double number() {
    switch (below(5)) {
      case 0: return 0.0;
      case 1: return static_cast<double>(below(20001)) - 10000.0;
      case 2: return (static_cast<double>(below(2000001)) - 1e6) / 1000.0;
      case 3: return std::ldexp(uniform() - 0.5, static_cast<int>(below(110)) - 60);
      default: return any_bits();
    }
  }

 private:
  std::uint64_t below(std::uint64_t limit) { return engine_() % limit; }
  bool coin() { return below(2) == 0; }
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double not_negative() { return std::abs(number()); }
  double positive() {
    const double value = not_negative();
    return value > 0.0 ? value : 1e-3;
  }
  double between(double low, double high) { return coin() ? low : low + (high - low) * uniform(); }
  int integer(int low, int high) { return low + static_cast<int>(below(static_cast<std::uint64_t>(high - low + 1))); }

  // Finite, of a magnitude that survives the change of units (GHz to Hz and back).
  double any_bits() {
    const double mantissa = 1.0 + uniform();
    const double value = std::ldexp(mantissa, static_cast<int>(below(1000)) - 950);
    return coin() ? value : -value;
  }

  template <class Enum>
  Enum one_of(std::uint64_t count) {
    return static_cast<Enum>(below(count));
  }

  template <class Object, class Make>
  void fill(std::vector<Object>& objects, Make make) {
    for (std::uint64_t i = below(4); i > 0; --i) objects.push_back(make());
  }

  std::string name() {
    static constexpr std::string_view letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.:;/\\$!\"' ,\t#%()\xC3\xB6\xB0";
    std::string text;
    const std::uint64_t usual = below(4) > 0 ? 52 : letters.size();
    for (std::uint64_t i = 1 + below(20); i > 0; --i) text += letters[below(usual)];
    return text;
  }

  core::Vec3 vector() { return {number(), number(), number()}; }
  core::Vec3 magnitudes() { return {not_negative(), not_negative(), not_negative()}; }
  core::Angle magnitude() { return core::Angle::from_deg(not_negative()); }
  core::Angle angle() { return core::Angle::from_deg(number()); }
  core::PowerRatio gain() { return coin() ? core::PowerRatio{} : core::PowerRatio::from_db(between(0.0, 300.0)); }
  std::array<core::Angle, 3> angles() { return {angle(), angle(), angle()}; }

  core::SampledFunction sampled(bool ascending) {
    core::SampledFunction function;
    function.method = one_of<core::Interpolation>(3);
    double x = std::ldexp(uniform() - 0.5, 10);
    for (std::uint64_t i = below(6); i > 0; --i) {
      function.knots.push_back({ascending ? x : number(), ascending ? number() : positive()});
      x += std::ldexp(1.0 + uniform(), static_cast<int>(below(20)) - 10);
    }
    return function;
  }

  template <std::size_t N>
  UserFunction<N> function(bool ascending = true) {
    UserFunction<N> block;
    for (core::SampledFunction& part : block.part) part = sampled(ascending);
    return block;
  }

  Platform platform() {
    Platform platform;
    platform.name = name();
    platform.path = one_of<Platform::Path>(2);
    if (platform.path == Platform::Path::stationary) {
      platform.position_m = vector();
    } else {
      platform.trajectory_m = function<3>();
      platform.aligned = coin();
    }
    platform.rotation_kind = one_of<Platform::Rotation>(2);
    if (platform.rotation_kind == Platform::Rotation::constant)
      platform.rotation = angles();
    else
      platform.rotation_deg = function<3>();
    platform.rotation_rate = angles();
    platform.position_error = one_of<Platform::MotionError>(2);
    if (platform.position_error == Platform::MotionError::gaussian)
      platform.position_stddev_m = magnitudes();
    else
      platform.position_envelope = function<3>();
    platform.rotation_error = one_of<Platform::MotionError>(2);
    if (platform.rotation_error == Platform::MotionError::gaussian)
      platform.rotation_stddev = {magnitude(), magnitude(), magnitude()};
    else
      platform.rotation_envelope = function<3>();
    return platform;
  }

  Surface surface() {
    Surface surface;
    surface.platform = name();
    for (core::Vec3& corner : surface.corner_m) corner = vector();
    return surface;
  }

  Target target() {
    Target target;
    target.platform = name();
    target.position_m = vector();
    target.position_stddev_m = magnitudes();
    target.rcs_m2 = number();
    target.rcs_stddev_m2 = not_negative();
    target.reflectivity = one_of<Target::Reflectivity>(2);
    if (target.reflectivity == Target::Reflectivity::isotropic) return target;
    target.azimuth = angle();
    target.elevation = angle();
    target.azimuth_stddev = magnitude();
    target.elevation_stddev = magnitude();
    target.gain = one_of<Target::Gain>(2);
    if (target.gain == Target::Gain::user) target.gain_db = function<1>();
    return target;
  }

  Antenna antenna() {
    Antenna antenna;
    antenna.pattern = one_of<Antenna::Pattern>(3);
    if (antenna.pattern == Antenna::Pattern::sinx) {
      antenna.elevation_beamwidth = angle();
      antenna.azimuth_beamwidth = angle();
    } else if (antenna.pattern == Antenna::Pattern::user) {
      antenna.gain_db = function<2>();
    }
    return antenna;
  }

  Radar radar() {
    Radar radar;
    radar.name = name();
    radar.platform = name();
    fill_pulse(radar);
    fill_schedule(radar);
    radar.power_w = not_negative();
    radar.transmit_gain = gain();
    radar.receive_gain = gain();
    radar.losses = gain();
    radar.noise_temperature_k = not_negative();
    radar.transmit_antenna = antenna();
    radar.same_antenna = coin();
    if (!radar.same_antenna) radar.receive_antenna = antenna();
    fill_beam(radar);
    radar.window = one_of<Radar::Window>(5);
    if (radar.window == Radar::Window::hanning) radar.hanning_pedestal = between(0.0, 1.0);
    if (radar.window == Radar::Window::user) radar.window_gain = function<1>();
    radar.stc = one_of<Radar::Stc>(3);
    if (radar.stc == Radar::Stc::user) radar.stc_gain = function<1>();
    return radar;
  }

  void fill_pulse(Radar& radar) {
    radar.pulse = one_of<Radar::Pulse>(4);
    if (radar.pulse == Radar::Pulse::chirp) radar.bandwidth_hz = number();
    if (radar.pulse == Radar::Pulse::user) radar.pulse_iq = function<2>();
    if (radar.pulse == Radar::Pulse::barker) radar.barker_code = integer(0, 6);
    radar.pulse_width_s = not_negative();
    radar.envelope = one_of<Radar::Envelope>(3);
    if (radar.envelope == Radar::Envelope::linear) {
      radar.rise_s = not_negative();
      radar.fall_s = not_negative();
    }
    if (radar.envelope == Radar::Envelope::user) radar.envelope_gain = function<1>();
  }

  void fill_schedule(Radar& radar) {
    radar.repetition = one_of<Radar::Repetition>(2);
    if (radar.repetition == Radar::Repetition::constant)
      radar.prf_hz = 1e-5 + not_negative();
    else
      radar.pri_s = function<1>(false);
    radar.carrier = one_of<Radar::Carrier>(3);
    if (radar.carrier == Radar::Carrier::user)
      radar.carrier_list_hz = function<1>(false);
    else
      radar.carrier_hz = not_negative();
    if (radar.carrier != Radar::Carrier::stepped) return;
    radar.carrier_step_hz = not_negative();
    radar.carrier_steps = integer(1, 1000);
    radar.pulses_per_step = integer(1, 100);
  }

  void fill_beam(Radar& radar) {
    radar.beam = one_of<Radar::Beam>(4);
    if (radar.beam == Radar::Beam::fixed || radar.beam == Radar::Beam::rotating) radar.beam_elevation = angle();
    if (radar.beam == Radar::Beam::fixed) radar.beam_azimuth = angle();
    if (radar.beam == Radar::Beam::rotating) radar.beam_rate = core::Angle::from_deg(not_negative());
    if (radar.beam == Radar::Beam::spot) radar.spot_world_m = vector();
    if (radar.beam == Radar::Beam::user) radar.beam_target_world_m = function<3>();
  }

  Simulation simulation() {
    Simulation simulation;
    simulation.radar = name();
    simulation.range_start_m = number();
    simulation.range_end_m = number();
    simulation.time_start_s = number();
    simulation.time_end_s = number();
    simulation.bits = integer(1, 64);
    simulation.sample_rate_hz = positive();
    simulation.lsb_v = number();
    simulation.format = one_of<FileFormat>(6);
    simulation.processing = one_of<Processing>(3);
    simulation.file = name();
    simulation.pulse_position = one_of<Simulation::PulsePosition>(2);
    simulation.oversampling = between(1.0, 100.0);
    simulation.width_factor = between(1.0, 100.0);
    return simulation;
  }

  GeometryTable geometry() {
    GeometryTable table;
    table.radar = name();
    table.range_start_m = number();
    table.range_end_m = number();
    table.time_start_s = number();
    table.time_end_s = number();
    table.separator = one_of<GeometryTable::Separator>(2);
    table.columns = integer(0, 255);
    table.file = name();
    return table;
  }

  std::mt19937_64 engine_;
};

}  // namespace sarsim::scene::test

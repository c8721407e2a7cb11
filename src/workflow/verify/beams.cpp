#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "core/maths/constants.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/own_path.hpp"
#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

namespace {

constexpr double width_deg = 10.0;
constexpr core::Vec3 seen_m{300.0, 950.0, 90.0};

double deg(long double rad) { return static_cast<double>(rad) * core::deg_per_rad; }

// Offsets in azimuth and elevation [deg] of a direction from a beam, both in the frame the beam's angles belong to.
struct Offsets {
  double azimuth_deg = 0.0;
  double elevation_deg = 0.0;
};

Offsets offsets_of(const Place& beam, const Place& look) {
  const Place along = (1.0L / length_of(beam)) * beam;
  const Place right = cross_of(along, {0.0L, 0.0L, 1.0L});
  const Place level = (1.0L / length_of(right)) * right;
  const Place up = cross_of(level, along);
  return {deg(std::atan2(dot_of(look, level), dot_of(look, along))),
          deg(std::asin(dot_of(look, up) / length_of(look)))};
}

// One way, sin(x)/x in both cuts.
double sinx_loss_db(const Offsets& o) {
  const auto cut = [](double offset_deg) {
    const double x = 0.88 * core::pi * std::sin(offset_deg / core::deg_per_rad) / (width_deg / core::deg_per_rad);
    return std::sin(x) / x;
  };
  return 20.0 * std::log10(std::abs(cut(o.azimuth_deg) * cut(o.elevation_deg)));
}

scene::Scene beam_scene(bool user) {
  scene::Scene scene = radar_at_origin();
  using Pattern = scene::Antenna::Pattern;
  scene::Antenna& antenna = scene.radars[0].transmit_antenna;
  antenna.pattern = user ? Pattern::user : Pattern::sinx;
  antenna.azimuth_beamwidth = core::Angle::from_deg(width_deg);
  antenna.elevation_beamwidth = core::Angle::from_deg(width_deg);
  using core::Interpolation;
  antenna.gain_db.part = {core::SampledFunction{Interpolation::linear, {{0.0, 0.0}, {180.0, -90.0}}},
                          core::SampledFunction{Interpolation::linear, {{0.0, -1.0}, {180.0, -46.0}}}};
  add_target(scene, seen_m);
  const double range_m = core::norm(seen_m);
  set_window(scene, range_m + 200.0, range_m + 300.0, 4e6);
  return scene;
}

// Amplitude of the first sample of the last pulse over that of isotropic antennas, in dB.
double two_way_db(const scene::Scene& scene) {
  scene::Scene plain = scene;
  plain.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::isotropic;
  return 20.0 * std::log10(std::abs(column(recorded(scene), 0).back()) / std::abs(column(recorded(plain), 0).back()));
}

Place towards(double azimuth_deg, double elevation_deg) {
  const long double az = azimuth_deg / core::deg_per_rad;
  const long double el = elevation_deg / core::deg_per_rad;
  return {std::sin(az) * std::cos(el), std::cos(az) * std::cos(el), std::sin(el)};
}

// Cuts that are not the same on both sides: elevation counts upwards, azimuth to the right of the beam, and beyond the
// last point its gain is held.
void measure_uneven_cuts(Record& record) {
  scene::Scene scene = beam_scene(true);
  auto& cuts = scene.radars[0].transmit_antenna.gain_db.part;
  cuts[0] = {core::Interpolation::linear, {{-40.0, -12.0}, {0.0, 0.0}, {40.0, -4.0}}};
  cuts[1] = {core::Interpolation::linear, {{-20.0, -30.0}, {0.0, 0.0}, {10.0, -6.0}}};
  const auto expect = [&](const std::string& what, double azimuth_deg, double elevation_deg, const auto& gain_db) {
    scene.radars[0].beam_azimuth = core::Angle::from_deg(azimuth_deg);
    scene.radars[0].beam_elevation = core::Angle::from_deg(elevation_deg);
    const Offsets o = offsets_of(towards(azimuth_deg, elevation_deg), place(seen_m));
    record.near("Two-way gain of uneven cuts, the target " + what, "dB", 2.0 * gain_db(o.azimuth_deg, o.elevation_deg),
                two_way_db(scene), 1e-9, "the points' straight lines");
  };
  expect("below and to the right", 15.0, 9.0, [](double az, double el) { return -0.1 * az + 1.5 * el; });
  expect("above and to the left", 30.0, -3.0, [](double az, double el) { return 0.3 * az - 0.6 * el; });
  expect("beyond all points", 70.0, -45.0, [](double, double) { return -12.0 - 6.0; });
}

void measure_beams(Record& record) {
  constexpr const char* source = "docs/theory/frames.md, antenna frame";
  scene::Scene spot = beam_scene(false);
  spot.radars[0].beam = scene::Radar::Beam::spot;
  spot.radars[0].spot_world_m = {370.0, 930.0, 50.0};
  record.near("Two-way gain of a beam held on a point", "dB",
              2.0 * sinx_loss_db(offsets_of(place(spot.radars[0].spot_world_m), place(seen_m))), two_way_db(spot), 1e-9,
              source);
  scene::Scene turning = beam_scene(false);
  turning.radars[0].beam = scene::Radar::Beam::rotating;
  turning.radars[0].beam_rate = core::Angle::from_deg(300.0);
  turning.radars[0].beam_elevation = core::Angle::from_deg(4.0);
  turning.radars[0].prf_hz = 20.0;
  set_pulses(turning, 0, 1);
  record.near("Two-way gain of a beam that turns by 300 deg/s, after 50 ms", "dB",
              2.0 * sinx_loss_db(offsets_of(towards(15.0, 4.0), place(seen_m))), two_way_db(turning), 1e-9, source);
  scene::Scene banked = beam_scene(false);
  add_platform(banked, "Plane", {}).rotation = {core::Angle::from_deg(12.0), core::Angle::from_deg(0.0),
                                                core::Angle::from_deg(25.0)};
  banked.radars[0].platform = "Plane";
  banked.radars[0].beam_azimuth = core::Angle::from_deg(-9.0);
  banked.radars[0].beam_elevation = core::Angle::from_deg(15.0);
  // What the platform sees: yaw and roll undone, the last first.
  const long double yaw_rad = 25.0 / core::deg_per_rad;
  const long double roll_rad = 12.0 / core::deg_per_rad;
  const Place carried = turned(turned(place(seen_m), {0.0L, 0.0L, 1.0L}, yaw_rad), {1.0L, 0.0L, 0.0L}, roll_rad);
  record.near("Two-way gain of a beam of a platform that rolls and yaws", "dB",
              2.0 * sinx_loss_db(offsets_of(towards(-9.0, 15.0), carried)), two_way_db(banked), 1e-9, source);
  scene::Scene user = beam_scene(true);
  user.radars[0].beam_azimuth = core::Angle::from_deg(30.0);
  user.radars[0].beam_elevation = core::Angle::from_deg(-3.0);
  const Offsets o = offsets_of(towards(30.0, -3.0), place(seen_m));
  record.near("Two-way gain of an antenna given by points", "dB",
              2.0 * (-0.5 * std::abs(o.azimuth_deg) - 1.0 - 0.25 * std::abs(o.elevation_deg)), two_way_db(user), 1e-9,
              "the points' straight lines");
  measure_uneven_cuts(record);
}

void measure_reflectivity(Record& record) {
  scene::Scene scene = beam_scene(false);
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::isotropic;
  const double plain_v = std::abs(recorded(scene).samples.front());
  scene::Target& target = scene.targets[0];
  scene::TargetTraits& traits = target.traits.edit();
  traits.reflectivity = scene::Target::Reflectivity::directional;
  traits.azimuth = core::Angle::from_deg(170.0);
  traits.elevation = core::Angle::from_deg(20.0);
  const Place normal = towards(170.0, 20.0);
  const double cosine = static_cast<double>(-dot_of(normal, place(seen_m)) / length_of(place(seen_m)));
  record.near("Cross-section of a plane target over its greatest", "", cosine,
              std::norm(recorded(scene).samples.front() / plain_v), 1e-12, "cosine of the incidence angle");
  traits.gain = scene::Target::Gain::user;
  traits.gain_db.part[0] = {core::Interpolation::linear, {{0.0, 3.0}, {90.0, -27.0}}};
  record.near("Cross-section of a target given by points", "dB", 3.0 - deg(std::acos(cosine)) / 3.0,
              20.0 * std::log10(std::abs(recorded(scene).samples.front()) / plain_v), 1e-9,
              "the points' straight line at the incidence angle");
}

void measure_stc(Record& record) {
  scene::Scene scene = beam_scene(false);
  scene.radars[0].noise_temperature_k = 290.0;
  const auto plain = recorded(scene).samples;
  const double spacing_m = 0.5 * core::exact_light_speed_mps / scene.simulations[0].sample_rate_hz;
  // The largest deviation of the ratio of samples with and without the gain.
  const auto deviation = [&](double (*gain)(double)) {
    const auto found = recorded(scene).samples;
    double worst = found.size() == plain.size() && !found.empty() ? 0.0 : 1.0;
    for (std::size_t i = 0; i < std::min(found.size(), plain.size()); ++i) {
      const double range_m = scene.simulations[0].range_start_m + static_cast<double>(i) * spacing_m;
      worst = std::max(worst, std::abs(found[i] / plain[i] / gain(range_m) - 1.0));
    }
    return worst;
  };
  scene.radars[0].stc = scene::Radar::Stc::range_law;
  record.at_most("STC: deviation from the square of the sample's range", "", 1e-12,
                 deviation([](double range_m) { return range_m * range_m; }), "on echo and noise");
  scene.radars[0].stc = scene::Radar::Stc::user;
  scene.radars[0].stc_gain.part[0] = {core::Interpolation::linear, {{0.0, 1.0}, {2000.0, 5.0}}};
  record.at_most("STC by points: deviation from their straight line", "", 1e-12,
                 deviation([](double range_m) { return 1.0 + range_m / 500.0; }), "on echo and noise");
}

}  // namespace

void measure_beams_and_targets(Record& record) {
  for (const auto measure : {measure_beams, measure_reflectivity, measure_stc}) measure(record);
}

}  // namespace sarsim::workflow::verify

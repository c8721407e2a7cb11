#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/maths/constants.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/own_path.hpp"
#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

namespace {

constexpr double path_carrier_hz = 1e9;
constexpr double middle_to_edge_s = 2.5e-6;  // Half of the pulse of `radar_at_origin`.

// The largest error of the phase of the only target's echo, in degrees: all pulses, the first sample.
double worst_phase_deg(const scene::Scene& scene, const Motion& point) {
  const simulate::Recording recording = recorded(scene);
  const double row_s = 2.0 * scene.simulations[0].range_start_m / core::exact_light_speed_mps;
  double worst_rad = 0.0;
  for (std::size_t row = 0; row < recording.report.rows; ++row) {
    const double middle_s = scene.simulations[0].time_start_s + static_cast<double>(row) / scene.radars[0].prf_hz;
    const std::complex<double> expected =
        echo_received(at_rest({}), point, middle_s, row_s - middle_to_edge_s, path_carrier_hz);
    const std::complex<double> found = recording.samples[row * recording.report.columns];
    worst_rad = std::max(worst_rad, found == 0.0 ? core::pi : std::abs(std::arg(found * std::conj(expected))));
  }
  return core::deg_per_rad * worst_rad;
}

// A radar at the origin that records eleven pulses, 50 ms apart, of what is about `range_m` away.
scene::Scene watched(double range_m) {
  scene::Scene scene = radar_at_origin();
  scene.radars[0].prf_hz = 20.0;
  set_window(scene, range_m + 200.0, range_m + 300.0, 4e6);
  set_pulses(scene, -5, 5);
  return scene;
}

const Place x_axis{1.0L, 0.0L, 0.0L};
const Place y_axis{0.0L, 1.0L, 0.0L};
const Place z_axis{0.0L, 0.0L, 1.0L};
constexpr core::Vec3 ship_m{600.0, 500.0, 600.0};
constexpr core::Vec3 mast_m{7.0, -11.0, 5.0};
constexpr double ship_range_m = 984.0;

// Rolled, pitched and yawed one after the other, each the other way than right-handed.
Place posed(const Place& v, const std::array<long double, 3>& angles_deg) {
  const auto rad = [&](std::size_t axis) { return -angles_deg[axis] / 180.0L * core::pi; };
  return turned(turned(turned(v, x_axis, rad(0)), y_axis, rad(1)), z_axis, rad(2));
}

void measure_frames(Record& record) {
  scene::Scene scene = watched(ship_range_m);
  scene::Platform& ship = add_platform(scene, "Ship", ship_m);
  ship.rotation = {core::Angle::from_deg(10.0), core::Angle::from_deg(20.0), core::Angle::from_deg(30.0)};
  add_target(scene, mast_m, 1.0, "Ship");
  record.at_most("Point of a platform turned by (10, 20, 30) deg: error of the phase", "deg", 1e-5,
                 worst_phase_deg(scene, at_rest(place(ship_m) + posed(place(mast_m), {10.0L, 20.0L, 30.0L}))),
                 "docs/theory/frames.md, by Rodrigues' formula");

  const auto turning = [](long double t) {
    return place(ship_m) + posed(place(mast_m), {10.0L + 3.0L * t, 20.0L - 7.0L * t, 30.0L + 12.0L * t});
  };
  scene.platforms.back().rotation_rate = {core::Angle::from_deg(3.0), core::Angle::from_deg(-7.0),
                                          core::Angle::from_deg(12.0)};
  record.at_most("Point of a platform that turns: error of the phase", "deg", 1e-5, worst_phase_deg(scene, turning),
                 "the same at its own time");
  using core::Interpolation;
  scene.platforms.back().rotation_kind = scene::Platform::Rotation::user;
  scene.platforms.back().rotation_rate = {};
  scene.platforms.back().rotation_deg.part = {
      core::SampledFunction{Interpolation::linear, {{-1.0, 7.0}, {1.0, 13.0}}},
      core::SampledFunction{Interpolation::linear, {{-1.0, 27.0}, {1.0, 13.0}}},
      core::SampledFunction{Interpolation::linear, {{-1.0, 18.0}, {1.0, 42.0}}}};
  record.at_most("Point of a platform turned by points: error of the phase", "deg", 1e-5,
                 worst_phase_deg(scene, turning), "the same angles");
}

void measure_alignment(Record& record) {
  const core::Vec3 velocity_mps{12.0, 16.0, 5.0};
  scene::Scene scene = watched(ship_range_m);
  add_mover(scene, "Ship", ship_m, velocity_mps).aligned = true;
  add_target(scene, mast_m, 1.0, "Ship");
  const Place forward = (1.0L / length_of(place(velocity_mps))) * place(velocity_mps);
  const Place level = cross_of(z_axis, forward);
  const Place left = (1.0L / length_of(level)) * level;
  const Place mast = static_cast<long double>(mast_m.x) * forward + static_cast<long double>(mast_m.y) * left +
                     static_cast<long double>(mast_m.z) * cross_of(forward, left);
  record.at_most("Point of a platform aligned with its path: error of the phase", "deg", 1e-5,
                 worst_phase_deg(scene, straight_motion(place(ship_m) + mast, place(velocity_mps))),
                 "x along the path, y level");
}

// A platform whose x goes by points; y and z stay.
void measure_path(Record& record, const std::string& name, const core::SampledFunction& x, const Motion& expected,
                  const std::string& source) {
  scene::Scene scene = watched(1000.0);
  add_mover(scene, "Car", {1000.0, 10.0, 0.0}, {}).trajectory_m.part[0] = x;
  add_target(scene, {}, 1.0, "Car");
  record.at_most("Path by " + name + " points: error of the phase", "deg", 1e-5, worst_phase_deg(scene, expected),
                 source);
}

// The clamped spline through three points: the slope in the middle is the mean of the chords, weighted by 1/width.
long double three_point_spline(long double t) {
  constexpr std::array<long double, 3> at{-0.3L, -0.1L, 0.3L};
  constexpr std::array<long double, 3> value{1000.0L, 1003.0L, 996.0L};
  const std::array<long double, 2> width{at[1] - at[0], at[2] - at[1]};
  const std::array<long double, 2> chord{(value[1] - value[0]) / width[0], (value[2] - value[1]) / width[1]};
  const long double bent = (chord[0] / width[0] + chord[1] / width[1]) / (1.0L / width[0] + 1.0L / width[1]);
  const std::size_t piece = t < at[1] ? 0 : 1;
  const long double begin = piece == 0 ? chord[0] : bent;
  const long double end = piece == 0 ? bent : chord[1];
  const long double s = (t - at[piece]) / width[piece];
  return (1.0L - s) * value[piece] + s * value[piece + 1] +
         s * (1.0L - s) * width[piece] * ((begin - chord[piece]) * (1.0L - s) + (chord[piece] - end) * s);
}

constexpr std::array<double, 5> low_pass_points{1000.0, 1002.0, 1001.0, 998.5, 1000.5};

// Tapered sinc over points 0.2 s apart from -0.4 s on, the ends held.
long double low_pass_path(long double t) {
  const long double u = (t + 0.4L) / 0.2L;
  long double sum = 0.0L;
  long double weights = 0.0L;
  for (int k = -12; k <= 16; ++k) {
    const long double z = u - k;
    if (std::abs(z) >= 11.0L) continue;
    const long double turn = core::pi * z;
    const long double weight = (z == 0.0L ? 1.0L : std::sin(turn) / turn) * 0.5L * (1.0L + std::cos(turn / 11.0L));
    sum += weight * low_pass_points.at(static_cast<std::size_t>(std::clamp(k, 0, 4)));
    weights += weight;
  }
  return sum / weights;
}

void measure_paths(Record& record) {
  using core::Interpolation;
  const auto along_x = [](long double (*x)(long double)) {
    return [x](long double t) { return Place{x(t), 10.0L, 0.0L}; };
  };
  const auto bent = [](long double t) { return 1000.0L + (t < 0.03L ? 20.0L * (t - 0.03L) : -50.0L * (t - 0.03L)); };
  measure_path(record, "LINEAR", {Interpolation::linear, {{-0.97, 980.0}, {0.03, 1000.0}, {1.03, 950.0}}},
               along_x(bent), "straight lines");
  measure_path(record, "CUBIC", {Interpolation::cubic, {{-0.3, 1000.0}, {-0.1, 1003.0}, {0.3, 996.0}}},
               along_x(three_point_spline), "clamped spline of three points in closed form");
  core::SampledFunction low_pass{Interpolation::low_pass, {}};
  for (std::size_t k = 0; k < low_pass_points.size(); ++k)
    low_pass.knots.push_back({-0.4 + 0.2 * static_cast<double>(k), low_pass_points.at(k)});
  measure_path(record, "MFILTER", low_pass, along_x(low_pass_path), "tapered sinc, docs/theory/echo-model.md");
}

}  // namespace

void measure_geometry(Record& record) {
  for (const auto measure : {measure_frames, measure_alignment, measure_paths}) measure(record);
}

}  // namespace sarsim::workflow::verify

#include "scene/model/orbit.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/schema/fields_motion.hpp"

namespace sarsim::scene {

namespace {

using MotionError = Platform::MotionError;

void add_position(FieldTable<Platform>& table) {
  table.group("Position");
  table.add<&Platform::path>(
      {.id = "path",
       .key = "path",
       .other_types = {"line"},
       .label = "Position",
       .words = "kind of path",
       .choices = {{"STATIONARY", Platform::Path::stationary, "Stationary", "the platform stays where it is"},
                   {"TRAJECTORY", Platform::Path::trajectory, "Trajectory", "the platform follows a path", "points"},
                   {"", Platform::Path::ephemeris, "Orbit file", "states from a file", "ephemeris"},
                   {"", Platform::Path::orbit, "Orbit", "an ellipse round the Earth, turned by J2", "orbit"},
                   {"", Platform::Path::state, "Orbit by state",
                    "from a position and a velocity, under gravity with J2", "state"},
                   {"", Platform::Path::legs, "Legs", "straight pieces, turns and climbs", "legs"},
                   {"", Platform::Path::waypoints, "Waypoints", "a route through points", "waypoints"},
                   {"", Platform::Path::relative, "Relative", "beside another platform", "relative"}},
       .tip = "Whether the platform stays where it is or follows a path."});
  table.when<&Platform::path>(Platform::Path::stationary);
  table.add<&Platform::position_m>({.id = "position_m",
                                    .key = "position",
                                    .label = "coordinate",
                                    .words = "position",
                                    .quantity = Quantity::length,
                                    .on_earth = true,
                                    .tip = "Position of the platform's origin in world coordinates."});
  table.when<&Platform::path>(Platform::Path::trajectory);
  table.add<&Platform::trajectory_m>({.id = "trajectory_m",
                                      .key = "path",
                                      .label = "Trajectory",
                                      .words = "trajectory",
                                      .block = &function_blocks::trajectory,
                                      .tip = "World x, y and z against time. Speeds are its derivative."});
  add_paths(table);
}

void add_rotation(FieldTable<Platform>& table) {
  table.group("Rotation");
  table.add<&Platform::rotation_kind>(
      {.id = "rotation_kind",
       .key = "rotation",
       .label = "Rotation",
       .words = "kind of rotation",
       .choices = {{"CONST", Platform::Rotation::constant, "Fixed", "rotation given by angles and rates", "fixed"},
                   {"OTHER", Platform::Rotation::user, "User-defined", "rotation given by functions of time", "points"},
                   {"", Platform::Rotation::coordinated, "Coordinated", "along the path, banked in turns",
                    "coordinated"},
                   {"", Platform::Rotation::zero_doppler, "Zero Doppler",
                    "x axis along the velocity over the turning Earth, z up as far as that allows", "zero-doppler"},
                   {"", Platform::Rotation::nadir, "Nadir", "z axis away from the Earth's centre", "nadir"},
                   {"", Platform::Rotation::look_at, "Look at", "z axis away from a point", "look-at"},
                   {"", Platform::Rotation::quaternions, "Quaternions", "attitude from a file", "quaternions"}},
       .tip = "Whether the rotation is given by angles or by functions of time. A rate is added to either."});
  using Law = Platform::Rotation;
  table.when<&Platform::rotation_kind>(Law::constant, Law::coordinated, Law::zero_doppler, Law::nadir, Law::look_at,
                                       Law::quaternions);
  table.add<&Platform::rotation>(
      {.id = "rotation",
       .key = "rotation.angles",
       .label = "rotation",
       .words = "rotation about",
       .noun = "rotation",
       .quantity = Quantity::angle,
       .tip = "Rotation about each axis, clockwise seen against it, from its tip: positive z turns +x towards -y; roll "
              "about x first, then y, then z. Added to the roll, pitch and yaw of coordinated flight; with the other "
              "kinds it is added to their rotation."});
  table.when<&Platform::rotation_kind>(Platform::Rotation::user);
  table.add<&Platform::rotation_deg>({.id = "rotation_deg",
                                      .key = "rotation",
                                      .label = "Rotation against time",
                                      .words = "rotation",
                                      .block = &function_blocks::rotation,
                                      .tip = "Rotation about x, y and z in degrees against time."});
  add_attitude_laws(table);
  using Way = Platform::Path;
  table.when<&Platform::path>(Way::trajectory, Way::ephemeris, Way::orbit, Way::state, Way::legs, Way::waypoints,
                              Way::relative);
  table.add<&Platform::aligned>(
      {.id = "aligned",
       .key = "path.aligned",
       .label = "Align X-axis to path",
       .words = "alignment with the path",
       .choices = {{"NOT_ALIGNED", false, "no", "keeps its own attitude"},
                   {"ALIGNED", true, "yes", "x axis along the velocity"}},
       .tip = "Turns the platform so that its x axis points along the velocity; the y axis stays parallel to the "
              "world's x-y plane."});
  table.always();
  table.add<&Platform::rotation_rate>({.id = "rotation_rate",
                                       .key = "rotation_rate",
                                       .label = "rotation rate",
                                       .words = "rotation rate about",
                                       .noun = "rotation rate",
                                       .quantity = Quantity::angle_rate,
                                       .tip = "Added to the rotation as rate times time."});
}

void add_position_errors(FieldTable<Platform>& table) {
  table.group("Motion errors");
  table.add<&Platform::position_error>(
      {.id = "position_error",
       .key = "position_error",
       .label = "Position errors",
       .words = "kind of position errors",
       .choices = {{"STDDEV", MotionError::gaussian, "Standard deviation", "position errors drawn anew for each pulse",
                    "gaussian"},
                   {"OTHER", MotionError::envelope, "User-defined", "position errors of a given correlation",
                    "envelope"},
                   {"", MotionError::gusts, "Gusts", "an aircraft in turbulence", "gusts"}},
       .tip = "Gaussian errors drawn anew for each pulse, or noise smoothed by an envelope.",
       .rare = true});
  table.when<&Platform::position_error>(MotionError::gaussian);
  table.add<&Platform::position_stddev_m>(
      {.id = "position_stddev_m",
       .key = "position_error.deviation",
       .label = "position std. deviation",
       .words = "standard deviation of position",
       .noun = "standard deviation of the position",
       .quantity = Quantity::length,
       .range = zero_or_more,
       .tip = "Standard deviation of the Gaussian error of each pulse's position; 0 for none.",
       .rare = true});
  table.when<&Platform::position_error>(MotionError::envelope);
  table.add<&Platform::position_envelope>(
      {.id = "position_envelope",
       .key = "position_error",
       .label = "Position error envelope",
       .words = "envelope of the position errors",
       .block = &function_blocks::position_envelope,
       .tip = "White noise is integrated with this weight against the time before now. No points: no error.",
       .rare = true});
}

void add_parent(FieldTable<Platform>& table) {
  table.add<&Platform::parent>({.id = "parent",
                                .key = "parent",
                                .label = "Parent",
                                .words = "parent",
                                .refers = "platform",
                                .example = "\"Earth\"",
                                .optional = true,
                                .since_2 = true,
                                .tip = "The platform on which this one is mounted: path, rotation and errors are then "
                                       "in its frame, as of a rotor on a fuselage.",
                                .rare = true});
}

void add_rotation_errors(FieldTable<Platform>& table) {
  table.always();
  table.add<&Platform::rotation_error>(
      {.id = "rotation_error",
       .key = "rotation_error",
       .label = "Rotation errors",
       .words = "kind of rotation errors",
       .choices = {{"STDDEV", MotionError::gaussian, "Standard deviation", "rotation errors drawn anew for each pulse",
                    "gaussian"},
                   {"OTHER", MotionError::envelope, "User-defined", "rotation errors of a given correlation",
                    "envelope"}},
       .tip = "Gaussian errors drawn anew for each pulse, or noise smoothed by an envelope.",
       .rare = true});
  table.when<&Platform::rotation_error>(MotionError::gaussian);
  table.add<&Platform::rotation_stddev>(
      {.id = "rotation_stddev",
       .key = "rotation_error.deviation",
       .label = "rotation std. deviation",
       .words = "standard deviation of the rotation about",
       .noun = "standard deviation of the rotation",
       .quantity = Quantity::angle,
       .range = zero_or_more,
       .tip = "Standard deviation of the Gaussian error of each pulse's rotation; 0 for none.",
       .rare = true});
  table.when<&Platform::rotation_error>(MotionError::envelope);
  table.add<&Platform::rotation_envelope>(
      {.id = "rotation_envelope",
       .key = "rotation_error",
       .label = "Rotation error envelope",
       .words = "envelope of the rotation errors",
       .block = &function_blocks::rotation_envelope,
       .tip = "White noise is integrated with this weight against the time before now. No points: no error.",
       .rare = true});
}

double first_value(const core::SampledFunction& function) {
  return function.knots.empty() ? 0.0 : function.knots.front().y;
}

// A route to begin with: 1 km to the north, at the speed of something slow.
constexpr double first_length_m = 1000.0;
constexpr double first_speed_mps = 10.0;

void begin_route(Platform& platform) {
  if (platform.speed_mps == 0.0) platform.speed_mps = first_speed_mps;
}

// The platform stays where it was, and as it was turned, at the beginning of what is now given otherwise.
void begin_platform(const Platform& before, Platform& after) {
  if (after.path == Platform::Path::trajectory) {
    begin_constant(after.trajectory_m.part[0], before.position_m.x);
    begin_constant(after.trajectory_m.part[1], before.position_m.y);
    begin_constant(after.trajectory_m.part[2], before.position_m.z);
  } else if (after.path == Platform::Path::legs) {
    after.start_m = before.position_m;
    begin_route(after);
    if (after.legs.empty()) after.legs.emplace_back().length_m = first_length_m;
  } else if (after.path == Platform::Path::waypoints) {
    begin_route(after);
    if (after.waypoints.empty())
      after.waypoints = {{before.position_m}, {before.position_m + core::Vec3{0.0, first_length_m, 0.0}}};
  } else if (before.path == Platform::Path::trajectory) {
    const auto& path = before.trajectory_m.part;
    after.position_m = {first_value(path[0]), first_value(path[1]), first_value(path[2])};
  }
  continue_orbit(before, after);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (after.rotation_kind == Platform::Rotation::user)
      begin_constant(after.rotation_deg.part[axis], before.rotation[axis].deg());
    else if (before.rotation_kind == Platform::Rotation::user)
      after.rotation[axis] = core::Angle::from_deg(first_value(before.rotation_deg.part[axis]));
  }
}

}  // namespace

template <>
const FieldTable<Platform>& table_of<Platform>() {
  static const FieldTable<Platform> made = [] {
    FieldTable<Platform> table;
    table.group("Platform");
    table.add<&Platform::name>({.id = "name",
                                .key = "name",
                                .label = "Platform name",
                                .words = "name of the platform",
                                .tip = "Targets, surfaces and radars refer to the platform by this name."});
    add_parent(table);
    add_position(table);
    add_rotation(table);
    add_position_errors(table);
    add_gusts(table);
    add_rotation_errors(table);
    add_perturbations(table);
    return table.on_switch(begin_platform);
  }();
  return made;
}

}  // namespace sarsim::scene

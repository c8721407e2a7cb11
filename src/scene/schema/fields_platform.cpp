#include "scene/schema/field_table.hpp"
#include "scene/schema/scene_grammar.hpp"

namespace sarsim::scene::field_tables {

namespace {

bool stationary(const Platform& p) { return p.path == Platform::Path::stationary; }
bool moving(const Platform& p) { return p.path == Platform::Path::trajectory; }

void add_position(FieldTable<Platform>& table) {
  table.group("Position");
  table.choice("path", "Position", &Platform::path, {"Stationary", "Trajectory"},
               "Whether the platform stays where it is or follows a path.");
  table.where(stationary);
  table.vector(script::platform_grammar::position, "coordinate", Quantity::length, &Platform::position_m,
               "Place of the platform's origin in world coordinates.");
  table.where(moving);
  table.function("trajectory_m", "Trajectory", &Platform::trajectory_m,
                 "World x, y and z against time. Speeds are its derivative.");
}

void add_rotation(FieldTable<Platform>& table) {
  table.always().group("Rotation");
  table.choice("rotation_kind", "Rotation", &Platform::rotation_kind, {"Fixed", "User-defined"},
               "Whether the rotation is given by angles or by functions of time. A rate is added to either.");
  table.where([](const Platform& p) { return p.rotation_kind == Platform::Rotation::constant; });
  table.vector(script::platform_grammar::rotation, "rotation", Quantity::angle, &Platform::rotation,
               "Rotation about the axis, clockwise seen along it; roll about x first, then y, then z.");
  table.where([](const Platform& p) { return p.rotation_kind == Platform::Rotation::user; });
  table.function("rotation_deg", "Rotation against time", &Platform::rotation_deg,
                 "Rotation about x, y and z in degrees against time.");
  table.where(moving);
  table.check(
      "aligned", "Align X-axis to path", &Platform::aligned,
      "Turns the platform so that its x axis points along the velocity; the y axis stays parallel to the world's "
      "x-y plane.");
  table.always();
  table.vector(script::platform_grammar::rotation_rate, "rotation rate", Quantity::angle_rate, &Platform::rotation_rate,
               "Added to the rotation as rate times time.");
}

void add_motion_errors(FieldTable<Platform>& table) {
  table.always().group("Motion errors").rare();
  table.choice("position_error", "Position errors", &Platform::position_error, {"Standard deviation", "User-defined"},
               "Gaussian errors drawn anew for each pulse, or noise smoothed by an envelope.");
  table.where([](const Platform& p) { return p.position_error == Platform::MotionError::gaussian; });
  table.vector(script::platform_grammar::position_stddev, "position std. deviation", Quantity::length,
               &Platform::position_stddev_m,
               "Standard deviation of the Gaussian error of each pulse's position; 0 for none.");
  table.where([](const Platform& p) { return p.position_error == Platform::MotionError::envelope; });
  table.function("position_envelope", "Position error envelope", &Platform::position_envelope,
                 "White noise is integrated with this weight against the time before now. No points: no error.");
  table.always();
  table.choice("rotation_error", "Rotation errors", &Platform::rotation_error, {"Standard deviation", "User-defined"},
               "Gaussian errors drawn anew for each pulse, or noise smoothed by an envelope.");
  table.where([](const Platform& p) { return p.rotation_error == Platform::MotionError::gaussian; });
  table.vector(script::platform_grammar::rotation_stddev, "rotation std. deviation", Quantity::angle,
               &Platform::rotation_stddev,
               "Standard deviation of the Gaussian error of each pulse's rotation; 0 for none.");
  table.where([](const Platform& p) { return p.rotation_error == Platform::MotionError::envelope; });
  table.function("rotation_envelope", "Rotation error envelope", &Platform::rotation_envelope,
                 "White noise is integrated with this weight against the time before now. No points: no error.");
}

double first_value(const core::SampledFunction& function) {
  return function.knots.empty() ? 0.0 : function.knots.front().y;
}

// The platform stays where it was, and as it was turned, at the beginning of what is now given otherwise.
void begin_platform(const Platform& before, Platform& after) {
  if (moving(after)) {
    begin_constant(after.trajectory_m.part[0], before.position_m.x);
    begin_constant(after.trajectory_m.part[1], before.position_m.y);
    begin_constant(after.trajectory_m.part[2], before.position_m.z);
  } else if (moving(before)) {
    const auto& path = before.trajectory_m.part;
    after.position_m = {first_value(path[0]), first_value(path[1]), first_value(path[2])};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (after.rotation_kind == Platform::Rotation::user)
      begin_constant(after.rotation_deg.part[axis], before.rotation[axis].deg());
    else if (before.rotation_kind == Platform::Rotation::user)
      after.rotation[axis] = core::Angle::from_deg(first_value(before.rotation_deg.part[axis]));
  }
}

}  // namespace

const FieldTable<Platform>& platform_table() {
  static const FieldTable<Platform> made = [] {
    FieldTable<Platform> table;
    table.group("Platform");
    table.name(
        script::platform_grammar::name, FieldKind::text, "Platform name", &Platform::name,
        "Targets, surfaces and radars refer to the platform by this name; capital and small letters are the same.");
    add_position(table);
    add_rotation(table);
    add_motion_errors(table);
    table.on_switch(begin_platform);
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene::field_tables

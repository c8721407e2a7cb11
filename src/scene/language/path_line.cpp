#include "scene/language/path_line.hpp"

#include <fmt/format.h>

namespace sarsim::scene::language {

void read_line_path(ObjectReader& reader, ObjectText& text, Platform& platform) {
  Leaf* const type = text.find("path.type");
  if (type == nullptr || reader.string_of(type->value) != "line") return;
  FieldSpec start;
  start.id = "trajectory_m";
  start.words = "start of the path";
  start.quantity = Quantity::length;
  start.on_earth = true;
  start.likely = likely_range(Quantity::length);
  FieldSpec velocity = start;
  velocity.words = "velocity of the path";
  velocity.quantity = Quantity::speed;
  velocity.likely = likely_range(Quantity::speed);
  core::Vec3 at_zero;
  core::Vec3 per_second;
  reader.note_place(start.id, type->value.span);
  if (const Leaf* const leaf = reader.find("path.start"))
    static_cast<void>(reader.read_vector(start, leaf->value, at_zero));
  if (const Leaf* const leaf = reader.find("path.velocity"))
    static_cast<void>(reader.read_vector(velocity, leaf->value, per_second));
  else
    reader.error(type->value.span, start.id, {"a path of type line has no velocity", "", "velocity = [x, y, z]"});
  platform.path = Platform::Path::trajectory;
  const auto straight = [](double first, double speed) {
    core::SampledFunction function;
    function.method = core::Interpolation::linear;
    function.knots = {{0.0, first}};
    if (speed != 0.0) function.knots.push_back({1.0, first + speed});
    return function;
  };
  platform.trajectory_m.part = {straight(at_zero.x, per_second.x), straight(at_zero.y, per_second.y),
                                straight(at_zero.z, per_second.z)};
  type->used = true;
  for (std::size_t i = 0; i < text.leaves.size(); ++i) {
    const Leaf leaf = text.leaves[i];
    const bool of_points = is_below(leaf.path, "path.x") || is_below(leaf.path, "path.y") ||
                           is_below(leaf.path, "path.z") || leaf.path == "path.file";
    if (!of_points || leaf.used) continue;
    reader.error(leaf.key, start.id,
                 {fmt::format("'{}' does not apply here", leaf.path), "", "", "it belongs to path of type points"});
    text.use_all_below(leaf.path);
  }
}

}  // namespace sarsim::scene::language

#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

namespace {

FieldSpec corner(std::string_view id, std::string_view key, std::string_view label) {
  return {.id = id,
          .key = key,
          .label = label,
          .words = "corner",
          .place = "corner_m",
          .quantity = Quantity::length,
          .on_earth = true,
          .tip =
              "Corner of the triangle. Its front, which reflects, is where (point 2 - point 1) x (point 3 - point 1) "
              "points."};
}

}  // namespace

template <>
const FieldTable<Surface>& table_of<Surface>() {
  static const FieldTable<Surface> made = [] {
    FieldTable<Surface> table;
    table.group("Surface");
    table.add<&Surface::platform>({.id = "platform",
                                   .key = "platform",
                                   .label = "Platform name",
                                   .words = "name of the platform",
                                   .refers = "platform",
                                   .tip = "The platform that carries the triangle; coordinates are in its frame."});
    table.group("Point 1").add<&Surface::corner_m, 0>(corner("corner_m[0]", "corners[0]", "coordinate of point 1"));
    table.group("Point 2").add<&Surface::corner_m, 1>(corner("corner_m[1]", "corners[1]", "coordinate of point 2"));
    table.group("Point 3").add<&Surface::corner_m, 2>(corner("corner_m[2]", "corners[2]", "coordinate of point 3"));
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene

#include "scene/schema/field_table.hpp"
#include "scene/schema/scene_grammar.hpp"

namespace sarsim::scene::field_tables {

namespace {

bool directional(const Target& t) { return t.reflectivity == Target::Reflectivity::directional; }
bool user_gain(const Target& t) { return directional(t) && t.gain == Target::Gain::user; }

void add_place(FieldTable<Target>& table) {
  namespace grammar = script::target_grammar;
  table.group("Position");
  table.name(grammar::platform, FieldKind::platform, "Platform name", &Target::platform,
             "The platform that carries the target; coordinates are in its frame.");
  table.vector(grammar::position, "coordinate", Quantity::length, &Target::position_m,
               "Place of the target in the platform's frame.");
  table.rare();
  table.vector(grammar::position_stddev, "std. deviation", Quantity::length, &Target::position_stddev_m,
               "Gaussian jitter of the coordinate from pulse to pulse; 0 for none.");
  table.rare(false);
}

void add_reflectivity(FieldTable<Target>& table) {
  namespace grammar = script::target_grammar;
  table.group("Reflectivity");
  table.number(grammar::rcs, "Radar cross section", Quantity::area, &Target::rcs_m2,
               "Received power is Pt Gt Gr lambda^2 RCS/((4 pi)^3 R^4 L).");
  table.rare();
  table.number(grammar::rcs_stddev, "RCS std. deviation", Quantity::area, &Target::rcs_stddev_m2,
               "Gaussian scintillation of the cross section from pulse to pulse; 0 for none.");
  table.rare(false);
  table.choice("reflectivity", "Reflectivity", &Target::reflectivity, {"Isotropic", "Directional"},
               "The same from all directions, or as a surface whose cross section depends on the incidence angle.");
  table.where(directional);
  table.number(grammar::azimuth, "Azimuth", Quantity::angle, &Target::azimuth,
               "Direction in which the surface faces, in the platform's frame: from +y clockwise towards +x.");
  table.number(grammar::elevation, "Elevation", Quantity::angle, &Target::elevation,
               "Direction in which the surface faces, in the platform's frame: above the x-y plane.");
  table.rare();
  table.number(grammar::azimuth_stddev, "Azimuth std. deviation", Quantity::angle, &Target::azimuth_stddev,
               "Gaussian jitter of the azimuth from pulse to pulse; 0 for none.");
  table.number(grammar::elevation_stddev, "Elevation std. deviation", Quantity::angle, &Target::elevation_stddev,
               "Gaussian jitter of the elevation from pulse to pulse; 0 for none.");
  table.rare(false);
  table.choice("gain", "Gain", &Target::gain, {"Cos", "User-defined"},
               "Cos: RCS cos(incidence angle), nothing from behind. User-defined: a function of the incidence angle.");
  table.where(user_gain);
  table.function("gain_db", "Gain definition", &Target::gain_db,
                 "Reflectivity in dB against the incidence angle, 0 to 180 degrees.");
}

void begin_target(const Target&, Target& after) {
  if (user_gain(after)) begin_constant(after.gain_db.part[0], 0.0);
}

}  // namespace

const FieldTable<Target>& target_table() {
  static const FieldTable<Target> made = [] {
    FieldTable<Target> table;
    add_place(table);
    add_reflectivity(table);
    table.on_switch(begin_target);
    return table;
  }();
  return made;
}

const FieldTable<Surface>& surface_table() {
  namespace grammar = script::surface_grammar;
  static const FieldTable<Surface> made = [] {
    FieldTable<Surface> table;
    table.group("Surface");
    table.name(grammar::platform, FieldKind::platform, "Platform name", &Surface::platform,
               "The platform that carries the triangle; coordinates are in its frame.");
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string number = std::to_string(i + 1);
      table.group("Point " + number);
      table.vector_named(
          "corner_m[" + std::to_string(i) + "]", grammar::corner, "coordinate of point " + number,
          Quantity::length, [i](auto& surface) -> auto& { return surface.corner_m[i]; },
          "Corner of the triangle. Its front, which reflects, is where (point 2 - point 1) x (point 3 - point 1) "
          "points.");
    }
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene::field_tables

#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

namespace {

template <class Object>
void add_deviation(FieldTable<Object>& table) {
  table.template add<&Object::traits, &TargetTraits::position_stddev_m>(
      {.id = "position_stddev_m",
       .key = "position_deviation",
       .label = "std. deviation",
       .words = "standard deviation of position",
       .noun = "standard deviation of the position",
       .quantity = Quantity::length,
       .range = zero_or_more,
       .tip = "Gaussian jitter of the coordinate from pulse to pulse; 0 for none.",
       .rare = true});
}

void add_place(FieldTable<Target>& table) {
  table.group("Position");
  table.add<&Target::platform>({.id = "platform",
                                .key = "platform",
                                .label = "Platform name",
                                .words = "name of the platform",
                                .refers = "platform",
                                .tip = "The platform that carries the target; coordinates are in its frame."});
  table.add<&Target::position_m>({.id = "position_m",
                                  .key = "position",
                                  .label = "coordinate",
                                  .words = "position",
                                  .quantity = Quantity::length,
                                  .on_earth = true,
                                  .tip = "Position of the target in the platform's frame."});
  add_deviation(table);
}

void add_place(FieldTable<Cloud>& table) {
  table.group("Points");
  table.add<&Cloud::platform>({.id = "platform",
                               .key = "platform",
                               .label = "Platform name",
                               .words = "name of the platform",
                               .refers = "platform",
                               .tip = "The platform that carries the points; coordinates are in its frame."});
  table.add<&Cloud::file>({.id = "file",
                           .key = "positions.file",
                           .label = "File",
                           .words = "file of the points",
                           .tip =
                               "NPY, CSV or HDF5 table with a point in each row: x, y, z in metres and, where it has "
                               "a fourth column, the cross-section in square metres."});
  add_deviation(table);
}

template <class Object>
void add_reflectivity(FieldTable<Object>& table) {
  table.group("Reflectivity");
  table.template add<&Object::rcs_m2>({.id = "rcs_m2",
                                       .key = "rcs",
                                       .label = "Radar cross section",
                                       .words = "radar cross-section",
                                       .quantity = Quantity::area,
                                       .tip = "Received power is Pt Gt Gr lambda^2 RCS/((4 pi)^3 R^4 L)."});
  table.template add<&Object::traits, &TargetTraits::rcs_stddev_m2>(
      {.id = "rcs_stddev_m2",
       .key = "rcs_deviation",
       .label = "RCS std. deviation",
       .words = "standard deviation of the radar cross-section",
       .quantity = Quantity::area,
       .range = zero_or_more,
       .tip = "Gaussian scintillation of the cross section from pulse to pulse; 0 for none.",
       .rare = true});
  table.template add<&Object::traits, &TargetTraits::reflectivity>(
      {.id = "reflectivity",
       .key = "reflectivity",
       .label = "Reflectivity",
       .words = "kind of reflectivity",
       .choices = {{"ISOTROPIC", Target::Reflectivity::isotropic, "Isotropic", ""},
                   {"DIRECTIONAL", Target::Reflectivity::directional, "Directional", ""}},
       .tip = "The same from all directions, or as a surface whose cross section depends on the incidence angle."});
}

template <class Object>
void add_direction(FieldTable<Object>& table) {
  table.template when<&Object::traits, &TargetTraits::reflectivity>(Target::Reflectivity::directional);
  table.template add<&Object::traits, &TargetTraits::azimuth>(
      {.id = "azimuth",
       .key = "reflectivity.azimuth",
       .label = "Azimuth",
       .words = "azimuth of the target's face",
       .noun = "pointing azimuth",
       .quantity = Quantity::angle,
       .tip = "Direction in which the surface faces, in the platform's frame: from +y clockwise towards +x."});
  table.template add<&Object::traits, &TargetTraits::elevation>(
      {.id = "elevation",
       .key = "reflectivity.elevation",
       .label = "Elevation",
       .words = "elevation of the target's face",
       .noun = "pointing elevation",
       .quantity = Quantity::angle,
       .tip = "Direction in which the surface faces, in the platform's frame: above the x-y plane."});
  table.template add<&Object::traits, &TargetTraits::azimuth_stddev>(
      {.id = "azimuth_stddev",
       .key = "reflectivity.azimuth_deviation",
       .label = "Azimuth std. deviation",
       .words = "standard deviation of the azimuth",
       .quantity = Quantity::angle,
       .range = zero_or_more,
       .tip = "Gaussian jitter of the azimuth from pulse to pulse; 0 for none.",
       .rare = true});
  table.template add<&Object::traits, &TargetTraits::elevation_stddev>(
      {.id = "elevation_stddev",
       .key = "reflectivity.elevation_deviation",
       .label = "Elevation std. deviation",
       .words = "standard deviation of the elevation",
       .quantity = Quantity::angle,
       .range = zero_or_more,
       .tip = "Gaussian jitter of the elevation from pulse to pulse; 0 for none.",
       .rare = true});
  table.template add<&Object::traits, &TargetTraits::gain>(
      {.id = "gain",
       .key = "reflectivity.gain",
       .label = "Gain",
       .words = "law of reflectivity",
       .choices = {{"COS_GAIN", Target::Gain::cosine, "Cos", "cosine of the incidence angle", "cosine"},
                   {"OTHER_GAIN", Target::Gain::user, "User-defined", "function of the incidence angle", "points"}},
       .tip = "RCS times the cosine of the incidence angle, nothing from behind; or times a given function of that "
              "angle."});
  table.template when<&Object::traits, &TargetTraits::gain>(Target::Gain::user);
  table.template add<&Object::traits, &TargetTraits::gain_db>(
      {.id = "gain_db",
       .key = "reflectivity.gain",
       .label = "Gain definition",
       .words = "reflectivity",
       .block = &function_blocks::target_gain,
       .tip = "Reflectivity in dB against the incidence angle, 0 to 180 degrees."});
}

bool needs_gain(const TargetTraits& traits) {
  return traits.reflectivity == TargetTraits::Reflectivity::directional && traits.gain == TargetTraits::Gain::user &&
         traits.gain_db.part[0].knots.empty();
}

void begin_gain(const Target&, Target& after) {
  if (needs_gain(*after.traits)) begin_constant(after.traits.edit().gain_db.part[0], 0.0);
}

void begin_gain(const Cloud&, Cloud& after) {
  if (needs_gain(after.traits)) begin_constant(after.traits.gain_db.part[0], 0.0);
}

}  // namespace

template <>
const FieldTable<Target>& table_of<Target>() {
  static const FieldTable<Target> made = [] {
    FieldTable<Target> table;
    add_place(table);
    add_reflectivity(table);
    add_direction(table);
    return table.on_switch(begin_gain);
  }();
  return made;
}

template <>
const FieldTable<Cloud>& table_of<Cloud>() {
  static const FieldTable<Cloud> made = [] {
    FieldTable<Cloud> table;
    add_place(table);
    add_reflectivity(table);
    add_direction(table);
    return table.on_switch(begin_gain);
  }();
  return made;
}

}  // namespace sarsim::scene

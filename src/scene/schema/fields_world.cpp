#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

namespace {

void add_anchor(FieldTable<World>& table) {
  table.group("Anchor").when<&World::frame>(World::Frame::earth);
  table.add<&World::latitude>({.id = "latitude",
                               .key = "anchor.latitude",
                               .label = "Latitude",
                               .words = "latitude of the anchor",
                               .quantity = Quantity::angle,
                               .range = {-90.0, 90.0},
                               .tip = "Geodetic latitude (WGS 84) of the world's origin, positive to the north.",
                               .needed = true});
  table.add<&World::longitude>({.id = "longitude",
                                .key = "anchor.longitude",
                                .label = "Longitude",
                                .words = "longitude of the anchor",
                                .quantity = Quantity::angle,
                                .range = {-360.0, 360.0},
                                .tip = "Longitude of the world's origin, positive to the east.",
                                .needed = true});
  table.add<&World::height_m>({.id = "height_m",
                               .key = "anchor.height",
                               .label = "Height",
                               .words = "height of the anchor",
                               .quantity = Quantity::length,
                               .range = {-1e4, 1e8},
                               .tip = "Height of the world's origin above the ellipsoid."});
  table.add<&World::heading>({.id = "heading",
                              .key = "anchor.heading",
                              .label = "Heading",
                              .words = "heading of the y axis",
                              .quantity = Quantity::angle,
                              .range = {-360.0, 360.0},
                              .tip = "Direction of the world's y axis, clockwise from north: at 0 x is east and y is "
                                     "north."});
}

void add_earth(FieldTable<World>& table) {
  table.group("Earth").when<&World::frame>(World::Frame::earth);
  table.add<&World::undulation_m>({.id = "undulation_m",
                                   .key = "geoid.undulation",
                                   .label = "Geoid undulation",
                                   .words = "undulation of the geoid",
                                   .quantity = Quantity::length,
                                   .range = {-200.0, 200.0},
                                   .tip = "Height of the mean sea level above the ellipsoid, for positions with an "
                                          "altitude."});
  table.add<&World::geoid>(
      {.id = "geoid",
       .key = "geoid.file",
       .label = "Geoid grid",
       .words = "file of the geoid",
       .example = "\"egm96-5.pgm\"",
       .optional = true,
       .tip = "Grid of undulations in place of one number: GeographicLib PGM, GTX or ESRI ASCII."});
  table.add<&World::dut1_s>({.id = "dut1_s",
                             .key = "dut1",
                             .label = "UT1 - UTC",
                             .words = "difference UT1 - UTC",
                             .quantity = Quantity::time,
                             .range = {-0.9, 0.9},
                             .tip = "Turns orbits given in TEME, EME2000 or GCRF over the ground: 0.1 s are 46 m at "
                                    "the equator. IERS publishes it."});
}

}  // namespace

template <>
const FieldTable<World>& table_of<World>() {
  static const FieldTable<World> made = [] {
    FieldTable<World> table;
    table.group("World");
    table.add<&World::frame>(
        {.id = "frame",
         .key = "frame",
         .label = "Frame",
         .words = "frame of the world",
         .choices = {{"", World::Frame::flat, "Flat", "a plane that rests, without Earth", "flat"},
                     {"", World::Frame::earth, "Earth", "fixed to the turning Earth, WGS 84", "earth"}},
         .tip = "Whether the world is a plane without Earth, or lies on the turning Earth with its origin at the "
                "anchor: x east, y north, z up there."});
    table.add<&World::epoch>({.id = "epoch",
                              .key = "epoch",
                              .label = "Epoch",
                              .words = "epoch",
                              .example = "\"2024-04-01T22:59:42Z\"",
                              .optional = true,
                              .tip = "UTC of time 0, as 2024-04-01T22:59:42Z. Orbits from files need it."});
    add_anchor(table);
    add_earth(table);
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene

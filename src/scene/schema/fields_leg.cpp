#include "scene/schema/field_table.hpp"

/// The elements of lists.
namespace sarsim::scene {

namespace {

using LegKind = Leg::Kind;

void add_leg_sizes(FieldTable<Leg>& table) {
  table.when<&Leg::kind>(LegKind::straight, LegKind::climb, LegKind::hold, LegKind::circle);
  table.add<&Leg::duration_s>({.id = "duration_s",
                               .key = "duration",
                               .label = "Duration",
                               .words = "duration of the leg",
                               .quantity = Quantity::time,
                               .range = zero_or_more,
                               .example = "\"60 s\"",
                               .tip = "Duration; a straight leg has this or a length."});
  table.when<&Leg::kind>(LegKind::straight);
  table.add<&Leg::length_m>({.id = "length_m",
                             .key = "length",
                             .label = "Length",
                             .words = "length of the leg",
                             .quantity = Quantity::length,
                             .range = zero_or_more,
                             .example = "\"10 km\"",
                             .tip = "How long it is.",
                             .rare = true});
  table.add<&Leg::acceleration_mps2>({.id = "acceleration_mps2",
                                      .key = "acceleration",
                                      .label = "Acceleration",
                                      .words = "acceleration of the leg",
                                      .quantity = Quantity::acceleration,
                                      .example = "\"0.5 m/s2\"",
                                      .tip = "Change of speed; the platform may stop but not reverse.",
                                      .rare = true});
}

void add_turns(FieldTable<Leg>& table) {
  table.when<&Leg::kind>(LegKind::turn);
  table.add<&Leg::angle>({.id = "angle",
                          .key = "angle",
                          .label = "Angle",
                          .words = "angle of the turn",
                          .quantity = Quantity::angle,
                          .example = "\"90 deg\"",
                          .tip = "Change of heading, positive to the right."});
  table.when<&Leg::kind>(LegKind::turn_to);
  table.add<&Leg::heading>({.id = "heading",
                            .key = "heading",
                            .label = "Heading",
                            .words = "heading behind the turn",
                            .quantity = Quantity::angle,
                            .example = "\"270 deg\"",
                            .tip = "Azimuth: clockwise from the y axis.",
                            .needed = true});
  table.when<&Leg::kind>(LegKind::turn_to, LegKind::circle);
  table.add<&Leg::side>(
      {.id = "side",
       .key = "side",
       .label = "Side",
       .words = "side of the turn",
       .choices = {{"", Leg::Side::shorter, "Shorter", "the shorter way; circles to the right", "shorter"},
                   {"", Leg::Side::right, "Right", "clockwise from above", "right"},
                   {"", Leg::Side::left, "Left", "counterclockwise from above", "left"}},
       .tip = "Direction of the turn.",
       .rare = true});
  table.when<&Leg::kind>(LegKind::turn, LegKind::turn_to, LegKind::circle);
  table.add<&Leg::bank>({.id = "bank",
                         .key = "bank",
                         .label = "Bank",
                         .words = "bank of the turn",
                         .quantity = Quantity::angle,
                         .range = {0.0, 89.9},
                         .example = "\"25 deg\"",
                         .tip = "Bank angle of a coordinated turn, of radius v^2/(g tan bank). This or the radius."});
  table.add<&Leg::radius_m>({.id = "radius_m",
                             .key = "radius",
                             .label = "Radius",
                             .words = "radius of the turn",
                             .quantity = Quantity::length,
                             .range = zero_or_more,
                             .example = "\"3 km\"",
                             .tip = "Radius of the arc. This or the bank.",
                             .rare = true});
}

void add_climbs(FieldTable<Leg>& table) {
  table.when<&Leg::kind>(LegKind::climb_to);
  table.add<&Leg::height_m>({.id = "height_m",
                             .key = "height",
                             .label = "Height",
                             .words = "height behind the climb",
                             .quantity = Quantity::length,
                             .example = "\"3500 m\"",
                             .tip = "World z at the end of the climb or descent.",
                             .needed = true});
  table.when<&Leg::kind>(LegKind::climb, LegKind::climb_to);
  table.add<&Leg::rate_mps>({.id = "rate_mps",
                             .key = "rate",
                             .label = "Rate of climb",
                             .words = "rate of the climb",
                             .quantity = Quantity::speed,
                             .example = "\"5 m/s\"",
                             .tip = "Vertical speed; to a height its magnitude counts, otherwise negative is down."});
  table.add<&Leg::rounding_mps2>({.id = "rounding_mps2",
                                  .key = "rounding",
                                  .label = "Rounding",
                                  .words = "rounding of the climb",
                                  .quantity = Quantity::acceleration,
                                  .range = zero_or_more,
                                  .example = "\"1 m/s2\"",
                                  .tip = "Vertical acceleration at both ends; 0: the vertical speed steps.",
                                  .rare = true});
}

}  // namespace

template <>
const FieldTable<Leg>& table_of<Leg>() {
  static const FieldTable<Leg> made = [] {
    FieldTable<Leg> table;
    table.group("Leg");
    table.add<&Leg::kind>({.id = "kind",
                           .key = "leg",
                           .label = "Leg",
                           .words = "kind of leg",
                           .choices = {{"", LegKind::straight, "Straight", "straight and level", "straight"},
                                       {"", LegKind::turn, "Turn", "an arc by an angle", "turn"},
                                       {"", LegKind::turn_to, "Turn to", "an arc to a heading", "turn-to"},
                                       {"", LegKind::climb, "Climb", "straight, with a vertical speed", "climb"},
                                       {"", LegKind::climb_to, "Climb to", "the same to a height", "climb-to"},
                                       {"", LegKind::hold, "Hold", "straight on", "hold"},
                                       {"", LegKind::circle, "Circle", "in circles", "circle"}},
                           .tip = "Manoeuvre of the platform."});
    add_leg_sizes(table);
    add_turns(table);
    add_climbs(table);
    return table;
  }();
  return made;
}

template <>
const FieldTable<Waypoint>& table_of<Waypoint>() {
  static const FieldTable<Waypoint> made = [] {
    FieldTable<Waypoint> table;
    table.group("Waypoint");
    table.add<&Waypoint::position_m>({.id = "position_m",
                                      .key = "position",
                                      .label = "coordinate",
                                      .words = "position of the waypoint",
                                      .quantity = Quantity::length,
                                      .example = "[0, 20000, 3000]",
                                      .on_earth = true,
                                      .tip = "World position.",
                                      .needed = true});
    table.add<&Waypoint::speed_mps>({.id = "speed_mps",
                                     .key = "speed",
                                     .label = "Speed",
                                     .words = "speed from the waypoint on",
                                     .quantity = Quantity::speed,
                                     .range = zero_or_more,
                                     .example = "\"150 m/s\"",
                                     .tip = "Level speed from here on; 0: as before."});
    return table;
  }();
  return made;
}

template <>
const FieldTable<Oscillation>& table_of<Oscillation>() {
  static const FieldTable<Oscillation> made = [] {
    using Axis = Oscillation::Axis;
    FieldTable<Oscillation> table;
    table.group("Oscillation");
    table.add<&Oscillation::axis>({.id = "axis",
                                   .key = "axis",
                                   .label = "Axis",
                                   .words = "axis of the oscillation",
                                   .choices = {{"", Axis::x, "X", "world x", "x"},
                                               {"", Axis::y, "Y", "world y", "y"},
                                               {"", Axis::z, "Z", "world z", "z"},
                                               {"", Axis::roll, "Roll", "rotation about x", "roll"},
                                               {"", Axis::pitch, "Pitch", "rotation about y", "pitch"},
                                               {"", Axis::yaw, "Yaw", "rotation about z", "yaw"}},
                                   .tip = "What oscillates."});
    table.when<&Oscillation::axis>(Axis::x, Axis::y, Axis::z);
    table.add<&Oscillation::amplitude_m>({.id = "amplitude_m",
                                          .key = "amplitude",
                                          .label = "Amplitude",
                                          .words = "amplitude of the oscillation",
                                          .quantity = Quantity::length,
                                          .example = "\"0.5 m\"",
                                          .tip = "Half of the peak-to-peak displacement."});
    table.when<&Oscillation::axis>(Axis::roll, Axis::pitch, Axis::yaw);
    table.add<&Oscillation::angle>({.id = "angle",
                                    .key = "angle",
                                    .label = "Angle",
                                    .words = "angle of the oscillation",
                                    .quantity = Quantity::angle,
                                    .example = "\"5 deg\"",
                                    .tip = "Half of the peak-to-peak angle."});
    table.always();
    table.add<&Oscillation::frequency_hz>({.id = "frequency_hz",
                                           .key = "frequency",
                                           .label = "Frequency",
                                           .words = "frequency of the oscillation",
                                           .quantity = Quantity::frequency,
                                           .range = {0.0, 1e5},
                                           .likely = {1e-5, 1e5},
                                           .example = "\"0.1 Hz\"",
                                           .tip = "Frequency f of amplitude sin(2 pi f t + phase)."});
    table.add<&Oscillation::phase>({.id = "phase",
                                    .key = "phase",
                                    .label = "Phase",
                                    .words = "phase of the oscillation",
                                    .quantity = Quantity::angle,
                                    .tip = "At time 0.",
                                    .rare = true});
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene

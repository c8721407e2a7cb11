#include "scene/schema/fields_motion.hpp"

namespace sarsim::scene {

namespace {

using PathKind = Platform::Path;
using RotationKind = Platform::Rotation;

void add_ephemeris(FieldTable<Platform>& table) {
  table.when<&Platform::path>(PathKind::ephemeris);
  table.add<&Platform::ephemeris_file>({.id = "ephemeris_file",
                                        .key = "path.file",
                                        .label = "Orbit file",
                                        .words = "file of the path",
                                        .example = "\"S1A.EOF\"",
                                        .since_2 = true,
                                        .tip = "Sentinel-1 EOF, CCSDS OEM, SP3, a table t, x, y, z, or mean elements "
                                               "as TLE or OMM. Only the table works over a flat world."});
  table.add<&Platform::satellite>({.id = "satellite",
                                   .key = "path.satellite",
                                   .label = "Satellite",
                                   .words = "name of the satellite",
                                   .example = "\"25544\"",
                                   .optional = true,
                                   .since_2 = true,
                                   .tip = "Which satellite of the file: its name, catalogue number or mark."});
  table.add<&Platform::interpolation>(
      {.id = "interpolation",
       .key = "path.interpolation",
       .label = "Interpolation",
       .words = "interpolation of the states",
       .choices = {{"", Platform::Interpolation::automatic, "Automatic", "degree 7 where there are velocities",
                    "automatic"},
                   {"", Platform::Interpolation::hermite, "Hermite", "4 positions and velocities, degree 7", "hermite"},
                   {"", Platform::Interpolation::lagrange, "Lagrange", "8 positions, degree 7", "lagrange"},
                   {"", Platform::Interpolation::cubic, "Cubic", "2 positions and velocities, degree 3", "cubic"}},
       .since_2 = true,
       .tip = "Polynomial through neighbouring states; with states every 10 s of a low orbit the error is below 1e-8 m "
              "but for cubic, which is off by 0.3 mm."});
}

void add_orbit(FieldTable<Platform>& table) {
  table.when<&Platform::path>(PathKind::orbit);
  table.add<&Platform::semi_major_axis_m>({.id = "semi_major_axis_m",
                                           .key = "path.semi_major_axis",
                                           .label = "Semi-major axis",
                                           .words = "semi-major axis",
                                           .quantity = Quantity::length,
                                           .range = {6.4e6, 5e8},
                                           .since_2 = true,
                                           .tip = "Mean element at time 0; its secular changes are those of J2."});
  table.add<&Platform::eccentricity>({.id = "eccentricity",
                                      .key = "path.eccentricity",
                                      .label = "Eccentricity",
                                      .words = "eccentricity",
                                      .range = {0.0, 0.99},
                                      .example = "0.001",
                                      .since_2 = true,
                                      .tip = "Mean element at time 0."});
  table.add<&Platform::inclination>({.id = "inclination",
                                     .key = "path.inclination",
                                     .label = "Inclination",
                                     .words = "inclination",
                                     .quantity = Quantity::angle,
                                     .range = {0.0, 180.0},
                                     .since_2 = true,
                                     .tip = "Angle between orbit and equator; above 90 degrees it is retrograde."});
  table.add<&Platform::node_longitude>({.id = "node_longitude",
                                        .key = "path.node_longitude",
                                        .label = "Node longitude",
                                        .words = "longitude of the ascending node",
                                        .quantity = Quantity::angle,
                                        .range = {-360.0, 360.0},
                                        .since_2 = true,
                                        .tip = "Longitude under the ascending node at time 0."});
  table.add<&Platform::perigee>({.id = "perigee",
                                 .key = "path.perigee",
                                 .label = "Argument of perigee",
                                 .words = "argument of perigee",
                                 .quantity = Quantity::angle,
                                 .range = {-360.0, 360.0},
                                 .since_2 = true,
                                 .tip = "Angle from the ascending node to the perigee."});
  table.add<&Platform::anomaly>({.id = "anomaly",
                                 .key = "path.anomaly",
                                 .label = "Mean anomaly",
                                 .words = "mean anomaly",
                                 .quantity = Quantity::angle,
                                 .range = {-360.0, 360.0},
                                 .since_2 = true,
                                 .tip = "At time 0; on a circular orbit the angle from the perigee."});
}

void add_state(FieldTable<Platform>& table) {
  table.when<&Platform::path>(PathKind::state);
  table.add<&Platform::state_position_m>(
      {.id = "state_position_m",
       .key = "path.position",
       .label = "ECEF coordinate",
       .words = "position of the state",
       .quantity = Quantity::length,
       .range = {-1e9, 1e9},
       .example = "[2057735.247, -6459802.572, -2037501.319]",
       .since_2 = true,
       .tip = "At time 0 from the centre of the Earth, z to the north pole, x to longitude 0 (ECEF, ITRF)."});
  table.add<&Platform::state_velocity_mps>(
      {.id = "state_velocity_mps",
       .key = "path.velocity",
       .label = "ECEF velocity",
       .words = "velocity of the state",
       .quantity = Quantity::speed,
       .range = {-1e5, 1e5},
       .example = "[-886.58536, -2517.114487, 7108.167902]",
       .since_2 = true,
       .tip = "At time 0 over the turning Earth, in the axes of the position; it goes on under gravity with J2."});
}

void add_routes(FieldTable<Platform>& table) {
  table.when<&Platform::path>(PathKind::legs);
  table.add<&Platform::start_m>({.id = "start_m",
                                 .key = "path.start",
                                 .label = "start",
                                 .words = "start of the path",
                                 .quantity = Quantity::length,
                                 .on_earth = true,
                                 .since_2 = true,
                                 .tip = "Where the first leg begins."});
  table.add<&Platform::course>({.id = "course",
                                .key = "path.heading",
                                .label = "Heading",
                                .words = "heading of the first leg",
                                .quantity = Quantity::angle,
                                .since_2 = true,
                                .tip = "Azimuth of the first leg: clockwise from the y axis."});
  table.add<&Platform::legs>(
      {.id = "legs",
       .key = "path.legs",
       .label = "Legs",
       .words = "legs of the path",
       .example = R"([{ leg = "straight", length = "10 km" }, { leg = "turn", angle = "180 deg", bank = "30 deg" }])",
       .since_2 = true,
       .tip = "Straight legs, turns and climbs in sequence; straight on before and after them."});
  table.when<&Platform::path>(PathKind::waypoints);
  table.add<&Platform::waypoints>({.id = "waypoints",
                                   .key = "path.waypoints",
                                   .label = "Waypoints",
                                   .words = "waypoints of the path",
                                   .example = R"([{ position = [0, 0, 3000] }, { position = [0, 20000, 3000] }])",
                                   .since_2 = true,
                                   .tip = "Points of a route, joined by straight lines that arcs round off."});
  table.add<&Platform::bank>({.id = "bank",
                              .key = "path.bank",
                              .label = "Bank",
                              .words = "bank of the turns",
                              .quantity = Quantity::angle,
                              .range = {0.0, 89.0},
                              .since_2 = true,
                              .tip = "Bank angle of the turns at waypoints, of radius v^2/(g tan bank)."});
  table.add<&Platform::acceleration_mps2>({.id = "acceleration_mps2",
                                           .key = "path.acceleration",
                                           .label = "Acceleration",
                                           .words = "acceleration between speeds",
                                           .quantity = Quantity::acceleration,
                                           .range = zero_or_more,
                                           .since_2 = true,
                                           .tip = "Between the speeds of successive waypoints; 0: the speed steps."});
  table.when<&Platform::path>(PathKind::legs, PathKind::waypoints);
  table.add<&Platform::speed_mps>({.id = "speed_mps",
                                   .key = "path.speed",
                                   .label = "Speed",
                                   .words = "speed",
                                   .quantity = Quantity::speed,
                                   .range = zero_or_more,
                                   .since_2 = true,
                                   .tip = "Level speed at the start."});
  table.add<&Platform::start_s>({.id = "start_s",
                                 .key = "path.start_time",
                                 .label = "Start time",
                                 .words = "start time of the path",
                                 .quantity = Quantity::time,
                                 .since_2 = true,
                                 .tip = "When the platform is at the start."});
}

void add_relative(FieldTable<Platform>& table) {
  table.when<&Platform::path>(PathKind::relative);
  table.add<&Platform::leader>({.id = "leader",
                                .key = "path.leader",
                                .label = "Leader",
                                .words = "leader of the path",
                                .refers = "platform",
                                .example = "\"Earth\"",
                                .optional = true,
                                .since_2 = true,
                                .tip = "The platform with which this one flies in formation."});
  table.add<&Platform::offset_m>({.id = "offset_m",
                                  .key = "path.offset",
                                  .label = "offset",
                                  .words = "offset from the leader",
                                  .quantity = Quantity::length,
                                  .since_2 = true,
                                  .tip = "Along the leader's level heading, to the left of it, and up."});
  table.add<&Platform::delay_s>({.id = "delay_s",
                                 .key = "path.delay",
                                 .label = "Delay",
                                 .words = "delay behind the leader",
                                 .quantity = Quantity::time,
                                 .since_2 = true,
                                 .tip = "Time by which the platform trails the leader."});
}

}  // namespace

void add_paths(FieldTable<Platform>& table) {
  add_ephemeris(table);
  add_orbit(table);
  add_state(table);
  add_routes(table);
  add_relative(table);
}

void add_attitude_laws(FieldTable<Platform>& table) {
  table.when<&Platform::rotation_kind>(RotationKind::coordinated);
  table.add<&Platform::attack>({.id = "attack",
                                .key = "rotation.attack",
                                .label = "Angle of attack",
                                .words = "angle of attack",
                                .quantity = Quantity::angle,
                                .range = {-90.0, 90.0},
                                .since_2 = true,
                                .tip = "Angle of the x axis above the path."});
  table.when<&Platform::rotation_kind>(RotationKind::look_at);
  table.add<&Platform::look_at_m>({.id = "look_at_m",
                                   .key = "rotation.point",
                                   .label = "Look-at point",
                                   .words = "point that the platform looks at",
                                   .quantity = Quantity::length,
                                   .on_earth = true,
                                   .since_2 = true,
                                   .tip = "The z axis points away from it, the x axis as far ahead as that allows."});
  table.when<&Platform::rotation_kind>(RotationKind::nadir);
  table.add<&Platform::flight>(
      {.id = "flight",
       .key = "rotation.along",
       .label = "Along",
       .words = "direction of flight",
       .choices = {{"", Platform::Flight::earth_fixed, "Ground track", "the velocity over the turning Earth", "ground"},
                   {"", Platform::Flight::inertial, "Inertial", "the velocity that stars see", "inertial"}},
       .since_2 = true,
       .tip = "Which velocity the x axis follows."});
  table.when<&Platform::rotation_kind>(RotationKind::quaternions);
  table.add<&Platform::attitude_file>({.id = "attitude_file",
                                       .key = "rotation.file",
                                       .label = "Attitude file",
                                       .words = "file of the attitude",
                                       .example = "\"S1A.aem\"",
                                       .since_2 = true,
                                       .tip = "CCSDS AEM with quaternions."});
}

void add_gusts(FieldTable<Platform>& table) {
  table.when<&Platform::position_error>(Platform::MotionError::gusts);
  table.add<&Platform::turbulence>(
      {.id = "turbulence",
       .key = "position_error.turbulence",
       .label = "Turbulence",
       .words = "strength of the turbulence",
       .choices = {{"", Platform::Turbulence::light, "Light", "15 kn of wind at 20 ft", "light"},
                   {"", Platform::Turbulence::moderate, "Moderate", "30 kn", "moderate"},
                   {"", Platform::Turbulence::severe, "Severe", "45 kn", "severe"}},
       .since_2 = true,
       .tip = "Dryden turbulence of MIL-F-8785C.",
       .rare = true});
  table.add<&Platform::gust_height_m>({.id = "gust_height_m",
                                       .key = "position_error.height",
                                       .label = "Height above ground",
                                       .words = "height above ground",
                                       .quantity = Quantity::length,
                                       .range = {0.0, 20e3},
                                       .since_2 = true,
                                       .tip = "Scale lengths and strength of the gusts depend on it.",
                                       .rare = true});
  table.add<&Platform::airspeed_mps>({.id = "airspeed_mps",
                                      .key = "position_error.airspeed",
                                      .label = "Airspeed",
                                      .words = "airspeed",
                                      .quantity = Quantity::speed,
                                      .range = {1.0, 1000.0},
                                      .since_2 = true,
                                      .tip = "Airspeed through the gusts.",
                                      .rare = true});
  table.add<&Platform::response_s>({.id = "response_s",
                                    .key = "position_error.response",
                                    .label = "Response",
                                    .words = "lag of the aircraft",
                                    .quantity = Quantity::time,
                                    .range = {1e-3, 1e3},
                                    .since_2 = true,
                                    .tip = "Time constant with which the aircraft follows a gust: 2 (W/S)/(rho g V "
                                           "C_La).",
                                    .rare = true});
  table.add<&Platform::hold_s>({.id = "hold_s",
                                .key = "position_error.hold",
                                .label = "Autopilot period",
                                .words = "period of the autopilot",
                                .quantity = Quantity::time,
                                .range = {0.1, 1e4},
                                .since_2 = true,
                                .tip = "Period of the control loop that returns the aircraft to its path.",
                                .rare = true});
  table.add<&Platform::hold_damping>({.id = "hold_damping",
                                      .key = "position_error.damping",
                                      .label = "Autopilot damping",
                                      .words = "damping of the autopilot",
                                      .range = {0.05, 10.0},
                                      .since_2 = true,
                                      .tip = "Fraction of critical damping.",
                                      .rare = true});
}

namespace {

void add_waves(FieldTable<Platform>& table) {
  table.always();
  table.add<&Platform::waves>(
      {.id = "waves",
       .key = "waves",
       .label = "Waves",
       .words = "kind of waves",
       .choices = {{"", Platform::Waves::none, "None", "still water", "none"},
                   {"", Platform::Waves::ship, "Ship", "heave, roll and pitch of a ship", "ship"}},
       .since_2 = true,
       .tip = "Heave, roll and pitch of a ship in a sea with Bretschneider's spectrum.",
       .rare = true});
  table.when<&Platform::waves>(Platform::Waves::ship);
  const auto add = [&]<auto Member>(FieldSpec spec) {
    spec.since_2 = true;
    spec.rare = true;
    table.add<Member>(std::move(spec));
  };
  add.operator()<&Platform::wave_height_m>({.id = "wave_height_m",
                                            .key = "waves.height",
                                            .label = "Wave height",
                                            .words = "significant wave height",
                                            .quantity = Quantity::length,
                                            .range = {0.0, 30.0},
                                            .tip = "Significant height: 0.3 m in sea state 2, 0.88 in 3, 1.88 in 4, "
                                                   "3.25 in 5, 5 in 6, 7.5 in 7, 11.5 in 8."});
  add.operator()<&Platform::wave_period_s>({.id = "wave_period_s",
                                            .key = "waves.period",
                                            .label = "Wave period",
                                            .words = "period of the waves",
                                            .quantity = Quantity::time,
                                            .range = {0.5, 30.0},
                                            .tip = "Period of the most energetic waves: about 7.5 s in sea states 2 "
                                                   "and 3, 8.8 in 4, 9.7 in 5, 12.4 in 6, 15 in 7, 16.4 in 8."});
  add.operator()<&Platform::wave_heading>({.id = "wave_heading",
                                           .key = "waves.heading",
                                           .label = "Waves to",
                                           .words = "heading of the waves",
                                           .quantity = Quantity::angle,
                                           .tip = "Azimuth to which the waves go."});
  add.operator()<&Platform::ship_length_m>({.id = "ship_length_m",
                                            .key = "waves.length",
                                            .label = "Ship length",
                                            .words = "length of the ship",
                                            .quantity = Quantity::length,
                                            .range = {1.0, 1000.0},
                                            .tip = "At the waterline."});
  add.operator()<&Platform::ship_beam_m>({.id = "ship_beam_m",
                                          .key = "waves.beam",
                                          .label = "Ship beam",
                                          .words = "beam of the ship",
                                          .quantity = Quantity::length,
                                          .range = {0.3, 200.0},
                                          .tip = "At the waterline."});
  add.operator()<&Platform::ship_draught_m>({.id = "ship_draught_m",
                                             .key = "waves.draught",
                                             .label = "Ship draught",
                                             .words = "draught of the ship",
                                             .quantity = Quantity::length,
                                             .range = {0.1, 50.0},
                                             .tip = "Depth of the keel below the water."});
  add.operator()<&Platform::metacentric_height_m>(
      {.id = "metacentric_height_m",
       .key = "waves.metacentric_height",
       .label = "Metacentric height",
       .words = "metacentric height",
       .quantity = Quantity::length,
       .range = {0.01, 50.0},
       .tip = "How stiff the ship is against roll; its roll period is 2 C B/sqrt(GM)."});
  add.operator()<&Platform::roll_damping>({.id = "roll_damping",
                                           .key = "waves.roll_damping",
                                           .label = "Roll damping",
                                           .words = "damping of the roll",
                                           .range = {0.005, 2.0},
                                           .tip = "Fraction of critical damping: 0.05 bare, 0.1 with bilge keels."});
  add.operator()<&Platform::wave_count>({.id = "wave_count",
                                         .key = "waves.count",
                                         .label = "Number of waves",
                                         .words = "number of waves",
                                         .quantity = Quantity::count,
                                         .range = {1.0, 1000.0},
                                         .tip = "Number of sinusoids that model the sea; 20 to 40 are enough."});
}

void add_navigation(FieldTable<Platform>& table) {
  table.always();
  table.group("Navigation");
  table.add<&Platform::navigation>(
      {.id = "navigation",
       .key = "navigation",
       .label = "Navigation",
       .words = "kind of navigation",
       .choices = {{"", Platform::Navigation::none, "Exact", "the motion is known as it is", "exact"},
                   {"", Platform::Navigation::ins, "Inertial", "known with the errors of an inertial system", "ins"}},
       .since_2 = true,
       .tip = "Measured (navigation) motion, which motion files and focusing can use instead of the true motion.",
       .rare = true});
  table.when<&Platform::navigation>(Platform::Navigation::ins);
  const auto add = [&]<auto Member>(FieldSpec spec) {
    spec.since_2 = true;
    spec.rare = true;
    table.add<Member>(std::move(spec));
  };
  add.operator()<&Platform::accelerometer_mps2>({.id = "accelerometer_mps2",
                                                 .key = "navigation.accelerometer",
                                                 .label = "accelerometer bias",
                                                 .words = "bias of the accelerometers",
                                                 .quantity = Quantity::acceleration,
                                                 .tip = "Along world x, y and z; the position error grows as b t^2/2: "
                                                        "0.88 m in a minute for 50 ug."});
  add.operator()<&Platform::gyro>({.id = "gyro",
                                   .key = "navigation.gyro",
                                   .label = "gyro drift",
                                   .words = "drift of the gyros",
                                   .quantity = Quantity::angle_rate,
                                   .tip = "Tilt of the vertical that moves x and y, and drift of the heading; the "
                                          "position error grows as g eps t^3/6."});
  add.operator()<&Platform::fix_m>({.id = "fix_m",
                                    .key = "navigation.position",
                                    .label = "Position error",
                                    .words = "wandering error of the position",
                                    .quantity = Quantity::length,
                                    .range = zero_or_more,
                                    .tip = "Standard deviation on each axis."});
  add.operator()<&Platform::fix_s>({.id = "fix_s",
                                    .key = "navigation.position_time",
                                    .label = "Position correlation",
                                    .words = "correlation time of the position error",
                                    .quantity = Quantity::time,
                                    .range = {1e-3, 1e6},
                                    .tip = "Integral of the correlation (1 + 2 t/T) exp(-2 t/T)."});
  add.operator()<&Platform::attitude_error>({.id = "attitude_error",
                                             .key = "navigation.attitude",
                                             .label = "Attitude error",
                                             .words = "wandering error of the attitude",
                                             .quantity = Quantity::angle,
                                             .range = {0.0, 90.0},
                                             .tip = "Standard deviation of each angle."});
  add.operator()<&Platform::attitude_s>({.id = "attitude_s",
                                         .key = "navigation.attitude_time",
                                         .label = "Attitude correlation",
                                         .words = "correlation time of the attitude error",
                                         .quantity = Quantity::time,
                                         .range = {1e-3, 1e6},
                                         .tip = "Integral of the correlation (1 + 2 t/T) exp(-2 t/T)."});
  add.operator()<&Platform::aligned_s>({.id = "aligned_s",
                                        .key = "navigation.aligned",
                                        .label = "Aligned at",
                                        .words = "time of the alignment",
                                        .quantity = Quantity::time,
                                        .tip = "Time from which biases and drifts act."});
}

}  // namespace

void add_perturbations(FieldTable<Platform>& table) {
  table.always();
  table.group("Motion errors");
  table.add<&Platform::oscillations>({.id = "oscillations",
                                      .key = "oscillations",
                                      .label = "Oscillations",
                                      .words = "oscillations",
                                      .example = R"([{ axis = "roll", angle = "5 deg", frequency = "0.1 Hz" }])",
                                      .since_2 = true,
                                      .tip = "Sinusoids added to a coordinate or an angle.",
                                      .rare = true});
  add_waves(table);
  add_navigation(table);
}

}  // namespace sarsim::scene

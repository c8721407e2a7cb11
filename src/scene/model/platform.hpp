#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/maths/angle.hpp"
#include "core/maths/vector.hpp"
#include "scene/model/user_function.hpp"

namespace sarsim::scene {

/// A piece of a path in closed form; level but for climbs. Lengths and durations of 0 are not given.
struct Leg {
  /// What it does.
  enum class Kind { straight, turn, turn_to, climb, climb_to, hold, circle };
  /// Which way a turn goes; `shorter` is right in a circle.
  enum class Side { shorter, right, left };

  Kind kind = Kind::straight;
  double duration_s = 0.0;
  double length_m = 0.0;
  double acceleration_mps2 = 0.0;  ///< Of the speed; Kind::straight.
  core::Angle angle;               ///< Clockwise positive; Kind::turn.
  core::Angle heading;             ///< Kind::turn_to.
  Side side = Side::shorter;
  core::Angle bank;  ///< Of a turn or circle; this or the radius.
  double radius_m = 0.0;
  double height_m = 0.0;  ///< World z; Kind::climb_to.
  double rate_mps = 0.0;  ///< Vertical speed.
  double rounding_mps2 = 0.0;

  friend bool operator==(const Leg&, const Leg&) = default;
};

/// A point of a route.
struct Waypoint {
  core::Vec3 position_m;
  double speed_mps = 0.0;  ///< From here on; 0: as before.

  friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

/// An oscillation of a coordinate or of an angle: amplitude sin(2 pi frequency t + phase).
struct Oscillation {
  /// What oscillates: along x, y, z, or about them.
  enum class Axis { x, y, z, roll, pitch, yaw };

  Axis axis = Axis::z;
  double amplitude_m = 0.0;  ///< Of x, y, z,
  core::Angle angle;         ///< and of the others.
  double frequency_hz = 0.0;
  core::Angle phase;

  friend bool operator==(const Oscillation&, const Oscillation&) = default;
};

struct ReadPath;
struct ReadAttitude;

/// A frame that carries targets and radars (script `$PLATFORM`, thesis 4.3).
struct Platform {
  /// How its place follows from the time.
  enum class Path {
    stationary,
    trajectory,  ///< Points against time.
    ephemeris,   ///< A file.
    orbit,       ///< An ellipse that J2 turns.
    state,       ///< A position and a velocity, from which gravity leads on.
    legs,
    waypoints,
    relative,  ///< To another platform.
  };
  /// How it is turned. Behind `user` the angles turn it further, within the axes of the law.
  enum class Rotation { constant, user, coordinated, zero_doppler, nadir, look_at, quaternions };
  /// A draw of its own for each pulse, white noise smoothed by an envelope, or the Dryden turbulence of an aircraft.
  enum class MotionError { gaussian, envelope, gusts };
  /// How a file of states is interpolated: by what it has.
  enum class Interpolation { automatic, hermite, lagrange, cubic };
  /// How strong the turbulence is.
  enum class Turbulence { light, moderate, severe };
  /// What waves move.
  enum class Waves { none, ship };
  /// How the motion is known.
  enum class Navigation { none, ins };
  /// Which velocity a satellite's x axis follows.
  enum class Flight { earth_fixed, inertial };

  std::string name = "Earth";
  Path path = Path::stationary;
  core::Vec3 position_m;         ///< World position; Path::stationary.
  UserFunction<3> trajectory_m;  ///< World x, y, z [m] against time [s]; Path::trajectory.
  bool aligned = false;          ///< Platform x axis along the velocity; Path::trajectory.
  Rotation rotation_kind = Rotation::constant;
  std::array<core::Angle, 3> rotation;       ///< About x, y, z; Rotation::constant.
  UserFunction<3> rotation_deg;              ///< About x, y, z [deg] against time [s]; Rotation::user.
  std::array<core::Angle, 3> rotation_rate;  ///< Per second; added to either kind as rate * t.
  MotionError position_error = MotionError::gaussian;
  core::Vec3 position_stddev_m;       ///< MotionError::gaussian.
  UserFunction<3> position_envelope;  ///< Integration envelope [m/sqrt(s)] against lag [s]; MotionError::envelope.
  MotionError rotation_error = MotionError::gaussian;
  std::array<core::Angle, 3> rotation_stddev;
  UserFunction<3> rotation_envelope;  ///< Integration envelope [deg/sqrt(s)] against lag [s].

  std::string parent;  ///< Platform in whose frame all of this is; empty: the world.

  std::string ephemeris_file;  ///< Path::ephemeris; docs/formats/motion-files.md.
  std::string satellite;       ///< Of several in the file; empty: the only one.
  Interpolation interpolation = Interpolation::automatic;
  double semi_major_axis_m = 7071e3;  ///< Path::orbit: mean elements at time 0.
  double eccentricity = 0.0;
  core::Angle inclination;
  core::Angle node_longitude;                       ///< Of the ascending node, over the Earth as it lies at time 0.
  core::Angle perigee;                              ///< Argument of perigee.
  core::Angle anomaly;                              ///< Mean anomaly.
  core::Vec3 state_position_m{7071e3, 0.0, 0.0};    ///< Path::state: at time 0 from the Earth's centre, in axes fixed
                                                    ///< to it (ECEF, ITRF),
  core::Vec3 state_velocity_mps{0.0, 7000.0, 0.0};  ///< and over the turning Earth.
  core::Vec3 start_m;                               ///< Path::legs.
  core::Angle course;                               ///< Azimuth of the first leg.
  double speed_mps = 0.0;                           ///< Level speed; Path::legs and waypoints.
  std::vector<Leg> legs;
  std::vector<Waypoint> waypoints;
  core::Angle bank;                ///< Of the turns between waypoints.
  double acceleration_mps2 = 0.0;  ///< From one speed to the next; 0: it steps.
  double start_s = 0.0;            ///< When the first leg begins.
  std::string leader;              ///< Path::relative.
  core::Vec3 offset_m;             ///< Along the leader's path, to the left, up.
  double delay_s = 0.0;            ///< Of the leader's path.

  core::Angle attack;    ///< Added to the pitch; Rotation::coordinated.
  core::Vec3 look_at_m;  ///< World position; Rotation::look_at.
  Flight flight = Flight::earth_fixed;
  std::string attitude_file;  ///< Rotation::quaternions.

  std::vector<Oscillation> oscillations;
  Turbulence turbulence = Turbulence::moderate;  ///< MotionError::gusts, with the next five.
  double gust_height_m = 300.0;                  ///< Above ground.
  double airspeed_mps = 100.0;
  double response_s = 0.5;  ///< Lag of the aircraft behind the gusts.
  double hold_s = 20.0;     ///< Period with which the autopilot brings it back.
  double hold_damping = 0.7;
  Waves waves = Waves::none;
  double wave_height_m = 3.25;  ///< Significant height; Waves::ship, with the next eight.
  double wave_period_s = 9.7;   ///< Of the peak.
  core::Angle wave_heading;     ///< Azimuth to which the waves go.
  double ship_length_m = 110.0;
  double ship_beam_m = 15.0;
  double ship_draught_m = 5.0;
  double metacentric_height_m = 1.2;
  double roll_damping = 0.1;
  int wave_count = 30;
  Navigation navigation = Navigation::none;
  core::Vec3 accelerometer_mps2;    ///< Biases along world axes; Navigation::ins, with the next.
  std::array<core::Angle, 3> gyro;  ///< Per second: drifts that tilt the vertical and so move x and y.
  double fix_m = 0.0;               ///< Standard deviation of a wandering position error,
  double fix_s = 60.0;              ///< and its correlation time.
  core::Angle attitude_error;       ///< Standard deviation of a wandering attitude error,
  double attitude_s = 60.0;         ///< and its correlation time.
  double aligned_s = 0.0;           ///< When the biases begin to count.

  FileContents<ReadPath> read_path;          ///< Of `ephemeris_file` (workflow/input/motion_input.hpp).
  FileContents<ReadAttitude> read_attitude;  ///< Of `attitude_file`.

  friend bool operator==(const Platform&, const Platform&) = default;
};

}  // namespace sarsim::scene

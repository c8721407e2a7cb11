#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/maths/angle.hpp"
#include "core/maths/sampled_function.hpp"
#include "core/maths/vector.hpp"
#include "scene/model/shared.hpp"

/// What a script describes, as plain data. Any values can be stored, so that an editor can hold a
/// half-typed object; `check` (scene/check/check.hpp) says whether they can be simulated. SI units, except
/// that angles and decibels keep what was typed (core/maths/angle.hpp) and that the knots of user-defined
/// functions stay in the units that their name ends in.
namespace sarsim::scene {

/// N functions of one variable that are defined together, in the script or in a data file.
template <std::size_t N>
struct UserFunction {
  std::array<core::SampledFunction, N> part;
  std::string file;  ///< Name of the data file as the script gives it; empty: INLINE.

  friend bool operator==(const UserFunction&, const UserFunction&) = default;
};

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

/// What a file says, made ready; null until it is read. It is no part of what a scene says: any are equal.
template <class Contents>
struct FileContents : std::shared_ptr<const Contents> {
  using std::shared_ptr<const Contents>::shared_ptr;
  FileContents() = default;
  FileContents(std::shared_ptr<const Contents> contents) : std::shared_ptr<const Contents>(std::move(contents)) {}

  friend bool operator==(const FileContents&, const FileContents&) { return true; }
};

struct CloudPoints;
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

/// How a point reflects and jitters: what many points have in common.
struct TargetTraits {
  /// The same cross-section from all sides, or one that depends on the angle from a normal.
  enum class Reflectivity { isotropic, directional };
  /// That dependence: the cosine, or points.
  enum class Gain { cosine, user };

  core::Vec3 position_stddev_m;
  double rcs_stddev_m2 = 0.0;
  Reflectivity reflectivity = Reflectivity::isotropic;
  core::Angle azimuth;  ///< Of the reflecting normal in the platform's frame; Reflectivity::directional.
  core::Angle elevation;
  core::Angle azimuth_stddev;
  core::Angle elevation_stddev;
  Gain gain = Gain::cosine;
  UserFunction<1> gain_db;  ///< Reflectivity [dB] against incidence angle [deg]; Gain::user.

  friend bool operator==(const TargetTraits&, const TargetTraits&) = default;
};

/// Whether they are equal to the last bit, for scripts keep a zero with the sign it was typed with.
[[nodiscard]] bool identical(const TargetTraits& a, const TargetTraits& b);

/// What the world itself is called where a platform is named.
inline std::string world_name() { return "Earth"; }
/// The name of the platform that carries a point.
using SharedName = Shared<std::string, world_name>;

/// A point that reflects (script `$TARGET`, thesis 4.2). There may be millions, so that it is as small as can be.
struct Target {
  using Reflectivity = TargetTraits::Reflectivity;
  using Gain = TargetTraits::Gain;

  SharedName platform;
  core::Vec3 position_m;  ///< In the platform's frame.
  double rcs_m2 = 1.0;
  Shared<TargetTraits> traits;

  friend bool operator==(const Target&, const Target&) = default;
};

/// Many points that reflect alike, from a table in a file (script `$CLOUD`); docs/formats/point-tables.md.
struct Cloud {
  std::string platform = "Earth";
  std::string file = "points.npy";  ///< NPY, CSV or HDF5: x, y, z and perhaps cross-sections.
  double rcs_m2 = 1.0;              ///< Of each point, where the table has no cross-sections.
  TargetTraits traits;              ///< Of each point.

  FileContents<CloudPoints> points;  ///< What the file holds; null until it is read (workflow/input/cloud_input.hpp).

  friend bool operator==(const Cloud&, const Cloud&) = default;
};

/// A triangle that reflects (script `$SURFACE`); its front is where (corner 2 - corner 1) x (corner 3 - corner 1)
/// points.
struct Surface {
  std::string platform = "Earth";
  std::array<core::Vec3, 3> corner_m{core::Vec3{1000.0, 10.0, 0.0}, core::Vec3{1000.0, -10.0, 0.0},
                                     core::Vec3{1000.0, 0.0, 10.0}};

  friend bool operator==(const Surface&, const Surface&) = default;
};

/// One antenna of a radar: its gain against the offset from the beam's direction.
struct Antenna {
  /// Gain 1 everywhere, sin(x)/x, or points.
  enum class Pattern { isotropic, sinx, user };

  Pattern pattern = Pattern::isotropic;
  core::Angle elevation_beamwidth = core::Angle::from_deg(10.0);  ///< Pattern::sinx.
  core::Angle azimuth_beamwidth = core::Angle::from_deg(10.0);
  UserFunction<2> gain_db;  ///< Azimuth cut, elevation cut: one-way power [dB] against offset [deg]; Pattern::user.

  friend bool operator==(const Antenna&, const Antenna&) = default;
};

/// A transmitter and receiver at the origin of its platform (script `$RADAR`, thesis 4.4).
struct Radar {
  /// One frequency, a linear sweep, I and Q by points, or a Barker code.
  enum class Pulse { mono, chirp, user, barker };
  /// Full amplitude throughout, straight rise and fall, or points.
  enum class Envelope { rectangular, linear, user };
  /// One repetition frequency, or a list of intervals.
  enum class Repetition { constant, user };
  /// One carrier, evenly spaced steps, or a list.
  enum class Carrier { single, stepped, user };
  /// A fixed direction, a turning one, a point that is looked at, or angles against time.
  enum class Beam { fixed, rotating, spot, user };
  /// Weights of the matched filter.
  enum class Window { rectangular, hanning, bartlett, hamming, user, blackman, kaiser, taylor };
  /// Sensitivity-time control: none, gain with the square of the range, or points.
  enum class Stc { none, range_law, user };

  std::string name = "Radar1";
  std::string platform = "Earth";

  Pulse pulse = Pulse::mono;
  double bandwidth_hz = 50e6;  ///< Pulse::chirp; negative sweeps down.
  UserFunction<2> pulse_iq;    ///< I, Q against the fraction of the pulse width; Pulse::user.
  int barker_code = 6;         ///< 0 to 6, lengths 2, 3, 4, 5, 7, 11, 13; Pulse::barker.
  double pulse_width_s = 5e-6;
  Envelope envelope = Envelope::rectangular;
  double rise_s = 0.0;  ///< Envelope::linear.
  double fall_s = 0.0;
  UserFunction<1> envelope_gain;  ///< Against the fraction of the pulse width; Envelope::user.

  Repetition repetition = Repetition::constant;
  double prf_hz = 1000.0;  ///< Repetition::constant.
  UserFunction<1> pri_s;   ///< y: interval after each pulse, in turn; x is ignored; Repetition::user.
  Carrier carrier = Carrier::single;
  double carrier_hz = 1e9;  ///< Carrier::single, and the start frequency of Carrier::stepped.
  double carrier_step_hz = 0.1e9;
  int carrier_steps = 66;
  int pulses_per_step = 2;
  UserFunction<1> carrier_list_hz;  ///< y: carrier of each pulse, in turn; x is ignored; Carrier::user.

  double power_w = 1000.0;
  core::PowerRatio transmit_gain;
  core::PowerRatio receive_gain;
  core::PowerRatio losses;
  double noise_temperature_k = 0.0;

  Antenna transmit_antenna;
  bool same_antenna = true;  ///< Receive with the transmit antenna.
  Antenna receive_antenna;   ///< Where not the same.
  Beam beam = Beam::fixed;
  core::Angle beam_elevation;           ///< Beam::fixed, Beam::rotating; in the platform's frame.
  core::Angle beam_azimuth;             ///< Beam::fixed.
  core::Angle beam_rate;                ///< Per second; Beam::rotating.
  core::Vec3 spot_world_m;              ///< Beam::spot.
  UserFunction<3> beam_target_world_m;  ///< World point looked at [m] against time [s]; Beam::user.

  Window window = Window::rectangular;
  double hanning_pedestal = 0.0;
  double kaiser_beta = 2.5;           ///< Window::kaiser.
  double taylor_sidelobes_db = 35.0;  ///< Window::taylor: how far they lie below the peak.
  int taylor_equal_sidelobes = 5;     ///< Window::taylor: nbar.
  UserFunction<1> window_gain;        ///< Against the fraction of the pulse width; Window::user.
  Stc stc = Stc::none;
  UserFunction<1> stc_gain;  ///< Voltage gain against range [m]; Stc::user.

  friend bool operator==(const Radar&, const Radar&) = default;
};

/// How a file of samples is laid out (docs/formats).
enum class FileFormat { ascii, binary, bracket, hdf5, csv, npy, zarr, sigmf };

/// What is done to the received samples before the A/D converter.
enum class Processing { raw, matched_filter, srp };

/// A recording to be made (script `$SIMULATION`, thesis 4.5).
struct Simulation {
  /// Which part of an echo stands at its target's range.
  enum class PulsePosition { begin, centre };

  std::string radar;
  double range_start_m = 0.0;  ///< One way.
  double range_end_m = 0.0;
  double time_start_s = 0.0;
  double time_end_s = 0.01;
  int bits = 8;
  double sample_rate_hz = 0.0;
  double lsb_v = 0.0;  ///< 0: estimated from the largest magnitude.
  FileFormat format = FileFormat::binary;
  Processing processing = Processing::raw;
  std::string file = "sim1.bin";
  PulsePosition pulse_position = PulsePosition::begin;
  double oversampling = 1.0;  ///< Above 1 a band-limited pulse keeps only its nominal bandwidth.
  /// Kept length of such a pulse, in pulse widths. 0: all of it; in the classic profile, its nominal length.
  double width_factor = 0.0;

  friend bool operator==(const Simulation&, const Simulation&) = default;
};

/// A table of delays, amplitudes and speeds to be made (script `$GEOMETRY`, thesis 4.10).
struct GeometryTable {
  /// What stands between the columns of the table.
  enum class Separator { space, comma };

  std::string radar;
  double range_start_m = 0.0;
  double range_end_m = 100e3;
  double time_start_s = 0.0;
  double time_end_s = 0.1;
  Separator separator = Separator::space;
  int columns = 227;  ///< Sum of column bits, docs/formats/geometry-table.md.
  std::string file = "geo1.txt";

  friend bool operator==(const GeometryTable&, const GeometryTable&) = default;
};

/// Which set of conventions a run follows (docs/decisions/0001-profiles.md).
enum class Profile { physical, classic };

/// What the pulse of a simulation is (decision 7): hard-edged, or confined to a band.
enum class PulseDefinition { ideal, band_limited };

/// Which echoes of pulses other than its own a row receives; never any by the conventions of 1998.
enum class AmbiguousEchoes {
  strong,  ///< Those that may exceed -60 dB relative to the strongest echo, antennas ignored.
  all,
  none,
};

/// What a receiver does while its radar sends.
enum class Eclipsing {
  none,     ///< It goes on receiving.
  blanked,  ///< It is off: samples are 0.
};

/// Choices that hold for every product of a scene (script `$OPTIONS`; the command line overrides).
struct RunOptions {
  Profile profile = Profile::physical;
  std::uint64_t seed = 1;
  PulseDefinition pulse = PulseDefinition::ideal;
  double tolerance = 1e-6;
  core::CubicEnds cubic_ends = core::CubicEnds::chords;  ///< Of every function given by points, CUBIC (decision 17).
  AmbiguousEchoes ambiguous_echoes = AmbiguousEchoes::strong;
  Eclipsing eclipsing = Eclipsing::none;

  friend bool operator==(const RunOptions&, const RunOptions&) = default;
};

/// Where and when the scene is (format 2 `[world]`).
struct World {
  /// What the world's coordinates are fixed to.
  enum class Frame {
    flat,   ///< Nothing: a plane that rests.
    earth,  ///< The turning Earth, WGS 84: x east, y north, z up at the anchor, turned by its heading.
  };

  Frame frame = Frame::flat;
  std::string epoch;          ///< UTC of time 0, ISO 8601; empty: none.
  core::Angle latitude;       ///< Geodetic, of the anchor; this and what follows: Frame::earth.
  core::Angle longitude;      ///< Positive to the east.
  double height_m = 0.0;      ///< Above the ellipsoid.
  core::Angle heading;        ///< Of the world's y axis, clockwise from north.
  std::string geoid;          ///< Grid of undulations; empty: `undulation_m` everywhere.
  double undulation_m = 0.0;  ///< Height of the mean sea level above the ellipsoid.
  double dut1_s = 0.0;        ///< UT1 - UTC, for orbits in axes that do not turn with the Earth.

  friend bool operator==(const World&, const World&) = default;
};

/// What lies between radars and what they see (format 2 `[atmosphere]`); nothing as it is made.
struct Atmosphere {
  /// How the refractivity depends on height.
  enum class Refraction { none, exponential, linear };

  Refraction refraction = Refraction::none;
  double refractivity = 315.0;     ///< N at height 0.
  double scale_height_m = 7350.0;  ///< Refraction::exponential.
  double k_factor = 4.0 / 3.0;     ///< Refraction::linear.
  bool gases = false;
  double vapour_g_per_m3 = 7.5;  ///< At height 0.
  double rain_mm_per_h = 0.0;
  double rain_top_m = 5000.0;
  core::Angle polarisation;  ///< From the horizontal, for rain.
  double tec_units = 0.0;    ///< Vertical electron content, 1e16/m^2.
  double shell_height_m = 450e3;
  double field_ut = 0.0;  ///< Magnetic field along the path, uT.

  friend bool operator==(const Atmosphere&, const Atmosphere&) = default;
};

/// Everything that a script says, in the script's order within each list.
struct Scene {
  std::vector<Platform> platforms;
  std::vector<Surface> surfaces;
  std::vector<Target> targets;
  std::vector<Cloud> clouds;
  std::vector<Radar> radars;
  std::vector<Simulation> simulations;
  std::vector<GeometryTable> geometries;
  RunOptions options;
  World world;
  Atmosphere atmosphere;

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// Position of the platform that `name` means, or `not_found`: an exact match ignoring case first, otherwise the only
/// platform of which `name` is a prefix (or that is a prefix of `name`). "Earth" where no platform has exactly that
/// name is not found: it is the world itself, which `resolve` (simulate/resolve/resolved.hpp) knows without a
/// definition.
inline constexpr std::size_t not_found = static_cast<std::size_t>(-1);
/// See `not_found`.
[[nodiscard]] std::size_t find_platform(const Scene& scene, std::string_view name);
/// The same for radars.
[[nodiscard]] std::size_t find_radar(const Scene& scene, std::string_view name);

}  // namespace sarsim::scene

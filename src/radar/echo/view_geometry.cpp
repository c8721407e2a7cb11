#include "radar/echo/view_geometry.hpp"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/view_geometry.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "core/maths/constants.hpp"
#include "core/maths/opposite.hpp"
#include "radar/echo/simd_curves-inl.hpp"
#include "radar/simd/angle-inl.hpp"
#include "radar/simd/math-inl.hpp"
#include "radar/simd/normals-inl.hpp"

HWY_BEFORE_NAMESPACE();
#include "core/report/expect.hpp"

namespace sarsim::radar::HWY_NAMESPACE {

using Tag = hn::ScalableTag<double>;
using Vector = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

struct Triple {
  Vector x, y, z;
};

HWY_INLINE Vector dot_row(Tag d, const core::Vec3& row, const Triple& v, Vector start) {
  return hn::MulAdd(hn::Set(d, row.z), v.z,
                    hn::MulAdd(hn::Set(d, row.y), v.y, hn::MulAdd(hn::Set(d, row.x), v.x, start)));
}

HWY_INLINE Triple turned(Tag d, const core::Mat3& m, const Triple& v, const core::Vec3& shift) {
  return {dot_row(d, m.row[0], v, hn::Set(d, shift.x)), dot_row(d, m.row[1], v, hn::Set(d, shift.y)),
          dot_row(d, m.row[2], v, hn::Set(d, shift.z))};
}

HWY_INLINE Vector inner(const Triple& a, const Triple& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

HWY_INLINE Triple outer(const Triple& a, const Triple& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

HWY_INLINE Triple all_lanes(Tag d, const core::Vec3& v) { return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)}; }

HWY_INLINE Triple plus(const Triple& a, Vector factor, const Triple& b) {
  return {hn::MulAdd(factor, b.x, a.x), hn::MulAdd(factor, b.y, a.y), hn::MulAdd(factor, b.z, a.z)};
}

HWY_INLINE Vector degrees(Tag d, Vector radians) { return hn::Mul(radians, hn::Set(d, 57.295779513082320877)); }

// Points [first, first + count) of the columns, one to a lane; lanes that are left over repeat the last one.
template <bool Whole>
struct Points {
  std::size_t first, count;

  template <class D>
  HWY_INLINE hn::Vec<D> of(D d, const std::vector<hn::TFromD<D>>& column) const {
    if constexpr (Whole) return hn::LoadU(d, column.data() + first);
    HWY_ALIGN hn::TFromD<D> buffer[hn::MaxLanes(d)];
    for (std::size_t l = 0; l < hn::Lanes(d); ++l) buffer[l] = column[first + (l < count ? l : count - 1)];
    return hn::Load(d, buffer);
  }

  HWY_INLINE void put(Tag d, Vector values, double* HWY_RESTRICT to) const {
    if constexpr (Whole) return hn::StoreU(values, d, to);
    HWY_ALIGN double buffer[hn::MaxLanes(d)];
    hn::Store(values, d, buffer);
    for (std::size_t l = 0; l < count; ++l) to[l] = buffer[l];
  }
};

// The axis of AntennaView::Offsets::world_angles.
struct Axis {
  double sine_azimuth, cosine_azimuth, sine_elevation, cosine_elevation;
};

Axis axis_of(const ViewFrame& frame) {
  return {std::sin(frame.axis_azimuth_rad), std::cos(frame.axis_azimuth_rad), std::sin(frame.axis_elevation_rad),
          std::cos(frame.axis_elevation_rad)};
}

// How the radar moves on, in units of the speed of light.
struct RadarWay {
  double per_light;
  core::Vec3 way, slope;  // ViewFrame::radar_mps and radar_slope_mps
  double square;          // way.way
  double per_still;       // 2/(1 - way.way)
  double way_slope;       // way.slope
  bool is_even;           // whether slope is way but for rounding: always, unless the radar jumps or jerks
};

RadarWay way_of(const ViewFrame& frame) {
  RadarWay out{};
  out.per_light = 1.0 / frame.light_speed_mps;
  out.way = out.per_light * frame.radar_mps;
  out.slope = out.per_light * frame.radar_slope_mps;
  out.square = core::dot(out.way, out.way);
  out.per_still = 2.0 / (1.0 - out.square);
  out.way_slope = core::dot(out.way, out.slope);
  out.is_even = core::norm(out.slope - out.way) <= 1e-15;
  return out;
}

// What the echoes of a group of points depend on. The frame is a copy: the compiler could not know that no result is
// written into another, and would compute anew for each vector what all have in common.
struct Scenery {
  const PointArrays& points;
  const CurveTables& curves;
  const AntennaView& antenna;
  bool has_cuts;    // whether the antenna has sin(x)/x cuts,
  bool has_tables;  // and user-defined ones
  ViewFrame frame;
  bool is_upright;  // whether axes of the platform are those of the world
  Axis axis;
  RadarWay way;
};

bool is_identity(const core::Mat3& m) {
  return m.row[0] == core::Vec3{1, 0, 0} && m.row[1] == core::Vec3{0, 1, 0} && m.row[2] == core::Vec3{0, 0, 1};
}

Scenery scenery_of(const PointArrays& points, const ViewFrame& frame, const AntennaView& antenna,
                   const CurveTables& curves) {
  return {points,
          curves,
          antenna,
          antenna.cut != std::array<double, 4>{},
          antenna.curve_cell[0] >= 0.0 || antenna.curve_cell[2] >= 0.0,
          frame,
          is_identity(frame.world_from_platform),
          axis_of(frame),
          way_of(frame)};
}

// The flights of one vector of points.
struct Flights {
  Triple look;          // to the points as they are met
  Vector distance;      // its length
  Vector per_distance;  // 1/distance
  Vector per_ways;      // 1/(way out times way home)
  Vector delay, doppler;
};

// The level part of a vector.
struct Level {
  Vector length;
  Vector inverse;  // 1/length; 0 where there is none
  Mask is_zero;    // shorter than 1e-15 m: rounding leaves that of a vertical vector
};

HWY_INLINE Level level_of(Tag d, const Triple& v) {
  const auto square = hn::MulAdd(v.x, v.x, hn::Mul(v.y, v.y));
  const auto is_zero = hn::Lt(square, hn::Set(d, 1e-30));
  const auto length = hn::Sqrt(square);
  return {length, hn::IfThenZeroElse(is_zero, hn::Div(length, square)), is_zero};
}

// A direction as sines and cosines of its azimuth and elevation; 0 is the azimuth of a vertical one.
struct Angles {
  Vector sine_azimuth, cosine_azimuth, sine_elevation, cosine_elevation;
};

HWY_INLINE Angles angles_of(Tag d, const Triple& v, const Level& level, Vector per_distance) {
  return {hn::Mul(v.x, level.inverse), hn::IfThenElse(level.is_zero, hn::Set(d, 1.0), hn::Mul(v.y, level.inverse)),
          hn::Mul(v.z, per_distance), hn::Mul(level.length, per_distance)};
}

// cos and sin of any angle in radians.
HWY_INLINE void cos_sin(Tag d, Vector radians, Vector& cosine, Vector& sine) {
  const auto turns = hn::Mul(radians, hn::Set(d, 0.15915494309189533577));
  cos_sin_turns(d, fraction_of_turn(turns), cosine, sine);
}

// sin(x)/x for |x| <= pi by its Taylor series, within 4e-16: the terms of even and of odd powers of x^2 apart, as two
// sums that do not wait for each other.
HWY_INLINE Vector main_lobe(Tag d, Vector x) {
  const auto x2 = hn::Mul(x, x);
  const auto x4 = hn::Mul(x2, x2);
  auto even = hn::Set(d, 1.0 / 15511210043330985984000000.0);
  auto odd = hn::Set(d, -1.0 / 10888869450418352160768000000.0);
  even = hn::MulAdd(even, x4, hn::Set(d, 1.0 / 51090942171709440000.0));
  odd = hn::MulAdd(odd, x4, hn::Set(d, -1.0 / 25852016738884976640000.0));
  even = hn::MulAdd(even, x4, hn::Set(d, 1.0 / 355687428096000.0));
  odd = hn::MulAdd(odd, x4, hn::Set(d, -1.0 / 121645100408832000.0));
  even = hn::MulAdd(even, x4, hn::Set(d, 1.0 / 6227020800.0));
  odd = hn::MulAdd(odd, x4, hn::Set(d, -1.0 / 1307674368000.0));
  even = hn::MulAdd(even, x4, hn::Set(d, 1.0 / 362880.0));
  odd = hn::MulAdd(odd, x4, hn::Set(d, -1.0 / 39916800.0));
  even = hn::MulAdd(even, x4, hn::Set(d, 1.0 / 120.0));
  odd = hn::MulAdd(odd, x4, hn::Set(d, -1.0 / 5040.0));
  even = hn::MulAdd(even, x4, hn::Set(d, 1.0));
  odd = hn::MulAdd(odd, x4, hn::Set(d, -1.0 / 6.0));
  return hn::MulAdd(odd, x2, even);
}

// sin(x)/x with x = 2 pi cut sine. What a lane gets does not depend on the others.
HWY_INLINE Vector sinx_cut(Tag d, double cut, Vector sine) {
  const auto turns = hn::Mul(hn::Set(d, cut), sine);
  const auto x = hn::Mul(turns, hn::Set(d, 6.283185307179586476925));
  const auto inside = hn::Le(hn::Abs(turns), hn::Set(d, 0.5));
  const auto lobe = main_lobe(d, x);
  if (hn::AllTrue(d, inside)) return lobe;
  auto c = hn::Zero(d);
  auto s = hn::Zero(d);
  cos_sin_turns(d, fraction_of_turn(turns), c, s);
  return hn::IfThenElse(inside, lobe, hn::Div(s, x));
}

// The sin(x)/x cuts at an offset.
HWY_INLINE Vector sinx_gain(Tag d, const AntennaView& antenna, const Angles& offset) {
  const auto& cut = antenna.cut;
  auto gain = hn::Set(d, 1.0);
  if (cut[0] > 0.0) gain = hn::Mul(gain, sinx_cut(d, cut[0], offset.sine_azimuth));
  if (cut[1] > 0.0) gain = hn::Mul(gain, sinx_cut(d, cut[1], offset.sine_elevation));
  if (cut[2] == cut[0] && cut[3] == cut[1]) {
    gain = antenna.roots ? hn::Abs(gain) : hn::Mul(gain, gain);
  } else {
    if (cut[2] > 0.0) gain = hn::Mul(gain, sinx_cut(d, cut[2], offset.sine_azimuth));
    if (cut[3] > 0.0) gain = hn::Mul(gain, sinx_cut(d, cut[3], offset.sine_elevation));
    if (antenna.roots) gain = hn::Sqrt(hn::Abs(gain));
  }
  // Nothing from offsets that round to 90 degrees, or beyond.
  const auto edge = hn::Set(d, 1.7e-16);
  return hn::IfThenElseZero(hn::And(hn::Gt(offset.cosine_azimuth, edge), hn::Gt(offset.cosine_elevation, edge)), gain);
}

// Sines and cosines of differences between the angles of a direction and those of the axis.
HWY_INLINE Angles less_axis(Tag d, const Angles& a, const Axis& axis) {
  const auto sa = hn::Set(d, axis.sine_azimuth);
  const auto ca = hn::Set(d, axis.cosine_azimuth);
  const auto se = hn::Set(d, axis.sine_elevation);
  const auto ce = hn::Set(d, axis.cosine_elevation);
  return {hn::MulSub(a.sine_azimuth, ca, hn::Mul(a.cosine_azimuth, sa)),
          hn::MulAdd(a.cosine_azimuth, ca, hn::Mul(a.sine_azimuth, sa)),
          hn::MulSub(a.sine_elevation, ce, hn::Mul(a.cosine_elevation, se)),
          hn::MulAdd(a.cosine_elevation, ce, hn::Mul(a.sine_elevation, se))};
}

// The opposite direction has one angle, whatever the sign of a zero or of rounding: half a turn, positive, as
// wrapped_angle has it.
HWY_INLINE Vector opposite_positive(Tag d, Vector degrees) {
  const auto opposite = hn::Le(degrees, hn::Set(d, -180.0 + core::opposite_rad * core::deg_per_rad));
  return hn::IfThenElse(opposite, hn::Set(d, 180.0), degrees);
}

// The user-defined cuts, decibels. In the antenna's frame the magnitudes of the offsets come out at once; tables that
// tell -x from x want their signs as well.
HWY_INLINE Vector user_gain_db(Tag d, const AntennaView& antenna, const ViewFrame& frame, const Triple& v,
                               Vector level) {
  const bool is_signed = antenna.curves.first_deg < 0.0;
  auto azimuth = angle_between(d, hn::Abs(v.x), v.y);
  auto elevation = angle_between(d, hn::Abs(v.z), level);
  if (antenna.offsets == AntennaView::Offsets::antenna_frame) {
    azimuth = degrees(d, azimuth);
    elevation = degrees(d, elevation);
    if (is_signed) {
      azimuth = opposite_positive(d, hn::CopySign(azimuth, v.x));
      elevation = opposite_positive(d, hn::CopySign(elevation, v.z));
    }
  } else {
    azimuth = opposite_positive(
        d, wrapped_degrees(d, hn::Sub(hn::Set(d, frame.axis_azimuth_rad), hn::CopySign(azimuth, v.x))));
    elevation = opposite_positive(
        d, wrapped_degrees(d, hn::Sub(hn::Set(d, frame.axis_elevation_rad), hn::CopySign(elevation, v.z))));
    if (!is_signed) {
      azimuth = hn::Abs(azimuth);
      elevation = hn::Abs(elevation);
    }
  }
  const auto at = [&](std::size_t i, Vector offset) {
    if (antenna.curve_cell[i] < 0.0) return hn::Zero(d);
    return curve_value(d, antenna.curves, hn::Set(d, antenna.curve_cell[i]), offset);
  };
  auto gain = hn::Add(at(0, azimuth), at(1, elevation));
  if (antenna.curve_cell[2] == antenna.curve_cell[0] && antenna.curve_cell[3] == antenna.curve_cell[1])
    return hn::Add(gain, gain);
  return hn::Add(gain, hn::Add(at(2, azimuth), at(3, elevation)));
}

// What the antennas make of an amplitude, and the decibels that are still to be applied.
HWY_INLINE void weigh(Tag d, const Scenery& scenery, const Flights& flight, Vector& amplitude, Vector& decibels) {
  const AntennaView& antenna = scenery.antenna;
  const ViewFrame& frame = scenery.frame;
  if (!scenery.has_cuts && !scenery.has_tables) return;
  const bool world = antenna.offsets == AntennaView::Offsets::world_angles;
  const Triple v = world ? flight.look : turned(d, frame.antenna_from_world, flight.look, core::Vec3{});
  const Level level = level_of(d, v);
  if (scenery.has_cuts) {
    const Angles angles = angles_of(d, v, level, flight.per_distance);
    const Angles offset = world ? less_axis(d, angles, scenery.axis) : angles;
    amplitude = hn::Mul(amplitude, sinx_gain(d, antenna, offset));
  }
  if (scenery.has_tables) decibels = hn::Add(decibels, user_gain_db(d, antenna, frame, v, level.length));
}

template <bool Whole>
HWY_INLINE Triple drawn_position(Tag d, const PointArrays& points, const Points<Whole>& at, std::int64_t pulse,
                                 Triple point) {
  const hn::RebindToUnsigned<Tag> du;
  const PointJitter& jitter = points.jitter;
  auto a = hn::Zero(d);
  auto b = hn::Zero(d);
  if (!jitter.x_stddev_m.empty()) {
    normal_pair(d, at.of(du, jitter.position_key), pulse, 0, a, b);
    point.x = hn::MulAdd(at.of(d, jitter.x_stddev_m), a, point.x);
    point.y = hn::MulAdd(at.of(d, jitter.y_stddev_m), b, point.y);
  }
  if (!jitter.z_stddev_m.empty()) {
    normal_pair(d, at.of(du, jitter.position_key), pulse, 1, a, b);
    point.z = hn::MulAdd(at.of(d, jitter.z_stddev_m), a, point.z);
  }
  return point;
}

template <bool Whole>
HWY_INLINE Vector drawn_root_rcs(Tag d, const PointArrays& points, const Points<Whole>& at, std::int64_t pulse) {
  const PointJitter& jitter = points.jitter;
  if (jitter.rcs_m2.empty()) return at.of(d, points.root_rcs_m);
  const hn::RebindToUnsigned<Tag> du;
  auto a = hn::Zero(d);
  auto b = hn::Zero(d);
  normal_pair(d, at.of(du, jitter.rcs_key), pulse, 0, a, b);
  const auto rcs = hn::MulAdd(at.of(d, jitter.rcs_stddev_m2), a, at.of(d, jitter.rcs_m2));
  return hn::Sqrt(hn::Max(rcs, hn::Zero(d)));
}

template <bool Whole>
HWY_INLINE Triple normals(Tag d, const PointArrays& points, const Points<Whole>& at, std::int64_t pulse) {
  const PointJitter& jitter = points.jitter;
  if (jitter.azimuth_rad.empty())
    return {at.of(d, points.normal_x), at.of(d, points.normal_y), at.of(d, points.normal_z)};
  const hn::RebindToUnsigned<Tag> du;
  auto a = hn::Zero(d);
  auto b = hn::Zero(d);
  normal_pair(d, at.of(du, jitter.pointing_key), pulse, 0, a, b);
  auto ca = hn::Zero(d);
  auto sa = hn::Zero(d);
  auto ce = hn::Zero(d);
  auto se = hn::Zero(d);
  cos_sin(d, hn::MulAdd(at.of(d, jitter.azimuth_stddev_rad), a, at.of(d, jitter.azimuth_rad)), ca, sa);
  cos_sin(d, hn::MulAdd(at.of(d, jitter.elevation_stddev_rad), b, at.of(d, jitter.elevation_rad)), ce, se);
  return {hn::Mul(sa, ce), hn::Mul(ca, ce), se};
}

// What the reflectivity makes of an amplitude, and the decibels that are still to be applied.
template <bool Whole>
HWY_INLINE void reflect(Tag d, const Scenery& scenery, const Points<Whole>& at, const Flights& flight,
                        Vector& amplitude, Vector& decibels) {
  const PointArrays& points = scenery.points;
  const ViewFrame& frame = scenery.frame;
  if (points.law == PointArrays::Law::isotropic) return;
  const Triple of_platform = normals(d, points, at, frame.pulse);
  Triple normal = turned(d, frame.world_from_platform, of_platform, core::Vec3{});
  if (frame.moves) {
    const auto early = hn::MulSub(flight.distance, hn::Set(d, 1.0 / frame.light_speed_mps), hn::Set(d, frame.anchor_s));
    normal = plus(normal, early, turned(d, frame.world_from_platform_rate, of_platform, core::Vec3{}));
  }
  const auto towards = hn::Neg(inner(normal, flight.look));
  if (points.law == PointArrays::Law::cosine) {
    amplitude = hn::Mul(amplitude, hn::Sqrt(hn::Max(hn::Div(towards, flight.distance), hn::Zero(d))));
    return;
  }
  const Triple across = outer(normal, flight.look);
  const auto incidence = angle_between(d, hn::Sqrt(inner(across, across)), towards);
  decibels = hn::Add(decibels, curve_value(d, scenery.curves, at.of(d, points.curve_cell), degrees(d, incidence)));
}

// Where an echo goes and how it is stretched, each for one vector of points.
struct Columns {
  double *delay, *amplitude, *doppler, *bend;

  [[nodiscard]] Columns from(std::size_t i) const {
    return {delay + i, amplitude + i, doppler + i, bend == nullptr ? nullptr : bend + i};
  }
};

// thesis_flight_of, in vectors; a mask of those not near the speed of light.
HWY_INLINE Mask set_thesis_flights(Tag d, const ViewFrame& frame, const Triple& look, const Triple& velocity,
                                   Flights& out) {
  out.look = look;
  const auto distance2 = inner(look, look);
  out.distance = hn::Sqrt(distance2);
  out.per_ways = hn::Div(hn::Set(d, 1.0), distance2);
  out.per_distance = hn::Mul(out.per_ways, out.distance);
  const auto v = hn::Mul(inner(look, velocity), out.per_distance);
  out.delay = hn::Div(hn::Add(out.distance, out.distance), hn::Sub(hn::Set(d, frame.light_speed_mps), v));
  out.doppler = hn::Mul(hn::Add(v, v), hn::Set(d, 1.0 / frame.light_speed_mps));
  return hn::Lt(hn::Abs(v), hn::Set(d, 0.999 * frame.light_speed_mps));
}

// flight_of for points at rest.
HWY_INLINE void set_flights_to_rest(Tag d, const RadarWay& radar, const Triple& look, Flights& out) {
  const auto one = hn::Set(d, 1.0);
  const auto distance2 = inner(look, look);
  out.look = look;
  out.distance = hn::Sqrt(distance2);
  if (radar.square == 0.0) {
    out.per_ways = hn::Div(one, distance2);
    out.per_distance = hn::Mul(out.per_ways, out.distance);
    out.delay = hn::Mul(out.distance, hn::Set(d, 2.0 * radar.per_light));
    out.doppler = hn::Zero(d);
    return;
  }
  const auto along = inner(look, all_lanes(d, radar.way));
  const auto length = hn::Mul(hn::Sub(out.distance, along), hn::Set(d, radar.per_still));
  const auto home = hn::Sub(length, out.distance);
  out.delay = hn::Mul(length, hn::Set(d, radar.per_light));
  if (radar.is_even) {  // D = 1 - d1/d2
    out.per_ways = hn::Div(one, hn::Mul(out.distance, home));
    out.per_distance = hn::Mul(out.per_ways, home);
    out.doppler = hn::Mul(hn::Sub(home, out.distance), hn::Mul(out.per_ways, out.distance));
    return;
  }
  // D = 1 - (1 - u2.w)/(1 - u1.w) is (d1 + d2)(way.w d1 - r1.w)/(d2 (d1 - r1.w)); one division for all.
  const auto out_w = inner(look, all_lanes(d, radar.slope));
  const auto ahead = hn::Sub(out.distance, out_w);
  const auto slower = hn::Mul(length, hn::MulSub(out.distance, hn::Set(d, radar.way_slope), out_w));
  const auto home_ahead = hn::Mul(home, ahead);
  const auto per_all = hn::Div(one, hn::Mul(out.distance, home_ahead));
  out.per_distance = hn::Mul(per_all, home_ahead);
  out.per_ways = hn::Mul(per_all, ahead);
  out.doppler = hn::Mul(slower, hn::Mul(per_all, out.distance));
}

// flight_of, in vectors; a mask of points not near the speed of light.
HWY_INLINE Mask set_flights(Tag d, const RadarWay& radar, double anchor_s, const Triple& look, const Triple& velocity,
                            Flights& out) {
  const auto scale = hn::Set(d, radar.per_light);
  const Triple b{hn::Mul(velocity.x, scale), hn::Mul(velocity.y, scale), hn::Mul(velocity.z, scale)};
  const Triple way = all_lanes(d, radar.way);
  const Triple w = all_lanes(d, radar.slope);
  const Triple r = plus(look, hn::Set(d, -anchor_s), velocity);
  const auto one = hn::Set(d, 1.0);
  const auto rb = inner(r, b);
  const auto b2 = inner(b, b);
  const auto still = hn::Sub(one, b2);
  out.distance = hn::Div(hn::Add(rb, hn::Sqrt(hn::MulAdd(rb, rb, hn::Mul(inner(r, r), still)))), still);
  out.look = plus(r, out.distance, b);
  const auto length = hn::Mul(hn::Sub(out.distance, inner(out.look, way)), hn::Set(d, radar.per_still));
  const auto home = hn::Sub(length, out.distance);
  out.delay = hn::Mul(length, scale);
  const auto out_w_m = inner(out.look, w);
  out.per_distance = hn::Div(one, out.distance);
  const auto per_home = hn::Div(one, home);
  out.per_ways = hn::Mul(out.per_distance, per_home);
  const auto out_b_m = inner(out.look, b);
  const auto out_w = hn::Mul(out_w_m, out.per_distance);
  const auto out_b = hn::Mul(out_b_m, out.per_distance);
  const auto home_w = hn::Mul(hn::MulSub(length, hn::Set(d, radar.way_slope), out_w_m), per_home);
  const auto home_b = hn::Mul(hn::MulSub(length, inner(way, b), out_b_m), per_home);
  const auto sum = hn::Add(hn::Sub(out_b, home_b), hn::Sub(home_w, out_w));
  const auto products = hn::MulSub(out_w, home_b, hn::Mul(out_b, home_w));
  out.doppler = hn::Div(hn::Add(sum, products), hn::Mul(hn::Sub(one, out_w), hn::Sub(one, home_b)));
  return hn::Lt(b2, hn::Set(d, 0.998));
}

// bend_of and bend, in vectors.
HWY_INLINE Vector bent(Tag d, const ViewFrame& frame, const Triple& point, const Triple& velocity, Flights& flight) {
  const auto per_light = hn::Set(d, 1.0 / frame.light_speed_mps);
  const Triple relative = plus(velocity, hn::Set(d, -1.0), all_lanes(d, frame.radar_slope_mps));
  const Triple acceleration = turned(d, frame.world_from_platform_acceleration, point, frame.acceleration_mps2);
  const auto per_distance = flight.per_distance;
  const auto speed = hn::Mul(inner(flight.look, relative), per_distance);
  const auto curvature = hn::NegMulAdd(speed, speed, inner(relative, relative));
  const auto by_point = hn::Mul(inner(flight.look, acceleration), per_distance);
  const auto by_radar = hn::Mul(inner(flight.look, all_lanes(d, frame.radar_mps2)), per_distance);
  const auto second = hn::Add(hn::Mul(curvature, per_distance), hn::Sub(by_point, by_radar));
  const auto early = hn::MulSub(flight.distance, per_light, hn::Set(d, frame.anchor_s));
  const auto late = hn::Sub(flight.delay, hn::Set(d, frame.back_s));
  const auto of_point = hn::Mul(by_point, early);
  const auto of_radar = hn::Mul(by_radar, late);
  const auto longer = hn::MulSub(of_point, early, hn::Mul(hn::Mul(of_radar, hn::Set(d, 0.5)), flight.delay));
  flight.delay = hn::MulAdd(longer, per_light, flight.delay);
  flight.doppler = hn::MulAdd(hn::Sub(hn::Add(of_point, of_point), of_radar), per_light, flight.doppler);
  return hn::Mul(second, hn::Add(per_light, per_light));
}

// Where points are from the radar as it sends.
HWY_INLINE Triple seen_at(Tag d, const Scenery& scenery, const Triple& point) {
  const core::Vec3& origin = scenery.frame.origin_m;
  if (!scenery.is_upright) return turned(d, scenery.frame.world_from_platform, point, origin);
  return {hn::Add(point.x, hn::Set(d, origin.x)), hn::Add(point.y, hn::Set(d, origin.y)),
          hn::Add(point.z, hn::Set(d, origin.z))};
}

// The flights to one vector of points; writes where their echoes go. A mask of points not near the speed of light.
template <bool Plain, bool Whole>
HWY_INLINE Mask set_flights_at(Tag d, const Scenery& scenery, const Points<Whole>& at, const Columns& to,
                               Flights& out) {
  const PointArrays& points = scenery.points;
  const ViewFrame& frame = scenery.frame;
  const Triple point{at.of(d, points.x_m), at.of(d, points.y_m), at.of(d, points.z_m)};
  Mask slow = hn::FirstN(d, hn::Lanes(d));
  if constexpr (Plain) {
    set_flights_to_rest(d, scenery.way, seen_at(d, scenery, point), out);
  } else {
    // Deviations move points, never speeds.
    const bool at_rest = frame.light_time == LightTime::exact && !frame.moves;
    const Triple velocity =
        at_rest && !frame.bends ? Triple{} : turned(d, frame.world_from_platform_rate, point, frame.velocity_mps);
    const Triple seen = seen_at(d, scenery, drawn_position(d, points, at, frame.pulse, point));
    if (frame.light_time == LightTime::thesis)
      slow = set_thesis_flights(d, frame, seen, velocity, out);
    else if (at_rest)
      set_flights_to_rest(d, scenery.way, seen, out);
    else
      slow = set_flights(d, scenery.way, frame.anchor_s, seen, velocity, out);
    if (to.bend != nullptr) at.put(d, frame.bends ? bent(d, frame, point, velocity, out) : hn::Zero(d), to.bend);
  }
  at.put(d, out.delay, to.delay);
  at.put(d, out.doppler, to.doppler);
  return slow;
}

// The echoes of one vector of points; a mask of those that are certain to be possible. Plain: see `is_plain`.
template <bool Plain, bool Whole>
HWY_INLINE Mask echoes_at(const Scenery& scenery, const Points<Whole>& at, const Columns& to) {
  const Tag d;
  const PointArrays& points = scenery.points;
  const ViewFrame& frame = scenery.frame;
  Flights flight;
  const Mask slow = set_flights_at<Plain>(d, scenery, at, to, flight);
  const auto root_rcs = Plain ? at.of(d, points.root_rcs_m) : drawn_root_rcs(d, points, at, frame.pulse);
  auto a = hn::Mul(root_rcs, hn::Set(d, frame.amplitude_scale));
  auto decibels = hn::Zero(d);
  if constexpr (!Plain) reflect(d, scenery, at, flight, a, decibels);
  weigh(d, scenery, flight, a, decibels);
  if (scenery.has_tables || points.law == PointArrays::Law::curve) a = hn::Mul(a, amplitude_of_decibels(d, decibels));
  if (frame.spreading) a = hn::Mul(a, flight.per_ways);
  at.put(d, a, to.amplitude);
  const auto apart = hn::Ge(flight.distance, hn::Set(d, doubtful_distance_m));
  const auto possible = hn::And(apart, hn::Le(hn::Abs(a), hn::Set(d, doubtful_amplitude)));
  return Plain ? possible : hn::And(slow, possible);
}

// The last few points; a function of its own, or the compiler takes its time over the two copies of the geometry.
HWY_NOINLINE Mask rest_at(const Scenery& scenery, const Points<false>& at, const Columns& to) {
  return echoes_at<false>(scenery, at, to);
}

template <bool Plain>
HWY_INLINE Mask whole_vectors_at(const Scenery& scenery, const PointSpan& run, const Columns& to) {
  const Tag d;
  const std::size_t lanes = hn::Lanes(d);
  Mask possible = hn::FirstN(d, lanes);
  for (std::size_t i = run.begin; i + lanes <= run.end; i += lanes)
    possible = hn::And(possible, echoes_at<Plain>(scenery, Points<true>{i, lanes}, to.from(i - run.begin)));
  return possible;
}

// Points at rest that reflect alike in all directions, the same for every pulse: as most are where there are many.
bool is_plain(const PointArrays& points, const ViewFrame& frame, const EchoBatch& echoes) {
  const PointJitter& jitter = points.jitter;
  return frame.light_time == LightTime::exact && !frame.moves && echoes.dilation_rate.empty() &&
         points.law == PointArrays::Law::isotropic && jitter.x_stddev_m.empty() && jitter.z_stddev_m.empty() &&
         jitter.rcs_m2.empty();
}

bool write_on_target(const PointArrays& points, const PointSpan& run, const ViewFrame& frame,
                     const AntennaView& antenna, const CurveTables& curves, EchoBatch& echoes, std::size_t first) {
  const Tag d;
  const Scenery scenery = scenery_of(points, frame, antenna, curves);
  const Columns to{echoes.delay_s.data() + first, echoes.amplitude_sqrt_w.data() + first, echoes.doppler.data() + first,
                   echoes.dilation_rate.empty() ? nullptr : echoes.dilation_rate.data() + first};
  Mask possible = is_plain(points, frame, echoes) ? whole_vectors_at<true>(scenery, run, to)
                                                  : whole_vectors_at<false>(scenery, run, to);
  if (const std::size_t rest = run.size() % hn::Lanes(d); rest > 0) {
    const Scenery copy = scenery;  // since its address is taken
    possible = hn::And(possible, rest_at(copy, {run.end - rest, rest}, to.from(run.size() - rest)));
  }
  return scenery.way.square < 0.998 && hn::AllTrue(d, possible);
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(write_on_target);

bool write_echoes(const PointArrays& points, const PointSpan& run, const ViewFrame& frame, const AntennaView& antenna,
                  const CurveTables& curves, EchoBatch& echoes, std::size_t first) {
  CORE_EXPECT(frame.light_speed_mps > 0.0);
  CORE_EXPECT(run.begin <= run.end && run.end <= points.size());
  CORE_EXPECT(first + run.size() <= echoes.delay_s.size());
  CORE_EXPECT(points.y_m.size() == points.size());
  CORE_EXPECT(points.z_m.size() == points.size());
  CORE_EXPECT(echoes.is_whole());
  return HWY_DYNAMIC_DISPATCH(write_on_target)(points, run, frame, antenna, curves, echoes, first);
}

}  // namespace sarsim::radar

#endif

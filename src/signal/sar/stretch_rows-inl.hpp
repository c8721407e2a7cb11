// Delays and phases of the stretches of a tile, for one pulse; included once per instruction set (Highway's
// foreach_target).

#ifndef SARSIM_SIGNAL_STRETCH_ROWS
#define SARSIM_SIGNAL_STRETCH_ROWS

#include <array>
#include <cmath>
#include <cstdint>

#include "radar/path/path.hpp"
#include "signal/sar/back_projection_kernel.hpp"
#include "signal/sar/projection_point.hpp"

namespace sarsim::signal {

/// How the points of a stretch find their records.
enum class Reach : std::int32_t {
  beside,  ///< No record meets any of them.
  wide,    ///< Each point loads its own.
  narrow,  ///< As many records as a vector has lanes hold them all.
};

/// The polynomials of the stretches of a tile in one column of stretches, one per row, in j = column - middle.
struct StretchRows {
  static constexpr std::size_t rows = ProjectionTile::rows;
  // Half turns: phase0 + phase1 j + phase2 j^2 + phase3 j^3.
  alignas(64) std::array<float, rows> phase0, phase1, phase2, phase3;
  // Records behind the middle between record `base` and the next: record0 + record1 j + scale (phase2 j^2 + phase3
  // j^3).
  alignas(64) std::array<float, rows> record0, record1;
  alignas(64) std::array<std::int32_t, rows> base, reach;
  // Place in the aperture at the beginning, the middle and the end of the stretch.
  alignas(64) std::array<double, rows> place_begin, place_middle, place_end;
};

}  // namespace sarsim::signal

#endif

#if defined(SARSIM_SIGNAL_STRETCH_ROWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SARSIM_SIGNAL_STRETCH_ROWS_INL
#undef SARSIM_SIGNAL_STRETCH_ROWS_INL
#else
#define SARSIM_SIGNAL_STRETCH_ROWS_INL
#endif

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace sarsim::signal::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_HAVE_SCALABLE
using FloatTag = hn::CappedTag<float, 4>;
#else
using FloatTag = hn::CappedTag<float, 16>;
#endif
using FloatVec = hn::Vec<FloatTag>;

using DoubleTag = hn::CappedTag<double, 8>;
using DoubleVec = hn::Vec<DoubleTag>;

struct Vec3Lanes {
  DoubleVec x, y, z;
};

HWY_INLINE DoubleVec dot_lanes(const Vec3Lanes& a, const core::Vec3& b) {
  const DoubleTag d;
  return hn::MulAdd(a.x, hn::Set(d, b.x), hn::MulAdd(a.y, hn::Set(d, b.y), hn::Mul(a.z, hn::Set(d, b.z))));
}

HWY_INLINE Vec3Lanes moved(const Vec3Lanes& a, const core::Vec3& b) {
  const DoubleTag d;
  return {hn::Add(a.x, hn::Set(d, b.x)), hn::Add(a.y, hn::Set(d, b.y)), hn::Add(a.z, hn::Set(d, b.z))};
}

HWY_INLINE DoubleVec length_squared(const Vec3Lanes& a) {
  return hn::MulAdd(a.x, a.x, hn::MulAdd(a.y, a.y, hn::Mul(a.z, a.z)));
}

// What is left of half turns when whole turns are dropped.
HWY_INLINE DoubleVec without_turns(DoubleVec half_turns) {
  const DoubleTag d;
  const DoubleVec turns = hn::Round(hn::Mul(half_turns, hn::Set(d, 0.5)));
  return hn::NegMulAdd(turns, hn::Set(d, 2.0), half_turns);
}

// Where points stand in the aperture of a pulse that flies along `heading`.
HWY_INLINE DoubleVec place_of_points(const Vec3Lanes& r, const core::Vec3& heading, double speed_mps,
                                     const ProjectionAperture& aperture) {
  const DoubleTag d;
  const DoubleVec ahead = dot_lanes(r, heading);
  const DoubleVec squared = length_squared(r);
  if (aperture.kind == ProjectionAperture::Kind::angle) {
    const DoubleVec sine = hn::Div(ahead, hn::Sqrt(squared));
    const DoubleVec angle = hn::Asin(d, hn::Min(hn::Max(sine, hn::Set(d, -1.0)), hn::Set(d, 1.0)));
    return hn::Div(hn::Sub(angle, hn::Set(d, aperture.squint_rad)), hn::Set(d, aperture.extent));
  }
  const DoubleVec aside = hn::Sqrt(hn::Max(hn::NegMulAdd(ahead, ahead, squared), hn::Zero(d)));
  const DoubleVec late = hn::NegMulAdd(hn::Set(d, std::tan(aperture.squint_rad)), aside, ahead);
  return hn::Div(late, hn::Set(d, speed_mps * aperture.extent));
}

HWY_INLINE void store_floats(DoubleVec v, float* HWY_RESTRICT to) {
  const hn::Rebind<float, DoubleTag> floats;
  hn::StoreU(hn::DemoteTo(floats, v), floats, to);
}

HWY_INLINE void store_integers(DoubleVec v, std::int32_t* HWY_RESTRICT to) {
  const hn::Rebind<std::int32_t, DoubleTag> integers;
  hn::StoreU(hn::DemoteTo(integers, v), integers, to);
}

// Where the records of stretches begin and how far they reach: `most` to either side of `record`.
HWY_INLINE void store_reach(DoubleVec record, DoubleVec most, const ProjectionConstants& constants, std::size_t row,
                            StretchRows& out) {
  constexpr double rounding = 1e-3;
  const DoubleTag d;
  const auto lanes = static_cast<double>(hn::Lanes(FloatTag()));
  const double last = static_cast<double>(constants.record_count) - 1.0;
  const DoubleVec low = hn::Sub(record, most);
  const DoubleVec high = hn::Add(record, most);
  const DoubleVec zero = hn::Zero(d);
  const auto beside = hn::Or(hn::Lt(high, zero), hn::Gt(low, hn::Set(d, last)));
  // A window of records begins below the lowest, but so that it ends with the last one there is.
  const DoubleVec window = hn::Min(hn::Floor(hn::Sub(low, hn::Set(d, rounding))), hn::Set(d, last - lanes));
  const auto within = hn::And(hn::Ge(window, zero), hn::Le(high, hn::Set(d, last - rounding)));
  const double widest = lanes < 8.0 ? 0.0 : lanes - rounding;
  const auto narrow = hn::And(within, hn::Lt(hn::Sub(high, window), hn::Set(d, widest)));
  const DoubleVec nearest = hn::Floor(hn::Min(hn::Max(record, zero), hn::Set(d, last)));
  const DoubleVec base = hn::IfThenElse(narrow, window, nearest);
  const DoubleVec wide = hn::IfThenElse(beside, zero, hn::Set(d, static_cast<double>(Reach::wide)));
  const DoubleVec reach = hn::IfThenElse(narrow, hn::Set(d, static_cast<double>(Reach::narrow)), wide);
  store_integers(base, out.base.data() + row);
  store_integers(reach, out.reach.data() + row);
  store_floats(hn::Sub(hn::Sub(record, base), hn::Set(d, 0.5)), out.record0.data() + row);
}

// first + a i + q i^2/2 + s i^3/6 of one coordinate.
HWY_INLINE DoubleVec cubic_of(DoubleVec i, double first, double a, double q, double s) {
  const DoubleTag d;
  const DoubleVec bend = hn::MulAdd(i, hn::Set(d, s / 6.0), hn::Set(d, 0.5 * q));
  return hn::MulAdd(hn::MulAdd(bend, i, hn::Set(d, a)), i, hn::Set(d, first));
}

// The points of rows from that of row 0.
HWY_INLINE Vec3Lanes row_points(DoubleVec i, const core::Vec3& first, const ProjectionTile& tile) {
  const core::Vec3& a = tile.row_step_m;
  const core::Vec3& q = tile.row_bend_m;
  const core::Vec3& s = tile.row_twist_m;
  return {cubic_of(i, first.x, a.x, q.x, s.x), cubic_of(i, first.y, a.y, q.y, s.y),
          cubic_of(i, first.z, a.z, q.z, s.z)};
}

// How the points of a column go on from its middle: step, bend and twist there.
struct ColumnShape {
  core::Vec3 step_m, bend_m, twist_m;
  bool bent;
};

HWY_INLINE ColumnShape shape_of(const ProjectionTile& tile, double middle) {
  const core::Vec3 twist_m = tile.column_twist_m;
  const core::Vec3 bend_m = tile.column_bend_m + middle * twist_m;
  const core::Vec3 step_m = tile.column_step_m + middle * tile.column_bend_m + (0.5 * middle * middle) * twist_m;
  return {step_m, bend_m, twist_m, core::dot(bend_m, bend_m) + core::dot(twist_m, twist_m) > 0.0};
}

// Powers of j in a quantity along a stretch.
struct DistanceTerms {
  DoubleVec first, step, bend, twist;
};
struct MotionTerms {
  DoubleVec away, away_step;  // the speed at which points recede
  DoubleVec ahead;            // r.V/c
};

HWY_INLINE DistanceTerms distances_of(const Vec3Lanes& r, const ColumnShape& shape) {
  const DoubleTag d;
  const DoubleVec distance = hn::Sqrt(length_squared(r));
  const DoubleVec inverse = hn::Div(hn::Set(d, 1.0), distance);
  const DoubleVec half_inverse = hn::Mul(inverse, hn::Set(d, 0.5));
  const DoubleVec u = hn::Mul(dot_lanes(r, shape.step_m), inverse);
  const DoubleVec b2 = hn::Set(d, core::dot(shape.step_m, shape.step_m));
  const DoubleVec second = shape.bent ? hn::Add(b2, dot_lanes(r, shape.bend_m)) : b2;
  const DoubleVec bend = hn::Mul(hn::NegMulAdd(u, u, second), half_inverse);
  DoubleVec twist = hn::Neg(hn::Mul(hn::Mul(u, bend), inverse));
  if (shape.bent) {
    const DoubleVec third = hn::MulAdd(dot_lanes(r, shape.twist_m), hn::Set(d, 1.0 / 3.0),
                                       hn::Set(d, core::dot(shape.step_m, shape.bend_m)));
    twist = hn::MulAdd(third, half_inverse, twist);
  }
  return {distance, u, bend, twist};
}

// Half the sum of both ways.
HWY_INLINE DistanceTerms mean_of(const DistanceTerms& a, const DistanceTerms& b) {
  const DoubleTag d;
  const DoubleVec half = hn::Set(d, 0.5);
  const auto mean = [&](DoubleVec x, DoubleVec y) { return hn::Mul(half, hn::Add(x, y)); };
  return {mean(a.first, b.first), mean(a.step, b.step), mean(a.bend, b.bend), mean(a.twist, b.twist)};
}

HWY_INLINE MotionTerms motion_of(const Vec3Lanes& r, const DistanceTerms& distance, const core::Vec3& step_m,
                                 const ProjectionPulse& pulse, const ProjectionConstants& constants) {
  const DoubleTag d;
  const DoubleVec zero = hn::Zero(d);
  if (!constants.moving) return {zero, zero, zero};
  const DoubleVec inverse = hn::Div(hn::Set(d, 1.0), distance.first);
  const DoubleVec along = dot_lanes(r, pulse.velocity_mps);
  const DoubleVec away = hn::Neg(hn::Mul(along, inverse));
  const DoubleVec turned = hn::MulAdd(away, distance.step, hn::Set(d, core::dot(pulse.velocity_mps, step_m)));
  return {away, hn::Neg(hn::Mul(turned, inverse)), hn::Mul(along, hn::Set(d, 1.0 / constants.light_speed_mps))};
}

// Phases in half turns and records of rows from `row` on.
HWY_INLINE void store_terms(const DistanceTerms& distance, const MotionTerms& motion, const ColumnShape& shape,
                            const ProjectionPulse& pulse, const ProjectionConstants& constants, std::size_t row,
                            double half, StretchRows& out) {
  const DoubleTag d;
  const double c = constants.light_speed_mps;
  const double carrier_hz = pulse.carrier_of(constants);
  const double ahead1 = constants.moving ? core::dot(pulse.velocity_mps, shape.step_m) / c : 0.0;
  const double ahead2 = constants.moving ? 0.5 * core::dot(pulse.velocity_mps, shape.bend_m) / c : 0.0;
  const DoubleVec slowness = hn::Set(d, slowness_of(pulse, constants));
  const DoubleVec delay = hn::Mul(hn::Sub(distance.first, motion.ahead), slowness);
  const DoubleVec delay1 = hn::Mul(slowness, hn::Sub(distance.step, hn::Set(d, ahead1)));
  const DoubleVec doppler_scale = hn::Set(d, -radar::turns_per_m(carrier_hz, c));
  const DoubleVec fd = hn::Mul(doppler_scale, motion.away);
  const DoubleVec inverse_rate = hn::Set(d, constants.doppler_delay_s2);
  const DoubleVec early = hn::Mul(fd, inverse_rate);
  const DoubleVec early1 = hn::Mul(hn::Mul(doppler_scale, motion.away_step), inverse_rate);
  const DoubleVec two_f = hn::Set(d, 2.0 * carrier_hz);
  const DoubleVec per_bend = hn::Mul(two_f, slowness);
  const DoubleVec half_turns2 = hn::Mul(per_bend, hn::Sub(distance.bend, hn::Set(d, ahead2)));
  const DoubleVec half_turns3 = hn::Mul(per_bend, distance.twist);
  store_floats(without_turns(hn::MulAdd(two_f, delay, hn::Mul(fd, early))), out.phase0.data() + row);
  store_floats(without_turns(hn::MulAdd(two_f, delay1, hn::Mul(hn::Add(fd, fd), early1))), out.phase1.data() + row);
  store_floats(half_turns2, out.phase2.data() + row);
  store_floats(half_turns3, out.phase3.data() + row);
  const DoubleVec rate = hn::Set(d, constants.records_per_s);
  const DoubleVec from_first = hn::Sub(hn::Sub(delay, early), hn::Set(d, constants.first_delay_s + pulse.later_s));
  const DoubleVec record1 = hn::Mul(hn::Sub(delay1, early1), rate);
  const DoubleVec bent_records = hn::MulAdd(hn::Abs(half_turns3), hn::Set(d, half), hn::Abs(half_turns2));
  const double scale = half * half * constants.records_per_s / (2.0 * carrier_hz);
  const DoubleVec most = hn::MulAdd(hn::Abs(record1), hn::Set(d, half), hn::Mul(bent_records, hn::Set(d, scale)));
  store_floats(record1, out.record1.data() + row);
  store_reach(hn::Mul(from_first, rate), most, constants, row, out);
}

// The stretches of all rows about the column `middle`, for one pulse. With r from the antenna to the point in the
// middle, b the step of a column, u = r.b/d and v the speed at which the point recedes,
//
//     d(j) = d + u j + e j^2 + (g/(2 d) - u e/d) j^3 + ...,      e = (b^2 + r.q - u^2)/(2 d),  g = b.q + r.s/3,
//     v'(j) = (-V.b - v u)/d,     tau(j) = k (d(j) - r(j).V/c),
//
// q and s the bend and the twist of the columns there.
void expand_rows(const ProjectionPulse& pulse, const ProjectionConstants& constants, const ProjectionAperture& aperture,
                 const ProjectionTile& tile, double middle, double half, StretchRows& out) {
  const DoubleTag d;
  const ColumnShape shape = shape_of(tile, middle);
  const double speed_mps = core::norm(pulse.velocity_mps);
  const core::Vec3 heading = heading_of(pulse, aperture);
  const core::Vec3 first = tile.point_m(0.0, middle) - pulse.position_m;
  for (std::size_t row = 0; row < ProjectionTile::rows; row += hn::Lanes(d)) {
    const Vec3Lanes r = row_points(hn::Iota(d, static_cast<double>(row)), first, tile);
    DistanceTerms distance = distances_of(r, shape);
    if (pulse.bistatic)
      distance = mean_of(distance, distances_of(moved(r, pulse.position_m - pulse.receiver_m), shape));
    const MotionTerms motion = motion_of(r, distance, shape.step_m, pulse, constants);
    store_terms(distance, motion, shape, pulse, constants, row, half, out);
    if (aperture.kind == ProjectionAperture::Kind::all) continue;
    const core::Vec3 to_end_m = half * shape.step_m;
    hn::Store(place_of_points(moved(r, -1.0 * to_end_m), heading, speed_mps, aperture), d,
              out.place_begin.data() + row);
    hn::Store(place_of_points(r, heading, speed_mps, aperture), d, out.place_middle.data() + row);
    hn::Store(place_of_points(moved(r, to_end_m), heading, speed_mps, aperture), d, out.place_end.data() + row);
  }
}

}  // namespace sarsim::signal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Delays and phases of the stretches of a tile, for one pulse; included once per instruction set (Highway's
// foreach_target).

#ifndef SARSIM_SIGNAL_STRETCH_ROWS
#define SARSIM_SIGNAL_STRETCH_ROWS

#include <array>
#include <cmath>
#include <cstdint>

#include "radar/path/path.hpp"
#include "signal/sar/projection_point.hpp"
#include "signal/sar/projection_tile.hpp"

namespace sarsim::signal {

/// How the points of a stretch find their records.
enum class Reach : std::int32_t {
  beside,  ///< No record meets any of them.
  wide,    ///< Each point loads its own.
  narrow,  ///< As many records as a vector has lanes hold them all.
};

/// The polynomials of the stretches of a tile in one column of stretches, one per row, in j = column - middle.
struct ResampleRows {
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

/// A vector for each row.
struct RowVectors {
  alignas(64) std::array<double, ProjectionTile::rows> x, y, z;
};

/// How the points of a stretch on a curved surface go on from its middle, row by row: place, step, bend and twist there
/// (the derivatives by the column).
struct RowShapes {
  RowVectors place_m, step_m, bend_m, twist_m;
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

HWY_INLINE DoubleVec dot_lanes(const Vec3Lanes& a, const Vec3Lanes& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
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
                            ResampleRows& out) {
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

// a + b i + c i^2 + e i^3 of one coordinate.
HWY_INLINE DoubleVec cubic_of(DoubleVec i, double a, double b, double c, double e) {
  const DoubleTag d;
  const DoubleVec bend = hn::MulAdd(i, hn::Set(d, e), hn::Set(d, c));
  return hn::MulAdd(hn::MulAdd(bend, i, hn::Set(d, b)), i, hn::Set(d, a));
}

// The derivatives by the column, of order `b`, for all rows.
HWY_INLINE void fill_rows(const StretchSurface& surface, std::size_t b, double factorial, RowVectors& out) {
  const DoubleTag d;
  const auto& t = surface.terms;
  const DoubleVec times = hn::Set(d, factorial);
  for (std::size_t row = 0; row < ProjectionTile::rows; row += hn::Lanes(d)) {
    const DoubleVec i = hn::Iota(d, static_cast<double>(row) - StretchSurface::middle_row);
    hn::Store(hn::Mul(times, cubic_of(i, t[0][b].x, t[1][b].x, t[2][b].x, t[3][b].x)), d, out.x.data() + row);
    hn::Store(hn::Mul(times, cubic_of(i, t[0][b].y, t[1][b].y, t[2][b].y, t[3][b].y)), d, out.y.data() + row);
    hn::Store(hn::Mul(times, cubic_of(i, t[0][b].z, t[1][b].z, t[2][b].z, t[3][b].z)), d, out.z.data() + row);
  }
}

HWY_INLINE void fill_shapes(const StretchSurface& surface, RowShapes& out) {
  fill_rows(surface, 0, 1.0, out.place_m);
  fill_rows(surface, 1, 1.0, out.step_m);
  fill_rows(surface, 2, 2.0, out.bend_m);
  fill_rows(surface, 3, 6.0, out.twist_m);
}

HWY_INLINE Vec3Lanes load_rows(const RowVectors& v, std::size_t row) {
  const DoubleTag d;
  return {hn::Load(d, v.x.data() + row), hn::Load(d, v.y.data() + row), hn::Load(d, v.z.data() + row)};
}

HWY_INLINE Vec3Lanes same_for_all(const core::Vec3& v) {
  const DoubleTag d;
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

// Points of rows from an antenna, and how their columns go on.
struct ShapeLanes {
  Vec3Lanes r, step, bend, twist;
};

template <bool curved>
HWY_INLINE ShapeLanes shape_lanes(const ProjectionTile& tile, const RowShapes* shapes, const core::Vec3& first,
                                  const core::Vec3& antenna_m, std::size_t row) {
  if constexpr (curved)
    return {moved(load_rows(shapes->place_m, row), -1.0 * antenna_m), load_rows(shapes->step_m, row),
            load_rows(shapes->bend_m, row), load_rows(shapes->twist_m, row)};
  const DoubleTag d;
  const DoubleVec i = hn::Iota(d, static_cast<double>(row));
  const core::Vec3& a = tile.row_step_m;
  const Vec3Lanes r{hn::MulAdd(i, hn::Set(d, a.x), hn::Set(d, first.x)),
                    hn::MulAdd(i, hn::Set(d, a.y), hn::Set(d, first.y)),
                    hn::MulAdd(i, hn::Set(d, a.z), hn::Set(d, first.z))};
  const Vec3Lanes zero = same_for_all({});
  return {r, same_for_all(tile.column_step_m), zero, zero};
}

// Powers of j in a quantity along a stretch.
struct DistanceTerms {
  DoubleVec first, step, bend, twist;
};
struct MotionTerms {
  DoubleVec away, away_step;  // the speed at which points recede
  DoubleVec ahead;            // r.V/c
};

template <bool curved>
HWY_INLINE DistanceTerms distances_of(const Vec3Lanes& r, const ShapeLanes& shape) {
  const DoubleTag d;
  const DoubleVec distance = hn::Sqrt(length_squared(r));
  const DoubleVec inverse = hn::Div(hn::Set(d, 1.0), distance);
  const DoubleVec half_inverse = hn::Mul(inverse, hn::Set(d, 0.5));
  const DoubleVec u = hn::Mul(dot_lanes(r, shape.step), inverse);
  const DoubleVec b2 = length_squared(shape.step);
  const DoubleVec second = curved ? hn::Add(b2, dot_lanes(r, shape.bend)) : b2;
  const DoubleVec bend = hn::Mul(hn::NegMulAdd(u, u, second), half_inverse);
  DoubleVec twist = hn::Neg(hn::Mul(hn::Mul(u, bend), inverse));
  if constexpr (curved) {
    const DoubleVec third =
        hn::MulAdd(dot_lanes(r, shape.twist), hn::Set(d, 1.0 / 3.0), dot_lanes(shape.step, shape.bend));
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

HWY_INLINE MotionTerms motion_of(const ShapeLanes& shape, const DistanceTerms& distance, const ProjectionPulse& pulse,
                                 const ProjectionConstants& constants) {
  const DoubleTag d;
  const DoubleVec zero = hn::Zero(d);
  if (!constants.moving) return {zero, zero, zero};
  const DoubleVec inverse = hn::Div(hn::Set(d, 1.0), distance.first);
  const DoubleVec along = dot_lanes(shape.r, pulse.velocity_mps);
  const DoubleVec away = hn::Neg(hn::Mul(along, inverse));
  const DoubleVec turned = hn::MulAdd(away, distance.step, dot_lanes(shape.step, pulse.velocity_mps));
  return {away, hn::Neg(hn::Mul(turned, inverse)), hn::Mul(along, hn::Set(d, 1.0 / constants.light_speed_mps))};
}

// Phases in half turns and records of rows from `row` on.
template <bool curved>
HWY_INLINE void store_terms(const DistanceTerms& distance, const MotionTerms& motion, const ShapeLanes& shape,
                            const ProjectionPulse& pulse, const ProjectionConstants& constants, std::size_t row,
                            double half, ResampleRows& out) {
  const DoubleTag d;
  const double c = constants.light_speed_mps;
  const double carrier_hz = pulse.carrier_of(constants);
  const double per_speed = constants.moving ? 1.0 / c : 0.0;
  const DoubleVec ahead1 = hn::Mul(hn::Set(d, per_speed), dot_lanes(shape.step, pulse.velocity_mps));
  const DoubleVec slowness = hn::Set(d, slowness_of(pulse, constants));
  const DoubleVec delay = hn::Mul(hn::Sub(distance.first, motion.ahead), slowness);
  const DoubleVec delay1 = hn::Mul(slowness, hn::Sub(distance.step, ahead1));
  const DoubleVec doppler_scale = hn::Set(d, -radar::turns_per_m(carrier_hz, c));
  const DoubleVec fd = hn::Mul(doppler_scale, motion.away);
  const DoubleVec inverse_rate = hn::Set(d, constants.doppler_delay_s2);
  const DoubleVec early = hn::Mul(fd, inverse_rate);
  const DoubleVec early1 = hn::Mul(hn::Mul(doppler_scale, motion.away_step), inverse_rate);
  const DoubleVec two_f = hn::Set(d, 2.0 * carrier_hz);
  const DoubleVec per_bend = hn::Mul(two_f, slowness);
  DoubleVec bend = distance.bend;
  if constexpr (curved)
    bend = hn::NegMulAdd(hn::Set(d, 0.5 * per_speed), dot_lanes(shape.bend, pulse.velocity_mps), bend);
  const DoubleVec half_turns2 = hn::Mul(per_bend, bend);
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
// @param shapes  of the stretches on a curved surface
template <bool curved>
void expand_rows(const ProjectionPulse& pulse, const ProjectionConstants& constants, const ProjectionAperture& aperture,
                 const ProjectionTile& tile, const RowShapes* shapes, double middle, double half, ResampleRows& out) {
  const DoubleTag d;
  const double speed_mps = core::norm(pulse.velocity_mps);
  const core::Vec3 heading = heading_of(pulse, aperture);
  const core::Vec3 first = tile.corner_m + middle * tile.column_step_m - pulse.position_m;
  const DoubleVec to_end = hn::Set(d, half);
  for (std::size_t row = 0; row < ProjectionTile::rows; row += hn::Lanes(d)) {
    const ShapeLanes shape = shape_lanes<curved>(tile, shapes, first, pulse.position_m, row);
    const Vec3Lanes& r = shape.r;
    DistanceTerms distance = distances_of<curved>(r, shape);
    if (pulse.bistatic)
      distance = mean_of(distance, distances_of<curved>(moved(r, pulse.position_m - pulse.receiver_m), shape));
    const MotionTerms motion = motion_of(shape, distance, pulse, constants);
    store_terms<curved>(distance, motion, shape, pulse, constants, row, half, out);
    if (aperture.kind == ProjectionAperture::Kind::all) continue;
    const Vec3Lanes& b = shape.step;
    const Vec3Lanes begin{hn::NegMulAdd(to_end, b.x, r.x), hn::NegMulAdd(to_end, b.y, r.y),
                          hn::NegMulAdd(to_end, b.z, r.z)};
    const Vec3Lanes end{hn::MulAdd(to_end, b.x, r.x), hn::MulAdd(to_end, b.y, r.y), hn::MulAdd(to_end, b.z, r.z)};
    hn::Store(place_of_points(begin, heading, speed_mps, aperture), d, out.place_begin.data() + row);
    hn::Store(place_of_points(r, heading, speed_mps, aperture), d, out.place_middle.data() + row);
    hn::Store(place_of_points(end, heading, speed_mps, aperture), d, out.place_end.data() + row);
  }
}

}  // namespace sarsim::signal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

#include "signal/sar/back_projection_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "signal/sar/back_projection_kernel.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#ifndef SARSIM_BACK_PROJECTION_STRETCHES
#define SARSIM_BACK_PROJECTION_STRETCHES
namespace sarsim::signal {

/// The polynomials of the stretches of a tile in one column of stretches, one per row, in j = column - middle.
struct StretchRows {
  static constexpr std::size_t rows = ProjectionTile::rows;
  // Half turns: phase0 + phase1 j + phase2 j^2 + phase3 j^3.
  alignas(64) std::array<double, rows> phase0, phase1, phase2, phase3;
  // Records: record0 + record1 j + scale (phase2 j^2 + phase3 j^3).
  alignas(64) std::array<double, rows> record0, record1;
  // Place in the aperture at the beginning, the middle and the end of the stretch.
  alignas(64) std::array<double, rows> place_begin, place_middle, place_end;
};

/// Where the aperture counts angles from.
inline core::Vec3 heading_of(const ProjectionPulse& pulse, const ProjectionAperture& aperture) {
  if (core::dot(aperture.heading, aperture.heading) > 0.0) return aperture.heading;
  const double speed_mps = core::norm(pulse.velocity_mps);
  return speed_mps > 0.0 ? (1.0 / speed_mps) * pulse.velocity_mps : core::Vec3{};
}

/// k of tau = k (d - r.V/c): 2/c, and 1/(1 - V^2/c^2) of that where the antenna flies on while the echo is under way.
inline double slowness_of(const ProjectionPulse& pulse, const ProjectionConstants& constants) {
  const double c = constants.light_speed_mps;
  const double v2 = constants.moving ? core::dot(pulse.velocity_mps, pulse.velocity_mps) : 0.0;
  return 2.0 / c / (1.0 - v2 / (c * c));
}

}  // namespace sarsim::signal
#endif

HWY_BEFORE_NAMESPACE();
namespace sarsim::signal::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_HAVE_SCALABLE
using FloatTag = hn::CappedTag<float, 4>;
#else
using FloatTag = hn::CappedTag<float, 16>;
#endif
using FloatVec = hn::Vec<FloatTag>;

struct Quad {
  FloatVec re, im, step_re, step_im;
};

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Quad load_records(const float* base, const std::int32_t* HWY_RESTRICT at) {
  const FloatTag d;
  const float* record = base + at[0];
  return {hn::Set(d, record[0]), hn::Set(d, record[1]), hn::Set(d, record[2]), hn::Set(d, record[3])};
}
#else
// Four floats from each of `base + at[0]`, `base + at[4]`, ...: one after the other, as many as a vector has room for.
template <class D>
HWY_INLINE hn::Vec<D> every_fourth(D d, const float* base, const std::int32_t* HWY_RESTRICT at) {
  if constexpr (hn::MaxLanes(D()) > 4) {
    const hn::Half<D> half;
    return hn::Combine(d, every_fourth(half, base, at + hn::MaxLanes(half)), every_fourth(half, base, at));
  } else {
    return hn::LoadU(d, base + at[0]);
  }
}

// Lane l of the result is what stands at `base + at[l]`: four floats in a row, transposed.
HWY_INLINE Quad load_records(const float* base, const std::int32_t* HWY_RESTRICT at) {
  const FloatTag d;
  const hn::RepartitionToWide<FloatTag> wide;
  const FloatVec a = every_fourth(d, base, at), b = every_fourth(d, base, at + 1);
  const FloatVec c = every_fourth(d, base, at + 2), e = every_fourth(d, base, at + 3);
  const auto low01 = hn::BitCast(wide, hn::InterleaveLower(d, a, b));
  const auto low23 = hn::BitCast(wide, hn::InterleaveLower(d, c, e));
  const auto high01 = hn::BitCast(wide, hn::InterleaveUpper(d, a, b));
  const auto high23 = hn::BitCast(wide, hn::InterleaveUpper(d, c, e));
  return {hn::BitCast(d, hn::InterleaveLower(wide, low01, low23)),
          hn::BitCast(d, hn::InterleaveUpper(wide, low01, low23)),
          hn::BitCast(d, hn::InterleaveLower(wide, high01, high23)),
          hn::BitCast(d, hn::InterleaveUpper(wide, high01, high23))};
}
#endif

// cos and sin of pi x, any x: half turns are taken out and come back as a sign. The polynomials are best in the sense
// of Chebyshev on |x| <= 1/2: within 7e-7.
HWY_INLINE void cos_sin_half_turns(FloatVec x, FloatVec& cosine, FloatVec& sine) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  const FloatVec whole = hn::Round(x);
  const FloatVec r = hn::Sub(x, whole);
  const auto sign = hn::BitCast(d, hn::ShiftLeft<31>(hn::ConvertTo(di, whole)));
  const FloatVec r2 = hn::Mul(r, r);
  FloatVec c = hn::Set(d, 0.21969674F);
  c = hn::MulAdd(c, r2, hn::Set(d, -1.3318801F));
  c = hn::MulAdd(c, r2, hn::Set(d, 4.0584119F));
  c = hn::MulAdd(c, r2, hn::Set(d, -4.9347929F));
  c = hn::MulAdd(c, r2, hn::Set(d, 0.99999995F));
  FloatVec s = hn::Set(d, -0.55463620F);
  s = hn::MulAdd(s, r2, hn::Set(d, 2.5418990F));
  s = hn::MulAdd(s, r2, hn::Set(d, -5.1671428F));
  s = hn::MulAdd(s, r2, hn::Set(d, 3.1415820F));
  cosine = hn::Xor(c, sign);
  sine = hn::Xor(hn::Mul(s, r), sign);
}

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
  const core::Vec3 s = tile.column_twist_m;
  const core::Vec3 q = tile.column_bend_m + middle * s;
  const core::Vec3 b = tile.column_step_m + middle * tile.column_bend_m + (0.5 * middle * middle) * s;
  const bool bent = core::dot(q, q) + core::dot(s, s) > 0.0;
  const DoubleVec b2 = hn::Set(d, core::dot(b, b));
  const double ahead1 = constants.moving ? core::dot(pulse.velocity_mps, b) / constants.light_speed_mps : 0.0;
  const double ahead2 = constants.moving ? 0.5 * core::dot(pulse.velocity_mps, q) / constants.light_speed_mps : 0.0;
  const DoubleVec f = hn::Set(d, pulse.carrier_of(constants));
  const double speed_mps = core::norm(pulse.velocity_mps);
  const core::Vec3 heading = heading_of(pulse, aperture);
  const core::Vec3 first = tile.point_m(0.0, middle) - pulse.position_m;
  const core::Vec3 a = tile.row_step_m;
  for (std::size_t row = 0; row < ProjectionTile::rows; row += hn::Lanes(d)) {
    const DoubleVec i = hn::Iota(d, static_cast<double>(row));
    const Vec3Lanes r{hn::MulAdd(i, hn::Set(d, a.x), hn::Set(d, first.x)),
                      hn::MulAdd(i, hn::Set(d, a.y), hn::Set(d, first.y)),
                      hn::MulAdd(i, hn::Set(d, a.z), hn::Set(d, first.z))};
    const DoubleVec distance = hn::Sqrt(length_squared(r));
    const DoubleVec inverse = hn::Div(hn::Set(d, 1.0), distance);
    const DoubleVec u = hn::Mul(dot_lanes(r, b), inverse);
    const DoubleVec half_inverse = hn::Mul(inverse, hn::Set(d, 0.5));
    const DoubleVec second = bent ? hn::Add(b2, dot_lanes(r, q)) : b2;
    const DoubleVec bend = hn::Mul(hn::NegMulAdd(u, u, second), half_inverse);
    DoubleVec twist = hn::Neg(hn::Mul(hn::Mul(u, bend), inverse));
    if (bent) {
      const DoubleVec third = hn::MulAdd(dot_lanes(r, s), hn::Set(d, 1.0 / 3.0), hn::Set(d, core::dot(b, q)));
      twist = hn::MulAdd(third, half_inverse, twist);
    }
    DoubleVec v = hn::Zero(d);
    DoubleVec v1 = hn::Zero(d);
    DoubleVec ahead = hn::Zero(d);  // r.V/c
    if (constants.moving) {
      const DoubleVec along = dot_lanes(r, pulse.velocity_mps);
      v = hn::Neg(hn::Mul(along, inverse));
      v1 = hn::Neg(hn::Mul(hn::MulAdd(v, u, hn::Set(d, core::dot(pulse.velocity_mps, b))), inverse));
      ahead = hn::Mul(along, hn::Set(d, 1.0 / constants.light_speed_mps));
    }
    const DoubleVec slowness = hn::Set(d, slowness_of(pulse, constants));
    const DoubleVec delay = hn::Mul(hn::Sub(distance, ahead), slowness);
    const DoubleVec delay1 = hn::Mul(slowness, hn::Sub(u, hn::Set(d, ahead1)));
    const DoubleVec doppler_scale =
        hn::Set(d, -radar::turns_per_m(pulse.carrier_of(constants), constants.light_speed_mps));
    const DoubleVec fd = hn::Mul(doppler_scale, v);
    const DoubleVec fd1 = hn::Mul(doppler_scale, v1);
    const DoubleVec inverse_rate = hn::Set(d, constants.doppler_delay_s2);
    const DoubleVec early = hn::Mul(fd, inverse_rate);
    const DoubleVec early1 = hn::Mul(fd1, inverse_rate);
    const DoubleVec two_f = hn::Add(f, f);
    const DoubleVec half_turns = hn::MulAdd(two_f, delay, hn::Mul(fd, early));
    const DoubleVec half_turns1 = hn::MulAdd(two_f, delay1, hn::Mul(hn::Add(fd, fd), early1));
    hn::Store(without_turns(half_turns), d, out.phase0.data() + row);
    hn::Store(without_turns(half_turns1), d, out.phase1.data() + row);
    hn::Store(hn::Mul(hn::Mul(two_f, slowness), hn::Sub(bend, hn::Set(d, ahead2))), d, out.phase2.data() + row);
    hn::Store(hn::Mul(hn::Mul(two_f, slowness), twist), d, out.phase3.data() + row);
    const DoubleVec rate = hn::Set(d, constants.records_per_s);
    const DoubleVec from_first = hn::Sub(hn::Sub(delay, early), hn::Set(d, constants.first_delay_s));
    hn::Store(hn::Mul(from_first, rate), d, out.record0.data() + row);
    hn::Store(hn::Mul(hn::Sub(delay1, early1), rate), d, out.record1.data() + row);
    if (aperture.kind == ProjectionAperture::Kind::all) continue;
    hn::Store(place_of_points(moved(r, -half * b), heading, speed_mps, aperture), d, out.place_begin.data() + row);
    hn::Store(place_of_points(r, heading, speed_mps, aperture), d, out.place_middle.data() + row);
    hn::Store(place_of_points(moved(r, half * b), heading, speed_mps, aperture), d, out.place_end.data() + row);
  }
}

// How the points of a stretch are weighted.
enum class Weighting { none, ones, cut, table };

struct StretchTerms {
  float phase0, phase1, phase2, phase3;
  float record0, record1, record_scale;
  float lowest, highest;  // of the record, relative to the base
  float place0, place1, place2;
  const float* base;
  const float* weights;
};

HWY_INLINE FloatVec weight_at(FloatVec j, const StretchTerms& t, bool table) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  const FloatVec place = hn::MulAdd(hn::MulAdd(hn::Set(d, t.place2), j, hn::Set(d, t.place1)), j, hn::Set(d, t.place0));
  const auto inside = hn::Le(hn::Abs(place), hn::Set(d, 0.5F));
  if (!table) return hn::IfThenElseZero(inside, hn::Set(d, 1.0F));
  constexpr auto pieces = static_cast<float>(ProjectionAperture::pieces);
  const FloatVec x = hn::Mul(hn::Add(place, hn::Set(d, 0.5F)), hn::Set(d, pieces));
  const FloatVec held = hn::Min(hn::Max(x, hn::Zero(d)), hn::Set(d, pieces));
  const FloatVec whole = hn::Floor(held);
  const auto at = hn::ConvertTo(di, whole);
  const FloatVec begin = hn::GatherIndex(d, t.weights, at);
  const FloatVec end = hn::GatherIndex(d, t.weights + 1, at);
  return hn::IfThenElseZero(inside, hn::MulAdd(hn::Sub(held, whole), hn::Sub(end, begin), begin));
}

template <Weighting weighting>
HWY_INLINE void add_stretch(const StretchTerms& t, float first, std::size_t count, float* HWY_RESTRICT re,
                            float* HWY_RESTRICT im, float* HWY_RESTRICT weight) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  alignas(64) std::int32_t at[16];
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const FloatVec j = hn::Iota(d, first + static_cast<float>(k));
    const FloatVec bend = hn::Mul(hn::MulAdd(hn::Set(d, t.phase3), j, hn::Set(d, t.phase2)), j);
    const FloatVec record =
        hn::MulAdd(hn::MulAdd(bend, hn::Set(d, t.record_scale), hn::Set(d, t.record1)), j, hn::Set(d, t.record0));
    const FloatVec held = hn::Min(hn::Max(record, hn::Set(d, t.lowest)), hn::Set(d, t.highest));
    const FloatVec whole = hn::Floor(held);
    hn::Store(hn::ShiftLeft<2>(hn::ConvertTo(di, whole)), di, at);
    const FloatVec phase = hn::MulAdd(hn::Add(bend, hn::Set(d, t.phase1)), j, hn::Set(d, t.phase0));
    FloatVec cosine, sine;
    cos_sin_half_turns(phase, cosine, sine);
    if constexpr (weighting == Weighting::ones)
      hn::Store(hn::Add(hn::Load(d, weight + k), hn::Set(d, 1.0F)), d, weight + k);
    if constexpr (weighting == Weighting::cut || weighting == Weighting::table) {
      const FloatVec w = weight_at(j, t, weighting == Weighting::table);
      hn::Store(hn::Add(hn::Load(d, weight + k), w), d, weight + k);
      cosine = hn::Mul(cosine, w);
      sine = hn::Mul(sine, w);
    }
    const Quad q = load_records(t.base, at);
    const FloatVec fraction = hn::Sub(held, whole);
    const FloatVec x = hn::MulAdd(fraction, q.step_re, q.re);
    const FloatVec y = hn::MulAdd(fraction, q.step_im, q.im);
    const FloatVec sum_re = hn::NegMulAdd(y, sine, hn::MulAdd(x, cosine, hn::Load(d, re + k)));
    const FloatVec sum_im = hn::MulAdd(y, cosine, hn::MulAdd(x, sine, hn::Load(d, im + k)));
    hn::Store(sum_re, d, re + k);
    hn::Store(sum_im, d, im + k);
  }
}

// The terms of one row; false where nothing of the stretch meets the pulse's records or its aperture.
HWY_INLINE bool terms_of_row(const StretchRows& rows, std::size_t row, double half,
                             const ProjectionConstants& constants, const ProjectionPulse& pulse, Weighting& weighting,
                             StretchTerms& t) {
  const double last = static_cast<double>(constants.record_count) - 2.0;
  const double record0 = rows.record0[row];
  const double scale = constants.records_per_s / (2.0 * pulse.carrier_of(constants));
  const double reach = half * (std::abs(rows.record1[row]) +
                               half * scale * (std::abs(rows.phase2[row]) + half * std::abs(rows.phase3[row])));
  if (weighting == Weighting::none && (record0 + reach < -1.0 || record0 - reach > last)) return false;
  if (weighting == Weighting::cut || weighting == Weighting::table) {
    const double begin = rows.place_begin[row];
    const double middle = rows.place_middle[row];
    const double end = rows.place_end[row];
    const double bend = std::abs(begin - 2.0 * middle + end);  // four times what the parabola leaves its chord
    if (std::min(begin, end) - bend > 0.5 || std::max(begin, end) + bend < -0.5) return false;
    if (weighting == Weighting::cut && std::min(begin, end) - bend > -0.5 && std::max(begin, end) + bend < 0.5)
      weighting = Weighting::ones;
    t.place0 = static_cast<float>(middle);
    t.place1 = static_cast<float>((end - begin) / (2.0 * half));
    t.place2 = static_cast<float>((begin - 2.0 * middle + end) / (2.0 * half * half));
  }
  const double base = std::floor(std::clamp(record0, -1.0, last));
  t.base = pulse.records + 4 * static_cast<std::ptrdiff_t>(base + 1.0);
  t.lowest = static_cast<float>(-1.0 - base);
  t.highest = static_cast<float>(last - base);
  t.phase0 = static_cast<float>(rows.phase0[row]);
  t.phase1 = static_cast<float>(rows.phase1[row]);
  t.phase2 = static_cast<float>(rows.phase2[row]);
  t.phase3 = static_cast<float>(rows.phase3[row]);
  t.record0 = static_cast<float>(record0 - base);
  t.record1 = static_cast<float>(rows.record1[row]);
  t.record_scale = static_cast<float>(scale);
  return true;
}

void project_on_target(std::span<const ProjectionPulse> pulses, const ProjectionConstants& constants,
                       const ProjectionAperture& aperture, std::size_t stretch, ProjectionTile& tile) {
  const double half = 0.5 * static_cast<double>(stretch);
  const Weighting wanted = aperture.kind == ProjectionAperture::Kind::all ? Weighting::none
                           : aperture.uniform                             ? Weighting::cut
                                                                          : Weighting::table;
  StretchRows rows;
  StretchTerms t{};
  t.weights = aperture.weights.data();
  for (const ProjectionPulse& pulse : pulses)
    for (std::size_t column = 0; column < tile.used_columns; column += stretch) {
      expand_rows(pulse, constants, aperture, tile, static_cast<double>(column) + half, half, rows);
      const std::size_t count = std::min(stretch, tile.used_columns - column);
      for (std::size_t row = 0; row < tile.used_rows; ++row) {
        Weighting weighting = wanted;
        if (!terms_of_row(rows, row, half, constants, pulse, weighting, t)) continue;
        const std::size_t at = row * ProjectionTile::columns + column;
        float* re = tile.re.data() + at;
        float* im = tile.im.data() + at;
        float* weight = tile.weight.data() + at;
        const auto first = static_cast<float>(-half);
        switch (weighting) {
          case Weighting::none: add_stretch<Weighting::none>(t, first, count, re, im, weight); break;
          case Weighting::ones: add_stretch<Weighting::ones>(t, first, count, re, im, weight); break;
          case Weighting::cut: add_stretch<Weighting::cut>(t, first, count, re, im, weight); break;
          case Weighting::table: add_stretch<Weighting::table>(t, first, count, re, im, weight); break;
        }
      }
    }
}

}  // namespace sarsim::signal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::signal {

HWY_EXPORT(project_on_target);

namespace {

// One point and one pulse in double precision, as the header defines them.
void project_point(const ProjectionPulse& pulse, const ProjectionConstants& constants,
                   const ProjectionAperture& aperture, const core::Vec3& point_m, float& re, float& im, float& weight) {
  const core::Vec3 r = point_m - pulse.position_m;
  const double d = core::norm(r);
  const double speed_mps = core::norm(pulse.velocity_mps);
  const double v = constants.moving && d > 0.0 ? -core::dot(r, pulse.velocity_mps) / d : 0.0;
  double w = 1.0;
  if (aperture.kind != ProjectionAperture::Kind::all) {
    const double ahead = core::dot(r, heading_of(pulse, aperture));
    const double aside = std::sqrt(std::max(d * d - ahead * ahead, 0.0));
    const double place = aperture.kind == ProjectionAperture::Kind::angle
                             ? (std::atan2(ahead, aside) - aperture.squint_rad) / aperture.extent
                             : (ahead - std::tan(aperture.squint_rad) * aside) / (speed_mps * aperture.extent);
    if (!(std::abs(place) <= 0.5)) return;
    if (!aperture.uniform) {
      const double x = (place + 0.5) * static_cast<double>(ProjectionAperture::pieces);
      const auto piece = static_cast<std::size_t>(x);
      const double begin = static_cast<double>(aperture.weights[piece]);
      const double end = static_cast<double>(aperture.weights[piece + 1]);
      w = begin + (x - std::floor(x)) * (end - begin);
    }
    weight += static_cast<float>(w);
  }
  const double ahead_m = constants.moving ? core::dot(r, pulse.velocity_mps) / constants.light_speed_mps : 0.0;
  const double delay_s = slowness_of(pulse, constants) * (d - ahead_m);
  const double fd = radar::doppler_of(v, pulse.carrier_of(constants), constants.light_speed_mps);
  const double early_s = fd * constants.doppler_delay_s2;
  const double record = (delay_s - early_s - constants.first_delay_s) * constants.records_per_s;
  if (!(record >= 0.0 && record < static_cast<double>(constants.record_count) - 2.0)) return;
  const auto whole = static_cast<std::size_t>(record);
  const double fraction = record - static_cast<double>(whole);
  const float* at = pulse.records + 4 * (whole + 1);
  const double x = static_cast<double>(at[0]) + fraction * static_cast<double>(at[2]);
  const double y = static_cast<double>(at[1]) + fraction * static_cast<double>(at[3]);
  const double turns = pulse.carrier_of(constants) * delay_s + 0.5 * fd * early_s;
  const double angle = 2.0 * core::pi * (turns - std::round(turns));
  re += static_cast<float>(w * (x * std::cos(angle) - y * std::sin(angle)));
  im += static_cast<float>(w * (x * std::sin(angle) + y * std::cos(angle)));
}

}  // namespace

Stretch stretch_for(double nearest_m, double column_step_m, double wavelength_m) {
  CORE_EXPECT(wavelength_m > 0.0);
  for (const Stretch stretch : {Stretch::of_64, Stretch::of_32, Stretch::of_16}) {
    const double reach_m = 0.5 * static_cast<double>(stretch) * column_step_m;
    if (reach_m > 0.1 * nearest_m) continue;
    const double x = reach_m / nearest_m;
    if (nearest_m * x * x * x * x / 8.0 < 1e-5 * 0.5 * wavelength_m) return stretch;
  }
  return Stretch::by_point;
}

void project(std::span<const ProjectionPulse> pulses, const ProjectionConstants& constants,
             const ProjectionAperture& aperture, Stretch stretch, ProjectionTile& tile) {
  CORE_EXPECT(constants.light_speed_mps > 0.0);
  CORE_EXPECT(constants.records_per_s > 0.0);
  CORE_EXPECT(constants.record_count >= 2);
  CORE_EXPECT(aperture.uniform || aperture.weights.size() == ProjectionAperture::pieces + 2);
  CORE_EXPECT(tile.used_rows <= ProjectionTile::rows);
  CORE_EXPECT(tile.used_columns <= ProjectionTile::columns);
  if (stretch != Stretch::by_point) {
    HWY_DYNAMIC_DISPATCH(project_on_target)
    (pulses, constants, aperture, static_cast<std::size_t>(stretch), tile);
    return;
  }
  for (const ProjectionPulse& pulse : pulses)
    for (std::size_t row = 0; row < tile.used_rows; ++row)
      for (std::size_t column = 0; column < tile.used_columns; ++column) {
        const std::size_t at = row * ProjectionTile::columns + column;
        const core::Vec3 point_m = tile.point_m(static_cast<double>(row), static_cast<double>(column));
        project_point(pulse, constants, aperture, point_m, tile.re[at], tile.im[at], tile.weight[at]);
      }
}

}  // namespace sarsim::signal

#endif

#include "signal/sar/back_projection_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/report/expect.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "signal/sar/back_projection_kernel.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include <hwy/highway.h>

#include "signal/sar/resample_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::signal::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

struct Quad {
  FloatVec re, im, next_re, next_im;
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

// Added to a number below 2^22, leaves the nearest whole number in the lowest bits.
constexpr float rounder = 12582912.0F;

// cos and sin of pi x for |x| < 2^22: half turns are taken out and come back as a sign. The polynomials are best in the
// sense of Chebyshev on |x| <= 1/2: within 7e-7.
HWY_INLINE void cos_sin_half_turns(FloatVec x, FloatVec& cosine, FloatVec& sine) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  const FloatVec rounded = hn::Add(x, hn::Set(d, rounder));
  const FloatVec r = hn::Sub(x, hn::Sub(rounded, hn::Set(d, rounder)));
  const auto sign = hn::BitCast(d, hn::ShiftLeft<31>(hn::BitCast(di, rounded)));
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
  sine = hn::Mul(s, hn::Xor(r, sign));
}

// How the points of a stretch are weighted.
enum class Weighting { none, ones, cut, table };

Weighting weighting_of(const ProjectionAperture& aperture) {
  if (aperture.kind == ProjectionAperture::Kind::all) return Weighting::none;
  return aperture.uniform ? Weighting::cut : Weighting::table;
}

constexpr std::size_t max_stretches = ProjectionTile::columns / static_cast<std::size_t>(Stretch::of_16);

// What a pulse and a row have beside the polynomials.
struct StretchTerms {
  float record_scale;
  float before, behind;  // the first and the last record, as record0 counts them
  float place0, place1, place2;
  const float* base;
  const float* weights;
};

// The records of points, interpolated.
struct Echo {
  FloatVec re, im;
};

// Each point loads its own records; before the first and behind the last there is nothing.
class WideRecords {
 public:
  explicit WideRecords(const StretchTerms& t) : t_(&t) {}
  HWY_INLINE Echo at(FloatVec record) const {
    constexpr float rounding = 2.5e-4F;  // so that no record before the first one or behind the last one is loaded
    const FloatTag d;
    const hn::RebindToSigned<FloatTag> di;
    alignas(64) std::int32_t at[16];
    const FloatVec before = hn::Set(d, t_->before), behind = hn::Set(d, t_->behind);
    const FloatVec held =
        hn::Min(hn::Max(record, hn::Set(d, t_->before + rounding)), hn::Set(d, t_->behind - rounding));
    const FloatVec rounded = hn::Add(held, hn::Set(d, rounder));
    const auto index = hn::Sub(hn::BitCast(di, rounded), hn::BitCast(di, hn::Set(d, rounder)));
    hn::Store(hn::Add(index, index), di, at);
    const Quad q = load_records(t_->base, at);
    const FloatVec fraction = hn::Add(hn::Sub(held, hn::Sub(rounded, hn::Set(d, rounder))), hn::Set(d, 0.5F));
    const auto there = hn::And(hn::Ge(record, before), hn::Lt(record, behind));
    return {hn::IfThenElseZero(there, hn::MulAdd(fraction, hn::Sub(q.next_re, q.re), q.re)),
            hn::IfThenElseZero(there, hn::MulAdd(fraction, hn::Sub(q.next_im, q.im), q.im))};
  }

 private:
  const StretchTerms* t_;
};

#if HWY_TARGET == HWY_SCALAR
using NarrowRecords = WideRecords;
#else
// As many records as there are lanes stay in registers, where points look them up: means of neighbours and their
// differences.
class NarrowRecords {
 public:
  explicit HWY_INLINE NarrowRecords(const StretchTerms& t) {
    const FloatTag d;
    FloatVec re, im, next_re, next_im;
    hn::LoadInterleaved2(d, t.base, re, im);
    hn::LoadInterleaved2(d, t.base + 2, next_re, next_im);
    step_re_ = hn::Sub(next_re, re);
    step_im_ = hn::Sub(next_im, im);
    re_ = hn::MulAdd(step_re_, hn::Set(d, 0.5F), re);
    im_ = hn::MulAdd(step_im_, hn::Set(d, 0.5F), im);
  }
  HWY_INLINE Echo at(FloatVec record) const {
    const FloatTag d;
    const hn::RebindToSigned<FloatTag> di;
    const FloatVec rounded = hn::Add(record, hn::Set(d, rounder));
    const FloatVec fraction = hn::Sub(record, hn::Sub(rounded, hn::Set(d, rounder)));
    const auto lane = hn::And(hn::BitCast(di, rounded), hn::Set(di, static_cast<std::int32_t>(hn::Lanes(d)) - 1));
    const auto index = hn::IndicesFromVec(d, lane);
    return {hn::MulAdd(fraction, hn::TableLookupLanes(step_re_, index), hn::TableLookupLanes(re_, index)),
            hn::MulAdd(fraction, hn::TableLookupLanes(step_im_, index), hn::TableLookupLanes(im_, index))};
  }

 private:
  FloatVec re_, im_, step_re_, step_im_;
};
#endif

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

template <Weighting weighting, class Records>
HWY_INLINE void add_stretch(const ResampleRows& rows, std::size_t row, const StretchTerms& t, float first,
                            std::size_t count, float* HWY_RESTRICT re, float* HWY_RESTRICT im,
                            float* HWY_RESTRICT weight) {
  const FloatTag d;
  const Records records(t);
  const FloatVec phase0 = hn::Set(d, rows.phase0[row]), phase1 = hn::Set(d, rows.phase1[row]);
  const FloatVec phase2 = hn::Set(d, rows.phase2[row]), phase3 = hn::Set(d, rows.phase3[row]);
  const FloatVec record0 = hn::Set(d, rows.record0[row]), record1 = hn::Set(d, rows.record1[row]);
  const FloatVec record_scale = hn::Set(d, t.record_scale);
  const FloatVec next = hn::Set(d, static_cast<float>(hn::Lanes(d)));
  FloatVec j = hn::Iota(d, first);
  for (std::size_t k = 0; k < count; k += hn::Lanes(d), j = hn::Add(j, next)) {
    const FloatVec bend = hn::Mul(hn::MulAdd(phase3, j, phase2), j);
    const FloatVec record = hn::MulAdd(hn::MulAdd(bend, record_scale, record1), j, record0);
    const FloatVec phase = hn::MulAdd(hn::Add(bend, phase1), j, phase0);
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
    const Echo echo = records.at(record);
    const FloatVec sum_re = hn::NegMulAdd(echo.im, sine, hn::MulAdd(echo.re, cosine, hn::Load(d, re + k)));
    const FloatVec sum_im = hn::MulAdd(echo.im, cosine, hn::MulAdd(echo.re, sine, hn::Load(d, im + k)));
    hn::Store(sum_re, d, re + k);
    hn::Store(sum_im, d, im + k);
  }
}

// The place of a row in the aperture; false where nothing of the stretch is in it.
HWY_INLINE bool place_row(const ResampleRows& rows, std::size_t row, double half, Weighting& weighting,
                          StretchTerms& t) {
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
  return true;
}

// The terms of one row; false where nothing of the stretch meets the pulse's records or its aperture.
HWY_INLINE bool terms_of_row(const ResampleRows& rows, std::size_t row, double half,
                             const ProjectionConstants& constants, const ProjectionPulse& pulse, Weighting& weighting,
                             StretchTerms& t) {
  if (weighting == Weighting::none && static_cast<Reach>(rows.reach[row]) == Reach::beside) return false;
  if (weighting == Weighting::cut || weighting == Weighting::table)
    if (!place_row(rows, row, half, weighting, t)) return false;
  const std::int32_t base = rows.base[row];
  t.base = pulse.records + 2 * static_cast<std::ptrdiff_t>(base);
  t.before = -0.5F - static_cast<float>(base);
  t.behind = static_cast<float>(static_cast<std::ptrdiff_t>(constants.record_count) - 1 - base) - 0.5F;
  return true;
}

template <class Records>
HWY_INLINE void add_row(Weighting weighting, const ResampleRows& rows, std::size_t row, const StretchTerms& t,
                        float first, std::size_t count, std::size_t at, ProjectionTile& tile) {
  float* re = tile.re.data() + at;
  float* im = tile.im.data() + at;
  float* weight = tile.weight.data() + at;
  switch (weighting) {
    case Weighting::none: add_stretch<Weighting::none, Records>(rows, row, t, first, count, re, im, weight); break;
    case Weighting::ones: add_stretch<Weighting::ones, Records>(rows, row, t, first, count, re, im, weight); break;
    case Weighting::cut: add_stretch<Weighting::cut, Records>(rows, row, t, first, count, re, im, weight); break;
    case Weighting::table: add_stretch<Weighting::table, Records>(rows, row, t, first, count, re, im, weight); break;
  }
}

template <bool curved>
void project_stretches(std::span<const ProjectionPulse> pulses, const ProjectionConstants& constants,
                       const ProjectionAperture& aperture, std::size_t stretch, std::span<const RowShapes> shapes,
                       ProjectionTile& tile) {
  const double half = 0.5 * static_cast<double>(stretch);
  const auto first = static_cast<float>(-half);
  const Weighting wanted = weighting_of(aperture);
  ResampleRows rows;
  StretchTerms t{};
  t.weights = aperture.weights.data();
  for (const ProjectionPulse& pulse : pulses) {
    t.record_scale = static_cast<float>(constants.records_per_s / (2.0 * pulse.carrier_of(constants)));
    for (std::size_t column = 0; column < tile.used_columns; column += stretch) {
      const RowShapes* shape = curved ? &shapes[column / stretch] : nullptr;
      expand_rows<curved>(pulse, constants, aperture, tile, shape, static_cast<double>(column) + half, half, rows);
      const std::size_t count = std::min(stretch, tile.used_columns - column);
      for (std::size_t row = 0; row < tile.used_rows; ++row) {
        Weighting weighting = wanted;
        if (!terms_of_row(rows, row, half, constants, pulse, weighting, t)) continue;
        const std::size_t at = row * ProjectionTile::columns + column;
        if (static_cast<Reach>(rows.reach[row]) == Reach::narrow)
          add_row<NarrowRecords>(weighting, rows, row, t, first, count, at, tile);
        else
          add_row<WideRecords>(weighting, rows, row, t, first, count, at, tile);
      }
    }
  }
}

void project_on_target(std::span<const ProjectionPulse> pulses, const ProjectionConstants& constants,
                       const ProjectionAperture& aperture, std::size_t stretch, ProjectionTile& tile) {
  if (tile.surface.empty()) {
    project_stretches<false>(pulses, constants, aperture, stretch, {}, tile);
    return;
  }
  std::array<RowShapes, max_stretches> shapes;
  for (std::size_t i = 0; i * stretch < tile.used_columns; ++i) fill_shapes(tile.surface[i], shapes[i]);
  project_stretches<true>(pulses, constants, aperture, stretch, shapes, tile);
}

// As many points as a vector has floats, or doubles where those are more.
struct PointTerms {
  static constexpr std::size_t most = 16;
  alignas(64) std::array<float, most> half_turns, fraction, there, weight;
  alignas(64) std::array<std::int32_t, most> record;
};

HWY_INLINE DoubleVec lane_weights(DoubleVec place, const ProjectionAperture& aperture) {
  const DoubleTag d;
  const auto inside = hn::Le(hn::Abs(place), hn::Set(d, 0.5));
  if (aperture.uniform) return hn::IfThenElseZero(inside, hn::Set(d, 1.0));
  alignas(64) std::array<double, PointTerms::most> at{};
  const DoubleVec held = hn::Min(hn::Max(place, hn::Set(d, -0.5)), hn::Set(d, 0.5));
  hn::Store(hn::Mul(hn::Add(held, hn::Set(d, 0.5)), hn::Set(d, static_cast<double>(ProjectionAperture::pieces))), d,
            at.data());
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
    const auto piece = static_cast<std::size_t>(at[lane]);
    const auto begin = static_cast<double>(aperture.weights[piece]);
    const auto end = static_cast<double>(aperture.weights[piece + 1]);
    at[lane] = begin + (at[lane] - static_cast<double>(piece)) * (end - begin);
  }
  return hn::IfThenElseZero(inside, hn::Load(d, at.data()));
}

// What `project_point` computes, for the points from `lane` on.
HWY_INLINE void point_terms(const Vec3Lanes& r, const ProjectionPulse& pulse, const ProjectionConstants& constants,
                            const ProjectionAperture& aperture, const core::Vec3& heading, std::size_t lane,
                            PointTerms& out) {
  const DoubleTag d;
  const DoubleVec zero = hn::Zero(d);
  const double carrier_hz = pulse.carrier_of(constants);
  DoubleVec distance = hn::Sqrt(length_squared(r));
  if (pulse.bistatic)
    distance = hn::Mul(hn::Set(d, 0.5),
                       hn::Add(distance, hn::Sqrt(length_squared(moved(r, pulse.position_m - pulse.receiver_m)))));
  const DoubleVec along = constants.moving ? dot_lanes(r, pulse.velocity_mps) : zero;
  const DoubleVec away = hn::IfThenElseZero(hn::Gt(distance, zero), hn::Neg(hn::Div(along, distance)));
  const DoubleVec delay = hn::Mul(hn::Set(d, slowness_of(pulse, constants)),
                                  hn::NegMulAdd(hn::Set(d, 1.0 / constants.light_speed_mps), along, distance));
  const DoubleVec fd = hn::Mul(hn::Set(d, -radar::turns_per_m(carrier_hz, constants.light_speed_mps)), away);
  const DoubleVec early = hn::Mul(fd, hn::Set(d, constants.doppler_delay_s2));
  const DoubleVec from_first = hn::Sub(hn::Sub(delay, early), hn::Set(d, constants.first_delay_s + pulse.later_s));
  const DoubleVec record = hn::Mul(from_first, hn::Set(d, constants.records_per_s));
  const auto there =
      hn::And(hn::Ge(record, zero), hn::Lt(record, hn::Set(d, static_cast<double>(constants.record_count) - 1.0)));
  const DoubleVec whole = hn::Floor(hn::IfThenElseZero(there, record));
  store_floats(hn::IfThenElseZero(there, hn::Sub(record, whole)), out.fraction.data() + lane);
  store_integers(hn::Add(whole, whole), out.record.data() + lane);
  store_floats(without_turns(hn::MulAdd(hn::Set(d, 2.0 * carrier_hz), delay, hn::Mul(fd, early))),
               out.half_turns.data() + lane);
  DoubleVec weight = hn::Set(d, 1.0);
  if (aperture.kind != ProjectionAperture::Kind::all) {
    weight = lane_weights(place_of_points(r, heading, core::norm(pulse.velocity_mps), aperture), aperture);
    store_floats(weight, out.weight.data() + lane);
  }
  store_floats(hn::IfThenElseZero(there, weight), out.there.data() + lane);
}

HWY_INLINE void add_points(const PointTerms& t, const float* records, std::size_t lane, float* HWY_RESTRICT re,
                           float* HWY_RESTRICT im) {
  const FloatTag d;
  FloatVec cosine, sine;
  cos_sin_half_turns(hn::Load(d, t.half_turns.data() + lane), cosine, sine);
  const FloatVec weight = hn::Load(d, t.there.data() + lane);
  const FloatVec fraction = hn::Load(d, t.fraction.data() + lane);
  const Quad q = load_records(records, t.record.data() + lane);
  const FloatVec echo_re = hn::Mul(weight, hn::MulAdd(fraction, hn::Sub(q.next_re, q.re), q.re));
  const FloatVec echo_im = hn::Mul(weight, hn::MulAdd(fraction, hn::Sub(q.next_im, q.im), q.im));
  hn::Store(hn::NegMulAdd(echo_im, sine, hn::MulAdd(echo_re, cosine, hn::Load(d, re))), d, re);
  hn::Store(hn::MulAdd(echo_im, cosine, hn::MulAdd(echo_re, sine, hn::Load(d, im))), d, im);
}

void project_points_on_target(std::span<const ProjectionPulse> pulses, const ProjectionConstants& constants,
                              const ProjectionAperture& aperture, ProjectionTile& tile) {
  const DoubleTag d;
  const FloatTag f;
  const std::size_t together = std::max(hn::Lanes(d), hn::Lanes(f));
  const bool weighted = aperture.kind != ProjectionAperture::Kind::all;
  alignas(64) std::array<double, ProjectionTile::columns> x, y, z;
  PointTerms t{};
  for (std::size_t row = 0; row < tile.used_rows; ++row) {
    for (std::size_t column = 0; column < ProjectionTile::columns; ++column) {
      const core::Vec3 point_m = tile.point_m(row, column);
      x[column] = point_m.x;
      y[column] = point_m.y;
      z[column] = point_m.z;
    }
    for (const ProjectionPulse& pulse : pulses) {
      const core::Vec3 heading = heading_of(pulse, aperture);
      for (std::size_t column = 0; column < tile.used_columns; column += together) {
        for (std::size_t lane = 0; lane < together; lane += hn::Lanes(d)) {
          const std::size_t from = column + lane;
          const Vec3Lanes points{hn::Load(d, x.data() + from), hn::Load(d, y.data() + from),
                                 hn::Load(d, z.data() + from)};
          point_terms(moved(points, -1.0 * pulse.position_m), pulse, constants, aperture, heading, lane, t);
        }
        const std::size_t at = row * ProjectionTile::columns + column;
        for (std::size_t lane = 0; lane < together; lane += hn::Lanes(f)) {
          add_points(t, pulse.records, lane, tile.re.data() + at + lane, tile.im.data() + at + lane);
          if (!weighted) continue;
          float* sum = tile.weight.data() + at + lane;
          hn::Store(hn::Add(hn::Load(f, sum), hn::Load(f, t.weight.data() + lane)), f, sum);
        }
      }
    }
  }
}

}  // namespace sarsim::signal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::signal {

HWY_EXPORT(project_on_target);
HWY_EXPORT(project_points_on_target);

void project(std::span<const ProjectionPulse> pulses, const ProjectionConstants& constants,
             const ProjectionAperture& aperture, Stretch stretch, ProjectionTile& tile) {
  CORE_EXPECT(constants.light_speed_mps > 0.0);
  CORE_EXPECT(constants.records_per_s > 0.0);
  CORE_EXPECT(constants.record_count >= 2);
  CORE_EXPECT(aperture.uniform || aperture.weights.size() == ProjectionAperture::pieces + 2);
  CORE_EXPECT(tile.used_rows <= ProjectionTile::rows);
  CORE_EXPECT(tile.used_columns <= ProjectionTile::columns);
  CORE_EXPECT(tile.points_m.empty() || tile.points_m.size() == ProjectionTile::rows * ProjectionTile::columns);
  if (stretch == Stretch::by_point) {
    HWY_DYNAMIC_DISPATCH(project_points_on_target)(pulses, constants, aperture, tile);
    return;
  }
  CORE_EXPECT(tile.surface.empty() ||
              tile.surface.size() * static_cast<std::size_t>(stretch) == ProjectionTile::columns);
  HWY_DYNAMIC_DISPATCH(project_on_target)
  (pulses, constants, aperture, static_cast<std::size_t>(stretch), tile);
}

}  // namespace sarsim::signal

#endif

#include "echo/sight.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echo/sight.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "echo/simd_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::HWY_NAMESPACE {

using Tag = hn::ScalableTag<double>;
using Vector = hn::Vec<Tag>;

struct Triple {
  Vector x, y, z;
};

HWY_INLINE Vector dot_row(Tag d, const Vec3& row, const Triple& v, Vector start) {
  return hn::MulAdd(hn::Set(d, row.z), v.z,
                    hn::MulAdd(hn::Set(d, row.y), v.y, hn::MulAdd(hn::Set(d, row.x), v.x, start)));
}

HWY_INLINE Triple turned(Tag d, const Mat3& m, const Triple& v, const Vec3& shift) {
  return {dot_row(d, m.row[0], v, hn::Set(d, shift.x)), dot_row(d, m.row[1], v, hn::Set(d, shift.y)),
          dot_row(d, m.row[2], v, hn::Set(d, shift.z))};
}

HWY_INLINE Vector inner(const Triple& a, const Triple& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

// sin(x)/x with x = 2 pi cut sine.
HWY_INLINE Vector sinx_cut(Tag d, double cut, Vector sine) {
  const auto turns = hn::Mul(hn::Set(d, cut), sine);
  auto c = hn::Zero(d);
  auto s = hn::Zero(d);
  cos_sin_turns(d, fraction_of_turn(turns), c, s);
  const auto x = hn::Mul(turns, hn::Set(d, 6.283185307179586476925));
  const auto small = hn::Lt(hn::Abs(x), hn::Set(d, 1e-8));
  return hn::IfThenElse(small, hn::Set(d, 1.0), hn::Div(s, hn::IfThenElse(small, hn::Set(d, 1.0), x)));
}

HWY_INLINE Vector beam_gain(Tag d, const SinxBeam& beam, const Triple& look, Vector distance) {
  const Triple a = turned(d, beam.antenna_from_world, look, Vec3{});
  const auto level = hn::Sqrt(hn::MulAdd(a.x, a.x, hn::Mul(a.y, a.y)));
  const auto sine_azimuth = hn::Div(a.x, hn::Max(level, hn::Set(d, 1e-300)));
  const auto sine_elevation = hn::Div(a.z, distance);
  auto gain = hn::Set(d, 1.0);
  if (beam.cut[0] > 0.0) gain = hn::Mul(gain, sinx_cut(d, beam.cut[0], sine_azimuth));
  if (beam.cut[1] > 0.0) gain = hn::Mul(gain, sinx_cut(d, beam.cut[1], sine_elevation));
  if (beam.cut[2] == beam.cut[0] && beam.cut[3] == beam.cut[1])
    gain = hn::Mul(gain, gain);
  else {
    if (beam.cut[2] > 0.0) gain = hn::Mul(gain, sinx_cut(d, beam.cut[2], sine_azimuth));
    if (beam.cut[3] > 0.0) gain = hn::Mul(gain, sinx_cut(d, beam.cut[3], sine_elevation));
  }
  // Nothing behind: azimuth offsets of 90 degrees or more.
  return hn::IfThenElseZero(hn::Gt(a.y, hn::Zero(d)), gain);
}

struct Columns {
  const double *x, *y, *z, *root_rcs, *normal_x, *normal_y, *normal_z;
};

HWY_INLINE void echoes_at(const Columns& at, std::size_t i, const SightFrame& frame, const SinxBeam* beam,
                          double* HWY_RESTRICT delay, double* HWY_RESTRICT amplitude, double* HWY_RESTRICT speed) {
  const Tag d;
  const Triple point{hn::LoadU(d, at.x + i), hn::LoadU(d, at.y + i), hn::LoadU(d, at.z + i)};
  const Triple look = turned(d, frame.world_from_platform, point, frame.origin_m);
  const Triple velocity = turned(d, frame.world_from_platform_rate, point, frame.velocity_mps);
  const auto distance2 = inner(look, look);
  const auto distance = hn::Sqrt(distance2);
  const auto v = hn::Div(inner(look, velocity), distance);
  hn::StoreU(v, d, speed);
  hn::StoreU(hn::Div(hn::Add(distance, distance), hn::Sub(hn::Set(d, frame.light_speed_mps), v)), d, delay);
  auto a = hn::Mul(hn::LoadU(d, at.root_rcs + i), hn::Set(d, frame.amplitude_scale));
  if (at.normal_x != nullptr) {
    const Triple normal =
        turned(d, frame.world_from_platform,
               {hn::LoadU(d, at.normal_x + i), hn::LoadU(d, at.normal_y + i), hn::LoadU(d, at.normal_z + i)}, Vec3{});
    const auto cosine = hn::Div(hn::Neg(inner(normal, look)), distance);
    a = hn::Mul(a, hn::Sqrt(hn::Max(cosine, hn::Zero(d))));
  }
  if (frame.spreading) a = hn::Div(a, distance2);
  if (beam != nullptr) a = hn::Mul(a, beam_gain(d, *beam, look, distance));
  hn::StoreU(a, d, amplitude);
}

void append_on_target(const PointArrays& points, std::size_t first, std::size_t count, const SightFrame& frame,
                      const SinxBeam* beam, EchoBatch& echoes) {
  const Tag d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t old = echoes.size();
  echoes.delay_s.resize(old + count);
  echoes.amplitude_sqrt_w.resize(old + count);
  echoes.speed_mps.resize(old + count);
  const bool cosine = !points.normal_x.empty();
  const Columns at{points.x_m.data() + first,
                   points.y_m.data() + first,
                   points.z_m.data() + first,
                   points.root_rcs_m.data() + first,
                   cosine ? points.normal_x.data() + first : nullptr,
                   cosine ? points.normal_y.data() + first : nullptr,
                   cosine ? points.normal_z.data() + first : nullptr};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
    echoes_at(at, i, frame, beam, echoes.delay_s.data() + old + i, echoes.amplitude_sqrt_w.data() + old + i,
              echoes.speed_mps.data() + old + i);
  if (i == count) return;
  // The last few points, padded with copies of one of them.
  HWY_ALIGN double buffer[7][hn::MaxLanes(d)];
  const double* const source[7] = {at.x, at.y, at.z, at.root_rcs, at.normal_x, at.normal_y, at.normal_z};
  for (std::size_t c = 0; c < (cosine ? 7U : 4U); ++c)
    for (std::size_t l = 0; l < lanes; ++l) buffer[c][l] = source[c][i + l < count ? i + l : i];
  HWY_ALIGN double out[3][hn::MaxLanes(d)];
  const Columns rest{buffer[0],
                     buffer[1],
                     buffer[2],
                     buffer[3],
                     cosine ? buffer[4] : nullptr,
                     cosine ? buffer[5] : nullptr,
                     cosine ? buffer[6] : nullptr};
  echoes_at(rest, 0, frame, beam, out[0], out[1], out[2]);
  for (std::size_t l = 0; i + l < count; ++l) {
    echoes.delay_s[old + i + l] = out[0][l];
    echoes.amplitude_sqrt_w[old + i + l] = out[1][l];
    echoes.speed_mps[old + i + l] = out[2][l];
  }
}

}  // namespace sarsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim {

HWY_EXPORT(append_on_target);

void append_echoes(const PointArrays& points, std::size_t first, std::size_t count, const SightFrame& frame,
                   const SinxBeam* beam, EchoBatch& echoes) {
  HWY_DYNAMIC_DISPATCH(append_on_target)(points, first, count, frame, beam, echoes);
}

}  // namespace sarsim

#endif

#include "radar/echo/strengths.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/strengths.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "radar/simd/math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

// Positions, phasors and Doppler factors of one vector of echoes.
template <class Real>
struct Vectors {
  using Wide = hn::ScalableTag<double>;
  using Narrow = hn::Rebind<Real, Wide>;
  hn::Vec<Wide> position, doppler, bend;
  hn::Vec<Narrow> re, im;
};

struct Columns {
  const double *delay, *amplitude, *doppler, *bend, *ahead;  // no bend, none ahead: nullptr

  [[nodiscard]] Columns from(std::size_t k) const {
    return {delay + k, amplitude + k, doppler + k, bend == nullptr ? nullptr : bend + k,
            ahead == nullptr ? nullptr : ahead + k};
  }
};

// What is the same for all echoes of a row; kept apart, as the compiler could not know that no result is written into a
// RowFrame.
struct RowConstants {
  explicit RowConstants(const RowFrame& frame)
      : origin_s(frame.origin_s),
        per_interval(1.0 / frame.interval_s),
        quarters_per_s(-4.0 * frame.carrier_hz),
        from(frame.from),
        to(frame.to) {}

  double origin_s, per_interval, quarters_per_s, from, to;
};

template <class Real>
HWY_INLINE Vectors<Real> strengths_at(const Columns& at, const RowConstants& row) {
  const hn::ScalableTag<double> dd;
  const hn::Rebind<Real, hn::ScalableTag<double>> narrow;
  const auto delay = hn::LoadU(dd, at.delay);
  const auto amplitude = hn::LoadU(dd, at.amplitude);
  Vectors<Real> out;
  out.position = hn::Mul(hn::Sub(delay, hn::Set(dd, row.origin_s)), hn::Set(dd, row.per_interval));
  out.doppler = hn::LoadU(dd, at.doppler);
  out.bend = at.bend == nullptr ? hn::Zero(dd) : hn::LoadU(dd, at.bend);
  auto quarters = hn::Mul(delay, hn::Set(dd, row.quarters_per_s));
  if (at.ahead != nullptr) quarters = hn::MulAdd(hn::LoadU(dd, at.ahead), hn::Set(dd, 4.0), quarters);
  const auto whole = hn::Round(quarters);
  const auto angle = hn::Mul(hn::Sub(quarters, whole), hn::Set(dd, 0.5 * core::pi));
  const auto turns = hn::Round(hn::Mul(whole, hn::Set(dd, 0.25)));
  const auto quarter = hn::NegMulAdd(turns, hn::Set(dd, 4.0), whole);
  // Less than an eighth of a turn is left, which a float holds to 4e-9 of a turn.
  const auto narrowed = [&](auto x) {
    if constexpr (sizeof(Real) == 4) return hn::DemoteTo(narrow, x);
    if constexpr (sizeof(Real) == 8) return x;
  };
  auto c = hn::Zero(narrow);
  auto s = hn::Zero(narrow);
  cos_sin_of(narrow, narrowed(quarter), narrowed(angle), c, s);
  const auto strength = narrowed(amplitude);
  out.re = hn::Mul(c, strength);
  out.im = hn::Mul(s, strength);
  return out;
}

// Writes the echoes of a vector that touch the row behind the `kept` ones that are there.
template <class Real>
HWY_INLINE void keep_touching(const Vectors<Real>& v, const RowConstants& row, std::size_t here, std::size_t& kept,
                              Strengths<Real>& out) {
  const hn::ScalableTag<double> dd;
  const hn::Rebind<Real, hn::ScalableTag<double>> narrow;
  const std::size_t lanes = hn::Lanes(dd);
  const auto touches = hn::And(hn::Gt(v.position, hn::Set(dd, row.from)), hn::Lt(v.position, hn::Set(dd, row.to)));
  if (here == lanes && hn::AllTrue(dd, touches)) {
    hn::StoreU(v.position, dd, out.position.data() + kept);
    hn::StoreU(v.doppler, dd, out.doppler.data() + kept);
    if (!out.dilation_rate.empty()) hn::StoreU(v.bend, dd, out.dilation_rate.data() + kept);
    hn::StoreInterleaved2(v.re, v.im, narrow, reinterpret_cast<Real*>(out.strength.data() + kept));
    kept += lanes;
    return;
  }
  HWY_ALIGN double position[hn::MaxLanes(dd)];
  HWY_ALIGN double doppler[hn::MaxLanes(dd)];
  HWY_ALIGN double bend[hn::MaxLanes(dd)];
  HWY_ALIGN Real re[hn::MaxLanes(dd)];
  HWY_ALIGN Real im[hn::MaxLanes(dd)];
  hn::Store(v.position, dd, position);
  hn::Store(v.doppler, dd, doppler);
  hn::Store(v.bend, dd, bend);
  hn::StoreU(v.re, narrow, re);
  hn::StoreU(v.im, narrow, im);
  for (std::size_t i = 0; i < here; ++i) {
    if (!(position[i] > row.from && position[i] < row.to)) continue;
    out.position[kept] = position[i];
    out.strength[kept] = {re[i], im[i]};
    out.doppler[kept] = doppler[i];
    if (!out.dilation_rate.empty()) out.dilation_rate[kept] = bend[i];
    ++kept;
  }
}

// The smallest and the largest of a column; 0 of none.
HWY_INLINE void set_range(std::span<const double> column, double& lowest_out, double& highest_out) {
  const hn::ScalableTag<double> d;
  const std::size_t count = column.size();
  const auto first = hn::Set(d, count > 0 ? column.front() : 0.0);
  auto lowest = first;
  auto highest = first;
  std::size_t k = 0;
  for (; k + hn::Lanes(d) <= count; k += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, column.data() + k);
    lowest = hn::Min(lowest, x);
    highest = hn::Max(highest, x);
  }
  lowest_out = hn::GetLane(hn::MinOfLanes(d, lowest));
  highest_out = hn::GetLane(hn::MaxOfLanes(d, highest));
  for (; k < count; ++k) {
    lowest_out = std::min(lowest_out, column[k]);
    highest_out = std::max(highest_out, column[k]);
  }
}

template <class Real>
HWY_INLINE void gather_on_target(const EchoBatch& echoes, const RowFrame& frame, Strengths<Real>& out) {
  const hn::ScalableTag<double> dd;
  const std::size_t lanes = hn::Lanes(dd);
  const std::size_t count = echoes.size();
  out.position.resize(count);
  out.strength.resize(count);
  out.doppler.resize(count);
  out.dilation_rate.resize(echoes.dilation_rate.size());
  std::size_t kept = 0;
  std::size_t k = 0;
  const bool bends = !echoes.dilation_rate.empty();
  const bool ahead = !echoes.ahead_turns.empty();
  const Columns all{echoes.delay_s.data(), echoes.amplitude_sqrt_w.data(), echoes.doppler.data(),
                    bends ? echoes.dilation_rate.data() : nullptr, ahead ? echoes.ahead_turns.data() : nullptr};
  const RowConstants row(frame);
  for (; k + lanes <= count; k += lanes) keep_touching(strengths_at<Real>(all.from(k), row), row, lanes, kept, out);
  if (k < count) {
    HWY_ALIGN double rest[5][hn::MaxLanes(dd)];
    for (std::size_t i = 0; i < lanes; ++i) {
      const std::size_t source = k + i < count ? k + i : k;
      rest[0][i] = all.delay[source];
      rest[1][i] = all.amplitude[source];
      rest[2][i] = all.doppler[source];
      rest[3][i] = bends ? all.bend[source] : 0.0;
      rest[4][i] = ahead ? all.ahead[source] : 0.0;
    }
    const Columns last{rest[0], rest[1], rest[2], bends ? rest[3] : nullptr, ahead ? rest[4] : nullptr};
    keep_touching(strengths_at<Real>(last, row), row, count - k, kept, out);
  }
  out.position.resize(kept);
  out.strength.resize(kept);
  out.doppler.resize(kept);
  if (bends) out.dilation_rate.resize(kept);
  set_range(out.doppler, out.motion.lowest_doppler, out.motion.highest_doppler);
  set_range(out.dilation_rate, out.motion.lowest_bend, out.motion.highest_bend);
}

// Chebyshev's polynomials at the nodes, [node][degree], times 2/terms, half of that for degree 0: Lagrange's polynomial
// of node r is sum over m of matrix[r][m] T_m(x).
void lagrange_matrix(std::size_t terms, double* matrix) {
  for (std::size_t r = 0; r < terms; ++r)
    for (std::size_t m = 0; m < terms; ++m)
      matrix[r * terms + m] = (m == 0 ? 1.0 : 2.0) / static_cast<double>(terms) *
                              std::cos(static_cast<double>(m) * std::acos(doppler_node(r, terms)));
}

// Strengths of one vector of echoes, or of the first `here` of it, times their weights.
template <class Real>
HWY_INLINE void store_weighted(hn::Vec<hn::ScalableTag<double>> weight, const std::complex<Real>* HWY_RESTRICT strength,
                               std::size_t here, std::complex<Real>* HWY_RESTRICT out) {
  const hn::ScalableTag<double> dd;
  const hn::Rebind<Real, hn::ScalableTag<double>> narrow;
  auto factor = hn::Zero(narrow);
  if constexpr (sizeof(Real) == 4) factor = hn::DemoteTo(narrow, weight);
  if constexpr (sizeof(Real) == 8) factor = weight;
  if (here < hn::Lanes(dd)) {
    HWY_ALIGN Real each[hn::MaxLanes(dd)];
    hn::Store(factor, narrow, each);
    for (std::size_t i = 0; i < here; ++i) out[i] = strength[i] * each[i];
    return;
  }
  auto re = hn::Zero(narrow);
  auto im = hn::Zero(narrow);
  hn::LoadInterleaved2(narrow, reinterpret_cast<const Real*>(strength), re, im);
  hn::StoreInterleaved2(hn::Mul(re, factor), hn::Mul(im, factor), narrow, reinterpret_cast<Real*>(out));
}

template <class Real>
HWY_INLINE void weigh_on_target(std::span<const std::complex<Real>> strength, std::span<const double> at,
                                const DopplerSpan& span, std::size_t terms, std::complex<Real>* weighted) {
  const hn::ScalableTag<double> dd;
  const std::size_t lanes = hn::Lanes(dd);
  const std::size_t count = strength.size();
  double matrix[max_doppler_terms * max_doppler_terms];
  lagrange_matrix(terms, matrix);
  HWY_ALIGN double chebyshev[max_doppler_terms * hn::MaxLanes(dd)];
  HWY_ALIGN double buffer[hn::MaxLanes(dd)];
  for (std::size_t k = 0; k < count; k += lanes) {
    const std::size_t here = std::min(lanes, count - k);
    if (here < lanes)
      for (std::size_t i = 0; i < lanes; ++i) buffer[i] = at[k + std::min(i, here - 1)];
    const auto place = hn::LoadU(dd, here < lanes ? buffer : at.data() + k);
    const auto x = hn::Mul(hn::Sub(place, hn::Set(dd, span.middle)), hn::Set(dd, 1.0 / span.half));
    auto before = hn::Set(dd, 1.0);
    auto now = x;
    for (std::size_t m = 0; m < terms; ++m) {
      hn::Store(before, dd, chebyshev + m * lanes);
      const auto next = hn::MulSub(hn::Add(x, x), now, before);
      before = now;
      now = next;
    }
    for (std::size_t r = 0; r < terms; ++r) {
      auto sum = hn::Zero(dd);
      for (std::size_t m = 0; m < terms; ++m)
        sum = hn::MulAdd(hn::Set(dd, matrix[r * terms + m]), hn::Load(dd, chebyshev + m * lanes), sum);
      store_weighted(sum, strength.data() + k, here, weighted + r * count + k);
    }
  }
}

// (u - e)/e with u = (e + a u^2/2)/(1 - D), in as many rounds as PulseClock::late_of takes; as a share of e, which may
// be 0.
void late_rates_on_target(std::span<const double> doppler, std::span<const double> dilation_rate, double sent_s,
                          double* out) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  const auto one = hn::Set(d, 1.0);
  HWY_ALIGN double rest[3][hn::MaxLanes(d)];
  for (std::size_t k = 0; k < doppler.size(); k += lanes) {
    const std::size_t here = std::min(lanes, doppler.size() - k);
    const bool whole = here == lanes;
    if (!whole)
      for (std::size_t i = 0; i < lanes; ++i) {
        const std::size_t source = k + std::min(i, here - 1);
        rest[0][i] = doppler[source];
        rest[1][i] = dilation_rate.empty() ? 0.0 : dilation_rate[source];
      }
    const auto speed = hn::LoadU(d, whole ? doppler.data() + k : rest[0]);
    const auto scale = hn::Div(one, hn::Sub(one, speed));
    auto late = hn::Mul(speed, scale);
    if (!dilation_rate.empty()) {
      const auto bend = hn::Mul(hn::LoadU(d, whole ? dilation_rate.data() + k : rest[1]), hn::Set(d, 0.5 * sent_s));
      auto longer = scale;  // u/e
      for (int round = 0; round < 3; ++round) longer = hn::Mul(hn::MulAdd(bend, hn::Mul(longer, longer), one), scale);
      late = hn::Mul(hn::MulAdd(bend, longer, speed), longer);
    }
    hn::StoreU(late, d, whole ? out + k : rest[2]);
    if (!whole) std::copy_n(rest[2], here, out + k);
  }
}

void gather_single(const EchoBatch& echoes, const RowFrame& frame, Strengths<float>& out) {
  gather_on_target(echoes, frame, out);
}
void gather_double(const EchoBatch& echoes, const RowFrame& frame, Strengths<double>& out) {
  gather_on_target(echoes, frame, out);
}

void weigh_single(std::span<const std::complex<float>> strength, std::span<const double> at, const DopplerSpan& span,
                  std::size_t terms, std::complex<float>* weighted) {
  weigh_on_target(strength, at, span, terms, weighted);
}
void weigh_double(std::span<const std::complex<double>> strength, std::span<const double> at, const DopplerSpan& span,
                  std::size_t terms, std::complex<double>* weighted) {
  weigh_on_target(strength, at, span, terms, weighted);
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

namespace {

constexpr std::size_t parts_in_turn = 16;
// From part to part, round and round: neighbours in the turn come from parts that are far from each other too, as rows
// of a grid that follow each other meet at the ends of their echoes.
constexpr std::size_t step_of_turn = 7;

// Whether most echoes touch samples that the one before them touches.
bool neighbours_meet(std::span<const double> position) {
  constexpr std::size_t looks = 256;
  constexpr double near_samples = 8.0;
  const std::size_t step = position.size() / looks;
  if (step < parts_in_turn) return false;
  std::size_t near = 0;
  for (std::size_t k = 0; k < position.size() - 1; k += step)
    if (std::abs(position[k + 1] - position[k]) < near_samples) ++near;
  return 2 * near > looks;
}

template <class Value>
void take_in_turn(core::AlignedVector<Value>& values, core::AlignedVector<Value>& room) {
  if (values.empty()) return;
  room.resize(values.size());
  const std::size_t part = values.size() / parts_in_turn;
  for (std::size_t i = 0; i < part; ++i)
    for (std::size_t n = 0; n < parts_in_turn; ++n)
      room[i * parts_in_turn + n] = values[step_of_turn * n % parts_in_turn * part + i];
  const std::size_t whole = part * parts_in_turn;
  std::copy(values.begin() + static_cast<std::ptrdiff_t>(whole), values.end(),
            room.begin() + static_cast<std::ptrdiff_t>(whole));
  values.swap(room);
}

}  // namespace

template <class Real>
void part_neighbours(Strengths<Real>& echoes) {
  if (!neighbours_meet(echoes.position)) return;
  take_in_turn(echoes.position, echoes.room);
  take_in_turn(echoes.doppler, echoes.room);
  take_in_turn(echoes.dilation_rate, echoes.room);
  take_in_turn(echoes.strength, echoes.strength_room);
}

template void part_neighbours(Strengths<float>& echoes);
template void part_neighbours(Strengths<double>& echoes);

HWY_EXPORT(gather_single);
HWY_EXPORT(gather_double);
HWY_EXPORT(weigh_single);
HWY_EXPORT(weigh_double);
HWY_EXPORT(late_rates_on_target);

void late_rates(std::span<const double> doppler, std::span<const double> dilation_rate, double sent_s,
                std::span<double> rate) {
  CORE_EXPECT(dilation_rate.empty() || dilation_rate.size() == doppler.size());
  CORE_EXPECT(rate.size() == doppler.size());
  HWY_DYNAMIC_DISPATCH(late_rates_on_target)(doppler, dilation_rate, sent_s, rate.data());
}

double doppler_node(std::size_t r, std::size_t terms) {
  CORE_EXPECT(r < terms);
  return std::cos(core::pi * (static_cast<double>(r) + 0.5) / static_cast<double>(terms));
}

template <>
void gather_strengths(const EchoBatch& echoes, const RowFrame& frame, Strengths<float>& out) {
  CORE_EXPECT(frame.interval_s > 0.0);
  CORE_EXPECT(echoes.is_whole());
  HWY_DYNAMIC_DISPATCH(gather_single)(echoes, frame, out);
}
template <>
void gather_strengths(const EchoBatch& echoes, const RowFrame& frame, Strengths<double>& out) {
  CORE_EXPECT(frame.interval_s > 0.0);
  CORE_EXPECT(echoes.is_whole());
  HWY_DYNAMIC_DISPATCH(gather_double)(echoes, frame, out);
}

template <>
void weigh_strengths(std::span<const std::complex<float>> strength, std::span<const double> at, const DopplerSpan& span,
                     std::size_t terms, std::span<std::complex<float>> weighted) {
  CORE_EXPECT(terms > 0);
  CORE_EXPECT(terms <= max_doppler_terms);
  CORE_EXPECT(span.half >= 0.0);
  CORE_EXPECT(at.size() == strength.size());
  CORE_EXPECT(weighted.size() == terms * strength.size());
  HWY_DYNAMIC_DISPATCH(weigh_single)(strength, at, span, terms, weighted.data());
}
template <>
void weigh_strengths(std::span<const std::complex<double>> strength, std::span<const double> at,
                     const DopplerSpan& span, std::size_t terms, std::span<std::complex<double>> weighted) {
  CORE_EXPECT(terms > 0);
  CORE_EXPECT(terms <= max_doppler_terms);
  CORE_EXPECT(span.half >= 0.0);
  CORE_EXPECT(at.size() == strength.size());
  CORE_EXPECT(weighted.size() == terms * strength.size());
  HWY_DYNAMIC_DISPATCH(weigh_double)(strength, at, span, terms, weighted.data());
}

}  // namespace sarsim::radar

#endif

#include "radar/echo/gridding.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/gridding.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "radar/echo/piece_places-inl.hpp"
#include "radar/simd/math-inl.hpp"

HWY_BEFORE_NAMESPACE();
#include "core/report/expect.hpp"

namespace sarsim::radar::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

// One lane holds no pair of a real and an imaginary part: plain loops.

template <class Real>
Real lane_value(const LanePolynomials<Real>& lanes, std::size_t table, std::size_t lane, Real y) {
  const Real* at = lanes.coefficients.data() + table + lane;
  Real sum = at[0];
  for (std::size_t p = 1; p <= lanes.degree; ++p) sum = sum * y + at[p * lanes.lanes];
  return sum;
}

template <class Real, std::size_t Degree, std::size_t Lanes>
void spread_block(const LanePolynomials<Real>& taps, std::size_t width, const Places<Real>& places, std::size_t first,
                  std::size_t count, std::size_t total, std::span<const std::complex<Real>> strength,
                  SpreadGrid<Real>& grid) {
  const bool tilted = strength.size() < grid.term.size() * total;
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(places.cell[k]);
    const auto table = static_cast<std::size_t>(places.table[k]);
    for (std::size_t tap = 0; tap < width; ++tap) {
      const Real weight = lane_value(taps, table, tap, places.y[k]);
      if (tilted) {
        grid.term[0][at + tap] += weight * strength[first + k];
        grid.term[1][at + tap] += weight * places.tilt[k] * strength[first + k];
        continue;
      }
      for (std::size_t r = 0; r < grid.term.size(); ++r)
        grid.term[r][at + tap] += weight * strength[r * total + first + k];
    }
  }
}

template <class Real, std::size_t Degree, std::size_t Lanes>
void edge_block(const EdgePiece<Real>& piece, const Places<Real>& places, std::size_t first, std::size_t count,
                std::span<const std::complex<Real>> strength, std::span<const double> doppler, EdgeRow<Real>& row) {
  const std::size_t samples = piece.samples.lanes / 2;
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(places.cell[k]);
    const auto table = static_cast<std::size_t>(places.table[k]);
    for (std::size_t i = 0; i < samples; ++i) {
      std::complex<Real> z(lane_value(piece.samples, table, 2 * i, places.y[k]),
                           lane_value(piece.samples, table, 2 * i + 1, places.y[k]));
      if (!doppler.empty()) {
        const double t = static_cast<double>(i) + static_cast<double>(places.fraction[k]);
        const double turns =
            doppler[first + k] * (piece.doppler_offset + t * (piece.doppler_slope + t * piece.doppler_bend));
        z *= std::complex<Real>(std::polar(1.0, -6.283185307179586476925 * (turns - std::round(turns))));
      }
      row.samples[at + i] += strength[first + k] * z;
    }
  }
}

#else

constexpr std::size_t usual_width = 8;

// Calls f(d, lane, weights) for the taps of an echo, vector by vector. The usual ones fill half of their lanes.
template <class Real, std::size_t Degree, std::size_t Lanes, class F>
HWY_INLINE void each_taps(const Polynomials<Real, Degree, Lanes>& taps, std::size_t width, std::int32_t table, Real y,
                          const F& f) {
  const hn::CappedTag<Real, Lanes == 16 ? usual_width : HWY_LANES(Real)> d;
  const std::size_t last = Lanes == 16 ? usual_width : width;
  for (std::size_t lane = 0; lane < last; lane += hn::Lanes(d)) f(d, lane, taps.at(d, table, lane, hn::Set(d, y)));
}

template <class Real>
HWY_INLINE const Real* parts_of(const std::complex<Real>* z) {
  return reinterpret_cast<const Real*>(z);
}

// Two terms, the second of which follows from the first.
template <class Real, std::size_t Degree, std::size_t Lanes>
HWY_INLINE void spread_tilted(const LanePolynomials<Real>& taps, std::size_t width, const Places<Real>& places,
                              std::size_t count, const std::complex<Real>* HWY_RESTRICT strength,
                              SpreadGrid<Real>& grid) {
  const hn::ScalableTag<Real> wide;
  const Polynomials<Real, Degree, Lanes> polynomials(taps);
  Real* const one = reinterpret_cast<Real*>(grid.term[0].data());
  Real* const two = reinterpret_cast<Real*>(grid.term[1].data());
  for (std::size_t k = 0; k < count; ++k) {
    const auto pair = in_all_pairs(wide, parts_of(strength + k));
    const auto tilted = hn::Mul(pair, hn::Set(wide, places.tilt[k]));
    each_taps(polynomials, width, places.table[k], places.y[k], [&](auto d, std::size_t lane, auto weights) {
      const std::ptrdiff_t at = 2 * (std::ptrdiff_t{places.cell[k]} + static_cast<std::ptrdiff_t>(lane));
      add_weighted(d, weights, pair, one + at);
      add_weighted(d, weights, tilted, two + at);
    });
  }
}

// Terms is 0 where their number is only known at run time.
template <class Real, std::size_t Degree, std::size_t Lanes, std::size_t Terms>
HWY_INLINE void spread_terms(const LanePolynomials<Real>& taps, std::size_t width, const Places<Real>& places,
                             std::size_t first, std::size_t count, std::size_t total,
                             std::span<const std::complex<Real>> strength, SpreadGrid<Real>& grid) {
  const hn::ScalableTag<Real> wide;
  const Polynomials<Real, Degree, Lanes> polynomials(taps);
  const std::size_t terms = Terms > 0 ? Terms : grid.term.size();
  for (std::size_t k = 0; k < count; ++k)
    each_taps(polynomials, width, places.table[k], places.y[k], [&](auto d, std::size_t lane, auto weights) {
      const std::ptrdiff_t at = std::ptrdiff_t{places.cell[k]} + static_cast<std::ptrdiff_t>(lane);
      for (std::size_t r = 0; r < terms; ++r) {
        const auto pair = in_all_pairs(wide, parts_of(strength.data() + r * total + first + k));
        add_weighted(d, weights, pair, reinterpret_cast<Real*>(grid.term[r].data() + at));
      }
    });
}

template <class Real, std::size_t Degree, std::size_t Lanes>
HWY_INLINE void spread_block(const LanePolynomials<Real>& taps, std::size_t width, const Places<Real>& places,
                             std::size_t first, std::size_t count, std::size_t total,
                             std::span<const std::complex<Real>> strength, SpreadGrid<Real>& grid) {
  if (strength.size() < grid.term.size() * total)
    return spread_tilted<Real, Degree, Lanes>(taps, width, places, count, strength.data() + first, grid);
  switch (grid.term.size()) {
    case 1: return spread_terms<Real, Degree, Lanes, 1>(taps, width, places, first, count, total, strength, grid);
    case 2: return spread_terms<Real, Degree, Lanes, 2>(taps, width, places, first, count, total, strength, grid);
    default: return spread_terms<Real, Degree, Lanes, 0>(taps, width, places, first, count, total, strength, grid);
  }
}

// -1 in even lanes, +1 in odd ones.
template <class D>
HWY_INLINE hn::Vec<D> pair_signs(D d) {
  using T = hn::TFromD<D>;
  return hn::OddEven(hn::Set(d, T(1)), hn::Set(d, T(-1)));
}

// Number of the sample that each lane from `lane` on belongs to.
template <class D>
HWY_INLINE hn::Vec<D> sample_numbers(D d, std::size_t lane) {
  using T = hn::TFromD<D>;
  const auto twice = hn::Iota(d, static_cast<T>(lane));
  return hn::Mul(hn::OddEven(hn::Sub(twice, hn::Set(d, T(1))), twice), hn::Set(d, T(0.5)));
}

// How the Doppler phase runs along the few samples of the edges of a block of echoes: not at all, or seen from the
// middle sample by so little that the angle itself, or a short series, turns them, or by any angle.
enum class EdgeTurn { none, faint, slight, any };

// The strengths of the edges of a block of echoes, turned by the Doppler phase of the middle sample, and how the phase
// goes on from there.
template <class Real>
struct TurnedEdges {
  static constexpr std::size_t most = Places<Real>::most;
  HWY_ALIGN Real turns[most];
  HWY_ALIGN Real slope[most];  // Turns per sample, backwards
  HWY_ALIGN Real bend[most];   // and per sample squared.
  HWY_ALIGN Real strength[2 * most];
  EdgeTurn turn = EdgeTurn::none;
};

template <class Real>
double middle_sample(const EdgePiece<Real>& piece) {
  return 0.5 * (0.5 * static_cast<double>(piece.samples.lanes) - 1.0);
}

// Phases of the middle samples and their changes. What a series leaves out, half the square of the angle below
// `faint_angle` and its fourth power over 24 below `slight_angle`, is lost in the last digit of Real.
template <class Real>
HWY_INLINE void place_turns(const EdgePiece<Real>& piece, std::span<const double> doppler, std::size_t first,
                            std::size_t count, const Places<Real>& places, TurnedEdges<Real>& out) {
  constexpr double faint_angle = sizeof(Real) == 4 ? 2e-4 : 1e-8;
  constexpr double slight_angle = sizeof(Real) == 4 ? 0.02 : 1e-3;
  const hn::ScalableTag<double> d;
  HWY_ALIGN double buffer[Places<Real>::most];
  const double* const from = whole_vectors(doppler, first, count, buffer);
  const double middle = middle_sample(piece);
  const auto offset = hn::Set(d, piece.doppler_offset);
  const auto slope = hn::Set(d, piece.doppler_slope);
  const auto bend = hn::Set(d, piece.doppler_bend);
  auto largest = hn::Zero(d);
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const auto speed = hn::LoadU(d, from + k);
    const auto sample = hn::Add(load_wide(d, places.fraction + k), hn::Set(d, middle));
    const auto bent = hn::Mul(sample, bend);
    const auto turns = hn::Mul(speed, hn::Add(offset, hn::Mul(sample, hn::Add(slope, bent))));
    const auto change = hn::Neg(hn::Mul(speed, hn::Add(slope, hn::Add(bent, bent))));
    const auto curve = hn::Neg(hn::Mul(speed, bend));
    store_narrow(d, hn::Sub(hn::Round(turns), turns), out.turns + k);
    store_narrow(d, change, out.slope + k);
    store_narrow(d, curve, out.bend + k);
    largest = hn::Max(largest, hn::MulAdd(hn::Set(d, middle), hn::Abs(curve), hn::Abs(change)));
  }
  const double angle = 6.283185307179586476925 * middle * hn::GetLane(hn::MaxOfLanes(d, largest));
  out.turn = angle < faint_angle ? EdgeTurn::faint : angle < slight_angle ? EdgeTurn::slight : EdgeTurn::any;
}

// Strengths times the phasors of the middle samples.
template <class Real>
HWY_INLINE void turn_strengths(const std::complex<Real>* HWY_RESTRICT strength, std::size_t count,
                               TurnedEdges<Real>& out) {
  using Edges = TurnedEdges<Real>;
  const hn::ScalableTag<Real> d;
  HWY_ALIGN Real padded[2 * Edges::most];
  const Real* given = reinterpret_cast<const Real*>(strength);
  if (count % hn::Lanes(d) != 0) {
    std::copy_n(given, 2 * count, padded);
    for (std::size_t k = count; k % hn::Lanes(d) != 0; ++k) out.turns[k] = padded[2 * k] = padded[2 * k + 1] = 0;
    given = padded;
  }
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    auto c = hn::Zero(d);
    auto s = hn::Zero(d);
    cos_sin_turns(d, hn::Load(d, out.turns + k), c, s);
    auto re = hn::Zero(d);
    auto im = hn::Zero(d);
    hn::LoadInterleaved2(d, given + 2 * k, re, im);
    hn::StoreInterleaved2(hn::NegMulAdd(im, s, hn::Mul(re, c)), hn::MulAdd(re, s, hn::Mul(im, c)), d,
                          out.strength + 2 * k);
  }
}

// A strength for each lane of interleaved samples: they are multiplied by `re`, and their neighbours in the pair, the
// other part of the number, by `im`, which has the sign that its lane takes.
template <class V>
struct PairFactors {
  V re, im;
};

// Where the samples of the lanes stand, from the middle one.
template <class V>
struct LanePlaces {
  V samples;  // from the middle
  V angle;    // times 2 pi
  V signs;    // -1 in even lanes, +1 in odd ones
  V signed_angle;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE LanePlaces<V> lane_places(D d, std::size_t lane, V middle) {
  const auto samples = hn::Sub(sample_numbers(d, lane), middle);
  const auto angle = hn::Mul(samples, hn::Set(d, hn::TFromD<D>(6.283185307179586476925)));
  const auto signs = pair_signs(d);
  return {samples, angle, signs, hn::Mul(angle, signs)};
}

// A strength turned from sample to sample.
template <EdgeTurn Turn, class D, class V = hn::Vec<D>>
HWY_INLINE PairFactors<V> turned(D d, const LanePlaces<V>& at, V re, V im, V slope, V bend) {
  using T = hn::TFromD<D>;
  if constexpr (Turn == EdgeTurn::none) return {re, hn::Mul(im, at.signs)};
  const auto change = hn::MulAdd(at.samples, bend, slope);
  if constexpr (Turn == EdgeTurn::faint)
    return {hn::NegMulAdd(hn::Mul(at.angle, change), im, re),
            hn::MulAdd(hn::Mul(at.signed_angle, change), re, hn::Mul(im, at.signs))};
  auto c = hn::Set(d, T(1));
  auto s = hn::Zero(d);
  if constexpr (Turn == EdgeTurn::slight) {
    const auto angle = hn::Mul(at.angle, change);
    const auto square = hn::Mul(angle, angle);
    c = hn::MulAdd(square, hn::Set(d, T(-0.5)), c);
    s = hn::Mul(angle, hn::MulAdd(square, hn::Set(d, T(-1.0 / 6.0)), hn::Set(d, T(1))));
  } else {
    cos_sin_turns(d, fraction_of_turn(hn::Mul(at.samples, change)), c, s);
  }
  return {hn::NegMulAdd(im, s, hn::Mul(re, c)), hn::Mul(hn::MulAdd(re, s, hn::Mul(im, c)), at.signs)};
}

template <class Real, std::size_t Degree, std::size_t Lanes, EdgeTurn Turn>
HWY_INLINE void edge_loop(const EdgePiece<Real>& piece, const Places<Real>& places, std::size_t count,
                          const Real* HWY_RESTRICT strength, const TurnedEdges<Real>& edges,
                          std::complex<Real>* HWY_RESTRICT row) {
  const hn::ScalableTag<Real> d;
  const Polynomials<Real, Degree, Lanes> polynomials(piece.samples);
  const auto middle = hn::Set(d, static_cast<Real>(middle_sample(piece)));
  for (std::size_t k = 0; k < count; ++k) {
    const auto y = hn::Set(d, places.y[k]);
    const auto re = hn::Set(d, strength[2 * k]);
    const auto im = hn::Set(d, strength[2 * k + 1]);
    const auto slope = Turn == EdgeTurn::none ? hn::Zero(d) : hn::Set(d, edges.slope[k]);
    const auto bend = Turn == EdgeTurn::none ? hn::Zero(d) : hn::Set(d, edges.bend[k]);
    Real* HWY_RESTRICT out = reinterpret_cast<Real*>(row + places.cell[k]);
    for (std::size_t lane = 0; lane < polynomials.lanes; lane += hn::Lanes(d)) {
      const auto pairs = polynomials.at(d, places.table[k], lane, y);
      const auto factors = turned<Turn>(d, lane_places(d, lane, middle), re, im, slope, bend);
      const auto sum = hn::MulAdd(pairs, factors.re, hn::LoadU(d, out + lane));
      hn::StoreU(hn::MulAdd(hn::Reverse2(d, pairs), factors.im, sum), d, out + lane);
    }
  }
}

template <class Real, std::size_t Degree, std::size_t Lanes>
HWY_INLINE void edge_block(const EdgePiece<Real>& piece, const Places<Real>& places, std::size_t first,
                           std::size_t count, std::span<const std::complex<Real>> strength,
                           std::span<const double> doppler, EdgeRow<Real>& row) {
  TurnedEdges<Real> edges;
  std::complex<Real>* const out = row.samples.data();
  if (doppler.empty()) {
    const Real* const given = reinterpret_cast<const Real*>(strength.data() + first);
    return edge_loop<Real, Degree, Lanes, EdgeTurn::none>(piece, places, count, given, edges, out);
  }
  place_turns(piece, doppler, first, count, places, edges);
  turn_strengths(strength.data() + first, count, edges);
  if (edges.turn == EdgeTurn::faint)
    edge_loop<Real, Degree, Lanes, EdgeTurn::faint>(piece, places, count, edges.strength, edges, out);
  else if (edges.turn == EdgeTurn::slight)
    edge_loop<Real, Degree, Lanes, EdgeTurn::slight>(piece, places, count, edges.strength, edges, out);
  else
    edge_loop<Real, Degree, Lanes, EdgeTurn::any>(piece, places, count, edges.strength, edges, out);
}

#endif  // HWY_SCALAR

template <class Real>
HWY_INLINE void spread_on_target(const LanePolynomials<Real>& taps, std::size_t width, double period,
                                 std::span<const double> position, std::span<const std::complex<Real>> strength,
                                 const SpreadMotion& motion, SpreadGrid<Real>& grid) {
  using Block = Places<Real>;
  const hn::ScalableTag<double> d;
  const hn::Rebind<std::int32_t, decltype(d)> integer;
  const auto cells_per_unit = hn::Set(d, static_cast<double>(grid.cells) / period);
  const auto half_width = hn::Set(d, 0.5 * static_cast<double>(width));
  const auto max_cells = hn::Set(integer, static_cast<std::int32_t>(grid.cells));
  const auto padding = hn::Set(integer, static_cast<std::int32_t>(SpreadGrid<Real>::padding));
  const bool moves = !motion.doppler.empty();
  HWY_ALIGN double buffer[Block::most];
  HWY_ALIGN double speeds[Block::most];
  Block places{};
  for (std::size_t first = 0; first < position.size(); first += Block::most) {
    const std::size_t count = std::min(Block::most, position.size() - first);
    const double* const from = whole_vectors(position, first, count, buffer);
    const double* const moved = moves ? whole_vectors(motion.doppler, first, count, speeds) : speeds;
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
      auto given = hn::LoadU(d, from + k);
      if (moves) {
        const auto speed = hn::Sub(hn::LoadU(d, moved + k), hn::Set(d, motion.middle));
        given = hn::MulAdd(speed, hn::Set(d, motion.shift), given);
        store_narrow(d, hn::Mul(speed, hn::Set(d, motion.tilt)), places.tilt + k);
      }
      const auto wrapped = hn::IfThenElse(hn::Lt(given, hn::Zero(d)), hn::Add(given, hn::Set(d, period)), given);
      const auto left = hn::MulSub(wrapped, cells_per_unit, half_width);
      const auto cell = hn::Ceil(left);
      // Rounding may leave a position beyond the end of the circle.
      const auto on_grid = hn::Min(hn::DemoteTo(integer, cell), max_cells);
      hn::StoreU(hn::Add(on_grid, padding), integer, places.cell + k);
      store_narrow(d, hn::Sub(cell, left), places.fraction + k);
    }
    place_on_pieces(taps, count, places);
    with_shape(taps, [&](auto degree, auto lanes) {
      spread_block<Real, degree(), lanes()>(taps, width, places, first, count, position.size(), strength, grid);
    });
  }
}

template <class Real>
HWY_INLINE void add_edges_on_target(const EdgePiece<Real>& piece, std::span<const double> position,
                                    std::span<const std::complex<Real>> strength, std::span<const double> doppler,
                                    EdgeRow<Real>& row) {
  using Block = Places<Real>;
  const hn::ScalableTag<double> d;
  const auto padding = hn::Set(d, static_cast<double>(EdgeRow<Real>::padding));
  const auto first_useful = hn::Set(d, -0.5 * static_cast<double>(piece.samples.lanes));
  const auto last_useful = hn::Set(d, static_cast<double>(row.count));
  const bool late = piece.late != 0.0 && !doppler.empty();
  HWY_ALIGN double buffer[Block::most];
  HWY_ALIGN double speeds[Block::most];
  Block places{};
  for (std::size_t first = 0; first < position.size(); first += Block::most) {
    const std::size_t count = std::min(Block::most, position.size() - first);
    const double* const from = whole_vectors(position, first, count, buffer);
    const double* const moved = late ? whole_vectors(doppler, first, count, speeds) : speeds;
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
      auto start = hn::Add(hn::LoadU(d, from + k), hn::Set(d, piece.start));
      if (late) start = hn::MulAdd(hn::LoadU(d, moved + k), hn::Set(d, piece.late), start);
      const auto sample = hn::Ceil(hn::Sub(start, hn::Set(d, 1e-9)));
      const auto fraction = hn::Max(hn::Zero(d), hn::Sub(sample, start));
      const auto useful = hn::And(hn::Gt(sample, first_useful), hn::Lt(sample, last_useful));
      // What is of no use goes where nobody looks, to the beginning of the padding.
      store_integers(d, hn::IfThenElseZero(useful, hn::Add(sample, padding)), places.cell + k);
      store_narrow(d, fraction, places.fraction + k);
    }
    place_on_pieces(piece.samples, count, places);
    with_shape(piece.samples, [&](auto degree, auto lanes) {
      edge_block<Real, degree(), lanes()>(piece, places, first, count, strength, doppler, row);
    });
  }
}

void spread_single(const LanePolynomials<float>& taps, std::size_t width, double period,
                   std::span<const double> position, std::span<const std::complex<float>> strength,
                   const SpreadMotion& motion, SpreadGrid<float>& grid) {
  spread_on_target(taps, width, period, position, strength, motion, grid);
}
void spread_double(const LanePolynomials<double>& taps, std::size_t width, double period,
                   std::span<const double> position, std::span<const std::complex<double>> strength,
                   const SpreadMotion& motion, SpreadGrid<double>& grid) {
  spread_on_target(taps, width, period, position, strength, motion, grid);
}
void edges_single(const EdgePiece<float>& piece, std::span<const double> position,
                  std::span<const std::complex<float>> strength, std::span<const double> doppler, EdgeRow<float>& row) {
  add_edges_on_target(piece, position, strength, doppler, row);
}
void edges_double(const EdgePiece<double>& piece, std::span<const double> position,
                  std::span<const std::complex<double>> strength, std::span<const double> doppler,
                  EdgeRow<double>& row) {
  add_edges_on_target(piece, position, strength, doppler, row);
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(spread_single);
HWY_EXPORT(spread_double);
HWY_EXPORT(edges_single);
HWY_EXPORT(edges_double);

template <>
void spread(const LanePolynomials<float>& taps, std::size_t width, double period, std::span<const double> position,
            std::span<const std::complex<float>> strength, const SpreadMotion& motion, SpreadGrid<float>& grid) {
  CORE_EXPECT(width > 0);
  CORE_EXPECT(period > 0.0);
  CORE_EXPECT(strength.size() == position.size() * grid.term.size() ||
              (grid.term.size() == 2 && strength.size() == motion.doppler.size()));
  CORE_EXPECT(motion.doppler.empty() || motion.doppler.size() == position.size());
  HWY_DYNAMIC_DISPATCH(spread_single)(taps, width, period, position, strength, motion, grid);
}
template <>
void spread(const LanePolynomials<double>& taps, std::size_t width, double period, std::span<const double> position,
            std::span<const std::complex<double>> strength, const SpreadMotion& motion, SpreadGrid<double>& grid) {
  CORE_EXPECT(width > 0);
  CORE_EXPECT(period > 0.0);
  CORE_EXPECT(strength.size() == position.size() * grid.term.size() ||
              (grid.term.size() == 2 && strength.size() == motion.doppler.size()));
  CORE_EXPECT(motion.doppler.empty() || motion.doppler.size() == position.size());
  HWY_DYNAMIC_DISPATCH(spread_double)(taps, width, period, position, strength, motion, grid);
}
template <>
void add_edges(const EdgePiece<float>& piece, std::span<const double> position,
               std::span<const std::complex<float>> strength, std::span<const double> doppler, EdgeRow<float>& row) {
  CORE_EXPECT(strength.size() == position.size());
  CORE_EXPECT(doppler.empty() || doppler.size() == position.size());
  HWY_DYNAMIC_DISPATCH(edges_single)(piece, position, strength, doppler, row);
}
template <>
void add_edges(const EdgePiece<double>& piece, std::span<const double> position,
               std::span<const std::complex<double>> strength, std::span<const double> doppler, EdgeRow<double>& row) {
  CORE_EXPECT(strength.size() == position.size());
  CORE_EXPECT(doppler.empty() || doppler.size() == position.size());
  HWY_DYNAMIC_DISPATCH(edges_double)(piece, position, strength, doppler, row);
}

}  // namespace sarsim::radar

#endif

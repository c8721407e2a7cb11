#include "radar/echo/range_bins.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/range_bins.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "radar/echo/piece_places-inl.hpp"
#include "radar/simd/math-inl.hpp"

HWY_BEFORE_NAMESPACE();
#include "core/report/expect.hpp"

namespace sarsim::radar::HWY_NAMESPACE {

// Echoes that follow each other often fall into one bin, and would wait for the sum of the last: a block takes a few
// from each of so many places.
constexpr std::size_t streams = 16;
constexpr std::size_t in_turn = 8;  // of each place; at least the doubles of a vector

constexpr std::size_t floats_of_sum = 2 * BinSums::functions;

// Where the echoes of a block belong.
struct BinPlaces {
  static constexpr std::size_t most = streams * in_turn;
  HWY_ALIGN float place[most];         // p
  HWY_ALIGN float apart[most];         // D from the middle
  HWY_ALIGN float bend[most];          // a from the middle
  HWY_ALIGN std::int32_t sum[most];    // where the sums begin, in floats
  HWY_ALIGN float y[most];             // in the piece, from its middle
  HWY_ALIGN std::int32_t table[most];  // where the polynomials of the piece begin
  HWY_ALIGN float strength[2 * most];
  HWY_ALIGN float bent[2 * most];  // -j dk/most_change times it
};

using Wide = hn::CappedTag<double, in_turn>;
using WideVector = hn::Vec<Wide>;
using Narrow = hn::ScalableTag<float>;

HWY_INLINE WideVector limited(WideVector x, double most) {
  return hn::Max(hn::Zero(Wide()), hn::Min(x, hn::Set(Wide(), most)));
}

// How echoes move: not at all, evenly, or bent.
enum class BinMotion { none, even, bent };

// Finds the places of echoes.
template <BinMotion Motion>
class Placer {
 public:
  HWY_INLINE Placer(const RangeBins& bins, const LanePolynomials<float>& weights, std::uint8_t* marks)
      : bins_(bins),
        pieces_(static_cast<float>(weights.pieces)),
        per_piece_(static_cast<float>((weights.degree + 1) * weights.lanes)),
        per_z_(bins.most_z > 0.0 ? static_cast<float>(0.5 / bins.most_z) * pieces_ : 0.0F),
        per_change_(bins.most_change > 0.0 ? static_cast<float>(1.0 / bins.most_change) : 0.0F),
        marks_(marks) {}

  // Of up to `in_turn` echoes.
  HWY_INLINE void place_some(const Strengths<float>& echoes, std::size_t first, std::size_t count, std::size_t at,
                             BinPlaces& out) const {
    const double* position = echoes.position.data() + first;
    const double* doppler = echoes.doppler.data() + first;
    const float* strength = reinterpret_cast<const float*>(echoes.strength.data() + first);
    const double* bend = bent ? echoes.bend_per_s.data() + first : nullptr;
    HWY_ALIGN double positions[in_turn];
    HWY_ALIGN double dopplers[in_turn];
    HWY_ALIGN double bends[in_turn];
    HWY_ALIGN float strengths[2 * in_turn]{};
    if (count < in_turn) {
      for (std::size_t i = 0; i < in_turn; ++i) {
        positions[i] = position[i < count ? i : 0];
        dopplers[i] = doppler[i < count ? i : 0];
        if constexpr (bent) bends[i] = bend[i < count ? i : 0];
      }
      if constexpr (bent) bend = bends;
      std::copy_n(strength, 2 * count, strengths);
      position = positions;
      doppler = dopplers;
      strength = strengths;
    }
    const hn::CappedTag<float, 2 * in_turn> d;
    for (std::size_t i = 0; i < 2 * in_turn; i += hn::Lanes(d))
      hn::Store(hn::LoadU(d, strength + i), d, out.strength + 2 * at + i);
    for (std::size_t i = 0; i < in_turn; i += hn::Lanes(Wide()))
      place_vector(position + i, doppler + i, bent ? bend + i : nullptr, at + i, out);
  }

  // For a block that is placed: where the echoes stand on the pieces, and their strengths turned by t.
  HWY_INLINE void turn(BinPlaces& out) const {
    const Narrow d;
    const auto of = [&](double x) { return hn::Set(d, static_cast<float>(x)); };
    const auto one = of(1.0);
    for (std::size_t k = 0; k < BinPlaces::most; k += hn::Lanes(d)) {
      const auto place = hn::Load(d, out.place + k);
      auto sweep = of(bins_.sweep);
      auto z = hn::Mul(sweep, place);
      auto turns = hn::Mul(hn::Mul(z, of(0.5)), place);
      auto change = hn::Zero(d);
      if constexpr (moves) {
        const auto apart = hn::Load(d, out.apart + k);
        change = hn::Mul(apart, hn::MulAdd(apart, of(bins_.sweep_square), of(bins_.sweep_slope)));
        if constexpr (bent) change = hn::MulAdd(hn::Load(d, out.bend + k), of(bins_.bend_slope), change);
        const auto swept = hn::MulAdd(change, place, z);
        const auto carried = hn::MulAdd(apart, of(bins_.carrier), of(bins_.carrier * bins_.middle));
        turns = hn::MulAdd(place, hn::MulSub(swept, of(0.5), carried), hn::Mul(change, of(0.5 * bins_.square)));
        z = hn::NegMulAdd(apart, of(bins_.carrier), swept);
      }
      place_on_pieces(z, k, out);
      // Series of angles below a quarter.
      const auto angle = hn::Mul(turns, of(6.283185307179586476925));
      const auto square = hn::Mul(angle, angle);
      const auto c = hn::MulAdd(square, hn::MulAdd(square, of(1.0 / 24.0), of(-0.5)), one);
      const auto s = hn::Mul(angle, hn::MulAdd(square, hn::MulAdd(square, of(1.0 / 120.0), of(-1.0 / 6.0)), one));
      auto re = hn::Zero(d);
      auto im = hn::Zero(d);
      hn::LoadInterleaved2(d, out.strength + 2 * k, re, im);
      const auto turned_re = hn::NegMulAdd(im, s, hn::Mul(re, c));
      const auto turned_im = hn::MulAdd(re, s, hn::Mul(im, c));
      hn::StoreInterleaved2(turned_re, turned_im, d, out.strength + 2 * k);
      if constexpr (moves) {
        const auto bend = hn::Mul(change, hn::Set(d, per_change_));
        hn::StoreInterleaved2(hn::Mul(turned_im, bend), hn::Neg(hn::Mul(turned_re, bend)), d, out.bent + 2 * k);
      }
    }
  }

 private:
  static constexpr bool moves = Motion != BinMotion::none;
  static constexpr bool bent = Motion == BinMotion::bent;

  // A sample within 1e-9 of an end belongs to what follows.
  HWY_INLINE void place_vector(const double* position, const double* doppler, const double* bend, std::size_t at,
                               BinPlaces& out) const {
    const Wide d;
    const auto hair = hn::Set(d, 1e-9);
    const auto x = hn::LoadU(d, position);
    auto begins = hn::Add(x, hn::Set(d, bins_.begin_hard));
    auto ends = hn::Add(x, hn::Set(d, bins_.end_hard));
    if constexpr (moves) {
      const auto speed = hn::LoadU(d, doppler);
      const auto late = hn::MulAdd(speed, hn::MulAdd(speed, speed, speed), speed);  // D/(1 - D) but for D^4
      begins = hn::MulAdd(late, hn::Set(d, bins_.begin_late), begins);
      ends = hn::MulAdd(late, hn::Set(d, bins_.end_late), ends);
      if constexpr (bent) {
        const auto a = hn::LoadU(d, bend);
        begins = hn::MulAdd(a, hn::Set(d, bins_.begin_bent), begins);
        ends = hn::MulAdd(a, hn::Set(d, bins_.end_bent), ends);
        store_narrow(d, hn::Sub(a, hn::Set(d, bins_.bend_middle)), out.bend + at);
      }
      store_narrow(d, hn::Sub(speed, hn::Set(d, bins_.middle)), out.apart + at);
    }
    const auto first = hn::Ceil(hn::Sub(begins, hair));
    store_narrow(d, hn::Sub(hn::Sub(first, x), hn::Set(d, bins_.begin + 0.5)), out.place + at);

    const auto samples = hn::Set(d, static_cast<double>(bins_.samples));
    const auto row = limited(hn::Sub(first, hn::Set(d, bins_.first_sample)), static_cast<double>(bins_.samples - 1));
    const auto per_sum = hn::Set(d, static_cast<double>(floats_of_sum));
    if (bins_.run_count == 1) return store_integers(d, hn::Mul(row, per_sum), out.sum + at);
    const auto more = hn::Sub(hn::Sub(hn::Ceil(hn::Sub(ends, hair)), first), hn::Set(d, bins_.least_samples));
    const auto run = limited(more, static_cast<double>(bins_.run_count - 1));
    store_integers(d, hn::Mul(hn::MulAdd(run, samples, row), per_sum), out.sum + at);
    if (!hn::AllTrue(d, hn::Eq(run, hn::Set(d, static_cast<double>(bins_.main_run))))) mark(out.sum + at);
  }

  void mark(const std::int32_t* HWY_RESTRICT sums) const {
    for (std::size_t i = 0; i < hn::Lanes(Wide()); ++i)
      marks_[static_cast<std::size_t>(sums[i]) / (floats_of_sum * BinSums::rows_of_mark)] = 1;
  }

  HWY_INLINE void place_on_pieces(hn::Vec<Narrow> z, std::size_t k, BinPlaces& out) const {
    const Narrow d;
    const hn::RebindToSigned<Narrow> whole;
    const auto along = hn::MulAdd(z, hn::Set(d, per_z_), hn::Set(d, 0.5F * pieces_));
    const auto piece = hn::Max(hn::Zero(d), hn::Min(hn::Floor(along), hn::Set(d, pieces_ - 1.0F)));
    hn::Store(hn::ConvertTo(whole, hn::Mul(piece, hn::Set(d, per_piece_))), whole, out.table + k);
    hn::Store(hn::Sub(hn::Sub(along, piece), hn::Set(d, 0.5F)), d, out.y + k);
  }

  const RangeBins& bins_;
  float pieces_;
  float per_piece_;  // coefficients
  float per_z_;
  float per_change_;
  std::uint8_t* marks_;  // of the sums of all runs
};

#if HWY_TARGET == HWY_SCALAR

// One lane holds no pair of a real and an imaginary part: plain loops.
template <std::size_t Degree, bool Bends>
class Adder {
 public:
  Adder(const LanePolynomials<float>& weights, std::complex<float>* sums) : weights_(weights), sums_(sums) {}

  void add(const BinPlaces& places, std::size_t k) const {
    float* const at = reinterpret_cast<float*>(sums_) + places.sum[k];
    for (std::size_t f = 0; f < BinSums::functions; ++f)
      for (std::size_t part = 0; part < 2; ++part) {
        at[2 * f + part] += weight(places, k, f) * places.strength[2 * k + part];
        if (Bends) at[2 * f + part] += weight(places, k, BinSums::functions + f) * places.bent[2 * k + part];
      }
  }

 private:
  float weight(const BinPlaces& places, std::size_t k, std::size_t lane) const {
    const float* from = weights_.coefficients.data() + places.table[k] + lane;
    float sum = from[0];
    for (std::size_t p = 1; p <= weights_.degree; ++p) sum = sum * places.y[k] + from[p * weights_.lanes];
    return sum;
  }

  const LanePolynomials<float>& weights_;
  std::complex<float>* sums_;
};

#else

// Adds strengths times their weights.
template <std::size_t Degree, bool Bends>
class Adder {
 public:
  HWY_INLINE Adder(const LanePolynomials<float>& weights, std::complex<float>* sums)
      : weights_(weights), sums_(reinterpret_cast<float*>(sums)) {}

  HWY_INLINE void add(const BinPlaces& places, std::size_t k) const {
    float* HWY_RESTRICT at = sums_ + places.sum[k];
    const auto pair = in_all_pairs(Wide(), places.strength + 2 * k);
    if constexpr (Bends) {
      const auto bent = in_all_pairs(Wide(), places.bent + 2 * k);
      if constexpr (hn::MaxLanes(Wide()) == 2 * functions) {
        add_both(places, k, pair, bent, at);
      } else {
        add_some(places, k, 0, pair, at);
        add_some(places, k, functions, bent, at);
      }
    } else {
      add_some(places, k, 0, pair, at);
    }
  }

 private:
  static constexpr std::size_t functions = BinSums::functions;
  using Wide = hn::CappedTag<float, 2 * functions>;

  // By the functions from a lane on.
  template <class V>
  HWY_INLINE void add_some(const BinPlaces& places, std::size_t k, std::size_t lane, V pair,
                           float* HWY_RESTRICT at) const {
    const hn::CappedTag<float, functions> d;
    const auto y = hn::Set(d, places.y[k]);
    for (std::size_t f = 0; f < functions; f += hn::Lanes(d))
      add_weighted(d, weights_.at(d, places.table[k], lane + f, y), pair, at + 2 * f);
  }

  // All weights are one vector.
  template <class V>
  HWY_INLINE void add_both(const BinPlaces& places, std::size_t k, V pair, V bent, float* HWY_RESTRICT at) const {
    const Wide d;
    auto sum = hn::Load(d, at);
    each_twice(d, weights_.at(d, places.table[k], 0, hn::Set(d, places.y[k])),
               [&](std::size_t lane, V each) { sum = hn::MulAdd(each, lane == 0 ? pair : bent, sum); });
    hn::Store(sum, d, at);
  }

  Polynomials<float, Degree, 2 * functions> weights_;
  float* sums_;
};

#endif  // HWY_SCALAR

template <BinMotion Motion, std::size_t Degree>
void add_all(const RangeBins& bins, const LanePolynomials<float>& weights, const Strengths<float>& echoes,
             BinSums& out) {
  const Placer<Motion> placer(bins, weights, out.marks.data());
  const Adder<Degree, Motion != BinMotion::none> adder(weights, out.sums.data());
  BinPlaces places{};
  const std::size_t part = echoes.position.size() / streams;
  for (std::size_t from = 0; from < part; from += in_turn) {
    const std::size_t count = std::min(in_turn, part - from);
    for (std::size_t s = 0; s < streams; ++s) placer.place_some(echoes, s * part + from, count, s * in_turn, places);
    placer.turn(places);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t s = 0; s < streams; ++s) adder.add(places, s * in_turn + i);
  }
  for (std::size_t from = streams * part; from < echoes.position.size(); from += in_turn) {
    const std::size_t count = std::min(in_turn, echoes.position.size() - from);
    placer.place_some(echoes, from, count, 0, places);
    placer.turn(places);
    for (std::size_t i = 0; i < count; ++i) adder.add(places, i);
  }
}

void add_on_target(const RangeBins& bins, const LanePolynomials<float>& weights, const Strengths<float>& echoes,
                   BinSums& out) {
  constexpr std::size_t usual = 3;  // degree
  if (weights.degree != usual || bins.bends)
    bins.bends   ? add_all<BinMotion::bent, 0>(bins, weights, echoes, out)
    : bins.moves ? add_all<BinMotion::even, 0>(bins, weights, echoes, out)
                 : add_all<BinMotion::none, 0>(bins, weights, echoes, out);
  else
    bins.moves ? add_all<BinMotion::even, usual>(bins, weights, echoes, out)
               : add_all<BinMotion::none, usual>(bins, weights, echoes, out);
}

#if HWY_TARGET != HWY_SCALAR

// The sum of a number's real parts and that of its imaginary parts, from lanes that hold them in turn.
template <class D>
HWY_INLINE std::complex<float> sum_of_pairs(D d, hn::Vec<D> pairs) {
  if constexpr (hn::MaxLanes(d) > 2) {
    const hn::Half<D> half;
    return sum_of_pairs(half, hn::Add(hn::LowerHalf(half, pairs), hn::UpperHalf(half, pairs)));
  } else {
    HWY_ALIGN float parts[2];
    hn::Store(pairs, d, parts);
    return {parts[0], parts[1]};
  }
}

#endif

// What a tail says of the sums of a bin.
HWY_INLINE std::complex<float> sample_of(const BinTail& tail, const float* HWY_RESTRICT sums) {
  constexpr std::size_t lanes = 2 * BinSums::functions;
#if HWY_TARGET == HWY_SCALAR
  std::complex<float> result;
  for (std::size_t i = 0; i < lanes; i += 2)
    result += std::complex<float>(sums[i] * tail.of_same[i] + sums[i + 1] * tail.of_other[i],
                                  sums[i + 1] * tail.of_same[i + 1] + sums[i] * tail.of_other[i + 1]);
  return result;
#else
  const hn::CappedTag<float, lanes> d;
  auto all = hn::Zero(d);
  for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
    const auto sum = hn::Load(d, sums + lane);
    all = hn::MulAdd(sum, hn::LoadU(d, tail.of_same.data() + lane), all);
    all = hn::MulAdd(hn::Reverse2(d, sum), hn::LoadU(d, tail.of_other.data() + lane), all);
  }
  return sum_of_pairs(d, all);
#endif
}

// Adds the sums of other runs to those of the main run, and what that does not tell of them to the edges.
void join_runs(const RangeBins& bins, std::span<const BinTail> tails, BinSums& sums,
               std::span<std::complex<float>> edges) {
  constexpr std::size_t lanes = 2 * BinSums::functions;
  const hn::CappedTag<float, lanes> d;
  float* const all = reinterpret_cast<float*>(sums.sums.data());
  const auto last = static_cast<std::ptrdiff_t>(edges.size());
  const auto join = [&](std::size_t run, std::size_t n) {
    float* HWY_RESTRICT others = all + (run * bins.samples + n) * lanes;
    float* HWY_RESTRICT main = all + (bins.main_run * bins.samples + n) * lanes;
    for (const BinTail& tail : tails) {
      const std::ptrdiff_t at =
          static_cast<std::ptrdiff_t>(bins.first_sample) + static_cast<std::ptrdiff_t>(n) + tail.sample;
      if (tail.run == run && at >= 0 && at < last) edges[static_cast<std::size_t>(at)] += sample_of(tail, others);
    }
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
      hn::Store(hn::Add(hn::Load(d, main + lane), hn::Load(d, others + lane)), d, main + lane);
      hn::Store(hn::Zero(d), d, others + lane);
    }
  };
  for (std::size_t mark = 0; mark < sums.marks.size(); ++mark) {
    if (std::exchange(sums.marks[mark], 0) == 0) continue;
    const std::size_t begin = mark * BinSums::rows_of_mark;
    const std::size_t end = std::min(bins.run_count * bins.samples, begin + BinSums::rows_of_mark);
    for (std::size_t i = begin; i < end; ++i)
      if (const std::size_t run = i / bins.samples; run != bins.main_run) join(run, i - run * bins.samples);
  }
}

// Moves `count` sums of each function to rows from sample `at` on, and leaves 0.
void move_to_rows(std::complex<float>* HWY_RESTRICT sums, std::size_t count, std::size_t at,
                  std::span<const std::span<std::complex<float>>, BinSums::functions> rows) {
  constexpr std::size_t functions = BinSums::functions;
  std::size_t n = 0;
#if HWY_TARGET != HWY_SCALAR
  // A complex number is moved as a double; four by four, or two by two.
  const hn::CappedTag<double, 4> d;
  constexpr std::size_t block = hn::MaxLanes(d);
  double* const from = reinterpret_cast<double*>(sums);
  for (; n + block <= count; n += block)
    for (std::size_t k = 0; k < functions; k += block) {
      const auto in = [&](std::size_t i) { return hn::LoadU(d, from + (n + i) * functions + k); };
      const auto out = [&](std::size_t i, auto v) {
        hn::StoreU(v, d, reinterpret_cast<double*>(rows[k + i].data() + at + n));
      };
      const auto a = hn::InterleaveLower(d, in(0), in(1));
      const auto b = hn::InterleaveUpper(d, in(0), in(1));
      if constexpr (block == 2) {
        out(0, a);
        out(1, b);
      } else {
        const auto e = hn::InterleaveLower(d, in(2), in(3));
        const auto f = hn::InterleaveUpper(d, in(2), in(3));
        out(0, hn::ConcatLowerLower(d, e, a));
        out(1, hn::ConcatLowerLower(d, f, b));
        out(2, hn::ConcatUpperUpper(d, e, a));
        out(3, hn::ConcatUpperUpper(d, f, b));
      }
    }
#endif
  for (; n < count; ++n)
    for (std::size_t k = 0; k < functions; ++k) rows[k][at + n] = sums[n * functions + k];
  std::fill_n(sums, count * functions, std::complex<float>());
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(add_on_target);
HWY_EXPORT(join_runs);
HWY_EXPORT(move_to_rows);

void BinSums::make_room(const RangeBins& bins) {
  sums.resize(bins.run_count * bins.samples * functions);
  marks.resize(bins.run_count * bins.samples / rows_of_mark + 1);
}

void BinSums::clear() {
  sums.clear();
  marks.clear();
}

void BinTail::set(std::size_t function, std::complex<double> factor) {
  CORE_EXPECT(function < BinSums::functions);
  of_same[2 * function] = of_same[2 * function + 1] = static_cast<float>(factor.real());
  of_other[2 * function] = static_cast<float>(-factor.imag());
  of_other[2 * function + 1] = static_cast<float>(factor.imag());
}

void add_to_bins(const RangeBins& bins, const LanePolynomials<float>& weights, const Strengths<float>& echoes,
                 BinSums& out) {
  CORE_EXPECT(bins.run_count >= 1 && bins.run_count <= RangeBins::most_runs);
  CORE_EXPECT(bins.samples > 0);
  CORE_EXPECT(out.sums.size() == bins.run_count * bins.samples * BinSums::functions);
  CORE_EXPECT(weights.lanes == 2 * BinSums::functions);
  CORE_EXPECT(echoes.strength.size() == echoes.position.size());
  CORE_EXPECT(echoes.doppler.size() == echoes.position.size());
  CORE_EXPECT(!bins.bends || echoes.bend_per_s.size() == echoes.position.size());
  HWY_DYNAMIC_DISPATCH(add_on_target)(bins, weights, echoes, out);
}

void leave_bins(const RangeBins& bins, std::span<const BinTail> tails, BinSums& sums, std::size_t first,
                std::span<const std::span<std::complex<float>>, BinSums::functions> rows,
                std::span<std::complex<float>> edges) {
  constexpr std::size_t functions = BinSums::functions;
  const std::size_t period = rows[0].size();
  CORE_EXPECT(first < period);
  CORE_EXPECT(bins.samples <= period);
  if (bins.run_count > 1) HWY_DYNAMIC_DISPATCH(join_runs)(bins, tails, sums, edges);
  std::complex<float>* from = sums.sums.data() + bins.main_run * bins.samples * functions;
  const auto move = [&](std::size_t count, std::size_t at) {
    HWY_DYNAMIC_DISPATCH(move_to_rows)(from, count, at, rows);
    from += count * functions;
  };
  const std::size_t to_end = std::min(bins.samples, period - first);
  const std::size_t around = bins.samples - to_end;
  move(to_end, first);
  move(around, 0);
  for (const std::span<std::complex<float>> row : rows) {
    std::ranges::fill(row.subspan(around, first - around), std::complex<float>());
    std::ranges::fill(row.subspan(first + to_end), std::complex<float>());
  }
}

}  // namespace sarsim::radar

#endif

#include "radar/echo/slepian_sums.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/maths/constants.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/slepian_sums.cpp"
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

constexpr std::size_t functions = BinSums::functions;
constexpr std::size_t floats_of_sum = 2 * functions;

// Where the echoes of a block belong.
struct BinPlaces {
  static constexpr std::size_t most = streams * in_turn;
  HWY_ALIGN float ahead[most];         // n0 less where the echo itself begins, less half a sample
  HWY_ALIGN float apart[most];         // D from the middle
  HWY_ALIGN float bend[most];          // a from the middle
  HWY_ALIGN std::int32_t sum[most];    // where the sums begin, in floats
  HWY_ALIGN float y[most];             // in the piece, from its middle
  HWY_ALIGN std::int32_t table[most];  // where the polynomials of the piece begin
  HWY_ALIGN float strength[2 * most];  // as it comes,
  HWY_ALIGN float re[most];            // and turned
  HWY_ALIGN float im[most];
  HWY_ALIGN float bent[most];  // what half of a second derivative by y counts, times -j
};

using Wide = hn::CappedTag<double, in_turn>;
using WideVector = hn::Vec<Wide>;
using Narrow = hn::ScalableTag<float>;

// How echoes move: not at all, evenly, or bent.
enum class BinMotion { none, even, bent };

// A polynomial of D and a about their middles.
struct Shift {
  double at_middle, slope, square, bent;

  // What hard + late D/(1 - D) + bend a is but for (D - middle)^3.
  Shift(const SlepianSums& bins, double hard, double late, double bend) : bent(bend) {
    const double rate = 1.0 / (1.0 - bins.middle);
    at_middle = hard + late * bins.middle * rate + bend * bins.bend_middle;
    slope = late * rate * rate;
    square = slope * rate;
  }
};

// Where bins put echoes.
struct Placing {
  static constexpr double hair = 1e-9;  // a sample so close to an end belongs to what follows

  explicit Placing(const SlepianSums& bins)
      : begin(bins, bins.begin_hard, bins.begin_late, bins.begin_bent),
        length(bins, bins.end_hard - bins.begin_hard, bins.end_late - bins.begin_late, bins.end_bent - bins.begin_bent),
        middle(bins.middle),
        bend_middle(bins.bend_middle),
        first_sample(bins.first_sample),
        main_run(static_cast<double>(bins.main_run)),
        rows(static_cast<std::int32_t>(bins.samples)),
        runs(static_cast<std::int32_t>(bins.run_count)),
        main_rows(static_cast<std::int32_t>(bins.main_run * bins.samples)) {
    begin.at_middle += 0.5 - hair;
    length.at_middle -= 0.5 + bins.min_samples;
    main_middle = length.at_middle - main_run + 0.5;
    main_half = 0.5 - bins.apart - hair;
  }

  Shift begin;   // half a sample less a hair after where an echo begins: rounded, the first sample that it reaches
  Shift length;  // beyond the least number of samples, less half a sample
  double middle, bend_middle;
  double first_sample, main_run;
  double main_middle, main_half;  // of what is ahead of echoes that are of the main run, however they move
  std::int32_t rows, runs, main_rows;
};

// What bins turn echoes by, in single precision.
struct Turning {
  Turning(const SlepianSums& bins, const Placing& placing, const LanePolynomials<float>& weights)
      : sweep(static_cast<float>(bins.sweep)),
        sweep_slope(static_cast<float>(bins.sweep_slope)),
        sweep_square(static_cast<float>(bins.sweep_square)),
        bend_slope(static_cast<float>(bins.bend_slope)),
        carrier(static_cast<float>(bins.carrier)),
        carried(static_cast<float>(bins.carrier * bins.middle)),
        half_square(static_cast<float>(0.5 * bins.square)),
        begin_slope(static_cast<float>(placing.begin.slope)),
        begin_square(static_cast<float>(placing.begin.square)),
        begin_bent(static_cast<float>(placing.begin.bent)),
        begin_bent_middle(static_cast<float>(placing.begin.bent * bins.bend_middle)),
        pieces(static_cast<float>(weights.pieces)),
        per_piece(static_cast<float>((weights.degree + 1) * weights.lanes)) {
    if (!(bins.max_z > 0.0)) return;
    const double z = bins.max_z / static_cast<double>(weights.pieces);  // half a piece
    per_z = static_cast<float>(0.5 / z);
    if (!(bins.max_change > 0.0)) return;
    per_change = static_cast<float>(1.0 / (8.0 * core::pi * z * z));
    per_bend = static_cast<float>(8.0 * core::pi * core::pi * z * z * bins.square);
  }

  float sweep, sweep_slope, sweep_square, bend_slope, carrier, carried, half_square;
  float begin_slope, begin_square, begin_bent, begin_bent_middle;  // of p
  float pieces;
  float per_piece;          // coefficients
  float per_z = 0.0F;       // pieces
  float per_change = 0.0F;  // what half of a second derivative counts for each unit of dk,
  float per_bend = 0.0F;    // and the function itself for each unit of that
};

// Finds the places of echoes.
template <BinMotion Motion>
class Placer {
 public:
  HWY_INLINE Placer(const SlepianSums& bins, const LanePolynomials<float>& weights, std::uint64_t* marks)
      : placing_(bins), turning_(bins, placing_, weights), marks_(marks) {}

  [[nodiscard]] HWY_INLINE float per_bend() const { return turning_.per_bend; }

  // Of up to `in_turn` echoes.
  HWY_INLINE void place_some(const Strengths<float>& echoes, std::size_t first, std::size_t count, std::size_t at,
                             BinPlaces& out) const {
    const double* position = echoes.position.data() + first;
    const double* doppler = echoes.doppler.data() + first;
    const float* strength = reinterpret_cast<const float*>(echoes.strength.data() + first);
    const double* bend = bent ? echoes.dilation_rate.data() + first : nullptr;
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
    const auto of = [&](float x) { return hn::Set(d, x); };
    const auto one = of(1.0F);
    for (std::size_t k = 0; k < BinPlaces::most; k += hn::Lanes(d)) {
      auto place = hn::Load(d, out.ahead + k);
      auto change = hn::Zero(d);
      auto z = hn::Zero(d);
      auto turns = hn::Zero(d);
      if constexpr (moves) {
        const auto apart = hn::Load(d, out.apart + k);
        place = hn::MulAdd(apart, hn::MulAdd(apart, of(turning_.begin_square), of(turning_.begin_slope)), place);
        change = hn::Mul(apart, hn::MulAdd(apart, of(turning_.sweep_square), of(turning_.sweep_slope)));
        if constexpr (bent) {
          const auto bend = hn::Load(d, out.bend + k);
          place = hn::Add(hn::MulAdd(bend, of(turning_.begin_bent), place), of(turning_.begin_bent_middle));
          change = hn::MulAdd(bend, of(turning_.bend_slope), change);
        }
        const auto swept = hn::Mul(hn::Add(of(turning_.sweep), change), place);
        const auto carried = hn::MulAdd(apart, of(turning_.carrier), of(turning_.carried));
        turns = hn::MulAdd(place, hn::MulSub(swept, of(0.5F), carried), hn::Mul(change, of(turning_.half_square)));
        z = hn::NegMulAdd(apart, of(turning_.carrier), swept);
      } else {
        z = hn::Mul(of(turning_.sweep), place);
        turns = hn::Mul(hn::Mul(z, of(0.5F)), place);
      }
      place_on_pieces(z, k, out);
      // Series of angles below a quarter.
      const auto angle = hn::Mul(turns, of(6.283185307179586F));
      const auto square = hn::Mul(angle, angle);
      const auto c = hn::MulAdd(square, hn::MulAdd(square, of(1.0F / 24.0F), of(-0.5F)), one);
      const auto s = hn::Mul(angle, hn::MulAdd(square, hn::MulAdd(square, of(1.0F / 120.0F), of(-1.0F / 6.0F)), one));
      auto from_re = hn::Zero(d);
      auto from_im = hn::Zero(d);
      hn::LoadInterleaved2(d, out.strength + 2 * k, from_re, from_im);
      hn::Store(hn::NegMulAdd(from_im, s, hn::Mul(from_re, c)), d, out.re + k);
      hn::Store(hn::MulAdd(from_re, s, hn::Mul(from_im, c)), d, out.im + k);
      if constexpr (moves) hn::Store(hn::Mul(change, of(turning_.per_change)), d, out.bent + k);
    }
  }

 private:
  static constexpr bool moves = Motion != BinMotion::none;
  static constexpr bool bent = Motion == BinMotion::bent;

  HWY_INLINE WideVector shifted(const Shift& shift, WideVector apart, WideVector bend, WideVector x) const {
    const Wide d;
    if constexpr (moves) x = hn::MulAdd(apart, hn::MulAdd(apart, hn::Set(d, shift.square), hn::Set(d, shift.slope)), x);
    if constexpr (bent) x = hn::MulAdd(bend, hn::Set(d, shift.bent), x);
    return x;
  }

  HWY_INLINE void place_vector(const double* position, const double* doppler, const double* bend, std::size_t at,
                               BinPlaces& out) const {
    const Wide d;
    auto apart = hn::Zero(d);
    auto bends = hn::Zero(d);
    if constexpr (moves) {
      apart = hn::Sub(hn::LoadU(d, doppler), hn::Set(d, placing_.middle));
      store_narrow(d, apart, out.apart + at);
    }
    if constexpr (bent) {
      bends = hn::Sub(hn::LoadU(d, bend), hn::Set(d, placing_.bend_middle));
      store_narrow(d, bends, out.bend + at);
    }
    const auto from = hn::Add(hn::LoadU(d, position), hn::Set(d, placing_.begin.at_middle));
    const auto begins = shifted(placing_.begin, apart, bends, from);
    const auto first = hn::Round(begins);
    const auto ahead = hn::Sub(first, begins);
    store_narrow(d, ahead, out.ahead + at);

    const hn::Rebind<std::int32_t, Wide> integer;
    const auto limited = [&](WideVector whole, std::int32_t count) {
      return hn::Max(hn::Zero(integer), hn::Min(hn::DemoteTo(integer, whole), hn::Set(integer, count - 1)));
    };
    auto row = limited(hn::Sub(first, hn::Set(d, placing_.first_sample)), placing_.rows);
    const auto put = [&](hn::Vec<decltype(integer)> place) {
      static_assert(floats_of_sum == 16);
      hn::StoreU(hn::ShiftLeft<4>(place), integer, out.sum + at);
    };
    if (placing_.runs == 1) return put(row);
    const auto off = hn::Abs(hn::Sub(ahead, hn::Set(d, placing_.main_middle)));
    if (HWY_LIKELY(hn::AllTrue(d, hn::Lt(off, hn::Set(d, placing_.main_half)))))
      return put(hn::Add(row, hn::Set(integer, placing_.main_rows)));
    const auto length = shifted(placing_.length, apart, bends, hn::Set(d, placing_.length.at_middle));
    const auto run = limited(hn::Ceil(hn::Sub(length, ahead)), placing_.runs);
    put(hn::Add(row, hn::Mul(run, hn::Set(integer, placing_.rows))));
    mark(out.sum + at);
  }

  void mark(const std::int32_t* HWY_RESTRICT sums) const {
    for (std::size_t i = 0; i < hn::Lanes(Wide()); ++i) {
      const std::size_t place = static_cast<std::size_t>(sums[i]) / floats_of_sum;
      marks_[place / 64] |= std::uint64_t{1} << place % 64;
    }
  }

  HWY_INLINE void place_on_pieces(hn::Vec<Narrow> z, std::size_t k, BinPlaces& out) const {
    const Narrow d;
    const auto along = hn::MulAdd(z, hn::Set(d, turning_.per_z), hn::Set(d, 0.5F * turning_.pieces - 0.5F));
    const auto piece = hn::Max(hn::Zero(d), hn::Min(hn::Round(along), hn::Set(d, turning_.pieces - 1.0F)));
    const auto table = small_integers(d, hn::Mul(piece, hn::Set(d, turning_.per_piece)));
    hn::Store(table, hn::RebindToSigned<Narrow>(), out.table + k);
    hn::Store(hn::Sub(along, piece), d, out.y + k);
  }

  Placing placing_;
  Turning turning_;
  std::uint64_t* marks_;  // of the sums of all runs
};

// Adds strengths times their weights, and what bends add to these: half of the second derivative of the polynomials
// times another strength.
template <std::size_t Degree, bool Bends>
class Adder {
 public:
  HWY_INLINE Adder(const LanePolynomials<float>& weights, float per_bend, float* sums)
      : coefficients_(weights.coefficients.data()), degree_(weights.degree), per_bend_(per_bend), sums_(sums) {}

  HWY_INLINE void add(const BinPlaces& places, std::size_t k) const {
    const D d;
    float* HWY_RESTRICT at = sums_ + places.sum[k];
    const float* HWY_RESTRICT from = coefficients_ + places.table[k];
    const V y = hn::Set(d, places.y[k]);
    for (std::size_t f = 0; f < functions; f += hn::Lanes(d)) {
      V re = hn::Load(d, at + f);
      V im = hn::Load(d, at + functions + f);
      V c = hn::Load(d, from + f);  // of y^m
      V weight = c;
      V bend = hn::Zero(d);  // of the sum of c y^m, that of m (m - 1)/2 c y^(m - 2)
      for (std::size_t m = degree(); m > 0; --m) {
        if (Bends && m >= 2) {
          const V own = m > 2 ? hn::Mul(c, half_product(m)) : c;
          bend = m == degree() ? own : hn::MulAdd(bend, y, own);
        }
        c = hn::Load(d, from + (degree() - m + 1) * functions + f);
        weight = hn::MulAdd(weight, y, c);
      }
      const V by_re = hn::Set(d, places.re[k]);
      const V by_im = hn::Set(d, places.im[k]);
      if constexpr (Bends) {
        bend = hn::Mul(hn::MulAdd(weight, hn::Set(d, per_bend_), bend), hn::Set(d, places.bent[k]));
        re = hn::MulAdd(bend, by_im, re);
        im = hn::NegMulAdd(bend, by_re, im);
      }
      hn::Store(hn::MulAdd(weight, by_re, re), d, at + f);
      hn::Store(hn::MulAdd(weight, by_im, im), d, at + functions + f);
    }
  }

 private:
  using D = hn::CappedTag<float, functions>;
  using V = hn::Vec<D>;

  HWY_INLINE std::size_t degree() const { return Degree > 0 ? Degree : degree_; }
  static HWY_INLINE V half_product(std::size_t m) { return hn::Set(D(), static_cast<float>(m * (m - 1) / 2)); }

  const float* HWY_RESTRICT coefficients_;
  std::size_t degree_;
  float per_bend_;
  float* sums_;
};

template <BinMotion Motion, std::size_t Degree>
void add_all(const SlepianSums& bins, const LanePolynomials<float>& weights, const Strengths<float>& echoes,
             BinSums& out) {
  const Placer<Motion> placer(bins, weights, out.marks.data());
  const Adder<Degree, Motion != BinMotion::none> adder(weights, placer.per_bend(), out.sums.data());
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

void add_on_target(const SlepianSums& bins, const LanePolynomials<float>& weights, const Strengths<float>& echoes,
                   BinSums& out) {
  if (bins.bends) return add_all<BinMotion::bent, 0>(bins, weights, echoes, out);
  switch (weights.degree) {
    case 2:
      return bins.moves ? add_all<BinMotion::even, 2>(bins, weights, echoes, out)
                        : add_all<BinMotion::none, 2>(bins, weights, echoes, out);
    case 3:
      return bins.moves ? add_all<BinMotion::even, 3>(bins, weights, echoes, out)
                        : add_all<BinMotion::none, 3>(bins, weights, echoes, out);
    default:
      return bins.moves ? add_all<BinMotion::even, 0>(bins, weights, echoes, out)
                        : add_all<BinMotion::none, 0>(bins, weights, echoes, out);
  }
}

// What a tail says of the sums of a bin.
HWY_INLINE std::complex<float> sample_of(const BinTail& tail, const float* HWY_RESTRICT sums) {
  const hn::CappedTag<float, functions> d;
  auto re = hn::Zero(d);
  auto im = hn::Zero(d);
  for (std::size_t f = 0; f < functions; f += hn::Lanes(d)) {
    const auto sum_re = hn::Load(d, sums + f);
    const auto sum_im = hn::Load(d, sums + functions + f);
    const auto factor_re = hn::LoadU(d, tail.re.data() + f);
    const auto factor_im = hn::LoadU(d, tail.im.data() + f);
    re = hn::MulAdd(sum_re, factor_re, hn::NegMulAdd(sum_im, factor_im, re));
    im = hn::MulAdd(sum_re, factor_im, hn::MulAdd(sum_im, factor_re, im));
  }
  return {hn::GetLane(hn::SumOfLanes(d, re)), hn::GetLane(hn::SumOfLanes(d, im))};
}

// Adds the sums of other runs to those of the main run, and what that does not tell of them to lone samples.
void join_runs(const SlepianSums& bins, std::span<const BinTail> tails, BinSums& sums, std::size_t count,
               std::vector<LoneSample>& lone) {
  constexpr std::size_t lanes = floats_of_sum;
  const hn::CappedTag<float, lanes> d;
  float* const all = sums.sums.data();
  const auto join = [&](std::size_t run, std::size_t n) {
    float* HWY_RESTRICT others = all + (run * bins.samples + n) * lanes;
    float* HWY_RESTRICT main = all + (bins.main_run * bins.samples + n) * lanes;
    for (const BinTail& tail : tails) {
      const std::ptrdiff_t at =
          static_cast<std::ptrdiff_t>(bins.first_sample) + static_cast<std::ptrdiff_t>(n) + tail.sample;
      if (tail.run == run && at >= 0 && at < static_cast<std::ptrdiff_t>(count))
        lone.push_back({static_cast<std::size_t>(at), sample_of(tail, others)});
    }
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
      hn::Store(hn::Add(hn::Load(d, main + lane), hn::Load(d, others + lane)), d, main + lane);
      hn::Store(hn::Zero(d), d, others + lane);
    }
  };
  for (std::size_t word = 0; word < sums.marks.size(); ++word)
    for (std::uint64_t marks = std::exchange(sums.marks[word], 0); marks != 0; marks &= marks - 1) {
      const std::size_t place = 64 * word + static_cast<std::size_t>(std::countr_zero(marks));
      const std::size_t run = place / bins.samples;
      if (run != bins.main_run) join(run, place - run * bins.samples);
    }
}

// Moves `count` sums of each function to rows from sample `at` on, and leaves 0.
void move_to_rows(float* HWY_RESTRICT sums, std::size_t count, std::size_t at,
                  std::span<const std::span<std::complex<float>>, functions> rows) {
  std::size_t n = 0;
#if HWY_TARGET != HWY_SCALAR
  // Real and imaginary parts of four functions, or two, become complex numbers, moved as doubles; and four by four, or
  // two by two, those of one function neighbours.
  const hn::CappedTag<float, functions> floats;
  const hn::RepartitionToWide<decltype(floats)> d;
  constexpr std::size_t block = hn::MaxLanes(d);
  const auto numbers = [&](std::size_t i, std::size_t half, auto joined) {
    const float* const from = sums + i * floats_of_sum + half * 2 * block;
    return hn::BitCast(d, joined(hn::Load(floats, from), hn::Load(floats, from + functions)));
  };
  const auto lower = [&](auto re, auto im) { return hn::InterleaveLower(floats, re, im); };
  const auto upper = [&](auto re, auto im) { return hn::InterleaveUpper(floats, re, im); };
  const auto out = [&](std::size_t function, auto v) {
    hn::StoreU(v, d, reinterpret_cast<double*>(rows[function].data() + at + n));
  };
  const auto move = [&](std::size_t half, std::size_t first, std::size_t second, auto joined) {
    const auto in = [&](std::size_t i) { return numbers(n + i, half, joined); };
    const auto a = hn::InterleaveLower(d, in(0), in(1));
    const auto b = hn::InterleaveUpper(d, in(0), in(1));
    if constexpr (block == 2) {
      out(first, a);
      out(first + 1, b);
    } else {
      const auto e = hn::InterleaveLower(d, in(2), in(3));
      const auto f = hn::InterleaveUpper(d, in(2), in(3));
      out(first, hn::ConcatLowerLower(d, e, a));
      out(first + 1, hn::ConcatLowerLower(d, f, b));
      out(second, hn::ConcatUpperUpper(d, e, a));
      out(second + 1, hn::ConcatUpperUpper(d, f, b));
    }
  };
  const auto zero = hn::Zero(floats);
  for (; n + block <= count; n += block) {
    for (std::size_t half = 0; half < functions / (2 * block); ++half) {
      const std::size_t function = half * 2 * block;
      move(half, function, function + 4, lower);
      move(half, function + 2, function + 6, upper);
    }
    for (std::size_t i = 0; i < block * floats_of_sum; i += hn::Lanes(floats))
      hn::Store(zero, floats, sums + n * floats_of_sum + i);
  }
#endif
  for (; n < count; ++n)
    for (std::size_t k = 0; k < functions; ++k) {
      float* const sum = sums + n * floats_of_sum + k;
      rows[k][at + n] = {std::exchange(sum[0], 0.0F), std::exchange(sum[functions], 0.0F)};
    }
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(add_on_target);
HWY_EXPORT(join_runs);
HWY_EXPORT(move_to_rows);

void BinSums::make_room(const SlepianSums& bins) {
  sums.resize(bins.run_count * bins.samples * 2 * functions);
  marks.resize(bins.run_count * bins.samples / 64 + 1);
}

void BinSums::clear() {
  sums.clear();
  marks.clear();
}

void BinTail::set(std::size_t function, std::complex<double> factor) {
  CORE_EXPECT(function < BinSums::functions);
  re[function] = static_cast<float>(factor.real());
  im[function] = static_cast<float>(factor.imag());
}

void add_to_bins(const SlepianSums& bins, const LanePolynomials<float>& weights, const Strengths<float>& echoes,
                 BinSums& out) {
  CORE_EXPECT(bins.run_count >= 1 && bins.run_count <= SlepianSums::max_runs);
  CORE_EXPECT(bins.samples > 0);
  CORE_EXPECT(out.sums.size() == bins.run_count * bins.samples * 2 * BinSums::functions);
  CORE_EXPECT(weights.lanes == BinSums::functions);
  CORE_EXPECT(echoes.strength.size() == echoes.position.size());
  CORE_EXPECT(echoes.doppler.size() == echoes.position.size());
  CORE_EXPECT(!bins.bends || echoes.dilation_rate.size() == echoes.position.size());
  HWY_DYNAMIC_DISPATCH(add_on_target)(bins, weights, echoes, out);
}

void leave_bins(const SlepianSums& bins, std::span<const BinTail> tails, BinSums& sums, std::size_t first,
                std::span<const std::span<std::complex<float>>, BinSums::functions> rows, std::size_t count,
                std::vector<LoneSample>& lone) {
  constexpr std::size_t functions = BinSums::functions;
  const std::size_t period = rows[0].size();
  CORE_EXPECT(first < period);
  CORE_EXPECT(bins.samples <= period);
  if (bins.run_count > 1) HWY_DYNAMIC_DISPATCH(join_runs)(bins, tails, sums, count, lone);
  float* from = sums.sums.data() + bins.main_run * bins.samples * 2 * functions;
  const auto move = [&](std::size_t places, std::size_t at) {
    HWY_DYNAMIC_DISPATCH(move_to_rows)(from, places, at, rows);
    from += places * 2 * functions;
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

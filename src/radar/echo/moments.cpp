#include "radar/echo/moments.hpp"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/moments.cpp"
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

// Where the echoes of a block belong.
struct BinPlaces {
  static constexpr std::size_t most = streams * in_turn;
  HWY_ALIGN float y[most];
  HWY_ALIGN float y2[most];
  HWY_ALIGN float y4[most];
  HWY_ALIGN float tilt[most];
  HWY_ALIGN std::int32_t sum[most];  // number of the sums of powers
  HWY_ALIGN std::complex<float> strength[most];
};

using Wide = hn::CappedTag<double, in_turn>;
using WideVector = hn::Vec<Wide>;

// A number of each run, in all lanes; runs that are not there are like the last.
template <class Member>
struct OfRuns {
  WideVector first, second, third;

  HWY_INLINE OfRuns(Wide d, const RangeBins& bins, Member member)
      : first(hn::Set(d, bins.runs[0].*member)),
        second(hn::Set(d, bins.runs[std::min<std::size_t>(1, bins.run_count - 1)].*member)),
        third(hn::Set(d, bins.runs[bins.run_count - 1].*member)) {}

  HWY_INLINE WideVector at(hn::Mask<Wide> beyond_first, hn::Mask<Wide> beyond_second) const {
    return hn::IfThenElse(beyond_second, third, hn::IfThenElse(beyond_first, second, first));
  }
};

// Finds the places of echoes.
template <bool Moves>
class Placer {
 public:
  HWY_INLINE explicit Placer(const RangeBins& bins)
      : bins_(bins),
        from_(Wide(), bins, &RangeBins::Run::from),
        per_piece_(Wide(), bins, &RangeBins::Run::per_piece),
        last_piece_(Wide(), bins, &RangeBins::Run::last_piece),
        first_bin_(Wide(), bins, &RangeBins::Run::first_bin) {}

  // Of up to `in_turn` echoes.
  HWY_INLINE void place_some(const Strengths<float>& echoes, std::size_t first, std::size_t count, std::size_t at,
                             BinPlaces& out) const {
    HWY_ALIGN double positions[in_turn];
    HWY_ALIGN double dopplers[in_turn];
    const double* position = echoes.position.data() + first;
    const double* doppler = echoes.doppler.data() + first;
    if (count < in_turn) {
      for (std::size_t i = 0; i < in_turn; ++i) {
        positions[i] = position[i < count ? i : 0];
        dopplers[i] = doppler[i < count ? i : 0];
      }
      position = positions;
      doppler = dopplers;
    }
    std::copy_n(echoes.strength.data() + first, count, out.strength + at);
    for (std::size_t i = 0; i < in_turn; i += hn::Lanes(Wide())) place_vector(position + i, doppler + i, at + i, out);
  }

 private:
  // A sample within 1e-9 of an end belongs to what follows.
  HWY_INLINE void place_vector(const double* position, const double* doppler, std::size_t at, BinPlaces& out) const {
    const Wide d;
    const auto hair = hn::Set(d, 1e-9);
    const auto x = hn::LoadU(d, position);
    auto stands = hn::Add(x, hn::Set(d, bins_.begin));
    auto begins = hn::Add(x, hn::Set(d, bins_.begin_hard));
    auto ends = hn::Add(x, hn::Set(d, bins_.end_hard));
    if constexpr (Moves) {
      const auto speed = hn::LoadU(d, doppler);
      const auto late = hn::MulAdd(speed, hn::MulAdd(speed, speed, speed), speed);  // D/(1 - D) but for D^4
      const auto apart = hn::Sub(speed, hn::Set(d, bins_.middle));
      stands = hn::MulAdd(apart, hn::Set(d, bins_.shift), stands);
      begins = hn::MulAdd(late, hn::Set(d, bins_.begin_late), begins);
      ends = hn::MulAdd(late, hn::Set(d, bins_.end_late), ends);
      store_narrow(d, hn::Mul(apart, hn::Set(d, bins_.tilt)), out.tilt + at);
    }
    const auto first = hn::Ceil(hn::Sub(begins, hair));
    const auto more = hn::Sub(hn::Sub(hn::Ceil(hn::Sub(ends, hair)), first), hn::Set(d, bins_.least_samples));
    const auto beyond_first = hn::Gt(more, hn::Set(d, 0.5));
    const auto beyond_second = hn::Gt(more, hn::Set(d, 1.5));
    const auto of_run = [&](const auto& values) { return values.at(beyond_first, beyond_second); };
    const auto along = hn::Mul(hn::Sub(hn::Sub(first, stands), of_run(from_)), of_run(per_piece_));
    const auto piece = limited(hn::Floor(along), of_run(last_piece_));
    const auto inside = hn::Sub(along, piece);
    const auto y = hn::Sub(hn::Add(inside, inside), hn::Set(d, 1.0));
    const auto y2 = hn::Mul(y, y);
    store_narrow(d, y, out.y + at);
    store_narrow(d, y2, out.y2 + at);
    store_narrow(d, hn::Mul(y2, y2), out.y4 + at);
    const auto samples = hn::Set(d, static_cast<double>(bins_.samples));
    const auto row = limited(hn::Sub(first, hn::Set(d, bins_.first_sample)), hn::Sub(samples, hn::Set(d, 1.0)));
    store_integers(d, hn::MulAdd(hn::Add(piece, of_run(first_bin_)), samples, row), out.sum + at);
  }

  HWY_INLINE static WideVector limited(WideVector x, WideVector most) {
    return hn::Max(hn::Zero(Wide()), hn::Min(x, most));
  }

  using Numbers = OfRuns<double RangeBins::Run::*>;
  const RangeBins& bins_;
  Numbers from_, per_piece_, last_piece_, first_bin_;
};

#if HWY_TARGET == HWY_SCALAR

// One lane holds no pair of a real and an imaginary part: plain loops.
template <std::size_t Terms>
void add_powers(const BinPlaces& places, std::size_t k, std::size_t of_term, std::complex<float>* sums) {
  for (std::size_t term = 0; term < Terms; ++term) {
    std::complex<float>* const at = sums + term * of_term + static_cast<std::size_t>(places.sum[k]) * Moments::powers;
    std::complex<float> product = term == 0 ? places.strength[k] : places.tilt[k] * places.strength[k];
    for (std::size_t p = 0; p < Moments::powers; ++p, product *= places.y[k]) at[p] += product;
  }
}

#else

// Strengths times the powers of y, each in a pair of lanes: times y, y^2 and y^4 where the power has them.
template <std::size_t Terms>
HWY_INLINE void add_powers(const BinPlaces& places, std::size_t k, std::size_t of_term,
                           std::complex<float>* HWY_RESTRICT sums) {
  using D = hn::CappedTag<float, 2 * Moments::powers>;
  HWY_ALIGN static constexpr float power[] = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7};
  const D d;
  float* HWY_RESTRICT at = reinterpret_cast<float*>(sums + static_cast<std::size_t>(places.sum[k]) * Moments::powers);
  double both;
  std::memcpy(&both, places.strength + k, sizeof both);
  const auto pair = hn::BitCast(d, hn::Set(hn::Repartition<double, D>(), both));
  for (std::size_t lane = 0; lane < 2 * Moments::powers; lane += hn::Lanes(d), at += hn::Lanes(d)) {
    auto rest = hn::Load(d, power + lane);
    auto products = pair;
    const auto raise = [&](float from, const float* HWY_RESTRICT by) {
      const auto has = hn::Ge(rest, hn::Set(d, from));
      products = hn::IfThenElse(has, hn::Mul(products, hn::Set(d, by[k])), products);
      rest = hn::IfThenElse(has, hn::Sub(rest, hn::Set(d, from)), rest);
    };
    raise(4.0F, places.y4);
    raise(2.0F, places.y2);
    raise(1.0F, places.y);
    hn::Store(hn::Add(products, hn::Load(d, at)), d, at);
    if constexpr (Terms == 2) {
      float* HWY_RESTRICT second = at + 2 * of_term;
      hn::Store(hn::MulAdd(products, hn::Set(d, places.tilt[k]), hn::Load(d, second)), d, second);
    }
  }
}

#endif  // HWY_SCALAR

template <bool Moves, std::size_t Terms>
void add_all(const RangeBins& bins, const Strengths<float>& echoes, Moments& out) {
  const std::size_t of_term = bins.samples * bins.bins * Moments::powers;
  std::complex<float>* const sums = out.sums.data();
  const std::size_t part = echoes.position.size() / streams;
  const Placer<Moves> placer(bins);
  BinPlaces places;
  for (std::size_t from = 0; from < part; from += in_turn) {
    const std::size_t count = std::min(in_turn, part - from);
    for (std::size_t s = 0; s < streams; ++s) placer.place_some(echoes, s * part + from, count, s * in_turn, places);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t s = 0; s < streams; ++s) add_powers<Terms>(places, s * in_turn + i, of_term, sums);
  }
  for (std::size_t from = streams * part; from < echoes.position.size(); from += in_turn) {
    const std::size_t count = std::min(in_turn, echoes.position.size() - from);
    placer.place_some(echoes, from, count, 0, places);
    for (std::size_t i = 0; i < count; ++i) add_powers<Terms>(places, i, of_term, sums);
  }
}

void add_moments_on_target(const RangeBins& bins, const Strengths<float>& echoes, std::size_t terms, Moments& out) {
  // Even where all of these echoes are at rest, they may stand apart from the middle of D.
  const bool moves = bins.shift != 0.0 || bins.begin_late != 0.0 || bins.end_late != 0.0;
  if (terms == 2) return add_all<true, 2>(bins, echoes, out);
  if (moves) return add_all<true, 1>(bins, echoes, out);
  add_all<false, 1>(bins, echoes, out);
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(add_moments_on_target);

void Moments::make_room(const RangeBins& bins, std::size_t terms) {
  sums.resize(terms * bins.samples * bins.bins * powers);
}

void add_moments(const RangeBins& bins, const Strengths<float>& echoes, std::size_t terms, Moments& out) {
  CORE_EXPECT(terms == 1 || terms == 2);
  CORE_EXPECT(bins.run_count >= 1 && bins.run_count <= RangeBins::most_runs);
  CORE_EXPECT(out.sums.size() == terms * bins.samples * bins.bins * Moments::powers);
  CORE_EXPECT(echoes.strength.size() == echoes.position.size());
  CORE_EXPECT(echoes.doppler.size() == echoes.position.size());
  HWY_DYNAMIC_DISPATCH(add_moments_on_target)(bins, echoes, terms, out);
}

}  // namespace sarsim::radar

#endif

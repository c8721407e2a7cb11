#include "radar/echo/shaped_tones.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/shaped_tones.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "radar/echo/tone-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

constexpr std::size_t block = ShapeTable::cells_per_block;

// Place of the first of a run of cells in its part, and what it changes by from cell to cell.
struct CellPlaces {
  double first, step;
};

// Values of the shape at one place of each cell of `blocks` blocks (Horner). The degree is a constant so that the loop
// over it is unrolled.
template <class T, bool complex, std::size_t degree>
HWY_INLINE void evaluate(const ShapeTable::Block<T>* HWY_RESTRICT coefficients, std::size_t blocks, CellPlaces places,
                         T* HWY_RESTRICT re, T* HWY_RESTRICT im) {
  const hn::CappedTag<T, block> d;
  const auto within = hn::Mul(hn::Iota(d, T(0)), hn::Set(d, static_cast<T>(places.step)));
  for (std::size_t b = 0; b < blocks; ++b, coefficients += (degree + 1) * (complex ? 2 : 1))
    for (std::size_t i = 0; i < block; i += hn::Lanes(d)) {
      const double first = places.first + places.step * static_cast<double>(b * block + i);
      const auto y = hn::Add(hn::Set(d, static_cast<T>(first)), within);
      auto sum_re = hn::Load(d, coefficients[degree].value + i);
      auto sum_im = complex ? hn::Load(d, coefficients[2 * degree + 1].value + i) : sum_re;
      for (std::size_t k = degree; k-- > 0;) {
        sum_re = hn::MulAdd(sum_re, y, hn::Load(d, coefficients[k].value + i));
        if (complex) sum_im = hn::MulAdd(sum_im, y, hn::Load(d, coefficients[degree + 1 + k].value + i));
      }
      hn::Store(sum_re, d, re + b * block + i);
      if (complex) hn::Store(sum_im, d, im + b * block + i);
    }
}

template <class T, bool complex, std::size_t degree = 0>
void evaluate_degree(std::size_t wanted, const ShapeTable::Block<T>* coefficients, std::size_t blocks,
                     CellPlaces places, T* re, T* im) {
  if constexpr (degree < fit_terms) {
    if (wanted == degree)
      evaluate<T, complex, degree>(coefficients, blocks, places, re, im);
    else
      evaluate_degree<T, complex, degree + 1>(wanted, coefficients, blocks, places, re, im);
  }
}

// The table's values for an echo, from the first cell of a block on.
template <class T, bool complex>
HWY_INLINE void evaluate_shape(const ShapeTable& table, const ShapePlace& place, T* HWY_RESTRICT re,
                               T* HWY_RESTRICT im) {
  const std::size_t first = place.cell / block;
  const std::size_t last = (place.cell + place.count - 1) / block;
  const double before = static_cast<double>(place.cell - first * block);
  evaluate_degree<T, complex>(table.degree(), table.coefficients<T>(place.part, place.cell), last + 1 - first,
                              {place.y - place.y_step * before, place.y_step}, re, im);
  table.patch(place, first * block, re, im);
}

template <class T, bool complex>
HWY_INLINE void add_echo(const ShapeTable& table, const ShapedEcho& echo, std::span<const Tone> tones, T* re, T* im,
                         T* turn_re, T* turn_im, T* shape_re, T* shape_im) {
  evaluate_shape<T, complex>(table, echo.place, shape_re, shape_im);
  const std::size_t offset = echo.place.cell % block;
  for (const Tone& tone : tones.subspan(echo.first_tone, echo.last_tone - echo.first_tone)) {
    const std::size_t at = offset + tone.begin - echo.place.sample;
    add_tone(tone, ToneFactor < T, complex ? 2 : 1 > {shape_re + at, shape_im + at}, re, im, turn_re, turn_im);
  }
}

template <bool complex>
void add_in_double(const ShapeTable& table, std::span<const ShapedEcho> echoes, std::span<const Tone> tones,
                   SplitRow& row, ToneScratch& scratch, ShapeScratch& shape) {
  for (const ShapedEcho& echo : echoes)
    add_echo<double, complex>(table, echo, tones, row.re.data(), row.im.data(), scratch.turn_re_double.data(),
                              scratch.turn_im_double.data(), shape.re_double[0].value, shape.im_double[0].value);
}

template <bool complex>
void add_in_single(const ShapeTable& table, std::span<const ShapedEcho> echoes, std::span<const Tone> tones,
                   SplitRow& row, ToneScratch& scratch, ShapeScratch& shape) {
  std::size_t begin = row.re.size();
  std::size_t end = 0;
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const ShapePlace& place = echoes[k].place;
    add_echo<float, complex>(table, echoes[k], tones, scratch.re_single.data(), scratch.im_single.data(),
                             scratch.turn_re.data(), scratch.turn_im.data(), shape.re_single[0].value,
                             shape.im_single[0].value);
    begin = std::min(begin, place.sample);
    end = std::max(end, place.sample + place.count);
    // The tones of an echo do not overlap.
    if (k % ToneScratch::group == ToneScratch::group - 1 || k + 1 == echoes.size()) {
      flush(begin, end, scratch, row);
      begin = row.re.size();
      end = 0;
    }
  }
}

void add_shaped_tones_on_target(const ShapeTable& table, std::span<const ShapedEcho> echoes,
                                std::span<const Tone> tones, SplitRow& row, ToneScratch& scratch, ShapeScratch& shape) {
  if (table.is_single_precision())
    table.is_complex() ? add_in_single<true>(table, echoes, tones, row, scratch, shape)
                       : add_in_single<false>(table, echoes, tones, row, scratch, shape);
  else
    table.is_complex() ? add_in_double<true>(table, echoes, tones, row, scratch, shape)
                       : add_in_double<false>(table, echoes, tones, row, scratch, shape);
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(add_shaped_tones_on_target);

void add_shaped_tones(const ShapeTable& table, std::span<const ShapedEcho> echoes, std::span<const Tone> tones,
                      SplitRow& row, ToneScratch& scratch, ShapeScratch& shape) {
  scratch.make_room(row.re.size(), table.is_single_precision());
  // A whole vector may be read after the last sample of an echo.
  const std::size_t blocks =
      table.cells() / ShapeTable::cells_per_block + SplitRow::padding / ShapeTable::cells_per_block;
  if (table.is_single_precision()) {
    shape.re_single.resize(blocks);
    shape.im_single.resize(blocks);
  } else {
    shape.re_double.resize(blocks);
    shape.im_double.resize(blocks);
  }
  HWY_DYNAMIC_DISPATCH(add_shaped_tones_on_target)(table, echoes, tones, row, scratch, shape);
}

}  // namespace sarsim::radar

#endif

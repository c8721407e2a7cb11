#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/os/input_file.hpp"
#include "raster/format/raw_decode.hpp"
#include "raster/format/text_rows.hpp"
#include "raster/table/count_range.hpp"
#include "raster/table/raster.hpp"
#include "raster/table/row_index.hpp"

namespace sarsim::raster {

/// Where a row of a text begins.
struct TextMark {
  std::uint64_t offset = 0;
  std::size_t line = 1;
};

/// Where the rows of a text begin, as far as that has been looked for.
using TextIndex = RowIndex<TextMark>;

/// How the numbers of a text make samples.
struct TextSamples {
  TextLayout layout;
  std::size_t values = 0;            ///< Numbers of a row.
  std::size_t components = 2;        ///< Numbers of a sample.
  std::optional<CountRange> offset;  ///< Subtracted from whole numbers.
  double factor = 1.0;               ///< By which numbers without an offset are multiplied: their unit in volts.

  /// The value of a number; "-0" of old programs is 0.
  template <class Real>
  [[nodiscard]] Real decoded(const TextNumber& number) const {
    if (!offset || !number.whole) return nearest<Real>(factor * number.value + 0.0);
    return static_cast<Real>(offset->without_offset(number.magnitude));
  }
  /// Whether a number is none of a converter whose offset is subtracted, which the first row alone made believe.
  [[nodiscard]] bool misfits(const TextNumber& number) const {
    return offset && (!number.whole || number.value < 0.0 || number.magnitude > offset->highest_stored());
  }
};

/// A text that has been read through and is sound: all its rows have the same length.
[[nodiscard]] std::shared_ptr<Raster> make_whole_text(RasterInfo info, core::InputFile file, const TextSamples& samples,
                                                      std::unique_ptr<TextIndex> index);

/// A text of which nothing but the first row is known, and that may grow. It is looked through on a thread of its own;
/// what is missing of a row is 0, what is too much is left out.
/// @param begin      where the first row begins
/// @param row_bytes  length of that row
[[nodiscard]] std::shared_ptr<Raster> make_growing_text(RasterInfo info, core::InputFile file,
                                                        const TextSamples& samples, TextMark begin,
                                                        std::uint64_t row_bytes);

}  // namespace sarsim::raster

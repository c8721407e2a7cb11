#pragma once

#include <complex>
#include <cstddef>
#include <variant>

#include "core/report/problem.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::picture {

/// A cut through the response of a point, along the rows or along the columns.
struct CutReading {
  double width = 0.0;    ///< Between the half-power points, in samples.
  double null = 0.0;     ///< Mean distance of the first minima on both sides, in samples.
  double pslr_db = 0.0;  ///< Highest sidelobe beyond the first minima, relative to the peak. Above 0: a stronger
                         ///< response lies beside this one, which may itself be a sidelobe.
  double islr_db = 0.0;  ///< Energy beyond the first minima over that between them, to `reach` on both sides.
  double reach = 0.0;    ///< How far sidelobes were looked at, in samples: 10 times `null` where the image allows it.
};

/// What the response of a point tells.
struct PointReading {
  double row = 0.0;  ///< Place of the peak, in samples; fractions are interpolated.
  double column = 0.0;
  std::complex<double> value;  ///< At the peak.
  CutReading along_column;     ///< The row changes.
  CutReading along_row;        ///< The column changes.
};

/// How the point next to a sample is found.
struct PointOptions {
  /// The largest sample so many rows and columns around the click is taken, and from there the way up to a sample
  /// without a larger neighbour. At most 1024.
  std::size_t search_rows = 4;
  std::size_t search_columns = 4;
};

/// Measures the point next to a sample: chip of 32 x 32 samples around the largest one, spectral centroid removed in
/// both directions, spectrum padded with zeros to 16 times as many samples, peak refined by a parabola; cuts of 128
/// samples through that peak, made 16 times finer the same way. For a response sin(x)/x the figures are 0.886, -13.26
/// dB and -10.1 dB (ISLR to 10 null widths); docs/formats/images.md has those of other windows.
///
/// Samples beyond the image are 0. A problem where the click is outside, where nothing but zeros is around it, or where
/// the response has no main lobe with minima on both sides. What reading the plane throws comes out.
[[nodiscard]] std::variant<PointReading, core::Problem> read_point(const raster::Raster& plane, std::size_t row,
                                                                   std::size_t column,
                                                                   const PointOptions& options = {});

}  // namespace sarsim::picture

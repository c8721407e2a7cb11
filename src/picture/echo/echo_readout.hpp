#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "picture/echo/echo_picture.hpp"

namespace sarsim::picture {

/// Everything about the sample that a pixel shows; its own range and time, not those of the cursor.
struct ReadOut {
  std::size_t row = 0;     ///< Of the matrix.
  std::size_t column = 0;  ///< Of the matrix.
  double range_m = 0.0;
  double delay_s = 0.0;  ///< Two-way.
  double time_s = 0.0;
  std::int64_t pulse = 0;  ///< Absolute number; of a burst its first.
  double carrier_hz = 0.0;
  std::complex<double> sample_v;
  double magnitude_v = 0.0;
  double phase_deg = 0.0;
  double level_db = 0.0;  ///< Relative to the colours' reference.
};

/// @return nothing outside the plot and where the row that belongs there is not ready
[[nodiscard]] std::optional<ReadOut> read_out(const EchoMatrix& matrix, const EchoColours& colours, double x_px,
                                              double y_px);
/// The lines of the read-out panel: name and value with unit.
struct ReadOutLine {
  std::string name;
  std::string value;
};
[[nodiscard]] std::vector<ReadOutLine> lines_of(const ReadOut& read_out);

/// From the first of two cursors to the second.
struct CursorDifference {
  double range_m = 0.0;
  double delay_s = 0.0;
  double time_s = 0.0;
  std::int64_t pulses = 0;
  double level_db = 0.0;        ///< Ratio of the magnitudes; not a number where the first is 0.
  double phase_deg = 0.0;       ///< In (-180, 180].
  double range_rate_mps = 0.0;  ///< Range over time; not a number at equal times.
};
[[nodiscard]] CursorDifference difference(const ReadOut& first, const ReadOut& second);

/// Values along a line through the picture, of the quantity shown.
struct SideCut {
  std::vector<double> position;  ///< Range [m] or time [s].
  std::vector<double> value;
};
/// Along a row that is ready; empty where it is not.
[[nodiscard]] SideCut row_cut(const EchoMatrix& matrix, const EchoColours& colours, std::size_t row);
/// Along a column, through the rows that are ready.
[[nodiscard]] SideCut column_cut(const EchoMatrix& matrix, const EchoColours& colours, std::size_t column);

}  // namespace sarsim::picture

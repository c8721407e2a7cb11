#pragma once

#include <cstddef>
#include <vector>

#include "picture/echo/echo_picture.hpp"

namespace sarsim::picture {

/// A line through points of the plot, device pixels.
struct EchoCurve {
  /// A place in the picture.
  struct Point {
    double x_px;
    double y_px;
  };
  std::size_t element = 0;  ///< Row or column of the matrix.
  Point base_from{};        ///< Ends of the grey line that stands for 0 (for the lower limit, of decibels).
  Point base_to{};
  std::vector<Point> points;
};

/// Curves instead of pixels (thesis 4.5.1).
struct EchoCurves {
  std::vector<EchoCurve> curves;
  double spacing_px = 0.0;
  double scale_px = 0.0;  ///< Height of the largest value over the base line.
};

/// One curve across for each pulse that is ready; where pulses are nearer than 20 pixels, for every n-th. A value is
/// drawn upwards from the pulse's time, the largest magnitude as 3/8 of the spacing, so that positive and negative
/// together take 75 % of it; decibels take 90 % from the lower limit to the upper.
[[nodiscard]] EchoCurves curves_per_pulse(const EchoMatrix& matrix, const EchoColours& colours);
/// One curve upwards every 20 pixels (every sample, where those are farther apart), through the pulses that are ready;
/// a value is drawn to the right.
[[nodiscard]] EchoCurves curves_per_range(const EchoMatrix& matrix, const EchoColours& colours);

}  // namespace sarsim::picture

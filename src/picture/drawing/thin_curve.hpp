#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sarsim::picture {

/// A point of a picture, pixels from its upper left corner.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// A curve with fewer points that looks the same: of each run of points that follow one another in a column, so many
/// pixels wide, the first, the lowest, the highest and the last, in their order. For a curve that goes up and down many
/// times in each pixel the drawing library takes a time that grows with the square of its points.
/// @param points     finite
/// @param column_px  above 0
[[nodiscard]] inline std::vector<Point> thinned(const std::vector<Point>& points, double column_px) {
  std::vector<Point> kept;
  const auto lower = [](const Point& a, const Point& b) { return a.y < b.y; };
  for (auto first = points.begin(); first != points.end();) {
    const double column = std::floor(first->x / column_px);
    const auto end = std::find_if(first, points.end(),
                                  [&](const Point& point) { return std::floor(point.x / column_px) != column; });
    const auto [least, most] = std::minmax_element(first, end, lower);
    const std::array wanted{first, std::min(least, most), std::max(least, most), end - 1};
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (i == 0 || wanted[i] != wanted[i - 1]) kept.push_back(*wanted[i]);
    first = end;
  }
  return kept;
}

}  // namespace sarsim::picture

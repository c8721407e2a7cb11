#include "picture/figure/fitted_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unordered_map>

#include "core/task/stop_points.hpp"

namespace sarsim::picture {

namespace {

std::uint32_t key_of(const raster::Rgb& colour) {
  return static_cast<std::uint32_t>(colour.red) << 16U | static_cast<std::uint32_t>(colour.green) << 8U |
         static_cast<std::uint32_t>(colour.blue);
}

// How strong a colour of a bar is.
class Strengths {
 public:
  explicit Strengths(const std::optional<FigureColourBar>& bar) {
    if (!bar || bar->kind == ColourMapKind::cyclic || bar->colours.size() < 2) return;
    const double step = (bar->last - bar->first) / static_cast<double>(bar->colours.size() - 1);
    for (std::size_t i = 0; i < bar->colours.size(); ++i) {
      const double value = bar->first + static_cast<double>(i) * step;
      of_.try_emplace(key_of(bar->colours[i]), bar->kind == ColourMapKind::diverging ? std::abs(value) : value);
    }
  }

  // Neighbours often have the same colour.
  double of(const raster::Rgb& colour) {
    if (const std::uint32_t key = key_of(colour); key != last_key_) {
      const auto found = of_.find(key);
      last_key_ = key;
      last_ = found == of_.end() ? weakest : found->second;
    }
    return last_;
  }

 private:
  static constexpr double weakest = -std::numeric_limits<double>::infinity();
  std::unordered_map<std::uint32_t, double> of_;
  std::uint32_t last_key_ = ~std::uint32_t{0};  // of no colour
  double last_ = weakest;
};

std::size_t begin_of(std::size_t dot, std::size_t cells, std::size_t dots) { return dot * cells / dots; }

}  // namespace

FigureImage fitted(const FigureImage& image, const std::optional<FigureColourBar>& bar, std::size_t columns,
                   std::size_t rows, const core::StopFlag* stop) {
  if (columns == 0 || rows == 0) throw std::invalid_argument("an image needs a dot at least");
  if (image.width <= columns && image.height <= rows) return image;
  FigureImage out{std::min(image.width, columns),
                  std::min(image.height, rows),
                  image.x_first,
                  image.x_last,
                  image.y_first,
                  image.y_last,
                  {}};
  out.cells.reserve(out.width * out.height);
  Strengths strengths(bar);
  std::vector<double> strongest(out.width);
  for (std::size_t row = 0; row < out.height; ++row) {
    core::end_if_asked(stop);
    const std::size_t first = begin_of(row, image.height, out.height);
    const std::size_t end = begin_of(row + 1, image.height, out.height);
    const std::size_t begun = out.cells.size();
    for (std::size_t r = first; r < end; ++r)
      for (std::size_t column = 0, c = 0; column < out.width; ++column) {
        if (r == first) {
          out.cells.push_back(image.cells[r * image.width + c]);
          strongest[column] = strengths.of(out.cells.back());
        }
        for (const std::size_t behind = begin_of(column + 1, image.width, out.width); c < behind; ++c) {
          const raster::Rgb& cell = image.cells[r * image.width + c];
          const double strength = strengths.of(cell);
          if (strength <= strongest[column]) continue;
          strongest[column] = strength;
          out.cells[begun + column] = cell;
        }
      }
  }
  return out;
}

}  // namespace sarsim::picture

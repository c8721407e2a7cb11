#pragma once

#include "base/stop.hpp"
#include "data/image_source.hpp"
#include "view/echo_window.hpp"
#include "view/figure.hpp"

namespace sarsim {

/// How a file is looked at: the part that is seen, in rows and columns of the file, and the look.
struct ImageLook {
  std::size_t first_row = 0;
  std::size_t rows = 0;  ///< 0: all.
  std::size_t first_column = 0;
  std::size_t columns = 0;  ///< 0: all.
  DisplayQuantity quantity = DisplayQuantity::magnitude;
  ColourMap map = ColourMap::ocean;
  bool inverted = false;
  ClassicSliders sliders;
  LimitRule limits;
  Decibels decibels;
};

/// A picture of a file of any size: where it has more samples than pixels, a subset of them. Axes are pulses and
/// samples, or, where the file says them, slant range and time.
/// @param size  device pixels at most
/// @throws std::invalid_argument for a part that is not inside the file, and what reading throws
[[nodiscard]] Figure image_figure(const ImageSource& source, const ImageLook& look, const PlotSize& size,
                                  const WorkControl& control = {});

}  // namespace sarsim

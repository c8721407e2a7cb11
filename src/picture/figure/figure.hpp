#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "picture/colour/colour_map.hpp"
#include "picture/colour/theme.hpp"

namespace sarsim::picture {

/// A picture with axes, described by what it shows; how it is drawn is the business of whoever draws it. All figures of
/// the program, on screen and in files, are made from this value.

/// An axis and the part of it that is seen, from the left or the bottom.
struct FigureAxis {
  std::string label;  ///< "Slant range".
  std::string unit;   ///< Of the values, without a prefix: "m"; marks choose the prefix.
  double first = 0.0;
  double last = 1.0;  ///< May be below `first`.
  /// A second scale on the other side that names the same places in other words: value * factor.
  struct Twin {
    std::string label;
    std::string unit;
    double factor = 1.0;
    friend bool operator==(const Twin&, const Twin&) = default;
  };
  std::optional<Twin> twin;
  /// Values are seconds, and marks say the time of day: that at the value 0, s since midnight.
  std::optional<double> clock_s = std::nullopt;

  friend bool operator==(const FigureAxis&, const FigureAxis&) = default;
};

/// Points joined by straight lines, or bars.
struct FigureCurve {
  std::string name;  ///< For the legend; curves without one are left out of it.
  Role role = Role::curve;
  bool bars = false;
  std::vector<double> x;
  std::vector<double> y;  ///< As many; a NaN breaks the line.

  friend bool operator==(const FigureCurve&, const FigureCurve&) = default;
};

/// A picture of coloured cells.
struct FigureImage {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Edges of the first and behind the last cell.
  double x_first = 0.0;
  double x_last = 1.0;
  double y_first = 0.0;
  double y_last = 1.0;
  std::vector<raster::Rgb> cells;  ///< height rows of width cells, the first row at y_first.

  friend bool operator==(const FigureImage&, const FigureImage&) = default;
};

/// What the colours of an image mean.
struct FigureColourBar {
  std::string label;
  std::string unit;
  double first = 0.0;
  double last = 1.0;
  std::vector<raster::Rgb> colours;                ///< Evenly spaced from first to last, at least two.
  ColourMapKind kind = ColourMapKind::sequential;  ///< Of the values: which of them stand out.

  friend bool operator==(const FigureColourBar&, const FigureColourBar&) = default;
};

/// A mark on the picture: a cross with words beside it, or a ring around a place.
struct FigureMark {
  double x = 0.0;
  double y = 0.0;
  std::string text;
  bool ring = false;

  friend bool operator==(const FigureMark&, const FigureMark&) = default;
};

/// One pair of axes and what stands in it: the image behind, curves before it.
struct FigurePanel {
  std::string title;
  FigureAxis x;
  FigureAxis y;
  std::optional<FigureImage> image;
  std::optional<FigureColourBar> colour_bar;
  std::vector<FigureCurve> curves;
  std::vector<FigureMark> marks;
  /// Of a map: how many units of y are as long as one of x, so that a circle on the ground is one in the picture; 0: no
  /// map. One axis may show more than it says; panels more than three times as long as wide are no maps.
  double y_per_x = 0.0;

  friend bool operator==(const FigurePanel&, const FigurePanel&) = default;
};

/// Panels one below the other.
struct Figure {
  std::string title;
  std::string note;  ///< One line below everything: "highest magnitude 40.96 pV".
  std::vector<FigurePanel> panels;

  friend bool operator==(const Figure&, const Figure&) = default;
};

}  // namespace sarsim::picture

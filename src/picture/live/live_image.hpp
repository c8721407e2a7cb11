#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "core/task/sample_rows.hpp"
#include "picture/colour/colour_map.hpp"
#include "picture/figure/figure.hpp"
#include "picture/live/live_request.hpp"
#include "raster/table/image_places.hpp"

namespace sarsim::picture {

/// Places along one side of an image: edges of the first and behind the last pixel.
struct LiveAxis {
  std::string label;  ///< "Azimuth".
  std::string unit;   ///< "m".
  double first = 0.0;
  double last = 1.0;
  std::size_t count = 0;  ///< Pixels.

  friend bool operator==(const LiveAxis&, const LiveAxis&) = default;
};

/// What computing an image took.
struct LiveCost {
  std::size_t echoes = 0;  ///< Targets times pulses whose echoes were computed.
  double seconds = 0.0;
};

/// An image at the resolution of a window: the largest magnitude of each pixel, so that no point is lost.
struct LiveImage {
  LiveProduct product = LiveProduct::focused;  ///< Never automatic.
  LiveAxis rows;
  LiveAxis columns;
  std::vector<float> magnitude_v;  ///< rows.count rows of columns.count pixels.
  float largest_v = 0.0F;
  std::string made;      ///< "omega-k, 1240 pulses".
  bool coarse = false;   ///< A better one follows.
  std::string coarsely;  ///< Why it is coarse: "256 of 100000 targets".
  /// Where the targets of the scene should be.
  struct TargetPlace {
    double column = 0.0;  ///< In the unit of `columns`.
    double row = 0.0;     ///< In that of `rows`.
    friend bool operator==(const TargetPlace&, const TargetPlace&) = default;
  };
  std::vector<TargetPlace> targets;  ///< Where they are wanted, of a whole image; of many targets none.
  LiveCost cost;
  core::Problems problems;  ///< Warnings and notes about the image.
};

/// Reduces samples to pixels: each is the largest magnitude of its samples; an image with fewer samples than pixels
/// keeps its samples.
/// @param places  of the rows and columns
/// @throws core::Interrupted
[[nodiscard]] LiveImage live_image(const core::SampleRows<float>& samples, const raster::FocusedPlaces& places,
                                   const PlotSize& size, const core::WorkControl& control);

/// How it is shown.
struct LiveLook {
  ColourMap map = ColourMap::ocean;
  double span_db = 50.0;  ///< Shown below the largest magnitude.

  friend bool operator==(const LiveLook&, const LiveLook&) = default;
};

/// The figure of an image in decibels below its largest magnitude; of a single row, a curve.
[[nodiscard]] Figure live_figure(const LiveImage& image, const LiveLook& look);
/// The same below a magnitude that is given, so that two images have the same colours.
[[nodiscard]] Figure live_figure(const LiveImage& image, const LiveLook& look, float reference_v);

/// Puts a ring around each of these places of a live figure.
void add_rings(Figure& figure, const std::vector<LiveImage::TargetPlace>& places);

/// |after| - |before| in decibels, pixel by pixel of `after`, each not below the span under the larger of both peaks;
/// 0 where they are alike. Where `before` does not reach, it counts as silence.
[[nodiscard]] std::vector<float> difference_db(const LiveImage& before, const LiveImage& after, double span_db);
/// Its figure, in diverging colours with 0 in the middle.
[[nodiscard]] Figure difference_figure(const LiveImage& before, const LiveImage& after, const LiveLook& look);

}  // namespace sarsim::picture

#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "signal/measure/response.hpp"
#include "signal/sar/sar_image.hpp"

namespace sarsim::signal {

/// Reads `out.size()` values of a row of an image, from a column on.
using ImageReader = std::function<void(std::size_t row, std::size_t first_column, std::span<std::complex<float>> out)>;

/// Reader of an image in memory; keeps a reference.
[[nodiscard]] ImageReader reader_of(const FocusedImage& image);

/// What a point target looks like in an image. The cuts run along the axes of its response: `range` along the line of
/// sight of the beam's centre and `azimuth` across it; without squint, along the axes of the image.
struct PointResponse {
  ImagePlace place;         ///< Of the peak.
  double amplitude = 0.0;   ///< Of the peak.
  double phase_rad = 0.0;   ///< Of the peak, in (-pi, pi].
  ResponseFigures azimuth;  ///< Widths and nulls in metres.
  ResponseFigures range;
};

/// A response along a line through its peak, which is in the middle.
struct ResponseCut {
  double step_m = 0.0;
  std::vector<std::complex<double>> values;  ///< An odd number.
};

/// The lines that the figures of a point were measured on.
struct PointCuts {
  ResponseCut azimuth;
  ResponseCut range;
};

/// Directions of the cuts through the points of an image, as unit vectors of azimuth and range.
struct ResponseAxes {
  ImagePlace range{0.0, 1.0};    ///< Along the line of sight.
  ImagePlace azimuth{1.0, 0.0};  ///< Across it.
};

/// The axes of an image: azimuth and range if the squint of the beam centre is below half a degree.
[[nodiscard]] ResponseAxes response_axes(const FocusedImage& image);

/// The largest peak near a place, between samples: a piece of the image about it is taken for one period of a
/// band-limited function about the image's spectral centre (zero-padded Fourier transform), whose maximum is found by
/// Newton's method.
///
/// @param image     axes and frame; `values` may be empty
/// @param expected  where to look, and `search_m` around it in both coordinates
/// @param cuts      where not null, filled for a point that is found
/// @return nothing where the place is outside the image, the image is 0 there, or the response runs out of it before
///         its first minimum
[[nodiscard]] std::optional<PointResponse> measure_point(const FocusedImage& image, const ImageReader& reader,
                                                         const ImagePlace& expected, double search_m,
                                                         PointCuts* cuts = nullptr);

}  // namespace sarsim::signal

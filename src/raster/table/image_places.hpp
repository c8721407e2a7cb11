#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sarsim::raster {

/// Places of rows or columns that the file does not say itself: `first` is that of the first, `step` from one to the
/// next.
struct ImagePlaces {
  std::string label;  ///< "Azimuth".
  std::string unit;   ///< "m".
  double first = 0.0;
  double step = 1.0;

  /// The places of the first `count` rows or columns.
  [[nodiscard]] std::vector<double> list(std::size_t count) const {
    std::vector<double> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back(first + step * static_cast<double>(i));
    return places;
  }

  friend bool operator==(const ImagePlaces&, const ImagePlaces&) = default;
};

/// Places of an image that Sarsim made: rows along the track, bursts, northings ... instead of pulses.
struct FocusedPlaces {
  ImagePlaces azimuth;
  ImagePlaces range;
  double azimuth_centre_per_m = 0.0;  ///< Middles of the image's spectrum, cycles for each unit of the places.
  double range_centre_per_m = 0.0;
};

}  // namespace sarsim::raster

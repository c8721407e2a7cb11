#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>

#include "raster/table/image_window.hpp"

namespace sarsim::picture {

/// A table of complex samples, of whatever size and from wherever: a file, a product that was computed.
struct SamplePlane {
  std::size_t rows = 0;
  std::size_t columns = 0;
  /// Reads a window row by row into window.samples() places. Called from several threads at once; what it throws comes
  /// out of whatever asked for the samples.
  std::function<void(const raster::ImageWindow&, std::span<std::complex<float>>)> read;
};

}  // namespace sarsim::picture

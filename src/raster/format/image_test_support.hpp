#pragma once

#include <complex>
#include <filesystem>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "raster/format/data_test_support.hpp"
#include "raster/format/open_raster.hpp"

/// Images opened and read for tests.
namespace sarsim::raster::data_test {

/// Opens an image and waits until it is looked through; a failure of the test, and null, where it cannot be opened.
inline std::shared_ptr<Raster> open_whole(const std::filesystem::path& path, const RasterHints& hints = {}) {
  const OpenedRaster opened = open_raster(Integrity::partial, path, hints);
  EXPECT_TRUE(opened.raster) << text_of(opened.problems);
  if (opened.raster) opened.raster->wait_until_indexed(nullptr);
  return opened.raster;
}

/// What a file of samples that does not describe itself needs.
inline RasterHints sample_hints(std::size_t columns, int bits) {
  RasterHints hints;
  hints.columns = columns;
  hints.bits = bits;
  return hints;
}

/// The samples of a window.
inline std::vector<std::complex<float>> read(const Raster& source, const ImageWindow& window, unsigned threads = 1) {
  std::vector<std::complex<float>> samples(window.samples());
  source.read_window(window, samples, {threads, nullptr});
  return samples;
}

/// All samples of an image.
inline std::vector<std::complex<float>> read_all(const Raster& source) {
  return read(source, {0, source.rows(), 0, source.columns()});
}

}  // namespace sarsim::raster::data_test

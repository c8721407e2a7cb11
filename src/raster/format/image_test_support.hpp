#pragma once

#include <complex>
#include <filesystem>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "raster/format/data_test_support.hpp"
#include "raster/format/image_source.hpp"

/// Images opened and read for tests.
namespace sarsim::raster::data_test {

/// Opens an image and waits until it is looked through; a failure of the test, and null, where it cannot be opened.
inline std::shared_ptr<ImageSource> open_whole(const std::filesystem::path& path, const ImageHints& hints = {}) {
  const OpenedImage opened = ImageSource::open(path, hints);
  EXPECT_TRUE(opened.source) << text_of(opened.problems);
  if (opened.source) opened.source->wait_until_indexed(nullptr);
  return opened.source;
}

/// What a file of samples that does not describe itself needs.
inline ImageHints sample_hints(std::size_t columns, int bits) {
  ImageHints hints;
  hints.samples.columns = columns;
  hints.samples.bits = bits;
  return hints;
}

/// The samples of a window.
inline std::vector<std::complex<float>> read(const ImageSource& source, const ImageWindow& window,
                                             unsigned threads = 1) {
  std::vector<std::complex<float>> samples(window.samples());
  source.read_window(window, samples, {threads, nullptr});
  return samples;
}

/// All samples of an image.
inline std::vector<std::complex<float>> read_all(const ImageSource& source) {
  return read(source, {0, source.rows(), 0, source.columns()});
}

}  // namespace sarsim::raster::data_test

#include "workflow/image/image_fields.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sarsim::workflow {
namespace image_fields_test {

std::string description_of(const std::string& algorithm, signal::ImagePlane plane) {
  signal::FocusedImage image;
  image.frame.plane = plane;
  ImageOrigin origin;
  origin.algorithm = algorithm;
  return header_of(image, origin).description;
}

TEST(HeaderOfImage, SaysAlongWhatLinesAndSamplesLie) {
  EXPECT_NE(
      description_of("omega-k", signal::ImagePlane::slant_range).find("lines along azimuth, samples along slant range"),
      std::string::npos);
  EXPECT_NE(description_of("back-projection", signal::ImagePlane::ground_grid)
                .find("lines along azimuth, samples along ground range"),
            std::string::npos);
}

TEST(HeaderOfImage, OfATurningTargetHasItsCrossRange) {
  for (const char* algorithm : {"isar-range-doppler", "isar-back-projection"})
    EXPECT_NE(description_of(algorithm, signal::ImagePlane::ground_grid)
                  .find("lines along cross-range, samples along the line of sight"),
              std::string::npos);
}

}  // namespace image_fields_test
}  // namespace sarsim::workflow

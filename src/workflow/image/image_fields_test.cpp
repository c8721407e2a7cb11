#include "workflow/image/image_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"

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

// Of an image that Sarsim could have made, but for one field; empty where that is read.
std::string refusal_with(const std::string& name, const std::string& value) {
  signal::FocusedImage image;
  image.frame = {signal::ImagePlane::slant_range, {}, {0.0, 1.0, 0.0}, {}, 90.0};
  image.azimuth = {0.0, 1.0, 4, 0.0};
  image.range = {900.0, 1.0, 4, 0.0};
  image.carrier_hz = 1e9;
  image.light_speed_mps = core::classic_light_speed_mps;
  ImageOrigin origin;
  origin.algorithm = "omega-k";
  raster::EnviHeader header = header_of(image, origin);
  const auto field = std::ranges::find(header.fields, name, &std::pair<std::string, std::string>::first);
  EXPECT_NE(field, header.fields.end()) << name;
  field->second = value;
  try {
    read_header(header, "x.hdr", image, origin);
  } catch (const core::InvalidRequest& refused) {
    return refused.problems.at(0).message;
  }
  return {};
}

TEST(ReadHeader, RefusesSpeedsThatCannotBeByName) {
  EXPECT_EQ(refusal_with("speed mps", "90"), "");
  for (const char* const value : {"0", "-90", "nan"})
    EXPECT_EQ(refusal_with("speed mps", value).find("x.hdr: 'speed mps' is not "), 0U) << value;
  EXPECT_EQ(refusal_with("light speed mps", "299792458"), "");
  for (const char* const value : {"3e8", "0", "2997924580"})
    EXPECT_EQ(refusal_with("light speed mps", value),
              "x.hdr: 'light speed mps' is no speed of light (299792458, or 299792500 of the classic profile)");
}

}  // namespace image_fields_test
}  // namespace sarsim::workflow

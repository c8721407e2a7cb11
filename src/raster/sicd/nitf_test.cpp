#include "raster/sicd/nitf.hpp"

#include <gmock/gmock.h>

#include <string>

#include "core/report/invalid_request.hpp"
#include "raster/sicd/sicd_test_value.hpp"
#include "raster/sicd/sicd_writer.hpp"

namespace sarsim::raster {
namespace nitf_test {

using testing::HasSubstr;
using testing::StartsWith;

// What NGA.STND.0024, Volume 2, 3.2 gives: floor((10^10 - 2)/row) rows, at most 99 999 of several segments.
TEST(NitfRowsOfSegment, AreThoseOfTheStandard) {
  EXPECT_EQ(nitf_rows_of_segment(400, 4802), 400U);
  EXPECT_EQ(nitf_rows_of_segment(1'249'999'999, 1), 1'249'999'999U);  // 9 999 999 992 bytes.
  EXPECT_EQ(nitf_rows_of_segment(1'250'000'000, 1), 99'999U);
  EXPECT_EQ(nitf_rows_of_segment(200'000, 8192), 99'999U);
  EXPECT_EQ(nitf_rows_of_segment(40'000, 40'000), 31'249U);  // Of 320 000 bytes.
}

TEST(LayOutNitf, PutsSegmentsOneBehindTheOther) {
  Sicd image = sicd_test_value(70'000, 40'000);
  const NitfLayout layout = lay_out_nitf(nitf_content(image));
  ASSERT_EQ(layout.segments.size(), 3U);
  const std::string& file = layout.texts[0].second;
  EXPECT_THAT(file, StartsWith("NITF02.1009BF01SARSIM    20240401225942"));
  EXPECT_EQ(std::stoull(file.substr(342, 12)), layout.size);
  EXPECT_EQ(std::stoull(file.substr(354, 6)), file.size());
  EXPECT_EQ(file.substr(360, 3), "003");
  std::uint64_t at = file.size();
  std::size_t row = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [offset, header] = layout.texts[i + 1];
    EXPECT_EQ(offset, at);
    EXPECT_EQ(layout.segments[i].first, row);
    EXPECT_EQ(layout.segments[i].offset, at + header.size());
    EXPECT_THAT(header, StartsWith("IMSICD00" + std::to_string(i + 1)));
    EXPECT_EQ(std::stoull(header.substr(333, 8)), layout.segments[i].count);
    // Display level, attachment, place below the segment before it.
    const std::string tail = header.substr(header.size() - 4 - 10 - 10 - 6, 16);
    EXPECT_EQ(tail, "00" + std::to_string(i + 1) + "00" + std::to_string(i) + (i == 0 ? "00000" : "31249") + "00000");
    row += layout.segments[i].count;
    at += header.size() + layout.segments[i].count * 40'000U * 8U;
  }
  EXPECT_EQ(row, 70'000U);
  EXPECT_EQ(layout.texts[4].first, at);
  EXPECT_EQ(layout.size, at + layout.texts[4].second.size());
}

// Segments share the corners between them: a third of the way down the sides of the image.
TEST(LayOutNitf, GivesSegmentsTheirCorners) {
  const NitfContent content = nitf_content(sicd_test_value(70'000, 40'000));
  const NitfLayout layout = lay_out_nitf(content);
  const auto corners = [&](std::size_t segment) { return layout.texts[segment + 1].second.substr(372, 60); };
  EXPECT_EQ(corners(0).substr(0, 15), "340036S0175924E");
  EXPECT_EQ(corners(0).substr(45, 15), corners(1).substr(0, 15));
  EXPECT_EQ(corners(0).substr(30, 15), corners(1).substr(15, 15));
  EXPECT_EQ(corners(2).substr(45, 15), "340036S0180036E");
}

TEST(LayOutNitf, RefusesWhatTheFormatCannotHold) {
  const NitfContent narrow = nitf_content(sicd_test_value(3, 3));
  NitfContent wide = narrow;
  wide.columns = 100'000'000;
  EXPECT_THROW((void)lay_out_nitf(wide), core::InvalidRequest);
  NitfContent large = narrow;
  large.rows = 50'000'000;
  large.columns = 20'000;  // 8 TB.
  EXPECT_THROW((void)lay_out_nitf(large), core::InvalidRequest);
}

}  // namespace nitf_test
}  // namespace sarsim::raster

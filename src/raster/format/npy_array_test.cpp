#include "raster/format/npy_array.hpp"

#include <gtest/gtest.h>

namespace sarsim::raster {
namespace npy_array_test {

NpyHeader header_of(std::string type, std::vector<std::uint64_t> shape, bool fortran_order = false) {
  return {std::move(type), fortran_order, std::move(shape), 0};
}

std::optional<NpyPlane> plane_of(const NpyHeader& header) { return npy_plane_of(header, *npy_type_of(header)); }

TEST(NpyArray, SamplesAreLittleEndianPairsOrSignedNumbers) {
  EXPECT_EQ(npy_sample_types(), "<c8, <c16, <f4, <f8, <i2, <i4, <i8");
  EXPECT_NE(npy_sample_type_of(header_of("<c8", {1})), nullptr);
  EXPECT_EQ(npy_sample_type_of(header_of(">c8", {1})), nullptr);
  EXPECT_EQ(npy_sample_type_of(header_of("|u1", {1})), nullptr);
}

TEST(NpyArray, OtherNumbersCanBeLookedAt) {
  EXPECT_NE(npy_type_of(header_of(">c8", {1})), nullptr);
  EXPECT_NE(npy_type_of(header_of("|b1", {1})), nullptr);
  EXPECT_EQ(npy_type_of(header_of("<U4", {1})), nullptr);
  EXPECT_EQ(npy_type_of(header_of("c8", {1})), nullptr);
  EXPECT_EQ(npy_type_of(header_of("", {1})), nullptr);
}

TEST(NpyArray, TheLastDimensionMakesPairsAndColours) {
  const auto pairs = plane_of(header_of("<f4", {3, 5, 2}));
  ASSERT_TRUE(pairs);
  EXPECT_EQ(pairs->value, ImageValue::complex);
  EXPECT_EQ(pairs->rows, 3U);
  EXPECT_EQ(pairs->columns, 5U);
  const auto colours = plane_of(header_of("|u1", {3, 5, 3}));
  ASSERT_TRUE(colours);
  EXPECT_EQ(colours->value, ImageValue::rgb);
  const auto line = plane_of(header_of("<c8", {7}));
  ASSERT_TRUE(line);
  EXPECT_EQ(line->rows, 1U);
  EXPECT_EQ(line->columns, 7U);
}

TEST(NpyArray, OtherShapesHaveNoRowsAndColumns) {
  EXPECT_FALSE(plane_of(header_of("<c8", {})));
  EXPECT_FALSE(plane_of(header_of("<c8", {0, 3})));
  EXPECT_FALSE(plane_of(header_of("<c8", {2, 3, 4})));
  EXPECT_FALSE(plane_of(header_of("<f4", {2, 3, 2}, true)));
}

}  // namespace npy_array_test
}  // namespace sarsim::raster

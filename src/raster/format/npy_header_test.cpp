#include "raster/format/npy_header.hpp"

#include <gtest/gtest.h>

#include <array>

namespace sarsim::raster {
namespace npy_header_test {

std::variant<NpyHeader, core::Problem> parsed(const std::string& bytes) {
  return parse_npy_header(std::as_bytes(std::span(bytes)));
}

// A file of a version with some dictionary.
std::string with_text(char major, const std::string& text) {
  std::string bytes = "\x93NUMPY";
  bytes += major;
  bytes += '\0';
  bytes += static_cast<char>(text.size());
  bytes += '\0';
  if (major > 1) bytes += std::string(2, '\0');
  return bytes + text;
}

TEST(NpyHeader, IsPaddedTo64Bytes) {
  const std::array<std::size_t, 2> shape{3, 5};
  const std::string text = npy_header_text("<c8", shape);
  EXPECT_EQ(text, std::string("\x93NUMPY\x01\x00v\x00", 10) +
                      "{'descr': '<c8', 'fortran_order': False, 'shape': (3, 5), }" + std::string(58, ' ') + "\n");
  EXPECT_EQ(text.size(), 128U);
}

TEST(NpyHeader, ReadsWhatItWrites) {
  for (const std::size_t size : {std::size_t{1}, std::size_t{12345678901}}) {
    const std::array<std::size_t, 3> shape{size, 7, 2};
    const std::string text = npy_header_text("<i4", shape);
    EXPECT_EQ(text.size() % 64, 0U);
    const auto header = std::get<NpyHeader>(parsed(text));
    EXPECT_EQ(header.type, "<i4");
    EXPECT_FALSE(header.fortran_order);
    EXPECT_EQ(header.shape, (std::vector<std::uint64_t>{size, 7, 2}));
    EXPECT_EQ(header.data_offset, text.size());
  }
}

TEST(NpyHeader, ReadsEveryVersionAndSpelling) {
  const std::string dictionary = "{ \"shape\" : (4L,) ,'fortran_order':True,'descr':'<f8'}\n";
  for (const char major : {'\1', '\2', '\3'}) {
    const auto header = std::get<NpyHeader>(parsed(with_text(major, dictionary)));
    EXPECT_TRUE(header.fortran_order);
    EXPECT_EQ(header.shape, (std::vector<std::uint64_t>{4}));
    EXPECT_EQ(header.type, "<f8");
  }
}

TEST(NpyHeader, ReadsStructures) {
  const std::string text =
      "{'descr': [('x', '<f8'), ('name', '<U3'), (('title', 'v'), '<f4', (2, 3)), ('n', '|u1', 4)], "
      "'fortran_order': False, 'shape': (5,), }";
  const auto header = std::get<NpyHeader>(parsed(with_text(1, text)));
  ASSERT_EQ(header.fields.size(), 4U);
  EXPECT_EQ(header.fields[1].offset, 8U);
  EXPECT_EQ(header.fields[2].name, "v");
  EXPECT_EQ(header.fields[2].offset, 8U + 12U);
  EXPECT_EQ(header.fields[2].count, 6U);
  EXPECT_EQ(header.fields[3].offset, 8U + 12U + 24U);
  EXPECT_EQ(header.structure_bytes(), 8U + 12U + 24U + 4U);
}

TEST(NpyHeader, RefusesMalformedOnes) {
  const std::string good = "{'descr': '<c8', 'fortran_order': False, 'shape': (3, 5), }";
  ASSERT_TRUE(std::holds_alternative<NpyHeader>(parsed(with_text(1, good))));
  EXPECT_TRUE(std::holds_alternative<core::Problem>(parsed(with_text(4, good))));
  EXPECT_TRUE(std::holds_alternative<core::Problem>(parsed(with_text(1, good).substr(0, 40))));
  for (const char* text :
       {"", "{}", "{'descr': '<c8'}", "{'descr': '<c8', 'fortran_order': False, 'shape': (3, 5), } x",
        "{'descr': '<c8', 'fortran_order': Maybe, 'shape': (3, 5), }",
        "{'descr': '<c8', 'fortran_order': False, 'shape': (-3, 5), }",
        "{'descr': '<c8', 'fortran_order': False, 'shape': (99999999999999999999, 5), }",
        "{'descr': '<c8', 'fortran_order': False, 'shape': (3 5), }",
        "{'descr': [], 'fortran_order': False, 'shape': (3, 5), }",
        "{'descr': [('r', '<f4'), ('i', [('a', '<f4')])], 'fortran_order': False, 'shape': (3, 5), }",
        "{'descr': [('r', 'O')], 'fortran_order': False, 'shape': (3, 5), }",
        "{'descr': [('r', '<f4', (2,)], 'fortran_order': False, 'shape': (3, 5), }",
        "{'descr': '<c8, 'fortran_order': False, 'shape': (3, 5), }", "{'other': 1}", "{'shape': (1, 2"})
    EXPECT_TRUE(std::holds_alternative<core::Problem>(parsed(with_text(1, text)))) << text;
}

}  // namespace npy_header_test
}  // namespace sarsim::raster

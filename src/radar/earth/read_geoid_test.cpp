#include "radar/earth/read_geoid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "radar/earth/geoid_test_support.hpp"

namespace sarsim::radar {
namespace read_geoid_test {

using namespace geoid_test;

GeoidGrid sound(const std::string& bytes) {
  std::variant<GeoidGrid, core::Problem> reading = read_geoid(bytes, "g");
  if (const auto* const problem = std::get_if<core::Problem>(&reading)) ADD_FAILURE() << core::to_string(*problem);
  return std::get<GeoidGrid>(std::move(reading));
}

core::Problem problem_of(const std::string& bytes) {
  const std::variant<GeoidGrid, core::Problem> reading = read_geoid(bytes, "g");
  const auto* const problem = std::get_if<core::Problem>(&reading);
  EXPECT_NE(problem, nullptr);
  return problem == nullptr ? core::Problem{} : *problem;
}

std::string replaced(std::string text, const std::string& piece, const std::string& by) {
  const std::size_t place = text.find(piece);
  EXPECT_NE(place, std::string::npos) << piece;
  return place == std::string::npos ? text : text.replace(place, piece.size(), by);
}

std::optional<double> at(const GeoidGrid& grid, double latitude_deg, double longitude_deg) {
  return grid.undulation_m(latitude_deg * core::rad_per_deg, longitude_deg * core::rad_per_deg);
}

TEST(ReadGeoid, TellsFormatsByTheirBytes) {
  EXPECT_EQ(geoid_format_of(pgm_bytes()), GeoidFormat::pgm);
  EXPECT_EQ(geoid_format_of(gtx_bytes()), GeoidFormat::gtx);
  EXPECT_EQ(geoid_format_of(ascii_text()), GeoidFormat::ascii);
  EXPECT_EQ(geoid_format_of("\r\n  yllcenter 3"), GeoidFormat::ascii);
  EXPECT_EQ(geoid_format_of(""), GeoidFormat::unknown);
  EXPECT_EQ(geoid_format_of(std::string(1000, '\0')), GeoidFormat::unknown);
  EXPECT_EQ(problem_of("GeoTIFF").message, "the file is no grid of the geoid that could be read");
}

TEST(ReadGeoid, ReadsGeographicLibsPicture) {
  const GeoidGrid grid = sound(pgm_bytes());
  EXPECT_EQ(grid.lattice(), (GeoidLattice{90.0, -30.0, 0.0, 30.0, 7, 12}));
  EXPECT_TRUE(grid.is_ring());
  for (int row = 0; row < 7; ++row)
    for (int column = 0; column < 12; ++column)
      EXPECT_NEAR(*at(grid, 90.0 - 30.0 * row, 30.0 * column), -108.0 + 0.003 * pgm_level(row, column), 1e-9);
  // The header may stand in one line, as netpbm allows.
  EXPECT_TRUE(at(sound(replaced(pgm_bytes(), "12 7\n65535", "12 7 65535")), 0.0, 0.0));
  EXPECT_TRUE(at(sound(replaced(pgm_bytes(), "12 7\n", "# Origin 90N 0E\n# AREA_OR_POINT Point\r\n12 7\r\n")), 0, 0));
}

TEST(ReadGeoid, RefusesBrokenPictures) {
  const std::string good = pgm_bytes();
  EXPECT_EQ(problem_of(good.substr(0, good.size() - 1)).message, "the PGM file is cut off");
  EXPECT_EQ(problem_of(good + '\n').message, "there is more than pixels in the PGM file");
  EXPECT_EQ(problem_of(replaced(good, "# Scale 0.003\n", "")).message,
            "the header does not say how pixels become heights");
  core::Problem problem = problem_of(replaced(good, "# Scale 0.003", "# Scale zero"));
  EXPECT_EQ(problem.message, "Scale is not a number");
  EXPECT_EQ(problem.place, (core::Place{"g", 4, 0}));
  EXPECT_EQ(problem_of(replaced(good, "0.003", "-0.003")).message, "Scale is not above 0");
  EXPECT_EQ(problem_of(replaced(good, "0.003", "nan")).message, "Scale is not a number");
  EXPECT_EQ(problem_of(replaced(good, "0.003", "1e308")).message, "no geoid is so high (row 1, column 1)");
  EXPECT_EQ(problem_of(replaced(good, "# Scale", "# Offset 3\n# Scale")).message, "Offset appears twice in the header");
  EXPECT_EQ(problem_of(replaced(good, "65535", "255")).message, "the pixels of the PGM do not have 16 bits");
  EXPECT_EQ(problem_of(replaced(good, "12 7", "7 12")).message,
            "the picture does not cover the Earth from pole to pole");
  EXPECT_EQ(problem_of(replaced(good, "12 7", "999998 999999")).message, "the PGM file is cut off");
  problem = problem_of(replaced(good, "12 7", "99999999999999999999 7"));
  EXPECT_EQ(problem.message, "the header of the PGM has no such number");
  EXPECT_EQ(problem.place.line, 5U);
  EXPECT_EQ(problem_of(replaced(good, "12 7", "-12 7")).message, "the header of the PGM has no such number");
  EXPECT_EQ(problem_of(replaced(good, "12 7", "# Origin 90S 0E\n12 7")).message, "the picture begins at another place");
  EXPECT_EQ(problem_of(replaced(good, "12 7", "# AREA_OR_POINT Area\n12 7")).message, "the pixels are not points");
  EXPECT_EQ(problem_of("P5\n# Offset 1\n# Scale 1\n12 7\n65535").message, "the PGM ends with its header");
  EXPECT_EQ(problem_of("P5").message, "the header of the PGM has no such number");
}

TEST(ReadGeoid, ReadsGtx) {
  const GeoidGrid grid = sound(gtx_bytes());
  EXPECT_EQ(grid.lattice(), (GeoidLattice{10.0, 0.5, 200.0, 0.5, 5, 4}));
  EXPECT_NEAR(*at(grid, 10.0, -160.0), 12.0, 1e-6);
  EXPECT_NEAR(*at(grid, 11.25, 200.75), 11.25 + 2.0075, 1e-6);
  EXPECT_TRUE(at(grid, 11.9, 200.99));
  EXPECT_FALSE(at(grid, 11.9, 201.01));
  EXPECT_FALSE(at(grid, 9.99, 201.0));
}

TEST(ReadGeoid, ReadsGtxOfTheWholeEarth) {
  // As egm96_15.gtx: from the south pole and -180 deg, no column repeated.
  std::string bytes = gtx_header(-90.0, -180.0, 45.0, 60.0, 5, 6);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 6; ++column)
      append_float(bytes, row == 0 ? -30.0F : row == 4 ? 14.0F : static_cast<float>(10 * row + column));
  const GeoidGrid grid = sound(bytes);
  EXPECT_TRUE(grid.is_ring());
  EXPECT_NEAR(*at(grid, 90.0, 33.0), 14.0, 1e-9);
  EXPECT_NEAR(*at(grid, -90.0, 133.0), -30.0, 1e-9);
  EXPECT_NEAR(*at(grid, -45.0, 150.0), 0.5 * (15.0 + 10.0), 1e-9);
  EXPECT_NEAR(*at(grid, -45.0, 180.0), 10.0, 1e-9);
}

TEST(ReadGeoid, RefusesBrokenGtx) {
  const auto message_of = [](const std::string& bytes) {
    const auto reading = read_geoid_gtx(bytes, "g");
    const auto* const problem = std::get_if<core::Problem>(&reading);
    return problem == nullptr ? "" : problem->message;
  };
  const std::string good = gtx_bytes();
  const std::string data = good.substr(40);
  const std::string length = "the GTX file does not hold as many values as its header says";
  EXPECT_EQ(message_of(good.substr(0, 39)), "the GTX file ends within its header");
  EXPECT_EQ(message_of(good.substr(0, good.size() - 1)), length);
  EXPECT_EQ(problem_of(good.substr(0, good.size() - 1)).message, length);
  EXPECT_EQ(message_of(good + "x"), length);
  EXPECT_EQ(message_of(good + "xxxx"), length);
  EXPECT_EQ(message_of(gtx_header(10, 200, 0.5, 0.5, 2147483647, 2147483647) + data), length);
  EXPECT_EQ(message_of(gtx_header(10, 200, 0.5, 0.5, 1073741824, 1073741824) + data), length);
  EXPECT_EQ(message_of(gtx_header(10, 200, 0.5, 0.5, -5, -4) + data), "the numbers of rows and columns cannot be");
  EXPECT_EQ(message_of(gtx_header(10, 200, 0.5, 0.5, 0, 4) + data), "the numbers of rows and columns cannot be");
  EXPECT_EQ(message_of(gtx_header(10, 200, -0.5, 0.5, 5, 4) + data), "the step of the latitude is not above 0");
  EXPECT_EQ(message_of(gtx_header(10, 200, 0.5, std::nan(""), 5, 4) + data), "the place of the grid is not known");
  EXPECT_EQ(message_of(gtx_header(1e300, 200, 0.5, 0.5, 5, 4) + data), "the place of the grid is not known");
  EXPECT_EQ(message_of(gtx_header(89, 200, 0.5, 0.5, 5, 4) + data), "the rows of the grid reach beyond a pole");
  for (const float value : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    std::string bytes = good;
    std::string number;
    append_float(number, value);
    EXPECT_EQ(message_of(bytes.replace(44, 4, number)), "value 2 of the GTX file is not finite");
  }
}

TEST(ReadGeoid, ReadsAsciiGrids) {
  const GeoidGrid grid = sound(ascii_text());
  EXPECT_EQ(grid.lattice(), (GeoidLattice{51.5, -1.0, 7.5, 1.0, 2, 3}));
  EXPECT_NEAR(*at(grid, 51.5, 8.0), 48.0, 1e-9);
  EXPECT_NEAR(*at(grid, 51.0, 7.5), 47.0, 1e-9);
  EXPECT_FALSE(at(grid, 51.0, 8.0));
  EXPECT_FALSE(at(grid, 51.6, 8.0));
  const GeoidGrid centred = sound("nrows 2 ncols 2 xllcenter -1 yllcenter 4 cellsize 2 1e1 20 30 -9999");
  EXPECT_EQ(centred.lattice(), (GeoidLattice{6.0, -2.0, -1.0, 2.0, 2, 2}));
  EXPECT_NEAR(*at(centred, 6.0, 0.0), 15.0, 1e-9);
  EXPECT_FALSE(at(centred, 4.0, 1.0));
}

TEST(ReadGeoid, RefusesBrokenAsciiGrids) {
  const std::string good = ascii_text();
  core::Problem problem = problem_of(replaced(good, "48.25", "48,25"));
  EXPECT_EQ(problem.message, "a value is not a number");
  EXPECT_EQ(problem.place, (core::Place{"g", 8, 0}));
  EXPECT_EQ(problem.hint, "write a point, not a comma");
  EXPECT_EQ(problem_of(replaced(good, "48.25", "inf")).message, "a value is not a number");
  EXPECT_EQ(problem_of(replaced(good, "48.25", "1e99")).message, "a value is too large");
  EXPECT_EQ(problem_of(replaced(good, "48.25", "")).message, "the values end early");
  EXPECT_EQ(problem_of(good + "1").message, "there is more in the file than its values");
  EXPECT_EQ(problem_of(replaced(good, "ncols 3", "ncols 3.5")).message, "ncols is no number of nodes");
  EXPECT_EQ(problem_of(replaced(good, "ncols 3", "ncols -3")).message, "ncols is no number of nodes");
  EXPECT_EQ(problem_of(replaced(good, "ncols 3", "ncols 1e300")).message, "ncols is no number of nodes");
  EXPECT_EQ(problem_of(replaced(good, "ncols 3", "ncols 999999")).message,
            "the file is too short for its numbers of rows and columns");
  EXPECT_EQ(problem_of(replaced(good, "NROWS 2\n", "")).message, "nrows is missing");
  EXPECT_EQ(problem_of(replaced(good, "cellsize 1\n", "")).message, "cellsize is missing");
  EXPECT_EQ(problem_of(replaced(good, "cellsize 1\n", "cellsize 0\n")).message, "the grid of the geoid has no step");
  EXPECT_EQ(problem_of(replaced(good, "cellsize 1\n", "dx 1\ndy 1\n")).message,
            "the word is not known in the header of an ASCII grid");
  EXPECT_EQ(problem_of(replaced(good, "xllcorner 7\n", "")).message, "the place of the grid is not clear");
  EXPECT_EQ(problem_of(replaced(good, "xllcorner 7\n", "xllcorner 7\nxllcenter 7\n")).message,
            "the place of the grid is not clear");
  EXPECT_EQ(problem_of(replaced(good, "NROWS 2\n", "nrows 2 NRows 2\n")).message, "nrows appears twice");
  EXPECT_EQ(problem_of(replaced(good, "cellsize 1\n", "cellsize one\n")).message, "cellsize is not a number");
}

// Numbers of a fixed sequence (splitmix64).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t end) {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<std::size_t>((z ^ (z >> 31U)) % end);
  }

 private:
  std::uint64_t state_;
};

// Some bytes changed, left out, doubled, or the rest cut off; more often than not in the header.
std::string mutated(std::string bytes, Numbers& numbers) {
  constexpr std::string_view likely = "\n\r\t #0123456789.-+eE\xFF\x7F\x80";
  for (std::size_t changes = 1 + numbers.below(3); changes > 0 && !bytes.empty(); --changes) {
    const std::size_t end = numbers.below(2) == 0 ? std::min<std::size_t>(bytes.size(), 90) : bytes.size();
    const std::size_t place = numbers.below(end);
    const std::size_t length = std::min(1 + numbers.below(20), bytes.size() - place);
    switch (numbers.below(6)) {
      case 0: bytes[place] = static_cast<char>(numbers.below(256)); break;
      case 1: bytes[place] = likely[numbers.below(likely.size())]; break;
      case 2: bytes.erase(place, length); break;
      case 3: bytes.insert(place, bytes.substr(numbers.below(bytes.size()), length)); break;
      case 4: bytes[place] = static_cast<char>(bytes[place] ^ static_cast<char>(1U << numbers.below(8))); break;
      default:
        if (numbers.below(8) == 0) bytes.resize(place);
    }
  }
  return bytes;
}

// What a grid promises, whatever bytes it was made from.
void expect_sound(const GeoidGrid& grid, const std::string& bytes, Numbers& numbers) {
  ASSERT_LE(grid.lattice().rows * grid.lattice().columns, bytes.size());
  for (int i = 0; i < 20; ++i) {
    const double latitude_deg = -90.0 + static_cast<double>(numbers.below(361)) * 0.5;
    const double longitude_deg = -400.0 + static_cast<double>(numbers.below(8001)) * 0.1;
    const std::optional<double> undulation_m = at(grid, latitude_deg, longitude_deg);
    ASSERT_LE(std::abs(undulation_m.value_or(0.0)), largest_undulation_m * (1.0 + 1e-12));
  }
}

TEST(ReadGeoid, SurvivesTenThousandMutations) {
  const std::string originals[] = {pgm_bytes(), gtx_bytes(), ascii_text()};
  Numbers numbers(20260728);
  std::size_t refused = 0;
  for (int i = 0; i < 10'000; ++i) {
    const std::string bytes = mutated(originals[numbers.below(std::size(originals))], numbers);
    for (const auto& reading : {read_geoid(bytes, "m"), read_geoid_gtx(bytes, "m"), read_geoid_pgm(bytes, "m"),
                                read_geoid_ascii(bytes, "m")}) {
      if (const auto* const grid = std::get_if<GeoidGrid>(&reading)) {
        expect_sound(*grid, bytes, numbers);
        continue;
      }
      const core::Problem& problem = std::get<core::Problem>(reading);
      ASSERT_FALSE(problem.message.empty());
      ASSERT_EQ(problem.place.file, "m");
      ASSERT_LE(problem.place.line, bytes.size() + 1);
    }
    refused += std::holds_alternative<core::Problem>(read_geoid(bytes, "m")) ? 1U : 0U;
  }
  EXPECT_GT(refused, 4'000U);
  EXPECT_LT(refused, 10'000U);
}

}  // namespace read_geoid_test
}  // namespace sarsim::radar

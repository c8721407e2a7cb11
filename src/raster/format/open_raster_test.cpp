#include "raster/format/open_raster.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <stdexcept>

#include "raster/format/data_test_support.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/npy_header.hpp"

namespace sarsim::raster {
namespace sample_file_test {

using namespace data_test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using Samples = std::vector<std::complex<double>>;

RasterHints hints_of(std::size_t columns, int bits) {
  RasterHints hints;
  hints.columns = columns;
  hints.bits = bits;
  return hints;
}

// Opens a text under a name; the file is gone afterwards, but open.
OpenedRaster opened(std::string_view text, const RasterHints& hints = {}, const std::string& name = "a.txt") {
  const TestFolder folder;
  return open_raster(Integrity::whole, put(folder / name, text), hints);
}

// The only error of a text.
core::Problem error_of(std::string_view text, const RasterHints& hints = {}, const std::string& name = "a.txt") {
  const OpenedRaster result = opened(text, hints, name);
  EXPECT_FALSE(result.raster);
  EXPECT_EQ(result.problems.size(), 1U) << text_of(result.problems);
  EXPECT_TRUE(core::has_errors(result.problems));
  return result.problems.empty() ? core::Problem{} : result.problems.front();
}

Samples samples_of(std::string_view text, std::size_t rows, std::size_t columns, const RasterHints& hints = {},
                   const std::string& name = "a.txt") {
  const OpenedRaster result = opened(text, hints, name);
  EXPECT_TRUE(result.raster) << text_of(result.problems);
  if (!result.raster) return {};
  EXPECT_EQ(result.raster->rows(), rows);
  EXPECT_EQ(result.raster->info().columns, columns);
  return read_all_rows(*result.raster);
}

const Samples four{{1, 2}, {-3, 4}, {5, 0}, {7, 8}};

TEST(WholeFile, ReadsAsciiWithAnyWhiteSpace) {
  EXPECT_EQ(samples_of("1 2\n-3 4\n\n5 0\n7 8\n\n", 2, 2), four);
  EXPECT_EQ(samples_of("1 2\r\n-3 4\r\n\r\n5 -0\r\n7 8", 2, 2), four);
  EXPECT_EQ(samples_of("\xEF\xBB\xBF\n\n  1\t2 \n -3\n+4\n \t \n\n\n5 0 7 8\n\n\n", 2, 2), four);
}

TEST(WholeFile, ColumnsReplaceBlankLinesOfAscii) {
  EXPECT_EQ(samples_of("1 2\n-3 4\n5 0\n7 8\n", 1, 4), four);
  EXPECT_EQ(samples_of("1 2\n-3 4\n5 0\n7 8\n", 2, 2, hints_of(2, 0)), four);
  EXPECT_EQ(samples_of("1 2\n\n-3 4\n\n5 0\n\n7 8\n", 2, 2, hints_of(2, 0)), four);
}

TEST(WholeFile, MinusZeroIsZero) {
  const Samples samples = samples_of("-0 0\n", 1, 1);
  EXPECT_FALSE(std::signbit(samples.at(0).real()));
}

TEST(WholeFile, ReadsWholeNumbersOfAnyLengthWhereverTheyStand) {
  EXPECT_EQ(
      samples_of("9223372036854775807 -9999999999999999999\n+18446744073709551615 12345678901234567890", 1, 2),
      (Samples{{9223372036854775807.0, -9999999999999999999.0}, {18446744073709551615.0, 12345678901234567890.0}}));
  EXPECT_EQ(error_of("1 -\n").found, "-");
  EXPECT_EQ(error_of("1 +-2\n").found, "+-2");
  std::string text;
  Samples expected;
  for (int row = 0; row < 20000; ++row) {
    text += fmt::format("{} {}\n\n", row, -row);
    expected.emplace_back(row, -row);
  }
  EXPECT_EQ(samples_of(text, 20000, 1), expected);
}

TEST(WholeFile, ReadsBracketText) {
  EXPECT_EQ(samples_of("(1,2) (-3,4) \n(5,0) (7,8) \n", 2, 2), four);
  EXPECT_EQ(samples_of("( 1 , 2 )(-3,4)\r\n\r\n(5,0)\t(7,8)", 2, 2), four);
}

TEST(WholeFile, ReadsCsvAsItStandsWithANoteAboutTheOffset) {
  const OpenedRaster result = opened("1,2,-3,4\n5,0,7,8\n");
  ASSERT_TRUE(result.raster);
  EXPECT_EQ(read_all_rows(*result.raster), four);
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_EQ(result.problems[0].severity, core::Severity::note);
  EXPECT_THAT(result.problems[0].message, HasSubstr("offset"));
}

TEST(WholeFile, SubtractsTheOffsetOfCsvWhereBitsAreGiven) {
  EXPECT_EQ(samples_of("I0,Q0,I1,Q1\r\n128,129,124,131\r\n\r\n 132 , 127,134,135,\r\n", 2, 2, hints_of(0, 8)), four);
  const Samples top = samples_of("18446744073709551614,0\n", 1, 1, hints_of(0, 64));
  EXPECT_EQ(top.at(0), std::complex<double>(9223372036854775807.0, -9223372036854775807.0));
}

TEST(WholeFile, RefusesCsvThatTheBitsDoNotFit) {
  EXPECT_EQ(error_of("1,2\n3,-4\n", hints_of(0, 8)).found, "negative numbers");
  EXPECT_EQ(error_of("1,2\n3,256\n", hints_of(0, 8)).found, "256");
  EXPECT_THAT(error_of("1,2.5\n", hints_of(0, 8)).found, HasSubstr("whole"));
  EXPECT_EQ(error_of("1,2\n", hints_of(0, 65)).expected, "1 to 64");
}

TEST(WholeFile, DecimalsAreVolts) {
  const OpenedRaster result = opened("1e-3 2.5\n");
  ASSERT_TRUE(result.raster);
  EXPECT_FALSE(result.raster->info().counts);
  EXPECT_EQ(read_all_rows(*result.raster), (Samples{{1e-3, 2.5}}));
}

TEST(WholeFile, NamesThePlaceOfTextThatIsNoNumber) {
  const core::Problem ascii = error_of("1 2\n3 x4\n");
  EXPECT_EQ(ascii.place.line, 2U);
  EXPECT_EQ(ascii.place.column, 3U);
  EXPECT_EQ(ascii.found, "x4");
  EXPECT_THAT(ascii.place.file, HasSubstr("a.txt"));
  const core::Problem csv = error_of("1,2\n3, 4, nan,1\n");
  EXPECT_EQ(csv.place.line, 2U);
  EXPECT_EQ(csv.place.column, 7U);
  EXPECT_EQ(csv.found, "nan");
  const core::Problem bracket = error_of("(1,2) (3;4)\n");
  EXPECT_EQ(bracket.place.column, 8U);
  EXPECT_EQ(bracket.found, "3;4");
  EXPECT_EQ(error_of("1 \xE9\n").found, "\\xe9");
  EXPECT_EQ(error_of("1,2\n3,\x01\x02,4\n", {.format = scene::FileFormat::csv}).found, "\\x01\\x02");
}

TEST(WholeFile, NamesThePlaceOfIncompleteSamples) {
  EXPECT_EQ(error_of("1,2\n3,,4\n").place.column, 3U);
  EXPECT_EQ(error_of("1,2\n3 4\n").expected, "a comma or the end of the line");
  EXPECT_EQ(error_of("(1,2) (3)\n").expected, "a comma");
  EXPECT_THAT(error_of("(1,2) (3,4\n").found, HasSubstr("end of the line"));
  EXPECT_THAT(error_of("(1,2) (3").message, HasSubstr("the file ends"));
}

TEST(WholeFile, ListsRowsOfOtherLengths) {
  const OpenedRaster result = opened("1 2\n3 4\n\n5 6\n\n1 2\n3 4\n\n7 8\n9 9\n1 1\n\n1 2\n3 4\n");
  EXPECT_FALSE(result.raster);
  ASSERT_EQ(result.problems.size(), 2U);
  EXPECT_EQ(result.problems[0].place.line, 4U);
  EXPECT_EQ(result.problems[0].found, "1 samples");
  EXPECT_EQ(result.problems[0].expected, "2 samples, as in the first row");
  EXPECT_TRUE(result.problems[0].hint.empty());
  EXPECT_EQ(result.problems[1].place.line, 11U);
}

TEST(WholeFile, SaysThatTheLastRowMayBeCutOff) {
  const core::Problem ascii = error_of("1 2\n3 4\n\n5 6\n7\n");
  EXPECT_EQ(ascii.place.line, 5U);
  EXPECT_EQ(ascii.found, "3 numbers");
  EXPECT_THAT(ascii.hint, HasSubstr("cut off"));
  EXPECT_THAT(error_of("1,2,3,4\n5,6\n").hint, HasSubstr("cut off"));
  EXPECT_THAT(error_of("1 2\n3 4\n5 6\n", hints_of(2, 0)).hint, HasSubstr("cut off"));
  EXPECT_THAT(error_of("1 2 3").message, HasSubstr("no Q"));
}

TEST(WholeFile, ListsAtMostTenRows) {
  std::string text = "1 2\n3 4\n\n";
  for (int i = 0; i < 100; ++i) text += "1 2\n\n";
  EXPECT_EQ(opened(text).problems.size(), 10U);
}

TEST(WholeFile, HintsOfTheShapeAreChecked) {
  RasterHints hints;
  hints.rows = 3;
  EXPECT_EQ(error_of("1 2\n\n3 4\n\n", hints).expected, "3");
  EXPECT_THAT(error_of("1,2,3,4\n", hints_of(3, 8)).expected, HasSubstr("3 samples"));
}

TEST(WholeFile, ReadsImagesWithAnEnviHeaderAsVolts) {
  const TestFolder folder;
  EnviHeader header;
  header.samples = header.lines = 2;
  header.description = "four";
  header.fields = {{"algorithm", "omega-k"}, {"script", "r.scr"}};
  EnviWriter writer(folder / "r.img", header, false);
  const std::array<std::complex<float>, 4> pixels{{{1, 2}, {-3, 4}, {5, 0}, {7, 8}}};
  writer.append(std::span(pixels).first(2));
  writer.append(std::span(pixels).last(2));
  writer.finish();
  const OpenedRaster image = open_raster(Integrity::whole, folder / "r.img");
  ASSERT_TRUE(image.raster) << text_of(image.problems);
  EXPECT_EQ(image.raster->info().format, &envi_format());
  EXPECT_FALSE(image.raster->info().counts);
  EXPECT_EQ(read_all_rows(*image.raster), four);
  Samples second(2);
  image.raster->read_rows(1, 1, second);
  EXPECT_EQ(second, (Samples{{5, 0}, {7, 8}}));
  EXPECT_THAT(image.raster->info().attributes,
              ElementsAre(Pair("description", "four"), Pair("data type", "complex float"), Pair("algorithm", "omega-k"),
                          Pair("script file", "r.scr")));
}

TEST(WholeFile, TakesAHeaderOnlyWhereNothingElseSaysWhatAFileIs) {
  const TestFolder folder;
  put(folder / "r.hdr", "ENVI\nsamples = 1\nlines = 1\ndata type = 6\n");
  put(folder / "r.asc", "1 2\n-3 4\n\n5 0\n7 8\n\n");
  const OpenedRaster text = open_raster(Integrity::whole, folder / "r.asc");
  ASSERT_TRUE(text.raster) << text_of(text.problems);
  EXPECT_EQ(text.raster->info().format, &format_of(scene::FileFormat::ascii));
  put(folder / "r.dat", std::string(16, '\1'));
  const OpenedRaster flat = open_raster(Integrity::whole, folder / "r.dat", hints_of(2, 8));
  ASSERT_TRUE(flat.raster) << text_of(flat.problems);
  EXPECT_EQ(flat.raster->info().format, &format_of(scene::FileFormat::binary));
  EXPECT_EQ(open_raster(Integrity::whole, folder / "r.dat").raster->rows(), 1U);
}

TEST(WholeFile, EmptyFilesAreProblems) {
  EXPECT_THAT(error_of("").message, HasSubstr("empty"));
  EXPECT_THAT(error_of(" \n\n").message, HasSubstr("no samples"));
  EXPECT_THAT(error_of("I0,Q0\n").message, HasSubstr("no samples"));
  EXPECT_THAT(error_of("", hints_of(2, 8), "a.bin").message, HasSubstr("empty"));
}

// Whatever has to be read through asks before the first number.
TEST(WholeFile, IsLeftWhereAStopIsRequested) {
  const TestFolder folder;
  core::StopFlag stop;
  stop.request();
  for (const char* name : {"a.txt", "a.csv"}) {
    const fs::path path = put(folder / name, std::string_view(name) == "a.csv" ? "1,2\n-3,4\n" : "1 2\n-3 4\n");
    for (const Integrity integrity : {Integrity::whole, Integrity::partial})
      EXPECT_THROW((void)open_raster(integrity, path, {}, &stop), core::Interrupted) << name;
  }
  for (const auto format : {scene::FileFormat::hdf5, scene::FileFormat::zarr}) {
    const fs::path path = folder / fmt::format("b{}", extension_of(format));
    write_test_file(path, test_product(3, 2, 8), {format});
    ASSERT_TRUE(open_raster(Integrity::whole, path).raster) << path;
    EXPECT_THROW((void)open_raster(Integrity::whole, path, {}, &stop), core::Interrupted) << path;
  }
}

TEST(WholeFile, ReadsAnyRowsOfALongText) {
  std::string text;
  for (int row = 0; row < 5000; ++row) text += fmt::format("{} {}\n{} 0\n\n", row, -row, row % 7);
  const OpenedRaster result = opened(text);
  ASSERT_TRUE(result.raster) << text_of(result.problems);
  for (const std::size_t first : {0U, 1U, 37U, 2500U, 4997U}) {
    Samples rows(6);
    result.raster->read_rows(first, 3, rows);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<double>(first + i);
      EXPECT_EQ(rows[2 * i], std::complex<double>(row, -row));
      EXPECT_EQ(rows[2 * i + 1], std::complex<double>(static_cast<double>((first + i) % 7), 0.0));
    }
  }
}

TEST(WholeFile, RefusesRowsThatAreNotThere) {
  const OpenedRaster result = opened("1 2\n\n3 4\n\n");
  Samples out(2);
  EXPECT_THROW(result.raster->read_rows(1, 2, out), std::out_of_range);
  EXPECT_THROW(result.raster->read_rows(static_cast<std::size_t>(-1), 2, out), std::out_of_range);
  EXPECT_THROW(result.raster->read_rows(0, 1, out), std::invalid_argument);
  EXPECT_NO_THROW(result.raster->read_rows(2, 0, {}));
}

TEST(WholeFile, SaysThatAFileHasBeenChanged) {
  const TestFolder folder;
  const auto text = open_raster(Integrity::whole, put(folder / "a.txt", "1 2\n\n3 4\n\n"));
  put(folder / "a.txt", "1 2\n\n3\n\n");
  Samples out(2);
  EXPECT_THROW(text.raster->read_rows(0, 2, out), std::runtime_error);
  const auto binary = open_raster(Integrity::whole, put(folder / "a.bin", "abcd"), hints_of(1, 8));
  put(folder / "a.bin", "ab");
  EXPECT_THROW(binary.raster->read_rows(0, 2, out), std::runtime_error);
}

TEST(WholeFile, BinaryNeedsColumnsAndBits) {
  const OpenedRaster result = opened("abcd", {}, "a.bin");
  EXPECT_EQ(result.problems.size(), 1U);
  EXPECT_THAT(result.problems[0].hint, HasSubstr("samples of a row"));
  EXPECT_EQ(error_of("abcd", hints_of(1, 65), "a.bin").expected, "1 to 64");
  EXPECT_EQ(error_of("abcd", hints_of(1, -1), "a.bin").expected, "1 to 64");
  EXPECT_EQ(samples_of("\x7F\x80\xFF\x01", 2, 1, hints_of(1, 8), "a.bin"), (Samples{{0, 1}, {128, -126}}));
}

TEST(WholeFile, BinaryOfAnotherSizeNamesTheNumbers) {
  const core::Problem problem = error_of("abcde", hints_of(1, 12), "a.bin");
  EXPECT_EQ(problem.found, "5 bytes");
  EXPECT_EQ(problem.expected, "a multiple of 1 samples x 2 x 2 bytes");
  EXPECT_EQ(error_of("abcd", hints_of(std::size_t{1} << 63, 64), "a.bin").found, "4 bytes");
  RasterHints hints = hints_of(1, 8);
  hints.rows = 3;
  EXPECT_EQ(error_of("abcd", hints, "a.bin").found, "2");
}

TEST(WholeFile, BinaryWithImpossibleValuesIsWarnedOf) {
  const OpenedRaster result = opened(std::string_view("\x00\x0F\x00\xF0", 4), hints_of(1, 12), "a.bin");
  ASSERT_TRUE(result.raster);
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_EQ(result.problems[0].severity, core::Severity::warning);
  EXPECT_EQ(result.problems[0].found, "61440 at byte 2");
}

TEST(WholeFile, UnknownContentIsAProblemThatAsksForTheFormat) {
  EXPECT_THAT(error_of(std::string_view("\0\1\2\3", 4), {}, "a").hint, HasSubstr("give the format"));
  EXPECT_EQ(samples_of("\x01\x02", 1, 1, hints_of(1, 8), "a"), (Samples{{-126, -125}}));
}

TEST(WholeFile, FilesThatCannotBeOpenedAreProblems) {
  const TestFolder folder;
  const auto message = [](const fs::path& path) { return open_raster(Integrity::whole, path).problems.at(0).message; };
  EXPECT_THAT(message(folder / "none"), HasSubstr("No such file"));
  EXPECT_THAT(message(folder.path()), HasSubstr("folder"));
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(message(folder / "pipe"), HasSubstr("not a regular file"));
}

// A NumPy file of a type and shape with so many bytes behind the header.
std::string npy(std::string_view type, std::vector<std::size_t> shape, const std::string& data) {
  return npy_header_text(type, shape) + data;
}

template <class Number>
std::string bytes_of(std::vector<Number> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

TEST(WholeFile, ReadsNumpyArraysOfEveryType) {
  EXPECT_EQ(samples_of(npy("<c8", {2, 2}, bytes_of<float>({1, 2, -3, 4, 5, 0, 7, 8})), 2, 2), four);
  EXPECT_EQ(samples_of(npy("<c16", {4}, bytes_of<double>({1, 2, -3, 4, 5, 0, 7, 8})), 1, 4), four);
  EXPECT_EQ(samples_of(npy("<f4", {2, 2, 2}, bytes_of<float>({1, 2, -3, 4, 5, 0, 7, 8})), 2, 2), four);
  EXPECT_EQ(samples_of(npy("<f8", {4, 1, 2}, bytes_of<double>({1, 2, -3, 4, 5, 0, 7, 8})), 4, 1), four);
  EXPECT_EQ(samples_of(npy("<i2", {4, 2}, bytes_of<std::int16_t>({1, 2, -3, 4, 5, 0, 7, 8})), 1, 4), four);
  EXPECT_EQ(samples_of(npy("<i4", {2, 2, 2}, bytes_of<std::int32_t>({1, 2, -3, 4, 5, 0, 7, 8})), 2, 2), four);
  EXPECT_EQ(samples_of(npy("<i8", {2, 2, 2}, bytes_of<std::int64_t>({1, 2, -3, 4, 5, 0, 7, 8})), 2, 2), four);
}

TEST(WholeFile, NumpyIntegersAreCountsAndTheOthersVolts) {
  EXPECT_TRUE(opened(npy("<i2", {1, 1, 2}, "abcd")).raster->info().counts);
  EXPECT_FALSE(opened(npy("<c8", {1, 1}, "abcdefgh")).raster->info().counts);
}

TEST(WholeFile, RefusesNumpyArraysByTheNameOfTheirFault) {
  EXPECT_THAT(error_of(npy(">c8", {1, 1}, "abcdefgh")).message, HasSubstr("big-endian"));
  EXPECT_EQ(error_of(npy("|u1", {1, 1, 2}, "ab")).found, "|u1");
  std::string fortran = npy("<c8", {1, 1}, "abcdefgh");
  fortran.replace(fortran.find("False"), 5, "True ");
  EXPECT_THAT(error_of(fortran).message, HasSubstr("Fortran"));
  EXPECT_EQ(error_of(npy("<f4", {1, 3}, "abcdefghijkl")).found, "(1, 3)");
  EXPECT_EQ(error_of(npy("<c8", {0, 3}, "")).found, "(0, 3)");
  EXPECT_EQ(error_of(npy("<c8", {}, "abcdefgh")).found, "()");
  EXPECT_EQ(error_of(npy("<c8", {2, 2}, "abcdefgh")).found, "8 bytes");
  EXPECT_THAT(error_of("\x93NUMPY").message, HasSubstr("not a NumPy"));
}

TEST(WholeFile, HostileNumpyShapesAllocateNothing) {
  EXPECT_EQ(error_of(npy("<c8", {1000000000000, 1}, "")).expected,
            "8000000000000 bytes for the shape (1000000000000, 1)");
  EXPECT_EQ(error_of(npy("<c8", {std::size_t{1} << 40, std::size_t{1} << 40}, "")).expected, "(rows, columns)");
  EXPECT_THAT(error_of(std::string("\x93NUMPY\x02\x00\xFF\xFF\xFF\xFF", 12) + "{").message, HasSubstr("too long"));
}

TEST(WholeFile, WarnsOfWhatFollowsANumpyArray) {
  const OpenedRaster result = opened(npy("<c8", {1, 1}, "abcdefgh+"));
  ASSERT_TRUE(result.raster);
  EXPECT_EQ(result.problems.at(0).found, "1 bytes more");
}

}  // namespace sample_file_test
}  // namespace sarsim::raster

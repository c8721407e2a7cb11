#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <sstream>

#include "raster/format/data_test_support.hpp"
#include "raster/table/formats.hpp"
#include "support/folders.hpp"
#include "support/python.hpp"

// Other people's software must read our files and find the same numbers: NumPy and h5py, with which the tests run, and
// what is foreign, skipped where it is absent.
namespace sarsim::raster {
namespace outside_software_test {

using namespace data_test;
using test::python;

constexpr std::size_t rows = 5;
constexpr std::size_t columns = 7;

fs::path script(const char* name) { return test::source_folder() / "tests/data" / name; }

bool runs(const std::string& command) { return std::system((command + " > /dev/null 2>&1").c_str()) == 0; }

std::string output_of(const std::string& command) {
  std::string text;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  char part[4096];
  while (pipe && std::fgets(part, sizeof part, pipe.get()) != nullptr) text += part;
  return text;
}

// Compares the lines "row column I Q" at the beginning of a text with what the file was made of.
void expect_samples(const std::string& text, bool counts, int bits) {
  const auto whole = test_counts(rows * columns, bits);
  const auto volts = test_volts(rows * columns);
  std::istringstream stream(text);
  for (std::size_t i = 0; i < rows * columns; ++i) {
    std::size_t row = 0;
    std::size_t column = 0;
    double in_phase = 0.0;
    double quadrature = 0.0;
    ASSERT_TRUE(stream >> row >> column >> in_phase >> quadrature) << "sample " << i << " of:\n" << text;
    ASSERT_EQ(row * columns + column, i);
    ASSERT_EQ(in_phase, counts ? static_cast<double>(whole[2 * i]) : volts[i].real()) << i;
    ASSERT_EQ(quadrature, counts ? static_cast<double>(whole[2 * i + 1]) : volts[i].imag()) << i;
  }
}

// Makes a file and gives its path.
fs::path make(const TestFolder& folder, scene::FileFormat format, bool counts, int bits) {
  const fs::path path = folder / ("a" + std::string(extension_of(format)));
  SinkOptions options;
  options.format = format;
  options.counts = counts;
  write_test_file(path, test_product(rows, columns, bits), options);
  return path;
}

struct Case {
  scene::FileFormat format;
  const char* kind;
  bool counts;
  int bits;
};

const Case cases[] = {
    {scene::FileFormat::ascii, "ascii", true, 12},   {scene::FileFormat::ascii, "ascii", true, 40},
    {scene::FileFormat::csv, "csv", true, 12},       {scene::FileFormat::bracket, "bracket", true, 12},
    {scene::FileFormat::binary, "binary", true, 8},  {scene::FileFormat::binary, "binary", true, 12},
    {scene::FileFormat::binary, "binary", true, 40}, {scene::FileFormat::npy, "npy", false, 12}};

std::string name_of_case(const testing::TestParamInfo<Case>& test) {
  return fmt::format("{}_{}", test.param.kind, test.param.bits);
}

class OutsideSoftware : public testing::TestWithParam<Case> {};
class ForeignProgramOctave : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Formats, OutsideSoftware, testing::ValuesIn(cases), name_of_case);
INSTANTIATE_TEST_SUITE_P(Formats, ForeignProgramOctave, testing::ValuesIn(cases), name_of_case);

TEST_P(OutsideSoftware, NumpyFindsTheSameNumbers) {
  if (!runs(python() + " -c 'import numpy'")) GTEST_SKIP() << "python3 with numpy is not here";
  const TestFolder folder;
  const fs::path path = make(folder, GetParam().format, GetParam().counts, GetParam().bits);
  expect_samples(output_of(fmt::format("{} '{}' {} '{}' {} {}", python(), script("read_with_numpy.py").string(),
                                       GetParam().kind, path.string(), columns, GetParam().bits)),
                 GetParam().counts, GetParam().bits);
}

std::string octave_on(const fs::path& path, const char* kind, int bits) {
  return output_of(fmt::format(
      R"x(octave-cli --quiet --norc --eval "kind='{}'; path='{}'; columns={}; bits={}; source('{}')" 2> /dev/null)x",
      kind, path.string(), columns, bits, script("read_with_octave.m").string()));
}

TEST_P(ForeignProgramOctave, FindsTheSameNumbers) {
  if (!runs("command -v octave-cli")) GTEST_SKIP() << "octave-cli is not here";
  const TestFolder folder;
  const fs::path path = make(folder, GetParam().format, GetParam().counts, GetParam().bits);
  expect_samples(octave_on(path, GetParam().kind, GetParam().bits), GetParam().counts, GetParam().bits);
}

TEST(ForeignProgramOctaveOnHdf5, FindsTheSameNumbers) {
  if (!runs("command -v octave-cli") || !runs("command -v h5dump")) GTEST_SKIP() << "octave-cli or h5dump is not here";
  const TestFolder folder;
  expect_samples(octave_on(make(folder, scene::FileFormat::hdf5, false, 12), "hdf5", 12), false, 12);
}

TEST(OutsideSoftwareOnNpy, NumpyFindsTheSameIntegers) {
  if (!runs(python() + " -c 'import numpy'")) GTEST_SKIP() << "python3 with numpy is not here";
  for (const int bits : {12, 40}) {
    const TestFolder folder;
    const fs::path path = make(folder, scene::FileFormat::npy, true, bits);
    expect_samples(output_of(fmt::format("{} '{}' npy '{}' {} {}", python(), script("read_with_numpy.py").string(),
                                         path.string(), columns, bits)),
                   true, bits);
  }
}

TEST(OutsideSoftwareOnHdf5, H5pyFindsTheSameNumbersAxesAndAttributes) {
  if (!runs(python() + " -c 'import h5py'")) GTEST_SKIP() << "python3 with h5py is not here";
  for (const bool counts : {false, true}) {
    for (const int bits : {12, 40}) {
      const TestFolder folder;
      const fs::path path = make(folder, scene::FileFormat::hdf5, counts, bits);
      const std::string text =
          output_of(fmt::format("{} '{}' '{}'", python(), script("read_with_h5py.py").string(), path.string()));
      expect_samples(text, counts, bits);
      EXPECT_NE(text.find("pulse_time_s 0.5 0.501"), std::string::npos) << text;
      EXPECT_NE(text.find("carrier_hz 1000000000 1001000000 1002000000"), std::string::npos) << text;
      EXPECT_NE(text.find("slant_range_m 1000 1001.5 1003"), std::string::npos) << text;
      EXPECT_NE(text.find("platform_position_m 0 -0.5 3 100 -0.5 3 200"), std::string::npos) << text;
      EXPECT_NE(text.find("platform_velocity_mps 100 0.25 0 100 0.25 1"), std::string::npos) << text;
      EXPECT_NE(text.find("platform_rotation_rad 0.125 0 -0 0.125 0 -1"), std::string::npos) << text;
      EXPECT_NE(text.find("seed 18446744073709551615\n"), std::string::npos) << text;
      EXPECT_NE(text.find("lsb_v 2.5e-09\n"), std::string::npos) << text;
      EXPECT_NE(text.find(fmt::format("bits {}\n", bits)), std::string::npos) << text;
      EXPECT_NE(text.find(R"(script '$SIMULATION\nRadar1 ! Name of radar\n')"), std::string::npos) << text;
      EXPECT_NE(text.find(counts ? "unit count\n" : "unit V\n"), std::string::npos) << text;
    }
  }
}

TEST(ForeignProgramH5dump, ReadsTheWholeFile) {
  if (!runs("command -v h5dump")) GTEST_SKIP() << "h5dump is not here";
  const TestFolder folder;
  const fs::path path = make(folder, scene::FileFormat::hdf5, false, 12);
  const std::string text = output_of("h5dump '" + path.string() + "'");
  EXPECT_NE(text.find("H5T_IEEE_F32LE \"r\""), std::string::npos) << text;
  EXPECT_NE(text.find("( 5, 7 ) / ( 5, 7 )"), std::string::npos) << text;
  EXPECT_NE(text.find("when the middle of the pulse leaves, s"), std::string::npos) << text;
  EXPECT_TRUE(runs("h5dump '" + path.string() + "'"));
}

}  // namespace outside_software_test
}  // namespace sarsim::raster

#include "data/image_source.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "data/data_test_support.hpp"
#include "data/npy_header.hpp"
#include "data/recording_hints.hpp"

namespace sarsim {
namespace {

namespace fs = std::filesystem;
using data_test::put;
using data_test::test_product;
using data_test::TestFolder;
using data_test::text_of;
using testing::HasSubstr;

std::shared_ptr<ImageSource> open_whole(const fs::path& path, const ImageHints& hints = {}) {
  const OpenedImage opened = ImageSource::open(path, hints);
  EXPECT_TRUE(opened.source) << text_of(opened.problems);
  if (opened.source) opened.source->wait_until_indexed(nullptr);
  return opened.source;
}

ImageHints sample_hints(std::size_t columns, int bits) {
  ImageHints hints;
  hints.samples.columns = columns;
  hints.samples.bits = bits;
  return hints;
}

std::vector<std::complex<float>> read(const ImageSource& source, const ImageWindow& window, unsigned threads = 1) {
  std::vector<std::complex<float>> samples(window.samples());
  source.read_window(window, samples, {threads, nullptr});
  return samples;
}

std::vector<std::complex<float>> read_all(const ImageSource& source) {
  return read(source, {0, source.rows(), 0, source.columns()});
}

// --- The same recording in every format -------------------------------------------------------------------------

struct FormatCase {
  const char* name;
  FileFormat format;
  ImageFormat image;
  bool counts;
};

class ImageOfFormat : public testing::TestWithParam<FormatCase> {};

TEST_P(ImageOfFormat, GivesTheSamplesOfAnyWindow) {
  const TestFolder folder;
  constexpr std::size_t rows = 23;
  constexpr std::size_t columns = 17;
  constexpr int bits = 12;
  const Product product = test_product(rows, columns, bits);
  const fs::path path = folder / GetParam().name;
  data_test::write_test_file(path, product, {GetParam().format, false, GetParam().counts, false});
  const auto source = open_whole(path, sample_hints(GetParam().format == FileFormat::binary ? columns : 0, bits));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().format, GetParam().image);
  EXPECT_EQ(source->info().value, ImageValue::complex);
  EXPECT_EQ(source->info().counts, GetParam().counts);
  ASSERT_EQ(source->rows(), rows);
  ASSERT_EQ(source->columns(), columns);
  EXPECT_EQ(source->indexed(), 1.0);
  const auto counts = data_test::test_counts(rows * columns, bits);
  const auto volts = data_test::test_volts(rows * columns);
  const auto expected = [&](std::size_t row, std::size_t column) {
    const std::size_t i = row * columns + column;
    if (!GetParam().counts) return std::complex<float>(volts[i]);
    return std::complex<float>(static_cast<float>(counts[2 * i]), static_cast<float>(counts[2 * i + 1]));
  };
  for (const ImageWindow& window :
       {ImageWindow{0, rows, 0, columns}, ImageWindow{5, 3, 2, 4}, ImageWindow{22, 1, 16, 1},
        ImageWindow{1, 8, 0, 6, 3, 3}, ImageWindow{0, 2, 16, 1, 22, 1}}) {
    const auto samples = read(*source, window, 2);
    for (std::size_t i = 0; i < window.rows; ++i)
      for (std::size_t k = 0; k < window.cols; ++k)
        ASSERT_EQ(samples[i * window.cols + k], expected(window.row(i), window.column(k))) << i << ", " << k;
  }
}

TEST_P(ImageOfFormat, RefusesWindowsThatAreNotInside) {
  const TestFolder folder;
  const fs::path path = folder / GetParam().name;
  data_test::write_test_file(path, test_product(4, 3, 8), {GetParam().format, false, GetParam().counts, false});
  const auto source = open_whole(path, sample_hints(GetParam().format == FileFormat::binary ? 3 : 0, 8));
  ASSERT_TRUE(source);
  constexpr std::size_t huge = std::numeric_limits<std::size_t>::max();
  std::vector<std::complex<float>> samples(4);
  for (const ImageWindow& window :
       {ImageWindow{3, 2, 0, 2}, ImageWindow{0, 2, 2, 2}, ImageWindow{0, 2, 0, 2, 4, 1},
        ImageWindow{0, 2, 0, 2, 1, huge}, ImageWindow{huge, 2, 0, 2}, ImageWindow{0, 2, 0, 2, 0, 1}})
    EXPECT_THROW(source->read_window(window, samples), std::out_of_range);
  EXPECT_THROW(source->read_window({0, 1, 0, 2}, samples), std::invalid_argument);
  std::vector<Rgb> colours(4);
  EXPECT_THROW(source->read_rgb({0, 2, 0, 2}, colours), std::logic_error);
  source->read_window({2, 0, 1, 0}, {});
}

TEST_P(ImageOfFormat, CutWhileOpenGivesAMessageWithItsName) {
  if (GetParam().format == FileFormat::hdf5) GTEST_SKIP() << "the HDF5 library's own business";
  const TestFolder folder;
  const fs::path path = folder / GetParam().name;
  data_test::write_test_file(path, test_product(3000, 40, 8), {GetParam().format, false, GetParam().counts, false});
  const auto source = open_whole(path, sample_hints(GetParam().format == FileFormat::binary ? 40 : 0, 8));
  ASSERT_TRUE(source);
  fs::resize_file(path, fs::file_size(path) / 2);
  try {
    read(*source, {2990, 2, 0, 40});
    FAIL() << "read rows that are not there";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(path.string()));
  }
  EXPECT_EQ(read(*source, {0, 1, 0, 40}).size(), 40U);
}

INSTANTIATE_TEST_SUITE_P(Formats, ImageOfFormat,
                         testing::Values(FormatCase{"a.bin", FileFormat::binary, ImageFormat::binary, true},
                                         FormatCase{"a.asc", FileFormat::ascii, ImageFormat::ascii, true},
                                         FormatCase{"a.csv", FileFormat::csv, ImageFormat::csv, true},
                                         FormatCase{"a.brk", FileFormat::bracket, ImageFormat::bracket, true},
                                         FormatCase{"counts.npy", FileFormat::npy, ImageFormat::npy, true},
                                         FormatCase{"volts.npy", FileFormat::npy, ImageFormat::npy, false},
                                         FormatCase{"counts.h5", FileFormat::hdf5, ImageFormat::hdf5, true},
                                         FormatCase{"volts.h5", FileFormat::hdf5, ImageFormat::hdf5, false}),
                         [](const auto& tested) {
                           std::string name = tested.param.name;
                           name.replace(name.find('.'), 1, "_");
                           return name;
                         });

TEST(ImageSource, OfHdf5CarriesAxesAndAttributes) {
  const TestFolder folder;
  data_test::write_test_file(folder / "a.h5", test_product(4, 3, 8), {FileFormat::hdf5, false, false, false});
  const auto source = open_whole(folder / "a.h5");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().sample_rate_hz, 100e6);
  EXPECT_EQ(source->info().lsb_v, 2.5e-9);
  const auto axes = source->axes();
  ASSERT_TRUE(axes);
  EXPECT_EQ(axes->column_range_m[2], 1003.0);
}

TEST(ImageSource, BinaryOfEveryNumberOfBitsIsReadToTheNearestFloat) {
  const TestFolder folder;
  for (int bits = 1; bits <= 64; ++bits) {
    const auto product = test_product(3, 5, bits);
    data_test::write_test_file(folder / "a.bin", product, {FileFormat::binary, true, true, false});
    const auto source = open_whole(folder / "a.bin", sample_hints(5, bits));
    ASSERT_TRUE(source);
    const auto samples = read_all(*source);
    const auto counts = data_test::test_counts(15, bits);
    for (std::size_t i = 0; i < 15; ++i)
      ASSERT_EQ(samples[i],
                std::complex<float>(static_cast<float>(counts[2 * i]), static_cast<float>(counts[2 * i + 1])))
          << bits;
  }
}

TEST(ImageSource, SaysWhatAFileWithoutADescriptionNeeds) {
  const TestFolder folder;
  const auto refusal = [&](const fs::path& path) {
    const OpenedImage opened = ImageSource::open(path);
    EXPECT_FALSE(opened.source);
    EXPECT_TRUE(has_errors(opened.problems));
    return text_of(opened.problems);
  };
  EXPECT_THAT(refusal(put(folder / "a.bin", "1234")), HasSubstr("does not say its own shape"));
  EXPECT_THAT(refusal(put(folder / "a.xyz", std::string("\0\1\2\3", 4))), HasSubstr("describe it as a custom file"));
  EXPECT_THAT(refusal(put(folder / "b.xyz", "")), HasSubstr("empty"));
  EXPECT_THAT(refusal(folder / "none"), HasSubstr("cannot read the file"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("it is a folder"));
}

// --- NumPy arrays -----------------------------------------------------------------------------------------------

std::string npy(const std::string& type, const std::string& shape, const std::string& data, bool fortran = false) {
  std::string text =
      "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }\n";
  return std::string("\x93NUMPY\1\0", 8) + static_cast<char>(text.size()) + '\0' + text + data;
}

TEST(ImageSource, ReadsNumpyArraysOfEitherByteOrderAndOrder) {
  const TestFolder folder;
  const auto big =
      open_whole(put(folder / "a.npy", npy(">i2", "(2, 3)", std::string("\0\1\0\2\0\3\0\4\0\5\xff\xff", 12))));
  ASSERT_TRUE(big);
  EXPECT_EQ(big->info().value, ImageValue::real);
  EXPECT_EQ(read_all(*big), (std::vector<std::complex<float>>{1, 2, 3, 4, 5, -1}));
  const auto turned = open_whole(put(folder / "b.npy", npy("|u1", "(2, 3)", "\1\2\3\4\5\6", true)));
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->rows(), 2U);
  EXPECT_EQ(turned->columns(), 3U);
  EXPECT_EQ(read_all(*turned), (std::vector<std::complex<float>>{1, 3, 5, 2, 4, 6}));
  EXPECT_EQ(read(*turned, {1, 1, 0, 2, 1, 2}), (std::vector<std::complex<float>>{2, 6}));
  const auto row =
      open_whole(put(folder / "c.npy", npy("<i4", "(2, 2)", std::string("\1\0\0\0\2\0\0\0\3\0\0\0\4\0\0\0", 16))));
  ASSERT_TRUE(row);
  EXPECT_EQ(read_all(*row), (std::vector<std::complex<float>>{{1, 2}, {3, 4}}));
}

TEST(ImageSource, ReadsNumpyArraysOfColours) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.npy", npy("|u1", "(1, 3, 3)", "\1\2\3\4\5\6\377\376\375")));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().value, ImageValue::rgb);
  std::vector<Rgb> colours(2);
  source->read_rgb({0, 1, 0, 2, 1, 2}, colours);
  EXPECT_EQ(colours, (std::vector<Rgb>{{1, 2, 3}, {255, 254, 253}}));
  EXPECT_NEAR(read_all(*source)[1].real(), 0.299 * 4 + 0.587 * 5 + 0.114 * 6, 1e-5);
}

TEST(ImageSource, RefusesNumpyArraysThatAreNoImages) {
  const TestFolder folder;
  const auto refusal = [&](const std::string& bytes) {
    const OpenedImage opened = ImageSource::open(put(folder / "a.npy", bytes));
    EXPECT_FALSE(opened.source);
    return text_of(opened.problems);
  };
  EXPECT_THAT(refusal(npy("<U4", "(2, 3)", std::string(96, 'x'))), HasSubstr("not one of numbers"));
  EXPECT_THAT(refusal(npy("<f4", "(2, 3, 4)", std::string(96, 'x'))), HasSubstr("not one of an image"));
  EXPECT_THAT(refusal(npy("<f4", "(0, 3)", "")), HasSubstr("not one of an image"));
  EXPECT_THAT(refusal(npy("<f4", "(2, 9223372036854775807)", "1234")), HasSubstr("ends within the array"));
  EXPECT_THAT(refusal(npy("<f4", "(3, 1, 2)", std::string(24, 'x'), true)), HasSubstr("Fortran"));
  EXPECT_THAT(refusal("\x93NUMPY"), HasSubstr(""));
}

TEST(ImageSource, ShowsTheRowsOfANumpyArrayThatIsStillBeingWritten) {
  const TestFolder folder;
  const fs::path path = put(folder / "a.npy", npy("|u1", "(4, 3)", "\1\2\3\4\5\6\7"));
  const OpenedImage opened = ImageSource::open(path);
  ASSERT_TRUE(opened.source);
  EXPECT_THAT(text_of(opened.problems), HasSubstr("what is there is shown"));
  EXPECT_EQ(opened.source->rows(), 2U);
  std::ofstream(path, std::ios::binary | std::ios::app) << "\10\11\12\13\14 and more";
  EXPECT_EQ(opened.source->rows(), 2U);
  EXPECT_EQ(opened.source->refresh(), 4U);
  EXPECT_EQ(read(*opened.source, {3, 1, 1, 1})[0].real(), 11.0F);
}

// --- Growing files ----------------------------------------------------------------------------------------------

TEST(ImageSource, RefreshFindsWhatABinaryFileHasGrownAndLost) {
  const TestFolder folder;
  const fs::path path = put(folder / "a.bin", std::string(4 * 6, '\x80'));
  const auto source = open_whole(path, sample_hints(3, 8));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->rows(), 4U);
  std::ofstream(path, std::ios::binary | std::ios::app) << std::string(13, '\x81');
  EXPECT_EQ(source->refresh(), 6U);
  EXPECT_EQ(read(*source, {5, 1, 0, 1})[0], std::complex<float>(2, 2));
  fs::resize_file(path, 11);
  EXPECT_EQ(source->refresh(), 1U);
  EXPECT_THROW(read(*source, {1, 1, 0, 1}), std::out_of_range);
}

TEST(ImageSource, RefreshFindsNewRowsOfATextAndCompletesTheLast) {
  const TestFolder folder;
  const fs::path path = put(folder / "a.csv", "1,2,3,4\n5,6,7,8\n9,10");
  const auto source = open_whole(path);
  ASSERT_TRUE(source);
  EXPECT_EQ(source->rows(), 2U);
  EXPECT_TRUE(source->problems().empty());
  std::ofstream(path, std::ios::app) << ",11,12\n13,14,15,1";
  source->refresh();
  source->wait_until_indexed(nullptr);
  ASSERT_EQ(source->rows(), 4U);
  EXPECT_EQ(read(*source, {2, 1, 0, 2}), (std::vector<std::complex<float>>{{9, 10}, {11, 12}}));
  std::ofstream(path, std::ios::app) << "6\n17,18,19,20\n";
  source->refresh();
  source->wait_until_indexed(nullptr);
  ASSERT_EQ(source->rows(), 5U);
  EXPECT_EQ(read(*source, {3, 2, 1, 1}), (std::vector<std::complex<float>>{{15, 16}, {19, 20}}));
}

// --- Texts ------------------------------------------------------------------------------------------------------

TEST(ImageSource, TextsAreReadAnywhereFromRememberedRows) {
  const TestFolder folder;
  constexpr std::size_t rows = 9000;
  std::string text;
  for (std::size_t row = 0; row < rows; ++row)
    text += "(" + std::to_string(row) + ",-1) (" + std::to_string(2 * row) + ",0.5) (7,8)\n";
  const auto source = open_whole(put(folder / "a.brk", text));
  ASSERT_TRUE(source);
  ASSERT_EQ(source->rows(), rows);
  const ImageWindow window{1, 3000, 0, 2, 3, 1};
  const auto samples = read(*source, window, 2);
  for (std::size_t i = 0; i < window.rows; ++i) {
    ASSERT_EQ(samples[2 * i], std::complex<float>(static_cast<float>(window.row(i)), -1.0F));
    ASSERT_EQ(samples[2 * i + 1], std::complex<float>(static_cast<float>(2 * window.row(i)), 0.5F));
  }
  EXPECT_EQ(read(*source, {rows - 1, 1, 0, 3})[0].real(), static_cast<float>(rows - 1));
  EXPECT_EQ(read(*source, {0, 1, 0, 3})[0].real(), 0.0F);
}

TEST(ImageSource, RowsOfATextThatAreUnevenAreShownWithAWarning) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.csv", "1,2,3,4\n5,6\n1,2,3,4,5,6\n7,8,9,10\n"));
  ASSERT_TRUE(source);
  ASSERT_EQ(source->rows(), 4U);
  EXPECT_EQ(read_all(*source),
            (std::vector<std::complex<float>>{{1, 2}, {3, 4}, {5, 6}, {0, 0}, {1, 2}, {3, 4}, {7, 8}, {9, 10}}));
  EXPECT_EQ(source->problems().size(), 2U);
  EXPECT_THAT(text_of(source->problems()), HasSubstr("a.csv:2"));
  EXPECT_FALSE(has_errors(source->problems()));
}

TEST(ImageSource, TextIsShownUpToTheFirstPlaceThatIsMalformed) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.csv", "1,2\n3,4\nfive,6\n7,8\n"));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->rows(), 2U);
  EXPECT_THAT(text_of(source->problems()), testing::AllOf(HasSubstr("a.csv:3:1"), HasSubstr("five")));
}

TEST(ImageSource, CsvOfSingleNumbersIsReal) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.csv", "x,y,z\n1,2,3\n4,5,6.5\n"));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().value, ImageValue::real);
  EXPECT_EQ(read_all(*source), (std::vector<std::complex<float>>{1, 2, 3, 4, 5, 6.5F}));
}

TEST(ImageSource, AsciiIsCutIntoRowsByCountingWhereTheSamplesAreGiven) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.asc", "1 2\n3 4\n5 6\n7 8\n9 10\n"), sample_hints(2, 8));
  ASSERT_TRUE(source);
  ASSERT_EQ(source->rows(), 2U);
  EXPECT_EQ(read(*source, {1, 1, 0, 2}), (std::vector<std::complex<float>>{{5, 6}, {7, 8}}));
}

TEST(ImageSource, MayBeReadFromManyThreadsWhileATextIsLookedThrough) {
  const TestFolder folder;
  std::string text;
  for (int row = 0; row < 60000; ++row) text += std::to_string(row) + ",1,2," + std::to_string(row) + "\n";
  const OpenedImage opened = ImageSource::open(put(folder / "a.csv", text));
  ASSERT_TRUE(opened.source);
  std::atomic<int> wrong{0};
  {
    std::vector<std::jthread> readers;
    for (unsigned seed = 0; seed < 3; ++seed)
      readers.emplace_back([&, seed] {
        std::mt19937 random(seed);
        for (int i = 0; i < 300; ++i) {
          const std::size_t known = opened.source->rows();
          if (known == 0) continue;
          const std::size_t row = random() % known;
          const auto samples = read(*opened.source, {row, 1, 0, 2});
          if (samples[1] != std::complex<float>(2.0F, static_cast<float>(row))) ++wrong;
          (void)opened.source->indexed();
        }
      });
  }
  EXPECT_EQ(wrong, 0);
  opened.source->wait_until_indexed(nullptr);
  EXPECT_EQ(opened.source->rows(), 60000U);
}

TEST(ImageSource, EndsAtOnceWhileATextIsStillLookedThrough) {
  const TestFolder folder;
  std::string text;
  for (int row = 0; row < 400000; ++row) text += "10,20,30,40,50,60,70,80\n";
  const fs::path path = put(folder / "a.csv", text);
  const auto begin = std::chrono::steady_clock::now();
  { const OpenedImage opened = ImageSource::open(path); }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(500));
  StopFlag stop;
  stop.request();
  const OpenedImage opened = ImageSource::open(path);
  ASSERT_TRUE(opened.source);
  EXPECT_THROW(opened.source->wait_until_indexed(&stop), Interrupted);
}

TEST(ImageSource, LongRowsAreReadInPiecesAndFarSamplesOneByOne) {
  const TestFolder folder;
  constexpr std::size_t columns = 700'001;
  std::string bytes(3 * columns, '\0');
  std::mt19937 random(2);
  for (char& byte : bytes) byte = static_cast<char>(random());
  RawLayout layout;
  layout.width = columns;
  layout.value = ImageValue::real;
  layout.number = RawNumber::int8;
  ImageHints hints;
  hints.raw = layout;
  const auto source = open_whole(put(folder / "a.raw", bytes), hints);
  ASSERT_TRUE(source);
  for (const ImageWindow& window : {ImageWindow{1, 2, 1, columns - 1}, ImageWindow{0, 2, 2, columns / 3, 2, 3},
                                    ImageWindow{0, 3, 7, 140, 1, 4999}, ImageWindow{2, 1, 0, 2, 1, columns - 1}}) {
    const auto samples = read(*source, window, 2);
    for (std::size_t i = 0; i < window.rows; ++i)
      for (std::size_t k = 0; k < window.cols; ++k)
        ASSERT_EQ(samples[i * window.cols + k].real(),
                  static_cast<float>(static_cast<signed char>(bytes[window.row(i) * columns + window.column(k)])))
            << i << ", " << k << ", " << window.col_step;
  }
}

// --- Drafts and stopping ----------------------------------------------------------------------------------------

TEST(ImageSource, DraftIsCoarserWhereTheTimeIsShortAndStandsForItsNeighbours) {
  const TestFolder folder;
  std::string bytes;
  for (int i = 0; i < 64 * 64; ++i) bytes += static_cast<char>(i % 64 + i / 64);
  RawLayout layout;
  layout.width = 64;
  layout.value = ImageValue::real;
  ImageHints hints;
  hints.raw = layout;
  const auto source = open_whole(put(folder / "a.raw", bytes), hints);
  ASSERT_TRUE(source);
  const ImageWindow window{3, 61, 1, 60};
  std::vector<std::complex<float>> exact(window.samples());
  EXPECT_EQ(source->read_draft(window, 1.0, exact), window);
  EXPECT_EQ(exact, read(*source, window));
  std::vector<std::complex<float>> draft(window.samples());
  const ImageWindow coarse = source->read_draft(window, source->read_cost_s(window) / 20.0, draft);
  EXPECT_LE(source->read_cost_s(coarse), source->read_cost_s(window) / 20.0);
  ASSERT_GT(coarse.row_step * coarse.col_step, 1U);
  for (std::size_t i = 0; i < window.rows; ++i)
    for (std::size_t k = 0; k < window.cols; ++k) {
      const std::size_t row = i / coarse.row_step * coarse.row_step;
      const std::size_t column = k / coarse.col_step * coarse.col_step;
      ASSERT_EQ(draft[i * window.cols + k], exact[row * window.cols + column]);
    }
}

TEST(ImageSource, ReadingStopsWhereItIsAskedTo) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.bin", std::string(600, '\x80')), sample_hints(3, 8));
  ASSERT_TRUE(source);
  StopFlag stop;
  stop.request();
  std::vector<std::complex<float>> samples(300);
  EXPECT_THROW(source->read_window({0, 100, 0, 3}, samples, {1, &stop}), Interrupted);
}

// --- Hints from a scene -----------------------------------------------------------------------------------------

Scene recording_scene() {
  Scene scene;
  scene.platforms.emplace_back();
  scene.radars.emplace_back();
  Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_end_m = 299.792458;
  simulation.time_end_s = 0.0095;
  simulation.sample_rate_hz = 50e6;
  simulation.bits = 10;
  simulation.lsb_v = 1e-6;
  simulation.file = "C:\\OUT\\Echo.BIN";
  simulation.format = FileFormat::binary;
  scene.simulations.push_back(simulation);
  return scene;
}

TEST(HintsFromScene, AreTheShapeAndDepthOfTheSimulationThatWroteTheFile) {
  const auto hints = hints_from_scene(recording_scene(), "/data/echo.bin");
  ASSERT_TRUE(hints);
  EXPECT_EQ(hints->columns, 100U);
  EXPECT_EQ(hints->rows, 10U);
  EXPECT_EQ(hints->bits, 10);
  EXPECT_EQ(hints->lsb_v, 1e-6);
  EXPECT_EQ(hints->format, FileFormat::binary);
  const auto other = hints_from_scene(recording_scene(), "echo.csv");
  ASSERT_TRUE(other);
  EXPECT_FALSE(other->format);
  EXPECT_FALSE(hints_from_scene(recording_scene(), "other.bin"));
}

TEST(HintsFromScene, AreNotToBeHadOfWindowsThatNoMemoryHolds) {
  Scene scene = recording_scene();
  scene.simulations[0].range_end_m = 1e12;
  EXPECT_FALSE(hints_from_scene(scene, "echo.bin"));
}

TEST(HintsFromScene, AreNotToBeHadOfARadarWithMistakes) {
  Scene scene = recording_scene();
  scene.radars[0].prf_hz = 0.0;
  EXPECT_FALSE(hints_from_scene(scene, "echo.bin"));
}

TEST(HintsFromScene, AskNothingOfTargets) {
  Scene scene = recording_scene();
  scene.targets.emplace_back().platform = "Nowhere";
  const auto hints = hints_from_scene(scene, "echo.bin");
  ASSERT_TRUE(hints);
  EXPECT_EQ(hints->columns, 100U);
}

// --- Files much larger than memory ------------------------------------------------------------------------------

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  statm >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

// A file of 40 GB that takes hardly any place on the disk, with some samples that are not zero.
class HugeFile : public testing::Test {
 protected:
  static constexpr std::uint64_t bytes = std::uint64_t{40} << 30;

  bool make(const std::string& begin, std::uint64_t mark_at, const std::string& mark) {
    path_ = folder_ / "huge";
    const int file = ::open(path_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    if (file < 0) return false;
    const bool made =
        ::ftruncate(file, static_cast<off_t>(bytes)) == 0 &&
        ::pwrite(file, begin.data(), begin.size(), 0) == static_cast<ssize_t>(begin.size()) &&
        ::pwrite(file, mark.data(), mark.size(), static_cast<off_t>(mark_at)) == static_cast<ssize_t>(mark.size());
    ::close(file);
    return made;
  }

  // Opens the file and reads windows of 1600 x 1000 at random places and spacings; seconds of a window on average.
  double window_seconds(const ImageSource& source) {
    std::mt19937_64 random(7);
    std::vector<std::complex<float>> samples(1600 * 1000);
    constexpr int windows = 12;
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < windows; ++i) {
      ImageWindow window{0, 1000, 0, 1600};
      window.row_step = 1 + random() % (source.rows() / 1001);
      window.col_step = 1 + random() % (source.columns() / 1601);
      window.row0 = random() % (source.rows() - 999 * window.row_step);
      window.col0 = random() % (source.columns() - 1599 * window.col_step);
      source.read_draft(window, 0.02, samples, {2, nullptr});
    }
    return seconds_since(begin) / windows;
  }

  TestFolder folder_;
  fs::path path_;
};

TEST_F(HugeFile, OfBinaryOpensAtOnceAndIsReadAnywhereWithLittleMemory) {
  constexpr std::size_t columns = 4096;
  const std::uint64_t row = 2 * columns;
  if (!make("", 3'000'000 * row + 2 * 1234, "\x85\x86")) GTEST_SKIP() << "the disk does not take files with holes";
  const double before = resident_mb();
  const auto begin = std::chrono::steady_clock::now();
  const OpenedImage opened = ImageSource::open(path_, [&] {
    ImageHints hints = sample_hints(columns, 8);
    hints.samples.format = FileFormat::binary;
    return hints;
  }());
  ASSERT_TRUE(opened.source) << text_of(opened.problems);
  EXPECT_LT(seconds_since(begin), 1.0);
  EXPECT_EQ(opened.source->rows(), bytes / row);
  EXPECT_EQ(read(*opened.source, {2'999'999, 3, 1234, 1})[1], std::complex<float>(6, 7));
  const double average = window_seconds(*opened.source);
  RecordProperty("milliseconds_of_a_window", std::to_string(1e3 * average));
  EXPECT_LT(average, 0.2);  // 33 ms where nothing else runs: docs/formats/images.md.
  EXPECT_LT(resident_mb() - before, 300.0);
}

TEST_F(HugeFile, OfNumpyOpensAtOnceAndIsReadAnywhereWithLittleMemory) {
  constexpr std::size_t columns = 50'000;
  constexpr std::size_t rows = 107'000;
  const std::string header = npy_header_text("<c8", std::array<std::size_t, 2>{rows, columns});
  const float value = 2.5F;
  const std::string mark(reinterpret_cast<const char*>(&value), 4);
  if (!make(header, header.size() + 8 * (columns * 99'999ULL + 49'999), mark))
    GTEST_SKIP() << "the disk does not take files with holes";
  const double before = resident_mb();
  const auto begin = std::chrono::steady_clock::now();
  const OpenedImage opened = ImageSource::open(path_);
  ASSERT_TRUE(opened.source) << text_of(opened.problems);
  EXPECT_LT(seconds_since(begin), 1.0);
  EXPECT_EQ(opened.source->rows(), rows);
  EXPECT_EQ(read(*opened.source, {99'990, 10, 49'990, 10})[99], std::complex<float>(2.5F, 0.0F));
  const double average = window_seconds(*opened.source);
  RecordProperty("milliseconds_of_a_window", std::to_string(1e3 * average));
  EXPECT_LT(average, 0.2);
  EXPECT_LT(resident_mb() - before, 300.0);
}

}  // namespace
}  // namespace sarsim

// What a file says twice, or a caller says of it, is compared (docs/formats/samples.md).

#include <gmock/gmock.h>

#include <fmt/format.h>

#include "raster/format/data_test_support.hpp"
#include "raster/table/image_gate.hpp"
#include "raster/table/product_attributes.hpp"

namespace sarsim::raster::contradictions_test {

using namespace data_test;
using testing::HasSubstr;

// What a caller says of a file that says it itself is compared with that.
TEST(RasterGate, HintsThatContradictTheFileAreTold) {
  const TestFolder folder;
  for (const auto& [name, format] :
       {std::pair("a.npy", scene::FileFormat::npy), std::pair("a.h5", scene::FileFormat::hdf5),
        std::pair("a.zarr", scene::FileFormat::zarr), std::pair("a.sigmf-meta", scene::FileFormat::sigmf)}) {
    write_test_file(folder / name, test_product(4, 3, 8), {.format = format, .counts = true});
    RasterHints hints;
    hints.columns = 3;
    EXPECT_TRUE(open_raster(Integrity::whole, folder / name, hints).raster) << name;
    hints.columns = 5;
    const auto refused = open_raster(Integrity::whole, folder / name, hints);
    EXPECT_FALSE(refused.raster) << name;
    EXPECT_THAT(text_of(refused.problems), HasSubstr("another number of columns; found '3'")) << name;
    hints = {};
    hints.lsb_v = 1.0;
    hints.bits = 12;
    const std::string told = text_of(open_raster(Integrity::whole, folder / name, hints).problems);
    const bool bare = format == scene::FileFormat::npy;
    EXPECT_EQ(told.find("warning: the LSB of the file") == std::string::npos, bare) << name << told;
    EXPECT_EQ(told.find("warning: the number of A/D bits") == std::string::npos, bare) << name << told;
    hints.lsb_v = 2.5e-9;
    hints.bits = 8;
    EXPECT_EQ(text_of(open_raster(Integrity::whole, folder / name, hints).problems), "") << name;
  }
}

// What a later version writes may mean something else; HDF5 has a test of its own.
TEST(RasterGate, LaterVersionsOfTheLayoutAreRefused) {
  const TestFolder folder;
  const auto problems = [&](const char* name, const char* attributes, const std::string& version) {
    std::string text = contents(folder / attributes);
    const std::string key = "format_version\": ";
    const std::size_t at = text.find(key);
    if (at == std::string::npos) return "no version in " + text;
    put(folder / attributes, text.replace(at + key.size(), text.find(',', at) - at - key.size(), version));
    return text_of(open_raster(Integrity::whole, folder / name).problems);
  };
  write_test_file(folder / "a.zarr", test_product(4, 3, 8), {.format = scene::FileFormat::zarr});
  fs::remove(folder / "a.zarr/.zmetadata");
  write_test_file(folder / "a.sigmf-meta", test_product(4, 3, 8), {.format = scene::FileFormat::sigmf});
  for (const auto& [name, attributes] :
       {std::pair("a.zarr", "a.zarr/.zattrs"), std::pair("a.sigmf-meta", "a.sigmf-meta")}) {
    EXPECT_EQ(problems(name, attributes, "1"), "");
    EXPECT_THAT(problems(name, attributes, "2"),
                HasSubstr("error: format_version of the file is not known; found '2', expected 1"));
    EXPECT_THAT(problems(name, attributes, "true"), HasSubstr("a newer version of sarsim wrote it")) << name;
  }
}

// Columns of CSV are I and Q in turn.
TEST(CsvHeadings, NamesOfOtherColumnsAreRefused) {
  const TestFolder folder;
  const auto problems = [&](const std::string& heading) {
    put(folder / "a.csv", heading + "\n1,2,3,4\n5,6,7,8\n");
    return text_of(open_raster(Integrity::whole, folder / "a.csv").problems);
  };
  for (const char* const sound :
       {"I0,Q0,I1,Q1", "i,q,i,q", "re1,im1,re2,im2", "I (V),Q (V),I (V),Q (V)", "I,Q", "I_0,Q_0,I_1,Q_1",
        "\"I [0]\",\"Q [0]\",\"I [1]\",\"Q [1]\"", "I4_mV,Q4_mV,I5_mV,Q5_mV", "I [count],Q [count],I [count],Q [count]",
        "# of Monday, noon", "#I,Q,I,Q"})
    EXPECT_EQ(problems(sound).find("error"), std::string::npos) << sound << problems(sound);
  EXPECT_THAT(problems("Q0,I0,Q1,I1"),
              HasSubstr("not those of I and Q in turn; found 'Q0 above column 1', expected I"));
  EXPECT_THAT(problems("I0,I1,Q0,Q1"), HasSubstr("found 'I1 above column 2', expected Q"));
  EXPECT_THAT(problems("Imag,Real,Imag,Real"), HasSubstr("expected I"));
  for (const auto& [heading, says] : std::initializer_list<std::pair<const char*, const char*>>{
           {"a,b,c,d", "found 'a above column 1', expected I"},
           {"mag,phase,mag,phase", "found 'mag above column 1', expected I"},
           {"# amplitude,phase [deg],amplitude,phase [deg]", "amplitudes and phases have to be converted"},
           {"I1,Q1,I0,Q0", "number the samples in another order; found 'I0 above column 3', expected 2"},
           {"I0,Q1,I1,Q2", "found 'Q1 above column 2', expected 0"},
           {"I0,Q0,I,Q", "number some of the samples only"},
           {"I [W],Q [W],I [W],Q [W]", "the unit of the samples is not known"},
           {"I [V],Q [mV],I [V],Q [mV]", "the columns have different units"},
           {"I,Q,I", "found '3 names', expected 4, one for each number"},
           {"NA,NA,NA,NA", "text that is not a sample; found 'NA'"},
           {"\"1\",\"2\",\"3\",\"4\"", "text that is not a sample"}})
    EXPECT_THAT(problems(heading), HasSubstr(says)) << heading;
}

// A first row that is missing is no line of names: no pulse gets lost, of pictures neither.
TEST(CsvHeadings, AreJudgedInPicturesToo) {
  const TestFolder folder;
  const auto problems = [&](const std::string& heading, const char* rows) {
    return text_of(open_raster(Integrity::partial, put(folder / "a.csv", heading + rows)).problems);
  };
  EXPECT_THAT(problems("mag,phase", "\n1,2\n"), HasSubstr("not those of I and Q in turn"));
  EXPECT_THAT(problems("t,I,Q", "\n1,2,3\n"), HasSubstr("found 't above column 1', expected I"));
  EXPECT_THAT(problems("NA,NA,NA", "\n1,2,3\n"), HasSubstr("found 'NA'"));
  EXPECT_EQ(problems("height,slope,shadow", "\n1,2,3\n").find("error"), std::string::npos);
}

TEST(CsvHeadings, UnitsAreFollowed) {
  const TestFolder folder;
  for (const Integrity integrity : {Integrity::whole, Integrity::partial}) {
    const fs::path path = put(folder / "a.csv", "I [mV],Q [mV]\n1500,-250\n");
    const OpenedRaster opened = open_raster(integrity, path);
    ASSERT_TRUE(opened.raster) << text_of(opened.problems);
    EXPECT_EQ(text_of(opened.problems), "");  // No offset of a converter to be feared.
    EXPECT_FALSE(opened.raster->info().counts);
    opened.raster->wait_until_indexed(nullptr);
    EXPECT_EQ(read_all_rows(*opened.raster), (std::vector<std::complex<double>>{{1.5, -0.25}}));
    EXPECT_THAT(text_of(open_raster(integrity, path, {.bits = 8}).problems),
                HasSubstr("the line of names says that the numbers are voltages"));
  }
}

// Places of an image are said twice.
TEST(ImageGate, WhatTheFieldsOfAnImageSayIsJudged) {
  RasterInfo info;
  const FileAttributes sound{{"image_plane", "slant range"},
                             {"azimuth_first_m", "-1"},
                             {"azimuth_step_m", "0.5"},
                             {"range_first_m", "900"},
                             {"range_step_m", "2"},
                             {"carrier_hz", "1e9"},
                             {"light_speed_mps", "299792458"},
                             {"speed_mps", "90"},
                             {"origin_m", "1, 2, 3"},
                             {"along", "0, 1, 0"}};
  RasterAxes axes;
  axes.row_axis = "azimuth_m";
  axes.row_m = {-1.0, -0.5, 0.0};
  axes.column_range_m = {900.0, 902.0};
  const auto problems = [&] { return text_of(problems_of_image(info, &axes, "a.h5")); };
  EXPECT_EQ(problems(), "");  // No image.
  info.attributes = sound;
  EXPECT_EQ(problems(), "");
  const std::pair<const char*, const char*> others[] = {
      {"image_plane", "moon"}, {"azimuth_step_m", "0"},     {"range_step_m", "nan"},  {"carrier_hz", "-1"},
      {"origin_m", "1, 2"},    {"origin_m", "nan, nan, 0"}, {"light_speed_mps", "0"}, {"light_speed_mps", "3e8"},
      {"speed_mps", "0"},      {"speed_mps", "-5"},         {"along", "0, 0, 0"},     {"along", "0 1 0"},
      {"range_first_m", "far"}};
  for (const auto& [name, value] : others) {
    info.attributes = sound;
    std::ranges::find(info.attributes, name, &std::pair<std::string, std::string>::first)->second = value;
    EXPECT_THAT(problems(), HasSubstr(fmt::format("error: {} of the image cannot be", name))) << value;
  }
  info.attributes = sound;
  axes.row_m[1] = 4.5;
  EXPECT_THAT(problems(), HasSubstr("warning: the axis azimuth_m contradicts azimuth_first_m and azimuth_step_m"));
  EXPECT_THAT(problems(), HasSubstr("4.5 m at position 1"));
}

}  // namespace sarsim::raster::contradictions_test

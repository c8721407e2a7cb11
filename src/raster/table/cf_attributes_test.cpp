#include "raster/table/cf_attributes.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::raster::cf_attributes_test {

using testing::HasSubstr;

std::string samples_problem(const FileAttributes& attributes, bool integers = false) {
  const auto meaning = meaning_of_samples(attributes, "/samples", integers);
  const auto* const problem = std::get_if<core::Problem>(&meaning);
  return problem == nullptr ? "" : core::to_string(*problem);
}

SampleMeaning samples(const FileAttributes& attributes, bool integers = false) {
  EXPECT_EQ(samples_problem(attributes, integers), "");
  return std::get<SampleMeaning>(meaning_of_samples(attributes, "/samples", integers));
}

TEST(CfAttributes, PlainOnesChangeNothing) {
  EXPECT_TRUE(samples({}).rule.is_plain());
  EXPECT_TRUE(samples({{"units", "V"}, {"unit", "V"}, {"long_name", "complex envelope"}}).rule.is_plain());
  EXPECT_TRUE(samples({{"scale_factor", "1"}, {"add_offset", "0"}, {"_FillValue", "nan"}}).rule.is_plain());
  EXPECT_TRUE(samples({{"units", "count"}}, true).counts);
  EXPECT_TRUE(samples({}, true).counts);
  EXPECT_FALSE(samples({{"units", "V"}}, true).counts);
}

TEST(CfAttributes, ScaleUnitAndMissingValuesAreFollowed) {
  const SampleMeaning scaled = samples({{"units", "mV"}, {"scale_factor", "0.5"}}, true);
  EXPECT_FALSE(scaled.counts);
  EXPECT_EQ(scaled.rule.scale, 0.5e-3);
  const SampleMeaning ranged =
      samples({{"valid_range", "-10, 10"}, {"_FillValue", "-9999"}, {"missing_value", "7, 8"}});
  std::vector<std::complex<double>> values{{1.0, 2.0}, {11.0, 0.0}, {0.0, -9999.0}, {8.0, 0.0}, {-10.0, 10.0}};
  ranged.rule.apply(std::span(values));
  EXPECT_EQ(values[0], std::complex<double>(1.0, 2.0));
  EXPECT_TRUE(std::isnan(values[1].real()));
  EXPECT_TRUE(std::isnan(values[2].imag()));
  EXPECT_TRUE(std::isnan(values[3].real()));
  EXPECT_EQ(values[4], std::complex<double>(-10.0, 10.0));
}

TEST(CfAttributes, WhatCannotBeFollowedIsRefusedByName) {
  const std::pair<std::string, std::string> keys[] = {
      {"add_offset", "3"},     {"scale_factor", "0"}, {"scale_factor", "twice"}, {"scale_factor", "inf"},
      {"units", "dB"},         {"units", "W"},        {"_FillValue", "none"},    {"valid_range", "1"},
      {"valid_range", "3, 1"}, {"valid_min", "low"},  {"units", "count"},        {"missing_value", "1,,2"}};
  for (const auto& [key, value] : keys)
    EXPECT_THAT(samples_problem({{key, value}}), HasSubstr("its attribute " + key + " cannot be followed"))
        << key << " " << value;
  EXPECT_THAT(samples_problem({{"units", "count"}, {"scale_factor", "2"}}, true), HasSubstr("scale_factor"));
  EXPECT_THAT(samples_problem({{"units", "V"}, {"unit", "mV"}}), HasSubstr("units"));
}

TEST(CfAttributes, DimensionsInTheWrongOrderAreRefused) {
  EXPECT_FALSE(problem_of_dimensions({}, "/samples"));
  EXPECT_FALSE(problem_of_dimensions({"pulse_time_s", "slant_range_m"}, "/samples"));
  EXPECT_FALSE(problem_of_dimensions({"pulse", "sample", "iq"}, "/samples"));
  EXPECT_TRUE(problem_of_dimensions({"slant_range_m", "pulse_time_s"}, "/samples"));
  EXPECT_TRUE(problem_of_dimensions({"", "pulse_time_s"}, "/samples"));
}

TEST(CfAttributes, AxesAreConvertedOrRefused) {
  const auto axis = [](const char* unit, const char* of) { return meaning_of_axis({{"units", unit}}, "/axis", of); };
  const std::tuple<const char*, const char*, double> known[] = {
      {"km", "m", 1e3},         {"us", "s", 1e-6},     {"GHz", "Hz", 1e9},   {"deg", "rad", core::pi / 180.0},
      {"km s-1", "m s-1", 1e3}, {"seconds", "s", 1.0}, {"m/s", "m s-1", 1.0}};
  for (const auto& [unit, of, factor] : known) {
    const auto meaning = axis(unit, of);
    ASSERT_TRUE(std::holds_alternative<AxisMeaning>(meaning)) << unit;
    EXPECT_EQ(std::get<AxisMeaning>(meaning).factor, factor) << unit;
  }
  const std::pair<const char*, const char*> refused[] = {
      {"km", "s"}, {"furlong", "m"}, {"seconds since 2020-01-01", "s"}, {"s", "m"}};
  for (const auto& [unit, of] : refused) EXPECT_TRUE(std::holds_alternative<core::Problem>(axis(unit, of))) << unit;
  const auto scaled = meaning_of_axis({{"scale_factor", "2"}, {"add_offset", "1"}, {"units", "km"}}, "/axis", "m");
  EXPECT_EQ(std::get<AxisMeaning>(scaled).factor, 2e3);
  EXPECT_EQ(std::get<AxisMeaning>(scaled).offset, 1e3);
}

}  // namespace sarsim::raster::cf_attributes_test

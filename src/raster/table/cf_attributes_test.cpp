#include "raster/table/cf_attributes.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "raster/table/product_attributes.hpp"

namespace sarsim::raster::cf_attributes_test {

using testing::HasSubstr;

std::string samples_problem(const FileAttributes& attributes, bool integers = false) {
  const auto meaning = meaning_of_samples({attributes}, "/samples", {integers});
  const auto* const problem = std::get_if<core::Problem>(&meaning);
  return problem == nullptr ? "" : core::to_string(*problem);
}

SampleMeaning samples(const FileAttributes& attributes, bool integers = false) {
  EXPECT_EQ(samples_problem(attributes, integers), "");
  return std::get<SampleMeaning>(meaning_of_samples({attributes}, "/samples", {integers}));
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
  const auto axis = [](const char* unit, const char* of) {
    return meaning_of_axis({{{"units", unit}}}, "/axis", of, {});
  };
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
  const auto scaled =
      meaning_of_axis({{{"scale_factor", "2"}, {"add_offset", "1"}, {"units", "km"}}}, "/axis", "m", {});
  EXPECT_EQ(std::get<AxisMeaning>(scaled).factor, 2e3);
  EXPECT_EQ(std::get<AxisMeaning>(scaled).offset, 1e3);
}

// What a reader could not read is there all the same.
TEST(CfAttributes, UnreadableOnesAreRefusedByName) {
  for (const char* const key : {"units", "unit", "scale_factor", "add_offset", "_FillValue", "missing_value",
                                "valid_range", "valid_min", "valid_max", "_Unsigned"}) {
    const ArrayAttributes attributes{.unreadable = {{key, "a structure"}}};
    const auto of_samples = meaning_of_samples(attributes, "/samples", {});
    const auto of_axis = meaning_of_axis(attributes, "/axis", "m", {});
    for (const auto* const problem : {std::get_if<core::Problem>(&of_samples), std::get_if<core::Problem>(&of_axis)}) {
      ASSERT_NE(problem, nullptr) << key;
      EXPECT_THAT(core::to_string(*problem), HasSubstr(std::string("its attribute ") + key + " cannot be followed"));
      EXPECT_EQ(problem->found, "a structure");
    }
  }
  const auto others = meaning_of_samples({.unreadable = {{"history", "3 texts"}}}, "/samples", {});
  EXPECT_TRUE(std::holds_alternative<SampleMeaning>(others));
  const auto cut_off = meaning_of_samples({.complete = false}, "/samples", {});
  EXPECT_TRUE(std::holds_alternative<core::Problem>(cut_off));
}

// docs/formats/samples.md: whole numbers with a scale are volts, one of 1 too.
TEST(CfAttributes, AScaleOfOneMakesVoltsOfWholeNumbers) {
  EXPECT_FALSE(samples({{"scale_factor", "1"}}, true).counts);
  EXPECT_TRUE(samples({{"scale_factor", "1"}}, true).rule.is_plain());
  EXPECT_TRUE(samples({{"scale_factor", "1"}, {"units", "count"}}, true).counts);
}

TEST(CfAttributes, AScaleThatLeavesNothingIsRefused) {
  for (const char* const scale : {"1e-300", "1e300", "-1e-38"}) {
    EXPECT_THAT(samples_problem({{"scale_factor", scale}}), HasSubstr("scale_factor")) << scale;
    const auto axis = meaning_of_axis({{{"scale_factor", scale}}}, "/axis", "m", {});
    EXPECT_TRUE(std::holds_alternative<core::Problem>(axis)) << scale;
  }
  EXPECT_EQ(samples({{"scale_factor", "-1e-36"}}).rule.scale, -1e-36);
}

TEST(CfAttributes, AnotherSignThanThatOfTheTypeIsRefused) {
  const auto refused = [](const char* word, bool has_sign) {
    const ArrayAttributes attributes{{{"_Unsigned", word}}};
    return std::holds_alternative<core::Problem>(meaning_of_samples(attributes, "/samples", {true, has_sign})) &&
           std::holds_alternative<core::Problem>(meaning_of_axis(attributes, "/axis", "m", {true, has_sign}));
  };
  EXPECT_TRUE(refused("true", true));
  EXPECT_TRUE(refused("false", false));
  EXPECT_FALSE(refused("True", false));
  EXPECT_FALSE(refused("false", true));
}

// xarray writes _FillValue = NaN at every axis: only a number that is it counts.
TEST(CfAttributes, PlacesThatStandForNoneAreFound) {
  const auto found = [](const FileAttributes& attributes, const std::vector<double>& values) {
    const auto meaning = meaning_of_axis({attributes}, "/axis", "m", {});
    const auto problem = problem_of_missing(std::get<AxisMeaning>(meaning), "/axis", values, 100);
    return problem ? problem->found : "";
  };
  EXPECT_EQ(found({{"_FillValue", "-9999"}}, {1.0, -9999.0}), "-9999 at position 101");
  EXPECT_EQ(found({{"missing_value", "0, 7"}}, {1.0, 2.0, 7.0}), "7 at position 102");
  EXPECT_EQ(found({{"valid_range", "1, 3"}}, {0.5}), "0.5 at position 100");
  EXPECT_EQ(found({{"valid_max", "3"}, {"scale_factor", "2"}}, {3.0, 4.0}), "4 at position 101");
  EXPECT_EQ(found({{"_FillValue", "-9999.1"}}, {static_cast<double>(-9999.1F)}), "-9999.1 at position 100");
  EXPECT_EQ(found({{"_FillValue", "nan"}}, {1.0, 2.0}), "");
  EXPECT_EQ(found({{"_FillValue", "-9999"}, {"valid_min", "0"}}, {1.0, 2.0}), "");
}

}  // namespace sarsim::raster::cf_attributes_test

#include "core/text/facts.hpp"

#include <gmock/gmock.h>

#include <array>
#include <limits>

namespace sarsim::core::facts_test {

namespace {

using testing::ElementsAre;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// A target that was found, or not.
Facts target(bool found) {
  return {{"target", "Target", std::size_t{3}},
          {"range_m", "Range", 10234.5, "m", fixed(3)},
          {"outside", "", false},
          {"found", "",
           Facts{{"range_error_m", "Error", only(found, -0.0001), "m", fixed(3), found ? "" : "no peak"},
                 {"width_m", "Width", only(found, 0.25), "m", fixed(2)},
                 {"", "Level", only(found, 1.5), "dB", with_sign(1)}}},
          {"state", "", found ? "found, weak" : "not found"}};
}

}  // namespace

TEST(Facts, AreMembersOfJson) {
  const Facts report{{"name", "Name", "a \"b\""},
                     {"", "For people", 1.0},
                     {"count", "Count", 7U},
                     {"value_m", "Value", 0.1, "m"},
                     {"no_number", "", nothing},
                     {"files", "", std::vector<std::string>{"a", "b"}},
                     {"rows", "Rows", FactRows{{{"n", "", 1}}, {{"n", "", 2}}}},
                     {"maybe", "", std::optional<double>()},
                     {"problems", "", Problems{}}};
  EXPECT_EQ(json_of(report),
            "{\n  \"name\": \"a \\\"b\\\"\",\n  \"count\": 7,\n  \"value_m\": 0.1,\n  \"no_number\": null,\n"
            "  \"files\": [\n    \"a\",\n    \"b\"\n  ],\n"
            "  \"rows\": [\n    {\n      \"n\": 1\n    },\n    {\n      \"n\": 2\n    }\n  ],\n"
            "  \"maybe\": null,\n  \"problems\": []\n}\n");
}

TEST(Facts, AreNullInJsonWhereNothingOfAGroupIsKnown) {
  EXPECT_NE(json_of(target(false)).find("\"found\": null"), std::string::npos);
  EXPECT_NE(json_of(target(true)).find("\"found\": {\n    \"range_error_m\": -0.0001"), std::string::npos);
  EXPECT_EQ(json_of(target(true)).find("Level"), std::string::npos);
}

TEST(Facts, AreColumnsOfCsv) {
  EXPECT_EQ(csv_names(target(false)), "target,range_m,outside,range_error_m,width_m,state\n");
  EXPECT_EQ(csv_line(target(true)), "3,10234.5,0,-0.0001,0.25,\"found, weak\"\n");
  EXPECT_EQ(csv_line(target(false)), "3,10234.5,0,,,not found\n");
  EXPECT_EQ(csv_line({{"third", "", 1.0 / 3.0}}, 4), "0.3333\n");
}

TEST(Facts, AreRowsOfTablesForPeople) {
  EXPECT_THAT(headings(target(false)), ElementsAre("Target", "Range (m)", "Error (m)", "Width (m)", "Level (dB)"));
  EXPECT_THAT(cells(target(true)), ElementsAre("3", "10234.500", "0.000", "0.25", "+1.5"));
  EXPECT_THAT(cells(target(false)), ElementsAre("3", "10234.500", "no peak", "", ""));
  constexpr std::array<std::size_t, 4> widths{3, 10, 6, 5};
  EXPECT_EQ(aligned_row(target(true), widths), "  3  10234.500  0.000  0.25\n");
  EXPECT_EQ(aligned_row(target(false), widths), "  3  10234.500  no peak\n");
}

TEST(Facts, AreLinesForPeople) {
  const Facts facts{{"carrier_hz", "carrier", 5.3e9, "Hz"},
                    {"", "zero", -0.0, "m"},
                    {"ratio", "ratio", 1.25},
                    {"share", "share", 0.5, "", {}, "50 %"},
                    {"rows", "rows", 12, "samples"},
                    {"missing", "missing", nothing, "m"},
                    {"hidden", "", 1.0}};
  EXPECT_EQ(text_of(facts),
            "  carrier                  5.3 GHz\n  zero                     0 m\n  ratio                    1.25\n"
            "  share                    50 %\n  rows                     12 samples\n");
  const std::vector<ShownFact> list = shown(facts);
  ASSERT_EQ(list.size(), 6U);
  EXPECT_EQ(list[0].value, "5.3");
  EXPECT_EQ(list[0].unit, "GHz");
  EXPECT_EQ(list[5].value, "");
}

}  // namespace sarsim::core::facts_test

#include "core/text/json.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace sarsim::core {
namespace json_test {

TEST(Json, NestsObjectsAndArrays) {
  JsonWriter json;
  json.begin_object().member("a", 1).key("b").begin_array().value("x").value(true).end_array();
  json.key("c").begin_array().end_array().key("d").null().end_object();
  EXPECT_EQ(json.text(), "{\n  \"a\": 1,\n  \"b\": [\n    \"x\",\n    true\n  ],\n  \"c\": [],\n  \"d\": null\n}\n");
}

TEST(Json, EscapesWhatStringsCannotHold) {
  JsonWriter json;
  json.value(std::string_view("q\" b\\ n\n t\t z\x01", 14));
  EXPECT_EQ(json.text(), "\"q\\\" b\\\\ n\\n t\\t z\\u0001\"\n");
}

TEST(Json, TakesStrayBytesAsLatin1) {
  EXPECT_EQ(valid_utf8("45\xB0"), "45\xC2\xB0");
  EXPECT_EQ(valid_utf8("\xFF"), "\xC3\xBF");
  EXPECT_EQ(valid_utf8("\xC3"), "\xC3\x83");  // A sequence that is cut off.
}

TEST(Json, KeepsValidUtf8) {
  const std::string text = "\xC2\xB0 \xE2\x82\xAC \xF0\x9F\x93\xA1";
  EXPECT_EQ(valid_utf8(text), text);
}

TEST(Json, RefusesOverlongSequencesAndSurrogates) {
  EXPECT_EQ(valid_utf8("\xC0\x80"), "\xC3\x80\xC2\x80");
  EXPECT_EQ(valid_utf8("\xED\xA0\x80"), "\xC3\xAD\xC2\xA0\xC2\x80");
  EXPECT_EQ(valid_utf8("\xE0\x80\x80"), "\xC3\xA0\xC2\x80\xC2\x80");
}

TEST(Json, NumbersAreExactAndNeverNan) {
  JsonWriter json;
  json.begin_array().value(0.1).value(5.3e9).value(1e-30).value(std::numeric_limits<double>::quiet_NaN());
  json.value(std::numeric_limits<double>::infinity()).value(std::numeric_limits<std::uint64_t>::max()).end_array();
  EXPECT_EQ(json.text(), "[\n  0.1,\n  5300000000,\n  1E-30,\n  null,\n  null,\n  18446744073709551615\n]\n");
}

}  // namespace json_test
}  // namespace sarsim::core

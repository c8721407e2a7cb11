#include "scene/schema/value_list.hpp"

#include <gmock/gmock.h>

#include "scene/model/object.hpp"

namespace sarsim::scene {
namespace value_list_test {

using testing::ElementsAre;
using testing::HasSubstr;

const Field& field(ObjectKind kind, std::string_view id) {
  for (const Field& f : fields_of(kind))
    if (f.id == id) return f;
  throw std::logic_error("no such field");
}
const Field& bandwidth() { return field(ObjectKind::radar, "bandwidth_hz"); }
const Field& length() { return field(ObjectKind::target, "position_m.x"); }
const Field& power() { return field(ObjectKind::radar, "power_w"); }
const Field& bits() { return field(ObjectKind::simulation, "bits"); }
const Field& file() { return field(ObjectKind::simulation, "file"); }
const Field& seed() { return option_fields().at(1); }

std::vector<std::string> values(std::string_view text, const Field& of) {
  const ValueList list = read_value_list(text, of, 1000);
  EXPECT_EQ(list.failure, "") << text;
  return list.texts;
}

std::string failure(std::string_view text, const Field& of, std::size_t most = 1000) {
  const ValueList list = read_value_list(text, of, most);
  EXPECT_TRUE(list.texts.empty()) << text;
  return list.failure;
}

TEST(ValueList, ReadsSingleValuesAndLists) {
  EXPECT_THAT(values("10MHz", bandwidth()), ElementsAre("10MHz"));
  EXPECT_THAT(values(" 10 MHz , 2e7", bandwidth()), ElementsAre("10MHz", "2e7"));
  EXPECT_THAT(values("-3,+4.5,.5", length()), ElementsAre("-3", "+4.5", ".5"));
}

TEST(ValueList, GivesNumbersWithoutUnitsTheLastOne) {
  EXPECT_THAT(values("1,2,5MHz", bandwidth()), ElementsAre("1MHz", "2MHz", "5MHz"));
  EXPECT_THAT(values("1kHz,2,5MHz", bandwidth()), ElementsAre("1kHz", "2MHz", "5MHz"));
  EXPECT_THAT(values("1MHz,2", bandwidth()), ElementsAre("1MHz", "2"));
  EXPECT_THAT(values("10:10:30MHz", bandwidth()), ElementsAre("10MHz", "20MHz", "30MHz"));
  EXPECT_THAT(values("1..3km", length()), ElementsAre("1km", "2km", "3km"));
}

TEST(ValueList, CountsRangesInDecimals) {
  EXPECT_THAT(values("0:0.1:0.5", length()), ElementsAre("0", "0.1", "0.2", "0.3", "0.4", "0.5"));
  EXPECT_THAT(values("10MHz:10MHz:40MHz", bandwidth()), ElementsAre("10MHz", "20MHz", "30MHz", "40MHz"));
  EXPECT_THAT(values("5:-2:0", length()), ElementsAre("5", "3", "1"));
  EXPECT_THAT(values("-1:0.5:1", length()), ElementsAre("-1", "-0.5", "0", "0.5", "1"));
  EXPECT_THAT(values("7:1:7", length()), ElementsAre("7"));
}

TEST(ValueList, EndsOfRangesBelongToThemWithinRounding) {
  // 3 * 0.1 misses 0.3 by a rounding; a thousand steps of 0.001 miss 1.
  EXPECT_EQ(values("0:0.1:0.3", length()).back(), "0.3");
  EXPECT_EQ(values("0:0.001:0.999", length()).size(), 1000U);
  EXPECT_THAT(values("0:2:5", length()), ElementsAre("0", "2", "4"));
}

TEST(ValueList, MixesUnitsWithinARange) {
  EXPECT_THAT(values("900kHz:100kHz:1.1MHz", bandwidth()), ElementsAre("900kHz", "1MHz", "1.1MHz"));
  EXPECT_THAT(values("1m:500mm:2m", length()), ElementsAre("1m", "1.5m", "2m"));
}

TEST(ValueList, CountsDecibelsInDecibels) {
  EXPECT_THAT(values("0dBW:10dBW:30dBW", power()), ElementsAre("0dBW", "10dBW", "20dBW", "30dBW"));
  EXPECT_THAT(failure("1W:10dBW:30dBW", power()), HasSubstr("mixes decibels"));
}

TEST(ValueList, CountsWholeNumbers) {
  EXPECT_THAT(values("6..8,12", bits()), ElementsAre("6", "7", "8", "12"));
  EXPECT_THAT(values("4:4:12", bits()), ElementsAre("4", "8", "12"));
  EXPECT_THAT(values("-1..1", length()), ElementsAre("-1", "0", "1"));
  EXPECT_EQ(values("1..1000", seed()).size(), 1000U);
  EXPECT_THAT(values("18446744073709551615", seed()), ElementsAre("18446744073709551615"));
  EXPECT_THAT(values("9223372036854775806..9223372036854775807", seed()),
              ElementsAre("9223372036854775806", "9223372036854775807"));
}

TEST(ValueList, KeepsCommasWithinQuotationMarks) {
  EXPECT_THAT(values("\"a,b.bin\",c:d.bin", file()), ElementsAre("a,b.bin", "c:d.bin"));
  EXPECT_THAT(failure("\"a,b", file()), HasSubstr("quotation mark"));
}

TEST(ValueList, RefusesWhatIsNoList) {
  EXPECT_THAT(failure("", bandwidth()), HasSubstr("no value"));
  EXPECT_THAT(failure("1,,2", bandwidth()), HasSubstr("nothing between two commas"));
  EXPECT_THAT(failure("1,2,", bandwidth()), HasSubstr("nothing between two commas"));
  EXPECT_THAT(failure("fast", bandwidth()), HasSubstr("not a valid frequency"));
  EXPECT_THAT(failure("5kg", bandwidth()), HasSubstr("not a valid frequency"));
  EXPECT_THAT(failure("nan", bandwidth()), HasSubstr("not a valid frequency"));
  EXPECT_THAT(failure("2.5", bits()), HasSubstr("not a valid whole number"));
}

TEST(ValueList, RefusesRangesThatMakeNoSense) {
  EXPECT_THAT(failure("1:2", length()), HasSubstr("start:step:end"));
  EXPECT_THAT(failure("1:2:3:4", length()), HasSubstr("start:step:end"));
  EXPECT_THAT(failure("1::3", length()), HasSubstr("start:step:end"));
  EXPECT_THAT(failure("1:0:3", length()), HasSubstr("step of zero"));
  EXPECT_THAT(failure("1:-1:3", length()), HasSubstr("never reaches its end"));
  EXPECT_THAT(failure("3:1:1", length()), HasSubstr("never reaches its end"));
  EXPECT_THAT(failure("1:1:1e999", length()), HasSubstr("too large"));
  EXPECT_THAT(failure("1:x:3", length()), HasSubstr("not a valid length"));
  EXPECT_THAT(failure("5..1", length()), HasSubstr("goes down; write 1..5, or 5:-1:1"));
  EXPECT_THAT(failure("1.5..3", length()), HasSubstr("not a valid range of whole numbers"));
  EXPECT_THAT(failure("1...3", length()), HasSubstr("not a valid range of whole numbers"));
  EXPECT_THAT(failure("1..", length()), HasSubstr("not a valid range of whole numbers"));
  EXPECT_THAT(failure("1m..3km", length()), HasSubstr("different units"));
  EXPECT_THAT(failure("-9223372036854775808..9223372036854775807", seed()), HasSubstr("more than 1000"));
}

TEST(ValueList, RefusesMoreValuesThanMany) {
  EXPECT_EQ(read_value_list("1..10", seed(), 10).texts.size(), 10U);
  EXPECT_THAT(failure("1..11", seed(), 10), HasSubstr("more than 10 values"));
  EXPECT_THAT(failure("0:1e-300:1", length(), 10), HasSubstr("more than 10 values"));
  EXPECT_THAT(failure("1..9,1..9", seed(), 10), HasSubstr("more than 10 values"));
  EXPECT_THAT(failure("1,2,3", length(), 2), HasSubstr("more than 2 values"));
}

}  // namespace value_list_test
}  // namespace sarsim::scene

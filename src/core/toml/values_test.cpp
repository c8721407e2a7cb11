#include "core/toml/values.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/text/number_text.hpp"
#include "core/toml/parse.hpp"

namespace sarsim::core::toml {
namespace values_test {

using namespace std::string_literals;

// A text with one value, which is read as `x = value`.
struct One {
  explicit One(const std::string& notation) : text("x = " + notation + "\n") {
    const Document document = parse(text);
    EXPECT_EQ(document.entries.size(), 1U) << notation;
    if (!document.entries.empty()) value = document.entries[0].value;
  }

  std::string text;
  Value value;
};

std::string string_of(const std::string& notation) {
  const One one(notation);
  return decoded_string(one.text, one.value);
}

std::optional<double> number_of(const std::string& notation) {
  const One one(notation);
  return number(one.text, one.value);
}

std::optional<std::int64_t> integer_of(const std::string& notation) {
  const One one(notation);
  return integer(one.text, one.value);
}

DateTime date_time_of(const std::string& notation) {
  const One one(notation);
  return date_time(one.text, one.value).value_or(DateTime{});
}

// The pieces of a container: "key:value" or "value".
std::vector<std::string> pieces_of(const std::string& text, const Value& container) {
  std::vector<std::string> pieces;
  Elements elements(text, container);
  while (const auto element = elements.next())
    pieces.push_back(std::string(piece(text, element->key)) + (container.kind == Kind::table ? ":" : "") +
                     std::string(piece(text, element->value.span)));
  return pieces;
}

using Pieces = std::vector<std::string>;

TEST(TomlElements, AreThoseOfAnArray) {
  const One one("[1, 'a,]', [2, [3]], # no ]\n {a = 1, b = '}'},\n 1979-05-27 07:32:00, \"\"\"x\n\"\"\", true,]");
  EXPECT_EQ(pieces_of(one.text, one.value),
            (Pieces{"1", "'a,]'", "[2, [3]]", "{a = 1, b = '}'}", "1979-05-27 07:32:00", "\"\"\"x\n\"\"\"", "true"}));
  const One empty("[ # nothing\n]");
  EXPECT_EQ(pieces_of(empty.text, empty.value), Pieces{});
}

TEST(TomlElements, AreThoseOfAnInlineTable) {
  const One one("{ a = 1, b . 'c' = [2], \"d=\" = {e = 3} }");
  EXPECT_EQ(pieces_of(one.text, one.value), (Pieces{"a:1", "b . 'c':[2]", "\"d=\":{e = 3}"}));
}

TEST(TomlElements, TellKinds) {
  const One one("[1, 1.5, '', [], {}, 2024-01-01]");
  Elements elements(one.text, one.value);
  for (const Kind kind : {Kind::integer, Kind::floating, Kind::string, Kind::array, Kind::table, Kind::local_date})
    EXPECT_EQ(elements.next().value().value.kind, kind);
  EXPECT_FALSE(elements.next());
  EXPECT_FALSE(elements.next());
}

TEST(TomlElements, OtherKindsHaveNone) {
  const One one("\"[1]\"");
  EXPECT_FALSE(Elements(one.text, one.value).next());
}

TEST(TomlElements, EndInAnyOtherText) {
  std::mt19937 random(1);
  const std::string letters = "[]{}\"'#,=.\\\n 1a-:TZ";
  for (int i = 0; i < 50'000; ++i) {
    std::string text;
    for (std::size_t k = 0; k < 20; ++k) text += letters[random() % letters.size()];
    const auto offset = [&] { return static_cast<std::uint32_t>(random() % 25); };
    const Value value{static_cast<Kind>(random() % 10), {offset(), offset()}};
    Elements elements(text, value);
    int count = 0;
    while (elements.next()) ASSERT_LT(++count, 25);
    ASSERT_LT(decoded_string(text, value).size(), 25U);
    ASSERT_LT(key_parts(text, value.span).size(), 25U);
    for (const Kind kind : {Kind::integer, Kind::floating})
      ASSERT_FALSE(std::isinf(number(text, {kind, value.span}).value_or(0.0)));
    ASSERT_LT(date_time(text, value).value_or(DateTime{}).month, 13);
  }
}

TEST(TomlStrings, AreDecoded) {
  EXPECT_EQ(string_of(R"("")"), "");
  EXPECT_EQ(string_of(R"("a\tb\n\"\\ \b\f\r")"), "a\tb\n\"\\ \b\f\r");
  EXPECT_EQ(string_of(R"("\u0041\u00e9\u20AC\U0001F600")"), "A\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
  EXPECT_EQ(string_of(R"("\u0000")"), "\0"s);
  EXPECT_EQ(string_of(R"('a\tb"')"), "a\\tb\"");
  EXPECT_EQ(string_of("\"\"\"\na\nb\"\"\""), "a\nb");
  EXPECT_EQ(string_of("\"\"\"\r\na\r\nb\"\"\""), "a\nb");
  EXPECT_EQ(string_of("\"\"\"a \\\n\n  \t b\\\r\n c\"\"\""),
            "a b"
            "c");
  EXPECT_EQ(string_of("\"\"\"\\\n\"\"\""), "");
  EXPECT_EQ(string_of("'''\n\na\\n'''"), "\na\\n");
  EXPECT_EQ(string_of(R"("""a"" b""""")"), "a\"\" b\"\"");
  EXPECT_EQ(string_of("'''a'''''"), "a''");
  EXPECT_EQ(string_of("5"), "");
}

TEST(TomlKeys, AreSplitAndDecoded) {
  const auto parts = [](const std::string& key) { return key_parts(key, {0, static_cast<std::uint32_t>(key.size())}); };
  EXPECT_EQ(parts("a"), (Pieces{"a"}));
  EXPECT_EQ(parts("a.b-2._"), (Pieces{"a", "b-2", "_"}));
  EXPECT_EQ(parts(R"(a . "b.\"c" .'d\e'.""."\u00e9")"), (Pieces{"a", "b.\"c", "d\\e", "", "\xC3\xA9"}));
  EXPECT_EQ(parts(""), Pieces{});
}

TEST(TomlNumbers, Integers) {
  EXPECT_EQ(integer_of("+1_000"), 1000);
  EXPECT_EQ(integer_of("-0"), 0);
  EXPECT_EQ(integer_of("0xDead_Beef"), 0xDEADBEEF);
  EXPECT_EQ(integer_of("0o755"), 0755);
  EXPECT_EQ(integer_of("0b1101"), 13);
  EXPECT_EQ(integer_of("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(integer_of("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(integer_of("1.0"), std::nullopt);
  EXPECT_EQ(number_of("0x10"), 16.0);
  EXPECT_EQ(number_of("-7"), -7.0);
}

// The literals on the right are correctly rounded by the compiler.
TEST(TomlNumbers, Floats) {
  EXPECT_EQ(number_of("3.1415"), 3.1415);
  EXPECT_EQ(number_of("+1_0.2_5e+0_2"), 1025.0);
  EXPECT_EQ(number_of("-6.626e-34"), -6.626e-34);
  EXPECT_EQ(number_of("9007199254740993.0"), 9007199254740992.0);
  EXPECT_EQ(number_of("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(number_of("-1e999"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(number_of("1e-999"), 0.0);
  EXPECT_EQ(number_of("+inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(number_of("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(number_of("-nan").value()));
  EXPECT_TRUE(std::signbit(number_of("-0.0").value()));
  EXPECT_EQ(number_of("'1.0'"), std::nullopt);
}

TEST(TomlNumbers, ReadBackWhatIsWritten) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20'000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value) || value == 0.0) continue;
    std::string text = format_number(value);
    const Kind kind = text.find_first_of(".eE") == std::string::npos ? Kind::integer : Kind::floating;
    ASSERT_EQ(number(text, {kind, {0, static_cast<std::uint32_t>(text.size())}}), value) << text;
  }
}

TEST(TomlBooleans, AreTrueOrFalse) {
  const One yes("true");
  const One no("false");
  const One none("1");
  EXPECT_EQ(boolean(yes.text, yes.value), true);
  EXPECT_EQ(boolean(no.text, no.value), false);
  EXPECT_EQ(boolean(none.text, none.value), std::nullopt);
}

TEST(TomlDateTimes, AreTakenApart) {
  const DateTime full = date_time_of("2024-04-01T22:59:42.123456789123-07:30");
  EXPECT_EQ(full.year, 2024);
  EXPECT_EQ(full.month, 4);
  EXPECT_EQ(full.day, 1);
  EXPECT_EQ(full.hour, 22);
  EXPECT_EQ(full.minute, 59);
  EXPECT_EQ(full.second, 42);
  EXPECT_EQ(full.nanosecond, 123'456'789);
  EXPECT_EQ(full.offset_minutes, -450);
  EXPECT_EQ(date_time_of("2024-04-01 22:59:42.5Z").nanosecond, 500'000'000);
  EXPECT_EQ(date_time_of("2024-04-01 22:59:42+00:01").offset_minutes, 1);
  EXPECT_EQ(date_time_of("2016-12-31T23:59:60Z").second, 60);
  EXPECT_EQ(date_time_of("2024-02-29").day, 29);
  EXPECT_EQ(date_time_of("07:32:08").minute, 32);
  const One none("7");
  EXPECT_FALSE(date_time(none.text, none.value));
}

}  // namespace values_test
}  // namespace sarsim::core::toml

#include "core/toml/parse.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/toml/lines.hpp"

namespace sarsim::core::toml {
namespace parse_test {

using namespace std::string_literals;

// "line:column message" of all mistakes.
std::string mistakes_of(const std::string& text) {
  std::string result;
  Lines lines(text);
  for (const Mistake& mistake : parse(text).mistakes) {
    const Position place = lines.at(mistake.at.begin);
    result += (result.empty() ? "" : "\n") + std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
              mistake.message;
  }
  return result;
}

void expect_valid(std::initializer_list<std::string> texts) {
  for (const std::string& text : texts) EXPECT_EQ(mistakes_of(text), "") << text;
}

void expect_invalid(std::initializer_list<std::string> texts) {
  for (const std::string& text : texts) EXPECT_NE(mistakes_of(text), "") << text;
}

void expect_valid_values(std::initializer_list<std::string> values) {
  for (const std::string& value : values) EXPECT_EQ(mistakes_of("x = " + value + "\n"), "") << value;
}

void expect_invalid_values(std::initializer_list<std::string> values) {
  for (const std::string& value : values) {
    EXPECT_NE(mistakes_of("x = " + value + "\n"), "") << value;
    EXPECT_NE(mistakes_of("x = [" + value + "]\n"), "") << value;
    EXPECT_NE(mistakes_of("x = " + value), "") << value << " without a line end";
  }
}

std::string repeated(std::size_t count, const std::string& part) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += part;
  return text;
}

TEST(TomlDocument, KeepsTablesAndEntriesWithTheirPlaces) {
  const std::string text = "a = 1 # one\n[ b . 'c' ]\nd.e = [2,\n 3]\n\n[[f]]\n";
  const Document document = parse(text);
  ASSERT_EQ(document.tables.size(), 3U);
  ASSERT_EQ(document.entries.size(), 2U);
  EXPECT_TRUE(document.mistakes.empty());
  const auto& [root, table, element] = std::tie(document.tables[0], document.tables[1], document.tables[2]);
  EXPECT_EQ(piece(text, root.header), "");
  EXPECT_EQ(root.entries, 1U);
  EXPECT_EQ(piece(text, table.header), "[ b . 'c' ]");
  EXPECT_EQ(piece(text, table.name), "b . 'c'");
  EXPECT_EQ(table.first_entry, 1U);
  EXPECT_EQ(table.entries, 1U);
  EXPECT_FALSE(table.element);
  EXPECT_EQ(piece(text, element.header), "[[f]]");
  EXPECT_TRUE(element.element);
  EXPECT_EQ(element.entries, 0U);
  EXPECT_EQ(piece(text, document.entries[0].value.span), "1");
  EXPECT_EQ(piece(text, document.entries[1].key), "d.e");
  EXPECT_EQ(piece(text, document.entries[1].value.span), "[2,\n 3]");
  EXPECT_EQ(document.entries[1].value.kind, Kind::array);
}

TEST(TomlDocument, TellsKindsApart) {
  const auto kind = [](const std::string& value) { return parse("x = " + value).entries.at(0).value.kind; };
  for (const char* value : {"''", "\"\"", "''''''", "\"\"\"a\"\"\""}) EXPECT_EQ(kind(value), Kind::string) << value;
  for (const char* value : {"0", "-5", "0xe", "0b1", "0o7"}) EXPECT_EQ(kind(value), Kind::integer) << value;
  for (const char* value : {"0.0", "1e5", "-2E-3", "inf", "-nan"}) EXPECT_EQ(kind(value), Kind::floating) << value;
  EXPECT_EQ(kind("true"), Kind::boolean);
  EXPECT_EQ(kind("2024-04-01T22:59:42Z"), Kind::offset_date_time);
  EXPECT_EQ(kind("2024-04-01 22:59:42-03:00"), Kind::offset_date_time);
  EXPECT_EQ(kind("2024-04-01 22:59:42.5"), Kind::local_date_time);
  EXPECT_EQ(kind("2024-04-01 # 2"), Kind::local_date);
  EXPECT_EQ(kind("22:59:42"), Kind::local_time);
  EXPECT_EQ(kind("[]"), Kind::array);
  EXPECT_EQ(kind("{}"), Kind::table);
}

// ---- groups of the public test suite

TEST(TomlDocument, Arrays) {
  expect_valid_values({"[]", "[ ]", "[1, 2]", "[1, 2,]", "[ [1], ['a', \"b\"], [[], []] ]", "[1, 'a', 2.5, {}]",
                       "[ # nothing\n]", "[\n1 # one\n,\n# two\r\n2\r\n]", "[{a = 1}, {a = 2}]", "[']', \"]\", '#']"});
  expect_invalid_values({"[1 2]", "[,]", "[1,,2]", "[1", "[1,", "[1}", "[1]]", "[a]", "[1, # 2]", "[[1]", "[\"a]"});
}

TEST(TomlDocument, Booleans) {
  expect_valid_values({"true", "false", "[true,false]"});
  expect_invalid_values({"True", "FALSE", "tru", "truee", "true1", "t", "yes", "falsify", "true-", "0true"});
}

TEST(TomlDocument, Comments) {
  expect_valid({"", "#", "# a", "#\n#\r\n", "x = 1#", "[a]#[b]\n", " \t# tab\there\n", "# \xC3\xA4\xF0\x9F\x98\x80\n"});
  expect_invalid({"# \x01\n", "# \x7F\n", "# a\rb\n", "#\r", "# \xFF\n", "x = 1 #\0\n"s, "a = 'x' ! comment\n"});
}

TEST(TomlDocument, ControlCharacters) {
  for (int c = 0; c < 0x80; ++c) {
    if (c == '\t' || c == '\n' || (c >= 0x20 && c < 0x7F)) continue;
    const std::string byte(1, static_cast<char>(c));
    expect_invalid({"x = \"a" + byte + "b\"\n", "x = 'a" + byte + "b'\n", "x = \"\"\"a" + byte + "b\"\"\"\n",
                    "x = '''a" + byte + "b'''\n", "# a" + byte + "b\n", byte + "b = 1\n", "x = 1" + byte + "1\n",
                    "[a" + byte + "]\n"});
  }
  expect_valid({"x = '\t'\ny = \"\t\"\r\n\tz\t=\t1\t\n"});
}

TEST(TomlDocument, DateTimes) {
  expect_valid_values({"1979-05-27T07:32:00Z", "1979-05-27t07:32:00z", "1979-05-27 07:32:00+23:59",
                       "1979-05-27T00:32:00.999999999999-07:00", "0000-01-01T00:00:00Z", "9999-12-31T23:59:59Z",
                       "2000-02-29", "2024-02-29", "07:32:00", "00:32:00.1", "1979-05-27T07:32:00",
                       "2016-12-31T23:59:60Z", "2017-01-01T00:59:60+01:00", "23:59:60"});
  expect_invalid_values({"1900-02-29",
                         "2023-02-29",
                         "2024-04-31",
                         "2024-00-01",
                         "2024-13-01",
                         "2024-01-00",
                         "2024-1-01",
                         "2024-01-1",
                         "24-01-01",
                         "12024-01-01",
                         "2024-01-01T",
                         "2024-01-01T24:00:00",
                         "2024-01-01T00:60:00",
                         "2024-01-01T00:00:61",
                         "2024-01-01T12:00:60Z",
                         "2024-01-01T00:00",
                         "2024-01-01T00:00Z",
                         "7:32:00",
                         "07:32",
                         "07:32:00.",
                         "07:32:00Z",
                         "07:32:00.5.5",
                         "2024-01-01T00:00:00+24:00",
                         "2024-01-01T00:00:00+01:60",
                         "2024-01-01T00:00:00+01",
                         "2024-01-01T00:00:00+0100",
                         "2024-01-01T00:00:00.Z",
                         "2024-01-01  00:00:00",
                         "2024-01-01x00:00:00",
                         "2024-01-01Z",
                         "2024-01-01T00:00:00ZZ",
                         "2024-01-0100:00:00",
                         "2024/01/01"});
}

TEST(TomlDocument, Encoding) {
  expect_valid({"\xEF\xBB\xBF", "\xEF\xBB\xBFx = 1\n", "x = '\xF4\x8F\xBF\xBF \xEE\x80\x80 \xED\x9F\xBF'\n"});
  for (const char* bytes :
       {"\x80", "\xC0\x80", "\xC1\xBF", "\xC3", "\xC3(", "\xE0\x80\x80", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xED\xBF\xBF",
        "\xE2\x82", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"})
    expect_invalid({"x = '"s + bytes + "'\n", "x = \""s + bytes + "\"\n", "x = '''"s + bytes + "'''", "# "s + bytes,
                    "'"s + bytes + "' = 1"});
  expect_invalid({"\xEF\xBB\xBF\xEF\xBB\xBF", "x = 1\n\xEF\xBB\xBFy = 2\n", "\xEF\xBB", "\xFF\xFEx\0 \0"s,
                  "\xC2\xA0x = 1", "x = \xC2\xB1"});
}

TEST(TomlDocument, Floats) {
  expect_valid_values({"0.0",     "+1.0",  "-0.01",    "5e+22", "1E06",    "-2e-2", "6.626e-34", "9_224.445_9",
                       "1_0e1_0", "1e00",  "3.0e00_1", "inf",   "+inf",    "-inf",  "nan",       "+nan",
                       "-nan",    "1e999", "0e0",      "0.0_1", "6.6e-34", "121e-3"});
  expect_invalid_values({".7",    "7.",    "3.e+20", "+.5",   "1e",   "1e+",      "1.2.3", "1e2.3",
                         "1e2e3", "1_.0",  "1._0",   "1.0_",  "1e_1", "1e1_",     "1_e1",  "1__0.0",
                         "_1.0",  "03.14", "-00.5",  "1.0f",  "Inf",  "infinity", "in",    "NaN",
                         "na",    "++1.0", "-+1.0",  "1.0 5", "inf_", "0x1.8p3",  "e5"});
  expect_invalid({"x = 1,5\n"});
}

TEST(TomlDocument, InlineTables) {
  expect_valid_values({"{}", "{ }", "{a=1}", "{ a = 1 , b = 2 }", "{a.b = 1, a.c = 2}", "{a = {b = {}}}",
                       "{'a b' = [1,\n2]}", "{a = [{b = 1}, {b = 1}]}", "{a = \"\"\"x\ny\"\"\"}", "{a = 1} # {"});
  expect_invalid_values({"{a = 1,}", "{,}", "{a = 1,, b = 2}", "{a = 1 b = 2}", "{a}", "{a = }", "{= 1}", "{a = 1\n}",
                         "{\n}", "{a = 1, # b\n}", "{a = 1", "{a = 1]", "{a = 1, a = 2}", "{a = {b = 1}, a.c = 2}",
                         "{a.b = 1, a = 2}", "{a = 1, a.b = 2}", "{a.b = 1, a.b = 2}", "{a = 1, \"a\" = 2}", "{[a]}"});
  expect_invalid({"a = {}\na.b = 1\n", "a = {}\n[a]\n", "a = {}\n[a.b]\n", "a = {}\n[[a]]\n", "a = {b = {}}\n[a.b.c]\n",
                  "a = {b.c = 1}\na.b.d = 1\n", "a.b = {}\na.b.c = 1\n", "[a.b]\n[a]\nb = {}\n", "a = {} b = 1\n"});
}

TEST(TomlDocument, Integers) {
  expect_valid_values({"0", "+0", "-0", "+99", "1_000", "1_2_3", "9223372036854775807", "-9223372036854775808", "0x0",
                       "0xDEAD_beef", "0o0755", "0b1101_0", "0x7FFFFFFFFFFFFFFF", "0x0000000000000000000001"});
  expect_invalid_values({"01",
                         "+01",
                         "-00",
                         "0_0",
                         "_1",
                         "1_",
                         "1__0",
                         "+",
                         "-",
                         "+-1",
                         "--1",
                         "9223372036854775808",
                         "-9223372036854775809",
                         "0x8000000000000000",
                         "0xFFFFFFFFFFFFFFFF",
                         "99999999999999999999",
                         "+0x1",
                         "-0b1",
                         "0x",
                         "0o",
                         "0b",
                         "0x_1",
                         "0x1_",
                         "0x1__2",
                         "0xG",
                         "0o8",
                         "0b2",
                         "0X1",
                         "0B1",
                         "0O1",
                         "1a",
                         "1 2",
                         "0x-1",
                         "1 000",
                         "\xD9\xA1",
                         "5.3 GHz",
                         "12m"});
}

TEST(TomlDocument, Keys) {
  expect_valid({"a-b_C9 = 1\n", "1234 = 1\n", "1.2 = 3\n", "- = 1\n", "'' = 1\n", "\"\" = 1\n", "\"a b\" = 1\n",
                "'a.b'.c = 1\n", "a . b\t.\"c\" = 1\n", "\"\\u00e9\\\"\" = 1\n", "a.b = 1\na.c = 2\n",
                "true = 1\ninf = 2\n", "'\\u0061' = 1\na = 2\n", "a = 1\nA = 2\n", "\"a.b\" = 1\na.b = 2\n",
                "'\xC3\xA9' = 1\n"});
  expect_invalid({"= 1\n",         "a\n",
                  "a =\n",         "a b = 1\n",
                  ".a = 1\n",      "a. = 1\n",
                  "a..b = 1\n",    "a = 1 b = 2\n",
                  "a = = 1\n",     "\"a = 1\n",
                  "'a\n' = 1\n",   "\"\"\"a\"\"\" = 1\n",
                  "'''a''' = 1\n", "\"a\\q\" = 1\n",
                  "a# = 1\n",      "\xC3\xA9 = 1\n",
                  "a! = 1\n",      "a\n= 1\n",
                  "a =\n1\n",      "[a] b = 1\n",
                  "a: 1\n",        "a+b = 1\n",
                  "a,b = 1\n"});
  expect_invalid({"a = 1\na = 2\n", "a = 1\n\"a\" = 2\n", "'a' = 1\n\"\\u0061\" = 2\n", "a = 1\na.b = 2\n",
                  "a.b = 1\na = 2\n", "a.b.c = 1\na.b = 2\n", "a.b = 1\na.b.c = 2\n", "'' = 1\n\"\" = 2\n"});
}

TEST(TomlDocument, Strings) {
  expect_valid_values({R"("")", R"("a'b")", R"('a"b\')", R"("\b\t\n\f\r\"\\\u00E9\U0001f600")", "\"\"\"\n\"\"\"",
                       R"("""a"b""c""")", R"("""a""""")", R"("""""")", R"("""""a""")", "'''a''b'''", "'''a'''''",
                       "'''\r\na\r\nb'''", "\"\"\"a \\\n  b\"\"\"", "\"\"\"a\\  \t\r\n\n  b\"\"\"", "\"\"\"\\\n\"\"\"",
                       R"("\\")", R"("""\"""" )", R"("\u0000\u001f\uD7FF\uE000\U0010FFFF")"});
  expect_invalid_values({R"("a)",
                         "'a",
                         "\"a'",
                         R"("a"b")",
                         "'a'b'",
                         R"("\")",
                         R"("\a")",
                         R"("\e")",
                         R"("\x41")",
                         R"("\ ")",
                         R"("\'")",
                         R"("\u12")",
                         R"("\u12G4")",
                         R"("\U0010FFF")",
                         R"("\U00110000")",
                         R"("\uD800")",
                         R"("\uDFFF")",
                         R"("\UFFFFFFFF")",
                         "\"a\nb\"",
                         "'a\nb'",
                         "\"a\\\nb\"",
                         R"("""a)",
                         R"("""a"")",
                         "'''a''",
                         "'''a''''''",
                         R"("""a"""""")",
                         R"("""\q""")",
                         "\"\"\"a\\ b\"\"\"",
                         "\"\"\"a\rb\"\"\"",
                         "'''a\rb'''",
                         "abc",
                         "`a`",
                         "\"\"\"\\\"\"\""});
}

TEST(TomlDocument, Tables) {
  expect_valid({"[a]\n[b]\n", "[a.b]\n[a]\n", "[a]\n[a.b]\n", "[a.b.c]\n[a.d]\n[a]\nx = 1\n", "[ a ]\n", "[a . b]\n",
                "[1.2]\n", "['a.b'.\"c\"]\n", "[a]", "[a]\r\n", "[a]\nb = 1\n[c]\nb = 1\n", "a.b = 1\n[a.c]\n",
                "[a]\nb.c = 1\n[a.b.d]\n", "[a.b.c]\n[a]\nb.d = 1\n", "['']\n", "[a]\n[A]\n", "[a.b.c]\n[a.b]\n[a]\n"});
  expect_invalid({"[]\n", "[ ]\n", "[a\n", "[a]]\n", "[a.]\n", "[.a]\n", "[a..b]\n", "[a b]\n", "[a\n]\n", "[a] [b]\n",
                  "[ [a] ]\n", "[a] x\n", "[\"\"\"a\"\"\"]\n", "[a=1]\n", "[a#]\n", "[\xC3\xA9]\n", "]\n",
                  "[a]b = 1\n"});
  expect_invalid({"[a]\n[a]\n", "[a]\n['a']\n", "[a.b]\n[a]\n[a]\n", "a = 1\n[a]\n", "a = 1\n[a.b]\n",
                  "[a]\nb = 1\n[a.b]\n", "[a]\nb = 1\n[a.b.c]\n", "a.b = 1\n[a]\n", "[a]\nb.c = 1\n[a.b]\n",
                  "[a]\nb.c.d = 1\n[a.b.c]\n", "[a.b]\n[a]\nb.c = 1\n", "[a.b.c]\n[a]\nb.c.d = 1\n",
                  "[a.b.c.d]\n[a]\nb.c.d.e = 1\n", "[a.b]\n[a]\nb = 1\n"});
}

TEST(TomlDocument, ArraysOfTables) {
  expect_valid({"[[a]]\n[[a]]\n", "[[a]]\nb = 1\n[[a]]\nb = 1\n", "[[a]]\n[a.b]\n[[a]]\n[a.b]\n", "[[a.b]]\n[a]\n",
                "[[a]]\n[[a.b]]\n[[a.b]]\n[[a]]\n[[a.b]]\n", "[[ a . b ]]\n", "[a]\n[[a.b]]\n",
                "[[a]]\nb.c = 1\n[[a]]\nb.c = 1\n", "[[a]]\n[b]\n[a.c]\n[[a]]\n[a.c]\n[c]\n",
                "[[a]]\n[[a.b]]\nc = 1\n[a.b.d]\n[[a.b]]\n[a.b.d]\n"});
  expect_invalid({"[[]]\n",
                  "[[a]\n",
                  "[[a] ]\n",
                  "[[a\n]]\n",
                  "[[a]]]\n",
                  "[[a.]]\n",
                  "[[a]]\n[a]\n",
                  "[a]\n[[a]]\n",
                  "[a.b]\n[[a]]\n",
                  "a = []\n[[a]]\n",
                  "a = [{}]\n[[a]]\n",
                  "a = [{}]\n[a.b]\n",
                  "[[a]]\nb = 1\nb = 2\n",
                  "[[a]]\n[a.b]\n[a.b]\n",
                  "[[a]]\n[[a.b]]\n[a.b]\n",
                  "[[a]]\n[a.b]\n[[a.b]]\n",
                  "a = 1\n[[a]]\n",
                  "a.b = 1\n[[a]]\n",
                  "[[a.b]]\n[a]\nb.c = 1\n",
                  "[[a.b]]\n[a]\nb = 1\n",
                  "[[a]]\nb.c = 1\n[a.b]\n"});
}

TEST(TomlDocument, AWholeDocument) {
  expect_valid({R"(# A document with everything.
title = "x"

[owner]
name = 'N. N.'
born = 1979-05-27T07:32:00-08:00

[database]
enabled = true
ports = [ 8000, 8001, 8002 ]
data = [ ["delta", "phi"], [3.14] ]
limits = { cpu = 79.5, case.x = -0 }

[servers]
  [servers.alpha]
  ip = "10.0.0.1"

[[product]]
name = """
many \
   lines"""

[[product]]  # empty

[[product]]
  [product.size]
  x = 1
  [[product.variety]]
  y = nan
)"});
}

// ---- mistakes

TEST(TomlDocument, FindsAllMistakesAtOnce) {
  EXPECT_EQ(mistakes_of("a = \"x\nb = 5.3 GHz\nc = yes\n! d\n[e\nf = 1\nf = 2\n"),
            "1:5 string is not closed\n2:9 unexpected text where the line should end\n3:5 not a TOML value\n4:1 key is "
            "missing\n5:3 header is not closed\n7:1 key appears twice in its table");
}

TEST(TomlDocument, GoesOnWithinArrays) {
  EXPECT_EQ(mistakes_of("a = [\n  [1, 2x],\n  [3 4, 5],\n  [6, , 7],\n]\nb = 01\n"),
            "2:7 malformed number\n3:6 values are not separated by a comma\n4:7 value is missing\n6:5 number has a "
            "leading zero");
}

TEST(TomlDocument, FindsTheLineThatFollowsAnOpenBracketOrString) {
  EXPECT_EQ(mistakes_of("a = [1,\n  2,\nb = 01\n"), "1:5 array is not closed\n3:5 number has a leading zero");
  EXPECT_EQ(mistakes_of("a = [1,\n[b]\nc = 01\n"), "1:5 array is not closed\n3:5 number has a leading zero");
  EXPECT_EQ(mistakes_of("a = [1\n[[b]] # b\nc = 01\n"), "1:5 array is not closed\n3:5 number has a leading zero");
  EXPECT_EQ(mistakes_of("a = \"\"\"\nx\n\nb.c = 01\n"),
            "1:5 string of several lines is not closed\n4:7 number has a leading zero");
  EXPECT_EQ(mistakes_of("a = '''\n[b]\nc = 01\n"),
            "1:5 string of several lines is not closed\n3:5 number has a leading zero");
  EXPECT_EQ(mistakes_of("a = [\"x,\n  1]\nb = 01\n"), "1:6 string is not closed\n3:5 number has a leading zero");
  EXPECT_EQ(mistakes_of("a = {b = 1,\n  c = 2\n}\nd = 01\n"),
            "1:5 inline table does not end on its line\n4:5 number has a leading zero");
  EXPECT_EQ(mistakes_of("a = {b = [1}\nc = [{d = 1]\ne = 01\n"),
            "1:12 closing bracket is of the wrong kind\n"
            "2:12 closing bracket is of the wrong kind\n"
            "3:5 number has a leading zero");
}

TEST(TomlDocument, LeavesOutEntriesWithMistakes) {
  const Document document = parse("a = 1\na = 2\nb = 5 m\nc = [1 2]\n[d]\n[d]\ne = 1\n[f]\n");
  EXPECT_EQ(document.mistakes.size(), 4U);
  ASSERT_EQ(document.tables.size(), 4U);
  EXPECT_EQ(document.tables[0].entries, 1U);
  EXPECT_FALSE(document.tables[1].broken);
  EXPECT_TRUE(document.tables[2].broken);
  EXPECT_EQ(document.tables[2].entries, 1U);
  EXPECT_FALSE(document.tables[3].broken);
}

TEST(TomlDocument, SaysWhatIsWrongInWords) {
  const auto first = [](const std::string& text) { return parse(text).mistakes.at(0); };
  EXPECT_EQ(first("\n\na = 1\n\nb = 2\na = 3\n").hint, "the first one is in line 3");
  EXPECT_EQ(first("a = 1\n\n[b]\n\n[c]\n[b]\n").hint, "the first one is in line 3");
  const Mistake word = first("a = abc # x\n");
  EXPECT_EQ(word.found, "abc");
  EXPECT_EQ(word.expected, "a value");
  EXPECT_EQ(word.hint, "text needs straight quotes; write true and false in lower case");
  EXPECT_EQ(first("a = 07:30\n").hint, "only TOML 1.1 lets them be left out");
  EXPECT_EQ(first("a = {b = 1,}\n").hint, "only TOML 1.1 allows it");
  EXPECT_EQ(first("a = \"\\e\"\n").hint, "that one is of TOML 1.1");
  EXPECT_EQ(first("a = '" + std::string(200, 'x') + "\n").found.size(), 63U);
}

TEST(TomlDocument, StopsAfterManyMistakes) {
  EXPECT_EQ(parse(repeated(5000, "x\n")).mistakes.size(), max_mistakes);
  EXPECT_EQ(parse("a = [\n" + repeated(5000, "x,\n") + "]").mistakes.size(), max_mistakes);
}

// ---- size

TEST(TomlDocument, BoundsTheDepthOfBrackets) {
  const auto nested = [](std::size_t depth) {
    return "a = " + std::string(depth, '[') + std::string(depth, ']') + "\nb = 01\n";
  };
  EXPECT_EQ(mistakes_of(nested(deepest_nesting)), "2:5 number has a leading zero");
  EXPECT_EQ(mistakes_of(nested(deepest_nesting + 1)),
            "1:105 brackets are nested too deeply\n2:5 number has a leading zero");
  EXPECT_EQ(parse("a = " + repeated(100'000, "[{a = ")).mistakes.size(), 1U);
}

TEST(TomlDocument, TakesManyNamesInLinearTime) {
  EXPECT_EQ(mistakes_of("a" + repeated(200'000, ".a") + " = 1\n"), "");
  EXPECT_EQ(mistakes_of("[a" + repeated(200'000, ". 'a'") + "]\n"), "");
  std::string keys;
  for (int i = 0; i < 100'000; ++i) keys += "key" + std::to_string(i) + " = " + std::to_string(i) + "\n";
  EXPECT_EQ(mistakes_of(keys), "");
  EXPECT_EQ(mistakes_of(keys + "key99999 = 1\n"), "100001:1 key appears twice in its table");
  EXPECT_EQ(mistakes_of("[[x]]\n" + keys + "[[x]]\n" + keys), "");
}

// Each of these took quadratic time once, or could have.
TEST(TomlDocument, TakesLongLinesOfMistakesInLinearTime) {
  constexpr std::size_t many = 200'000;
  for (const std::string& text :
       {"a = [" + repeated(many, "@ 1 2x ,"), "a = [\n'" + std::string(many, 'x') + "' " + repeated(many, "@ ,"),
        "a = [@" + repeated(many, "\"\\"), "a = [" + repeated(many, "\"\"\"x\"\"\",") + "]", repeated(many, "a = ["),
        "a = [\n" + repeated(many, "'a', \"b\nc\" ")})
    EXPECT_LE(parse(text).mistakes.size(), max_mistakes);
}

TEST(TomlDocument, ForgetsFinishedElements) {
  const Document document = parse(repeated(100'000, "[[a]]\nb.c = 1\n[a.d]\ne = {f = 1}\n[[g]]\n[[g.h]]\n"));
  EXPECT_TRUE(document.mistakes.empty());
  EXPECT_EQ(document.tables.size(), 400'001U);
  EXPECT_EQ(document.entries.size(), 200'000U);
}

}  // namespace parse_test
}  // namespace sarsim::core::toml

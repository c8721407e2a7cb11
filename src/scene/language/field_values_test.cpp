#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/language/scene_reader.hpp"

/// Every field of format 2 with a good, a bad and an unlikely value, from the table of fields. A good value, which is
/// its example, is in explanation_test.cpp, too.
namespace sarsim::scene::language {
namespace field_values_test {

using testing::HasSubstr;
using testing::Not;

struct Complaints {
  std::string errors;
  std::string warnings;
};

// What reading an object with these lines complains of.
Complaints complaints(const PlainTable& table, const std::string& lines) {
  const std::string text =
      fmt::format("format = \"sarsim 2\"\n{}{}\n{}\n", table.header == "radar" ? "" : "[[radar]]\nname = \"Radar1\"\n",
                  table.header_line(), lines);
  Complaints complaints;
  for (const core::Problem& problem : read_format_2(text, "scene.toml", {}).problems)
    (problem.severity == core::Severity::error ? complaints.errors : complaints.warnings) +=
        core::to_string(problem) + "\n";
  return complaints;
}

bool is_number(const PathFacts& facts) {
  const FieldSpec& spec = facts.spec();
  return (facts.role == PathRole::points || spec.type == FieldType::number || spec.type == FieldType::vector) &&
         (facts.role == PathRole::points || facts.role == PathRole::value) && spec.choices.empty() &&
         spec.flags.empty() && facts.path != "positions";
}

// A value of a path that holds this number.
std::string with_number(const PathFacts& facts, const std::string& number) {
  const FieldSpec& spec = facts.spec();
  if (facts.role == PathRole::points)
    return spec.block->x_ignored ? fmt::format("[{0}, {0}]", number) : fmt::format("[[0, {0}], [1, {0}]]", number);
  const std::string one = spec.type == FieldType::vector ? fmt::format("[{0}, {0}, {0}]", number) : number;
  std::string all = one;
  for (std::size_t i = 1; i < facts.fields.size(); ++i) all += ", " + one;
  return facts.fields.size() == 1 ? one : "[" + all + "]";
}

// The limits of what may be written, and of what is not suspicious.
Range allowed(const PathFacts& facts) { return range_of(facts); }
Range likely(const PathFacts& facts) {
  return facts.role == PathRole::points ? likely_y(*facts.spec().block) : facts.spec().likely;
}

// A number beyond a range on one of its sides that another range still holds.
std::optional<double> beyond(const Range& range, const Range& within) {
  const auto step = [](double limit) { return std::max(std::abs(limit), 1.0); };
  for (const double number : {range.high + step(range.high), range.low - step(range.low), 2.0 * range.low / 3.0})
    if (std::isfinite(number) && number != 0.0 && !range.holds(number) && within.holds(number)) return number;
  return std::nullopt;
}

std::string text_of(double number, const PathFacts& facts) {
  return core::format_number(quantity_of(facts) == Quantity::count ? std::floor(number) : number);
}

template <class Visit>
void for_each_path(const Visit& visit) {
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& facts : paths_of(table)) visit(table, facts);
}

TEST(FieldValues, ANumberOfAnotherKindIsRefusedEverywhere) {
  int count = 0;
  for_each_path([&](const PlainTable& table, const PathFacts& facts) {
    if (!is_number(facts)) return;
    for (const char* const value : {"\"1 kg\"", "true", "\"\"", "nan"}) {
      const std::string lines = example_text(table, facts, with_number(facts, value));
      EXPECT_NE(complaints(table, lines).errors, "") << lines;
    }
    ++count;
  });
  EXPECT_GT(count, 60);
}

TEST(FieldValues, ANumberOutOfRangeIsRefusedWithTheRange) {
  int count = 0;
  for_each_path([&](const PlainTable& table, const PathFacts& facts) {
    if (!is_number(facts)) return;
    const std::optional<double> number = beyond(allowed(facts), any_value);
    if (!number) return;
    const std::string lines = example_text(table, facts, with_number(facts, text_of(*number, facts)));
    EXPECT_THAT(complaints(table, lines).errors, HasSubstr("out of range")) << lines;
    ++count;
  });
  EXPECT_GT(count, 25);
}

TEST(FieldValues, AnUnlikelyNumberIsTakenWithAWarning) {
  int count = 0;
  for_each_path([&](const PlainTable& table, const PathFacts& facts) {
    if (!is_number(facts)) return;
    const std::optional<double> number = beyond(likely(facts), allowed(facts));
    // What is allowed may be bounded more closely than anything that would be unlikely.
    const bool has_unit = quantity_of(facts) != Quantity::number && quantity_of(facts) != Quantity::count;
    if (facts.role == PathRole::value && (number || !std::isfinite(allowed(facts).high))) {
      EXPECT_EQ(number.has_value(), has_unit) << table.header << '.' << facts.path << " lacks a likely range";
    }
    if (!number) return;
    const std::string lines = example_text(table, facts, with_number(facts, text_of(*number, facts)));
    const Complaints told = complaints(table, lines);
    EXPECT_THAT(told.warnings, HasSubstr("is unusual")) << lines;
    EXPECT_EQ(told.errors, "") << lines;
    ++count;
  });
  EXPECT_GT(count, 40);
}

TEST(FieldValues, AWordThatDoesNotExistIsRefusedWithThoseThatDo) {
  int count = 0;
  for_each_path([&](const PlainTable& table, const PathFacts& facts) {
    const bool is_choice = facts.role == PathRole::choice || facts.role == PathRole::interpolation;
    if (!is_choice) return;
    const std::string lines = example_text(table, facts, "\"nonsense\"");
    EXPECT_THAT(complaints(table, lines).errors, HasSubstr("nonsense")) << lines;
    ++count;
  });
  EXPECT_GT(count, 20);
}

TEST(FieldValues, WhatIsNeitherYesNorNoNorATextIsRefused) {
  int count = 0;
  for_each_path([&](const PlainTable& table, const PathFacts& facts) {
    if (facts.role != PathRole::value) return;
    const FieldType type = facts.spec().type;
    const bool is_text = type == FieldType::text || type == FieldType::name;
    if (!is_text && type != FieldType::check && type != FieldType::seed && type != FieldType::flags) return;
    const std::string lines = example_text(table, facts, is_text ? "5" : "[[1]]");
    EXPECT_NE(complaints(table, lines).errors, "") << lines;
    ++count;
  });
  EXPECT_GT(count, 12);
}

}  // namespace field_values_test
}  // namespace sarsim::scene::language

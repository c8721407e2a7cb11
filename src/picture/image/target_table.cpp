#include "picture/image/target_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <variant>

#include <fmt/format.h>

namespace sarsim::picture {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// A column: the label of the fact that it shows, and what it means.
struct Column {
  const char* label;
  const char* meaning;
};

constexpr Column all_columns[] = {
    {"Azimuth", "Expected position of the target's image"},
    {"Range", "Expected position of the target's image"},
    {"Offset az.", "Measured minus expected position, in azimuth"},
    {"Offset rg.", "Measured minus expected position, in range"},
    {"Width az.", "-3 dB width in azimuth"},
    {"Width rg.", "-3 dB width in range"},
    {"PSLR az.", "Peak sidelobe ratio in azimuth"},
    {"PSLR rg.", "Peak sidelobe ratio in range"},
    {"ISLR az.", "Integrated sidelobe ratio in azimuth"},
    {"ISLR rg.", "Integrated sidelobe ratio in range"},
    {"SNR", "Peak power over the noise power of the image"},
};

// Those columns, in their order.
core::Facts shown_columns(const workflow::MeasuredTarget& target, const workflow::MeasureReport& report) {
  const core::Facts facts = columns_of(target, report);
  core::Facts columns;
  for (const Column& column : all_columns)
    columns.push_back(*std::ranges::find(facts, column.label, &core::Fact::label));
  return columns;
}

std::string state_of(const workflow::MeasuredTarget& target) {
  if (target.outside) return target.theory.unrecorded ? "outside the recorded ranges" : "outside the image";
  if (!target.expected()) return "no echoes";
  return target.found ? "found" : to_string(target.state);
}

TargetTable::Row row_of(const workflow::MeasuredTarget& target, const workflow::MeasureReport& report) {
  TargetTable::Row row;
  row.target = target.theory.target + 1;
  row.expected = target.theory.place;
  row.inside = target.expected() && !target.outside;
  row.found = target.found.has_value();
  row.words = {std::to_string(row.target), state_of(target)};
  row.values = {static_cast<double>(row.target), nothing};
  const core::Facts columns = shown_columns(target, report);
  std::ranges::move(core::cells(columns), std::back_inserter(row.words));
  for (const core::Fact& fact : columns) {
    const double* const number = std::get_if<double>(&fact.value.held());
    row.values.push_back(number != nullptr && std::isfinite(*number) ? *number : nothing);
  }
  return row;
}

}  // namespace

TargetTable target_table(const workflow::MeasureReport& report) {
  TargetTable table;
  table.columns = {"Target", "State"};
  table.meanings = {"Its number in the script", "Whether the peak has the expected position and strength"};
  std::ranges::move(core::headings(shown_columns({}, report)), std::back_inserter(table.columns));
  for (const Column& column : all_columns) table.meanings.emplace_back(column.meaning);
  for (const workflow::MeasuredTarget& target : report.targets) table.rows.push_back(row_of(target, report));
  const workflow::MeasureSummary sum = workflow::summary_of(report);
  table.summary = fmt::format("{} of {} found", sum.found, sum.expected);
  if (sum.found > 0) table.summary += fmt::format(", at most {:.4f} m position error", sum.farthest_m);
  if (sum.outside > 0) table.summary += fmt::format("; {} outside the image", sum.outside);
  return table;
}

std::string text_of(const TargetTable& table) {
  const auto line = [](const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : "\t") + words[i];
    return text + "\n";
  };
  std::string text = line(table.columns);
  for (const TargetTable::Row& row : table.rows) text += line(row.words);
  return text;
}

}  // namespace sarsim::picture

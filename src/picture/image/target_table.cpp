#include "picture/image/target_table.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace sarsim::picture {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// A column: what it is called, what it means, and its value for a target.
struct Column {
  const char* heading;
  const char* meaning;
  int digits;
  bool has_sign;
  double (*value)(const workflow::MeasuredTarget& target);
};

template <class Value>
double if_found(const workflow::MeasuredTarget& target, const Value& value) {
  const signal::PointResponse* const response = target.response();
  return response != nullptr ? value(*response) : nothing;
}

constexpr Column all_columns[] = {
    {"Azimuth (m)", "Expected position of the target's image", 3, false,
     [](const workflow::MeasuredTarget& t) { return t.theory.place.azimuth_m; }},
    {"Range (m)", "Expected position of the target's image", 3, false,
     [](const workflow::MeasuredTarget& t) { return t.theory.place.range_m; }},
    {"Offset az. (m)", "Measured minus expected position, in azimuth", 4, true,
     [](const workflow::MeasuredTarget& t) {
       return if_found(t, [&](const auto& r) { return r.place.azimuth_m - t.theory.place.azimuth_m; });
     }},
    {"Offset rg. (m)", "Measured minus expected position, in range", 4, true,
     [](const workflow::MeasuredTarget& t) {
       return if_found(t, [&](const auto& r) { return r.place.range_m - t.theory.place.range_m; });
     }},
    {"Width az. (m)", "-3 dB width in azimuth", 3, false,
     [](const workflow::MeasuredTarget& t) { return if_found(t, [](const auto& r) { return r.azimuth.width; }); }},
    {"Width rg. (m)", "-3 dB width in range", 3, false,
     [](const workflow::MeasuredTarget& t) { return if_found(t, [](const auto& r) { return r.range.width; }); }},
    {"PSLR az. (dB)", "Peak sidelobe ratio in azimuth", 2, false,
     [](const workflow::MeasuredTarget& t) { return if_found(t, [](const auto& r) { return r.azimuth.pslr_db; }); }},
    {"PSLR rg. (dB)", "Peak sidelobe ratio in range", 2, false,
     [](const workflow::MeasuredTarget& t) { return if_found(t, [](const auto& r) { return r.range.pslr_db; }); }},
    {"ISLR az. (dB)", "Integrated sidelobe ratio in azimuth", 2, false,
     [](const workflow::MeasuredTarget& t) { return if_found(t, [](const auto& r) { return r.azimuth.islr_db; }); }},
    {"ISLR rg. (dB)", "Integrated sidelobe ratio in range", 2, false,
     [](const workflow::MeasuredTarget& t) { return if_found(t, [](const auto& r) { return r.range.islr_db; }); }},
    {"SNR (dB)", "Peak power over the noise power of the image", 1, false,
     [](const workflow::MeasuredTarget& t) { return t.outside || !std::isfinite(t.snr_db()) ? nothing : t.snr_db(); }},
};

std::string words_of(const Column& column, double value) {
  if (!std::isfinite(value)) return {};
  return column.has_sign ? fmt::format("{:+.{}f}", value, column.digits) : fmt::format("{:.{}f}", value, column.digits);
}

std::string state_of(const workflow::MeasuredTarget& target) {
  if (target.outside) return target.theory.unrecorded ? "outside the recorded ranges" : "outside the image";
  if (!target.expected()) return "no echoes";
  return target.found ? "found" : to_string(target.state);
}

TargetTable::Row row_of(const workflow::MeasuredTarget& target) {
  TargetTable::Row row;
  row.target = target.theory.target + 1;
  row.expected = target.theory.place;
  row.inside = target.expected() && !target.outside;
  row.found = target.found.has_value();
  row.words = {std::to_string(row.target), state_of(target)};
  row.values = {static_cast<double>(row.target), nothing};
  for (const Column& column : all_columns) {
    const double value = column.value(target);
    row.words.push_back(words_of(column, value));
    row.values.push_back(value);
  }
  return row;
}

}  // namespace

TargetTable target_table(const workflow::MeasureReport& report) {
  TargetTable table;
  table.columns = {"Target", "State"};
  table.meanings = {"Its number in the script", "Whether the peak has the expected position and strength"};
  for (const Column& column : all_columns) {
    table.columns.emplace_back(column.heading);
    table.meanings.emplace_back(column.meaning);
  }
  for (const workflow::MeasuredTarget& target : report.targets) table.rows.push_back(row_of(target));
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

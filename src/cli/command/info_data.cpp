#include "cli/command/info_data.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "cli/shell/report.hpp"
#include "cli/shell/watch.hpp"
#include "core/build/version.hpp"
#include "core/text/facts.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/sample_facts.hpp"

namespace sarsim::cli {

namespace {

constexpr std::size_t longest_attribute = 60;

std::string quantity(double value, bool counts) {
  return counts ? fmt::format("{:.9g}", value) : fmt::format("{:.6g} V", value);
}

core::Facts facts_of_shape(const workflow::SampleFacts& facts) {
  const raster::RasterInfo& info = facts.file->info();
  const auto rows = static_cast<double>(facts.rows);
  core::Facts f{{"format", "format", raster::word_of(*info.format)}};
  if (facts.rows_estimated)
    f.push_back(core::worded("rows_estimated", "rows", rows,
                             fmt::format("about {:.2g} (a text has no header; --statistics counts them)", rows)));
  else
    f.push_back(core::worded("rows", "rows", rows, std::to_string(facts.rows)));
  f.push_back(
      core::worded("columns", "samples of a row", static_cast<double>(info.columns), std::to_string(info.columns)));
  f.push_back({"values", "values", info.counts ? "counts" : "volts"});
  if (info.bits > 0) f.push_back({"bits", "A/D bits", info.bits});
  if (info.lsb_v) f.push_back(core::worded("lsb_v", "LSB", *info.lsb_v, fmt::format("{:.6G} mV", 1e3 * *info.lsb_v)));
  if (info.sample_rate_hz) f.push_back({"sample_rate_hz", "sampling rate", *info.sample_rate_hz, "Hz"});
  return f;
}

void add_axis(core::Facts& facts, const char* label, const std::string& key, std::string_view unit,
              const std::vector<double>& axis) {
  if (axis.empty()) return;
  const std::string suffix = "_" + std::string(unit == "Hz" ? "hz" : unit);
  append(facts, {core::worded("first_" + key + suffix, label, axis.front(),
                              core::with_prefix(axis.front(), unit) + " to " + core::with_prefix(axis.back(), unit)),
                 {"last_" + key + suffix, "", axis.back()}});
}

core::Facts facts_of_axes(const raster::Raster& file) {
  core::Facts f;
  const std::optional<raster::RasterAxes> axes = file.axes();
  if (!axes) return f;
  add_axis(f, "send times", "time", "s", axes->row_time_s);
  add_axis(f, "carriers", "carrier", "Hz", axes->row_carrier_hz);
  if (!axes->row_m.empty())
    add_axis(f, axes->row_axis == "cross_range_m" ? "cross-range" : "azimuth", "row", "m", axes->row_m);
  const bool ground = axes->column_axis == "ground_range_m";
  add_axis(f, ground ? "ground ranges" : "slant ranges", "range", "m", axes->column_range_m);
  return f;
}

core::Facts facts_of_statistics(const signal::SampleStatistics& s, bool counts) {
  const double samples = std::max(1.0, static_cast<double>(s.samples));
  const auto number = [](auto count) { return static_cast<double>(count); };
  core::Facts f{core::worded("lowest", "lowest I or Q", s.lowest, quantity(s.lowest, counts)),
                core::worded("highest", "highest I or Q", s.highest, quantity(s.highest, counts)),
                core::worded("rms", "rms magnitude", s.rms(), quantity(s.rms(), counts)),
                core::worded("largest_magnitude", "largest magnitude", s.largest_magnitude,
                             fmt::format("{} in row {}, column {} (from 0)", quantity(s.largest_magnitude, counts),
                                         s.largest_row, s.largest_column)),
                {"largest_row", "", number(s.largest_row)},
                {"largest_column", "", number(s.largest_column)},
                core::worded("zero_share", "zero samples", number(s.zeros) / samples,
                             fmt::format("{} ({:.4g} %)", s.zeros, 100.0 * number(s.zeros) / samples))};
  if (s.not_finite > 0)
    f.push_back(core::worded("not_finite", "not finite", number(s.not_finite), std::to_string(s.not_finite)));
  return f;
}

std::string shown(const std::pair<std::string, std::string>& attribute) {
  const std::size_t line = attribute.second.find_first_of("\r\n");
  if (line == std::string::npos && attribute.second.size() <= longest_attribute) return attribute.second;
  return fmt::format("({} bytes of text; --json shows them)", attribute.second.size());
}

std::string text_of(const std::string& path, const raster::RasterInfo& info, const core::Facts& facts) {
  std::error_code failure;
  const auto bytes = std::filesystem::file_size(path, failure);
  std::string text = failure ? path + "\n" : path + ", " + core::bytes_text(static_cast<double>(bytes)) + "\n";
  text += core::text_of(facts);
  if (!info.attributes.empty()) text += "attributes\n";
  for (const auto& attribute : info.attributes)
    text += core::printable(fmt::format("  {:<24} {}\n", attribute.first, shown(attribute)));
  return text;
}

std::string json_of(const std::string& path, const raster::RasterInfo& info, const core::Facts& facts) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("file", path);
  core::write_json(json, facts);
  json.key("attributes").begin_object();
  for (const auto& [name, value] : info.attributes) json.member(name, value);
  json.end_object().end_object();
  return json.text();
}

}  // namespace

ExitStatus print_data_info(const DataInfoArguments& arguments, Streams& streams) {
  Watch watch(streams, false);
  const workflow::SampleFacts facts =
      workflow::facts_of_samples(arguments.path, arguments.sample, arguments.statistics, watch.observer());
  const raster::RasterInfo& info = facts.file->info();
  core::Facts told = facts_of_shape(facts);
  append(told, facts_of_axes(*facts.file));
  if (facts.statistics) append(told, facts_of_statistics(*facts.statistics, info.counts));
  write_out(streams, arguments.json ? json_of(arguments.path, info, told) : text_of(arguments.path, info, told));
  return exit_done;
}

}  // namespace sarsim::cli

#include "cli/command/info_data.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "cli/shell/figures.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/watch.hpp"
#include "core/build/version.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/sample_facts.hpp"

namespace sarsim::cli {

namespace {

constexpr std::size_t longest_attribute = 60;

std::string quantity(double value, bool counts) {
  return counts ? fmt::format("{:.9g}", value) : fmt::format("{:.6g} V", value);
}

std::vector<Figure> shape_figures(const workflow::SampleFacts& facts) {
  const raster::RasterInfo& info = facts.file->info();
  std::vector<Figure> f;
  f.push_back(word_figure("format", "format", raster::word_of(*info.format)));
  const auto rows = static_cast<double>(facts.rows);
  if (facts.rows_estimated)
    f.push_back(figure("rows", "rows_estimated", rows,
                       fmt::format("about {:.2g} (a text has no header; --statistics counts them)", rows)));
  else
    f.push_back(figure("rows", "rows", rows, std::to_string(facts.rows)));
  f.push_back(figure("samples of a row", "columns", static_cast<double>(info.columns), std::to_string(info.columns)));
  f.push_back(word_figure("values", "values", info.counts ? "counts" : "volts"));
  if (info.bits > 0) f.push_back(figure("A/D bits", "bits", info.bits));
  if (info.lsb_v) f.push_back(figure("LSB", "lsb_v", *info.lsb_v, fmt::format("{:.6G} mV", 1e3 * *info.lsb_v)));
  if (info.sample_rate_hz) f.push_back(si_figure("sampling rate", "sample_rate_hz", *info.sample_rate_hz, "Hz"));
  return f;
}

void add_axis(std::vector<Figure>& figures, const char* label, const std::string& key, std::string_view unit,
              const std::vector<double>& axis) {
  if (axis.empty()) return;
  const std::string suffix = "_" + std::string(unit == "Hz" ? "hz" : unit);
  figures.push_back(figure(label, "first_" + key + suffix, axis.front(),
                           core::with_prefix(axis.front(), unit) + " to " + core::with_prefix(axis.back(), unit)));
  figures.push_back({"", "", "last_" + key + suffix, axis.back(), {}});
}

std::vector<Figure> axis_figures(const raster::Raster& file) {
  std::vector<Figure> f;
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

std::vector<Figure> statistics_figures(const signal::SampleStatistics& s, bool counts) {
  std::vector<Figure> f;
  f.push_back(figure("lowest I or Q", "lowest", s.lowest, quantity(s.lowest, counts)));
  f.push_back(figure("highest I or Q", "highest", s.highest, quantity(s.highest, counts)));
  f.push_back(figure("rms magnitude", "rms", s.rms(), quantity(s.rms(), counts)));
  f.push_back(figure("largest magnitude", "largest_magnitude", s.largest_magnitude,
                     fmt::format("{} in row {}, column {} (from 0)", quantity(s.largest_magnitude, counts),
                                 s.largest_row, s.largest_column)));
  f.push_back({"", "", "largest_row", static_cast<double>(s.largest_row), {}});
  f.push_back({"", "", "largest_column", static_cast<double>(s.largest_column), {}});
  const double samples = std::max(1.0, static_cast<double>(s.samples));
  f.push_back(figure("zero samples", "zero_share", static_cast<double>(s.zeros) / samples,
                     fmt::format("{} ({:.4g} %)", s.zeros, 100.0 * static_cast<double>(s.zeros) / samples)));
  if (s.not_finite > 0)
    f.push_back(figure("not finite", "not_finite", static_cast<double>(s.not_finite), std::to_string(s.not_finite)));
  return f;
}

std::string shown(const std::pair<std::string, std::string>& attribute) {
  const std::size_t line = attribute.second.find_first_of("\r\n");
  if (line == std::string::npos && attribute.second.size() <= longest_attribute) return attribute.second;
  return fmt::format("({} bytes of text; --json shows them)", attribute.second.size());
}

std::string text_of(const std::string& path, const raster::RasterInfo& info, std::vector<Figure> figures) {
  std::erase_if(figures, [](const Figure& f) { return f.label.empty(); });
  std::error_code failure;
  const auto bytes = std::filesystem::file_size(path, failure);
  std::string text = failure ? path + "\n" : path + ", " + core::bytes_text(static_cast<double>(bytes)) + "\n";
  text += figures_text(figures);
  if (!info.attributes.empty()) text += "attributes\n";
  for (const auto& attribute : info.attributes)
    text += core::printable(fmt::format("  {:<24} {}\n", attribute.first, shown(attribute)));
  return text;
}

std::string json_of(const std::string& path, const raster::RasterInfo& info, const std::vector<Figure>& figures) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("file", path);
  write_json(json, figures);
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
  std::vector<Figure> figures = shape_figures(facts);
  std::ranges::move(axis_figures(*facts.file), std::back_inserter(figures));
  if (facts.statistics)
    std::ranges::move(statistics_figures(*facts.statistics, info.counts), std::back_inserter(figures));
  write_out(streams, arguments.json ? json_of(arguments.path, info, figures) : text_of(arguments.path, info, figures));
  return exit_done;
}

}  // namespace sarsim::cli

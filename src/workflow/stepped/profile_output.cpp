#include "workflow/stepped/profile_output.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "core/os/output_file.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "radar/receiver/converter.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/raster_writer.hpp"
#include "workflow/image/image_output.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

constexpr int count_bits = 16;

void look_at(const core::StopFlag* stop) {
  if (stop != nullptr && stop->requested()) throw core::Interrupted();
}

std::string listed(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    if (!text.empty()) text += ", ";
    core::append_number(text, number);
  }
  return text;
}

raster::EnviHeader header_of(const ProfileSeries& series, const ProfileOrigin& origin) {
  raster::EnviHeader header;
  header.samples = series.axis.count;
  header.lines = series.rows.size();
  header.description = fmt::format("Synthetic range profiles by sarsim {}: lines are {}, samples are slant ranges",
                                   core::program_version, origin.set);
  std::vector<double> times;
  for (const ProfileRow& row : series.rows) times.push_back(row.time_s);
  header.fields = {{"range first m", core::format_number(series.axis.first_m)},
                   {"range step m", core::format_number(series.axis.step_m)},
                   {"time s", listed(times)},
                   {"carrier hz", core::format_number(series.centre_hz)},
                   {"bandwidth hz", core::format_number(series.band_hz)},
                   {"light speed mps", core::format_number(origin.light_speed_mps)},
                   {"source", origin.source},
                   {"script", origin.script},
                   {"settings", origin.settings},
                   {"simulation", fmt::format("{}", origin.simulation + 1)},
                   {"velocity", origin.velocity},
                   {"window", origin.window}};
  if (!origin.aspects_rad.empty()) {
    std::vector<double> degrees;
    for (const double aspect : origin.aspects_rad) degrees.push_back(core::deg_per_rad * aspect);
    header.fields.emplace_back("aspect deg", listed(degrees));
  }
  return header;
}

void write_envi(const ProfileSeries& series, const ProfileOrigin& origin, const fs::path& path, bool replace,
                const core::StopFlag* stop) {
  raster::EnviWriter writer(path, header_of(series, origin), replace);
  std::vector<std::complex<float>> row(series.axis.count);
  for (std::size_t r = 0; r < series.rows.size(); ++r) {
    look_at(stop);
    std::ranges::transform(series.row(r), row.begin(), [](const auto& v) { return std::complex<float>(v); });
    writer.append(row);
  }
  writer.finish();
}

std::string column_name(const ProfileRow& row, const std::string& set) {
  if (set == "encounter") return "encounter_v";
  if (set == "scans") return fmt::format("scan_{}_v", row.scan + 1);
  return fmt::format("burst_{}_v", row.burst + 1);
}

void write_csv(const ProfileSeries& series, const ProfileOrigin& origin, const fs::path& path, bool replace,
               const core::StopFlag* stop) {
  core::OutputFile file(path, replace);
  const auto put = [&file](const std::string& text) { file.write(std::as_bytes(std::span(text))); };
  std::string line = "range_m";
  for (const ProfileRow& row : series.rows) {
    line += ',';
    line += column_name(row, origin.set);
  }
  put(line + "\n");
  for (std::size_t k = 0; k < series.axis.count; ++k) {
    look_at(stop);
    line = core::format_number(series.axis.at(static_cast<double>(k)));
    for (std::size_t r = 0; r < series.rows.size(); ++r) {
      line += ',';
      core::append_number(line, std::abs(series.row(r)[k]));
    }
    put(line + "\n");
  }
  file.commit();
}

raster::Product product_of(const ProfileSeries& series, const ProfileOrigin& origin) {
  raster::Product product;
  product.radar = origin.radar;
  product.options = origin.run;
  product.processing = scene::Processing::srp;
  product.rows = series.rows.size();
  product.columns = series.axis.count;
  std::vector<double> times;
  for (const ProfileRow& row : series.rows) times.push_back(row.time_s);
  product.row_time_s = [times](std::size_t row) { return times[row]; };
  product.row_carrier_hz = [carrier = series.centre_hz](std::size_t) { return carrier; };
  product.column_range_m = [axis = series.axis](std::size_t column) { return axis.at(static_cast<double>(column)); };
  product.sample_rate_hz = radar::frequency_of_turns(1.0, series.axis.step_m, origin.light_speed_mps);
  product.bits = count_bits;
  product.engine = "profiles";
  return product;
}

void write_samples(const ProfileSeries& series, const ProfileOrigin& origin, scene::FileFormat format,
                   const fs::path& path, bool replace, const core::StopFlag* stop) {
  raster::Product product = product_of(series, origin);
  raster::RunReport report;
  report.rows = product.rows;
  report.columns = product.columns;
  for (const auto& value : series.values) report.maximum_v = std::max(report.maximum_v, std::abs(value));
  product.lsb_v = report.maximum_v > 0.0 ? report.maximum_v / radar::full_scale_count(count_bits) : 1.0;
  report.lsb_v = report.best_lsb_v = product.lsb_v;
  report.range_used = report.maximum_v / (product.lsb_v * radar::full_scale_count(count_bits));
  raster::RasterWriter writer(raster::make_sink(path, product, {.format = format, .replace = replace}), product.columns,
                              {count_bits, product.lsb_v});
  for (std::size_t r = 0; r < product.rows; ++r) {
    look_at(stop);
    writer.append(series.row(r));
  }
  writer.finish(report);
}

}  // namespace

InMemoryImage kept_profiles(const ProfileSeries& series, const ProfileOrigin& origin) {
  const auto held = std::make_shared<const ProfileSeries>(series);
  InMemoryImage kept{{header_of(series, origin), product_of(series, origin)}, {}};
  kept.rows = {series.rows.size(), series.axis.count, [held](std::size_t row, std::span<std::complex<float>> out) {
                 std::ranges::transform(held->row(row), out.begin(),
                                        [](const auto& value) { return std::complex<float>(value); });
               }};
  kept.write = [held, origin](const fs::path& path, bool replace, const core::StopFlag* stop) {
    write_profiles(*held, origin, path, replace, stop);
  };
  return kept;
}

std::vector<fs::path> files_of_profiles(const fs::path& path) {
  workflow::expect_image_ending(path, "--out");
  workflow::expect_no_sicd(path, "--out");
  if (!workflow::is_envi(path)) return {path};
  return {path, fs::path(path).replace_extension(".hdr")};
}

void write_profiles(const ProfileSeries& series, const ProfileOrigin& origin, const fs::path& path, bool replace,
                    const core::StopFlag* stop) {
  const auto format = raster::format_from_path(path);
  if (!format) return write_envi(series, origin, path, replace, stop);
  if (raster::format_of(*format).spreadsheet) return write_csv(series, origin, path, replace, stop);
  write_samples(series, origin, *format, path, replace, stop);
}

}  // namespace sarsim::workflow

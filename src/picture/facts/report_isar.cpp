#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "picture/facts/report_parts.hpp"
#include "workflow/stepped/isar.hpp"

namespace sarsim::picture {

namespace {

// A number of an image.
struct ImageFact {
  const char* name;
  double value;
  const char* unit;
  bool prefix = true;
};

std::vector<ImageFact> facts_of_image(const workflow::IsarImage& made) {
  return {{"Time from", made.from_s, "s"},
          {"Time to", made.to_s, "s"},
          {"Cross-range from", made.image.azimuth.first_m, "m"},
          {"Cross-range spacing", made.image.azimuth.step_m, "m"},
          {"Range from", made.image.range.first_m, "m"},
          {"Range spacing", made.image.range.step_m, "m"},
          {"Range of the centre", made.range_m, "m"},
          {"Speed of the centre", made.speed_mps, "m/s"},
          {"Turned by", made.turn_rad * 180.0 / core::pi, "deg", false},
          {"Resolution in cross-range", made.cross_range_resolution_m, "m"},
          {"Resolution in range", made.range_resolution_m, "m"},
          {"Unambiguous cross-range", made.unambiguous_cross_range_m, "m"}};
}

void add_image(report::Facts& facts, const workflow::WrittenIsarImage& written) {
  facts.word("Bursts", fmt::format("{} to {}", written.first_burst + 1, written.first_burst + written.bursts));
  facts.count("Rows, along cross-range", written.image.image.azimuth.count, "pixels");
  facts.count("Columns, along range", written.image.image.range.count, "pixels");
  for (const ImageFact& fact : facts_of_image(written.image))
    fact.prefix ? facts.number(fact.name, fact.value, fact.unit) : facts.plain(fact.name, fact.value, fact.unit);
}

ReportTable images_table(const workflow::IsarReport& made) {
  ReportTable table{"Images", {"Image", "First burst", "Last burst", "Rows", "Columns"}, {}};
  for (const ImageFact& fact : facts_of_image(made.images.front().image))
    table.columns.push_back(fmt::format("{} ({})", fact.name, fact.unit));
  for (std::size_t i = 0; i < made.images.size(); ++i) {
    const workflow::WrittenIsarImage& written = made.images[i];
    std::vector<std::string> row{fmt::format("{}", i + 1), fmt::format("{}", written.first_burst + 1),
                                 fmt::format("{}", written.first_burst + written.bursts),
                                 fmt::format("{}", written.image.image.azimuth.count),
                                 fmt::format("{}", written.image.image.range.count)};
    for (const ImageFact& fact : facts_of_image(written.image)) row.push_back(report::six_digits(fact.value));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<std::string> point_row(std::size_t image, const workflow::HeldPoint& point) {
  std::vector<std::string> row{fmt::format("{}", image + 1), fmt::format("{}", point.target + 1),
                               report::fixed(point.expected.azimuth_m, 3), report::fixed(point.expected.range_m, 3)};
  if (!point.found) {
    row.emplace_back(point.outside ? "outside the image" : report::no_peak);
    return row;
  }
  const signal::PointResponse& found = *point.found;
  row.insert(row.end(), {report::fixed(found.place.azimuth_m - point.expected.azimuth_m, 3),
                         report::fixed(found.place.range_m - point.expected.range_m, 3),
                         report::fixed(found.azimuth.width, 3), report::fixed(found.range.width, 3),
                         report::fixed(core::amplitude_db(found.amplitude / point.amplitude), 2)});
  return row;
}

ReportTable points_table(const workflow::IsarReport& made) {
  ReportTable table{"Targets",
                    {"Image", "Target", "Cross-range (m)", "Range (m)", "Error in cross-range (m)",
                     "Error in range (m)", "Width in cross-range (m)", "Width in range (m)", "Error (dB)"},
                    {}};
  for (std::size_t i = 0; i < made.images.size(); ++i)
    for (const workflow::HeldPoint& point : made.images[i].image.points) {
      table.rows.push_back(point_row(i, point));
      table.rows.back().resize(table.columns.size());
    }
  return table;
}

}  // namespace

ReportPages pages_of(const workflow::IsarReport& made) {
  report::Facts facts;
  facts.count("Simulation", made.simulation + 1);
  facts.word("Algorithm", made.algorithm.substr(made.algorithm.starts_with("isar-") ? 5 : 0));
  facts.count("Images", made.images.size());
  if (made.images.size() == 1) add_image(facts, made.images.front());
  facts.time(made.seconds);
  ReportPages pages;
  pages.tables.push_back(facts.take());
  if (made.images.size() > 1) pages.tables.push_back(images_table(made));
  ReportTable points = points_table(made);
  if (!points.rows.empty()) pages.tables.push_back(std::move(points));
  return pages;
}

}  // namespace sarsim::picture

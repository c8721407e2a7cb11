#include "workflow/stepped/stepped_report.hpp"

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::workflow {

namespace {

using core::Facts;
using core::fixed;
using core::only;
using core::significant;

// What people read of a target that has no place or no peak.
const char* missing(bool found, bool outside, const char* words_outside) {
  return found ? "" : outside ? words_outside : "no peak";
}

Facts facts_of(const signal::ProfilePeak& peak) {
  return {{"range_m", "Range", peak.range_m, "m", fixed(3)},
          {"amplitude_v", "Amplitude", peak.amplitude, "V"},
          {"phase_rad", "Phase", peak.phase_rad, "rad", fixed(3)},
          {"width_m", "Width", peak.width_m, "m", fixed(3)}};
}

template <class Item, class... More>
core::FactRows rows_of(const std::vector<Item>& items, More... more) {
  core::FactRows rows;
  for (const Item& item : items) rows.push_back(facts_of(item, more...));
  return rows;
}

const char* word_of_speed(SeriesOptions::Velocity velocity) {
  using Velocity = SeriesOptions::Velocity;
  switch (velocity) {
    case Velocity::given: return "as given";
    case Velocity::scene: return "of the scene's targets";
    case Velocity::estimated: return "estimated";
    case Velocity::none: break;
  }
  return "none";
}

Facts facts_of_scan(std::size_t number, const ScanRecord& scan) {
  Facts facts{{"", "Scan", number},
              {"first_burst", "First burst", scan.bursts.first + 1},
              {"last_burst", "Last burst", scan.bursts.last + 1},
              {"from_s", "From", scan.from_s, "s"},
              {"to_s", "To", scan.to_s, "s"},
              {"speed_mps", "Speed", scan.speed_mps, "m/s"}};
  if (scan.estimate)
    append(facts, {{"uncertainty_mps", "Uncertainty", scan.estimate->uncertainty_mps, "m/s"},
                   {"entropy", "Entropy", scan.estimate->entropy, "", fixed(3)},
                   {"entropy_at_rest", "Entropy at rest", scan.estimate->entropy_at_rest, "", fixed(3)}});
  return facts;
}

// The profile that is held against the scene.
Facts facts_of_burst(const ProfilesReport& report) {
  if (report.held_row >= report.series.rows.size()) return {};
  const ProfileRow& row = report.series.rows[report.held_row];
  return {{"burst", "", row.burst + 1},
          {"time_s", "", row.time_s},
          {"targets", fmt::format("Targets in burst {}", row.burst + 1), rows_of(report.targets)},
          {"peaks", fmt::format("Peaks of burst {}", row.burst + 1), rows_of(report.peaks)}};
}

}  // namespace

Facts facts_of(const HeldPoint& point) {
  const bool found = point.found.has_value();
  const signal::PointResponse peak = point.found.value_or(signal::PointResponse{});
  return {
      {"target", "Target", point.target + 1},
      {"cross_range_m", "Cross-range", point.expected.azimuth_m, "m", fixed(3)},
      {"range_m", "Range", point.expected.range_m, "m", fixed(3)},
      {"outside", "", point.outside},
      {"found", "",
       Facts{
           {"cross_range_error_m", "Error in cross-range", only(found, peak.place.azimuth_m - point.expected.azimuth_m),
            "m", fixed(3), missing(found, point.outside, "outside the image")},
           {"range_error_m", "Error in range", only(found, peak.place.range_m - point.expected.range_m), "m", fixed(3)},
           {"cross_range_width_m", "Width in cross-range", only(found, peak.azimuth.width), "m", fixed(3)},
           {"range_width_m", "Width in range", only(found, peak.range.width), "m", fixed(3)},
           {"amplitude_error_db", "Error", only(found, core::amplitude_db(peak.amplitude / point.amplitude)), "dB",
            fixed(2)}}}};
}

Facts facts_of(const WrittenIsarImage& written, bool alone) {
  const IsarImage& made = written.image;
  const std::size_t first = written.first_burst + 1;
  const std::size_t last = written.first_burst + written.bursts;
  return {{"file", "", written.file.string()},
          {"", alone ? "Bursts" : "", fmt::format("{} to {}", first, last)},
          {"first_burst", alone ? "" : "First burst", first},
          {"last_burst", alone ? "" : "Last burst", last},
          {"from_s", "", made.from_s},
          {"to_s", "", made.to_s},
          {"rows", alone ? "Rows, along cross-range" : "Rows", made.image.azimuth.count, alone ? "pixels" : ""},
          {"columns", alone ? "Columns, along range" : "Columns", made.image.range.count, alone ? "pixels" : ""},
          {"", "Time from", made.from_s, "s"},
          {"", "Time to", made.to_s, "s"},
          {"cross_range_first_m", "Cross-range from", made.image.azimuth.first_m, "m"},
          {"cross_range_step_m", "Cross-range spacing", made.image.azimuth.step_m, "m"},
          {"range_first_m", "Range from", made.image.range.first_m, "m"},
          {"range_step_m", "Range spacing", made.image.range.step_m, "m"},
          {"centre_range_m", "Range of the centre", made.range_m, "m"},
          {"speed_mps", "Speed of the centre", made.speed_mps, "m/s"},
          {"turn_rad", "", made.turn_rad},
          {"", "Turned by", made.turn_rad * core::deg_per_rad, "deg", significant(6)},
          {"range_resolution_m", "", made.range_resolution_m},
          {"cross_range_resolution_m", "Resolution in cross-range", made.cross_range_resolution_m, "m"},
          {"", "Resolution in range", made.range_resolution_m, "m"},
          {"unambiguous_cross_range_m", "Unambiguous cross-range", made.unambiguous_cross_range_m, "m"},
          {"targets", "", rows_of(made.points)}};
}

Facts facts_of(const IsarReport& report) {
  const bool alone = report.images.size() == 1;
  const std::string algorithm = report.algorithm.substr(report.algorithm.starts_with("isar-") ? 5 : 0);
  Facts facts{{"sarsim", "", core::program_version},
              {"source", "", report.source},
              {"", "Simulation", report.simulation + 1},
              core::worded("algorithm", "Algorithm", report.algorithm, algorithm),
              {"", "Images", report.images.size()},
              {"files", "", core::texts_of(report.files)},
              {"images", "", rows_of(report.images, alone)},
              core::worded("seconds", "Time taken", report.seconds, core::duration_text(report.seconds)),
              {"problems", "", report.problems}};
  return facts;
}

Facts facts_of(const HeldTarget& target) {
  const bool found = target.found.has_value();
  const signal::ProfilePeak peak = target.found.value_or(signal::ProfilePeak{});
  return {{"target", "Target", target.truth.target + 1},
          {"range_m", "Range", target.truth.range_m, "m", fixed(3)},
          {"speed_mps", "Speed", target.truth.speed_mps, "m/s", fixed(2)},
          {"amplitude_v", "", target.truth.amplitude},
          {"expected_m", "Expected", target.expected_m, "m", fixed(3)},
          {"expected_bin", "Bin", target.expected_bin, "", fixed(2)},
          {"outside", "", target.outside},
          {"smear_cells", "", target.smear_cells},
          {"nearest_target_m", "", target.nearest_m},
          {"found", "",
           Facts{{"range_m", "Found", only(found, peak.range_m), "m", fixed(3),
                  missing(found, target.outside, "outside the profile")},
                 {"range_error_m", "Error", only(found, peak.range_m - target.expected_m), "m", fixed(3)},
                 {"width_m", "Width", only(found, peak.width_m), "m", fixed(3)},
                 {"phase_rad", "", only(found, peak.phase_rad)},
                 {"amplitude_error_db", "Error",
                  only(found, core::amplitude_db(peak.amplitude / target.truth.amplitude)), "dB", fixed(2)}}}};
}

Facts facts_of(const ProfilesReport& report) {
  const ProfileSeries& series = report.series;
  const signal::SteppedLimits& limits = series.limits;
  core::FactRows scans;
  for (const ScanRecord& scan : series.scans) scans.push_back(facts_of_scan(scans.size() + 1, scan));
  Facts facts{{"sarsim", "", core::program_version},
              {"source", "", report.source},
              {"files", "", core::texts_of(report.files)},
              {"", "Simulation", report.simulation + 1},
              {"set", "A profile for", word_of(report.set)},
              {"", "Bursts recorded", report.bursts},
              {"bursts", "Bursts illuminated", series.rows.size()},
              {"", "Scans", series.scans.size()},
              {"", "Speed compensated", word_of_speed(report.velocity)},
              {"columns", "Bins", series.axis.count},
              {"range_first_m", "Range from", series.axis.first_m, "m"},
              {"", "Range to", series.axis.at(static_cast<double>(series.axis.count) - 1.0), "m"},
              {"range_step_m", "Bins apart", series.axis.step_m, "m"},
              {"carrier_hz", "", series.centre_hz},
              {"bandwidth_hz", "Band", series.band_hz, "Hz"},
              {"", "Centre frequency", series.centre_hz, "Hz"},
              {"resolution_m", "Resolution", limits.resolution_m, "m"},
              {"unambiguous_range_m", "Steps repeat every", limits.unambiguous_range_m, "m"},
              {"shift_m_per_mps", "Shift by each m/s", limits.shift_m_per_mps, "m"},
              {"smear_m_per_mps", "Smear by each m/s", limits.smear_m_per_mps, "m"},
              {"tolerable_speed_mps", "Speed that smears half a cell", limits.tolerable_mps, "m/s"},
              {"ambiguous_speed_mps", "Ambiguous speed", limits.ambiguous_mps, "m/s"},
              {"scans", "Scans", std::move(scans)}};
  append(facts, facts_of_burst(report));
  append(facts, {core::worded("seconds", "Time taken", report.seconds, core::duration_text(report.seconds)),
                 {"problems", "", report.problems}});
  return facts;
}

std::string csv_of(const std::vector<HeldTarget>& targets) {
  const auto columns = [](const HeldTarget& target) -> Facts {
    const bool found = target.found.has_value();
    const signal::ProfilePeak peak = target.found.value_or(signal::ProfilePeak{});
    return {{"target", "", target.truth.target + 1},
            {"range_m", "", target.truth.range_m},
            {"speed_mps", "", target.truth.speed_mps},
            {"amplitude_v", "", target.truth.amplitude},
            {"expected_m", "", target.expected_m},
            {"expected_bin", "", target.expected_bin},
            {"smear_cells", "", target.smear_cells},
            {"nearest_target_m", "", target.nearest_m},
            {"found_m", "", only(found, peak.range_m)},
            {"found_width_m", "", only(found, peak.width_m)},
            {"found_phase_rad", "", only(found, peak.phase_rad)},
            {"found_amplitude_v", "", only(found, peak.amplitude)}};
  };
  std::string text = core::csv_names(columns({}));
  for (const HeldTarget& target : targets) text += core::csv_line(columns(target));
  return text;
}

}  // namespace sarsim::workflow

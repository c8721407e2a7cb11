#include "cli/command/part_report.hpp"

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "raster/parts/part_run.hpp"

namespace sarsim::cli {

std::string part_text(const workflow::PartReport& report) {
  const std::string& output = report.file;
  if (report.finished_before) return output + ": finished before; nothing was computed\n";
  if (report.range.count == 0)
    return fmt::format("{}: part {} has none of its {} pulses\n", output, report.part, report.rows);
  std::string text =
      fmt::format("{}: part {}: pulses {} to {} are made, {} of them now, in {}\n", output, report.part,
                  report.range.first + 1, report.range.end(), report.made, core::duration_text(report.seconds));
  if (report.elsewhere)
    text += fmt::format("{}: complete; another part has put it together\n", output);
  else if (!report.whole && report.own_file)
    text += fmt::format("  kept in {}, for sarsim merge\n", raster::parts_folder_of(report.file).string());
  else if (!report.whole)
    text += fmt::format("  {} of {} pulses are there; the last part to finish completes the file\n", report.there,
                        report.rows);
  return text;
}

void write_json(core::JsonWriter& json, const workflow::PartReport& report) {
  json.begin_object().member("kind", "part").member("file", report.file);
  json.member("part", report.part).member("rows", report.rows);
  json.member("first_row", report.range.first).member("part_rows", report.range.count);
  json.member("computed_rows", report.made).member("rejected_rows", report.rejected);
  json.member("rows_there", report.there).member("complete", report.whole.has_value() || report.elsewhere);
  json.member("seconds", report.seconds).member("journal_seconds", report.journal_seconds);
  json.member("journal_entries", report.journal_entries).end_object();
}

}  // namespace sarsim::cli

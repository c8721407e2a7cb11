#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "scene/ephemeris/formats.hpp"
#include "scene/ephemeris/json_records.hpp"
#include "scene/ephemeris/kvn_lines.hpp"
#include "scene/ephemeris/omm_record.hpp"
#include "scene/ephemeris/text_lines.hpp"
#include "scene/ephemeris/xml_scan.hpp"

namespace sarsim::scene::ephemeris {

namespace {

// One cell of a table from the front of a line, with its separator; quotes are taken off. False behind the last.
bool take_cell(std::string_view& line, bool& more, std::string& cell) {
  if (!more) return false;
  cell.clear();
  const bool quoted = core::trimmed(line).starts_with('"');
  if (quoted) {
    line.remove_prefix(line.find('"') + 1);
    while (!line.empty()) {
      const std::size_t end = std::min(line.find('"'), line.size());
      cell += line.substr(0, end);
      line.remove_prefix(std::min(end + 1, line.size()));
      if (!line.starts_with('"')) break;
      cell += '"';
      line.remove_prefix(1);
    }
  }
  const std::size_t end = line.find(',');
  if (!quoted) cell = core::trimmed(line.substr(0, end));
  more = end != std::string_view::npos;
  line.remove_prefix(more ? end + 1 : line.size());
  return true;
}

bool has_more_room(const ReaderInput& input, const MeanElementsFile& file) {
  constexpr std::size_t max_sets = 1'000'000;
  if (input.problems.full()) return false;
  if (file.sets.size() <= max_sets) return true;
  input.problems.error(
      {}, {"the file has too many sets of elements of one satellite", "", fmt::format("at most {}", max_sets), ""});
  return false;
}

}  // namespace

MeanElementsFile read_omm_kvn(const ReaderInput& input) {
  MeanElementsFile file;
  OmmRecord record;
  KvnLines lines(input.text);
  KvnLine line;
  while (has_more_room(input, file) && lines.next(line)) {
    if (line.key == "CCSDS_OMM_VERS") {
      record.finish(input, file);
      record.begin(line.line);
      static_cast<void>(read_version(line, 3, input.problems));
    } else if (line.key.empty() && line.line != "META_START" && line.line != "META_STOP") {
      input.problems.error(line.line, {"the line is none of an OMM", core::clipped(line.line), "KEYWORD = value", ""});
    } else if (line.value.empty()) {
      record.miss_value(omm_key_of(line.key), line.line, input.problems);
    } else {
      record.set(omm_key_of(line.key), std::string(line.value), line.line, line.unit, input.problems);
    }
  }
  record.finish(input, file);
  finish_elements(input, file);
  return file;
}

MeanElementsFile read_omm_xml(const ReaderInput& input) {
  MeanElementsFile file;
  OmmRecord record;
  XmlScan scan(input.text, input.problems);
  std::string_view unit;
  std::string_view opened;  // an element that nothing was seen in yet
  while (has_more_room(input, file)) {
    const XmlEvent event = scan.next();
    if (event == XmlEvent::end) break;
    if (event == XmlEvent::open) {
      if (scan.name() == "omm") record.begin(scan.name());
      unit = scan.attribute("units");
      opened = scan.name();
    } else if (event == XmlEvent::close) {
      if (!opened.empty() && scan.name() == opened) record.miss_value(omm_key_of(opened), scan.name(), input.problems);
      opened = {};
      if (scan.name() == "omm") {
        record.finish(input, file);
        record.begin({});
      }
    } else {
      opened = {};
      const auto plain = without_entities(scan.text());
      if (plain)
        record.set(omm_key_of(scan.name()), *plain, scan.text(), unit, input.problems);
      else
        input.problems.error(scan.text(), {"an entity is not known", core::clipped(scan.text()),
                                           "&amp;, &lt;, &gt;, &quot;, &apos; or the number of a character", ""});
    }
  }
  finish_elements(input, file);
  return file;
}

MeanElementsFile read_omm_csv(const ReaderInput& input) {
  MeanElementsFile file;
  OmmRecord record;
  TextLines lines(input.text);
  std::vector<OmmKey> keys;
  std::string_view line;
  std::string cell;
  if (lines.next_filled(line)) {
    bool more = true;
    while (take_cell(line, more, cell)) keys.push_back(omm_key_of(cell));
  }
  while (has_more_room(input, file) && lines.next_filled(line)) {
    const std::string_view whole = line;
    record.begin(whole);
    bool more = true;
    std::size_t column = 0;
    for (std::string_view at = line; take_cell(line, more, cell); at = line, ++column)
      if (column < keys.size()) record.set(keys[column], cell, at, {}, input.problems);
    if (column == keys.size())
      record.finish(input, file);
    else
      input.problems.error(whole, {"the line has another number of cells than the first one",
                                   fmt::format("{} cells", column), fmt::format("{}", keys.size()), ""});
  }
  finish_elements(input, file);
  return file;
}

MeanElementsFile read_omm_json(const ReaderInput& input) {
  MeanElementsFile file;
  OmmRecord record;
  JsonRecords records(input.text, input.problems);
  while (has_more_room(input, file)) {
    const JsonEvent event = records.next();
    if (event == JsonEvent::end) break;
    if (event == JsonEvent::open)
      record.begin(records.at());
    else if (event == JsonEvent::member)
      record.set(omm_key_of(records.member().key), records.member().value, records.member().at, {}, input.problems);
    else
      record.finish(input, file);
  }
  finish_elements(input, file);
  return file;
}

}  // namespace sarsim::scene::ephemeris

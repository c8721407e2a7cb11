#include "scene/ephemeris/read_ephemeris.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "scene/ephemeris/formats.hpp"
#include "scene/ephemeris/text_lines.hpp"

namespace sarsim::scene {

namespace ephemeris {

namespace {

// As much of a text as tells its format.
constexpr std::size_t head_bytes = std::size_t{1} << 16U;

OrbitFormat format_of_xml(std::string_view head) {
  const auto holds = [&](std::string_view tag) { return head.find(tag) != std::string_view::npos; };
  if (holds("<Earth_Explorer_File")) return OrbitFormat::eof;
  if (holds("<omm")) return OrbitFormat::omm_xml;
  if (holds("<oem") || holds("<ndm:oem")) return OrbitFormat::oem_xml;
  if (holds("<aem") || holds("<opm") || holds("<ocm") || holds("<ndm")) return OrbitFormat::other_ndm;
  if (holds("<OSV>") || holds("<List_of_OSVs")) return OrbitFormat::eof;
  return OrbitFormat::unknown;
}

OrbitFormat format_of_kvn(std::string_view line) {
  if (line.starts_with("CCSDS_OEM_VERS")) return OrbitFormat::oem;
  if (line.starts_with("CCSDS_OMM_VERS")) return OrbitFormat::omm_kvn;
  if (line.starts_with("CCSDS_AEM_VERS")) return OrbitFormat::aem;
  return OrbitFormat::other_ndm;
}

bool is_sp3(std::string_view line) {
  return line.size() > 6 && line[0] == '#' && core::lower(line[1]) >= 'a' && core::lower(line[1]) <= 'd' &&
         (line[2] == 'P' || line[2] == 'V') && core::is_digit(line[3]) && core::is_digit(line[6]);
}

bool is_first_tle_line(std::string_view line) { return line.size() > 40 && line.starts_with("1 "); }

// Whether the two lines of a set of elements follow somewhere.
bool holds_elements(TextLines lines) {
  std::string_view line;
  bool first = false;
  while (lines.next_filled(line)) {
    if (first && line.size() > 40 && line.starts_with("2 ")) return true;
    first = is_first_tle_line(line);
  }
  return false;
}

// A line of numbers, or of the names of columns.
bool is_table(std::string_view line) {
  const char first = line.front();
  if (core::is_digit(first) || first == '-' || first == '+' || first == '.')
    return line.find_first_of(",; \t") != std::string_view::npos;
  const std::size_t end = line.find_first_of(",;\t ");
  if (end == std::string_view::npos) return false;
  const std::string name = core::lower_case(line.substr(0, std::min<std::size_t>(end, 12)));
  for (const std::string_view known : {"t", "time", "\"t\"", "\"time\"", "utc", "epoch"})
    if (name.starts_with(known)) return line.find_first_of("xX") != std::string_view::npos;
  return false;
}

ProblemWords unknown_file(const char* expected) {
  return {"the format of the file is not known", "", expected, "the first lines of a file tell its format"};
}

// Problems of the text as a whole; true where it can be read.
bool check_text(std::string_view text, FileProblems& problems) {
  const std::string_view head = text.substr(0, head_bytes);
  if (text.size() > longest_ephemeris_text)
    problems.error({}, {"the file is too long", fmt::format("{} bytes", text.size()),
                        fmt::format("at most {}", longest_ephemeris_text), "leave out the states that are not needed"});
  else if (core::trimmed(head).empty())
    problems.error({}, {"the file is empty", "", "an orbit or an attitude", ""});
  else if (head.find('\0') != std::string_view::npos)
    problems.error({}, {"the file is not a text of single bytes", "", "a text in ASCII or UTF-8", ""});
  else if (head.find('\r') != std::string_view::npos && text.find('\n') == std::string_view::npos)
    problems.error({}, {"the lines end with carriage returns alone", "", "lines that end with a line feed", ""});
  return !problems.has_errors();
}

// One format that may be read, and its reader.
template <class File>
struct FormatReader {
  OrbitFormat format;
  File (*read)(const ReaderInput&);
};

template <class File>
core::Problems read_as(std::string_view text, const std::string& name, const EphemerisOptions& options,
                       std::initializer_list<FormatReader<File>> readers, const char* expected, File& file) {
  FileProblems problems(text, name);
  if (!check_text(text, problems)) return problems.take();
  const OrbitFormat format = orbit_format_of(text);
  const auto* const reader = std::ranges::find(readers, format, &FormatReader<File>::format);
  if (reader == readers.end()) {
    const std::string_view first = text.substr(0, 0);
    if (format == OrbitFormat::unknown)
      problems.error(first, unknown_file(expected));
    else
      problems.error(first,
                     {fmt::format("the file is {}, which cannot be used here", name_of(format)), "", expected, ""});
    return problems.take();
  }
  SatelliteChoice choice(options.satellite);
  file = reader->read({text, choice, problems, options.without_earth});
  return problems.take();
}

}  // namespace

}  // namespace ephemeris

std::string_view name_of(OrbitFormat format) {
  switch (format) {
    case OrbitFormat::unknown: return "a file of an unknown format";
    case OrbitFormat::eof: return "a Sentinel-1 orbit file";
    case OrbitFormat::oem: return "a CCSDS OEM";
    case OrbitFormat::oem_xml: return "a CCSDS OEM in XML";
    case OrbitFormat::sp3: return "an SP3 file";
    case OrbitFormat::csv: return "a table of times and positions";
    case OrbitFormat::tle: return "a file of two-line elements";
    case OrbitFormat::omm_kvn: return "a CCSDS OMM";
    case OrbitFormat::omm_xml: return "a CCSDS OMM in XML";
    case OrbitFormat::omm_csv: return "a CCSDS OMM as a table";
    case OrbitFormat::omm_json: return "a CCSDS OMM in JSON";
    case OrbitFormat::aem: return "a CCSDS AEM";
    case OrbitFormat::other_ndm: return "a CCSDS message of another kind or form";
  }
  return "";
}

std::string what_is_no_orbit(std::string_view text, OrbitFormat format) {
  if (format == OrbitFormat::aem) return "a CCSDS AEM, which holds attitudes";
  constexpr std::size_t most = 200;
  const std::string first = core::lower_case(text.substr(0, std::min(text.find('\n'), most)));
  const bool on_earth = first.find("lat") != std::string::npos && first.find("lon") != std::string::npos;
  return on_earth ? "columns of latitude and longitude, which are not read" : "";
}

OrbitFormat orbit_format_of(std::string_view text) {
  using namespace ephemeris;
  const std::string_view head = without_mark(text).substr(0, head_bytes);
  TextLines lines(head);
  std::string_view line;
  for (bool first = true; lines.next_filled(line); first = false) {
    if (first && line.front() == '<') return format_of_xml(head);
    if (first && (line.front() == '{' || line.front() == '['))
      return head.find("MEAN_MOTION") != std::string_view::npos ? OrbitFormat::omm_json : OrbitFormat::unknown;
    if (first && is_sp3(line)) return OrbitFormat::sp3;
    if (line.starts_with("CCSDS_")) return format_of_kvn(line);
    if (line.front() == '#' || line.front() == '!' || line.starts_with("COMMENT")) continue;
    if (is_first_tle_line(line)) return OrbitFormat::tle;
    if (line.find("MEAN_MOTION") != std::string_view::npos && line.find(',') != std::string_view::npos)
      return OrbitFormat::omm_csv;
    // A name, perhaps, with two lines below it; it may look like anything.
    const std::string_view name = line;
    if (lines.next_filled(line) && is_first_tle_line(line)) return OrbitFormat::tle;
    if (holds_elements(lines)) return OrbitFormat::tle;  // Below prose, which its reader reports.
    return is_table(name) ? OrbitFormat::csv : OrbitFormat::unknown;
  }
  return OrbitFormat::unknown;
}

EphemerisReading read_ephemeris(std::string_view text, const std::string& name, const EphemerisOptions& options) {
  using namespace ephemeris;
  EphemerisReading reading;
  reading.problems = read_as<EphemerisFile>(text, name, options,
                                            {{OrbitFormat::eof, &read_eof},
                                             {OrbitFormat::oem, &read_oem},
                                             {OrbitFormat::oem_xml, &read_oem_xml},
                                             {OrbitFormat::sp3, &read_sp3},
                                             {OrbitFormat::csv, &read_csv}},
                                            "positions: a Sentinel-1 orbit file, a CCSDS OEM, SP3, "
                                            "or a table of t, x, y, z",
                                            reading.file);
  return reading;
}

MeanElementsReading read_mean_elements(std::string_view text, const std::string& name,
                                       const EphemerisOptions& options) {
  using namespace ephemeris;
  MeanElementsReading reading;
  reading.problems = read_as<MeanElementsFile>(
      text, name, options,
      {{OrbitFormat::tle, &read_tle},
       {OrbitFormat::omm_kvn, &read_omm_kvn},
       {OrbitFormat::omm_xml, &read_omm_xml},
       {OrbitFormat::omm_csv, &read_omm_csv},
       {OrbitFormat::omm_json, &read_omm_json}},
      "mean elements: two-line elements, or a CCSDS OMM as keyword = value, XML, table or JSON", reading.file);
  return reading;
}

AttitudeReading read_attitude(std::string_view text, const std::string& name, const EphemerisOptions& options) {
  using namespace ephemeris;
  AttitudeReading reading;
  reading.problems = read_as<AttitudeFile>(text, name, options, {{OrbitFormat::aem, &read_aem}},
                                           "an attitude: a CCSDS AEM (keyword = value)", reading.file);
  return reading;
}

}  // namespace sarsim::scene

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "core/task/stop_points.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/grid_raster.hpp"
#include "raster/format/text_raster.hpp"
#include "raster/format/text_rows.hpp"
#include "raster/format/text_start.hpp"
#include "raster/table/count_range.hpp"
#include "raster/table/csv_heading.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t max_reported_rows = 10;
constexpr std::uint64_t index_spacing = 256;  // Bytes between remembered rows, so that the index stays small.
constexpr std::size_t max_values_of_first_row = std::size_t{1} << 25;
constexpr std::size_t numbers_at_once = std::size_t{1} << 16;  // Between two questions for a stop: a millisecond.

// What one reading of the whole text tells.
struct TextSurvey {
  std::unique_ptr<TextIndex> index = std::make_unique<TextIndex>(index_spacing);
  std::size_t rows = 0;
  std::size_t values = 0;  // Of each row.
  TextValues numbers;
  core::Problems problems;
};

core::Problem uneven_row(const TextRow& row, std::size_t index, std::size_t expected, bool last) {
  core::Problem problem;
  problem.place.line = row.line;
  problem.place.column = row.column;
  const bool half = row.values % 2 != 0;
  problem.message = fmt::format("row {} {}", index + 1, half ? "ends with an I that has no Q" : "has another length");
  problem.found = half ? fmt::format("{} numbers", row.values) : fmt::format("{} samples", row.values / 2);
  problem.expected = expected > 0 ? fmt::format("{} samples, as in the first row", expected / 2) : "pairs of I and Q";
  if (last && (expected == 0 || row.values < expected)) problem.hint = "it is the last row; the file may be cut off";
  return problem;
}

void list_uneven(TextSurvey& survey, const TextRow& row, bool last) {
  if (survey.problems.size() < max_reported_rows)
    survey.problems.push_back(uneven_row(row, survey.rows, survey.values, last));
}

TextSurvey survey_text(const core::InputFile& file, TextScanner scanner, const TextLayout& layout,
                       core::StopPoints stop) {
  TextSurvey survey;
  TextIndex::Recorder recorder(*survey.index);
  TextRowParser parser(scanner, layout, [&](const TextNumber& number) {
    stop.pass();
    survey.numbers.note(number);
  });
  for (;;) {
    scanner.skip_white_space();
    const TextMark mark{scanner.offset(), scanner.line()};
    const TextRow row = parser.parse();
    if (row.malformed) {
      survey.problems.push_back(*row.malformed);
      break;
    }
    if (row.values == 0) break;
    recorder.row_begins(survey.rows, mark.offset, mark);
    const bool even = row.values % 2 == 0;
    if (!even || (survey.values > 0 && row.values != survey.values) ||
        (layout.columns > 0 && row.values != 2 * layout.columns)) {
      const std::size_t expected = survey.values > 0 ? survey.values : 2 * layout.columns;
      scanner.skip_white_space();
      if (survey.values == 0) survey.values = expected;
      list_uneven(survey, row, scanner.peek() == TextScanner::end);
    } else if (survey.values == 0) {
      survey.values = row.values;
    }
    recorder.rows_known(++survey.rows);
  }
  for (core::Problem& problem : survey.problems) problem.place.file = file.path().string();
  if (survey.rows == 0 && survey.problems.empty())
    survey.problems.push_back(file_problem(file.path().string(), "the file holds no samples"));
  return survey;
}

CsvHeading heading_of(const core::InputFile& file, TextStyle style) {
  const auto line = style == TextStyle::commas ? line_of_names(file) : std::nullopt;
  return line ? csv_heading_of(*line) : CsvHeading{};
}

bool says_volts(const CsvHeading& heading) { return heading.unit && !heading.unit->counts; }

// Numbers that a line of names calls volts have no offset of a converter.
std::optional<core::Problem> problem_of_unit(const CsvHeading& heading, int bits, const std::string& name) {
  if (bits == 0 || !says_volts(heading)) return std::nullopt;
  return file_problem(name, "the line of names says that the numbers are voltages, and A/D bits are given",
                      fmt::format("{} A/D bits", bits), "one of the two",
                      "leave out the number of bits, or correct the unit in the line of names");
}

// CSV holds counts plus an offset, which only the number of bits tells.
std::optional<CountRange> find_offset(const TextSurvey& survey, const RasterHints& hints, const std::string& name,
                                      core::Problems& problems) {
  if (hints.bits == 0) {
    problems.push_back(
        with_severity(file_problem(name, "the values may contain the offset of the A/D converter", {}, {},
                                   "give the number of A/D bits to have it subtracted; the values are taken unchanged"),
                      core::Severity::note));
    return std::nullopt;
  }
  const CountRange range{hints.bits};
  const TextValues& numbers = survey.numbers;
  if (numbers.may_have_offset(range)) return range;
  problems.push_back(file_problem(
      name, fmt::format("the values are not those of {} A/D bits with an offset of {}", hints.bits, range.offset()),
      !numbers.whole ? "numbers that are not whole"
                     : (numbers.negative ? std::string("negative numbers") : fmt::format("{}", numbers.highest)),
      fmt::format("0 to {}", range.highest_stored()), "leave out the number of bits to take the values unchanged"));
  return std::nullopt;
}

OpenedRaster open_whole_text(core::InputFile file, TextStyle style, const RasterHints& hints, core::StopPoints stop) {
  const std::string name = file.path().string();
  if (hints.bits < 0 || hints.bits > 64)
    return {nullptr,
            {file_problem(name, "the number of A/D bits is out of range", fmt::format("{}", hints.bits), "1 to 64")}};
  if (hints.columns > std::numeric_limits<std::size_t>::max() / 2)
    return {nullptr, {file_problem(name, "the samples of a row are too many", fmt::format("{}", hints.columns))}};
  const CsvHeading heading = heading_of(file, style);
  if (auto problem = problem_of_unit(heading, hints.bits, name)) return {nullptr, {std::move(*problem)}};
  TextScanner scanner = scanner_at_samples(file, style);
  const TextLayout layout{style, style == TextStyle::commas ? 0 : hints.columns};
  TextSurvey survey = survey_text(file, std::move(scanner), layout, stop);
  OpenedRaster result{nullptr, std::move(survey.problems)};
  if (auto problem = problem_of_heading(heading, survey.values, name)) return {nullptr, {std::move(*problem)}};
  if (core::has_errors(result.problems)) return result;
  if (hints.rows > 0 && hints.rows != survey.rows)
    result.problems.push_back(file_problem(name, "the file has another number of rows", fmt::format("{}", survey.rows),
                                           fmt::format("{}", hints.rows)));
  if (hints.columns > 0 && 2 * hints.columns != survey.values)
    result.problems.push_back(file_problem(name, "the rows have another length",
                                           fmt::format("{} samples", survey.values / 2),
                                           fmt::format("{} samples", hints.columns)));
  TextSamples samples{layout, survey.values, 2, {}};
  if (says_volts(heading))
    samples.factor = heading.unit->volts;
  else if (style == TextStyle::commas)
    samples.offset = find_offset(survey, hints, name, result.problems);
  if (core::has_errors(result.problems)) return result;
  RasterInfo info = info_of(file, survey.values / 2, hints);
  info.counts = survey.numbers.whole && !says_volts(heading);
  info.bits = hints.bits;
  result.raster = make_whole_text(std::move(info), std::move(file), samples, std::move(survey.index));
  return result;
}

// What the first row tells of the others.
struct FirstRow {
  TextMark begin;
  TextRow row;
  TextValues numbers;
  std::uint64_t bytes = 0;
  bool too_long = false;
};

struct TooLong {};

FirstRow read_first_row(const core::InputFile& file, const TextLayout& layout, core::StopPoints stop) {
  FirstRow first;
  TextScanner scanner = scanner_at_samples(file, layout.style);
  scanner.skip_white_space();
  first.begin = {scanner.offset(), scanner.line()};
  std::size_t values = 0;
  TextRowParser parser(scanner, layout, [&](const TextNumber& number) {
    stop.pass();
    if (++values > max_values_of_first_row) throw TooLong();
    first.numbers.note(number);
  });
  try {
    first.row = parser.parse();
  } catch (const TooLong&) {
    first.too_long = true;
  }
  first.bytes = scanner.offset() - first.begin.offset;
  return first;
}

// The same where only the first row is known: values that do not fit it are taken as they stand.
std::optional<CountRange> offset_of(const FirstRow& first, const RasterHints& hints, const std::string& name,
                                    core::Problems& problems) {
  if (hints.bits == 0) {
    problems.push_back(with_severity(file_problem(name, "the values may contain the offset of the A/D converter", {},
                                                  {}, "give the number of A/D bits to have it subtracted"),
                                     core::Severity::note));
    return std::nullopt;
  }
  const CountRange range{hints.bits};
  if (first.numbers.may_have_offset(range)) return range;
  problems.push_back(with_severity(
      file_problem(name, fmt::format("the values are not those of {} A/D bits with an offset", hints.bits), {}, {},
                   "they are taken unchanged"),
      core::Severity::warning));
  return std::nullopt;
}

std::optional<core::Problem> first_row_problem(const std::string& name, const FirstRow& first,
                                               const TextLayout& layout) {
  if (first.too_long)
    return file_problem(name, "the first row does not end", fmt::format("{} numbers", max_values_of_first_row), {},
                        "give the samples of a row");
  if (first.row.malformed) {
    core::Problem problem = *first.row.malformed;
    problem.place.file = name;
    return problem;
  }
  if (first.row.values == 0) return file_problem(name, "the file holds no samples");
  if (first.row.values % 2 != 0 && layout.style != TextStyle::commas)
    return file_problem(name, "the first row ends with an I that has no Q",
                        fmt::format("{} numbers", first.row.values));
  if (layout.columns > 0 && first.row.values < 2 * layout.columns)
    return file_problem(name, "the file does not hold a single row", fmt::format("{} numbers", first.row.values),
                        fmt::format("{} samples", layout.columns));
  return std::nullopt;
}

OpenedRaster open_growing_text(core::InputFile file, TextStyle style, const RasterHints& hints, core::StopPoints stop) {
  const std::string name = file.path().string();
  if (hints.bits < 0 || hints.bits > 64 || hints.columns > (std::size_t{1} << 60U))
    return {nullptr, {file_problem(name, "the samples of a row or the A/D bits are out of range")}};
  const TextLayout layout{style, style == TextStyle::commas ? 0 : hints.columns};
  const FirstRow first = read_first_row(file, layout, stop);
  if (auto problem = first_row_problem(name, first, layout)) return {nullptr, {std::move(*problem)}};
  const CsvHeading heading = heading_of(file, style);
  if (auto problem = problem_of_unit(heading, hints.bits, name)) return {nullptr, {std::move(*problem)}};
  core::Problems problems;
  TextSamples samples{layout, first.row.values, first.row.values % 2 != 0 ? 1U : 2U, {}};
  // Columns of other names are a picture of real numbers where they cannot be pairs.
  if (samples.components == 2 || heading.pairs)
    if (auto problem = problem_of_heading(heading, samples.values, name)) return {nullptr, {std::move(*problem)}};
  if (says_volts(heading))
    samples.factor = heading.unit->volts;
  else if (samples.components == 2 && style == TextStyle::commas)
    samples.offset = offset_of(first, hints, name, problems);
  RasterInfo info = info_of(file, samples.values / samples.components, hints);
  if (samples.components == 1) info.value = ImageValue::real;
  info.counts = first.numbers.whole && samples.components == 2 && !says_volts(heading);
  info.bits = info.counts ? hints.bits : 0;
  return {make_growing_text(std::move(info), std::move(file), samples, first.begin, first.bytes), std::move(problems)};
}

}  // namespace

OpenedRaster open_text(core::InputFile file, const Format& format, const RasterHints& hints, Integrity integrity,
                       const core::StopFlag* stop) {
  const auto open = integrity == Integrity::whole ? open_whole_text : open_growing_text;
  return open(std::move(file), format.text, hints, {stop, numbers_at_once});
}

}  // namespace sarsim::raster

#include "raster/format/text_reader.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "raster/format/text_rows.hpp"
#include "raster/table/count_range.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t most_reported_rows = 10;
constexpr std::uint64_t index_spacing = 256;  // Bytes between remembered rows, so that the index stays small.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// Where some row begins.
struct RowMark {
  std::size_t row;
  std::uint64_t offset;
  std::size_t line;
};

// What one reading of the whole text tells.
struct TextSurvey {
  std::vector<RowMark> marks;
  std::size_t rows = 0;
  std::size_t values = 0;  // Of each row.
  TextValues numbers;
  core::Problems problems;
};

TextScanner scanner_at_start(const core::InputFile& file) {
  std::array<char, 3> begin{};
  const std::size_t got = file.read_at(0, std::as_writable_bytes(std::span(begin)));
  const bool marked = std::string_view(begin.data(), got) == byte_order_mark;
  return {file, marked ? byte_order_mark.size() : 0U, 1};
}

bool is_name(const std::string& token) {
  const char c = token.empty() ? '0' : token.front();
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '"' || c == '#';
}

// A header is a first line none of whose fields is a number and whose first field is a name.
void skip_header(TextScanner& scanner, const core::InputFile& file) {
  scanner.skip_white_space();
  TextScanner ahead(file, scanner.offset(), scanner.line());
  std::string token;
  TextNumber number;
  bool first = true;
  for (int c = ahead.peek(); c != TextScanner::end && c != '\n'; c = ahead.peek()) {
    if (c == ',' || c == '(' || c == ')') {
      ahead.advance();
      continue;
    }
    if (ahead.take_number(number, token) || (first && !is_name(token))) return;
    first = false;
    ahead.skip_blanks();
  }
  if (!first) scanner.skip_line();
}

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
  if (survey.problems.size() < most_reported_rows)
    survey.problems.push_back(uneven_row(row, survey.rows, survey.values, last));
}

void remember(TextSurvey& survey, std::uint64_t offset, std::size_t line) {
  if (survey.marks.empty() || offset >= survey.marks.back().offset + index_spacing)
    survey.marks.push_back({survey.rows, offset, line});
}

TextSurvey survey_text(const core::InputFile& file, TextScanner scanner, const TextLayout& layout) {
  TextSurvey survey;
  TextRowParser parser(scanner, layout, [&survey](const TextNumber& number) { survey.numbers.note(number); });
  for (;;) {
    scanner.skip_white_space();
    const std::uint64_t offset = scanner.offset();
    const std::size_t line = scanner.line();
    const TextRow row = parser.parse();
    if (row.malformed) {
      survey.problems.push_back(*row.malformed);
      break;
    }
    if (row.values == 0) break;
    remember(survey, offset, line);
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
    ++survey.rows;
  }
  for (core::Problem& problem : survey.problems) problem.place.file = file.path().string();
  if (survey.rows == 0 && survey.problems.empty())
    survey.problems.push_back(file_problem(file.path().string(), "the file holds no samples"));
  return survey;
}

class TextReader final : public SampleReader {
 public:
  TextReader(core::InputFile file, SampleFileInfo info, TextLayout layout, std::vector<RowMark> marks,
             std::optional<CountRange> offset)
      : SampleReader(std::move(info)),
        file_(std::move(file)),
        layout_(layout),
        marks_(std::move(marks)),
        offset_(offset) {}

  void read_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const override {
    if (count == 0) return;
    const auto after = std::ranges::upper_bound(marks_, first, {}, &RowMark::row);
    const RowMark& mark = *(after - 1);  // The first row is always remembered.
    TextScanner scanner(file_, mark.offset, mark.line);
    std::size_t row = mark.row;
    std::size_t next = 0;
    const std::size_t values = 2 * info().columns;
    TextRowParser parser(scanner, layout_, [&](const TextNumber& number) {
      if (row < first || next >= 2 * out.size()) return;
      const double value = decoded(number);
      std::complex<double>& sample = out[next / 2];
      sample = next % 2 == 0 ? std::complex<double>(value, 0.0) : std::complex<double>(sample.real(), value);
      ++next;
    });
    for (; row < first + count; ++row) {
      const TextRow found = parser.parse();
      if (found.malformed || found.values != values)
        throw std::runtime_error("cannot read " + file_.path().string() + ": it has been changed");
    }
  }

 private:
  [[nodiscard]] double decoded(const TextNumber& number) const {
    if (!offset_) return number.value + 0.0;  // The old programs wrote "-0"; it is 0.
    return static_cast<double>(offset_->without_offset(number.magnitude));
  }

  core::InputFile file_;
  TextLayout layout_;
  std::vector<RowMark> marks_;
  std::optional<CountRange> offset_;
};

// CSV holds counts plus an offset, which only the number of bits tells.
std::optional<CountRange> find_offset(const TextSurvey& survey, const SampleFileHints& hints, const std::string& name,
                                      core::Problems& problems) {
  if (hints.bits == 0) {
    problems.push_back(with_severity(
        file_problem(name, "the values may contain the offset of the A/D converter", {}, {},
                     "give the number of A/D bits to have it subtracted; the values are taken as they stand"),
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
      fmt::format("0 to {}", range.highest_stored()), "leave out the number of bits to take the values as they stand"));
  return std::nullopt;
}

}  // namespace

TextStyle style_of_text(const core::InputFile& file) {
  std::vector<char> begin(4096);
  begin.resize(file.read_at(0, std::as_writable_bytes(std::span(begin))));
  const auto control = [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code < 0x20 && !(code >= '\t' && code <= '\r')) || code == 0x7F;
  };
  if (std::ranges::any_of(begin, control)) return TextStyle::none;
  std::string_view text(begin.data(), begin.size());
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const std::size_t start = text.find_first_not_of(" \t\r\n\v\f");
  if (start == std::string_view::npos) return TextStyle::lines;
  text.remove_prefix(start);
  if (text.starts_with('(')) return TextStyle::brackets;
  return text.substr(0, text.find('\n')).find(',') != std::string_view::npos ? TextStyle::commas : TextStyle::lines;
}

TextScanner scanner_at_samples(const core::InputFile& file, TextStyle style) {
  TextScanner scanner = scanner_at_start(file);
  if (style == TextStyle::commas) skip_header(scanner, file);
  return scanner;
}

OpenedReader open_text(core::InputFile file, TextStyle style, const SampleFileHints& hints) {
  const std::string name = file.path().string();
  if (hints.bits < 0 || hints.bits > 64)
    return {nullptr,
            {file_problem(name, "the number of A/D bits is out of range", fmt::format("{}", hints.bits), "1 to 64")}};
  if (hints.columns > std::numeric_limits<std::size_t>::max() / 2)
    return {nullptr, {file_problem(name, "the samples of a row are too many", fmt::format("{}", hints.columns))}};
  TextScanner scanner = scanner_at_samples(file, style);
  const TextLayout layout{style, style == TextStyle::commas ? 0 : hints.columns};
  TextSurvey survey = survey_text(file, std::move(scanner), layout);
  OpenedReader result{nullptr, std::move(survey.problems)};
  if (core::has_errors(result.problems)) return result;
  if (hints.rows > 0 && hints.rows != survey.rows)
    result.problems.push_back(file_problem(name, "the file has another number of rows", fmt::format("{}", survey.rows),
                                           fmt::format("{}", hints.rows)));
  if (hints.columns > 0 && 2 * hints.columns != survey.values)
    result.problems.push_back(file_problem(name, "the rows have another length",
                                           fmt::format("{} samples", survey.values / 2),
                                           fmt::format("{} samples", hints.columns)));
  std::optional<CountRange> offset;
  if (style == TextStyle::commas) offset = find_offset(survey, hints, name, result.problems);
  if (core::has_errors(result.problems)) return result;
  SampleFileInfo info;
  info.rows = survey.rows;
  info.columns = survey.values / 2;
  info.counts = survey.numbers.whole;
  info.bits = hints.bits;
  if (hints.lsb_v > 0.0) info.lsb_v = hints.lsb_v;
  result.reader = std::make_unique<TextReader>(std::move(file), info, layout, std::move(survey.marks), offset);
  return result;
}

}  // namespace sarsim::raster

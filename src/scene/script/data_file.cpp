#include "scene/script/data_file.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/script/problem_log.hpp"
#include "scene/script/tokens.hpp"

namespace sarsim::scene {

namespace script {

namespace {

// The list of problems that a data file may give before reading of it ends.
constexpr std::size_t data_file_problem_limit = 20;

std::string with_unit(const FunctionAxis& axis) {
  return axis.unit.empty() ? std::string(axis.name) : fmt::format("{} ({})", axis.name, axis.unit);
}

std::string subject_of(const FunctionText& text) {
  return fmt::format("{} ({})", text.block.y[text.part].name, text.block.words);
}

// The number of points, or nothing where it cannot be told (reported).
std::optional<std::uint64_t> read_count(Tokens& tokens, const FunctionText& text, Reporter& reporter) {
  const Token token = tokens.peek();
  const std::string words = "number of points for " + subject_of(text);
  if (!token.is_value()) {
    reporter.error(token, text.member,
                   {fmt::format("{} is missing", words), "",
                    fmt::format("{} of {} functions", text.block.count - text.part, text.block.count)});
    return std::nullopt;
  }
  static_cast<void>(tokens.take());
  reporter.check_spelling(token, text.member);
  std::int64_t count = 0;
  if (!read_integer(token, Field{text.member, words}, reporter, count)) return std::nullopt;
  const std::int64_t least = text.whole_file ? 1 : 0;
  if (count < least) {
    reporter.error(token, text.member,
                   {fmt::format("{} is too small", words), shown(token.text), fmt::format("at least {}", least)});
    return std::nullopt;
  }
  if (count == 0)
    reporter.warning(token, text.member, {fmt::format("{} has no points and is zero everywhere", subject_of(text))});
  return static_cast<std::uint64_t>(count);
}

// One coordinate. The plain case comes first; words are only put together where something is to be said.
bool read_coordinate(const Token& token, const FunctionText& text, bool is_y, Reporter& reporter, double& value) {
  const FunctionAxis& axis = is_y ? text.block.y[text.part] : text.block.x;
  const int shift = is_y ? text.block.y_shift : 0;
  const Range range = is_y ? range_of_y(text.block) : any_value;
  if (plain_number(token, shift, range, value)) return true;
  reporter.check_spelling(token, text.member);
  const std::string words = fmt::format("{} of a point ({})", axis.name, text.block.words);
  return read_number(token, Field{text.member, words, axis.unit, shift, range}, reporter, value);
}

PointsEnd report_early_end(const Token& token, const FunctionText& text, Reporter& reporter, std::uint64_t announced,
                           std::size_t read) {
  const bool keyword = token.kind == TokenKind::word;
  reporter.error(
      token, text.member,
      {fmt::format("{} points were announced for {}, the data end after {}", announced, subject_of(text), read),
       shown(token.text), "x and y of every point", "correct the number of points or add the missing ones"});
  return keyword ? PointsEnd::keyword : PointsEnd::broken;
}

bool ends_data(const Token& token, const FunctionText& text) {
  if (!token.is_value()) return true;
  return !text.whole_file && token.kind == TokenKind::word && !begins_like_number(token.text) && is_keyword(token.text);
}

// The first point of a function whose x does not ascend; the rest would only say the same again. Nothing is said where
// the points end early: then a wrong count is the likelier mistake.
struct Descent {
  Token x_token;
  double above = 0.0;
  std::size_t point = 0;  // From 1.
};

void report(const std::optional<Descent>& descent, const FunctionText& text, Reporter& reporter) {
  if (!descent) return;
  // Rows of time, x, y and z read as points make y the time of the second point.
  const bool maybe_rows = text.block.count == 3 && descent->point <= 3;
  reporter.error(descent->x_token, text.member,
                 {fmt::format("point {} of {}: {} must ascend", descent->point, subject_of(text), text.block.x.name),
                  shown(descent->x_token.text),
                  fmt::format("more than {}, as of the point before", core::format_number(descent->above)),
                  maybe_rows ? "give the points of each coordinate in a list of their own, after "
                               "their number; rows of time, x, y and z are not read"
                             : "sort the points"});
}

}  // namespace

PointsEnd read_points(Tokens& tokens, const FunctionText& text, Reporter& reporter, std::vector<core::Knot>& points) {
  points.clear();
  const std::optional<std::uint64_t> count = read_count(tokens, text, reporter);
  if (!count) return PointsEnd::broken;
  // A point takes at least four bytes of text, so that a wrong count cannot ask for more memory than the text has.
  points.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(*count, tokens.remaining_bytes() / 4 + 1)));
  std::optional<Descent> descent;
  bool x_known = true;
  for (std::uint64_t i = 0; i < *count; ++i) {
    if (ends_data(tokens.peek(), text)) return report_early_end(tokens.peek(), text, reporter, *count, points.size());
    const Token x_token = tokens.take();
    core::Knot point;
    const bool x_good = read_coordinate(x_token, text, false, reporter, point.x);
    if (ends_data(tokens.peek(), text)) return report_early_end(tokens.peek(), text, reporter, *count, points.size());
    static_cast<void>(read_coordinate(tokens.take(), text, true, reporter, point.y));
    const bool comparable = x_good && x_known && !text.block.x_ignored && !points.empty();
    if (comparable && !descent && !(point.x > points.back().x))
      descent = Descent{x_token, points.back().x, points.size() + 1};
    x_known = x_good;
    points.push_back(point);
    if (reporter.full()) return PointsEnd::broken;
  }
  report(descent, text, reporter);
  return PointsEnd::complete;
}

std::string axes_text(const FunctionBlock& block, std::size_t part) {
  return fmt::format("{} against {}", with_unit(block.y[part]), with_unit(block.x));
}

void append_point(std::string& text, const FunctionBlock& block, const core::Knot& point) {
  core::append_number(text, point.x);
  text += ", ";
  core::append_number(text, point.y, -block.y_shift);
}

}  // namespace script

namespace {

bool is_table_name(const std::string& file_name) {
  const std::string small = core::lower_case(file_name);
  return small.ends_with(".csv") || small.ends_with(".tsv");
}

DataFileReading read_counted(std::string_view text, const std::string& file_name, const FunctionBlock& block) {
  using namespace script;
  DataFileReading reading;
  reading.functions.resize(block.count);
  ProblemLog log(data_file_problem_limit);
  Reporter reporter(log, file_name, {});
  if (const std::size_t control = find_control_byte(text); control != std::string_view::npos) {
    reporter.error(token_at(text, control), "", {"not a text file", "", "numbers as text", ""});
    reading.problems = log.take();
    return reading;
  }
  Tokens tokens(text);
  const Token first = tokens.peek();
  if (first.kind == TokenKind::command)
    reporter.error(first, "", {"this is a script, not a data file", "$" + shown(first.text), "a number of points", ""});
  else if (first.kind == TokenKind::end)
    reporter.error(first, "", {"the data file holds no numbers", "", "a number of points", ""});
  else
    for (std::size_t i = 0; i < block.count; ++i)
      if (read_points(tokens, {block, i, "", true}, reporter, reading.functions[i]) != PointsEnd::complete) break;
  reading.problems = log.take();
  if (const Token rest = tokens.peek(); !core::has_errors(reading.problems) && rest.kind != TokenKind::end) {
    reporter.warning(rest, "", {"numbers after the last function are ignored", shown(rest.text)});
    core::append(reading.problems, log.take());
  }
  // One word of the file is enough to see that it is another kind of file.
  for (std::size_t i = 1; i < reading.problems.size(); ++i) reading.problems[i].found.clear();
  return reading;
}

}  // namespace

DataFileReading read_data_file(std::string_view text, const std::string& file_name, const FunctionBlock& block) {
  if (is_hdf5(text)) {
    DataFileReading reading;
    reading.functions.resize(block.count);
    reading.deferred = true;
    return reading;
  }
  if (auto array = read_npy_table(text, file_name, block)) return *std::move(array);
  const bool is_text = script::find_control_byte(text) == std::string_view::npos;
  if (is_text && is_table_name(file_name))
    if (auto table = read_text_table(text, file_name, block, false)) return *std::move(table);
  DataFileReading counted = read_counted(text, file_name, block);
  const bool is_script = script::Tokens(text).peek().kind == script::TokenKind::command;
  if (counted.problems.empty() || !is_text || is_script) return counted;
  if (auto table = read_text_table(text, file_name, block, is_table_name(file_name))) return *std::move(table);
  return counted;
}

std::string write_data_file(std::span<const core::SampledFunction> functions, const FunctionBlock& block) {
  using namespace script;
  std::string text = fmt::format("! Data of: {}\n", block.words);
  text += "! For each function the number of points, then x and y of every point";
  text += block.x_ignored ? "; x only counts them\n" : ", x ascending\n";
  for (std::size_t i = 0; i < block.count; ++i) text += fmt::format("! Function {}: {}\n", i + 1, axes_text(block, i));
  for (std::size_t i = 0; i < block.count; ++i) {
    text += fmt::format("\n{:<20} ! points of {}\n", functions[i].knots.size(), axes_text(block, i));
    for (const core::Knot& knot : functions[i].knots) {
      append_point(text, block, knot);
      text += '\n';
    }
  }
  return text;
}

}  // namespace sarsim::scene

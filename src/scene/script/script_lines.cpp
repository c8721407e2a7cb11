#include "scene/script/script_lines.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/script/tokens.hpp"

namespace sarsim::scene::script {

namespace {

constexpr std::size_t value_columns = 20;

std::string capitalized(std::string_view words) {
  std::string text(words);
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace

std::string comment_of(const Field& field, std::string_view more) {
  std::string text = field.unit.empty() ? "" : fmt::format("({}) ", field.unit);
  text += capitalized(field.words);
  if (!more.empty()) text += fmt::format(" {}", more);
  if (!field.detail.empty()) text += fmt::format(": {}", field.detail);
  return text;
}

void ScriptLines::plain(std::string_view text) {
  text_ += text;
  text_ += '\n';
}

void ScriptLines::append(std::string_view lines, std::size_t expected_bytes) {
  if (text_.capacity() - text_.size() < lines.size())
    text_.reserve(text_.size() + std::max(lines.size(), expected_bytes));
  text_ += lines;
}

void ScriptLines::blank(int count) { text_.append(static_cast<std::size_t>(count), '\n'); }

void ScriptLines::value(std::string_view text, std::string_view comment) {
  text_ += text;
  if (!comment.empty()) {
    if (text.size() < value_columns) text_.append(value_columns - text.size(), ' ');
    text_ += " ! ";
    text_ += comment;
  }
  text_ += '\n';
}

void ScriptLines::name(const Field& field, std::string_view name) {
  value(quoted_where_needed(name), comment_of(field));
}

void ScriptLines::number(const Field& field, double number) {
  value(core::format_number(number, -field.shift), comment_of(field));
}

void ScriptLines::integer(const Field& field, int number) { value(fmt::format("{}", number), comment_of(field)); }

void ScriptLines::vector(const Field& field, const core::Vec3& vector) {
  value(core::format_number(vector.x, -field.shift), comment_of(field, "x"));
  value(core::format_number(vector.y, -field.shift), comment_of(field, "y"));
  value(core::format_number(vector.z, -field.shift), comment_of(field, "z"));
}

void ScriptLines::angles(const Field& field, const std::array<core::Angle, 3>& angles) {
  vector(field, {angles[0].deg(), angles[1].deg(), angles[2].deg()});
}

void ScriptLines::row(std::initializer_list<double> values, std::string_view comment) {
  bool first = true;
  for (const double number : values) {
    if (!first) text_ += ", ";
    first = false;
    core::append_number(text_, number);
  }
  text_ += "  ! ";
  text_ += comment;
  text_ += '\n';
}

void ScriptLines::write_block(const FunctionBlock& block, std::span<const core::SampledFunction> parts,
                              std::string_view file) {
  for (std::size_t i = 0; i < block.count; ++i)
    for (const auto& method : interpolations)
      if (method.value == parts[i].method)
        value(method.word, fmt::format("{}, joined by {}", capitalized(axes_text(block, i)), method.meaning));
  if (!file.empty()) {
    value("FILE " + quoted_where_needed(file), fmt::format("Data of: {}", block.words));
    return;
  }
  value("INLINE", fmt::format("Data of: {}", block.words));
  for (std::size_t i = 0; i < block.count; ++i) {
    value(fmt::format("{}", parts[i].knots.size()), fmt::format("Points of {}", axes_text(block, i)));
    for (const core::Knot& knot : parts[i].knots) {
      append_point(text_, block, knot);
      text_ += '\n';
    }
  }
}

}  // namespace sarsim::scene::script

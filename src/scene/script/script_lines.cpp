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

void ScriptLines::number(const Field& field, double number) {
  value(core::format_number(number, -field.shift), comment_of(field));
}

void ScriptLines::vector(const Field& field, const core::Vec3& vector) {
  value(core::format_number(vector.x, -field.shift), comment_of(field, "x"));
  value(core::format_number(vector.y, -field.shift), comment_of(field, "y"));
  value(core::format_number(vector.z, -field.shift), comment_of(field, "z"));
}

void ScriptLines::write_field(const FieldSpec& spec, const Field& field, const FieldValue& held) {
  switch (spec.type) {
    case FieldType::number:
      if (spec.quantity != Quantity::count) return number(field, std::get<double>(held));
      return value(fmt::format("{}", chosen(held)), comment_of(field));
    case FieldType::seed: return value(fmt::format("{}", std::get<std::uint64_t>(held)), comment_of(field));
    case FieldType::vector: return vector(field, std::get<core::Vec3>(held));
    case FieldType::choice:
    case FieldType::check:
      if (const Choice* const choice = chosen_word(spec, held)) return value(choice->word, choice->meaning);
      if (has_words(spec)) return;
      return value(fmt::format("{}", chosen(held)), comment_of(field));
    case FieldType::flags: return value(fmt::format("{}", chosen(held)), comment_of(field));
    case FieldType::text:
    case FieldType::name: return value(quoted_where_needed(std::get<std::string>(held)), comment_of(field));
    case FieldType::function: return write_block(*spec.block, std::get<ConstFunctionRef>(held));
    case FieldType::list: return;
  }
}

void ScriptLines::add_to_row(const Field& field, const FieldValue& value, bool first) {
  const auto add = [&](double number) {
    if (!first) text_ += ", ";
    first = false;
    core::append_number(text_, number, -field.shift);
  };
  if (const auto* const vector = std::get_if<core::Vec3>(&value))
    add(vector->x), add(vector->y), add(vector->z);
  else
    add(std::get<double>(value));
}

void ScriptLines::end_row(const Field& field, std::string_view comment) {
  text_ += "  ! (";
  text_ += field.unit;
  text_ += ") ";
  text_ += comment;
  text_ += '\n';
}

void ScriptLines::write_block(const FunctionBlock& block, const ConstFunctionRef& function) {
  const auto parts = function.parts;
  const std::string& file = *function.file;
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

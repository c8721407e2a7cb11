#include "scene/script/field_reader.hpp"

#include <array>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::scene::script {

namespace {

std::string listed(std::span<const std::string_view> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

std::string selection_hint(const Token& token, std::span<const std::string_view> words) {
  const std::string near = core::nearest_word(token.text.substr(0, longest_shown), words);
  if (!near.empty()) return fmt::format("did you mean {}?", near);
  if (begins_like_number(token.text))
    return "there may be one number too many before it, as a decimal comma makes (0,1 is read as two numbers: write "
           "0.1)";
  return {};
}

// A keyword that belongs to no field of an object, as the value that it stands for.
template <class Value, std::size_t N>
void select(FieldReader& reader, const Field& field, const Alternatives<Value, N>& alternatives, Value& value) {
  std::array<std::string_view, N> words;
  for (std::size_t i = 0; i < N; ++i) words[i] = alternatives[i].word;
  const std::size_t chosen = reader.keyword(field, words);
  if (chosen < N) value = alternatives[chosen].value;
}

constexpr std::array<char, 3> axis_letters{'x', 'y', 'z'};

}  // namespace

FieldReader::FieldReader(Reading& reading, const Token& command, std::string_view kind, std::size_t index)
    : reading_(reading), reporter_(reading.log, reading.file, {kind, index}), command_(command) {
  reading_.places.begin_object(kind, index, reading_.file);
}

Token FieldReader::take(const Field& field) {
  const Token& token = reading_.tokens.pass();
  if (token.comment_follows || token.open_quote) reporter_.check_spelling(token, field.member);
  return token;
}

void FieldReader::note_object() { note_place(Field{}, command_); }

void FieldReader::note_place(const Field& field, const Token& token) {
  reading_.places.add_field(field.member, token.line, token.column);
}

bool FieldReader::value_follows(const Field& field, std::string_view kind) {
  if (reading_.tokens.peek().is_value()) return true;
  failed_ = true;
  std::string expected(kind);
  if (!field.unit.empty()) expected += fmt::format(" in {}", field.unit);
  reporter_.error(reading_.tokens.last(), field.member,
                  {fmt::format("${} ends before the {}", shown(command_.text), field.words), "",
                   expected + fmt::format(" behind '{}'", shown(reading_.tokens.last().text)),
                   fmt::format("the command begins in line {}", command_.line)});
  return false;
}

bool FieldReader::number_follows(const Field& field, std::string_view kind) {
  if (skipping() || !value_follows(field, kind)) return false;
  const Token& token = reading_.tokens.peek();
  if (token.kind != TokenKind::word || !is_keyword(token.text)) return true;
  numbers_missing_ = true;
  std::string expected(kind);
  if (!field.unit.empty()) expected += fmt::format(" in {}", field.unit);
  reporter_.error(token, field.member,
                  {fmt::format("{} is missing", field.words), shown(token.text), expected + range_text(field.range),
                   "this keyword belongs after it"});
  return false;
}

bool FieldReader::leading_name(const Field& field, std::string& name) {
  if (!value_follows(field, "a name")) return false;
  const Token token = take(field);
  note_object();
  note_place(field, token);
  name = name_text(token);
  if (name.empty())
    reporter_.error(token, field.member,
                    {fmt::format("{} is empty", field.words), "", "a name with at least one character"});
  return true;
}

void FieldReader::text(const Field& field, std::string& text) {
  if (failed_ || !value_follows(field, "a name")) return;
  numbers_missing_ = false;
  const Token token = take(field);
  note_place(field, token);
  text = name_text(token);
  if (text.empty())
    reporter_.error(token, field.member,
                    {fmt::format("{} is empty", field.words), "", "a name with at least one character"});
}

bool FieldReader::plain_number_in(const Field& field, double& value) {
  if (!more() || !plain_number(peek(), field.shift, field.range, value)) return false;
  reading_.tokens.pass();
  return true;
}

void FieldReader::number_in(const Field& field, double& value) {
  double read = 0.0;
  if (number_follows(field, "a number") && read_number(take(field), field, reporter_, read)) value = read;
}

void FieldReader::number(const Field& field, double& value) {
  if (more()) note_place(field, peek());
  if (!skipping() && plain_number_in(field, value)) return;
  number_in(field, value);
}

void FieldReader::integer(const Field& field, double& value) {
  if (!number_follows(field, "a whole number")) return;
  const Token token = take(field);
  note_place(field, token);
  std::int64_t read = 0;
  if (!read_integer(token, field, reporter_, read)) return;
  if (field.range.holds(static_cast<double>(read))) value = static_cast<double>(read);
}

void FieldReader::seed(const Field& field, std::uint64_t& value) {
  if (!number_follows(field, "a whole number")) return;
  const Token token = take(field);
  note_place(field, token);
  if (const auto read = core::parse_whole(token.text))
    value = *read;
  else
    reporter_.error(
        token, field.member,
        {fmt::format("{} is not a seed", field.words), shown(token.text), "a whole number, 0 to 18446744073709551615"});
}

void FieldReader::vector(const Field& field, core::Vec3& value) {
  if (more()) note_place(field, peek());
  std::array<double*, 3> parts{&value.x, &value.y, &value.z};
  for (std::size_t i = 0; i < 3; ++i) {
    if (skipping()) return;
    // The words of a coordinate are only put together where something is to be said.
    if (plain_number_in(field, *parts[i])) continue;
    const std::string words = fmt::format("{} {}", field.words, axis_letters[i]);
    Field part = field;
    part.words = words;
    number_in(part, *parts[i]);
  }
}

void FieldReader::choice(const FieldSpec& spec, const Field& field, FieldValue& value) {
  constexpr std::size_t max_words = 16;
  if (spec.choices.size() > max_words) throw std::logic_error("a field has more choices than the reader looks at");
  std::array<std::string_view, max_words> words;
  std::array<int, max_words> values{};
  std::size_t count = 0;
  for (const Choice& one : spec.choices) {
    if (one.since_2()) continue;
    words[count] = one.word;
    values[count++] = one.value;
  }
  const std::size_t at = keyword(field, std::span(words).first(count));
  if (at < count) choose(value, values[at]);
}

void FieldReader::read_value(const FieldSpec& spec, const Field& field, FieldValue& value) {
  switch (spec.type) {
    case FieldType::number:
      if (spec.quantity == Quantity::count) return integer(field, std::get<double>(value));
      return number(field, std::get<double>(value));
    case FieldType::seed: return seed(field, std::get<std::uint64_t>(value));
    case FieldType::vector: return vector(field, std::get<core::Vec3>(value));
    case FieldType::choice:
      if (!has_words(spec)) return integer(field, std::get<double>(value));
      return choice(spec, field, value);
    case FieldType::check: return choice(spec, field, value);
    case FieldType::flags: return integer(field, std::get<double>(value));
    case FieldType::text:
    case FieldType::name: return text(field, std::get<std::string>(value));
    case FieldType::function:
    case FieldType::list: return;
  }
}

std::size_t FieldReader::keyword(const Field& field, std::span<const std::string_view> words) {
  if (failed_) return words.size();
  const bool resuming = numbers_missing_;
  numbers_missing_ = false;
  if (!reading_.tokens.peek().is_value()) {
    if (!resuming) static_cast<void>(value_follows(field, listed(words)));
    failed_ = true;
    return words.size();
  }
  const Token& next = reading_.tokens.peek();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!keyword_matches(next.text, words[i])) continue;
    note_place(field, take(field));
    return i;
  }
  // What follows missing numbers has been complained about already.
  if (resuming)
    failed_ = true;
  else
    structural_error(field, {fmt::format("{} is not a valid choice", field.words), shown(next.text), listed(words),
                             selection_hint(next, words)});
  return words.size();
}

void FieldReader::structural_error(const Field& field, Complaint complaint) {
  if (failed_) return;
  failed_ = true;
  reporter_.error(reading_.tokens.peek(), field.member, std::move(complaint));
}

void FieldReader::pass_over(const Field& field, std::size_t count, Complaint complaint) {
  if (failed_) return;
  reporter_.error(reading_.tokens.peek(), field.member, std::move(complaint));
  for (std::size_t i = 0; i < count && reading_.tokens.peek().is_value(); ++i) static_cast<void>(take(field));
}

void FieldReader::finish() {
  const Token first = reading_.tokens.peek();
  if (!failed_ && first.is_value())
    reporter_.warning(
        first, "",
        {fmt::format("values after the last one of ${} are ignored", shown(command_.text)), shown(first.text),
         "the next command", "a comma separates values: the decimal mark is the point"});
  reading_.tokens.skip_values();
}

void FieldReader::read_block(const Field& field, const FunctionBlock& block, std::span<core::SampledFunction> parts,
                             std::string& file) {
  for (std::size_t i = 0; i < block.count; ++i) {
    const std::string words = fmt::format("interpolation of {}", block.y[i].name);
    select(*this, Field{field.member, words}, interpolations, parts[i].method);
  }
  DataSource source = DataSource::in_script;
  select(*this, Field{field.member, "source of the data"}, data_sources, source);
  if (failed_) return;
  if (source == DataSource::data_file)
    read_file(field, block, parts, file);
  else
    read_inline(field, block, parts);
}

void FieldReader::read_inline(const Field& field, const FunctionBlock& block, std::span<core::SampledFunction> parts) {
  for (std::size_t i = 0; i < block.count && !failed_; ++i) {
    const FunctionText text{block, i, field.member, false};
    switch (read_points(reading_.tokens, text, reporter_, parts[i].knots)) {
      case PointsEnd::complete: break;
      case PointsEnd::keyword: numbers_missing_ = true; return;
      case PointsEnd::broken: failed_ = true; return;
    }
  }
}

void FieldReader::read_file(const Field& field, const FunctionBlock& block, std::span<core::SampledFunction> parts,
                            std::string& file) {
  if (!value_follows(field, "the name of a data file")) return;
  const Token token = take(field);
  file = name_text(token);
  if (file.empty())
    return reporter_.error(token, field.member, {"name of the data file is empty", "", "the name of a file"});
  const DataFileText data = reading_.loader ? reading_.loader(file) : DataFileText{};
  if (!data.failure.empty() || data.path.empty()) {
    const std::string why = data.failure.empty() ? "data file is not available" : data.failure;
    return reporter_.error(token, field.member, {why, shown(file), fmt::format("the data of: {}", block.words)});
  }
  DataFileReading read = read_data_file(data.text, data.path, block);
  for (core::Problem& problem : read.problems) {
    // Rows of tables have no columns of text, arrays no lines.
    const auto& [name, line, column] = problem.place;
    const std::string place = line == 0     ? name
                              : column == 0 ? fmt::format("{}:{}", name, line)
                                            : fmt::format("{}:{}:{}", name, line, column);
    Complaint complaint{fmt::format("data file {}: {}", place, problem.message), problem.found, problem.expected,
                        problem.hint};
    if (problem.severity == core::Severity::error)
      reporter_.error(token, field.member, std::move(complaint));
    else
      reporter_.warning(token, field.member, std::move(complaint));
  }
  for (std::size_t i = 0; i < block.count; ++i) parts[i].knots = std::move(read.functions[i]);
}

}  // namespace sarsim::scene::script

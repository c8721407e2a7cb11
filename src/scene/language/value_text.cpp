#include "scene/language/value_text.hpp"

#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "core/text/json.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/expression.hpp"

namespace sarsim::scene::language {

namespace {

std::string flags_text(const FieldSpec& spec, double sum) {
  const auto bits = static_cast<unsigned>(sum);
  unsigned known = 0;
  std::string text;
  for (const Flag& flag : spec.flags) {
    known |= flag.bit;
    if ((bits & flag.bit) != 0) text += (text.empty() ? "" : ", ") + in_quotes(flag.id);
  }
  return (bits & ~known) == 0 ? "[" + text + "]" : number_text(sum);
}

std::string choice_text(const FieldSpec& spec, int value) {
  for (const Choice& choice : spec.choices)
    if (choice.value == value) return has_words(spec) ? in_quotes(type_word(choice)) : type_word(choice);
  return {};
}

// TOML holds integers of 64 bits with a sign.
std::string seed_text(std::uint64_t seed) {
  const std::string digits = std::to_string(seed);
  return seed > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()) ? in_quotes(digits) : digits;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : core::valid_utf8(text)) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      quoted += c;
  }
  return quoted + "\"";
}

std::string number_text(double number) {
  std::string text = core::format_number(number);
  return text.starts_with('.') ? "0" + text : text;
}

std::string vector_text(const core::Vec3& vector) {
  return fmt::format("[{}, {}, {}]", number_text(vector.x), number_text(vector.y), number_text(vector.z));
}

std::string quantity_value(double number, Quantity quantity) {
  if (quantity == Quantity::number || quantity == Quantity::count) return number_text(number);
  return in_quotes(exact_quantity_text(number, quantity));
}

std::string value_text(const FieldSpec& spec, const FieldValue& value) {
  if (spec.type == FieldType::choice) return choice_text(spec, chosen(value));
  if (const auto* const vector = std::get_if<core::Vec3>(&value)) return vector_text(*vector);
  if (const auto* const text = std::get_if<std::string>(&value)) return in_quotes(*text);
  if (const auto* const yes = std::get_if<bool>(&value)) return *yes ? "true" : "false";
  if (const auto* const seed = std::get_if<std::uint64_t>(&value)) return seed_text(*seed);
  const auto* const number = std::get_if<double>(&value);
  if (number == nullptr) return {};
  return spec.type == FieldType::flags ? flags_text(spec, *number) : quantity_value(*number, spec.quantity);
}

}  // namespace sarsim::scene::language

#include "scene/script/problem_log.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "scene/model/limits.hpp"
#include "scene/schema/quantity.hpp"

namespace sarsim::scene::script {

namespace {

// Length of the longest beginning that is a number by itself.
std::size_t numeric_prefix(std::string_view text) {
  for (std::size_t length = std::min(text.size(), longest_shown); length > 0; --length)
    if (core::parse_number(text.substr(0, length))) return length;
  return 0;
}

bool all_letters(std::string_view text) {
  for (const char c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter) return false;
  }
  return !text.empty();
}

bool is_literal_too_large(std::string_view text) {
  const std::size_t mark = text.find_first_of("eEdD");
  if (mark == std::string_view::npos)
    return text.find_first_not_of("+-.0123456789") == std::string_view::npos && text.size() > 300;
  const std::string_view exponent = text.substr(mark + 1);
  const bool digits = !exponent.empty() && exponent.find_first_not_of("+0123456789") == std::string_view::npos;
  return digits && core::parse_number(text.substr(0, mark)).has_value();
}

// A number with a unit, in another unit of the same quantity; nothing where it has none.
std::optional<double> in_unit(std::string_view text, std::string_view unit) {
  for (int q = 0; q <= static_cast<int>(Quantity::count); ++q) {
    const auto quantity = static_cast<Quantity>(q);
    const auto units = units_of(quantity);
    if (std::ranges::find(units, unit) == units.end()) continue;
    const std::optional<double> value = read_quantity(text, quantity).value;
    const std::optional<double> one = read_quantity(fmt::format("1 {}", unit), quantity).value;
    if (value && one) return core::tidy(*value / *one);
  }
  return std::nullopt;
}

std::string hint_for(std::string_view text, const Field& field) {
  if (text.find('$') != std::string_view::npos) return "a blank is missing before '$'";
  const std::size_t prefix = numeric_prefix(text);
  if (prefix == 0 || prefix == text.size()) return {};
  const std::string_view number = text.substr(0, prefix);
  if (!all_letters(text.substr(prefix))) return {};
  if (field.unit.empty()) return fmt::format("write {}", number);
  if (const auto converted = in_unit(text, field.unit))
    return fmt::format("the unit is fixed ({}): write {}", field.unit, core::format_number(*converted));
  return fmt::format("the unit is fixed ({}): write {}", field.unit, number);
}

std::string expected_number(const Field& field, std::string_view kind) {
  std::string text(kind);
  if (!field.unit.empty()) text += fmt::format(" in {}", field.unit);
  return text + range_text(field.range);
}

// The range in the units of the script, for people.
Field in_script_units(Field field) {
  if (field.shift == 0) return field;
  const double scale = std::pow(10.0, -field.shift);
  field.range.low *= scale;
  field.range.high *= scale;
  return field;
}

bool holds_digit_above_zero(std::string_view text) {
  return text.substr(0, text.find_first_of("eEdD")).find_first_of("123456789") != std::string_view::npos;
}

void report_not_a_number(const Token& token, const Field& field, Reporter& reporter, std::string_view kind) {
  const char* what = is_literal_too_large(token.text) ? "{} is too large a number" : "{} is not a number";
  reporter.error(token, field.member,
                 {fmt::format(fmt::runtime(what), field.words), shown(token.text),
                  expected_number(in_script_units(field), kind), hint_for(token.text, field)});
}

void check_range(const Token& token, const Field& field, Reporter& reporter, double value, std::string_view kind) {
  if (field.range.holds(value)) return;
  reporter.error(token, field.member,
                 {fmt::format("{} is out of range", field.words), shown(token.text),
                  expected_number(in_script_units(field), kind)});
}

// A number that is finite, and yet so large that nothing can be computed with it.
bool check_size(const Token& token, const Field& field, Reporter& reporter, double value) {
  if (computable(value)) return true;
  reporter.error(token, field.member,
                 {fmt::format("{} is too large to compute with", field.words), shown(token.text),
                  fmt::format("a magnitude up to {:g}{}{}", largest_value * std::pow(10.0, -field.shift),
                              field.unit.empty() ? "" : " ", field.unit)});
  return false;
}

}  // namespace

std::string shown(std::string_view text) {
  if (text.size() <= longest_shown) return std::string(text);
  return std::string(text.substr(0, longest_shown)) + "...";
}

void ProblemLog::add(core::Problem problem) {
  std::size_t& count = problem.severity == core::Severity::error ? errors_ : warnings_;
  if (count++ < limit_) problems_.push_back(std::move(problem));
}

core::Problems ProblemLog::take() {
  if (errors_ >= limit_) {
    core::Problem stopped = core::error(fmt::format("reading stopped after {} errors", limit_));
    if (!problems_.empty()) stopped.place = problems_.back().place;
    problems_.push_back(std::move(stopped));
  }
  if (warnings_ > limit_)
    problems_.push_back(core::note(fmt::format("{} more warnings are not shown", warnings_ - limit_)));
  return std::move(problems_);
}

void Reporter::add(core::Severity severity, const Token& token, std::string_view member, Complaint complaint) {
  log_.add(core::ProblemBuilder(severity, std::move(complaint.message))
               .found(std::move(complaint.found))
               .expected(std::move(complaint.expected))
               .hint(std::move(complaint.hint))
               .in(std::string(file_), token.line, token.column)
               .at(std::string(object_.kind), object_.index, std::string(member)));
}

void Reporter::check_spelling(const Token& token, std::string_view member) {
  if (token.comment_follows)
    warning(token, member,
            {"a comment begins right after a value", shown(token.text) + "!", "",
             "put a blank before the '!', or quotes around a name that holds one"});
  if (token.open_quote)
    error(token, member, {"a quote is not closed", "\"" + shown(token.text), "a second '\"' on the same line", ""});
}

bool plain_number(const Token& token, int shift, const Range& range, double& value) {
  if (token.comment_follows || token.open_quote) return false;
  const std::optional<double> number = core::parse_number(token.text, shift);
  if (!number) return false;
  const double read = *number;
  if (read == 0.0 && holds_digit_above_zero(token.text)) return false;
  if (!computable(read) || !range.holds(read)) return false;
  value = read;
  return true;
}

bool read_number(const Token& token, const Field& field, Reporter& reporter, double& value) {
  const std::optional<double> number = core::parse_number(token.text, field.shift);
  if (!number) {
    report_not_a_number(token, field, reporter, "a number");
    return false;
  }
  value = *number;
  if (value == 0.0 && holds_digit_above_zero(token.text))
    reporter.warning(token, field.member,
                     {fmt::format("{} is too small for a number and counts as zero", field.words), shown(token.text)});
  if (!check_size(token, field, reporter, value)) return false;
  check_range(token, field, reporter, value, "a number");
  return true;
}

bool read_integer(const Token& token, const Field& field, Reporter& reporter, std::int64_t& value) {
  std::optional<std::int64_t> number = core::parse_integer(token.text);
  if (!number) {
    const std::optional<double> real = core::parse_number(token.text);
    if (real && *real == std::trunc(*real) && std::abs(*real) < 9e15) number = static_cast<std::int64_t>(*real);
    if (!number && real) {
      const char* what = *real == std::trunc(*real) ? "{} is too large" : "{} is not a whole number";
      reporter.error(
          token, field.member,
          {fmt::format(fmt::runtime(what), field.words), shown(token.text), expected_number(field, "a whole number")});
      return false;
    }
  }
  if (!number) {
    report_not_a_number(token, field, reporter, "a whole number");
    return false;
  }
  value = *number;
  check_range(token, field, reporter, static_cast<double>(value), "a whole number");
  return true;
}

}  // namespace sarsim::scene::script

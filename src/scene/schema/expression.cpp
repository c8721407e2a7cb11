#include "scene/schema/expression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/unit_functions.hpp"
#include "scene/schema/unit_source.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::scene {

namespace {

// The value of an expression, or why it has none.
struct Evaluated {
  std::optional<Measured> measured;
  ExpressionFault fault;  // Where there is no value.
  std::size_t begin = 0;  // Bytes of the text that are not blank at its ends.
  std::size_t end = 0;
  bool literal = false;  // One number, alone or with units.
  std::string hint;      // What to write instead where the dimension is not the wanted one; may be empty.
};

constexpr int deepest = 100;

// A part of an expression that has a value.
struct Operand {
  enum class Form { number, with_unit, unit, other };

  Measured measured;
  std::size_t begin = 0;
  std::size_t end = 0;
  Form form = Form::other;
};

using Maybe = std::optional<Operand>;

// Computes while it reads; the first fault ends it.
class Evaluation {
 public:
  Evaluation(std::string_view text, const LetNames& names) : source_(text), text_(source_.plain()), names_(names) {}

  Evaluated take();

 private:
  Maybe whole();
  Maybe sum();
  Maybe product();
  Maybe signed_factor();
  Maybe signed_within();
  Maybe factor();
  Maybe bracket();
  Maybe number(bool negative);
  Maybe number_with_unit(std::size_t begin, std::string_view digits, bool negative);
  Maybe word();
  Maybe call(const Function& function, std::size_t begin);
  bool closed(std::size_t opened);

  Maybe added(const Operand& left, const Operand& right, bool minus);
  Maybe multiplied(const Operand& left, const Operand& right, bool divide);
  Maybe raised_by_following(Maybe base);
  std::optional<Dimension> raised_dimension(const Operand& base, const Operand& exponent);
  std::optional<Dimension> dimension_of_call(const Function& function, const std::vector<Operand>& arguments);
  Maybe applied(const Function& function, const std::vector<Operand>& arguments, std::size_t begin);

  Maybe fail(std::size_t begin, std::size_t end, std::string message, std::string expected = {}, std::string hint = {});
  Maybe fail_at_end();
  Maybe fail_before_operand();
  Maybe fail_behind_operand();
  Maybe fail_in_number(std::size_t begin);
  Maybe fail_as_unit(std::size_t begin, std::string_view digits, std::string_view word, UnitSearch search);
  Maybe fail_unknown(std::string_view name, std::size_t begin, std::string_view what, std::string_view expected);
  Maybe finite(const Operand& result, bool no_value, std::string_view expected = {});

  // The next character that is no blank; a zero at the end.
  char next() {
    while (at_ < text_.size() && core::is_blank(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  [[nodiscard]] std::size_t token_end(std::size_t begin) const;
  [[nodiscard]] std::string_view unit_word() const {
    return at_ < text_.size() && text_[at_] == '\'' ? text_.substr(at_, 1) : word_at(text_, at_);
  }
  [[nodiscard]] bool is_other_word(std::string_view word) const {
    return names_.contains(word) || function_named(word) != nullptr || constant_named(word) != nullptr;
  }
  [[nodiscard]] std::size_t sampling_unit_length(std::string_view word) const;
  bool level_follows();
  [[nodiscard]] std::string quote(const Operand& part) const { return source_.quote(part.begin, part.end); }

  Source source_;
  std::string_view text_;
  const LetNames& names_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool commas_ = false;  // whether they separate arguments here
  std::size_t numbers_ = 0;
  bool compound_ = false;
  std::string divided_twice_;  // what to write instead of "/ 240 m/s", where there is such a thing
  ExpressionFault fault_;
};

Maybe Evaluation::fail(std::size_t begin, std::size_t end, std::string message, std::string expected,
                       std::string hint) {
  fault_ = {source_.origin(begin), source_.origin(end), std::move(message), std::move(expected), std::move(hint)};
  return std::nullopt;
}

Maybe Evaluation::fail_at_end() {
  std::size_t end = text_.size();
  while (end > 0 && core::is_blank(text_[end - 1])) --end;
  if (end == 0) return fail(0, text_.size(), "nothing is written", "a number, a unit or an expression");
  return fail(end - 1, end, fmt::format("{} ends too early", quoted(source_.typed())),
              fmt::format("a number, a name or '(' behind '{}'", text_[end - 1]));
}

std::size_t Evaluation::token_end(std::size_t begin) const {
  if (const std::string_view word = word_at(text_, begin); !word.empty()) return begin + word.size();
  std::size_t end = begin + std::max<std::size_t>(number_length(text_.substr(begin, 1)), 1);
  while (end < text_.size() && core::is_digit(text_[begin]) && begins_number(text_[end])) ++end;
  while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
  return end;
}

// What stands where a number, a name or '(' should.
Maybe Evaluation::fail_before_operand() {
  if (at_ == text_.size()) return fail_at_end();
  const std::size_t end = token_end(at_);
  const char c = text_[at_];
  if (c == ',' && !commas_ && end < text_.size() && core::is_digit(text_[end])) return fail_in_number(at_);
  const std::string found = source_.quote(at_, end);
  if (std::string_view("*/^),").find(c) == std::string_view::npos)
    return fail(at_, end, fmt::format("{} does not belong in an expression", found), "a number, a unit, a name or '('");
  return fail(at_, end, fmt::format("a number or a name is missing before {}", found), {},
              c == '*' && at_ > 0 && text_[at_ - 1] == '*' ? "a power is written with ^" : "");
}

// What stands where an operator or the end should.
Maybe Evaluation::fail_behind_operand() {
  const std::size_t end = token_end(at_);
  const char c = text_[at_];
  const std::string found = source_.quote(at_, end);
  if (c == ')') return fail(at_, end, "')' closes nothing", {}, "remove it, or add '(' before it");
  if (c == ',') return fail(at_, end, "',' is outside the arguments of a function");
  if (c != '(' && !begins_number(c) && !begins_word(c))
    return fail(at_, end, fmt::format("{} does not belong in an expression", found), "an operator or the end");
  return fail(at_, end, fmt::format("an operator is missing before {}", found), "+, -, *, / or ^",
              "a product is written with *");
}

// A comma, a point, or digits behind a blank follow a number.
Maybe Evaluation::fail_in_number(std::size_t begin) {
  const bool per_second = begin < at_ && begins_with_per_second(text_.substr(at_));
  const std::size_t end = per_second ? at_ + 3 : std::min(text_.find_first_not_of("0123456789.,", at_), text_.size());
  const std::string_view whole = text_.substr(begin, end - begin);
  std::string message = begin == at_ ? comma_failure(source_.typed(), "0" + std::string(whole))
                                     : broken_number(source_.typed(), whole, text_.substr(at_, end - at_));
  return fail(begin, end, std::move(message));
}

Maybe Evaluation::fail_unknown(std::string_view name, std::size_t begin, std::string_view what,
                               std::string_view expected) {
  std::vector<std::string_view> candidates = names_.all();
  for (const Quantity quantity : every_quantity)
    for (const Unit& unit : unit_table(quantity)) candidates.push_back(unit.name);
  for (const Constant& constant : constants()) candidates.push_back(constant.name);
  if (what == "function") candidates.clear();
  for (const Function& function : functions()) candidates.push_back(function.name);
  std::string nearest(what == "function" ? std::string_view() : unit_meant_by(name));
  if (nearest.empty()) nearest = core::nearest_word(name, candidates);
  // A single letter is near to every other one.
  if (name.size() == 1 && !core::equal_ignoring_case(name, nearest) && unit_meant_by(name).empty()) nearest.clear();
  return fail(begin, begin + name.size(), fmt::format("{} is not a known {}", quoted(name), what),
              std::string(expected), nearest.empty() ? std::string() : fmt::format("did you mean '{}'?", nearest));
}

Maybe Evaluation::finite(const Operand& result, bool no_value, std::string_view expected) {
  if (std::isfinite(result.measured.value)) return result;
  return fail(result.begin, result.end,
              fmt::format("{} {}", quote(result), no_value ? "has no value" : "is too large for a number"),
              std::string(expected));
}

Maybe Evaluation::whole() {
  Maybe result = sum();
  next();
  if (result && at_ < text_.size()) return fail_behind_operand();
  return result;
}

Maybe Evaluation::sum() {
  Maybe left = product();
  while (left && (next() == '+' || next() == '-')) {
    compound_ = true;
    const bool minus = text_[at_++] == '-';
    const Maybe right = product();
    if (!right) return right;
    left = added(*left, *right, minus);
  }
  return left;
}

Maybe Evaluation::added(const Operand& left, const Operand& right, bool minus) {
  const Dimension& a = left.measured.dimension;
  const Dimension& b = right.measured.dimension;
  if (a == b) {
    const double value = left.measured.value + (minus ? -right.measured.value : right.measured.value);
    return finite({{value, a}, left.begin, right.end}, false);
  }
  const Dimension decibels = dimension_of(Quantity::ratio_db);
  std::string hint = divided_twice_;
  if (a.pure() || b.pure())
    hint = fmt::format("does {} lack a unit?", quote(a.pure() ? left : right));
  else if (a == decibels || b == decibels)
    hint = "a level is held in W or m2; to add 3 dB, multiply it by 10^(3/10)";
  return fail(left.begin, right.end,
              fmt::format("{} is {}, {} is {}", quote(left), dimension_text(a), quote(right), dimension_text(b)),
              "values of one kind in a sum or difference", std::move(hint));
}

Maybe Evaluation::product() {
  Maybe left = signed_factor();
  std::size_t divisor = text_.size();  // where that of a division by a number with a unit begins, which is the last one
  while (left && (next() == '*' || next() == '/')) {
    const bool divide = text_[at_++] == '/';
    const Maybe right = signed_factor();
    if (!right) return right;
    const bool by_unit = divide && right->form == Operand::Form::unit;
    if (by_unit && divisor < right->begin && divided_twice_.empty())
      divided_twice_ = fmt::format("write / ({}) to divide by all of it", source_.part(divisor, right->end));
    if (!by_unit) compound_ = true;
    divisor = divide && right->form == Operand::Form::with_unit ? right->begin : text_.size();
    left = multiplied(*left, *right, divide);
  }
  return left;
}

Maybe Evaluation::multiplied(const Operand& left, const Operand& right, bool divide) {
  const auto dimension = scene::product(left.measured.dimension, right.measured.dimension, divide ? -1 : 1);
  if (!dimension)
    return fail(
        left.begin, right.end,
        fmt::format("{} is {}, {} is {}: there is no {} of them", quote(left), dimension_text(left.measured.dimension),
                    quote(right), dimension_text(right.measured.dimension), divide ? "quotient" : "product"),
        {}, "decibels are added, or multiplied by pure numbers; powers of units go to 99");
  const double a = left.measured.value;
  const double b = right.measured.value;
  const Operand result{{divide ? a / b : a * b, *dimension}, left.begin, right.end};
  if (divide && b == 0.0) return fail(left.begin, right.end, quote(result) + " divides by zero", "another divisor");
  return finite(result, false);
}

Maybe Evaluation::signed_factor() {
  if (depth_ > deepest)
    return fail(at_, std::min(at_ + 1, text_.size()),
                fmt::format("the expression is nested more than {} deep", deepest), {},
                "give its parts names in [let]");
  ++depth_;
  Maybe result = signed_within();
  --depth_;
  return result;
}

Maybe Evaluation::signed_within() {
  const char sign = next();
  if (sign != '-' && sign != '+') return raised_by_following(factor());
  const std::size_t begin = at_++;
  const bool level = level_follows();
  Maybe result = level ? raised_by_following(number(sign == '-')) : signed_factor();
  if (!result) return result;
  if (sign == '-' && !level) result->measured.value = -result->measured.value;
  result->begin = begin;
  return result;
}

// Whether a number with dBm or the like is next: a sign before it is one of the number, not of the watts.
bool Evaluation::level_follows() {
  next();
  const std::size_t begin = at_;
  at_ += number_length(text_.substr(at_));
  bool level = false;
  if (at_ > begin && begins_number(text_[begin])) {
    next();
    const UnitSearch search = find_unit(unit_word(), {});
    level = search.unit != nullptr && search.unit->is_level();
  }
  at_ = begin;
  return level;
}

Maybe Evaluation::raised_by_following(Maybe base) {
  if (!base || next() != '^') return base;
  const std::size_t numbers = numbers_;
  const bool unit = base->form == Operand::Form::unit;
  ++at_;
  const Maybe exponent = signed_factor();
  if (!exponent) return exponent;
  const auto dimension = raised_dimension(*base, *exponent);
  if (!dimension) return std::nullopt;
  if (unit) numbers_ = numbers;
  compound_ = compound_ || !unit;
  const double value = std::pow(base->measured.value, exponent->measured.value);
  const bool no_value = std::isnan(value) || base->measured.value == 0.0;
  return finite({{value, *dimension}, base->begin, exponent->end, unit ? base->form : Operand::Form::other}, no_value);
}

std::optional<Dimension> Evaluation::raised_dimension(const Operand& base, const Operand& exponent) {
  const Dimension& power = exponent.measured.dimension;
  auto dimension = power.pure() ? raised(base.measured.dimension, exponent.measured.value) : std::nullopt;
  if (!power.pure())
    fail(exponent.begin, exponent.end, fmt::format("{} is {}", quote(exponent), dimension_text(power)),
         "a pure number as exponent");
  else if (!dimension)
    fail(base.begin, exponent.end,
         fmt::format("{} is {}, which has no power {}", quote(base), dimension_text(base.measured.dimension),
                     core::format_number(exponent.measured.value)),
         "a whole exponent, or 0.5 where all units have even powers; none of decibels");
  return dimension;
}

Maybe Evaluation::factor() {
  const char c = next();
  if (c == '(') return bracket();
  if (begins_word(c)) return word();
  if (begins_number(c) && number_length(text_.substr(at_, 2)) > 0) return number(false);
  return fail_before_operand();
}

Maybe Evaluation::bracket() {
  const std::size_t begin = at_++;
  const bool outside = std::exchange(commas_, false);
  Maybe result = sum();
  if (!result || !closed(begin)) return std::nullopt;
  commas_ = outside;
  compound_ = true;
  return Operand{result->measured, begin, at_};
}

// Takes the ')' that must be next.
bool Evaluation::closed(std::size_t opened) {
  if (next() == ')') {
    ++at_;
    return true;
  }
  if (at_ == text_.size())
    fail(opened, opened + 1, "'(' is not closed", "')' behind it");
  else
    fail_behind_operand();
  return false;
}

Maybe Evaluation::number(bool negative) {
  next();
  const std::size_t begin = at_;
  const std::string_view digits = text_.substr(begin, number_length(text_.substr(begin)));
  ++numbers_;
  at_ += digits.size();
  const char c = next();
  if (!unit_word().empty()) return number_with_unit(begin, digits, negative);
  if (begins_number(c) || (c == ',' && !commas_)) return fail_in_number(begin);
  const std::size_t end = begin + digits.size();
  const std::optional<double> value = core::parse_number(digits);
  return finite({{value.value_or(HUGE_VAL), {}}, begin, end, Operand::Form::number}, false);
}

// The length of a unit of samples per second, "MS/s" or "MSa/s", that begins with a word: not of milliseconds. Zero
// where there is none.
std::size_t Evaluation::sampling_unit_length(std::string_view word) const {
  constexpr std::string_view per_second = "/s";
  if (names_.contains(word) || !(word.ends_with("S") || word.ends_with("Sa"))) return 0;
  const std::size_t slash = at_ + word.size();
  if (word_at(text_, slash + 1) != "s" || !text_.substr(slash).starts_with(per_second)) return 0;
  const std::size_t length = word.size() + per_second.size();
  return unit_meant_by(text_.substr(at_, length)).empty() ? 0 : length;
}

Maybe Evaluation::number_with_unit(std::size_t begin, std::string_view digits, bool negative) {
  const std::string_view typed = unit_word();
  if (const std::size_t length = sampling_unit_length(typed); length > 0) {
    const std::string_view unit = text_.substr(at_, length);
    return fail(at_, at_ + length, fmt::format("{} is not a known unit", quoted(unit)), {},
                fmt::format("write {} {}", core::clipped(digits), unit_meant_by(unit)));
  }
  UnitSearch search = unit_called(typed);
  if (search.unit != nullptr && search.unit->yields && names_.contains(typed)) search = {};
  if (search.unit == nullptr && !is_other_word(typed)) search = find_unit(typed, source_.typed());
  if (search.unit == nullptr) return fail_as_unit(begin, digits, typed, std::move(search));
  const Unit& unit = *search.unit;
  Operand one{{1.0, dimension_of(search.quantity)}, at_, at_ + typed.size(), Operand::Form::unit};
  Operand result{one.measured, begin, one.end, Operand::Form::with_unit};
  at_ = one.end;
  double power = 1.0;
  if (next() == '^' && !unit.is_level()) {
    ++at_;
    const Maybe exponent = signed_factor();
    const auto dimension = exponent ? raised_dimension(one, *exponent) : std::nullopt;
    if (!dimension) return std::nullopt;
    power = exponent->measured.value;
    if (exponent->form == Operand::Form::number) --numbers_;
    result = {{1.0, *dimension}, begin, exponent->end, Operand::Form::with_unit};
  }
  // Level units take the sign with them, all others leave it to the caller.
  const std::string with_sign = negative ? "-" + std::string(digits) : std::string();
  std::optional<double> value;
  if (power == 1.0)
    value = in_base_unit(negative ? with_sign : digits, unit);
  else if (unit.law == Unit::Law::decimal && power == std::floor(power))
    value = core::parse_number(digits, unit.exponent * static_cast<int>(power));
  else
    value = core::parse_number(digits).value_or(HUGE_VAL) * std::pow(*in_base_unit("1", unit), power);
  result.measured.value = value.value_or(HUGE_VAL);
  return finite(result, false);
}

Maybe Evaluation::fail_as_unit(std::size_t begin, std::string_view digits, std::string_view word, UnitSearch search) {
  const std::size_t end = at_ + word.size();
  if (is_other_word(word))
    return fail(begin, end, fmt::format("an operator is missing between {} and {}", quoted(digits), quoted(word)), {},
                fmt::format("write {}*{}", core::clipped(digits), core::clipped(word)));
  if (!search.failure.empty()) return fail(at_, end, std::move(search.failure));
  if (core::equal_ignoring_case(word, "bit") || core::equal_ignoring_case(word, "bits"))
    return fail(at_, end, fmt::format("{} is not a known unit", quoted(word)), {},
                fmt::format("write {}", core::clipped(digits)));
  return fail_unknown(word, at_, "unit", "a unit or an operator behind the number");
}

Maybe Evaluation::word() {
  const std::size_t begin = at_;
  const std::string_view name = word_at(text_, begin);
  const std::size_t end = at_ = begin + name.size();
  if (const Function* function = function_named(name)) {
    if (next() == '(') return call(*function, begin);
    // "min" is a unit as well: "6 deg/min".
    if (unit_called(name).unit == nullptr)
      return fail(begin, end, fmt::format("'{}' is a function", name), fmt::format("'(' behind it: {}(...)", name));
  }
  if (const UnitSearch search = unit_called(name);
      search.unit != nullptr && !(search.unit->yields && names_.contains(name))) {
    if (search.unit->is_level())
      return fail(begin, end, fmt::format("'{}' is a level", name), "a number directly before it",
                  fmt::format("write 30 {}", name));
    return Operand{{*in_base_unit("1", *search.unit), dimension_of(search.quantity)}, begin, end, Operand::Form::unit};
  }
  compound_ = true;
  if (const Constant* constant = constant_named(name))
    return Operand{{constant->value, constant->dimension}, begin, end};
  if (const Measured* value = names_.find(name)) return Operand{*value, begin, end};
  if (!names_.contains(name))
    return fail_unknown(name, begin, next() == '(' ? "function" : "name or unit",
                        "a unit, a name of [let], pi, c or a function");
  fail(begin, end, fmt::format("{} of [let] has no value", quoted(name)));
  fault_.follows = true;
  return std::nullopt;
}

Maybe Evaluation::call(const Function& function, std::size_t begin) {
  const std::size_t opened = at_;
  const bool outside = std::exchange(commas_, true);
  std::vector<Operand> arguments;
  do {
    ++at_;
    const Maybe argument = sum();
    if (!argument) return argument;
    arguments.push_back(*argument);
  } while (next() == ',');
  if (!closed(opened)) return std::nullopt;
  commas_ = outside;
  compound_ = true;
  return applied(function, arguments, begin);
}

std::optional<Dimension> Evaluation::dimension_of_call(const Function& function,
                                                       const std::vector<Operand>& arguments) {
  using Rule = Function::Rule;
  const Dimension& first = arguments.front().measured.dimension;
  const Dimension angle = dimension_of(Quantity::angle);
  const auto refuse_argument = [&](const Operand& argument, std::string_view expected) {
    fail(argument.begin, argument.end,
         fmt::format("{} is {}", quote(argument), dimension_text(argument.measured.dimension)),
         fmt::format("{} as argument of {}", expected, function.name));
    return std::nullopt;
  };
  for (const Operand& argument : arguments)
    if (argument.measured.dimension != first) return refuse_argument(argument, dimension_text(first));
  switch (function.rule) {
    case Rule::like: return first;
    case Rule::to_angle: return angle;
    case Rule::of_angle:
      if (first == angle || first.pure()) return Dimension{};
      return refuse_argument(arguments.front(), "an angle, or a pure number in radians,");
    case Rule::root:
      if (const auto half = raised(first, 0.5)) return half;
      return refuse_argument(arguments.front(), "even powers of all units");
    case Rule::pure:
    case Rule::pure_to_angle: break;
  }
  if (!first.pure()) return refuse_argument(arguments.front(), "a pure number");
  return function.rule == Rule::pure ? Dimension{} : angle;
}

Maybe Evaluation::applied(const Function& function, const std::vector<Operand>& arguments, std::size_t begin) {
  const std::size_t count = arguments.size();
  if (count < function.least || count > function.most) {
    const bool decimals = count == function.most + 1 && arguments.back().form != Operand::Form::other;
    return fail(
        begin, at_, fmt::format("{} has {} argument{}", source_.quote(begin, at_), count, count == 1 ? "" : "s"),
        fmt::format("{}{} for {}", function.most > function.least ? "at least " : "", function.least, function.name),
        decimals ? "a comma separates arguments; the decimal mark is the point" : "");
  }
  const auto dimension = dimension_of_call(function, arguments);
  if (!dimension) return std::nullopt;
  double value = arguments.front().measured.value;
  if (function.of_radians != nullptr && arguments.front().measured.dimension.pure())
    value = function.of_radians(value);
  else if (count == 1)
    value = function.apply(value, 0.0);
  for (std::size_t i = 1; i < count; ++i) value = function.apply(value, arguments[i].measured.value);
  return finite({{value, *dimension}, begin, at_}, true, function.domain);
}

Evaluated Evaluation::take() {
  const Maybe result = whole();
  if (!result) return {.measured = {}, .fault = std::move(fault_), .hint = {}};
  return {.measured = result->measured,
          .fault = {},
          .begin = source_.origin(result->begin),
          .end = source_.origin(result->end),
          .literal = numbers_ == 1 && !compound_,
          .hint = std::move(divided_twice_)};
}

// Evaluates an expression, whatever it measures.
Evaluated evaluated(std::string_view text, const LetNames& names) { return Evaluation(text, names).take(); }

// Where a name stands on the path of `LetNames::resolve_from`, where it does not.
constexpr std::size_t unseen = std::numeric_limits<std::size_t>::max();
constexpr std::size_t done = unseen - 1;
constexpr std::size_t longest_chain = 8;

ExpressionFault other_dimension(std::string_view text, const Evaluated& found, Quantity quantity) {
  const Dimension wanted = dimension_of(quantity);
  const std::string units = units_listed(quantity);
  ExpressionFault fault{found.begin, found.end, {}, {}, found.hint};
  fault.message = fmt::format("{} is {}; the field takes {}{}", quoted(text), dimension_text(found.measured->dimension),
                              with_article(noun_of(quantity)), units.empty() ? " without a unit" : ", in " + units);
  Dimension straight = found.measured->dimension;
  const int turns = std::exchange(straight.powers[Dimension::degree], wanted.powers[Dimension::degree]) -
                    wanted.powers[Dimension::degree];
  if (fault.hint.empty() && straight == wanted && std::abs(turns) == 1)
    fault.hint = fmt::format("an angle is a unit of its own; {} by 1 rad", turns > 0 ? "divide" : "multiply");
  return fault;
}

ExpressionFault no_whole_number(std::string_view text, const Evaluated& found) {
  return {found.begin, found.end, quoted(text) + " is not a whole number", "a whole number",
          fmt::format("try {}", core::format_number(std::round(found.measured->value)))};
}

// Why a name cannot be one of [let].
std::optional<ExpressionFault> name_fault(std::string_view name) {
  const auto fault = [&](std::string message, std::string expected, std::string hint) {
    return ExpressionFault{0, name.size(), std::move(message), std::move(expected), std::move(hint)};
  };
  const auto taken = [&](std::string_view by) {
    return fault(fmt::format("'{}' is the name of a {}", name, by), "another name", fmt::format("write {}_1", name));
  };
  if (const Unit* const unit = unit_called(name).unit; unit != nullptr && !unit->yields) return taken("unit");
  if (constant_named(name) != nullptr) return taken("constant");
  if (function_named(name) != nullptr) return taken("function");
  if (!name.empty() && word_at(name, 0).size() == name.size()) return std::nullopt;
  std::string corrected(name);
  for (char& c : corrected)
    if (!begins_word(c) && !core::is_digit(c)) c = '_';
  if (corrected.empty() || !begins_word(corrected.front())) corrected.insert(0, "_");
  return fault(fmt::format("{} is not a valid name", quoted(name)),
               "letters A to Z, digits and underscores, no digit in front", fmt::format("write {}", quoted(corrected)));
}

// The value of a number with one unit in plain characters, which nearly all texts are; nothing for all others.
std::optional<double> plain_literal(std::string_view text, Quantity quantity, bool& bare) {
  const std::size_t length = number_length(text);
  if (length == 0) return std::nullopt;
  const std::string_view unit = core::trimmed(text.substr(length));
  bare = unit.empty();
  if (bare) return core::parse_number(text.substr(0, length));
  for (const Unit& candidate : unit_table(quantity))
    if (candidate.name == unit) return in_base_unit(text.substr(0, length), candidate);
  return std::nullopt;
}

// Whether a text is a ratio written as "x100", and no name.
bool is_factor(std::string_view text, const LetNames& names) {
  if (names.contains(text)) return false;
  const std::string plain = plain_text(text);
  if (plain.empty() || core::lower(plain.front()) != 'x') return false;
  const std::string_view number = core::trimmed(std::string_view(plain).substr(1));
  return !number.empty() && number_length(number) == number.size();
}

QuantityResult read_factor(std::string_view text) {
  QuantityReading reading = read_quantity(text, Quantity::ratio_db);
  if (reading.value) return {.value = reading.value, .fault = {}, .literal = true};
  return {.value = {}, .fault = ExpressionFault{0, text.size(), std::move(reading.failure)}};
}

}  // namespace

QuantityResult evaluate(std::string_view text, Quantity quantity, const LetNames& names) {
  bool bare = false;
  const bool has_units = !unit_table(quantity).empty();
  const auto suits = [&](double value) { return quantity != Quantity::count || value == std::floor(value); };
  const std::string_view typed = core::trimmed(text);
  if (const auto value = plain_literal(typed, quantity, bare); value && suits(*value))
    return {.value = value, .fault = {}, .literal = true, .bare = bare && has_units};
  if (quantity == Quantity::ratio_db && is_factor(typed, names)) return read_factor(text);

  Evaluated found = evaluated(text, names);
  if (!found.measured) return {.value = {}, .fault = std::move(found.fault)};
  const bool pure = found.measured->dimension.pure();
  if (!pure && found.measured->dimension != dimension_of(quantity))
    return {.value = {}, .fault = other_dimension(text, found, quantity), .other = found.measured};
  if (!suits(found.measured->value)) return {.value = {}, .fault = no_whole_number(text, found)};
  return {.value = found.measured->value, .fault = {}, .literal = found.literal, .bare = pure && has_units};
}

std::string exact_quantity_text(double value, Quantity quantity) {
  std::string text = quantity_text(value, quantity);
  return value == 0.0 && std::signbit(value) ? "-" + text : text;
}

void LetNames::define(std::string name, double value) { define(std::move(name), Measured{value, {}}); }

void LetNames::define(std::string name, const Measured& value) {
  Entry entry{std::move(name), {}, false, value, {}, false};
  if (!std::isfinite(value.value)) {
    entry.value = std::nullopt;
    entry.fault =
        ExpressionFault{0, 0, core::format_number(value.value) + " is not a number to compute with", "a finite number"};
  }
  add(std::move(entry));
}

void LetNames::define(std::string name, std::string expression) {
  add({std::move(name), std::move(expression), true, {}, {}, false});
}

void LetNames::add(Entry entry) {
  if (auto fault = name_fault(entry.name)) {
    entry = {std::move(entry.name), {}, false, {}, std::move(fault), true};
    entries_.push_back(std::move(entry));
    return;
  }
  const auto [place, added] = places_.try_emplace(entry.name, entries_.size());
  if (added)
    entries_.push_back(std::move(entry));
  else
    entries_[place->second] = std::move(entry);
}

const Measured* LetNames::find(std::string_view name) const {
  const auto found = places_.find(name);
  if (found == places_.end() || !entries_[found->second].value) return nullptr;
  return &*entries_[found->second].value;
}

std::vector<std::string_view> LetNames::all() const {
  std::vector<std::string_view> names;
  names.reserve(places_.size());
  for (const auto& [name, place] : places_) names.emplace_back(name);
  return names;
}

std::vector<NameFault> LetNames::resolve() {
  for (Entry& entry : entries_)
    if (entry.computed) entry.value = std::nullopt, entry.fault = std::nullopt;
  std::vector<std::size_t> positions(entries_.size(), unseen);
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (entries_[i].computed && positions[i] == unseen) resolve_from(i, positions);
  std::vector<NameFault> faults;
  for (const Entry& entry : entries_)
    if (entry.fault) faults.push_back({entry.name, entry.of_name, *entry.fault});
  return faults;
}

// Depth first, without recursion, because a chain of names may be of any length: a name is computed when all that its
// expression uses has been. One that leads back to itself meets a name without a value, and so gets none.
void LetNames::resolve_from(std::size_t first, std::vector<std::size_t>& positions) {
  struct Step {
    std::size_t entry;
    std::vector<ExpressionWord> words;
    std::size_t next = 0;
  };
  std::vector<Step> path;
  const auto enter = [&](std::size_t entry) {
    positions[entry] = path.size();
    path.push_back({entry, words_of(entries_[entry].expression)});
  };
  const auto report_cycle = [&](std::size_t start) {
    Entry& entry = entries_[path[start].entry];
    const ExpressionWord& word = path[start].words[path[start].next - 1];
    std::string chain;
    for (std::size_t i = start; i < std::min(path.size(), start + longest_chain); ++i)
      chain += core::clipped(entries_[path[i].entry].name) + " -> ";
    if (path.size() - start > longest_chain) chain += "... -> ";
    entry.fault = ExpressionFault{word.begin,
                                  word.end,
                                  quoted(entry.name) + " depends on itself: " + chain + core::clipped(entry.name),
                                  {},
                                  "give one of these names a value without the others"};
  };
  enter(first);
  while (!path.empty()) {
    Step& step = path.back();
    if (step.next == step.words.size()) {
      compute(entries_[step.entry]);
      positions[step.entry] = done;
      path.pop_back();
      continue;
    }
    const auto used = places_.find(step.words[step.next++].name);
    if (used == places_.end() || !entries_[used->second].computed) continue;
    const std::size_t position = positions[used->second];
    if (position == unseen)
      enter(used->second);
    else if (position != done && !entries_[used->second].fault)
      report_cycle(position);
  }
}

void LetNames::compute(Entry& entry) const {
  Evaluated found = evaluated(entry.expression, *this);
  entry.value = found.measured;
  if (!found.measured && !found.fault.follows && !entry.fault) entry.fault = std::move(found.fault);
}

}  // namespace sarsim::scene

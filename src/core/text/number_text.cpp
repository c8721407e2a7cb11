#include "core/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "core/text/letters.hpp"

namespace sarsim::core {

namespace {

// Splits a decimal literal into the part before the exponent and the exponent's value.
struct Literal {
  bool negative = false;
  std::string_view mantissa;
  std::int64_t exponent = 0;
};

std::optional<Literal> split_literal(std::string_view text) {
  Literal literal;
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) literal.negative = text[i++] == '-';
  const std::size_t start = i;
  std::size_t digits = 0;
  while (i < text.size() && is_digit(text[i])) ++i, ++digits;
  if (i < text.size() && text[i] == '.') ++i;
  while (i < text.size() && is_digit(text[i])) ++i, ++digits;
  if (digits == 0) return std::nullopt;
  literal.mantissa = text.substr(start, i - start);
  if (i == text.size()) return literal;
  const char mark = lower(text[i]);
  if (mark != 'e' && mark != 'd') return std::nullopt;
  ++i;
  bool negative = false;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) negative = text[i++] == '-';
  if (i == text.size()) return std::nullopt;
  for (; i < text.size(); ++i) {
    if (!is_digit(text[i])) return std::nullopt;
    literal.exponent = std::min<std::int64_t>(literal.exponent * 10 + (text[i] - '0'), 100'000'000);
  }
  if (negative) literal.exponent = -literal.exponent;
  return literal;
}

// Decimal places of a mantissa before its point, negative for zeros behind it: 3 for "0123.4", -2 for "0.001".
std::int64_t magnitude(std::string_view mantissa) {
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return 0;
  const auto places = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  return places > 0 ? places : places + 1;
}

// A literal of few digits without an exponent, which is nearly every one: its digits as a whole number and the power of
// ten are exact doubles, so that their product or quotient is rounded only once.
std::optional<double> parse_short(std::string_view text, int exponent_shift) {
  static constexpr std::array<double, 23> exact_powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                       1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                       1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::uint64_t largest_exact = std::uint64_t{1} << 53;
  constexpr std::size_t longest = 20;
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.size() > longest) return std::nullopt;
  std::uint64_t digits = 0;
  std::size_t point = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_digit(text[i]))
      digits = 10 * digits + static_cast<std::uint64_t>(text[i] - '0');
    else if (text[i] == '.' && point == text.size())
      point = i;
    else
      return std::nullopt;
  }
  const bool whole = point == text.size();
  const std::size_t count = text.size() - (whole ? 0 : 1);
  if (count == 0 || count > 18 || digits > largest_exact) return std::nullopt;
  const int exponent = exponent_shift - static_cast<int>(whole ? 0 : text.size() - point - 1);
  if (std::abs(exponent) >= static_cast<int>(exact_powers.size())) return std::nullopt;
  const auto number = static_cast<double>(digits);
  const double power = exact_powers[static_cast<std::size_t>(std::abs(exponent))];
  const double value = exponent < 0 ? number / power : number * power;
  return negative ? -value : value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text, int exponent_shift) {
  if (const std::optional<double> value = parse_short(text, exponent_shift)) return value;
  const auto literal = split_literal(text);
  if (!literal) return std::nullopt;
  const std::int64_t exponent = literal->exponent + exponent_shift;
  std::string shifted;
  std::string_view digits = literal->mantissa;
  if (exponent != 0) digits = shifted = fmt::format("{}e{}", literal->mantissa, exponent);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) {
    // from_chars does not say which side was left; the place of the first digit that counts does.
    if (magnitude(literal->mantissa) + exponent > 0) return std::nullopt;
    value = 0.0;
  }
  if (!std::isfinite(value)) return std::nullopt;
  return literal->negative ? -value : value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> parse_whole(std::string_view digits, int base) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

std::string format_number(double value, int exponent_shift) {
  std::string text;
  append_number(text, value, exponent_shift);
  return text;
}

void append_number(std::string& text, double value, int exponent_shift) {
  if (value == 0.0) {
    text += '0';
    return;
  }
  if (!std::isfinite(value)) {
    text += std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
    return;
  }
  // Of the form "-d.ddde+xx".
  std::array<char, 40> buffer{};
  char* end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific).ptr;
  char* first = buffer.data();
  if (*first == '-') text += *first++;
  char* const mark = std::find(first, end, 'e');
  int exponent = 0;
  std::from_chars(mark + (mark[1] == '+' ? 2 : 1), end, exponent);
  exponent += exponent_shift;
  // The digits alone: the first one takes the place of the point.
  if (first[1] == '.') {
    first[1] = first[0];
    ++first;
  }
  const std::string_view digits(first, static_cast<std::size_t>(mark - first));
  const int count = static_cast<int>(digits.size());
  if (exponent >= 0 && exponent < 15) {
    const auto whole = static_cast<std::size_t>(exponent) + 1;
    text += digits.substr(0, whole);
    if (count <= exponent + 1) {
      text.append(whole - digits.size(), '0');
    } else {
      text += '.';
      text += digits.substr(whole);
    }
  } else if (exponent < 0 && exponent >= -5) {
    text += "0.";
    text.append(static_cast<std::size_t>(-exponent - 1), '0');
    text += digits;
  } else {
    text += digits[0];
    if (count > 1) {
      text += '.';
      text += digits.substr(1);
    }
    fmt::format_to(std::back_inserter(text), "E{:+03d}", exponent);
  }
}

std::string with_prefix(double value, std::string_view unit, int digits) {
  static constexpr std::array<std::pair<double, const char*>, 9> prefixes{{{1e12, "T"},
                                                                           {1e9, "G"},
                                                                           {1e6, "M"},
                                                                           {1e3, "k"},
                                                                           {1.0, ""},
                                                                           {1e-3, "m"},
                                                                           {1e-6, "u"},
                                                                           {1e-9, "n"},
                                                                           {1e-12, "p"}}};
  const double magnitude = std::abs(value);
  if (magnitude == 0.0 || !std::isfinite(value)) return fmt::format("{:g} {}", value, unit);
  for (const auto& [scale, prefix] : prefixes)
    if (magnitude >= scale * 0.9999999) return fmt::format("{:.{}g} {}{}", value / scale, digits, prefix, unit);
  return fmt::format("{:.{}g} {}", value, digits, unit);
}

std::string bytes_text(double bytes) {
  if (bytes < 1000.0) return fmt::format("{:.0f} bytes", bytes);
  static constexpr std::array<const char*, 6> units{"kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  bytes /= 1000.0;
  while (bytes >= 999.5 && unit + 1 < units.size()) bytes /= 1000.0, ++unit;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

std::string with_minus_sign(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "−");
  return number;
}

std::string duration_text(double seconds) {
  if (seconds < 0.001) return "below 1 ms";
  if (seconds < 60.0) return fmt::format("{:.2g} s", seconds);
  const double minutes = std::floor(seconds / 60.0);
  if (minutes < 60.0) return fmt::format("{:.0f} min {:02.0f} s", minutes, std::floor(seconds - 60.0 * minutes));
  const double hours = std::floor(minutes / 60.0);
  if (hours < 48.0) return fmt::format("{:.0f} h {:02.0f} min", hours, minutes - 60.0 * hours);
  return fmt::format("{:.1f} days", hours / 24.0);
}

std::string about_duration_text(double seconds) {
  std::string text = duration_text(seconds);
  return text.starts_with("below") ? text : "about " + text;
}

bool equal_ignoring_case(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replace = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replace, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace sarsim::core

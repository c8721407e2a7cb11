#include "scene/schema/value_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/maths/rounding.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::scene {

namespace {

// A step counts as reaching the end of its range where it misses it by less than this part of itself.
constexpr double rounding = 1e-9;

ValueList no_values(std::string failure) { return {{}, std::move(failure)}; }

// A number and the text behind it.
struct Term {
  std::string number;
  std::string unit;

  [[nodiscard]] std::string text() const { return number + unit; }
};

Term term_of(std::string_view text, const std::string& unit) {
  text = core::trimmed(text);
  const std::size_t length = number_length(text);
  Term term{std::string(text.substr(0, length)), std::string(core::trimmed(text.substr(length)))};
  if (length > 0 && term.unit.empty()) term.unit = unit;
  return term;
}

// The values between commas; nothing where a quotation mark is missing.
std::optional<std::vector<std::string>> split(std::string_view text) {
  std::vector<std::string> items(1);
  bool quoted = false;
  for (const char c : text) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      items.emplace_back();
    else
      items.back() += c;
  }
  if (quoted) return std::nullopt;
  for (std::string& item : items) item = core::trimmed(item);
  return items;
}

// 15 digits are what a double surely holds: sums of decimal fractions come out as people write them.
std::string decimal(double value) {
  constexpr int digits = 15;
  return core::format_number(core::tidy(value, digits));
}

// Reads the values of one field.
class Reader {
 public:
  Reader(const Field& field, std::size_t most) : field_(field), max_(most) {}

  ValueList read(std::string_view text) {
    const auto items = split(text);
    if (!items) return no_values(fmt::format("'{}' has a quotation mark without its partner", core::clipped(text)));
    if (items->size() == 1 && items->front().empty()) return no_values("no value follows the '='");
    const bool numbers = field_.kind == FieldKind::quantity;
    if (numbers) unit_ = list_unit(items->back());
    for (const std::string& item : *items) {
      std::string failure;
      if (item.empty())
        failure = fmt::format("'{}' has nothing between two commas", core::clipped(text));
      else if (!numbers)
        failure = add(item);
      else
        failure = add_numbers(item);
      if (!failure.empty()) return no_values(std::move(failure));
    }
    return {std::move(texts_), {}};
  }

 private:
  // What stands behind the last number of a list.
  static std::string list_unit(std::string_view item) {
    if (const std::size_t points = item.find(".."); points != std::string_view::npos) item.remove_prefix(points + 2);
    if (const std::size_t colon = item.rfind(':'); colon != std::string_view::npos) item.remove_prefix(colon + 1);
    return term_of(item, "").number.empty() ? std::string() : term_of(item, "").unit;
  }

  std::string too_many(std::string_view item) const {
    return fmt::format("'{}' would be more than {} values", core::clipped(item), max_);
  }

  std::string add(std::string text) {
    if (texts_.size() >= max_) return too_many(text);
    texts_.push_back(std::move(text));
    return {};
  }

  std::string add_numbers(const std::string& item) {
    if (item.find("..") != std::string::npos) return add_whole_range(item);
    if (item.find(':') != std::string::npos) return add_range(item);
    if (const std::size_t dash = item.find('-', 1); dash < item.size())  // "1-5", not "1e-5"
      if (core::parse_integer(item.substr(0, dash)) && core::parse_integer(item.substr(dash + 1)))
        return fmt::format("'{}' is not a valid range; write {}..{}", core::clipped(item), item.substr(0, dash),
                           item.substr(dash + 1));
    const Term term = term_of(item, unit_);
    const std::string text = term.number.empty() ? item : term.text();
    // Seeds hold more digits than a number; whoever sets them reads them.
    std::string failure = field_.id == "seed" ? std::string() : read_quantity(text, field_.quantity).failure;
    return failure.empty() ? add(text) : failure;
  }

  // "1..1000", "1..10km"
  std::string add_whole_range(const std::string& item) {
    const std::size_t points = item.find("..");
    const Term last = term_of(std::string_view(item).substr(points + 2), unit_);
    const Term first = term_of(std::string_view(item).substr(0, points), last.unit);
    const auto from = core::parse_integer(first.number);
    const auto to = core::parse_integer(last.number);
    if (!from || !to)
      return fmt::format("'{}' is not a valid range of whole numbers; it is written first..last, others start:step:end",
                         core::clipped(item));
    if (first.unit != last.unit)
      return fmt::format("'{}' begins and ends in different units; write both in {}", core::clipped(item),
                         last.unit.empty() ? "the same" : last.unit);
    if (*to < *from)
      return fmt::format("'{}' goes down; write {}..{}{}, or {}:-1:{}{}", core::clipped(item), *to, *from, last.unit,
                         *from, *to, last.unit);
    if (const std::string text = std::to_string(*from) + last.unit; field_.id != "seed")
      if (std::string failure = read_quantity(text, field_.quantity).failure; !failure.empty()) return failure;
    const std::uint64_t steps = static_cast<std::uint64_t>(*to) - static_cast<std::uint64_t>(*from);
    if (steps >= max_ - texts_.size()) return too_many(item);
    for (std::uint64_t i = 0; i <= steps; ++i)
      texts_.push_back(std::to_string(static_cast<std::int64_t>(static_cast<std::uint64_t>(*from) + i)) + last.unit);
    return {};
  }

  // "10MHz:10MHz:100MHz"
  std::string add_range(const std::string& item) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0, colon = 0; colon != std::string::npos; begin = colon + 1) {
      colon = item.find(':', begin);
      parts.push_back(std::string_view(item).substr(begin, colon - begin));
    }
    if (parts.size() != 3 || std::ranges::any_of(parts, [](auto part) { return core::trimmed(part).empty(); }))
      return fmt::format("'{}' is not a valid range; it is written start:step:end", core::clipped(item));
    const Term end = term_of(parts[2], unit_);
    const std::array<Term, 3> terms{term_of(parts[0], end.unit), term_of(parts[1], end.unit), end};
    for (const Term& term : terms) {
      const std::string text = term.number.empty() ? std::string(term.unit) : term.text();
      if (std::string failure = range_number_failure(text); !failure.empty()) return failure;
    }
    const bool one_unit = terms[0].unit == terms[1].unit && terms[1].unit == terms[2].unit;
    return one_unit ? add_in_unit(item, terms) : add_in_base_unit(item, terms);
  }

  // A step of a whole number may be a fraction as far as this is concerned; what it leads to is read later.
  [[nodiscard]] std::string range_number_failure(std::string_view text) const {
    const Quantity quantity = field_.quantity == Quantity::count ? Quantity::number : field_.quantity;
    return read_quantity(text, quantity).failure;
  }

  std::string add_in_unit(const std::string& item, const std::array<Term, 3>& terms) {
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) numbers[i] = core::parse_number(terms[i].number).value_or(NAN);
    const auto text_of = [&](double value) { return decimal(value) + terms[2].unit; };
    return add_steps(item, numbers, {terms[0].text(), terms[2].text()}, text_of);
  }

  std::string add_in_base_unit(const std::string& item, const std::array<Term, 3>& terms) {
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (terms[i].unit.starts_with("dB"))
        return fmt::format("'{}' mixes decibels with another unit; write all three in one unit", core::clipped(item));
      numbers[i] = read_quantity(terms[i].text(), field_.quantity).value.value_or(NAN);
    }
    const auto text_of = [&](double value) {
      std::string text = quantity_text(*core::parse_number(decimal(value)), field_.quantity);
      std::erase(text, ' ');
      return text;
    };
    return add_steps(item, numbers, {terms[0].text(), terms[2].text()}, text_of);
  }

  template <class TextOf>
  std::string add_steps(const std::string& item, const std::array<double, 3>& range,
                        const std::array<std::string, 2>& ends, const TextOf& text_of) {
    const auto [start, step, end] = range;
    if (!std::isfinite(start + step + end))
      return fmt::format("'{}' holds a number that is too large", core::clipped(item));
    if (step == 0.0) return fmt::format("'{}' has a step of zero", core::clipped(item));
    const double steps = std::floor((end - start) / step + rounding);
    if (steps < 0.0) return fmt::format("'{}' never reaches its end: the step leads away from it", core::clipped(item));
    if (!(steps < static_cast<double>(max_ - std::min(max_, texts_.size())))) return too_many(item);
    const auto last = static_cast<std::size_t>(steps);
    for (std::size_t i = 0; i <= last; ++i) {
      const double value = start + static_cast<double>(i) * step;
      const bool at_end = std::abs(value - end) <= rounding * std::abs(step);
      texts_.push_back(i == 0 ? ends[0] : at_end ? ends[1] : text_of(value));
    }
    return {};
  }

  const Field& field_;
  std::size_t max_;
  std::string unit_;
  std::vector<std::string> texts_;
};

}  // namespace

ValueList read_value_list(std::string_view text, const Field& field, std::size_t most) {
  return Reader(field, most).read(text);
}

}  // namespace sarsim::scene

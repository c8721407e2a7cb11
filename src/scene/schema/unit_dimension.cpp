#include "scene/schema/unit_dimension.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "scene/schema/unit_table.hpp"

namespace sarsim::scene {

namespace {

constexpr int highest_power = 99;

std::string units_text(const Dimension& dimension) {
  static constexpr std::array<std::string_view, 7> symbols{"m", "s", "deg", "K", "W", "V", "dB"};
  std::string above, below;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const int power = dimension.powers[i];
    if (power == 0) continue;
    std::string& side = power > 0 ? above : below;
    if (power < 0 || !side.empty()) side += power < 0 ? '/' : '*';
    side += std::abs(power) == 1 ? std::string(symbols[i]) : fmt::format("{}^{}", symbols[i], std::abs(power));
  }
  return (above.empty() ? "1" : above) + below;
}

}  // namespace

Dimension dimension_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::number:
    case Quantity::count: return {};
    case Quantity::length: return {{1}};
    case Quantity::time: return {{0, 1}};
    case Quantity::frequency: return {{0, -1}};
    case Quantity::angle: return {{0, 0, 1}};
    case Quantity::angle_rate: return {{0, -1, 1}};
    case Quantity::area: return {{2}};
    case Quantity::power: return {{0, 0, 0, 0, 1}};
    case Quantity::ratio_db: return {{0, 0, 0, 0, 0, 0, 1}};
    case Quantity::temperature: return {{0, 0, 0, 1}};
    case Quantity::voltage: return {{0, 0, 0, 0, 0, 1}};
    case Quantity::speed: return {{1, -1}};
    case Quantity::acceleration: return {{1, -2}};
  }
  return {};
}

std::optional<Dimension> product(const Dimension& a, const Dimension& b, int power) {
  Dimension result;
  for (std::size_t i = 0; i < result.powers.size(); ++i) {
    result.powers[i] = a.powers[i] + power * b.powers[i];
    if (std::abs(result.powers[i]) > highest_power) return std::nullopt;
  }
  const int decibels = result.powers[Dimension::decibel];
  if (decibels != 0 && decibels != 1) return std::nullopt;
  return result;
}

std::optional<Dimension> raised(const Dimension& a, double power) {
  if (a.pure()) return a;
  if (power == 0.5) {
    Dimension half = a;
    for (int& p : half.powers) {
      if (p % 2 != 0) return std::nullopt;
      p /= 2;
    }
    return half;
  }
  if (power != std::floor(power) || std::abs(power) > highest_power) return std::nullopt;
  return product({}, a, static_cast<int>(power));
}

std::string dimension_text(const Dimension& dimension) {
  if (dimension.pure()) return "a pure number";
  for (const Quantity quantity : every_quantity)
    if (dimension_of(quantity) == dimension) return with_article(noun_of(quantity));
  return "a quantity in " + units_text(dimension);
}

}  // namespace sarsim::scene

#include "picture/figure/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace sarsim::picture {

namespace {

constexpr int most_ticks = 1000;

// Units that carry no prefix: "kdB" and "mdeg" help nobody.
bool takes_prefix(std::string_view unit) {
  constexpr std::array<std::string_view, 6> bare{"", "deg", "°", "%", "m2", "K"};
  return !unit.starts_with("dB") && std::ranges::find(bare, unit) == bare.end();
}

struct Prefix {
  double scale;
  const char* text;
};

Prefix prefix_of(double magnitude) {
  constexpr std::array<Prefix, 8> prefixes{
      {{1e12, "T"}, {1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}}};
  for (const Prefix& prefix : prefixes)
    if (magnitude >= prefix.scale * (1.0 - 1e-9)) return prefix;
  return magnitude > 0.0 ? Prefix{1e-12, "p"} : Prefix{1.0, ""};
}

// The smallest of 1, 2, 5, 10, ... that is at least `value`, as digit and exponent, so that labels know their decimals.
struct Step {
  double value;
  int exponent;
};

Step step_above(double value) {
  const int exponent = static_cast<int>(std::floor(std::log10(value)));
  const double power = std::pow(10.0, exponent);
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= value * (1.0 - 1e-12)) return {digit * power, exponent};
  return {10.0 * power, exponent + 1};
}

std::string label_of(double shown, int decimals) {
  if (decimals > 15) return fmt::format("{:g}", shown);
  std::string label = fmt::format("{:.{}f}", shown, std::max(0, decimals));
  const bool zero = label.find_first_not_of("-0.") == std::string::npos;
  return zero ? "0" : label;
}

}  // namespace

Ticks axis_ticks(double first, double last, double length_px, double spacing_px, const std::string& unit) {
  Ticks ticks;
  ticks.unit = unit;
  if (!std::isfinite(first) || !std::isfinite(last)) return ticks;
  const double largest = std::max(std::abs(first), std::abs(last));
  if (takes_prefix(unit)) {
    const Prefix prefix = prefix_of(largest);
    ticks.scale = prefix.scale;
    ticks.unit = prefix.text + unit;
  }
  const double span = std::abs(last - first);
  const double room = std::clamp(length_px / std::max(spacing_px, 1.0), 1.0, static_cast<double>(most_ticks));
  // Nearer together than numbers can be told apart there is no axis.
  if (!(span > 1e-13 * largest) || !std::isfinite(span) || !(length_px > 0.0)) return ticks;
  const Step step = step_above(span / room / ticks.scale);
  const double low = std::min(first, last) / ticks.scale;
  const double high = std::max(first, last) / ticks.scale;
  const double start = std::ceil(low / step.value - 1e-9);
  const double count = std::floor(high / step.value + 1e-9) - start;
  for (int i = 0; i <= count && i <= most_ticks; ++i) {
    const double shown = (start + i) * step.value;
    ticks.ticks.push_back({shown * ticks.scale + 0.0, label_of(shown, -step.exponent)});
  }
  if (first > last) std::ranges::reverse(ticks.ticks);
  return ticks;
}

double round_below(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 0.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {10.0, 5.0, 2.0, 1.0})
    if (digit * power <= value * (1.0 + 1e-12)) return digit * power;
  return 0.5 * power;
}

}  // namespace sarsim::picture

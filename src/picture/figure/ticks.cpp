#include "picture/figure/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace sarsim::picture {

namespace {

constexpr int max_ticks = 1000;

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
      {{1e12, "T"}, {1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}}};
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
  const std::string label =
      decimals > 15 ? fmt::format("{:g}", shown) : fmt::format("{:.{}f}", shown, std::max(0, decimals));
  const bool zero = label.find_first_not_of("-0.") == std::string::npos;
  if (zero) return "0";
  return label.front() == '-' ? "−" + label.substr(1) : label;
}

// Marks at so many of the unit, from the lowest to the highest.
std::vector<Tick> ticks_at(const Step& step, double low, double high, double scale) {
  std::vector<Tick> ticks;
  const double start = std::ceil(low / step.value - 1e-9);
  const double count = std::floor(high / step.value + 1e-9) - start;
  for (int i = 0; i <= count && i <= max_ticks; ++i) {
    const double shown = (start + i) * step.value;
    ticks.push_back({shown * scale + 0.0, label_of(shown, -step.exponent)});
  }
  return ticks;
}

// Where one mark alone would say nothing of a scale, short labels may stand nearer together.
struct Narrower {
  double share;  // of the spacing
  std::size_t max_letters;
};
constexpr std::array<Narrower, 3> spacings{{{1.0, 1000}, {0.6, 6}, {0.4, 4}}};

std::size_t longest_label(const std::vector<Tick>& ticks) {
  std::size_t longest = 0;
  for (const Tick& tick : ticks) {
    const auto letters = std::ranges::count_if(tick.label, [](char c) { return (c & 0xC0) != 0x80; });
    longest = std::max(longest, static_cast<std::size_t>(letters));
  }
  return longest;
}

}  // namespace

Ticks axis_ticks(double first, double last, double length_px, double spacing_px, const std::string& unit) {
  Ticks ticks;
  ticks.unit = unit == "m2" ? "m²" : unit;
  if (!std::isfinite(first) || !std::isfinite(last)) return ticks;
  const double largest = std::max(std::abs(first), std::abs(last));
  if (takes_prefix(unit)) {
    const Prefix prefix = prefix_of(largest);
    ticks.scale = prefix.scale;
    ticks.unit = prefix.text + unit;
  }
  const double span = std::abs(last - first);
  // Nearer together than numbers can be told apart there is no axis.
  if (!(span > 1e-13 * largest) || !std::isfinite(span) || !(length_px > 0.0)) return ticks;
  const double low = std::min(first, last) / ticks.scale;
  const double high = std::max(first, last) / ticks.scale;
  for (const Narrower& one : spacings) {
    const double room =
        std::clamp(length_px / std::max(one.share * spacing_px, 1.0), 1.0, static_cast<double>(max_ticks));
    std::vector<Tick> marks = ticks_at(step_above(span / room / ticks.scale), low, high, ticks.scale);
    if (one.share == 1.0 || longest_label(marks) <= one.max_letters) ticks.ticks = std::move(marks);
    if (ticks.ticks.size() > 1) break;
  }
  if (first > last) std::ranges::reverse(ticks.ticks);
  return ticks;
}

namespace {

// Steps that divide minutes, hours and days.
double clock_step_s(double min_s) {
  for (const double step_s : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0, 7200.0,
                              10800.0, 21600.0, 43200.0, 86400.0})
    if (step_s >= min_s) return step_s;
  return 86400.0 * std::ceil(min_s / 86400.0);
}

// @param decimals  of the seconds
std::string clock_label(double time_s, int decimals) {
  constexpr double day_s = 86400.0;
  const double unit = std::pow(10.0, decimals);
  // Whole numbers of the last decimal, so that 59.9999 is no 60.
  const double parts = std::round((time_s - day_s * std::floor(time_s / day_s)) * unit);
  const double of_day = parts >= day_s * unit ? 0.0 : parts;
  const auto minutes = static_cast<int>(of_day / (60.0 * unit));
  const double seconds = (of_day - 60.0 * unit * minutes) / unit;
  return fmt::format("{:02}:{:02}:{:0{}.{}f}", minutes / 60, minutes % 60, seconds, decimals > 0 ? decimals + 3 : 2,
                     decimals);
}

}  // namespace

Ticks clock_ticks(double first, double last, double length_px, double spacing_px, double clock_s) {
  Ticks ticks;
  const double span_s = std::abs(last - first);
  if (!(span_s > 1e-9) || !std::isfinite(span_s) || !std::isfinite(clock_s) || !(length_px > 0.0)) return ticks;
  const double room = std::clamp(length_px / std::max(spacing_px, 1.0), 1.0, static_cast<double>(max_ticks));
  const double min_s = span_s / room;
  const Step fine = step_above(min_s);
  const double step_s = min_s > 0.5 ? clock_step_s(min_s) : fine.value;
  const int decimals = step_s < 1.0 ? -fine.exponent : 0;
  const double start = std::ceil((std::min(first, last) + clock_s) / step_s - 1e-6);  // a double of a day keeps 1e-11 s
  const double end = std::floor((std::max(first, last) + clock_s) / step_s + 1e-6);
  for (int i = 0; start + i <= end && i <= max_ticks; ++i)
    ticks.ticks.push_back({(start + i) * step_s - clock_s, clock_label((start + i) * step_s, decimals)});
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

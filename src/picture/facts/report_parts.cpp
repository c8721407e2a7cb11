#include "picture/facts/report_parts.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::picture::report {

void Facts::word(std::string name, std::string value, std::string unit) {
  table_.rows.push_back({std::move(name), std::move(value), std::move(unit)});
}

void Facts::count(std::string name, std::size_t value, std::string unit) {
  word(std::move(name), fmt::format("{}", value), std::move(unit));
}

void Facts::number(std::string name, double value, std::string_view unit) {
  if (!std::isfinite(value)) return;
  const std::string text = core::with_prefix(value == 0.0 ? 0.0 : value, unit);
  const std::size_t gap = text.find(' ');
  word(std::move(name), text.substr(0, gap), text.substr(gap + 1));
}

void Facts::plain(std::string name, double value, std::string_view unit) {
  if (std::isfinite(value)) word(std::move(name), six_digits(value), std::string(unit));
}

void Facts::axis(const std::string& name, const signal::ImageAxis& axis) {
  number(name + " from", axis.first_m, "m");
  number(name + " to", axis.at(static_cast<double>(axis.count) - 1.0), "m");
  number(name + " spacing", axis.step_m, "m");
}

void Facts::time(double seconds) { word("Time taken", core::duration_text(seconds)); }

ReportTable Facts::take() { return std::move(table_); }

std::string fixed(double value, int digits) {
  if (!std::isfinite(value)) return {};
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.starts_with('-') && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string six_digits(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value == 0.0 ? 0.0 : value) : std::string();
}

}  // namespace sarsim::picture::report

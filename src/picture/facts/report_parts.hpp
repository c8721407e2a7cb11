#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "picture/facts/report_pages.hpp"
#include "signal/sar/sar_image.hpp"

/// Parts of the pages of reports. Internal to report_*.cpp.
namespace sarsim::picture::report {

/// Rows of name, value and unit.
class Facts {
 public:
  /// A word, or a number without a unit.
  void word(std::string name, std::string value, std::string unit = {});
  /// A count of things.
  void count(std::string name, std::size_t value, std::string unit = {});
  /// A number with an SI unit, six digits with the prefix that suits it; left out where it is not finite.
  void number(std::string name, double value, std::string_view unit);
  /// The same with a unit that takes no prefix: dB, degrees.
  void plain(std::string name, double value, std::string_view unit);
  /// First and last coordinate of an axis and its spacing, m.
  void axis(const std::string& name, const signal::ImageAxis& axis);
  /// How long the work took.
  void time(double seconds);

  /// The table "Result".
  [[nodiscard]] ReportTable take();

 private:
  ReportTable table_{"Result", {"Name", "Value", "Unit"}, {}, true};
};

/// So many decimals; no sign where they are all 0, nothing where the value is not finite.
[[nodiscard]] std::string fixed(double value, int digits);

/// Six digits, nothing where the value is not finite.
[[nodiscard]] std::string six_digits(double value);

/// A cell of something that was not found.
inline constexpr const char* no_peak = "no peak";

}  // namespace sarsim::picture::report

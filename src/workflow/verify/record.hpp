#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/task/stop.hpp"

/// The simulator compared with the expected results, on the machine on which it runs.
namespace sarsim::workflow::verify {

/// How a measured value is judged.
enum class Bound {
  near,      ///< |measured - expected| <= tolerance.
  at_most,   ///< measured <= expected.
  at_least,  ///< measured >= expected.
};

/// One statement about the simulator, with what was measured.
struct Finding {
  std::string group;   ///< "Closed forms".
  std::string name;    ///< "Two-way phase of a target at 1 km".
  std::string unit;    ///< Empty for a pure number.
  std::string source;  ///< Where what is expected comes from.
  Bound bound = Bound::near;
  double expected = 0.0;
  double measured = 0.0;
  double tolerance = 0.0;  ///< Bound::near.
  bool holds = false;
  std::string failure;  ///< Why nothing could be measured.
};

/// A line of a chart; x and y of one length.
struct Curve {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
  bool dots = false;  ///< Points instead of a line.
};

/// What belongs to a group besides its findings.
struct Chart {
  std::string group;
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;
  bool log_x = false;
  bool log_y = false;
};

/// How much is measured, and with what.
struct Rules {
  bool quick = false;  ///< Fewer samples, with the wider tolerances that go with them; no measurement of speed.
  const core::StopFlag* stop = nullptr;
};

/// Gathers findings and charts of one group after the other.
class Record {
 public:
  explicit Record(Rules rules) : rules_(rules) {}

  [[nodiscard]] const Rules& rules() const { return rules_; }
  [[nodiscard]] bool quick() const { return rules_.quick; }

  /// Runs the measurements of a group; what they throw becomes a finding that does not hold. A requested stop throws
  /// Interrupted.
  void group(const std::string& name, const std::function<void(Record&)>& measure);

  /// Holds where the measured value lies within `tolerance` of the expected one.
  /// @param source  where the expectation comes from
  void near(const std::string& name, const std::string& unit, double expected, double measured, double tolerance,
            const std::string& source);
  /// Holds where the measured value is no larger.
  void at_most(const std::string& name, const std::string& unit, double most, double measured,
               const std::string& source);
  /// Holds where the measured value is no smaller.
  void at_least(const std::string& name, const std::string& unit, double least, double measured,
                const std::string& source);
  /// Adds a chart to the present group.
  void chart(Chart chart);

  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  [[nodiscard]] const std::vector<Chart>& charts() const { return charts_; }

 private:
  void add(Finding finding);

  Rules rules_;
  std::string group_;
  std::vector<Finding> findings_;
  std::vector<Chart> charts_;
};

}  // namespace sarsim::workflow::verify

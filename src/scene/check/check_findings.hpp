#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/maths/sampled_function.hpp"
#include "core/report/problem.hpp"

namespace sarsim::scene {

/// What ignoring a warning leads to, worst first; the order in which `check` lists warnings.
enum class Consequence {
  false_signal,  ///< The samples show something that is not there.
  lost_signal,   ///< Something that should be in the samples is not, or not as meant.
  other_object,  ///< Another object than the one meant may be used.
  surprise,      ///< The result is right but perhaps not the one expected.
};

/// What is wrong, and what would be right: rule and texts of a Problem.
struct Finding {
  core::RuleId id;
  std::string message;
  std::string found = {};
  std::string expected = {};
  std::string hint = {};
};

/// Collects what `check` finds about one object after the other.
class Findings {
 public:
  /// Everything reported from here on is about this object.
  void about(std::string_view kind, std::size_t index);
  [[nodiscard]] const core::Subject& subject() const { return subject_; }

  /// Reports a mistake: nothing runs with it. `field` names the member of the object.
  void error(std::string_view field, Finding finding);
  /// Reports what is allowed but likely not meant, ranked by its consequence.
  void warning(Consequence consequence, std::string_view field, Finding finding);
  /// A note that stands for `count` occurrences.
  void note(std::string_view field, Finding finding, std::size_t count = 1);

  /// Adds what was found elsewhere, behind everything here.
  void append(Findings&& later);

  /// Errors in the order reported, warnings by consequence, notes. Of an object with an error only the errors.
  [[nodiscard]] core::Problems take() &&;

 private:
  struct Entry {
    int rank = 0;
    core::Problem problem;
  };

  void add(core::Severity severity, int rank, std::string_view field, Finding&& finding, std::size_t count = 1);

  core::Subject subject_;
  std::vector<Entry> entries_;
};

/// A value with its unit for people to read: "5.3 GHz", "-12.5 m", "nan deg".
[[nodiscard]] std::string value_text(double value, std::string_view unit);

/// A number, or one of several, that is larger than anything that can be computed with.
/// @param what  "the ..."
[[nodiscard]] Finding too_large(std::string_view what, std::string found, std::string_view unit);

/// What has to hold for a user-defined function.
struct FunctionRule {
  /// A function without points is a mistake, means 0 everywhere, or means nothing.
  enum class Empty { error, constant_zero, allowed };

  std::string_view field;
  std::string_view what;                    ///< "trajectory".
  std::span<const std::string_view> parts;  ///< "X", "Y", "Z"; one empty name for a single function.
  bool used = true;                         ///< False: some other choice is made, only the numbers must be numbers.
  bool x_matters = true;                    ///< False for lists, whose x is ignored.
  Empty empty = Empty::error;               ///< What a part without points is.
};

/// Checks the parts of a user-defined function against a rule; true where a function that is used can be evaluated.
/// Points for Interpolation::low_pass that are farther than a twentieth of their mean spacing from even places lead to
/// a warning.
bool check_function(Findings& findings, const FunctionRule& rule, std::span<const core::SampledFunction> parts);

/// Names of the parts of functions that stand alone and of those with three coordinates.
inline constexpr std::string_view single_part[] = {""};
inline constexpr std::string_view coordinate_parts[] = {"X", "Y", "Z"};

}  // namespace sarsim::scene

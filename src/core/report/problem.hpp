#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sarsim::core {

/// How much a problem matters: an error stops the work, a warning does not, a note informs.
enum class Severity { error, warning, note };

/// A place in a text file; line and column count from 1 (column in bytes), 0 where unknown.
struct Place {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;

  friend bool operator==(const Place&, const Place&) = default;
};

/// What a problem is about: an object of the scene and, where one is to blame, its field.
struct Subject {
  std::string kind;  ///< "platform", "target", "cloud", "surface", "radar", "simulation", "geometry", "options"; empty
                     ///< for none.
  std::size_t index = 0;  ///< Position in the scene's list of that kind, from 0.
  std::string field;      ///< Member name of the scene structure ("pulse_width_s"); empty for the whole object.

  friend bool operator==(const Subject&, const Subject&) = default;
};

/// The rule that a problem breaks, as "prf.below-doppler-band": what it is about, and what is wrong there. It stays
/// where words change, and no output shows it. Only literals, which outlive every problem, are names.
class RuleId {
 public:
  constexpr RuleId() = default;
  consteval RuleId(const char* name) : name_(name) {}  // NOLINT: a literal in place of a rule

  /// Empty where no rule is broken: what a reader cannot read.
  [[nodiscard]] constexpr std::string_view name() const { return name_; }

  friend bool operator==(const RuleId&, const RuleId&) = default;

 private:
  std::string_view name_;
};

/// One thing that is wrong, or worth knowing, about what a user supplied.
struct Problem {
  Severity severity = Severity::error;
  std::string message;    ///< What is wrong, in words: "pulse width is not a number".
  std::string found;      ///< The offending text or value; empty where there is none.
  std::string expected;   ///< What would have been right; may be empty.
  std::string hint;       ///< How to mend it; may be empty.
  Place place;            ///< Where it stands; filled by the script reader.
  Subject subject;        ///< Which object and field; filled by scene checks and the script reader.
  std::size_t count = 1;  ///< How often the same cause was met.
  RuleId id = {};         ///< Of checks of scenes, surveys and remarks; not of readers.
};

using Problems = std::vector<Problem>;

/// A problem that is put together part by part, as in
/// `core::warning("the PRF is low").found("90 Hz").expected("at least 200 Hz").at("radar", 0, "prf_hz")`,
/// and becomes one where one is wanted. What is not said stays empty.
class ProblemBuilder {
 public:
  /// @param message  what is wrong, a sentence without its end
  ProblemBuilder(Severity severity, std::string message) : ProblemBuilder(severity, {}, std::move(message)) {}
  /// The same by a rule.
  ProblemBuilder(Severity severity, RuleId id, std::string message);

  /// What was found.
  ProblemBuilder&& found(std::string text) &&;
  /// What was expected instead.
  ProblemBuilder&& expected(std::string text) &&;
  /// How to fix it.
  ProblemBuilder&& hint(std::string text) &&;
  /// Which object and field it concerns.
  ProblemBuilder&& at(std::string kind, std::size_t index, std::string field) &&;
  ProblemBuilder&& at(Subject subject) &&;
  /// Where it stands.
  ProblemBuilder&& in(std::string file, std::size_t line = 0, std::size_t column = 0) &&;
  ProblemBuilder&& in(Place place) &&;
  /// How often the same cause was met.
  ProblemBuilder&& times(std::size_t count) &&;

  /// The problem, complete.
  operator Problem() &&;  // NOLINT: a builder is a problem in the making

 private:
  Problem problem_;
};

/// Begins a problem of this severity.
[[nodiscard]] ProblemBuilder error(std::string message);
/// See `error`.
[[nodiscard]] ProblemBuilder warning(std::string message);
/// See `error`.
[[nodiscard]] ProblemBuilder note(std::string message);
/// Begins a problem that a rule finds.
[[nodiscard]] ProblemBuilder error(RuleId id, std::string message);
/// See `error`.
[[nodiscard]] ProblemBuilder warning(RuleId id, std::string message);
/// See `error`.
[[nodiscard]] ProblemBuilder note(RuleId id, std::string message);

/// Adds what was found elsewhere, behind everything in a list.
void append(Problems& problems, Problems more);

/// True where at least one problem is an error.
[[nodiscard]] bool has_errors(const Problems& problems);

/// A text with its control characters, which could control a terminal or reverse the reading direction, escaped as
/// "\x1b" or "\u009b"; line feeds and tabs stay. Bytes that are not UTF-8 stay, except for those that are such
/// characters.
[[nodiscard]] std::string printable(std::string_view text);

/// One printable paragraph: "file:line:column: error: message; found 'x', expected y" and a second,
/// indented line with the hint where there is one. No trailing newline.
[[nodiscard]] std::string to_string(const Problem& problem);

/// Sorts errors before warnings before notes, keeping the order within each, and merges repetitions
/// of one cause (same severity, message, field and kind) into the first of them with a count,
/// except errors with a place, each of which stands for itself as long as there are no more than 100 of them.
/// Takes time n log n.
[[nodiscard]] Problems ranked(Problems problems);

}  // namespace sarsim::core

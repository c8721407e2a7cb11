#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/report/problem.hpp"
#include "scene/schema/grammar.hpp"
#include "scene/script/tokens.hpp"

namespace sarsim::scene::script {

/// The problems of one reading, in the order of the text; keeps a limited number of errors and of warnings, so that a
/// huge file of nonsense costs no more than a small one.
class ProblemLog {
 public:
  explicit ProblemLog(std::size_t limit) : limit_(limit) {}

  /// Keeps a problem, unless there are enough of its kind; those are counted.
  void add(core::Problem problem);

  /// Whether as many errors as anyone will read have been found; reading should end.
  [[nodiscard]] bool full() const { return errors_ >= limit_; }
  /// Whether it would be full with the problems of another log added.
  [[nodiscard]] bool full_with(const ProblemLog& later) const { return errors_ + later.errors_ >= limit_; }

  /// Adds what was found behind everything here by a log of the same limit. Not where that would make this one full:
  /// then reading should have ended somewhere within.
  /// @param objects_before  (kind) -> number of objects of that kind that come before the first of `later`
  template <class ObjectsBefore>
  void append(ProblemLog&& later, const ObjectsBefore& objects_before) {
    const std::size_t unsaid = later.warnings_ - std::min(later.warnings_, limit_);
    for (core::Problem& problem : later.problems_) {
      problem.subject.index += objects_before(problem.subject.kind);
      add(std::move(problem));
    }
    warnings_ += unsaid;
  }

  /// The problems, closed by a note of what was left out.
  [[nodiscard]] core::Problems take();

 private:
  std::size_t limit_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  core::Problems problems_;
};

/// Words of a problem that a token gives rise to.
struct Complaint {
  std::string message;
  std::string found = {};
  std::string expected = {};
  std::string hint = {};
};

/// `Subject` without its field, for readers, which make one for each of millions of objects.
struct ObjectId {
  std::string_view kind;
  std::size_t index = 0;
};

/// Reports what is wrong with the tokens of one object of a file.
class Reporter {
 public:
  /// Keeps references to log and file name; both must outlive it.
  Reporter(ProblemLog& log, std::string_view file, ObjectId object) : log_(log), file_(file), object_(object) {}

  void error(const Token& token, std::string_view member, Complaint complaint) {
    add(core::Severity::error, token, member, std::move(complaint));
  }
  void warning(const Token& token, std::string_view member, Complaint complaint) {
    add(core::Severity::warning, token, member, std::move(complaint));
  }

  /// Warns of a comment that touches the token and reports a quote that is not closed.
  void check_spelling(const Token& token, std::string_view member);

  [[nodiscard]] bool full() const { return log_.full(); }

 private:
  void add(core::Severity severity, const Token& token, std::string_view member, Complaint complaint);

  ProblemLog& log_;
  std::string_view file_;
  ObjectId object_;
};

/// Reads a number about which nothing at all is to be said into `value`; fast, for the many that are so. False, and
/// `value` as it was, for all others.
[[nodiscard]] bool plain_number(const Token& token, int shift, const Range& range, double& value);

/// Reads a token as the number that `field` describes. On failure reports why and gives nothing; a number outside the
/// field's range is reported and given all the same.
[[nodiscard]] bool read_number(const Token& token, const Field& field, Reporter& reporter, double& value);

/// The same for a whole number, which may also be written as 8.0 or 1E3.
[[nodiscard]] bool read_integer(const Token& token, const Field& field, Reporter& reporter, std::int64_t& value);

/// At most this many characters of a token are shown in a problem.
inline constexpr std::size_t longest_shown = 60;
/// A text as problems show it: cut off there, and "..." behind it.
[[nodiscard]] std::string shown(std::string_view text);

}  // namespace sarsim::scene::script

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/problem.hpp"
#include "script/grammar.hpp"
#include "script/tokens.hpp"

namespace sarsim::script {

/// The problems of one reading, in the order of the text; keeps a limited number of errors and of warnings, so that a
/// huge file of nonsense costs no more than a small one.
class ProblemLog {
 public:
  explicit ProblemLog(std::size_t limit) : limit_(limit) {}

  void add(Problem problem);

  /// Whether as many errors as anyone will read have been found; reading should end.
  [[nodiscard]] bool full() const { return errors_ >= limit_; }

  /// The problems, closed by a note of what was left out.
  [[nodiscard]] Problems take();

 private:
  std::size_t limit_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  Problems problems_;
};

/// Words of a problem that a token gives rise to.
struct Complaint {
  std::string message;
  std::string found = {};
  std::string expected = {};
  std::string hint = {};
};

/// Reports what is wrong with the tokens of one object of a file.
class Reporter {
 public:
  Reporter(ProblemLog& log, std::string file, Subject object)
      : log_(log), file_(std::move(file)), object_(std::move(object)) {}

  void error(const Token& token, std::string_view member, Complaint complaint) {
    add(Severity::error, token, member, std::move(complaint));
  }
  void warning(const Token& token, std::string_view member, Complaint complaint) {
    add(Severity::warning, token, member, std::move(complaint));
  }

  /// Warns of a comment that touches the token and reports a quote that is not closed.
  void check_spelling(const Token& token, std::string_view member);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const Subject& object() const { return object_; }
  [[nodiscard]] bool full() const { return log_.full(); }

 private:
  void add(Severity severity, const Token& token, std::string_view member, Complaint complaint);

  ProblemLog& log_;
  std::string file_;
  Subject object_;
};

/// The number of a token about which nothing at all is to be said; fast, for the many that are so.
[[nodiscard]] std::optional<double> plain_number(const Token& token, int shift);

/// Reads a token as the number that `field` describes. On failure reports why and gives nothing; a number outside the
/// field's range is reported and given all the same.
[[nodiscard]] bool read_number(const Token& token, const Field& field, Reporter& reporter, double& value);

/// The same for a whole number, which may also be written as 8.0 or 1E3.
[[nodiscard]] bool read_integer(const Token& token, const Field& field, Reporter& reporter, std::int64_t& value);

/// At most this many characters of a token are shown in a problem.
inline constexpr std::size_t longest_shown = 60;
[[nodiscard]] std::string shown(std::string_view text);

}  // namespace sarsim::script

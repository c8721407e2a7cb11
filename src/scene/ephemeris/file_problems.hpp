#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/report/problem.hpp"

namespace sarsim::scene::ephemeris {

/// Words of a problem.
struct ProblemWords {
  std::string message;
  std::string found = {};
  std::string expected = {};
  std::string hint = {};
};

/// The problems of the text of one file, in the order of their discovery. Keeps a limited number of errors and of
/// warnings, so that a huge file of nonsense costs no more than a small one.
class FileProblems {
 public:
  /// Remembers that a problem was reported; 0 for not yet.
  using Mark = std::size_t;

  /// Keeps a view of the text.
  FileProblems(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  /// Reports an error.
  /// @param at  the piece of the text that is to blame; what is no piece of the text leaves the place open
  Mark error(std::string_view at, ProblemWords words) { return add(core::Severity::error, at, std::move(words)); }
  /// Reports a warning, as above.
  Mark warning(std::string_view at, ProblemWords words) { return add(core::Severity::warning, at, std::move(words)); }

  /// True where a problem has been reported under this mark; it is then counted once more.
  bool again(Mark mark);

  /// Whether there are as many errors as anyone will read; reading should end.
  [[nodiscard]] bool full() const { return errors_ >= limit; }
  [[nodiscard]] bool has_errors() const { return errors_ > 0; }

  /// The problems, closed by a note of what was left out.
  [[nodiscard]] core::Problems take();

 private:
  static constexpr std::size_t limit = 20;

  Mark add(core::Severity severity, std::string_view at, ProblemWords words);
  [[nodiscard]] core::Place place_of(std::string_view at);

  std::string_view text_;
  std::string file_;
  core::Problems problems_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  bool quoted_ = false;  // A word of the text has been quoted; no second one is.
  // Line of an earlier place, from which later ones are counted.
  std::size_t known_offset_ = 0;
  std::size_t known_line_ = 1;
};

/// Reads a whole cell as a finite number times 10^exponent_shift; reports what is none and leaves `value` alone.
/// @param words  what it is: "position x"
/// @param unit   of the file, for messages; may be empty
[[nodiscard]] bool read_number(std::string_view cell, std::string_view words, std::string_view unit, int exponent_shift,
                               FileProblems& problems, double& value);

}  // namespace sarsim::scene::ephemeris

#include "scene/ephemeris/file_problems.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"

namespace sarsim::scene::ephemeris {

namespace {

constexpr FileProblems::Mark unlisted = static_cast<FileProblems::Mark>(-1);

// Of what stands in the file no more than a word is told; what was made of it ("1 of 3") is told as it is.
// @param quoted  whether a word of it was told before, which is then enough
std::string shown(std::string_view text, std::string_view at, std::string_view found, bool& quoted) {
  std::string_view quote = found;
  if (quote.ends_with("...")) quote.remove_suffix(3);
  const char* const begin = text.data();
  const bool within = !std::less<>{}(at.data(), begin) && !std::less<>{}(begin + text.size(), at.data());
  if (quote.empty() || at.data() == nullptr || !within) return core::clipped(found);
  const auto offset = static_cast<std::size_t>(at.data() - begin);
  const std::size_t line = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
  const std::size_t end = std::min(text.find('\n', offset), text.size());
  if (text.substr(line, end - line).find(quote) == std::string_view::npos) return core::clipped(found);
  return std::exchange(quoted, true) ? std::string() : core::quoted_word(found);
}

}  // namespace

FileProblems::Mark FileProblems::add(core::Severity severity, std::string_view at, ProblemWords words) {
  std::size_t& count = severity == core::Severity::error ? errors_ : warnings_;
  if (count++ >= limit) return unlisted;
  problems_.push_back(core::ProblemBuilder(severity, std::move(words.message))
                          .found(shown(text_, at, words.found, quoted_))
                          .expected(std::move(words.expected))
                          .hint(std::move(words.hint))
                          .in(place_of(at)));
  return problems_.size();
}

bool FileProblems::again(Mark mark) {
  if (mark == 0) return false;
  if (mark != unlisted) ++problems_[mark - 1].count;
  return true;
}

core::Place FileProblems::place_of(std::string_view at) {
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  if (at.data() == nullptr || std::less<>{}(at.data(), begin) || std::less<>{}(end, at.data())) return {file_, 0, 0};
  const auto offset = static_cast<std::size_t>(at.data() - begin);
  if (offset < known_offset_) {
    known_offset_ = 0;
    known_line_ = 1;
  }
  known_line_ += static_cast<std::size_t>(std::count(begin + known_offset_, begin + offset, '\n'));
  known_offset_ = offset;
  const std::size_t line_end = text_.substr(0, offset).rfind('\n');
  const std::size_t line_begin = line_end == std::string_view::npos ? 0 : line_end + 1;
  return {file_, known_line_, offset - line_begin + 1};
}

core::Problems FileProblems::take() {
  if (errors_ >= limit)
    problems_.push_back(core::error(fmt::format("reading stopped after {} errors", limit)).in(file_));
  if (warnings_ > limit)
    problems_.push_back(core::note(fmt::format("{} more warnings are not shown", warnings_ - limit)));
  return std::exchange(problems_, {});
}

bool read_number(std::string_view cell, std::string_view words, std::string_view unit, int exponent_shift,
                 FileProblems& problems, double& value) {
  const std::optional<double> number = core::parse_number(cell, exponent_shift);
  if (number) {
    value = *number;
    return true;
  }
  const bool blank = core::trimmed(cell).empty();
  const std::string expected = unit.empty() ? "a number" : fmt::format("a finite number in {}", unit);
  problems.error(cell, {fmt::format("{} is {}", words, blank ? "missing" : "not a finite number"), core::clipped(cell),
                        expected, cell.find(',') == std::string_view::npos ? "" : "write a point, not a comma"});
  return false;
}

}  // namespace sarsim::scene::ephemeris

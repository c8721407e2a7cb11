#include "scene/ephemeris/kvn_lines.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/ephemeris/known_words.hpp"

namespace sarsim::scene::ephemeris {

namespace {

bool is_comment(std::string_view line) {
  constexpr std::string_view word = "COMMENT";
  return line.starts_with(word) && (line.size() == word.size() || core::is_blank(line[word.size()]));
}

// Moves "[km]" at the end of a value into the unit.
void take_unit(KvnLine& line) {
  if (!line.value.ends_with(']')) return;
  const std::size_t begin = line.value.rfind('[');
  if (begin == std::string_view::npos) return;
  line.unit = core::trimmed(line.value.substr(begin + 1, line.value.size() - begin - 2));
  line.value = core::trimmed(line.value.substr(0, begin));
}

}  // namespace

bool KvnLines::next(KvnLine& line) {
  std::string_view text;
  while (lines_.next_filled(text)) {
    if (is_comment(text)) continue;
    line = KvnLine{text, text.substr(text.size()), {}, {}};
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) return true;
    line.key = core::trimmed(text.substr(0, sign));
    line.value = core::trimmed(text.substr(sign + 1));
    take_unit(line);
    return true;
  }
  return false;
}

void KvnBlock::begin(std::string_view at) {
  lines_.clear();
  at_ = at;
}

void KvnBlock::add(const KvnLine& line, bool strict, FileProblems& problems) {
  if (std::ranges::find(known_, line.key) == known_.end()) {
    const std::string nearest = core::nearest_word(line.key, known_);
    ProblemWords words{strict ? "the keyword is not known here" : "the keyword is not known here and is ignored",
                       core::clipped(line.key.empty() ? line.line : line.key), "",
                       nearest.empty() ? "" : fmt::format("did you mean {}?", nearest)};
    if (strict)
      problems.error(line.line, std::move(words));
    else
      problems.warning(line.line, std::move(words));
    return;
  }
  const auto same = [&](const KvnLine& other) { return other.key == line.key; };
  if (std::ranges::any_of(lines_, same))
    problems.error(line.line, {"the keyword appears twice in one block", std::string(line.key), "each keyword once",
                               "remove one of the lines"});
  else
    lines_.push_back(line);
}

std::string_view KvnBlock::value(std::string_view key) const {
  const auto found = std::ranges::find(lines_, key, &KvnLine::key);
  return found == lines_.end() ? std::string_view() : found->value;
}

std::string_view KvnBlock::required(std::string_view key, FileProblems& problems) const {
  const std::string_view read = value(key);
  if (read.empty())
    problems.error(at_, {fmt::format("{} is missing", key), "", fmt::format("a line {} = ...", key),
                         "it belongs between META_START and META_STOP"});
  return read;
}

namespace {

std::optional<radar::CivilTime> time_in(const KvnBlock& block, std::string_view key,
                                        std::optional<radar::TimeScale> scale, FileProblems& problems) {
  const std::string_view value = block.value(key);
  radar::CivilTime time;
  if (value.empty() || !read_time(value, key, scale, problems, time)) return std::nullopt;
  return time;
}

}  // namespace

TypedTimes read_typed_times(const KvnBlock& block, std::optional<radar::TimeScale> scale, FileProblems& problems) {
  return {{"START_TIME", time_in(block, "START_TIME", scale, problems), block.value("START_TIME")},
          {"STOP_TIME", time_in(block, "STOP_TIME", scale, problems), block.value("STOP_TIME")}};
}

UsableRange read_usable(const KvnBlock& block, std::optional<radar::TimeScale> scale, FileProblems& problems) {
  return {time_in(block, "USEABLE_START_TIME", scale, problems), time_in(block, "USEABLE_STOP_TIME", scale, problems)};
}

InterpolationHint read_interpolation_hint(const KvnBlock& block, std::string_view method_key, FileProblems& problems) {
  constexpr std::int64_t highest_degree = 100;
  InterpolationHint hint;
  if (const std::string_view method = block.value(method_key); !method.empty())
    hint.method = read_interpolation(method, problems);
  const std::string_view degree = block.value("INTERPOLATION_DEGREE");
  if (degree.empty()) return hint;
  const auto number = core::parse_integer(degree);
  if (number && *number >= 1 && *number <= highest_degree)
    hint.degree = static_cast<int>(*number);
  else
    problems.error(degree, {"the degree of interpolation is not a degree", core::clipped(degree),
                            fmt::format("a whole number from 1 to {}", highest_degree), ""});
  return hint;
}

void check_centre(std::string_view at, FileProblems& problems) {
  if (at.empty() || core::equal_ignoring_case(at, "EARTH")) return;
  problems.error(at, {"the centre of the orbit is not the Earth", core::clipped(at), "CENTER_NAME = EARTH", ""});
}

bool misses_stop(const KvnLine& line, FileProblems& problems) {
  const bool is_data = line.key.empty() && !line.line.empty() && core::is_digit(line.line.front());
  if (!is_data && line.line != "DATA_START" && line.line != "META_START") return false;
  problems.error(line.line,
                 {"the block of metadata is not closed", core::clipped(line.line), "META_STOP before it", ""});
  return true;
}

int read_version(const KvnLine& line, int newest, FileProblems& problems) {
  const auto number = core::parse_number(line.value);
  for (int version = 1; version <= newest; ++version)
    if (number && *number == version) return version;
  problems.error(line.line, {"this version of the message is not read", core::clipped(line.value),
                             fmt::format("a version from 1.0 to {}.0", newest), ""});
  return 0;
}

}  // namespace sarsim::scene::ephemeris

#include "workflow/options/option.hpp"

#include <algorithm>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text/number_text.hpp"
#include "workflow/options/trade_options.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::uint64_t max_signed = INT64_MAX;
constexpr const char* hint_begins = "; did you mean ";

// Numbers beyond those with a sign are read as they stand.
std::optional<std::uint64_t> whole_number(const std::string& word, std::uint64_t high) {
  if (high <= max_signed) {
    const auto number = core::parse_integer(word);
    return number && *number >= 0 ? std::optional(static_cast<std::uint64_t>(*number)) : std::nullopt;
  }
  return core::parse_whole(word);
}

std::string unlike(const std::string& word, const std::string& expected) {
  return fmt::format("'{}' is not {}", word, expected);
}

std::string mistake_in_text(const std::string& word) {
  if (word.empty()) return "the name is empty";
  return word.starts_with("--") ? unlike(word, "a name; write ./" + word + " for such a file") : std::string();
}

// @param names  of the option, the longest last
std::string mistake_in_choice(const std::string& names, const std::vector<std::string>& words,
                              const std::string& word) {
  if (std::ranges::any_of(words, [&](const std::string& one) { return core::equal_ignoring_case(one, word); }))
    return {};
  const std::string name = names.substr(names.rfind(',') + 1);
  const std::string_view note = other_way_than_choice(name, word);
  std::string meant = meant_choice(name, word, words);
  if (meant.empty() && note.empty()) meant = core::nearest_word(word, words);
  std::string hint = meant.empty() ? "" : fmt::format("{}'{}'?", hint_begins, meant);
  if (!note.empty()) hint += meant.empty() ? fmt::format("; {}", note) : fmt::format(" {}", note);
  return unlike(word, fmt::format("one of {}{}", fmt::join(words, ", "), hint));
}

std::string mistake_in_whole(const Option& option, const std::string& word) {
  const auto number = whole_number(word, option.high);
  if (number && *number >= option.low && *number <= option.high) return {};
  return unlike(word, fmt::format("a whole number from {} to {}", option.low, option.high));
}

}  // namespace

std::string mistake_in(const Option& option, const std::string& word) {
  switch (option.kind) {
    case OptionKind::flag: break;
    case OptionKind::text:
    case OptionKind::texts: return option.takes_options ? std::string() : mistake_in_text(word);
    case OptionKind::number: return core::parse_number(word) ? std::string() : unlike(word, "a number");
    case OptionKind::whole: return mistake_in_whole(option, word);
    case OptionKind::choice: return mistake_in_choice(option.name, option.words, word);
  }
  return {};
}

core::Problem problem_with(const Option& option, const std::string& mistake) {
  core::Problem problem;
  const std::size_t hint = mistake.rfind(hint_begins);
  problem.message = option.name + ": " + mistake.substr(0, hint);
  if (hint != std::string::npos) problem.hint = mistake.substr(hint + 2);
  return problem;
}

core::Problems problems_with(const std::vector<Option>& options, const GivenWords& given) {
  core::Problems problems;
  std::vector<std::string> names;
  for (const Option& option : options) names.push_back(option.name);
  for (auto entry = given.begin(); entry != given.end(); entry = given.upper_bound(entry->first)) {
    const std::string& name = entry->first;
    if (std::ranges::find(names, name) != names.end()) continue;
    core::Problem& problem = problems.emplace_back();
    problem.message = fmt::format("unknown option '{}'", name);
    const std::string nearest = core::nearest_word(name, names);
    if (!nearest.empty()) problem.hint = fmt::format("did you mean '{}'?", nearest);
  }
  for (const Option& option : options)
    for (auto [word, end] = given.equal_range(option.name); word != end; ++word)
      if (const std::string mistake = mistake_in(option, word->second); !mistake.empty())
        problems.push_back(problem_with(option, mistake));
  return problems;
}

double number_in(const std::string& word) { return core::parse_number(word).value_or(0.0); }

std::uint64_t whole_number_in(const std::string& word) {
  if (const auto number = whole_number(word, max_signed)) return *number;
  return whole_number(word, UINT64_MAX).value_or(0);
}

std::size_t choice_in(const Option& option, const std::string& word) {
  const auto same = [&](const std::string& one) { return core::equal_ignoring_case(one, word); };
  return static_cast<std::size_t>(std::ranges::find_if(option.words, same) - option.words.begin());
}

}  // namespace sarsim::workflow

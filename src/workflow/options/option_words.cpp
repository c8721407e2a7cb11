#include "workflow/options/option_words.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/letters.hpp"

namespace sarsim::workflow {

namespace {

// What stands behind the name of an option that takes a word; moves on to it where it is the next word.
void take_word(const Option& option, const std::vector<std::string>& words, std::size_t& i, GivenWords& given,
               core::Problems& problems) {
  const std::size_t sign = words[i].find('=');
  if (sign == std::string::npos && i + 1 == words.size()) {
    problems.push_back(core::error(fmt::format("{}: {} is missing after it", option.name, option.placeholder)));
    return;
  }
  const std::string word = sign == std::string::npos ? words[++i] : words[i].substr(sign + 1);
  if (option.kind != OptionKind::texts && given.contains(option.name))
    problems.push_back(core::error(option.name + " is given twice").hint("leave one of them out"));
  else
    given.emplace(option.name, word);
}

}  // namespace

std::vector<std::string> words_of_line(const std::string& line) {
  std::vector<std::string> words;
  char quote = '\0';
  bool within = false;
  for (const char c : line) {
    if (quote == '\0' && core::is_blank(c)) {
      within = false;
      continue;
    }
    if (!within) words.emplace_back();
    within = true;
    if (quote == '\0' && (c == '"' || c == '\''))
      quote = c;
    else if (c == quote)
      quote = '\0';
    else
      words.back() += c;
  }
  if (quote != '\0')
    throw core::InvalidRequest(fmt::format("a quote {} is not closed", quote), "add it where the word ends");
  return words;
}

GivenWords given_words(const std::vector<Option>& options, const std::vector<std::string>& words) {
  GivenWords given;
  core::Problems problems;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      problems.push_back(core::error(fmt::format("'{}' belongs to no option", words[i])));
      continue;
    }
    const std::string name = words[i].substr(0, words[i].find('='));
    const auto option = std::ranges::find(options, name, &Option::name);
    if (option != options.end() && option->kind != OptionKind::flag) {
      take_word(*option, words, i, given, problems);
      continue;
    }
    if (!given.contains(name)) given.emplace(name, "");
    if (option != options.end() && name != words[i]) problems.push_back(core::error(name + " takes no word"));
    // What an unknown one seems to take is not told of besides.
    if (option == options.end() && i + 1 < words.size() && !words[i + 1].starts_with("--")) ++i;
  }
  core::append(problems, problems_with(options, given));
  if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
  return given;
}

}  // namespace sarsim::workflow

#include "scene/language/words.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scene/language/keys.hpp"
#include "scene/script/order.hpp"

namespace sarsim::scene {

namespace {

using Spelling = std::pair<std::string, std::string>;

// From the tables of kinds and options.
const std::vector<Spelling>& spellings_of_format_2() {
  static const std::vector<Spelling> all = [] {
    std::vector<Spelling> made;
    for (const FieldOf<RunOptions>& field : table_of<RunOptions>().fields())
      for (const Choice& choice : field.spec.choices)
        made.emplace_back(fmt::format("{} {}", script::option_key(field.spec), choice.word),
                          fmt::format("{} = \"{}\"", field.spec.key, type_word(choice)));
    for_each_kind([&](const auto& kind) {
      made.emplace_back(fmt::format("${}", kind.command), fmt::format("[[{}]]", language::header_of(kind.kind)));
    });
    made.emplace_back("$OPTIONS", "[options]");
    return made;
  }();
  return all;
}

}  // namespace

std::string in_format_2(std::string sentence) {
  for (const auto& [from, to] : spellings_of_format_2())
    for (std::size_t at = sentence.find(from); at != std::string::npos; at = sentence.find(from, at + to.size()))
      sentence.replace(at, from.size(), to);
  return sentence;
}

void say_in_format_2(core::Problems& problems) {
  for (core::Problem& problem : problems) {
    problem.message = in_format_2(std::move(problem.message));
    problem.expected = in_format_2(std::move(problem.expected));
    if (problem.hint.starts_with("Scripts give")) problem.hint.clear();  // which unit they have
    problem.hint = in_format_2(std::move(problem.hint));
  }
}

}  // namespace sarsim::scene

#include "scene/language/words.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text/letters.hpp"
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
    made.emplace_back(": in a script the elevation comes first", "");
    made.emplace_back("(BINARY, ASCII, BRACKET, CSV)", R"(("binary", "ascii", "bracket", "csv"))");
    made.emplace_back("NONE to drop them", "\"none\" to drop them");
    made.emplace_back("\"strong\" or ALL", "\"strong\" or \"all\"");
    made.emplace_back("by points (OTHER)", "by points");
    made.emplace_back("an MFILTER", "a low-pass");
    made.emplace_back("MFILTER", "low-pass");
    return made;
  }();
  return all;
}

// Whole words of the sentences that both languages share: what format 2 calls an alternative, and a scene.
const std::vector<Spelling>& words_of_format_2() {
  static const std::vector<Spelling> all = [] {
    std::vector<Spelling> made{{"script", "scene"}, {"scripts", "scenes"}, {"CUBIC", "cubic"}, {"LINEAR", "linear"}};
    const auto add = [&](const FieldSpec& spec) {
      for (const Choice& choice : spec.choices)
        if (choice.word.size() > 2 && choice.word != "OTHER" && choice.word != "LINEAR" && choice.word != "FILE")
          made.emplace_back(choice.word, fmt::format("\"{}\"", type_word(choice)));
    };
    for (const FieldOf<Radar>& field : table_of<Radar>().fields()) add(field.spec);
    // Formats of files have their names outside scenes, too: "a CSV table", "an ASCII grid".
    for (const FieldOf<Simulation>& field : table_of<Simulation>().fields())
      if (field.spec.key != "format") add(field.spec);
    return made;
  }();
  return all;
}

bool is_word_letter(char c) { return c == '_' || core::is_digit(c) || core::is_letter(c); }

// A word in those of format 2; itself where it has no other.
std::string_view word_in_format_2(std::string_view word) {
  for (const auto& [from, to] : words_of_format_2())
    if (from == word) return to;
  return word;
}

// Word by word; what stands in quotes is the user's.
std::string with_words_of_format_2(std::string_view sentence) {
  std::string made;
  char quote = '\0';
  for (std::size_t i = 0; i < sentence.size();) {
    const char c = sentence[i];
    const bool begins = is_word_letter(c) && (i == 0 || !is_word_letter(sentence[i - 1]));
    std::size_t end = i + 1;
    while (begins && end < sentence.size() && is_word_letter(sentence[end])) ++end;
    const std::string_view piece = sentence.substr(i, end - i);
    const bool of_name =
        end < sentence.size() && sentence[end] == '.' && end + 1 < sentence.size() && is_word_letter(sentence[end + 1]);
    made += begins && quote == '\0' && !of_name ? word_in_format_2(piece) : piece;
    if (c == quote)
      quote = '\0';
    else if (quote == '\0' && (c == '"' || (c == '\'' && (i == 0 || !is_word_letter(sentence[i - 1])))))
      quote = c;
    i = end;
  }
  return made;
}

}  // namespace

std::string in_format_2(std::string sentence) {
  for (const auto& [from, to] : spellings_of_format_2())
    for (std::size_t at = sentence.find(from); at != std::string::npos; at = sentence.find(from, at + to.size()))
      sentence.replace(at, from.size(), to);
  return with_words_of_format_2(sentence);
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

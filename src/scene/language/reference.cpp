#include "scene/language/reference.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "scene/language/explanation.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/language/value_text.hpp"

namespace sarsim::scene::language {

namespace {

std::string in_cell(std::string_view text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

std::string code(std::string_view text) { return text.empty() ? std::string() : fmt::format("`{}`", text); }

// Anchor of a heading as Markdown renderers make it.
std::string anchor(std::string_view heading) {
  std::string made;
  for (const char c : heading)
    if (c != '.' && c != '`' && c != '[' && c != ']') made += c == ' ' ? '-' : c;
  return made;
}

std::string unit_text(const PathFacts& facts) {
  const auto units = units_of(quantity_of(facts));
  return units.empty() ? std::string() : std::string(units.front());
}

std::string range_cell(const PathFacts& facts) {
  if (facts.role == PathRole::choice || facts.role == PathRole::interpolation) return {};
  return range_text(facts);
}

// One kind of object, or [options].
class TablePage {
 public:
  explicit TablePage(const PlainTable& table) : table_(table), all_(language::paths_of(table)) {}

  [[nodiscard]] std::string text() {
    text_ = fmt::format("### {}\n\n{} ", table_.header_line(), table_.meaning);
    text_ += table_.command.empty() ? "The 1998 language has nothing like it.\n"
                                    : fmt::format("In the 1998 language: `${}`.\n", table_.command);
    add_example();
    add_fields();
    for (const PathFacts& facts : all_)
      if (facts.role == PathRole::choice && has_fields(facts)) add_choice(facts);
    for (const PathFacts& facts : all_)
      if (facts.spec().type == FieldType::list)
        text_ +=
            TablePage(element_table(facts.spec().list)).elements_of(fmt::format("{}.{}", table_.header, facts.path));
    return text_;
  }

  // What stands in each table of a list.
  [[nodiscard]] std::string elements_of(const std::string& list) {
    text_ = fmt::format("\n#### Entries of {}\n\n{}\n\n| Field | Takes | Unit | Range | Default | Meaning |\n", list,
                        table_.meaning);
    text_ += "|---|---|---|---|---|---|\n";
    for (const PathFacts& facts : all_) {
      const std::vector<Dependence> on = dependences(table_, facts);
      const std::string said =
          on.empty() ? meaning(facts)
                     : fmt::format("{} Only for {} {}.", meaning(facts), on.front().choice, joined(on.front().words));
      text_ += fmt::format("| {} | {} | {} | {} | {} | {} |\n", code(facts.path), in_cell(takes_text(facts)),
                           unit_text(facts), range_cell(facts), in_cell(code(default_text(facts))), in_cell(said));
    }
    return text_;
  }

 private:
  [[nodiscard]] bool has_fields(const PathFacts& choice) const {
    return std::ranges::any_of(alternatives(choice.spec()), [&](const Choice& alternative) {
      return !paths_of_alternative(table_, choice, alternative).empty();
    });
  }

  // The functions of a block share a line, and a list is not interpolated.
  [[nodiscard]] static bool is_shown(const PathFacts& facts) {
    return facts.part == 0 && (facts.role != PathRole::interpolation || !facts.spec().block->x_ignored);
  }

  [[nodiscard]] std::string names(const PathFacts& facts) const {
    std::vector<std::string> all;
    for (const PathFacts& other : all_)
      if (other.fields == facts.fields && other.role == facts.role && (other.part != 0 || other.path == facts.path))
        all.push_back(code(other.path));
    return joined(all, ", ");
  }

  [[nodiscard]] static std::string meaning(const PathFacts& facts) {
    if (facts.role == PathRole::points) return std::string(facts.spec().tip);
    if (facts.role == PathRole::interpolation) return "How the function runs between its points.";
    if (facts.role == PathRole::file) return "A data file with the points, in place of them.";
    return meaning_text(facts);
  }

  // The choice whose table a path stands in, the innermost one; null where it stands in none.
  [[nodiscard]] const PathFacts* choice_around(const PathFacts& facts) const {
    const PathFacts* around = nullptr;
    for (const PathFacts& choice : all_)
      if (choice.role == PathRole::choice && facts.path.starts_with(choice.path + ".")) around = &choice;
    return around;
  }

  // The plain fields with values, and nothing that is rare.
  void add_example() {
    text_ += fmt::format("\n```toml\n{}\n", table_.header_line());
    for (const PathFacts& facts : all_) {
      const bool shown =
          choice_around(facts) == nullptr && !facts.spec().rare && facts.path.find('.') == std::string::npos;
      if (!shown || facts.path == "positions" || !facts.spec().when.among.empty()) continue;
      text_ += example_text(table_, facts) + "\n";
    }
    text_ += "```\n";
  }

  void add_fields() {
    std::string_view group;
    text_ +=
        "\n| Field | Takes | Unit | Range | Default | Example | Meaning | 1998 |\n|---|---|---|---|---|---|---|---|\n";
    for (const PathFacts& facts : all_) {
      if (choice_around(facts) != nullptr) continue;
      if (facts.spec().group != group) text_ += fmt::format("| **{}** | | | | | | | |\n", facts.spec().group);
      group = facts.spec().group;
      add_row(facts, dependence_text(table_, facts));
    }
  }

  void add_row(const PathFacts& facts, const std::string& condition) {
    const bool has_section = facts.role == PathRole::choice && has_fields(facts);
    const std::string name = fmt::format("{}.{}", table_.header, facts.path);
    const std::string field = has_section ? fmt::format("[`{}`](#{})", facts.path, anchor(name)) : names(facts);
    const std::string said =
        condition.empty() ? meaning(facts) : fmt::format("{} Only for {}.", meaning(facts), condition);
    text_ += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", field, in_cell(takes_text(facts)),
                         unit_text(facts), range_cell(facts), in_cell(code(default_text(facts))), example_cell(facts),
                         in_cell(said), in_cell(script_text(facts)));
  }

  // Each line of the example is a line of the cell.
  [[nodiscard]] std::string example_cell(const PathFacts& facts) const {
    std::istringstream lines(example_text(table_, facts));
    std::string cell;
    for (std::string line; std::getline(lines, line);) cell += (cell.empty() ? "" : "<br>") + in_cell(code(line));
    return cell;
  }

  void add_choice(const PathFacts& choice) {
    text_ += fmt::format("\n#### {}.{}\n\n{}\n\n", table_.header, choice.path, meaning_text(choice));
    text_ += "| Type | Meaning | Fields | 1998 |\n|---|---|---|---|\n";
    for (const Choice& alternative : alternatives(choice.spec())) add_alternative(choice, alternative);
    text_ += "\n```toml\n";
    for (const Choice& alternative : alternatives(choice.spec()))
      text_ += example_text(table_, choice, alternative) + "\n";
    const std::string shorthand = shorthand_text(table_, choice);
    if (!shorthand.empty())
      text_ += fmt::format("{}   # the same as type = {}\n", shorthand,
                           value_text(choice.spec(), choice.spec().choices.front().value));
    text_ += "```\n";
    add_fields_below(choice);
  }

  void add_alternative(const PathFacts& choice, const Choice& alternative) {
    std::vector<std::string> fields;
    for (const PathFacts& facts : paths_of_alternative(table_, choice, alternative))
      if (is_shown(facts)) fields.push_back(names(facts));
    text_ += fmt::format("| `{}` | {} | {} | {} |\n", type_word(alternative),
                         in_cell(alternative.meaning.empty() ? alternative.shown : alternative.meaning),
                         joined(fields, ", "), code(alternative.word));
  }

  void add_fields_below(const PathFacts& choice) {
    text_ +=
        "\n| Field | Takes | Unit | Range | Default | Example | Meaning | 1998 |\n|---|---|---|---|---|---|---|---|\n";
    for (const PathFacts& facts : all_)
      if (is_shown(facts) && choice_around(facts) != nullptr && choice_around(facts)->path == choice.path)
        add_row(facts, dependence_text(table_, facts));
  }

  const PlainTable& table_;
  std::vector<PathFacts> all_;
  std::string text_;
};

std::string general_section() {
  std::string text = "| Word | Takes | Meaning | 1998 |\n|---|---|---|---|\n";
  for (const char* const word : {"format", "include", "let"}) {
    const Explanation explanation = explain(word);
    text += fmt::format("| `{}` | {} | {} | {} |\n", word, in_cell(explanation.takes), in_cell(explanation.meaning),
                        in_cell(explanation.in_script));
  }
  return text;
}

}  // namespace

std::string reference() {
  std::string text = general_section();
  for (const PlainTable& table : plain_tables()) text += "\n" + TablePage(table).text();
  return text;
}

}  // namespace sarsim::scene::language

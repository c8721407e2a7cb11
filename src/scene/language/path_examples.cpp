#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/language/value_text.hpp"
#include "scene/schema/expression.hpp"

/// The defaults and examples of paths as format 2 writes them.
namespace sarsim::scene::language {

namespace {

// Two values that a function may well have, and that show the size of what is usual.
std::array<double, 2> sample_values(Quantity quantity) {
  switch (quantity) {
    case Quantity::length: return {0.0, 1000.0};
    case Quantity::time: return {1e-3, 2e-3};
    case Quantity::frequency: return {9e9, 9.1e9};
    case Quantity::angle: return {0.0, 10.0};
    case Quantity::ratio_db: return {0.0, -3.0};
    default: return {1.0, 0.5};
  }
}

// One that a field may well have whose default is nothing.
double sample_value(Quantity quantity) {
  switch (quantity) {
    case Quantity::time: return 1e-7;
    case Quantity::frequency: return 1e8;
    case Quantity::length:
    case Quantity::angle:
    case Quantity::angle_rate: return 10.0;
    case Quantity::temperature: return 290.0;
    case Quantity::ratio_db: return 3.0;
    case Quantity::voltage: return 1e-3;
    default: return 1.0;
  }
}

std::string points_example(const FunctionBlock& block, std::size_t part) {
  const Quantity quantity = quantity_of(block.y[part]);
  const auto values = sample_values(quantity);
  if (block.x_ignored)
    return fmt::format("[{}, {}]", quantity_value(values[0], quantity), quantity_value(values[1], quantity));
  const double last_x = block.x.unit == "s" ? 10.0 : block.x.unit == "deg" ? 5.0 : block.x.unit == "m" ? 1000.0 : 1.0;
  return fmt::format("[[0, {}], [{}, {}]]", core::format_number(values[0]), core::format_number(last_x),
                     core::format_number(values[1]));
}

bool is_in_range(const PlainField& field) {
  const auto* const number = std::get_if<double>(&*field.initial);
  return number == nullptr || field.spec.type != FieldType::number || field.spec.range.holds(*number);
}

// Something of the right kind where there is no default that shows it.
std::string example_value(const PathFacts& facts) {
  const FieldSpec& spec = facts.spec();
  const FunctionBlock* const block = spec.block;
  if (facts.role == PathRole::points) return points_example(*block, facts.part);
  if (facts.role == PathRole::interpolation) return in_quotes("cubic");
  if (facts.role == PathRole::file) return in_quotes("points.txt");
  if (!spec.example.empty()) return std::string(spec.example);
  if (facts.path == "positions") return "[[0, 0, 0], [0, 10, 0]]";
  if (spec.type == FieldType::text) return facts.field().initial ? default_text(facts) : in_quotes("points.npy");
  if (spec.refers == "radar") return in_quotes("Radar1");
  if (spec.type == FieldType::check) return "true";
  if (spec.type == FieldType::vector && facts.fields.size() == 1) return "[0, 0, 10]";
  const auto* const initial = spec.type == FieldType::number ? std::get_if<double>(&*facts.field().initial) : nullptr;
  if (initial == nullptr || *initial != 0.0) return default_text(facts);
  const double sample = std::min(sample_value(spec.quantity), spec.range.high);
  if (facts.fields.size() == 1) return quantity_value(sample, spec.quantity);
  const auto* const last = std::get_if<double>(&*facts.fields.back()->initial);
  const double end = last != nullptr && *last != 0.0 ? *last : 1000.0 * sample;
  return fmt::format("[{}, {}]", quantity_value(*initial, spec.quantity), quantity_value(end, spec.quantity));
}

// A key with what it is set to, or keys below it.
struct Node {
  std::string key;
  std::string text;
  std::vector<Node> below = {};
};

Node& node_at(Node& root, std::string_view path) {
  const std::size_t dot = path.find('.');
  const std::string_view first = path.substr(0, dot);
  auto found = std::ranges::find(root.below, first, &Node::key);
  if (found == root.below.end()) found = root.below.insert(root.below.end(), {std::string(first), ""});
  return dot == std::string_view::npos ? *found : node_at(*found, path.substr(dot + 1));
}

// What a path is set to; empty where it is not set.
std::string_view text_at(const Node& root, std::string_view path) {
  const std::size_t dot = path.find('.');
  const auto found = std::ranges::find(root.below, path.substr(0, dot), &Node::key);
  if (found == root.below.end()) return {};
  return dot == std::string_view::npos ? std::string_view(found->text) : text_at(*found, path.substr(dot + 1));
}

std::string inline_text(const Node& node) {
  if (node.below.empty()) return node.text;
  if (node.below.size() == 1 && node.below.front().key == "type") return node.below.front().text;
  std::string text;
  for (const Node& below : node.below)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", below.key, inline_text(below));
  return "{ " + text + " }";
}

std::string lines_of(const Node& root) {
  std::string text;
  for (const Node& node : root.below)
    text += fmt::format("{}{} = {}", text.empty() ? "" : "\n", node.key, inline_text(node));
  return text;
}

void set(Node& root, std::string_view path, std::string text) { node_at(root, path).text = std::move(text); }

// Where the word of a choice stands.
std::string word_path(const PlainTable& table, const std::string& choice) {
  return table.is_entry ? choice : choice + ".type";
}

std::string text_below(const PlainTable& table, const Node& root) {
  return table.is_entry ? inline_text(root) : lines_of(root);
}

// The types that a path needs around it, the outer ones first.
void set_types(Node& root, const PlainTable& table, const PathFacts& facts) {
  const std::vector<Dependence> all = dependences(table, facts);
  for (auto on = all.rbegin(); on != all.rend(); ++on) {
    const bool is_around = facts.path.starts_with(on->choice + ".");
    if (is_around || !on->is_default || table.is_entry)
      set(root, word_path(table, on->choice), in_quotes(on->words.front()));
  }
  for (const PathFacts& choice : paths_of(table)) {
    if (choice.role != PathRole::choice || !facts.path.starts_with(choice.path + ".")) continue;
    Node& type = node_at(root, choice.path + ".type");
    if (type.text.empty()) type.text = default_text(choice);
  }
}

// What has no default, of the type that is set.
void set_needed(Node& root, const PlainTable& table) {
  for (const PathFacts& facts : paths_of(table)) {
    if (!facts.spec().needed) continue;
    const auto is_set = [&](const Dependence& on) {
      const std::string path = word_path(table, on.choice);
      const std::string_view text = text_at(root, path);
      return std::ranges::any_of(on.words, [&](const std::string& word) { return in_quotes(word) == text; });
    };
    if (std::ranges::all_of(dependences(table, facts), is_set)) set(root, facts.path, example_value(facts));
  }
}

// Whether a path has to be written where another one of the same alternative is: the other functions of its block, or
// what has no default.
bool stands_beside(const PathFacts& facts, const PathFacts& other) {
  if (other.path == facts.path || other.field().initial || facts.spec().when.among.empty()) return false;
  if (other.role == PathRole::interpolation || other.role == PathRole::file || facts.role == PathRole::file)
    return false;
  const Condition& when = facts.spec().when;
  return other.spec().when.field == when.field && other.spec().when.among == when.among;
}

}  // namespace

std::string default_text(const PathFacts& facts) {
  if (facts.role == PathRole::interpolation) return in_quotes(interpolation_word(core::Interpolation::linear));
  std::vector<std::string> values;
  for (const PlainField* field : facts.fields) {
    if (!field->initial || !is_in_range(*field)) return {};
    if (const auto* const text = std::get_if<std::string>(&*field->initial); text != nullptr && text->empty())
      return {};
    values.push_back(value_text(field->spec, *field->initial));
  }
  return values.size() == 1 ? values.front() : "[" + joined(values, ", ") + "]";
}

std::string example_text(const PlainTable& table, const PathFacts& facts) {
  if (facts.role == PathRole::choice) {
    for (const Choice& alternative : alternatives(facts.spec()))
      if (value_text(facts.spec(), alternative.value) == default_text(facts))
        return example_text(table, facts, alternative);
  }
  return example_text(table, facts, example_value(facts));
}

std::string example_text(const PlainTable& table, const PathFacts& facts, const std::string& value) {
  Node root;
  set_types(root, table, facts);
  set_needed(root, table);
  set(root, facts.path, value);
  for (const PathFacts& other : paths_of(table))
    if (stands_beside(facts, other)) set(root, other.path, example_value(other));
  return text_below(table, root);
}

std::string example_text(const PlainTable& table, const PathFacts& choice, const Choice& alternative) {
  Node root;
  set_types(root, table, choice);
  set(root, word_path(table, choice.path), in_quotes(type_word(alternative)));
  set_needed(root, table);
  for (const PathFacts& facts : paths_of_alternative(table, choice, alternative)) {
    if (facts.role == PathRole::interpolation || facts.role == PathRole::file) continue;
    if (facts.spec().type == FieldType::check) continue;
    if (facts.spec().type == FieldType::text && facts.spec().optional) continue;
    if (facts.spec().rare && facts.spec().type != FieldType::function && !choice.spec().rare) continue;
    set(root, facts.path, facts.role == PathRole::choice ? default_text(facts) : example_value(facts));
  }
  return text_below(table, root);
}

std::string shorthand_text(const PlainTable& table, const PathFacts& facts) {
  const std::vector<PathFacts> paths = paths_of(table);
  for (const PathFacts& choice : paths) {
    const std::string& standing = choice.field().shorthand;
    if (standing.empty() || choice.role != PathRole::choice) continue;
    if (facts.path != standing && facts.path != choice.path) continue;
    const auto value = std::ranges::find(paths, standing, &PathFacts::path);
    return fmt::format("{} = {}", choice.path, example_value(*value));
  }
  return {};
}

}  // namespace sarsim::scene::language

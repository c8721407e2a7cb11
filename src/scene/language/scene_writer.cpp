#include "scene/language/scene_writer.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/value_text.hpp"
#include "scene/model/object.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

namespace {

using namespace language;

std::string points_text(const core::SampledFunction& function, const FunctionBlock& block) {
  std::string text;
  bool counted = block.x_ignored;
  for (std::size_t i = 0; i < function.knots.size(); ++i)
    counted = counted && function.knots[i].x == static_cast<double>(i);
  for (const core::Knot& knot : function.knots)
    text += (text.empty() ? "" : ", ") +
            (counted ? number_text(knot.y) : fmt::format("[{}, {}]", number_text(knot.x), number_text(knot.y)));
  return "[" + text + "]";
}

Said function_part(const core::SampledFunction& function, const FunctionBlock& block, bool in_file) {
  Said node{"", "", {}};
  if (function.method != core::Interpolation::linear)
    node.below.push_back({"interpolation", in_quotes(interpolation_word(function.method))});
  if (!in_file && !function.knots.empty())
    node.below.push_back({std::string(points_key(block)), points_text(function, block)});
  return node;
}

void add_function(const FieldSpec& spec, const ConstFunctionRef& function, std::vector<Said>& nodes) {
  const FunctionBlock& block = *spec.block;
  const bool in_file = !function.file->empty();
  for (std::size_t part = 0; part < block.count; ++part) {
    Said node = function_part(function.parts[part], block, in_file);
    if (node.below.empty()) continue;
    if (block.count == 1) {
      std::ranges::move(node.below, std::back_inserter(nodes));
    } else {
      node.key = part_key(block, part);
      nodes.push_back(std::move(node));
    }
  }
  if (in_file) nodes.push_back({"file", in_quotes(*function.file)});
}

// The node that a path below an object stands in, made where there is none yet.
std::vector<Said>& nodes_of(std::vector<Said>& nodes, std::string_view path) {
  if (path.empty()) return nodes;
  const std::size_t dot = std::min(path.find('.'), path.size());
  const std::string_view first = path.substr(0, dot);
  auto found = std::ranges::find(nodes, first, &Said::key);
  if (found == nodes.end()) found = nodes.insert(nodes.end(), {std::string(first), "", {}});
  return nodes_of(found->below, path.substr(std::min(dot + 1, path.size())));
}

Said& node_at(std::vector<Said>& nodes, std::string_view path) {
  const std::size_t dot = path.rfind('.');
  std::vector<Said>& list = nodes_of(nodes, dot == std::string_view::npos ? std::string_view() : path.substr(0, dot));
  const std::string_view last = path.substr(dot + 1);
  const auto found = std::ranges::find(list, last, &Said::key);
  return found != list.end() ? *found : list.emplace_back(Said{std::string(last), "", {}});
}

std::string list_text(const ConstListRef& list);

// What a table of fields says of an object.
template <class Object>
class ObjectNodes {
 public:
  ObjectNodes(const Object& object, Saying saying, std::span<const FieldText> also)
      : object_(object), saying_(saying), also_(also) {
    const FieldTable<Object>& table = table_of<Object>();
    for (const FieldOf<Object>& field : table.fields())
      if (table.applies(object_, field)) add(table, field);
    drop_empty(nodes_);
  }

  [[nodiscard]] std::vector<Said> take() { return std::move(nodes_); }

 private:
  void add(const FieldTable<Object>& table, const FieldOf<Object>& field) {
    const FieldSpec& spec = field.spec;
    const std::string_view key = key_of(table, field, object_);
    const FieldValue value = field.get(object_);
    if (spec.type == FieldType::function)
      return add_function(spec, std::get<ConstFunctionRef>(value), nodes_of(nodes_, key));
    if (spec.type == FieldType::list) {
      const std::string text = list_text(std::get<ConstListRef>(value));
      if (!text.empty() || saying_ == Saying::everything) set(key, text.empty() ? "[]" : text, text.empty());
      return;
    }
    static const Object initial{};
    const bool is_wanted =
        is_always_said(table, field) || std::ranges::find(also_, &spec, &FieldText::field) != also_.end();
    const bool is_default = !is_wanted && value == field.get(initial);
    if (const std::size_t bracket = key.find('['); bracket != std::string_view::npos)
      return add_listed(spec, key.substr(0, bracket), value, is_default);
    if (is_default && saying_ == Saying::differences) return;
    if (spec.optional && std::get<std::string>(value).empty()) return;
    if (spec.type == FieldType::check && spec.choices.size() == 1) {  // "same", beside a choice of the same key
      if (chosen(value) == spec.choices.front().value) set(key, in_quotes(type_word(spec.choices.front())), is_default);
      return;
    }
    if (spec.type == FieldType::choice && has_words(spec)) return add_choice(key, spec, value, is_default);
    set(key, field_value_text(spec, value, also_), is_default);
  }

  // Names, what has no default, and a choice that is there at all only because another one of the same key is not
  // "same".
  static bool is_always_said(const FieldTable<Object>& table, const FieldOf<Object>& field) {
    if (field.spec.type == FieldType::text) return !field.spec.optional;
    if (field.spec.needed) return true;
    const Condition& when = field.spec.when;
    return !when.among.empty() && table.fields()[when.field].spec.key == field.spec.key &&
           field.spec.type == FieldType::choice;
  }

  void add_choice(std::string_view key, const FieldSpec& spec, const FieldValue& value, bool is_default) {
    set(std::string(key) + ".type", value_text(spec, value), is_default);
  }

  // All values of one array stand, or none.
  void add_listed(const FieldSpec& spec, std::string_view key, const FieldValue& value, bool is_default) {
    Said& node = node_at(nodes_, key);
    if (node.text.empty()) node.is_default = true;
    node.text += (node.text.empty() ? "[" : ", ") + field_value_text(spec, value, also_);
    node.is_default = node.is_default && is_default;
    const std::size_t last = spec.type == FieldType::vector ? 2 : 1;
    if (spec.key[spec.key.find('[') + 1] == static_cast<char>('0' + last)) {
      node.text += ']';
      if (node.is_default && saying_ == Saying::differences) node.text.clear();
    }
  }

  void set(std::string_view key, std::string text, bool is_default) {
    Said& node = node_at(nodes_, key);
    node.text = std::move(text);
    node.is_default = is_default;
  }

  static void drop_empty(std::vector<Said>& nodes) {
    for (Said& node : nodes) drop_empty(node.below);
    std::erase_if(nodes, [](const Said& node) { return node.text.empty() && node.below.empty(); });
  }

  const Object& object_;
  Saying saying_;
  std::span<const FieldText> also_;
  std::vector<Said> nodes_;
};

bool all_default(const Said& node) {
  return node.below.empty() ? node.is_default : std::ranges::all_of(node.below, all_default);
}

// Where a table says a choice without the type, which is then the default, the type is put in front: a reader asks for
// it. A table of the type alone is its word.
template <class Object>
void complete_choices(const Object& object, std::vector<Said>& nodes, const std::string& prefix) {
  const FieldTable<Object>& table = table_of<Object>();
  for (Said& node : nodes) {
    const std::string path = prefix.empty() ? node.key : prefix + "." + node.key;
    if (!node.text.empty()) continue;
    complete_choices(object, node.below, path);
    for (const FieldOf<Object>& field : table.fields()) {
      const FieldSpec& spec = field.spec;
      if (spec.type != FieldType::choice || !has_words(spec) || spec.key != path || !table.applies(object, field))
        continue;
      const auto type = std::ranges::find(node.below, "type", &Said::key);
      if (type == node.below.end())
        node.below.insert(node.below.begin(), {"type", value_text(spec, field.get(object)), {}, true});
      else if (type != node.below.begin())
        std::rotate(node.below.begin(), type, type + 1);
      const bool is_default = all_default(node);
      if (!is_default) node.below.front().is_default = false;
      const FieldSpec* const standing = shorthand(table, field);
      const bool is_first = chosen(field.get(object)) == spec.choices.front().value;
      if (node.below.size() == 1)
        node.text = node.below.front().text;
      else if (standing != nullptr && is_first && node.below.size() == 2 &&
               path + "." + node.below.back().key == standing->key)
        node.text = node.below.back().text;
      node.is_default = is_default;
    }
  }
}

// One line for each key, with tables that are too long for one line below headers of their own.
void append_nodes(std::string& text, const std::vector<Said>& nodes, const std::string& header, Saying saying) {
  constexpr std::size_t longest_line = 110;
  std::vector<const Said*> tables;
  for (const Said& node : nodes) {
    std::string line = fmt::format("{} = {}", node.key, inline_text(node));
    if (node.text.empty() && line.size() > longest_line) {
      tables.push_back(&node);
      continue;
    }
    text += (saying == Saying::everything && all_default(node) ? "# " : "") + line + "\n";
  }
  for (const Said* const node : tables) {
    const std::string path = header + "." + node->key;
    text += fmt::format("[{}]\n", path);
    append_nodes(text, node->below, path, saying);
  }
}

template <class Object>
std::vector<Said> nodes_of_object(const Object& object, Saying saying, std::span<const FieldText> also = {}) {
  std::vector<Said> nodes = ObjectNodes<Object>(object, saying, also).take();
  complete_choices(object, nodes, "");
  return nodes;
}

// The elements of a list, each as a table on a line of its own; empty for none.
std::string list_text(const ConstListRef& list) {
  return visit_elements(list.kind, list.list, [](const auto& elements) {
    std::string text;
    for (const auto& element : elements)
      text += fmt::format("{}\n  {}", text.empty() ? "" : ",",
                          inline_text({"", "", nodes_of_object(element, Saying::differences)}));
    return text.empty() ? text : "[" + text + "\n]";
  });
}

template <class Object>
std::string table_text(const Object& object, std::string_view header, Saying saying) {
  std::string text = fmt::format("[[{}]]\n", header);
  append_nodes(text, nodes_of_object(object, saying), std::string(header), saying);
  return text;
}

// Length of the run of targets from one on that differ in their position alone.
std::size_t alike_from(const std::vector<Target>& targets, std::size_t first) {
  std::size_t last = first + 1;
  for (; last < targets.size(); ++last) {
    Target other = targets[last];
    other.position_m = targets[first].position_m;
    if (!(other == targets[first])) break;
  }
  return last - first;
}

std::string positions_text(const std::vector<Target>& targets, std::size_t first, std::size_t count) {
  std::string text = "positions = [";
  for (std::size_t i = 0; i < count; ++i)
    text += (i == 0 ? "\n  " : ",\n  ") + vector_text(targets[first + i].position_m);
  return text + "\n]\n";
}

void append_targets(std::string& text, const std::vector<Target>& targets, Saying saying) {
  for (std::size_t i = 0; i < targets.size();) {
    const std::size_t count = alike_from(targets, i);
    if (count == 1) {
      text += "\n" + table_text(targets[i], "target", saying);
    } else {
      Target alike = targets[i];
      alike.position_m = {};
      std::vector<Said> nodes = nodes_of_object(alike, saying);
      std::erase_if(nodes, [](const Said& node) { return node.key == "position"; });
      text += "\n[[target]]\n" + positions_text(targets, i, count);
      append_nodes(text, nodes, "target", saying);
    }
    i += count;
  }
}

void append_objects(std::string& text, const Scene& scene, ObjectKind kind, Saying saying) {
  visit_list(scene, kind, [&]<class Object>(const std::vector<Object>& objects) {
    if constexpr (std::is_same_v<Object, Target>)
      append_targets(text, objects, saying);
    else
      for (const Object& object : objects) text += "\n" + table_text(object, header_of(kind), saying);
  });
}

template <class Table>
void append_single(std::string& text, const Single<Table>& single, const Scene& scene, Saying saying) {
  const Table& table = scene.*single.member;
  if (table == Table{} && saying == Saying::differences) return;
  text += fmt::format("\n[{}]\n", single.header);
  append_nodes(text, nodes_of_object(table, saying), std::string(single.header), saying);
}

}  // namespace

std::string inline_text(const Said& said) {
  if (!said.text.empty()) return said.text;
  std::string text;
  for (const Said& below : said.below)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", below.key, inline_text(below));
  return "{ " + text + " }";
}

std::string lines_of(const Said& said, const std::string& header) {
  std::string text;
  append_nodes(text, {said}, header, Saying::differences);
  return text;
}

std::vector<Said> said_of(const AnyObject& object, std::span<const FieldText> also) {
  return std::visit([&](const auto& any) { return nodes_of_object(any, Saying::differences, also); }, object);
}

std::vector<Said> said_of(const RunOptions& options, std::span<const FieldText> also) {
  return nodes_of_object(options, Saying::differences, also);
}

std::vector<Said> said_of(const Atmosphere& atmosphere, std::span<const FieldText> also) {
  return nodes_of_object(atmosphere, Saying::differences, also);
}

// An anchor that nobody has said stays so, and is warned of.
std::vector<Said> said_of(const World& world, std::span<const FieldText> also) {
  std::vector<Said> nodes = nodes_of_object(world, Saying::differences, also);
  if (!(world.latitude == World{}.latitude && world.longitude == World{}.longitude) || !also.empty()) return nodes;
  const auto anchor = std::ranges::find(nodes, "anchor", &Said::key);
  if (anchor == nodes.end()) return nodes;
  std::erase_if(anchor->below, [](const Said& said) { return said.key == "latitude" || said.key == "longitude"; });
  if (anchor->below.empty()) nodes.erase(anchor);
  return nodes;
}

std::string field_value_text(const FieldSpec& field, const FieldValue& value, std::span<const FieldText> words) {
  const auto word_of = [&](std::size_t part) -> const std::string* {
    const auto is_it = [&](const FieldText& said) {
      return said.field == &field && said.part == part && !said.text.empty();
    };
    const auto found = std::ranges::find_if(words, is_it);
    return found == words.end() ? nullptr : &found->text;
  };
  const auto* const vector = std::get_if<core::Vec3>(&value);
  if (vector == nullptr) {
    const std::string* const word = word_of(0);
    return word != nullptr ? *word : value_text(field, value);
  }
  std::array<std::string, 3> numbers{number_text(vector->x), number_text(vector->y), number_text(vector->z)};
  for (std::size_t part = 0; part < numbers.size(); ++part)
    if (const std::string* const word = word_of(part)) numbers[part] = *word;
  return fmt::format("[{}, {}, {}]", numbers[0], numbers[1], numbers[2]);
}

std::string write_objects(const Scene& scene, ObjectKind kind) {
  std::string text;
  append_objects(text, scene, kind, Saying::differences);
  return text;
}

std::string write_format_2(const Scene& scene, Saying saying) {
  std::string text = fmt::format("# Radar scene, written by Sarsim {}\n", core::program_version);
  text += "# Angles: azimuth from +y towards +x, elevation from the x-y plane upwards\n";
  text += fmt::format("format = \"{}\"\n", format_2_mark);
  // The world stands before the objects; the options stand behind them, as they do in a script.
  const auto is_last = [](const auto& single) { return !single.command.empty(); };
  for_each_single([&](const auto& single) {
    if (!is_last(single)) append_single(text, single, scene, saying);
  });
  for (const ObjectKind kind : written_object_kinds) append_objects(text, scene, kind, saying);
  for_each_single([&](const auto& single) {
    if (is_last(single)) append_single(text, single, scene, saying);
  });
  return text;
}

}  // namespace sarsim::scene

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "core/toml/values.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/object_reader.hpp"
#include "scene/schema/grammar.hpp"

/// The user-defined functions of objects.
namespace sarsim::scene::language {

namespace toml = core::toml;

namespace {

// An axis of a function as a field, to read its numbers by.
FieldSpec axis_spec(const FieldSpec& of, const FunctionAxis& axis, const Range& range) {
  FieldSpec spec;
  spec.id = of.problem_place();
  spec.words = axis.name;
  spec.quantity = quantity_of(axis);
  spec.range = range;
  return spec;
}

}  // namespace

void ObjectReader::read_function(const FieldSpec& spec, std::string_view key, const FunctionRef& function) {
  if (!says_anything_of(key)) return;
  const FunctionBlock& block = *spec.block;
  if (Leaf* const table = text_.find(key); table != nullptr && table->value.kind == toml::Kind::table)
    note_place(spec.problem_place(), table->key);
  Leaf* const file = find(std::string(key) + ".file");
  for (std::size_t part = 0; part < block.count; ++part) {
    std::string below(key);
    if (block.count > 1) below += "." + part_key(block, part);
    if (Leaf* const table = text_.find(below); table != nullptr && table->value.kind == toml::Kind::table)
      table->used = true;
    read_part(spec, below, part, function.parts[part]);
  }
  if (file != nullptr) read_function_file(spec, *file, function);
}

void ObjectReader::read_part(const FieldSpec& spec, const std::string& key, std::size_t part,
                             core::SampledFunction& function) {
  if (Leaf* const leaf = find(key + ".interpolation")) {
    const std::string word = toml::decoded_string(source_.text, leaf->value);
    const auto known = std::ranges::find_if(
        script::interpolations, [&](const auto& alternative) { return interpolation_word(alternative.value) == word; });
    if (known != script::interpolations.end())
      function.method = known->value;
    else
      error(leaf->value.span, spec.problem_place(),
            {fmt::format("unknown interpolation of {}", spec.block->y[part].name),
             script::shown(text_of(leaf->value.span)), "linear, cubic or low-pass"});
  }
  if (Leaf* const leaf = find(fmt::format("{}.{}", key, points_key(*spec.block))))
    read_points(spec, *leaf, part, function);
}

void ObjectReader::read_points(const FieldSpec& spec, const Leaf& leaf, std::size_t part,
                               core::SampledFunction& function) {
  const FunctionBlock& block = *spec.block;
  const FieldSpec x_spec = axis_spec(spec, block.x, any_value);
  FieldSpec y_spec = axis_spec(spec, block.y[part], range_of_y(block));
  y_spec.likely = likely_y(block);
  if (leaf.value.kind != toml::Kind::array) {
    const char* const form = block.x_ignored ? "[value, value, ...]" : "[[x, y], [x, y], ...]";
    return error(leaf.value.span, spec.problem_place(),
                 {fmt::format("{} is not an array", leaf.path), std::string(noun_of(leaf.value.kind)), form});
  }
  function.knots.clear();
  toml::Elements elements(source_.text, leaf.value);
  for (std::size_t number = 1; const auto element = elements.next(); ++number) {
    core::Knot knot{static_cast<double>(function.knots.size()), 0.0};
    if (block.x_ignored && element->value.kind != toml::Kind::array) {
      if (number_in(y_spec, element->value, knot.y)) function.knots.push_back(knot);
      continue;
    }
    toml::Elements pair(source_.text, element->value);
    const auto x = pair.next();
    const auto y = pair.next();
    if (element->value.kind != toml::Kind::array || !x || !y || pair.next()) {
      error(element->value.span, spec.problem_place(),
            {fmt::format("point {} of {} is not a pair", number, block.y[part].name),
             script::shown(text_of(element->value.span)), "[x, y]"});
      continue;
    }
    const bool sound = number_in(x_spec, x->value, knot.x);
    if (!number_in(y_spec, y->value, knot.y) || !sound) continue;
    if (!block.x_ignored && !function.knots.empty() && knot.x <= function.knots.back().x)
      error(x->value.span, spec.problem_place(),
            {fmt::format("point {} of {}: {} must ascend", number, block.y[part].name, block.x.name),
             script::shown(text_of(x->value.span)),
             fmt::format("above {}", quantity_text(function.knots.back().x, x_spec.quantity))});
    function.knots.push_back(knot);
  }
}

void ObjectReader::read_function_file(const FieldSpec& spec, const Leaf& leaf, const FunctionRef& function) {
  FieldValue name = std::string();
  if (!read_text(spec, leaf, name)) return;
  *function.file = std::get<std::string>(name);
  const DataFileText data =
      reading_.loader ? reading_.loader(*function.file) : DataFileText{{}, {}, "data files cannot be read here"};
  if (!data.failure.empty() || data.path.empty())
    return error(leaf.value.span, spec.problem_place(),
                 {fmt::format("cannot read the data file of {}", spec.words), *function.file, "", data.failure});
  DataFileReading read = read_data_file(data.text, data.path, *spec.block);
  for (core::Problem& problem : read.problems) {
    problem.subject = {std::string(kind_), index_, std::string(spec.problem_place())};
    reading_.log.add(std::move(problem));
  }
  for (std::size_t i = 0; i < spec.block->count; ++i) function.parts[i].knots = std::move(read.functions[i]);
}

}  // namespace sarsim::scene::language

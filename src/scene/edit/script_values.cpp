#include "scene/edit/script_values.hpp"

#include <algorithm>

#include "core/toml/scan.hpp"
#include "scene/model/limits.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

namespace {

bool is_unsayable(char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; }

void make_sayable(std::string& name, Language language) {
  std::ranges::replace_if(name, is_unsayable, '_');
  if (language == Language::script) return;
  std::ranges::replace(name, '\t', '_');
  // Bytes that are not UTF-8.
  while (const auto forbidden = core::toml::find_forbidden(name, core::toml::span_of(0, name.size()), false, false))
    std::fill(name.begin() + forbidden->begin, name.begin() + forbidden->end, '_');
}

// False for a number that a reader refuses. Every other comes back to the last bit, but a zero without its sign.
bool say_number(double& number, const Range& range) {
  if (number == 0.0) number = 0.0;
  return computable(number) && range.holds(number);
}

bool say_vector(core::Vec3& vector, const Range& range) {
  return say_number(vector.x, range) && say_number(vector.y, range) && say_number(vector.z, range);
}

// The value of a field that is no function as a script says it; false where it cannot.
bool say_value(const FieldSpec& spec, FieldValue& value) {
  switch (spec.type) {
    case FieldType::choice:
      if (has_words(spec)) return spec.since_2 || chosen_word(spec, value) != nullptr;
      return say_number(std::get<double>(value), spec.range);
    case FieldType::number:
    case FieldType::flags: return say_number(std::get<double>(value), spec.range);
    case FieldType::vector: return say_vector(std::get<core::Vec3>(value), spec.range);
    case FieldType::text:
    case FieldType::name: return !std::get<std::string>(value).empty();
    case FieldType::seed:
    case FieldType::check:
    case FieldType::function:
    case FieldType::list: return true;
  }
  return true;
}

bool say_points(std::vector<core::Knot>& points, const FunctionBlock& block) {
  for (core::Knot& point : points)
    if (!say_number(point.x, any_value) || !say_number(point.y, range_of_y(block))) return false;
  return block.x_ignored ||
         std::ranges::adjacent_find(points, std::ranges::greater_equal{}, &core::Knot::x) == points.end();
}

bool take_points_of_file(const FunctionRef& function, const FunctionBlock& block, const DataFileLoader& loader) {
  const DataFileText data = loader ? loader(*function.file) : DataFileText{};
  if (!data.failure.empty() || data.path.empty()) return false;
  DataFileReading read = read_data_file(data.text, data.path, block);
  if (read.deferred || core::has_errors(read.problems)) return false;
  for (std::size_t i = 0; i < block.count; ++i) function.parts[i].knots = std::move(read.functions[i]);
  return true;
}

bool say_function(const FunctionRef& function, const FunctionBlock& block, const DataFileLoader& loader) {
  const auto has_word = [](const core::SampledFunction& part) {
    return std::ranges::find(script::interpolations, part.method, &script::Alternative<core::Interpolation>::value) !=
           script::interpolations.end();
  };
  if (!std::ranges::all_of(function.parts, has_word)) return false;
  if (!function.file->empty()) return take_points_of_file(function, block, loader);
  return std::ranges::all_of(function.parts,
                             [&](core::SampledFunction& part) { return say_points(part.knots, block); });
}

// What only format 2 can say stays as it is in a new object.
template <class Object>
void forget_newer(Object& object) {
  const FieldTable<Object>& table = table_of<Object>();
  for (const FieldOf<Object>& field : table.fields()) {
    const bool is_choice = field.spec.type == FieldType::choice && has_words(field.spec);
    const bool newer = field.spec.since_2 || (is_choice && chosen_word(field.spec, field.get(object)) == nullptr &&
                                              std::ranges::any_of(field.spec.choices, &Choice::since_2));
    if (newer) field.reset(object);
  }
}

// Makes of an object what a script says of it; false, with the object half changed, where a script cannot say it.
template <class Object>
bool say(Object& object, const DataFileLoader& loader, Language language) {
  const FieldTable<Object>& table = table_of<Object>();
  if (language == Language::script) forget_newer(object);
  // A choice stands before what depends on it, so that one pass is enough.
  for (const FieldOf<Object>& field : table.fields()) {
    if (!table.applies(object, field)) {
      field.reset(object);
    } else if (field.list != nullptr || field.spec.since_2) {
      continue;  // no value that a script could say otherwise
    } else if (field.function != nullptr) {
      if (!say_function(field.function(object), *field.spec.block, loader)) return false;
    } else {
      FieldValue value = field.get(object);
      if (!say_value(field.spec, value)) return false;
      field.put(object, value);
    }
  }
  return true;
}

template <class Object>
void make_names_sayable_in(Object& object, Language language) {
  for (const FieldOf<Object>& field : table_of<Object>().fields()) {
    if (field.function != nullptr) {
      make_sayable(*field.function(object).file, language);
    } else if (field.spec.type == FieldType::text || field.spec.type == FieldType::name) {
      FieldValue value = field.get(object);
      if ((field.spec.optional || field.spec.since_2) && std::get<std::string>(value).empty()) continue;
      make_sayable(std::get<std::string>(value), language);
      field.put(object, value);
    }
  }
}

}  // namespace

void make_names_sayable(AnyObject& object, Language language) {
  std::visit([&](auto& any) { make_names_sayable_in(any, language); }, object);
}

AnyObject as_script_says(const AnyObject& object, const DataFileLoader& loader, Language language) {
  AnyObject named = object;
  make_names_sayable(named, language);
  AnyObject said = named;
  return std::visit([&](auto& any) { return say(any, loader, language); }, said) ? said : named;
}

RunOptions as_script_says(const RunOptions& options) {
  RunOptions said = options;
  return say(said, {}, Language::script) ? said : options;
}

}  // namespace sarsim::scene

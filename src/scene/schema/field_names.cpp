#include "scene/schema/field_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/model/object.hpp"
#include "scene/schema/field_form.hpp"
#include "scene/schema/function_table.hpp"
#include "scene/schema/trade_words.hpp"

namespace sarsim::scene {

namespace {

// Small letters without what people put between words.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (c != '_' && c != ' ' && c != '-') result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// "position.x" of "position_m.x", "corner2.x" of "corner_m[1].x", "spot.z" of "spot_world_m.z".
std::string without_units(std::string_view id) {
  static constexpr std::array<std::string_view, 10> endings{"_world_m", "_m2", "_mps", "_hz", "_deg",
                                                            "_m",       "_s",  "_w",   "_k",  "_v"};
  const std::size_t end = std::min(id.find_first_of(".["), id.size());
  std::string_view first = id.substr(0, end);
  for (const std::string_view ending : endings)
    if (first.ends_with(ending)) {
      first.remove_suffix(ending.size());
      break;
    }
  std::string result(first);
  std::string_view rest = id.substr(end);
  if (rest.starts_with("[")) {
    result += static_cast<char>(rest[1] + 1);
    rest.remove_prefix(3);
  }
  return result + std::string(rest);
}

// "pulse.width", "position.x": the path in format 2. Of a field with two, the second is asked for by `other`.
std::string path_of(const Field& field, bool other) {
  if (field.spec == nullptr) return {};
  const std::string_view key = other ? field.spec->other_key.key : field.spec->key;
  const std::size_t dot = field.spec->type == FieldType::vector ? field.id.rfind('.') : std::string::npos;
  if (key.empty() || dot == std::string::npos) return std::string(key);
  return std::string(key) + field.id.substr(dot);
}

bool starts_like_number(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first != std::string_view::npos &&
         std::string_view("0123456789.+-").find(text[first]) != std::string_view::npos;
}

const std::vector<Field>& fields_for(const NamedField& named) {
  if (named.of_atmosphere) return atmosphere_fields();
  return named.objects.empty() ? option_fields() : fields_of(named.objects.front().kind);
}

// The fields that a name can mean.
std::vector<const Field*> fields_called(const std::vector<Field>& fields, std::string_view name) {
  const std::string wanted = plain(name);
  std::vector<const Field*> found;
  const auto collect = [&](const auto& name_of_field) {
    for (const Field& field : fields)
      if (plain(name_of_field(field)) == wanted && std::ranges::find(found, &field) == found.end())
        found.push_back(&field);
  };
  collect([](const Field& field) { return std::string_view(field.id); });
  collect([](const Field& field) { return without_units(field.id); });
  // A choice may have the path that another field is called by: "rotation".
  collect([](const Field& field) { return field.kind == FieldKind::choice ? path_of(field, false) : std::string(); });
  if (!found.empty()) return found;
  collect([](const Field& field) { return path_of(field, false); });
  collect([](const Field& field) { return path_of(field, true); });
  collect([](const Field& field) { return field.kind == FieldKind::choice ? path_of(field, false) + ".type" : ""; });
  if (!found.empty()) return found;
  if (wanted == "x" || wanted == "y" || wanted == "z")
    collect([&](const Field& field) { return field.id == "position_m." + wanted ? wanted : std::string(); });
  if (!found.empty()) return found;
  collect([](const Field& field) { return std::string_view(field.label); });
  if (found.size() > 1) found.clear();  // Labels repeat from group to group.
  return found;
}

// The alternative that a word of one of the languages stands for; null where it is none.
const Choice* alternative_called(const Field& field, std::string_view text) {
  if (field.kind != FieldKind::choice) return nullptr;
  const std::string wanted = plain(text);
  for (const Choice& choice : field.spec->choices)
    if ((!choice.word.empty() && plain(choice.word) == wanted) || plain(type_word(choice)) == wanted) return &choice;
  return field.spec->spelling == nullptr ? nullptr : choice_of_type(*field.spec, text);
}

// Of fields of one name, the choice that has the word, the number for a number and something else for a word.
const Field* fitting(const std::vector<const Field*>& fields, std::string_view value) {
  if (fields.empty()) return nullptr;
  for (const Field* field : fields)
    if (alternative_called(*field, value) != nullptr) return field;
  const bool number = starts_like_number(value);
  for (const Field* field : fields)
    if ((field->kind == FieldKind::quantity) == number) return field;
  return fields.front();
}

std::string capital(std::string_view word) {
  std::string result(word);
  result.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(result.front())));
  return result;
}

std::string file_name(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

// The objects that a word can mean, each list of one kind; the first failure where there is none.
struct ObjectSearch {
  std::vector<std::vector<ObjectId>> found;
  std::string failure;
};

void find_by_own_name(const Scene& scene, std::string_view word, ObjectSearch& search) {
  const auto look = [&](ObjectKind kind, const auto& list, const auto& is_called) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (is_called(list[i])) {
        search.found.push_back({{kind, i}});
        return;
      }
  };
  const auto named = [&](const auto& object) { return core::equal_ignoring_case(object.name, word); };
  const auto filed = [&](const auto& object) {
    return core::equal_ignoring_case(object.file, word) || core::equal_ignoring_case(file_name(object.file), word);
  };
  look(ObjectKind::radar, scene.radars, named);
  look(ObjectKind::platform, scene.platforms, named);
  look(ObjectKind::simulation, scene.simulations, filed);
  look(ObjectKind::geometry, scene.geometries, filed);
}

std::string count_failure(ObjectKind kind, std::size_t count) {
  const std::string word = capital(name_of(kind));
  if (count == 0) return fmt::format("the scene has no {}", name_of(kind));
  if (count == 1) return fmt::format("the scene has one {}: write {}1", name_of(kind), word);
  return fmt::format("the scene has {} of the kind {}: write {}1 to {}{}, or {}* for all of them", count, name_of(kind),
                     word, word, count, word);
}

// "Target3", "target 3", "Target[3]", "Target*", "Target".
void find_by_kind(const Scene& scene, std::string_view word, ObjectSearch& search) {
  std::string text = plain(word);
  std::erase_if(text, [](char c) { return c == '[' || c == ']'; });
  const std::size_t letters = std::min(text.find_first_of("*0123456789"), text.size());
  const std::string_view called = std::string_view(text).substr(0, letters);
  const auto kind = called == "recording" ? ObjectKind::simulation : kind_called(called);
  if (!kind) return;
  const std::size_t count = count_of(scene, *kind);
  const std::string_view rest = std::string_view(text).substr(letters);
  if (rest == "*" && count > 0) {
    std::vector<ObjectId> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back({*kind, i});
    search.found.push_back(std::move(all));
    return;
  }
  const auto number = rest.empty() && count == 1 ? std::optional<std::int64_t>(1) : core::parse_integer(rest);
  if (number && *number >= 1 && static_cast<std::size_t>(*number) <= count)
    search.found.push_back({{*kind, static_cast<std::size_t>(*number) - 1}});
  else if (search.failure.empty())
    search.failure = count_failure(*kind, count);
}

// A name hides a number: a radar called Target1 is meant by that word. Of objects with one name only one can have the
// field, or the number is asked for.
ObjectSearch objects_called(const Scene& scene, std::string_view word) {
  ObjectSearch search;
  find_by_own_name(scene, word, search);
  if (search.found.empty()) find_by_kind(scene, word, search);
  return search;
}

std::vector<std::string> short_names(const std::vector<Field>& fields) {
  std::vector<std::string> names;
  for (const Field& field : fields) names.push_back(short_name(fields, field));
  return names;
}

std::string_view kind_in_format_2(ObjectKind kind) {
  if (kind == ObjectKind::simulation) return "recording";
  return kind == ObjectKind::cloud ? "target" : name_of(kind);
}

// Whether a field that means nothing now was named by a word that the trade has for a number elsewhere: "pri=1 ms"
// where there is no list of intervals.
bool is_other_word(const Scene& scene, const NamedField& named, std::string_view name, std::string_view value) {
  const std::string_view last = name.substr(name.rfind('.') + 1);
  const TradeWord* const word = trade_word(last, kind_in_format_2(named.objects.front().kind));
  if (word == nullptr || keeps_value(word->law) || word->law == TradeLaw::none) return false;
  return starts_like_number(value) && !field_applies(object_of(scene, named.objects.front()), named.field->id);
}

// What to try instead of a name that nothing has.
std::string meant_among(std::string_view name, const std::vector<std::string>& names) {
  const std::string nearest = core::nearest_word(name, names);
  return nearest.empty() ? "'sarsim sweep SCENE --fields' lists what there is"
                         : fmt::format("did you mean {}?", nearest);
}

// @param kind   of the owner in format 2
// @param value  that was given; may be empty
std::string no_field(std::string_view owner, std::string_view kind, const std::vector<Field>& fields,
                     std::string_view name, std::string_view value) {
  const std::string_view last = name.substr(name.rfind('.') + 1);
  if (const TradeWord* const word = trade_word(last, kind))
    return fmt::format("{} has no field '{}'; {}", owner, name,
                       trade_setting(*word, {last, kind, value}, kind == "atmosphere" ? "Atmosphere" : owner));
  const std::vector<std::string> names = short_names(fields);
  return fmt::format("{} has no field '{}'; {}", owner, name, meant_among(name, names));
}

std::string no_object(const Scene& scene, std::string_view word) {
  std::vector<std::string> names;
  for (const Radar& radar : scene.radars) names.push_back(radar.name);
  for (const Platform& platform : scene.platforms) names.push_back(platform.name);
  for (const ObjectKind kind : all_object_kinds)
    if (count_of(scene, kind) > 0) names.push_back(capital(name_of(kind)) + "1");
  names.emplace_back("Atmosphere");
  return fmt::format("the scene has no object '{}'; {}", word, meant_among(word, names));
}

NamedField option_called(std::string_view name, std::string_view value) {
  NamedField named;
  named.field = fitting(fields_called(option_fields(), name), value);
  return named;
}

// What one way of cutting a name into object and field can mean.
std::vector<NamedField> cut_at(const Scene& scene, std::string_view object, std::string_view field,
                               std::string_view value, std::string& failure) {
  if (core::equal_ignoring_case(object, "options")) {
    NamedField named = option_called(field, value);
    if (named.field == nullptr) failure = no_field("options", "options", option_fields(), field, value);
    return named.field == nullptr ? std::vector<NamedField>{} : std::vector<NamedField>{named};
  }
  ObjectSearch search = objects_called(scene, object);
  if (search.found.empty() && core::equal_ignoring_case(object, "atmosphere")) {
    NamedField named;
    named.of_atmosphere = true;
    named.field = fitting(fields_called(fields_for(named), field), value);
    if (named.field != nullptr) return {named};
    failure = no_field("the atmosphere", "atmosphere", fields_for(named), field, value);
    return {};
  }
  if (search.found.empty() && core::equal_ignoring_case(object, "world")) {
    failure = "places in the text of a scene are read with its world; change the world there, or by a name of [let]";
    return {};
  }
  if (failure.empty()) failure = search.failure;
  std::vector<NamedField> found;
  for (std::vector<ObjectId>& objects : search.found) {
    NamedField named;
    named.objects = std::move(objects);
    named.field = fitting(fields_called(fields_for(named), field), value);
    if (named.field != nullptr && !is_other_word(scene, named, field, value))
      found.push_back(std::move(named));
    else
      failure = no_field(object, kind_in_format_2(named.objects.front().kind), fields_for(named), field, value);
  }
  return found;
}

NamedField failed(std::string failure) {
  NamedField named;
  named.failure = std::move(failure);
  return named;
}

// Gives a function the points of a data file.
std::string set_function(AnyObject& object, const Field& field, std::string_view file, const PointsLoader& load) {
  if (file.empty()) return "the name of a data file is missing";
  if (!load) return field.label + " is a user-defined function, which only a data file can give";
  NamedPoints points = load(std::string(file), *field.spec->block);
  if (!points.failure.empty()) return points.failure;
  const FunctionRef function = function_tables::function_in(object, field.id);
  for (std::size_t i = 0; i < function.parts.size(); ++i) function.parts[i].knots = std::move(points.functions.at(i));
  *function.file = file;
  return {};
}

std::string no_meaning(const Field& field) {
  return field.label + " does not apply with the present choices; change those first";
}

// What forms show of the choice that a word stands for; the text itself where it is none.
std::string_view choice_text(const NamedField& named, std::string_view text) {
  const Choice* const choice = alternative_called(*named.field, text);
  return choice == nullptr ? text : choice->shown;
}

// The words of format 2 for a choice, one for each value.
std::vector<std::string> words_of_choice(const FieldSpec& spec) {
  std::vector<std::string> words;
  std::vector<int> values;
  for (const Choice& choice : spec.choices) {
    if (std::ranges::find(values, choice.value) != values.end()) continue;
    words.push_back(type_word(choice));
    values.push_back(choice.value);
  }
  return words;
}

// Why a value was refused: where forms would list what they show, in the words of format 2.
std::string in_format_2(const NamedField& named, std::string_view text, std::string failure) {
  const FieldSpec* const spec = named.field->spec;
  if (failure.empty() || spec == nullptr || spec->type != FieldType::choice) return failure;
  if (failure != field_forms::none_of(*spec, text, field_forms::shown_choices(*spec))) return failure;
  return field_forms::none_of(*spec, text, words_of_choice(*spec));
}

}  // namespace

NamedField find_named_field(const Scene& scene, std::string_view name, std::string_view value) {
  if (name.empty()) return failed("no field is named before the '='");
  std::string failure;
  for (std::size_t dot = name.find('.'); dot != std::string_view::npos; dot = name.find('.', dot + 1)) {
    const std::string_view object = name.substr(0, dot);
    std::vector<NamedField> found = cut_at(scene, object, name.substr(dot + 1), value, failure);
    if (found.size() == 1) return std::move(found.front());
    if (found.size() > 1)
      return failed(fmt::format("{} can mean {}{} and {}{}; write one of these", object,
                                capital(name_of(found[0].objects.front().kind)), found[0].objects.front().index + 1,
                                capital(name_of(found[1].objects.front().kind)), found[1].objects.front().index + 1));
  }
  NamedField option = option_called(name, value);
  if (option.field != nullptr) return option;
  if (!failure.empty()) return failed(std::move(failure));
  const std::size_t dot = name.find('.');
  if (dot != std::string_view::npos) return failed(no_object(scene, name.substr(0, dot)));
  if (const TradeWord* const word = trade_word(name, {}))
    return failed(fmt::format("'{}' is not a valid option; {}; a field is written OBJECT.FIELD, as in Radar1.bandwidth",
                              name, trade_setting(*word, {name, {}, value}, {})));
  const std::string nearest = core::nearest_word(name, short_names(option_fields()));
  return failed(
      nearest.empty()
          ? fmt::format("'{}' is not a valid option; a field is written OBJECT.FIELD, as in Radar1.bandwidth", name)
          : fmt::format("'{}' is not a valid option; did you mean {}?", name, nearest));
}

std::string short_name(const std::vector<Field>& fields, const Field& field) {
  std::string name = without_units(field.id);
  const auto alike = std::ranges::count_if(
      fields, [&](const Field& other) { return other.id == name || without_units(other.id) == name; });
  return alike > 1 ? field.id : name;
}

std::string address_of(const Scene& scene, ObjectId id) {
  const std::string numbered = capital(name_of(id.kind)) + std::to_string(id.index + 1);
  if (id.kind != ObjectKind::radar && id.kind != ObjectKind::platform) return numbered;
  std::string name = id.kind == ObjectKind::radar ? scene.radars.at(id.index).name : scene.platforms.at(id.index).name;
  const ObjectSearch search = objects_called(scene, name);
  const bool own = search.found.size() == 1 && search.found.front() == std::vector<ObjectId>{id};
  return own && !name.empty() && name.find_first_of(" \t=,\"'*") == std::string::npos ? name : numbered;
}

std::string set_named_field(Scene& scene, const NamedField& named, std::string_view text, const PointsLoader& load) {
  const std::string_view typed = choice_text(named, text);
  if (named.of_atmosphere) {
    if (!field_applies(scene.atmosphere, named.field->id)) return no_meaning(*named.field);
    return in_format_2(named, text, set_field(scene.atmosphere, named.field->id, typed));
  }
  if (named.objects.empty()) return in_format_2(named, text, set_field(scene.options, named.field->id, typed));
  for (const ObjectId id : named.objects) {
    AnyObject object = object_of(scene, id);
    // `set_field` takes the value that is there, whether it means something or not.
    if (!field_applies(object, named.field->id)) return no_meaning(*named.field);
    std::string failure = named.field->kind == FieldKind::function ? set_function(object, *named.field, text, load)
                                                                   : set_field(object, named.field->id, typed);
    if (!failure.empty()) return in_format_2(named, text, std::move(failure));
    visit_list(scene, id.kind, [&](auto& list) {
      list.at(id.index) = std::get<std::remove_cvref_t<decltype(list.front())>>(std::move(object));
    });
  }
  return {};
}

std::string named_field_text(const Scene& scene, const NamedField& named) {
  if (named.of_atmosphere) return field_text(scene.atmosphere, named.field->id);
  if (named.objects.empty()) return field_text(scene.options, named.field->id);
  return field_text(object_of(scene, named.objects.front()), named.field->id);
}

}  // namespace sarsim::scene

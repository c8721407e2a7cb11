#include "workflow/input/scene_building.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/counted.hpp"
#include "core/text/json.hpp"
#include "core/text/number_text.hpp"
#include "scene/edit/edit.hpp"
#include "scene/model/object.hpp"
#include "scene/schema/field_names.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/schema/function_table.hpp"
#include "workflow/input/cloud_input.hpp"

namespace sarsim::workflow {

namespace {

// An object of a kind as it is before anything is said of it, under a name.
scene::AnyObject new_object(scene::ObjectKind kind, const std::string& name) {
  return scene::visit_kind(kind, [&]<class Object>(const scene::Kind<Object>&) -> scene::AnyObject {
    Object object;
    if constexpr (scene::Kind<Object>::is_named)
      object.name = name;
    else if constexpr (scene::Kind<Object>::belongs_to_radar)
      if (!name.empty()) object.file = name;
    return object;
  });
}

scene::NamedField named_field(const SceneInput& input, const std::string& name, std::string_view value = "0") {
  scene::NamedField field = scene::find_named_field(input.scene, name, value);
  if (field.field == nullptr) throw core::InvalidRequest(field.failure);
  return field;
}

// The number that a field's text stands for; nothing where it is none.
std::optional<double> number_of(const scene::Field& field, const std::string& text) {
  if (field.kind == scene::FieldKind::check) return text == "yes" ? 1.0 : 0.0;
  if (field.kind != scene::FieldKind::quantity) return std::nullopt;
  return scene::read_quantity(text, field.quantity).value;
}

std::string_view unit_of(const scene::Field& field) {
  const auto units = scene::units_of(field.quantity);
  return field.kind != scene::FieldKind::quantity || units.empty() ? std::string_view() : units.front();
}

const char* type_of(const scene::Field& field) {
  switch (field.kind) {
    case scene::FieldKind::quantity: return "number";
    case scene::FieldKind::choice: return "choice";
    case scene::FieldKind::check: return "check";
    case scene::FieldKind::platform: return "platform";
    case scene::FieldKind::radar: return "radar";
    case scene::FieldKind::list: return "list";
    case scene::FieldKind::function: return "function";
    case scene::FieldKind::text: break;
  }
  return "text";
}

// Of a number that a form shows.
void write_number(core::JsonWriter& json, const char* name, const scene::Field& field, const std::string& text) {
  if (const auto number = number_of(field, text)) json.member(name, *number);
}

void write_field_now(core::JsonWriter& json, const std::string& name, const scene::Field& field,
                     const std::string& text) {
  json.begin_object().member("name", name).member("id", field.id).member("value", text);
  write_number(json, "number", field, text);
  json.member("unit", unit_of(field)).end_object();
}

std::string path_in_format_2(const scene::Field& field) {
  const std::string key(field.spec->key);
  const std::size_t dot = field.id.rfind('.');
  const bool part = field.spec->type == scene::FieldType::vector && dot != std::string::npos;
  return part ? key + field.id.substr(dot) : key;
}

void write_limits(core::JsonWriter& json, const scene::Range& range) {
  if (std::isfinite(range.low)) json.member("least", range.low);
  if (std::isfinite(range.high)) json.member("most", range.high);
}

void write_choices(core::JsonWriter& json, const scene::Field& field) {
  if (field.kind != scene::FieldKind::choice) return;
  json.key("choices").begin_array();
  for (const scene::Choice& choice : field.spec->choices)
    json.begin_object()
        .member("word", scene::type_word(choice))
        .member("shown", choice.shown)
        .member("meaning", choice.meaning)
        .end_object();
  json.end_array();
}

// Where a field means something.
template <class Object>
void write_condition(core::JsonWriter& json, const scene::Field& field) {
  const scene::Condition& when = field.spec->when;
  if (when.among.empty()) return;
  const scene::FieldSpec& choice = scene::table_of<Object>().fields()[when.field].spec;
  json.key("when").begin_object().member("field", choice.id).key("among").begin_array();
  for (const scene::Choice& alternative : choice.choices)
    if (std::ranges::find(when.among, alternative.value) != when.among.end()) json.value(scene::type_word(alternative));
  json.end_array().end_object();
}

// @param initial  the value of a new object; empty where it is not known
template <class Object>
void write_schema_of_field(core::JsonWriter& json, const std::vector<scene::Field>& fields, const scene::Field& field,
                           const std::string& initial) {
  json.begin_object().member("name", scene::short_name(fields, field)).member("id", field.id);
  json.member("path", path_in_format_2(field)).member("label", field.label).member("group", field.group);
  json.member("type", type_of(field)).member("unit", unit_of(field)).key("units").begin_array();
  if (field.kind == scene::FieldKind::quantity)
    for (const std::string_view unit : scene::units_of(field.quantity)) json.value(unit);
  json.end_array();
  if (field.kind == scene::FieldKind::quantity) write_limits(json, field.spec->range);
  if (!initial.empty()) json.member("default", initial);
  write_number(json, "default_number", field, initial);
  write_choices(json, field);
  write_condition<Object>(json, field);
  if (field.kind == scene::FieldKind::function) json.member("functions", field.spec->block->count);
  json.member("tip", field.tooltip).end_object();
}

void write_schema_of_kinds(core::JsonWriter& json) {
  scene::for_each_kind([&]<class Object>(const scene::Kind<Object>& kind) {
    const std::vector<scene::Field>& fields = scene::fields_of(kind.kind);
    const scene::AnyObject initial = Object{};
    json.begin_object().member("name", kind.name).member("title", kind.title).member("meaning", kind.meaning);
    json.member("single", false).key("fields").begin_array();
    for (const scene::Field& field : fields)
      write_schema_of_field<Object>(json, fields, field, scene::field_text(initial, field.id));
    json.end_array().end_object();
  });
}

void write_schema_of_singles(core::JsonWriter& json) {
  const auto write = [&]<class Object>(const scene::Single<Object>& single, const std::vector<scene::Field>& fields) {
    json.begin_object().member("name", single.header).member("title", single.header).member("meaning", single.meaning);
    json.member("single", true).key("fields").begin_array();
    for (const scene::Field& field : fields) {
      std::string initial;
      if constexpr (!std::is_same_v<Object, scene::World>) initial = scene::field_text(Object{}, field.id);
      write_schema_of_field<Object>(json, fields, field, initial);
    }
    json.end_array().end_object();
  };
  write(std::get<0>(scene::singles), scene::world_fields());
  write(std::get<1>(scene::singles), scene::atmosphere_fields());
  write(std::get<2>(scene::singles), scene::option_fields());
}

void expect_points(std::span<const double> positions_m, std::span<const double> rcs_m2) {
  if (positions_m.size() % 3 != 0 || (!rcs_m2.empty() && rcs_m2.size() != positions_m.size() / 3))
    throw core::InvalidRequest("positions are three numbers for each point, cross-sections one");
}

}  // namespace

SceneInput empty_scene(const std::string& name) {
  return read_scene_text("format = \"sarsim 2\"\n", name, {}, CheckLevel::reading);
}

std::size_t add_object(SceneInput& input, scene::ObjectKind kind, const std::string& name) {
  const std::size_t index = scene::count_of(input.scene, kind);
  if (scene::is_named(kind) && !name.empty())
    if (const std::string objection = scene::name_objection(input.scene, {kind, index}, name); !objection.empty())
      throw core::InvalidRequest(fmt::format("'{}': {}", name, objection));
  scene::apply(scene::add_object(input.scene, new_object(kind, name)), input.scene);
  return index;
}

void remove_object(SceneInput& input, scene::ObjectId id) {
  scene::erase_objects(input.scene, {id});
  input.places = {};  // What they say counts objects that are gone.
  input.problems.clear();
}

void add_targets(SceneInput& input, const std::string& platform, std::span<const double> positions_m,
                 std::span<const double> rcs_m2) {
  expect_points(positions_m, rcs_m2);
  std::vector<scene::Target>& targets = input.scene.targets;
  const std::size_t count = positions_m.size() / 3;
  if (targets.capacity() < targets.size() + count)
    targets.reserve(std::max(targets.size() + count, 2 * targets.size()));
  scene::Target target;
  target.platform = platform;
  for (std::size_t i = 0; i < count; ++i) {
    target.position_m = {positions_m[3 * i], positions_m[3 * i + 1], positions_m[3 * i + 2]};
    if (!rcs_m2.empty()) target.rcs_m2 = rcs_m2[i];
    targets.push_back(target);
  }
}

void add_cloud(SceneInput& input, const std::string& platform, const std::string& file,
               std::span<const double> positions_m, std::span<const double> rcs_m2) {
  expect_points(positions_m, rcs_m2);
  input.scene.clouds.push_back(cloud_of_points(platform, file, positions_m, rcs_m2));
}

double field_number(const SceneInput& input, const std::string& name) {
  const scene::NamedField field = named_field(input, name);
  const std::string text = scene::named_field_text(input.scene, field);
  if (const auto number = number_of(*field.field, text)) return *number;
  throw core::InvalidRequest(fmt::format("{} is not a number; it is '{}'", name, text));
}

void set_field_number(SceneInput& input, const std::string& name, double value) {
  const scene::NamedField field = named_field(input, name);
  if (!std::isfinite(value)) throw core::InvalidRequest(fmt::format("{}: {} is not a finite number", name, value));
  if (field.field->kind == scene::FieldKind::check) {
    set_field_value(input, name, value != 0.0 ? "yes" : "no");
    return;
  }
  if (field.field->kind != scene::FieldKind::quantity)
    throw core::InvalidRequest(fmt::format("{} is not a number", name));
  std::string text = core::format_number(value);
  if (const std::string_view unit = unit_of(*field.field); !unit.empty()) text += fmt::format(" {}", unit);
  set_field_value(input, name, text);
}

void set_field_points(SceneInput& input, const std::string& name, std::span<const double> x, std::span<const double> y,
                      std::size_t count, core::Interpolation method) {
  const scene::NamedField field = named_field(input, name);
  if (field.field->kind != scene::FieldKind::function)
    throw core::InvalidRequest(fmt::format("{} is not given by points", name));
  const std::size_t functions = field.field->spec->block->count;
  const bool list = field.field->spec->block->x_ignored;
  if (count == 0 || y.size() != functions * count || (x.size() != count && !(list && x.empty())))
    throw core::InvalidRequest(
        fmt::format("{} takes {}, each with the same number of points", name, core::counted(functions, "function")),
        fmt::format("found {} and {}", core::counted(x.size(), "place"), core::counted(y.size(), "value")));
  for (std::size_t i = 1; i < x.size() && !list; ++i)
    if (!(x[i] > x[i - 1]))
      throw core::InvalidRequest(fmt::format("{}: the places do not ascend at point {}", name, i + 1));
  for (const scene::ObjectId id : field.objects) {
    scene::AnyObject object = scene::object_of(input.scene, id);
    if (!scene::field_applies(object, field.field->id))
      throw core::InvalidRequest(fmt::format("{} does not apply with the present choices; change those first", name));
    const scene::FunctionRef function = scene::function_tables::function_in(object, field.field->id);
    for (std::size_t f = 0; f < functions; ++f) {
      core::SampledFunction& part = function.parts[f];
      part.method = method;
      part.knots.clear();
      for (std::size_t i = 0; i < count; ++i)
        part.knots.push_back({x.empty() ? static_cast<double>(i) : x[i], y[f * count + i]});
    }
    function.file->clear();
    scene::visit_list(input.scene, id.kind, [&](auto& list_of_kind) {
      list_of_kind.at(id.index) = std::get<std::remove_cvref_t<decltype(list_of_kind.front())>>(std::move(object));
    });
  }
}

std::string fields_json(const SceneInput& input, scene::ObjectId id) {
  const scene::AnyObject object = scene::object_of(input.scene, id);
  const std::vector<scene::Field>& fields = scene::fields_of(id.kind);
  const std::string address = scene::address_of(input.scene, id);
  core::JsonWriter json;
  json.begin_array();
  for (const scene::Field& field : fields)
    if (scene::field_applies(object, field.id))
      write_field_now(json, fmt::format("{}.{}", address, scene::short_name(fields, field)), field,
                      scene::field_text(object, field.id));
  return json.end_array().text();
}

std::string option_fields_json(const SceneInput& input) {
  const std::vector<scene::Field>& fields = scene::option_fields();
  core::JsonWriter json;
  json.begin_array();
  for (const scene::Field& field : fields)
    write_field_now(json, scene::short_name(fields, field), field, scene::field_text(input.scene.options, field.id));
  return json.end_array().text();
}

std::string atmosphere_fields_json(const SceneInput& input) {
  const std::vector<scene::Field>& fields = scene::atmosphere_fields();
  const scene::Atmosphere& atmosphere = input.scene.atmosphere;
  core::JsonWriter json;
  json.begin_array();
  for (const scene::Field& field : fields)
    if (scene::field_applies(atmosphere, field.id))
      write_field_now(json, "Atmosphere." + scene::short_name(fields, field), field,
                      scene::field_text(atmosphere, field.id));
  return json.end_array().text();
}

std::string schema_json() {
  core::JsonWriter json;
  json.begin_object().key("kinds").begin_array();
  write_schema_of_kinds(json);
  write_schema_of_singles(json);
  return json.end_array().end_object().text();
}

}  // namespace sarsim::workflow

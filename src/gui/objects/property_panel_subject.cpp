#include "gui/objects/property_panel_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "gui/common/object_names.hpp"
#include "scene/language/recorded_text.hpp"

namespace sarsim::gui {

namespace {

// "Pulse width" within a sentence is "pulse width"; "PRF" and "X coordinate" stay.
std::string within_sentence(std::string label) {
  const auto small = [](char c) { return c >= 'a' && c <= 'z'; };
  if (label.size() > 1 && small(label[1]) && label[0] >= 'A' && label[0] <= 'Z')
    label[0] = static_cast<char>(label[0] - 'A' + 'a');
  return label;
}

bool is_of_air(std::string_view field) {
  return std::ranges::any_of(scene::atmosphere_fields(), [&](const scene::Field& one) { return one.id == field; });
}

bool is_of_world(std::string_view field) {
  return std::ranges::any_of(scene::world_fields(), [&](const scene::Field& one) { return one.id == field; });
}

// The ids of all three differ.
const std::vector<scene::Field>& fields_of_whole_scene() {
  static const std::vector<scene::Field> all = [] {
    std::vector<scene::Field> fields = scene::world_fields();
    for (const auto* more : {&scene::option_fields(), &scene::atmosphere_fields()})
      fields.insert(fields.end(), more->begin(), more->end());
    return fields;
  }();
  return all;
}

std::string words_of(scene::ObjectKind kind, std::size_t count) {
  const std::string word = kind == scene::ObjectKind::geometry ? "geometry table" : std::string(scene::name_of(kind));
  return count == 1 ? word : word + "s";
}

}  // namespace

std::string edit_label(std::string_view verb, const scene::Field& field) {
  return fmt::format("{} {}", verb, within_sentence(field.label));
}

PanelSubject::PanelSubject(const scene::Document& document, std::optional<scene::ObjectKind> kind,
                           const std::vector<scene::ObjectId>& ids)
    : kind_(kind),
      options_(document.scene().options),
      world_(document.scene().world),
      air_(document.scene().atmosphere),
      is_format_2_(document.language() == scene::Language::format_2) {
  if (!kind) {
    typed_ = {document.typed_fields(std::nullopt)};
    return;
  }
  constexpr std::size_t max_looked_at = 100;
  const scene::Scene& scene = document.scene();
  std::ranges::copy_if(ids, std::back_inserter(ids_), [&](scene::ObjectId id) { return scene::has_object(scene, id); });
  scene::visit_kind(*kind, [&](const auto& known) {
    auto& objects = objects_.*known.list;
    objects.reserve(ids_.size());
    for (const scene::ObjectId id : ids_) objects.push_back((scene.*known.list)[id.index]);
  });
  if (ids_.size() > max_looked_at) return;
  for (const scene::ObjectId id : ids_) typed_.push_back(document.typed_fields(id));
}

bool PanelSubject::stands_in(const scene::Scene& scene) const {
  for (std::size_t i = 0; i < ids_.size(); ++i)
    if (!scene::has_object(scene, ids_[i]) || scene::object_of(scene, ids_[i]) != object(i)) return false;
  return true;
}

const std::vector<scene::Field>& PanelSubject::fields() const {
  return kind_ ? scene::fields_of(*kind_) : fields_of_whole_scene();
}

std::string PanelSubject::title(const scene::Scene& scene) const {
  if (!kind_) return "World, options and atmosphere";
  if (!single()) return fmt::format("{} {}", ids_.size(), words_of(*kind_, ids_.size()));
  std::string label = scene::label_of(scene, ids_.front());
  if (scene::reflects(*kind_)) return label;
  std::string word = words_of(*kind_, 1);
  word[0] = static_cast<char>(word[0] - 'a' + 'A');
  return word + " " + label;
}

bool PanelSubject::applies(std::string_view field) const {
  if (!kind_ && is_of_air(field)) return is_format_2_ && scene::field_applies(air_, field);
  if (!kind_ && is_of_world(field)) return is_format_2_ && scene::field_applies(world_, field);
  return !kind_ || scene::field_applies(objects_, *kind_, field);
}

std::optional<std::string> PanelSubject::common_text(std::string_view field) const {
  if (!kind_ && is_of_world(field)) return scene::field_text(world_, field);
  if (!kind_) return is_of_air(field) ? scene::field_text(air_, field) : scene::field_text(options_, field);
  return scene::common_field_text(objects_, *kind_, field);
}

std::optional<scene::TypedField> PanelSubject::common_typed(const std::string& field) const {
  std::optional<scene::TypedField> common;
  for (const scene::TypedFields& fields : typed_) {
    const auto found = fields.find(field);
    if (found == fields.end()) return std::nullopt;
    if (!common) {
      common = found->second;
      continue;
    }
    common->said = common->said || found->second.said;
    if (common->expression != found->second.expression) common->expression.clear();
  }
  return common;
}

std::string PanelSubject::field_of(std::string_view problem_field) const {
  if (kind_) return std::string(scene::field_of_problem(*kind_, problem_field));
  if (is_of_world(problem_field) || is_of_air(problem_field)) return std::string(problem_field);
  return std::string(scene::option_field_of_problem(problem_field));
}

bool PanelSubject::concerns(const core::Subject& subject) const {
  if (!kind_) return scene::is_single(subject.kind);
  return subject.kind == scene::name_of(*kind_) &&
         std::ranges::binary_search(ids_, scene::ObjectId{*kind_, subject.index});
}

template <class Change>
FieldChange PanelSubject::change_all(const scene::Document& document, const std::string& label, bool also_same,
                                     const Change& change) const {
  const scene::Scene& scene = document.scene();
  FieldChange all;
  if (!kind_) {
    scene::RunOptions options = options_;
    all.failure = change(options);
    if (all.failure.empty() && (also_same || options != options_)) all.edit = scene::change_options(scene, options);
    return all;
  }
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    scene::AnyObject changed = object(i);
    if (std::string failure = change(changed); !failure.empty()) return {{}, std::move(failure)};
    if (!also_same && changed == object(i)) continue;
    scene::Edit one = scene::replace_object(scene, ids_[i], std::move(changed), label);
    std::ranges::move(one.changes, std::back_inserter(all.edit.changes));
  }
  all.edit.label = single() ? label : fmt::format("{} of {}", label, title(scene));
  return all;
}

void PanelSubject::say(scene::Edit& edit, const scene::Field& field, const std::string& text) const {
  const scene::Field* const known = &*std::ranges::find(fields(), field.id, &scene::Field::id);
  if (!kind_) edit.typed.push_back({std::nullopt, known, text});
  for (const scene::ObjectId id : ids_) edit.typed.push_back({id, known, text});
}

namespace {

// Without names the text is a script, which cannot say what only format 2 has.
std::string objection_of_script(const scene::AnyObject& object, const scene::LetNames* names) {
  if (names != nullptr || scene::fits_script(object)) return {};
  return "the language of 1998 cannot say this; save the scene as .toml, in format 2";
}

template <class Object>
std::string set_in(Object& object, const std::string& field, const std::string& text, const scene::LetNames* names) {
  std::string failure = scene::set_field(object, field, text, names);
  if constexpr (std::is_same_v<Object, scene::AnyObject>)
    if (failure.empty()) failure = objection_of_script(object, names);
  return failure;
}

}  // namespace

FieldChange PanelSubject::change(const scene::Document& document, const scene::Field& field, const std::string& text,
                                 const std::string& merge_key) const {
  const scene::Scene& scene = document.scene();
  if (kind_ && scene::is_named(*kind_) && field.id == "name") {
    FieldChange change;
    change.failure =
        single() ? scene::name_objection(scene, ids_.front(), text) : "names must differ; rename one after another";
    if (change.failure.empty()) change.edit = scene::rename_object(scene, ids_.front(), text);
    return change;
  }
  if (!kind_ && is_of_air(field.id)) return change_air(document, field, text);
  if (!kind_ && is_of_world(field.id)) return change_world(document, field, text);
  const scene::LetNames* const names = document.let_names();
  const bool is_typed = names != nullptr && merge_key.empty() && field.kind == scene::FieldKind::quantity;
  FieldChange change = change_all(document, edit_label("Change", field), is_typed,
                                  [&](auto& object) { return set_in(object, field.id, text, names); });
  change.edit.merge_key = merge_key;
  if (is_typed && change.failure.empty()) say(change.edit, field, scene::text_as_typed(field, text, *names));
  return change;
}

FieldChange PanelSubject::change_air(const scene::Document& document, const scene::Field& field,
                                     const std::string& text) const {
  const scene::LetNames* const names = document.let_names();
  scene::Atmosphere air = air_;
  FieldChange change;
  change.failure = scene::set_field(air, field.id, text, names);
  if (!change.failure.empty() || air == air_) return change;
  change.edit = scene::change_atmosphere(document.scene(), air);
  change.edit.label = edit_label("Change", field);
  return change;
}

FieldChange PanelSubject::change_world(const scene::Document& document, const scene::Field& field,
                                       const std::string& text) const {
  scene::World world = world_;
  FieldChange change;
  change.failure = scene::set_field(world, field.id, text, document.let_names());
  if (change.failure.empty()) change.failure = document.world_objection(world);
  if (change.failure.empty()) change.edit = edit_of_world(document, std::move(world), edit_label("Change", field));
  return change;
}

// No edit at all for the world as it is.
scene::Edit PanelSubject::edit_of_world(const scene::Document& document, scene::World world,
                                        const std::string& label) const {
  if (world == world_) return {};
  scene::Edit edit = scene::change_world(document.scene(), std::move(world));
  edit.label = label;
  return edit;
}

FieldChange PanelSubject::change_entries(
    const scene::Document& document, const scene::Field& list,
    const std::function<std::string(scene::AnyObject&, const scene::LetNames*)>& change) const {
  if (!kind_ || !single()) return {{}, "only the list of one object can be changed"};
  scene::AnyObject changed = object(0);
  const scene::LetNames* const names = document.let_names();
  std::string failure = change(changed, names);
  if (failure.empty()) failure = objection_of_script(changed, names);
  if (!failure.empty()) return {{}, std::move(failure)};
  if (changed == object(0)) return {};
  return {scene::replace_object(document.scene(), ids_.front(), std::move(changed), edit_label("Change", list)), {}};
}

std::optional<scene::AnyObject> PanelSubject::only_object() const {
  if (!kind_ || !single()) return std::nullopt;
  return object(0);
}

scene::Edit PanelSubject::reset(const scene::Document& document, const scene::Field& field) const {
  if (!kind_ && is_of_world(field.id)) {
    scene::World world = world_;
    scene::reset_field(world, field.id);
    if (!document.world_objection(world).empty()) return {};
    return edit_of_world(document, std::move(world), edit_label("Reset", field));
  }
  if (!kind_ && is_of_air(field.id)) {
    scene::Atmosphere air = air_;
    scene::reset_field(air, field.id);
    if (air == air_) return {};
    scene::Edit edit = scene::change_atmosphere(document.scene(), air);
    edit.label = edit_label("Reset", field);
    return edit;
  }
  const auto reset_one = [&](auto& object) {
    scene::reset_field(object, field.id);
    return std::string();
  };
  scene::Edit edit = change_all(document, edit_label("Reset", field), true, reset_one).edit;
  say(edit, field, "");
  return edit;
}

}  // namespace sarsim::gui

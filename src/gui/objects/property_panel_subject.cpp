#include "gui/objects/property_panel_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "gui/common/object_names.hpp"

namespace sarsim::gui {

namespace {

// "Pulse width" within a sentence is "pulse width"; "PRF" and "X coordinate" stay.
std::string within_sentence(std::string label) {
  const auto small = [](char c) { return c >= 'a' && c <= 'z'; };
  if (label.size() > 1 && small(label[1]) && label[0] >= 'A' && label[0] <= 'Z')
    label[0] = static_cast<char>(label[0] - 'A' + 'a');
  return label;
}

std::string words_of(scene::ObjectKind kind, std::size_t count) {
  const std::string word = kind == scene::ObjectKind::geometry ? "geometry table" : std::string(scene::name_of(kind));
  return count == 1 ? word : word + "s";
}

}  // namespace

PanelSubject::PanelSubject(const scene::Scene& scene, scene::ObjectKind kind, const std::vector<scene::ObjectId>& ids)
    : kind_(kind), options_(scene.options) {
  std::ranges::copy_if(ids, std::back_inserter(ids_), [&](scene::ObjectId id) { return scene::has_object(scene, id); });
  objects_.reserve(ids_.size());
  for (const scene::ObjectId id : ids_) objects_.push_back(scene::object_of(scene, id));
}

bool PanelSubject::stands_in(const scene::Scene& scene) const {
  for (std::size_t i = 0; i < ids_.size(); ++i)
    if (!scene::has_object(scene, ids_[i]) || scene::object_of(scene, ids_[i]) != objects_[i]) return false;
  return true;
}

const std::vector<scene::Field>& PanelSubject::fields() const {
  return kind_ ? scene::fields_of(*kind_) : scene::option_fields();
}

std::string PanelSubject::title(const scene::Scene& scene) const {
  if (!kind_) return "Options of the script";
  if (!single()) return fmt::format("{} {}", ids_.size(), words_of(*kind_, ids_.size()));
  std::string label = scene::label_of(scene, ids_.front());
  if (scene::reflects(*kind_)) return label;
  std::string word = words_of(*kind_, 1);
  word[0] = static_cast<char>(word[0] - 'a' + 'A');
  return word + " " + label;
}

bool PanelSubject::applies(std::string_view field) const {
  return std::ranges::all_of(objects_,
                             [&](const scene::AnyObject& object) { return scene::field_applies(object, field); });
}

std::optional<std::string> PanelSubject::common_text(std::string_view field) const {
  if (!kind_) return scene::field_text(options_, field);
  if (objects_.empty()) return std::nullopt;
  std::string first = scene::field_text(objects_.front(), field);
  for (std::size_t i = 1; i < objects_.size(); ++i)
    if (scene::field_text(objects_[i], field) != first) return std::nullopt;
  return first;
}

std::string PanelSubject::field_of(std::string_view problem_field) const {
  return std::string(kind_ ? scene::field_of_problem(*kind_, problem_field)
                           : scene::option_field_of_problem(problem_field));
}

bool PanelSubject::concerns(const core::Subject& subject) const {
  if (!kind_) return subject.kind == "options";
  return subject.kind == scene::name_of(*kind_) &&
         std::ranges::binary_search(ids_, scene::ObjectId{*kind_, subject.index});
}

FieldChange PanelSubject::change(const scene::Scene& scene, const scene::Field& field, const std::string& text,
                                 const std::string& merge_key) const {
  FieldChange change;
  if (!kind_) {
    scene::RunOptions options = options_;
    change.failure = scene::set_field(options, field.id, text);
    if (change.failure.empty() && options != options_) change.edit = scene::change_options(scene, options);
    change.edit.merge_key = merge_key;
    return change;
  }
  if (scene::is_named(*kind_) && field.id == "name") {
    change.failure =
        single() ? scene::name_objection(scene, ids_.front(), text) : "names must differ; rename one after another";
    if (change.failure.empty()) change.edit = scene::rename_object(scene, ids_.front(), text);
    return change;
  }
  const std::string label = "Change " + within_sentence(field.label);
  for (std::size_t i = 0; i < ids_.size() && change.failure.empty(); ++i) {
    scene::AnyObject object = objects_[i];
    change.failure = scene::set_field(object, field.id, text);
    if (!change.failure.empty() || object == objects_[i]) continue;
    scene::Edit one = scene::replace_object(scene, ids_[i], std::move(object), label);
    std::ranges::move(one.changes, std::back_inserter(change.edit.changes));
  }
  if (!change.failure.empty()) change.edit = {};
  change.edit.label = single() ? label : fmt::format("{} of {}", label, title(scene));
  change.edit.merge_key = merge_key;
  return change;
}

}  // namespace sarsim::gui

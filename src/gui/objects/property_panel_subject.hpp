#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/problem.hpp"
#include "scene/edit/document.hpp"
#include "scene/edit/edit.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::gui {

/// An edit, or why there is none, in words.
struct FieldChange {
  scene::Edit edit;
  std::string failure;
};

/// What the menu calls an edit of a field: "Change position x".
[[nodiscard]] std::string edit_label(std::string_view verb, const scene::Field& field);

/// What a property panel shows: objects of one kind or, where there are none, what holds for the whole scene: the
/// world, the run options and the atmosphere.
class PanelSubject {
 public:
  PanelSubject() = default;
  /// Objects of one kind, without those that the scene does not have; without a kind, what holds for the whole scene.
  explicit PanelSubject(const scene::Document& document, std::optional<scene::ObjectKind> kind = std::nullopt,
                        const std::vector<scene::ObjectId>& ids = {});

  /// Nothing for what holds for the whole scene.
  [[nodiscard]] std::optional<scene::ObjectKind> kind() const { return kind_; }
  [[nodiscard]] const std::vector<scene::ObjectId>& ids() const { return ids_; }
  [[nodiscard]] bool single() const { return ids_.size() == 1; }
  /// Whether the scene has the same objects, as they are here, at the same ids.
  [[nodiscard]] bool stands_in(const scene::Scene& scene) const;
  [[nodiscard]] bool same_objects(const PanelSubject& other) const {
    return kind_ == other.kind_ && ids_ == other.ids_;
  }

  /// The fields of their kind, or of the world, the run options and the atmosphere.
  [[nodiscard]] const std::vector<scene::Field>& fields() const;
  /// "Radar Radar1", "3 targets", "World, options and atmosphere".
  [[nodiscard]] std::string title(const scene::Scene& scene) const;
  /// Whether the field means something for all objects.
  [[nodiscard]] bool applies(std::string_view field) const;
  /// What all objects show for a field; nothing where they differ.
  [[nodiscard]] std::optional<std::string> common_text(std::string_view field) const;
  /// What the text of the scene says of a field: that it says it where it does so for one of them, and an expression
  /// where all have the same. Nothing where that is not known, as of more than 100 objects.
  [[nodiscard]] std::optional<scene::TypedField> common_typed(const std::string& field) const;
  /// The field of the panel that a problem's field belongs to; empty where there is none.
  [[nodiscard]] std::string field_of(std::string_view problem_field) const;
  /// Whether a problem is about one of the objects.
  [[nodiscard]] bool concerns(const core::Subject& subject) const;

  /// The edit that gives all objects the typed value, as one step. In format 2 the text of the scene then says what was
  /// typed, unless it is one of a run of steps.
  [[nodiscard]] FieldChange change(const scene::Document& document, const scene::Field& field, const std::string& text,
                                   const std::string& merge_key = "") const;
  /// The edit that changes a list of the one object that is shown.
  /// @param change  changes the list and says why not where it cannot
  [[nodiscard]] FieldChange change_entries(
      const scene::Document& document, const scene::Field& list,
      const std::function<std::string(scene::AnyObject&, const scene::LetNames*)>& change) const;
  /// The only object that is shown; nothing where there are none, or several.
  [[nodiscard]] std::optional<scene::AnyObject> only_object() const;
  /// The edit that gives all objects the default, and takes what the text of format 2 says of the field out of it.
  [[nodiscard]] scene::Edit reset(const scene::Document& document, const scene::Field& field) const;

 private:
  [[nodiscard]] FieldChange change_air(const scene::Document& document, const scene::Field& field,
                                       const std::string& text) const;
  [[nodiscard]] FieldChange change_world(const scene::Document& document, const scene::Field& field,
                                         const std::string& text) const;
  [[nodiscard]] scene::Edit edit_of_world(const scene::Document& document, scene::World world,
                                          const std::string& label) const;
  [[nodiscard]] scene::AnyObject object(std::size_t index) const { return scene::object_of(objects_, {*kind_, index}); }
  // Changes one object or the options; says why not where it cannot.
  template <class Change>
  [[nodiscard]] FieldChange change_all(const scene::Document& document, const std::string& label, bool also_same,
                                       const Change& change) const;
  // Has the text of format 2 say something of a field of all objects.
  void say(scene::Edit& edit, const scene::Field& field, const std::string& text) const;

  std::optional<scene::ObjectKind> kind_;
  std::vector<scene::ObjectId> ids_;
  scene::Scene objects_;  // as they were, in the list of their kind
  scene::RunOptions options_;
  scene::World world_;
  scene::Atmosphere air_;
  bool is_format_2_ = false;               // the language of 1998 knows neither world nor air
  std::vector<scene::TypedFields> typed_;  // of each object, or of the options
};

}  // namespace sarsim::gui

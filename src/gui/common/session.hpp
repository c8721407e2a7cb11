#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "scene/edit/document.hpp"
#include "scene/edit/scene_change.hpp"
#include "scene/model/object.hpp"

namespace sarsim::gui {

/// What all windows of the workbench share: the document, what is selected and hidden, and the time of the scene.
/// Every change of the scene goes through here and is announced once, so that windows never talk to each other.
class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);

  [[nodiscard]] const scene::Document& document() const { return document_; }
  [[nodiscard]] const scene::Scene& scene() const { return document_.scene(); }
  /// The scene as it is, for work that goes on while it changes. Copied at most once for each change.
  [[nodiscard]] std::shared_ptr<const scene::Scene> shared_scene() const;

  /// Puts another document in place of this one; selection and hidden objects are cleared, the time is 0.
  void take(scene::Document document);
  /// Applies an edit; an empty one is passed over. Selection and hidden objects follow theirs.
  void perform(scene::Edit edit);
  /// Ends a run of merged edits: a drag, a spin box.
  void end_run();
  /// Replaces the script, as typed (Document::type_text).
  void type_text(const std::string& text);
  /// Takes back the last step, if any.
  void undo();
  /// Takes back the last step, if any, for good: a drag that is given up.
  void take_back();
  /// Makes it again, if any was taken back.
  void redo();
  /// Throws what Document::save throws.
  void save(const std::filesystem::path& path);

  /// Problems of the document as far as they are known, for windows that show them. Looked for at once after a single
  /// edit; during a run of merged edits (a drag, a spin box) only when it pauses, because that reads the whole script.
  /// Until then they are those of before the run, about the same objects.
  [[nodiscard]] const core::Problems& problems() const { return problems_; }

  [[nodiscard]] const std::set<scene::ObjectId>& selection() const { return selection_; }
  /// The object that panels show: the one selected last, if any.
  [[nodiscard]] std::optional<scene::ObjectId> current() const { return current_; }
  /// Selects these and no others.
  void select(std::set<scene::ObjectId> objects);
  /// Selects one object.
  void select_only(scene::ObjectId object);
  void select_also(scene::ObjectId object);  ///< Adds it, or takes it out where it is in.

  [[nodiscard]] const std::set<scene::ObjectId>& hidden() const { return hidden_; }
  /// Hides objects in the scene view, or shows them again.
  void set_hidden(const std::set<scene::ObjectId>& objects, bool hide);

  [[nodiscard]] double time_s() const { return time_s_; }
  /// The time at which the scene is seen.
  void set_time(double time_s);

  /// Adds a line to the log panel.
  void log(core::Severity severity, const QString& text);

 signals:
  /// Scene, script text, history or unsaved mark are others, and with them the problems of a single edit; `change` says
  /// what became of the scene. Comes once for each change, also for an edit that came to nothing.
  void scene_changed(const sarsim::scene::SceneChange& change);
  void problems_changed();           ///< Problems were looked for while the scene stayed as it was: a run paused.
  void document_changed();           ///< Path and unsaved mark changed while scene and text stayed: it was saved.
  void document_replaced();          ///< Another document was taken.
  void selection_changed();          ///< Other objects are selected.
  void hidden_changed();             ///< Other objects are hidden.
  void time_changed(double time_s);  ///< The scene is seen at another time.
  void logged(int severity, const QString& text);  ///< A line for the log panel.

 private:
  [[nodiscard]] scene::SceneChange follow_last_edit();
  void look_for_problems();
  void log_replaced_expressions();
  void find_put_off_problems();

  scene::Document document_;
  mutable std::shared_ptr<const scene::Scene> shared_;  // null until somebody asks for the scene as it is
  std::set<scene::ObjectId> selection_;
  std::optional<scene::ObjectId> current_;
  std::set<scene::ObjectId> hidden_;
  double time_s_ = 0.0;
  core::Problems problems_;
  QTimer problems_soon_;
};

}  // namespace sarsim::gui

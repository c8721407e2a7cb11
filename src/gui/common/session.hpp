#pragma once

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gui/common/latest_only_work.hpp"
#include "scene/edit/document.hpp"
#include "scene/edit/scene_change.hpp"
#include "scene/model/object_id.hpp"

namespace sarsim::gui {

/// What all windows of the workbench share: the documents that are open, the one at hand, what is selected and hidden
/// in it, and the time of its scene. Every change of the scene goes through here and is announced once, so that windows
/// never talk to each other.
class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);

  ~Session() override;

  /// The document at hand.
  [[nodiscard]] const scene::Document& document() const { return desk_->document; }
  [[nodiscard]] const scene::Scene& scene() const { return desk_->document.scene(); }
  /// The scene as it is, for work that goes on while it changes. Copied at most once for each change.
  [[nodiscard]] std::shared_ptr<const scene::Scene> shared_scene() const { return desk_->document.shared_scene(); }

  /// How many documents are open, one at least; they stand in a row.
  [[nodiscard]] std::size_t document_count() const { return desks_.size(); }
  /// Where in the row the document at hand stands.
  [[nodiscard]] std::size_t at_hand() const;
  /// The document at a place of the row; std::out_of_range where there is none, here and below.
  [[nodiscard]] const scene::Document& document_at(std::size_t index) const { return desks_.at(index)->document; }
  /// Tells documents apart for as long as the program runs: no other one has, had or will have the number.
  [[nodiscard]] int number_at(std::size_t index) const { return desks_.at(index)->number; }
  /// That of the document at hand.
  [[nodiscard]] int number() const { return desk_->number; }
  /// Puts a document behind the one at hand, and turns to it: nothing is selected or hidden, the time is 0.
  void add(scene::Document document);
  /// The same in place of the one at hand, which is closed.
  void take(scene::Document document);
  /// Takes another document in hand, as it was left: selection, hidden objects, time.
  void turn_to(std::size_t index);
  /// Puts a document at another place of the row.
  void move(std::size_t from, std::size_t to);
  /// Closes a document, with everything in it that was not saved. The last one gives way to an empty scene.
  void close(std::size_t index);

  /// Applies an edit; an empty one is passed over. Selection and hidden objects follow theirs. One of many objects is
  /// made on another thread, here and in `undo` and `redo`, and can be cancelled (`run_and_wait`). What cannot be done
  /// is told in the log.
  void perform(scene::Edit wanted);
  /// Makes an edit from a document, or says why it cannot be made, in words.
  using MakeEdit = std::function<std::string(const scene::Document& document, scene::Edit& edit)>;
  /// Makes an edit and performs it. One of many objects is made on another thread from a copy of the document, so
  /// `make` must hold on to all that it needs.
  /// @param what     for the dialog of work that takes longer than a moment
  /// @param objects  that it changes, about
  /// @return  why it was not made, of many objects also what `make` threw; empty also where the user gave it up
  [[nodiscard]] std::string make_and_perform(const QString& what, std::size_t objects, const MakeEdit& make);
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
  /// In a long text they are looked for in the background (`problems_changed`). Until then they are those of before,
  /// about the same objects, or none.
  [[nodiscard]] const core::Problems& problems() const { return desk_->problems; }

  [[nodiscard]] const std::set<scene::ObjectId>& selection() const { return desk_->selection; }
  /// Tells selections apart: equal numbers, equal selections.
  [[nodiscard]] std::uint64_t selection_number() const { return selection_number_; }
  /// The object that panels show: the one selected last, if any.
  [[nodiscard]] std::optional<scene::ObjectId> current() const { return desk_->current; }
  /// Selects these and no others; those that the scene does not have are passed over.
  void select(std::set<scene::ObjectId> objects);
  /// Selects one object.
  void select_only(scene::ObjectId object);
  void select_also(scene::ObjectId object);  ///< Adds it, or takes it out where it is in.

  [[nodiscard]] const std::set<scene::ObjectId>& hidden() const { return desk_->hidden; }
  /// Hides objects in the scene view, or shows them again.
  void set_hidden(const std::set<scene::ObjectId>& objects, bool hide);

  [[nodiscard]] double time_s() const { return desk_->time_s; }
  /// The time at which the scene is seen.
  void set_time(double time_s);

  /// Adds a line to the log panel.
  void log(core::Severity severity, const QString& text);

 signals:
  /// Scene, script text, history or unsaved mark are others, and with them the problems of a single edit; `change` says
  /// what became of the scene. Comes once for each change, also for an edit that came to nothing.
  void scene_changed(const sarsim::scene::SceneChange& change);
  void problems_changed();   ///< Problems were looked for while the scene stayed: a run paused, or the text is long.
  void document_changed();   ///< Path and unsaved mark changed while scene and text stayed: it was saved.
  void document_replaced();  ///< Another document is at hand.
  void document_closed(int number);  ///< A document is gone: what was kept about it is of no use any more.
  void row_changed();                ///< Other documents are open, or they stand in another order.
  void selection_changed();          ///< Other objects are selected; comes after `scene_changed`.
  void hidden_changed();             ///< Other objects are hidden.
  void time_changed(double time_s);  ///< The scene is seen at another time.
  void logged(int severity, const QString& text);  ///< A line for the log panel.

 private:
  // A document that is open, and how it is seen.
  struct Desk {
    int number = 0;
    scene::Document document;
    std::set<scene::ObjectId> selection;
    std::optional<scene::ObjectId> current;
    std::set<scene::ObjectId> hidden;
    double time_s = 0.0;
    core::Problems problems;
  };

  [[nodiscard]] std::unique_ptr<Desk> desk_with(scene::Document document);
  void show_desk(Desk& desk);
  using Change = std::function<void(scene::Document& document)>;
  void take_step(const scene::Edit* step, const Change& change);
  void change_document(const scene::Edit& step, const Change& change);
  void change_beside(const std::string& label, const Change& change);
  // What became of the scene, and whether other objects are selected than before.
  struct Followed {
    scene::SceneChange change;
    bool selection_differs = false;
  };
  [[nodiscard]] Followed follow_last_edit();
  void tell(const Followed& followed);
  void take_selection(std::set<scene::ObjectId> objects);
  void look_for_problems();
  void log_replaced_expressions();
  void find_put_off_problems();
  void take_search(bool good);

  int last_number_ = 0;
  std::uint64_t selection_number_ = 0;
  std::vector<std::unique_ptr<Desk>> desks_;
  Desk* desk_ = nullptr;  // the one at hand
  QTimer problems_soon_;
  // For problems of a long text, and what it was begun with.
  LatestOnlyWork search_;
  std::shared_ptr<scene::Document::Findings> found_;
  std::uint64_t searched_ = 0;  // the revision of the document at hand
};

}  // namespace sarsim::gui

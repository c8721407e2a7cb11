#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "script/reader.hpp"
#include "view/history.hpp"

namespace sarsim {

/// A scene being edited together with its script text, its file and its history. Scene and text always say the same:
/// an edit of the scene rewrites the commands of the objects it touched and leaves everything else, comments included,
/// as it was typed; a new text that can be read becomes an edit of the scene.
class Document {
 public:
  /// An empty scene: one platform, Earth (thesis 4.1).
  Document();

  /// A document from a file. Throws nothing: what stands in the way is in `problems`, and the document is then empty.
  [[nodiscard]] static Document open(const std::filesystem::path& path);
  /// A document without a file from a text, for templates and examples.
  [[nodiscard]] static Document from_text(std::string text);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Empty where it was never saved.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Problems of the text, or of the scene (`check`), with their places in the text. Made anew after each change.
  [[nodiscard]] const Problems& problems() const { return problems_; }
  /// Where each field stands in the text.
  [[nodiscard]] const FieldPlaces& places() const { return places_; }
  /// True where the text could not be read: the scene is then the last one that could.
  [[nodiscard]] bool text_broken() const { return text_broken_; }
  [[nodiscard]] bool changed() const;

  void perform(Edit edit);
  void end_run() { history_.end_run(); }
  /// Replaces the text, as typed. Where it can be read without errors of language, the scene follows in one undoable
  /// step; otherwise the scene stays and `problems` says why. Typing in a row is one step.
  void type_text(std::string text);
  void undo();
  void redo();
  [[nodiscard]] const History& history() const { return history_; }
  /// The edit that the last perform, undo, redo or type_text applied, and in which direction; for those who follow ids.
  struct LastEdit {
    Edit edit;
    bool forwards = true;
  };
  [[nodiscard]] const std::optional<LastEdit>& last_edit() const { return last_edit_; }

  /// Writes the text to a file, completely or not at all, and makes it this document's. Throws std::runtime_error that
  /// names the file and the cause.
  void save(const std::filesystem::path& path);
  /// True where the file on disk is no longer what was opened or saved here.
  [[nodiscard]] bool changed_on_disk() const;

 private:
  void follow_scene(const Scene& before);
  void read_places();

  Scene scene_;
  std::string text_;
  std::filesystem::path path_;
  std::string text_on_disk_;
  Problems problems_;
  FieldPlaces places_;
  bool text_broken_ = false;
  History history_;
  std::optional<LastEdit> last_edit_;
};

}  // namespace sarsim

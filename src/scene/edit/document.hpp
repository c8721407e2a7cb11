#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "scene/edit/data_functions.hpp"
#include "scene/edit/history.hpp"
#include "scene/edit/included_texts.hpp"
#include "scene/edit/splice_places.hpp"
#include "scene/edit/splice_tables.hpp"
#include "scene/edit/typed_fields.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::scene {

/// An expression of a text in whose place an edit wrote something else.
struct ReplacedExpression {
  std::optional<ObjectId> object;  ///< Nothing: of the options.
  const Field* field = nullptr;
  std::string expression;
};

/// A scene being edited together with its text in either language (`Language`), its file and its history. Scene and
/// text always say the same: an edit of the scene rewrites what the text says of the objects it touched and leaves
/// everything else, comments included, as it was typed; a new text that can be read becomes an edit of the scene. Both
/// are undone together, byte by byte.
class Document {
 public:
  /// An empty scene in format 2: one platform, Earth (thesis 4.1).
  Document();

  /// A document from a file. Throws nothing: what stands in the way is in `problems`. Where that is the file itself
  /// (none, a folder, no text) the document is empty and without a path; where the script holds mistakes, the scene is
  /// what could be understood of it. A scene in JSON becomes one in TOML that was never saved.
  [[nodiscard]] static Document open(const std::filesystem::path& path);
  /// A document without a file from a text, for templates and examples; mistakes as in `open`.
  [[nodiscard]] static Document from_text(std::string text);

  /// Reads the files of clouds into a scene; says what is wrong with them.
  /// @param folder  of the script
  using FileReader = std::function<core::Problems(Scene& scene, const std::filesystem::path& folder)>;
  /// From here on the points of clouds are read, at once and after each change.
  void read_files_with(FileReader reader);

  /// As it is; an edit may put another one in its place.
  [[nodiscard]] const Scene& scene() const { return *scene_; }
  /// The same for work that goes on while the document changes: it stays as it is. Costs nothing until the next edit,
  /// which then works on a copy. Copies of a document share it likewise.
  [[nodiscard]] std::shared_ptr<const Scene> shared_scene() const { return scene_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Empty where it was never saved.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Problems of the text and, where it holds no errors, of the scene (`check`), with their places in the text; ranked.
  /// Found when they are asked for, once after each change; that reads the text, so a drag of many objects should ask
  /// when it ends.
  [[nodiscard]] const core::Problems& problems() const { return findings().problems; }
  /// What is known of a text.
  struct Findings {
    core::Problems problems;
    FieldPlaces places;
    LetNames names;
  };
  /// Finds what `problems`, `places` and `let_names` tell, on any thread while the document goes on. Null where that is
  /// known already, and where it depends on more than the text: on files of points or of motion.
  [[nodiscard]] std::function<Findings()> search() const;
  /// Takes over what a search has found, unless the document is at another revision than where it was begun.
  void take(Findings found, std::uint64_t revision);
  /// Where each field stands in the text; found as the problems are.
  [[nodiscard]] const FieldPlaces& places() const { return findings().places; }
  /// Where the commands of the objects stand in the text, or their tables and rows in format 2 (`find_objects`). While
  /// the text is broken, those of the last one that could be read, or none. Found when they are asked for, once after
  /// each change.
  [[nodiscard]] const CommandPlaces& commands() const;
  /// What the text says of each field of an object's form, or of the options where there is no id. Empty in the
  /// language of 1998, which says every field, and while a broken text hides it.
  [[nodiscard]] TypedFields typed_fields(std::optional<ObjectId> id) const;
  /// That of the last text that could be read, or of the present one.
  [[nodiscard]] Language language() const;
  /// The names of [let], which expressions in fields may use; null in the language of 1998. Found as the problems are.
  [[nodiscard]] const LetNames* let_names() const;
  /// True where the text was typed so that it cannot be read: the scene is then the last one that could.
  [[nodiscard]] bool text_broken() const { return text_broken_; }
  /// Texts of the data files, by their names in the script, that hold the points of edited functions and are not on
  /// disk yet. They are the function editor's to write.
  [[nodiscard]] const std::map<std::string, std::string>& pending_data() const { return data_.texts(); }
  /// True where scene or text are not as they were saved last.
  [[nodiscard]] bool changed() const;

  /// Applies an edit and writes the objects that it touches into the text. What a script cannot say of them, members
  /// that their choices make meaningless for example, is left out of the scene too. While the text is broken the last
  /// text that could be read is written on; undoing gives the broken one back.
  /// @throws std::logic_error where the edit was not made for this scene; nothing is changed then
  void perform(Edit edit);
  /// Why the text could not be read in another world, in words: places by latitude over a flat one, a grid that is not
  /// there. Empty where it could.
  [[nodiscard]] std::string world_objection(const World& world) const;
  void end_run() { history_.end_run(); }
  /// The expressions in whose place the last `perform` wrote something else, because the scene demanded it: other than
  /// those of fields that were typed into. Looked for among the first 1000 objects of an edit that only replaces.
  [[nodiscard]] const std::vector<ReplacedExpression>& replaced_expressions() const { return replaced_; }
  /// Replaces the text, as typed. Where it can be read without errors of language, the scene follows in one undoable
  /// step; otherwise the scene stays and `problems` says why. Typing in a row is one step.
  void type_text(std::string text);
  /// Takes back the last step, with its text; std::logic_error where there is none.
  void undo();
  /// Takes back the last step for good, as if it had never been: a drag that is given up. std::logic_error where there
  /// is none.
  void take_back();
  /// Makes the step again that was taken back last; std::logic_error where there is none.
  void redo();
  [[nodiscard]] const History& history() const { return history_; }
  /// The edit that the last perform, undo, redo or type_text applied, and in which direction; for those who follow ids.
  struct LastEdit {
    std::shared_ptr<const Edit> edit;  ///< Never null.
    bool forwards = true;
  };
  [[nodiscard]] const std::optional<LastEdit>& last_edit() const { return last_edit_; }
  /// How many edits were applied, in either direction. One that changed nothing is none, and `last_edit` is still the
  /// one before.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  /// What the text includes, changes that are not on disk yet among it. Reads the files.
  [[nodiscard]] std::vector<IncludedText> included() const;

  /// Writes the text to a file, completely or not at all, and makes it this document's. Throws std::runtime_error that
  /// names the file and the cause.
  void save(const std::filesystem::path& path);
  /// True where the file on disk is no longer what was opened or saved here.
  [[nodiscard]] bool changed_on_disk() const;

 private:
  // A text, where its commands stand if that is known, and how it comes from the present one.
  struct NewText {
    std::string text;
    std::optional<CommandPlaces> commands;
    TextChanges changes;
    std::map<std::string, TextChanges> included;  // of files that the text includes
    std::optional<format_2::ObjectTables> tables = {};
  };

  void load(std::string text);
  void read_files();
  void follow_history(std::shared_ptr<const Edit> edit, bool forwards);
  void follow_world(Edit& edit, const std::string& text) const;
  void note_edit(std::shared_ptr<const Edit> edit, bool forwards);
  [[nodiscard]] NewText text_after(const Edit& edit, const DataFileLoader& loader) const;
  [[nodiscard]] NewText script_after(const std::string& base, const Edit& edit, const DataFileLoader& loader) const;
  [[nodiscard]] const std::string* sound_text() const;
  [[nodiscard]] const format_2::ObjectTables& tables() const;
  [[nodiscard]] std::vector<ReplacedExpression> expressions_at_stake(const Edit& edit) const;
  void drop_those_kept(std::vector<ReplacedExpression>& expressions) const;
  void forget_places();
  [[nodiscard]] TypedFields typed_in_included(ObjectId id) const;
  [[nodiscard]] bool touches_included(const Edit& edit) const;
  void change_included(const ScriptChange& change, bool forwards, PendingData& data) const;
  [[nodiscard]] ScriptReading read(const std::string& text) const;
  [[nodiscard]] DataFileLoader disk() const;
  [[nodiscard]] const Findings& findings() const;
  [[nodiscard]] Findings found_in(ScriptReading reading) const;
  [[nodiscard]] bool reads_files() const;
  [[nodiscard]] Scene& own_scene();
  [[nodiscard]] Scene& scene_for(const Edit* edit);

  std::shared_ptr<Scene> scene_ = std::make_shared<Scene>();  // never null but in one that was moved away
  std::string text_;
  bool text_broken_ = false;
  std::optional<std::string> sound_text_;  // the last that could be read, where it is known and the text is broken
  mutable std::optional<CommandPlaces> commands_;
  mutable std::optional<format_2::ObjectTables> tables_;  // of a text of format 2
  mutable std::optional<std::vector<IncludedText>> included_;
  std::filesystem::path path_;
  std::string text_on_disk_;
  mutable PendingData data_;
  mutable std::optional<Findings> findings_;
  FileReader file_reader_;
  core::Problems of_files_;
  History history_;
  std::optional<LastEdit> last_edit_;
  std::vector<ReplacedExpression> replaced_;
  std::uint64_t revision_ = 0;
};

}  // namespace sarsim::scene

#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "gui/common/session.hpp"
#include "scene/edit/document_data.hpp"
#include "scene/edit/recovery.hpp"
#include "scene/edit/starting_scenes.hpp"

class QWidget;

namespace sarsim::gui {

/// Opens, saves and guards the session's documents: questions before changes are lost, recent files, copies that
/// survive a crash, files that changed on disk. What is opened comes beside what is open; only a new scene in which
/// nothing was done gives way to it. A file that is open already is turned to.
class DocumentKeeper : public QObject {
  Q_OBJECT

 public:
  /// @param window  parent of the questions
  DocumentKeeper(Session& session, QWidget* window);
  ~DocumentKeeper() override;

  /// What is to become of changes.
  enum class Answer { save, discard, cancel };
  /// What is to become of data files.
  enum class DataAnswer { write, leave, cancel };
  /// Asked before unsaved changes are lost, and for file names (empty: cancelled). Dialogs unless replaced.
  std::function<Answer()> ask_unsaved;
  /// Asked when a script is saved whose data files do not say what the scene shows; `leave` saves the script alone.
  std::function<DataAnswer(const std::vector<scene::DataFileWrite>&)> ask_data;
  /// Asked for each document (empty: never saved) that a crash left a copy of; `cancel` puts the question off.
  std::function<Answer(const std::filesystem::path& document)> ask_recovery;
  std::function<QString()> ask_open_name;
  std::function<QString()> ask_save_name;
  /// Asked whether to save under a name with the ending that is usual for the other language: the scene keeps its own.
  std::function<bool(const QString& path)> ask_ending;
  /// Asked when another program has changed the file of the document: whether to read it anew.
  std::function<bool(bool unsaved)> ask_read_again;
  /// Told what failed and why. A dialog unless replaced: where nobody looks at one it would wait for ever.
  std::function<void(const QString& what, const QString& why)> show_failure;

  /// Each returns false where the user cancelled or it failed; failures are told to the user.
  /// @{
  bool make_new();
  bool open();
  bool open_file(const QString& name);
  /// Opens a copy without a file, so that saving it does not change the example.
  bool open_example(const QString& path);
  /// Begins a new document with a scene that the program carries.
  bool begin_with(const scene::StartingScene& starting);
  bool save();
  bool save_as();
  bool save_to(const QString& name);
  /// Closes the document at hand, after asking where it is unsaved.
  bool close();
  /// Saves or discards what is unsaved in the document at hand, or asks; true where it may go.
  bool may_close();
  /// The same for all of them, each in view while it is asked about; true where all may go.
  bool may_close_all();
  /// @}

  /// True where the script, or a data file that it speaks of, is not on disk as the scene is shown.
  [[nodiscard]] bool unsaved() const { return unsaved(session_.at_hand()); }
  [[nodiscard]] bool unsaved(std::size_t index) const;
  /// Writes the copies for recovery now, as is done two seconds after a change; false where there is nothing to keep or
  /// the disk refused.
  bool keep_copies();
  /// Looks whether the file is still what was opened or saved, as is done every two seconds. A version that the user
  /// does not want is not asked about again.
  void look_at_disk();
  /// Paths, the newest first, at most ten that still exist.
  [[nodiscard]] QStringList recent() const;
  /// What a document is called: its file with its folders, the example that it is a copy of, or "New scene".
  [[nodiscard]] QString shown_name() const { return shown_name(session_.at_hand()); }
  [[nodiscard]] QString shown_name(std::size_t index) const;
  /// Where the examples are, or an empty path.
  [[nodiscard]] static std::filesystem::path examples_folder();
  /// Offers copies that a crash left behind, and opens those that the user wants.
  void offer_recovery();
  /// The program ends here: forgets the copies.
  void end();

 signals:
  void recent_changed();  ///< The list of recent files is another one.

 private:
  // The version of a file that was last looked into.
  struct Version {
    std::filesystem::path path;
    std::filesystem::file_time_type time;
    std::uintmax_t bytes = 0;

    friend bool operator==(const Version&, const Version&) = default;
  };
  // What is known of an open document besides itself.
  struct Guard {
    QString example;  // that it is a copy of
    scene::Recovery copy;
    bool copy_is_due = false;
    std::optional<Version> seen;
  };

  void make_questions();
  [[nodiscard]] std::optional<scene::Document> read(const QString& path);
  void open_beside(scene::Document document);
  [[nodiscard]] std::optional<std::size_t> place_of(const std::filesystem::path& path) const;
  [[nodiscard]] Guard& guard(int number);
  void guard_change();
  void read_again();
  void note_recent(const QString& path);
  [[nodiscard]] DataAnswer data_question(const std::vector<scene::DataFileWrite>& files) const;
  [[nodiscard]] static Version version_of(const std::filesystem::path& path);
  void recover(const scene::Recovery::Copy& copy);
  void tell(const QString& what, const QString& why);

  Session& session_;
  QWidget* window_;
  std::map<int, Guard> guards_;  // by the numbers of documents
  QTimer keep_soon_;
  QTimer look_;
  bool asking_ = false;
};

}  // namespace sarsim::gui

#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "gui/common/session.hpp"
#include "scene/edit/document_data.hpp"
#include "scene/edit/recovery.hpp"
#include "scene/edit/starting_scenes.hpp"

class QWidget;

namespace sarsim::gui {

/// Opens, saves and guards the session's document: questions before changes are lost, recent files, copies that survive
/// a crash, files that changed on disk.
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
  /// Saves or discards what is unsaved, or asks; true where the document may go.
  bool may_close();
  /// @}

  /// True where the script, or a data file that it speaks of, is not on disk as the scene is shown.
  [[nodiscard]] bool unsaved() const;
  /// Writes the copy for recovery now, as is done two seconds after a change; false where there is nothing to keep or
  /// the disk refused.
  bool keep_copy();
  /// Looks whether the file is still what was opened or saved, as is done every two seconds. A version that the user
  /// does not want is not asked about again.
  void look_at_disk();
  /// Paths, the newest first, at most ten that still exist.
  [[nodiscard]] QStringList recent() const;
  /// What the document is called: its file, the example that it is a copy of, or "New scene".
  [[nodiscard]] QString shown_name() const;
  /// Where the examples are, or an empty path.
  [[nodiscard]] static std::filesystem::path examples_folder();
  /// Offers copies that a crash left behind; takes the first that the user wants.
  void offer_recovery();
  /// The document ends here: forgets the copy.
  void close();

 signals:
  void recent_changed();  ///< The list of recent files is another one.

 private:
  void note_recent(const QString& path);
  void make_questions();
  [[nodiscard]] DataAnswer data_question(const std::vector<scene::DataFileWrite>& files) const;
  void recover(const scene::Recovery::Copy& copy);
  void tell(const QString& what, const QString& why);

  Session& session_;
  QWidget* window_;
  scene::Recovery recovery_;
  QString example_;  // that the document is a copy of
  QTimer keep_soon_;
  QTimer look_;
  bool asking_ = false;
  // The version of the file that was last looked into.
  struct Version {
    std::filesystem::path path;
    std::filesystem::file_time_type time;
    std::uintmax_t bytes = 0;

    friend bool operator==(const Version&, const Version&) = default;
  };
  [[nodiscard]] static Version version_of(const std::filesystem::path& path);
  std::optional<Version> seen_;
};

}  // namespace sarsim::gui

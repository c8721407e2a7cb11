#pragma once

#include <QTimer>
#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

#include "gui/common/session.hpp"
#include "gui/script/script_coding.hpp"
#include "scene/language/completion.hpp"

class QAction;
class QLabel;
class QListWidget;

namespace sarsim::gui {

class FindBar;
class ScriptText;

/// The script as text, both ways: what is typed becomes the scene after a pause, and what is done to the scene changes
/// only those places of the text that it concerns, so that comments, cursor and scroll position stay. Below stands a
/// list of what is wrong; undo and redo are those of the document.
class ScriptEditor : public QWidget {
  Q_OBJECT

 public:
  explicit ScriptEditor(Session& session, QWidget* parent = nullptr);
  ~ScriptEditor() override;

  /// Gives what was typed to the session now, without waiting for a pause.
  void commit();
  [[nodiscard]] ScriptText& text() { return *text_; }
  /// Puts the cursor where a problem is.
  void jump_to(const core::Place& place);
  /// Takes the keyboard, with the cursor where a problem is, where that is in the script.
  void show_problem(const core::Place& place);
  /// Lists these below those that the session knows, as long as it knows no errors.
  void list_also(core::Problems of_echoes);
  /// The command that runs the script without the workbench: "sarsim run 'ship.scr'"; empty where it was never saved.
  [[nodiscard]] QString command_line() const;
  [[nodiscard]] QAction* find_action() const { return find_; }
  [[nodiscard]] QAction* copy_command_action() const { return copy_command_; }

 protected:
  /// What it missed while it was not seen is put in before it is read or typed into.
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_actions();
  void lay_out();
  void connect_text();
  void take_document();
  void take_session_text();
  void show_document();
  void catch_up();
  [[nodiscard]] bool is_seen() const;
  [[nodiscard]] bool take_last_changes();
  void take_whole_text();
  void note_typing();
  void refresh_problems();
  void show_position();
  void copy_command();
  [[nodiscard]] core::Problems listed_problems() const;
  [[nodiscard]] const scene::language::KnownNames& names();

  Session& session_;
  ScriptText* text_ = nullptr;
  FindBar* find_bar_ = nullptr;
  QListWidget* problems_ = nullptr;
  QLabel* position_ = nullptr;
  QLabel* state_ = nullptr;
  QAction* find_ = nullptr;
  QAction* copy_command_ = nullptr;
  QAction* complete_ = nullptr;
  QTimer pause_;    // since the last key
  QTimer run_end_;  // after which typing is another step of undo
  QTimer problems_soon_;
  ScriptCoding coding_;
  QString shared_;                                    // the text that editor and session had in common last
  bool stale_ = false;                                // the session's text changed while nobody looked
  bool other_document_ = false;                       // and is that of another document
  bool agreed_ = true;                                // nothing was typed since
  std::uint64_t revision_ = 0;                        // of the document then
  bool splicing_ = false;                             // the session's text is being put in
  std::vector<core::Place> places_;                   // of the lines of the list
  core::Problems of_echoes_;                          // what the session does not know
  std::optional<scene::language::KnownNames> names_;  // nothing: to be looked for
};

/// A file name as one word for a shell.
[[nodiscard]] QString shell_word(const QString& name);

}  // namespace sarsim::gui

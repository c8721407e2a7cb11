#pragma once

#include <QObject>

#include <functional>

#include "gui/script/object_lines.hpp"
#include "scene/language/completion.hpp"

class QKeyEvent;
class QPlainTextEdit;

namespace sarsim::gui {

class CompletionList;

/// Completes what is typed into a script of format 2: shows what may stand at the cursor while a word is typed, or when
/// it is asked, and puts in what is chosen with Enter, Tab or the mouse.
class ScriptCompleter : public QObject {
  Q_OBJECT

 public:
  /// What a text can refer to, asked for when it is needed.
  using Names = std::function<const scene::language::KnownNames&()>;

  /// Completes what is typed into a text, which passes its keys on to it.
  explicit ScriptCompleter(QPlainTextEdit* text);

  void set_names(Names names) { names_ = std::move(names); }
  /// Shows all that may stand at the cursor.
  void complete();
  /// Takes the list away.
  void hide();

  /// To be called before the text sees a key; true where the key was for the list.
  [[nodiscard]] bool take_key(const QKeyEvent& event);
  /// To be called when the text has seen a key.
  void follow_key(const QKeyEvent& event);

 private:
  void refresh(bool asked);
  void put_in(int line);

  QPlainTextEdit* text_ = nullptr;
  CompletionList* list_ = nullptr;
  Names names_;
  ObjectLines lines_;
  scene::language::Completions shown_;
  bool typing_ = false;  // a key is being taken
};

}  // namespace sarsim::gui

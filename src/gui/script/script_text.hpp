#pragma once

#include <QPlainTextEdit>
#include <QTimer>

#include <deque>
#include <memory>
#include <vector>

#include "core/report/problem.hpp"
#include "gui/script/script_coding.hpp"

namespace sarsim::gui {

class ScriptCompleter;
class ScriptHighlighter;

/// The text of a script as it is typed: line numbers, colours, the current line marked, problems underlined where they
/// are; tooltips with the words of problems and explanations of what stands there; in format 2 completion. Undo and
/// redo are left to whoever holds the document.
class ScriptText : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit ScriptText(QWidget* parent = nullptr);
  ~ScriptText() override;

  /// The text with '\n' at the ends of lines, character by character as it was put in.
  [[nodiscard]] QString script() const;
  /// Puts another text in its place; of a long one the beginning at once, as in `splice`.
  void set_script(const QString& text);
  /// Puts stretches of text in place of others, in turn; the cursor and what is on screen stay where they are. Of long
  /// stretches the beginning is put in at once, and the rest in pieces between which the window answers; until then the
  /// text takes no keys.
  void splice(const std::vector<DecodedChange>& changes);
  /// Puts in at once what is left.
  void complete();
  /// Whether all is put in.
  [[nodiscard]] bool is_complete() const { return waiting_.empty() && !putting_in_; }

  /// Underlines problems; they move with the text until they are set again.
  void underline(const std::vector<core::Problem>& problems, const ScriptCoding& coding);
  /// The underlined stretches, as begin and end.
  [[nodiscard]] std::vector<std::pair<int, int>> underlined() const;
  /// Words of the problems underlined at a position of the text; empty where there are none.
  [[nodiscard]] QString problem_at(int position) const;
  /// What the word at a position is, as rich text; empty where there is nothing to say.
  [[nodiscard]] QString explanation_at(int position) const;
  /// Completes what is typed.
  [[nodiscard]] ScriptCompleter& completer() { return *completer_; }
  /// Puts the cursor where a problem is, and brings it into sight.
  void jump_to(const core::Place& place, const ScriptCoding& coding);

  /// Makes the text larger (steps above 0) or smaller; 0 steps: as at first.
  void zoom(int steps);

  /// Width of the line numbers, in pixels.
  [[nodiscard]] int margin_width() const;
  /// Paints them; called by the widget that they stand in.
  void paint_margin(QPaintEvent* event);

 signals:
  void undo_wanted();  ///< Ctrl+Z was pressed.
  void redo_wanted();  ///< Ctrl+Y, or Ctrl+Shift+Z.
  void left();         ///< The keyboard goes elsewhere.
  void completed();    ///< All is put in.

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  struct Mark {
    QTextCursor where;
    QString text;
    core::Severity severity = core::Severity::error;
  };

  void put_in_more();
  void place_margin();
  void scroll_margin(const QRect& area, int dy);
  void show_marks();
  void refresh_colours();
  [[nodiscard]] QString tip_at(const QPoint& place) const;
  [[nodiscard]] QTextCursor stretch_of(const core::Place& place, const ScriptCoding& coding) const;

  QWidget* margin_ = nullptr;
  std::unique_ptr<ScriptHighlighter> highlighter_;
  ScriptCompleter* completer_ = nullptr;
  std::vector<Mark> marks_;
  std::deque<DecodedChange> waiting_;  // to be put in, in turn
  bool putting_in_ = false;
  QTimer more_;
  double first_size_pt_ = 0.0;
};

}  // namespace sarsim::gui

#include "gui/script/script_completer.hpp"

#include <QKeyEvent>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTextBlock>

#include <utility>

#include "gui/common/text.hpp"
#include "gui/script/completion_list.hpp"
#include "gui/script/script_highlighter.hpp"

namespace sarsim::gui {

namespace {

bool is_letter(const QKeyEvent& event) {
  const bool is_command = event.modifiers().testAnyFlags(Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  return !event.text().isEmpty() && event.text().front().isPrint() && !is_command;
}

bool is_modifier(int key) {
  return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt || key == Qt::Key_Meta ||
         key == Qt::Key_AltGr;
}

}  // namespace

ScriptCompleter::ScriptCompleter(QPlainTextEdit* text) : QObject(text), text_(text), list_(new CompletionList(text)) {
  const auto hide_unless_typing = [this] {
    if (!typing_) hide();
  };
  connect(text, &QPlainTextEdit::cursorPositionChanged, this, hide_unless_typing);
  connect(text->verticalScrollBar(), &QScrollBar::valueChanged, this, hide_unless_typing);
  connect(list_, &QTreeWidget::itemClicked, this,
          [this](QTreeWidgetItem* item) { put_in(list_->indexOfTopLevelItem(item)); });
}

void ScriptCompleter::complete() { refresh(true); }

void ScriptCompleter::hide() { list_->hide(); }

bool ScriptCompleter::take_key(const QKeyEvent& event) {
  typing_ = true;
  if (!list_->isVisible()) return false;
  switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Tab:
      put_in(list_->chosen());
      typing_ = false;
      return true;
    case Qt::Key_Escape:
      hide();
      typing_ = false;
      return true;
    default: break;
  }
  const bool taken = list_->move_by(event.key());
  typing_ = !taken;
  return taken;
}

void ScriptCompleter::follow_key(const QKeyEvent& event) {
  typing_ = false;
  if (is_modifier(event.key())) return;
  const bool shortens = event.key() == Qt::Key_Backspace && list_->isVisible();
  if (is_letter(event) || shortens)
    refresh(false);
  else
    hide();
}

void ScriptCompleter::refresh(bool asked) {
  const QTextCursor cursor = text_->textCursor();
  const bool may_complete = is_format_2(*text_->document()) && !text_->isReadOnly() && !cursor.hasSelection();
  auto lines = may_complete ? object_lines(*text_->document(), cursor.position()) : std::nullopt;
  if (!lines) return hide();
  lines_ = std::move(*lines);
  static const scene::language::KnownNames no_names;
  shown_ = scene::language::completions_at(lines_.text, lines_.offset, names_ ? names_() : no_names);
  if (shown_.offered.empty() || !(asked || shown_.unasked)) return hide();
  QTextCursor word = cursor;
  word.setPosition(std::min(lines_.position_of(shown_.replaced.begin), cursor.position()));
  const QRect beside = text_->cursorRect(word);
  list_->offer(shown_.offered, {text_->viewport()->mapToGlobal(beside.topLeft()), beside.size()});
}

void ScriptCompleter::put_in(int line) {
  hide();
  if (line < 0 || line >= static_cast<int>(shown_.offered.size())) return;
  const QString text = text_of(shown_.offered[static_cast<std::size_t>(line)].inserted);
  QTextCursor edit = text_->textCursor();
  edit.setPosition(lines_.position_of(shown_.replaced.begin));
  edit.setPosition(lines_.position_of(shown_.replaced.end), QTextCursor::KeepAnchor);
  typing_ = true;
  edit.insertText(text);
  text_->setTextCursor(edit);
  typing_ = false;
  if (text.endsWith(u' ')) refresh(false);  // What the key may be set to.
}

}  // namespace sarsim::gui

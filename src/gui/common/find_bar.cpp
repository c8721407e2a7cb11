#include "gui/common/find_bar.hpp"

#include <QCheckBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextBlock>
#include <QToolButton>

#include "gui/common/flow_layout.hpp"

namespace sarsim::gui {

namespace {

constexpr int shortest_line_letters = 24;

}  // namespace

FindBar::FindBar(QPlainTextEdit* text, QWidget* parent)
    : QWidget(parent),
      text_(text),
      word_(new QLineEdit(this)),
      case_(new QCheckBox(tr("Match &case"), this)),
      result_(new QLabel(this)) {
  setObjectName("find_bar");
  setAccessibleName(tr("Find"));
  word_->setObjectName("find_text");
  word_->setAccessibleName(tr("Text to find"));
  word_->setPlaceholderText(tr("Find"));
  word_->setClearButtonEnabled(true);
  case_->setObjectName("find_case");
  result_->setObjectName("find_result");
  const auto button = [this](const char* name, const QString& label, const QString& tip) {
    auto* made = new QToolButton(this);
    made->setObjectName(name);
    made->setText(label);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    return made;
  };
  QToolButton* previous = button("find_previous", tr("Previous"), tr("Find previous (Shift+F3)"));
  QToolButton* next = button("find_next", tr("Next"), tr("Find next (F3)"));
  QToolButton* close = button("find_close", tr("Close"), tr("Close the search (Esc)"));
  auto* layout = new FlowLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  word_->setMinimumWidth(word_->fontMetrics().averageCharWidth() * shortest_line_letters);
  layout->addWidget(word_);
  for (QWidget* widget : {static_cast<QWidget*>(previous), static_cast<QWidget*>(next), static_cast<QWidget*>(case_),
                          static_cast<QWidget*>(result_), static_cast<QWidget*>(close)})
    layout->addWidget(widget);
  connect(word_, &QLineEdit::textEdited, this, &FindBar::find_as_typed);
  connect(word_, &QLineEdit::returnPressed, this, &FindBar::find_next);
  connect(previous, &QToolButton::clicked, this, &FindBar::find_previous);
  connect(next, &QToolButton::clicked, this, &FindBar::find_next);
  connect(close, &QToolButton::clicked, this, &FindBar::close_bar);
  setVisible(false);
}

void FindBar::open() {
  const QString selected = text_->textCursor().selectedText();
  if (!selected.isEmpty() && !selected.contains(QChar::ParagraphSeparator)) word_->setText(selected);
  setVisible(true);
  word_->setFocus(Qt::ShortcutFocusReason);
  word_->selectAll();
}

void FindBar::close_bar() {
  setVisible(false);
  text_->setFocus();
}

void FindBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return close_bar();
  QWidget::keyPressEvent(event);
}

// Looks again from where the last find began, so that more letters stay at the same place.
void FindBar::find_as_typed() {
  QTextCursor cursor = text_->textCursor();
  cursor.setPosition(cursor.selectionStart());
  text_->setTextCursor(cursor);
  find(false);
}

void FindBar::find(bool backwards) {
  const QString wanted = word_->text();
  result_->clear();
  if (wanted.isEmpty()) return;
  QTextDocument::FindFlags flags;
  if (backwards) flags |= QTextDocument::FindBackward;
  if (case_->isChecked()) flags |= QTextDocument::FindCaseSensitively;
  QTextCursor found = text_->document()->find(wanted, text_->textCursor(), flags);
  if (found.isNull()) {
    QTextCursor end(text_->document());
    end.movePosition(backwards ? QTextCursor::End : QTextCursor::Start);
    found = text_->document()->find(wanted, end, flags);
    if (!found.isNull()) result_->setText(backwards ? tr("From the end") : tr("From the beginning"));
  }
  if (found.isNull())
    result_->setText(tr("Not found"));
  else
    text_->setTextCursor(found);
}

}  // namespace sarsim::gui

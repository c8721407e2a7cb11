#include "gui/script/completion_list.hpp"

#include <QHeaderView>
#include <QScreen>
#include <QScrollBar>

#include <algorithm>

#include "gui/common/text.hpp"

namespace sarsim::gui {

namespace {

constexpr int max_lines = 10;
constexpr int widest_em = 80;
constexpr int widest_word_em = 24;

}  // namespace

CompletionList::CompletionList(QWidget* text) : QTreeWidget(text) {
  setWindowFlags(Qt::ToolTip);
  setAttribute(Qt::WA_ShowWithoutActivating);
  setFocusPolicy(Qt::NoFocus);
  setFocusProxy(text);
  setObjectName("script_completions");
  setAccessibleName(tr("Completions"));
  setColumnCount(2);
  header()->hide();
  header()->setStretchLastSection(true);
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTextElideMode(Qt::ElideRight);
  setFrameShape(QFrame::StyledPanel);
}

void CompletionList::offer(const std::vector<scene::language::Completion>& offered, const QRect& beside) {
  clear();
  setFont(parentWidget()->font());
  const int em = fontMetrics().horizontalAdvance(u'm');
  const int height = fontMetrics().height() * 5 / 4;
  for (const scene::language::Completion& one : offered) {
    auto* line = new QTreeWidgetItem(this, {text_of(one.shown), text_of(one.meaning)});
    line->setSizeHint(0, {fontMetrics().horizontalAdvance(line->text(0)) + em, height});
    line->setForeground(1, palette().color(QPalette::PlaceholderText));
  }
  setCurrentItem(topLevelItem(0));
  place(beside);
  show();
}

bool CompletionList::move_by(int key) {
  const int count = topLevelItemCount();
  int line = chosen();
  switch (key) {
    case Qt::Key_Down: line = (line + 1) % count; break;
    case Qt::Key_Up: line = (line + count - 1) % count; break;
    case Qt::Key_PageDown: line = std::min(line + max_lines, count - 1); break;
    case Qt::Key_PageUp: line = std::max(line - max_lines, 0); break;
    default: return false;
  }
  setCurrentItem(topLevelItem(line));
  return true;
}

int CompletionList::chosen() const { return indexOfTopLevelItem(currentItem()); }

// Below what is typed, or above where the screen ends.
void CompletionList::place(const QRect& beside) {
  const int em = fontMetrics().horizontalAdvance(u'm');
  const int lines = std::min(topLevelItemCount(), max_lines);
  const int bar = topLevelItemCount() > max_lines ? verticalScrollBar()->sizeHint().width() : 0;
  setColumnWidth(0, std::min(sizeHintForColumn(0) + em, widest_word_em * em));
  const int meaning = sizeHintForColumn(1) + em;
  const QSize size(std::min(columnWidth(0) + meaning + bar, widest_em * em) + 2 * frameWidth(),
                   lines * sizeHintForRow(0) + 2 * frameWidth());
  const QRect room = parentWidget()->screen()->availableGeometry();
  const bool fits_below = beside.bottom() + size.height() <= room.bottom();
  const int top = fits_below ? beside.bottom() + 1 : std::max(beside.top() - size.height(), room.top());
  const int left = std::clamp(beside.left(), room.left(), std::max(room.left(), room.right() - size.width()));
  setGeometry(QRect(QPoint(left, top), size));
}

}  // namespace sarsim::gui

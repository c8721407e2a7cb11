#include "gui/common/reserved_label.hpp"

#include <QEvent>

namespace sarsim::gui {

ReservedLabel::ReservedLabel(int lines, QWidget* parent) : QLabel(parent), lines_(lines) {
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  setAlignment(Qt::AlignLeft | Qt::AlignTop);
  reserve();
}

void ReservedLabel::say(const QString& words) {
  if (words == text()) return;
  setText(words);
  setToolTip(words);
}

void ReservedLabel::reserve() { setFixedHeight(lines_ * fontMetrics().lineSpacing() + 2); }

void ReservedLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange) reserve();
}

}  // namespace sarsim::gui

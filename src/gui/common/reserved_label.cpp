#include "gui/common/reserved_label.hpp"

#include <QEvent>
#include <QPainter>

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
  is_cut_.reset();
}

// Whole lines, as high as a label of so many is.
void ReservedLabel::reserve() {
  QLabel sample;
  sample.setFont(font());
  sample.setText(QStringList(lines_, QStringLiteral("X")).join('\n'));
  setFixedHeight(sample.sizeHint().height());
}

// Words that go on are marked as such. To know that takes longer than to draw them, so it is kept.
void ReservedLabel::paintEvent(QPaintEvent* event) {
  QLabel::paintEvent(event);
  if (!is_cut_) is_cut_ = !text().isEmpty() && heightForWidth(width()) > height();
  if (!*is_cut_) return;
  QPainter painter(this);
  const QString more = QStringLiteral(" …");
  const int line = fontMetrics().height();
  const QRect corner(width() - fontMetrics().horizontalAdvance(more), height() - line, width(), line);
  painter.fillRect(corner, palette().color(backgroundRole()));
  painter.setPen(palette().color(foregroundRole()));
  painter.drawText(corner, Qt::AlignLeft | Qt::AlignVCenter, more);
}

void ReservedLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  reserve();
  is_cut_.reset();
}

void ReservedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  is_cut_.reset();
}

}  // namespace sarsim::gui

#include "gui/scene/geometry_view.hpp"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>
#include <QTableView>
#include <QWheelEvent>

#include <algorithm>

namespace sarsim::gui {

ModelPage::ModelPage(QAbstractItemModel* source, QObject* parent) : QAbstractTableModel(parent), source_(source) {
  connect(source_, &QAbstractItemModel::modelAboutToBeReset, this, [this] { beginResetModel(); });
  connect(source_, &QAbstractItemModel::modelReset, this, [this] {
    offset_ = 0;
    endResetModel();
  });
  connect(source_, &QAbstractItemModel::dataChanged, this, &ModelPage::pass_on_change);
}

void ModelPage::set_page(int rows) {
  rows = std::max(1, rows);
  if (rows == page_) return;
  const int before = rowCount();
  const int after = std::min(rows, source_->rowCount() - offset_);
  if (after > before) beginInsertRows({}, before, after - 1);
  if (after < before) beginRemoveRows({}, std::max(0, after), before - 1);
  page_ = rows;
  if (after > before) endInsertRows();
  if (after < before) endRemoveRows();
}

void ModelPage::set_offset(int offset) {
  offset = std::clamp(offset, 0, std::max(0, source_->rowCount() - page_));
  if (offset == offset_) return;
  offset_ = offset;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, std::max(0, columnCount() - 1)));
}

int ModelPage::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : std::clamp(source_->rowCount() - offset_, 0, page_);
}

int ModelPage::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : source_->columnCount(); }

QVariant ModelPage::data(const QModelIndex& index, int role) const {
  return index.isValid() ? source_->data(source_->index(offset_ + index.row(), index.column()), role) : QVariant();
}

QVariant ModelPage::headerData(int section, Qt::Orientation orientation, int role) const {
  return source_->headerData(section, orientation, role);
}

void ModelPage::pass_on_change(const QModelIndex& first, const QModelIndex& last) {
  const int top = std::max(0, first.row() - offset_);
  const int bottom = std::min(rowCount() - 1, last.row() - offset_);
  if (top <= bottom) emit dataChanged(index(top, first.column()), index(bottom, last.column()));
}

GeometryView::GeometryView(QAbstractItemModel* model, QWidget* parent)
    : QWidget(parent),
      source_(model),
      page_(new ModelPage(model, this)),
      table_(new QTableView(this)),
      bar_(new QScrollBar(Qt::Vertical, this)) {
  table_->setObjectName("geometry_table");
  table_->setAccessibleName(tr("Geometry of each pulse"));
  table_->setModel(page_);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->setVisible(false);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  table_->installEventFilter(this);
  table_->viewport()->installEventFilter(this);
  bar_->setObjectName("geometry_scroll");
  bar_->setAccessibleName(tr("Pulses"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(table_, 1);
  layout->addWidget(bar_);
  connect(bar_, &QScrollBar::valueChanged, this, [this](int row) { page_->set_offset(row); });
  connect(source_, &QAbstractItemModel::modelReset, this, &GeometryView::take_columns);
  take_columns();
}

void GeometryView::take_columns() {
  bar_->setValue(0);
  fit();
  // Room for "-1.23456789012e-10" and for headings.
  const int widest = fontMetrics().horizontalAdvance(QStringLiteral("-1.23456789012e-10 "));
  for (int column = 0; column < source_->columnCount(); ++column)
    table_->setColumnWidth(column, std::max(widest, table_->horizontalHeader()->sectionSizeHint(column)));
}

void GeometryView::fit() {
  const int height = std::max(1, table_->verticalHeader()->defaultSectionSize());
  page_->set_page(std::max(1, table_->viewport()->height() / height));
  bar_->setPageStep(page_->page());
  bar_->setRange(0, std::max(0, source_->rowCount() - page_->page()));
}

void GeometryView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void GeometryView::scroll_to(int row) { bar_->setValue(std::clamp(row, 0, bar_->maximum())); }

// Makes a row of the whole table the current one, scrolling as little as that takes.
void GeometryView::move_to(int row) {
  row = std::clamp(row, 0, std::max(0, source_->rowCount() - 1));
  if (row < page_->offset()) scroll_to(row);
  if (row >= page_->offset() + page_->page()) scroll_to(row - page_->page() + 1);
  const int column = std::max(0, table_->currentIndex().column());
  table_->setCurrentIndex(page_->index(row - page_->offset(), column));
}

bool GeometryView::move_by_key(int key, bool control) {
  const int now = page_->offset() + std::max(0, table_->currentIndex().row());
  switch (key) {
    case Qt::Key_Up: move_to(now - 1); return true;
    case Qt::Key_Down: move_to(now == source_->rowCount() - 1 ? now : now + 1); return true;
    case Qt::Key_PageUp: move_to(now - page_->page()); return true;
    case Qt::Key_PageDown: move_to(std::min(source_->rowCount() - 1 - now, page_->page()) + now); return true;
    case Qt::Key_Home:
      if (control) move_to(0);
      return control;
    case Qt::Key_End:
      if (control) move_to(source_->rowCount() - 1);
      return control;
    default: return false;
  }
}

bool GeometryView::eventFilter(QObject* object, QEvent* event) {
  if (object == table_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    return move_by_key(key->key(), key->modifiers().testFlag(Qt::ControlModifier));
  }
  if (object == table_->viewport() && event->type() == QEvent::Resize) fit();
  if (object == table_->viewport() && event->type() == QEvent::Wheel) {
    const auto* wheel = static_cast<QWheelEvent*>(event);
    constexpr int step = 120;  // eighths of a degree, Qt's usual wheel
    if (wheel->angleDelta().y() == 0) return false;
    bar_->setValue(bar_->value() - 3 * wheel->angleDelta().y() / step);
    return true;
  }
  return QWidget::eventFilter(object, event);
}

}  // namespace sarsim::gui

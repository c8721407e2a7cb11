#include "gui/objects/function_table.hpp"

#include <QAction>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <span>

namespace sarsim::gui {

namespace {

constexpr int max_samples = 10'000;

QString heading(const std::string& name, const AxisUnit& axis) {
  const QString text = QString::fromStdString(name);
  return axis.unit.empty() ? text : text + QStringLiteral(" (%1)").arg(QString::fromStdString(axis.unit));
}

// A table in which Tab goes from one number to the next that can be typed.
class NumbersView : public QTableView {
 public:
  using QTableView::QTableView;

 protected:
  QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override {
    QModelIndex next = QTableView::moveCursor(action, modifiers);
    const bool by_tab = action == MoveNext || action == MovePrevious;
    if (!by_tab || !next.isValid() || next.flags().testFlag(Qt::ItemIsEditable)) return next;
    const int step = action == MoveNext ? 1 : -1;
    return model()->index(next.row() + (next.column() + step < 0 ? -1 : 0), 1);
  }
};

// Rows that differ: [first, was] of the old ones and [first, last] of the new. Where the points in between are the same
// but for one that went to another place, `from` and `to` are its rows; else they are equal.
struct RowChange {
  int first = 0;
  int was = -1;
  int last = -1;
  int from = 0;
  int to = 0;
};

RowChange difference(const std::vector<core::Knot>& before, const std::vector<core::Knot>& after) {
  const auto least = static_cast<std::ptrdiff_t>(std::min(before.size(), after.size()));
  const std::ptrdiff_t same =
      std::mismatch(before.begin(), before.begin() + least, after.begin()).first - before.begin();
  const std::ptrdiff_t behind =
      std::mismatch(before.rbegin(), before.rbegin() + (least - same), after.rbegin()).first - before.rbegin();
  RowChange change{static_cast<int>(same), static_cast<int>(std::ssize(before) - behind) - 1,
                   static_cast<int>(std::ssize(after) - behind) - 1};
  if (change.was != change.last || change.first >= change.last) return change;
  const std::size_t first = static_cast<std::size_t>(change.first);
  const std::size_t last = static_cast<std::size_t>(change.last);
  const auto part = [](const std::vector<core::Knot>& knots, std::size_t begin, std::size_t end) {
    return std::span(knots).subspan(begin, end - begin);
  };
  if (std::ranges::equal(part(before, first + 1, last + 1), part(after, first, last)))
    change.from = change.first, change.to = change.last;
  else if (std::ranges::equal(part(before, first, last), part(after, first + 1, last + 1)))
    change.from = change.last, change.to = change.first;
  return change;
}

}  // namespace

AxisUnit axis_unit(const std::string& unit) {
  if (unit == "Hz") return {scene::Quantity::frequency, "GHz"};
  for (const scene::Quantity quantity : {scene::Quantity::length, scene::Quantity::time, scene::Quantity::angle,
                                         scene::Quantity::ratio_db, scene::Quantity::voltage, scene::Quantity::power})
    if (scene::units_of(quantity).front() == unit) return {quantity, unit};
  return {scene::Quantity::number, unit};
}

QString axis_text(double value, const AxisUnit& axis) {
  if (!std::isfinite(value)) return QString::number(value);
  const std::string text = axis.quantity == scene::Quantity::number
                               ? scene::quantity_text(value, scene::Quantity::number)
                               : scene::quantity_text(value, axis.quantity, axis.unit);
  return QString::fromStdString(text.substr(0, text.find(' ')));
}

FunctionTableModel::FunctionTableModel(QObject* parent) : QAbstractTableModel(parent) {}

void FunctionTableModel::show(const scene::FunctionInfo& info, std::size_t part,
                              const core::SampledFunction& function) {
  const QString names[] = {names_[0], names_[1]};
  per_pulse_ = info.per_pulse;
  axes_[0] = per_pulse_ ? AxisUnit{} : axis_unit(info.x_unit);
  axes_[1] = axis_unit(info.parts[part].y_unit);
  names_[0] = heading(info.x_name, axes_[0]);
  names_[1] = heading(info.parts[part].name, axes_[1]);
  take(function.knots);
  if (!std::ranges::equal(names, names_)) emit headerDataChanged(Qt::Horizontal, 0, 1);
}

// Says what became of the rows, so that a cell that is current or being edited stays with its point.
void FunctionTableModel::take(const std::vector<core::Knot>& knots) {
  const RowChange change = difference(knots_, knots);
  const int first = change.first;
  const int last = change.last;
  const int was = change.was;
  if (was > last) {
    beginRemoveRows({}, last + 1, was);
    knots_ = knots;
    endRemoveRows();
  } else if (was < last) {
    beginInsertRows({}, was + 1, last);
    knots_ = knots;
    endInsertRows();
  } else if (change.from != change.to) {
    beginMoveRows({}, change.from, change.from, {}, change.to > change.from ? change.to + 1 : change.to);
    knots_ = knots;
    endMoveRows();
  }
  knots_ = knots;
  if (first <= last) emit dataChanged(index(first, 0), index(last, 1));
}

void FunctionTableModel::show_knot(std::size_t row, core::Knot knot) {
  if (row >= knots_.size()) return;
  knots_[row] = knot;
  emit dataChanged(index(static_cast<int>(row), 0), index(static_cast<int>(row), 1));
}

int FunctionTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(knots_.size());
}

int FunctionTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 2; }

QVariant FunctionTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  const core::Knot& knot = knots_[static_cast<std::size_t>(index.row())];
  if (index.column() == 0 && per_pulse_) return index.row();
  return axis_text(index.column() == 0 ? knot.x : knot.y, axes_[index.column()]);
}

bool FunctionTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::EditRole) return false;
  const QString text = value.toString();
  if (text == data(index, Qt::EditRole).toString()) return true;
  const AxisUnit& axis = axes_[index.column()];
  const std::string bare = axis.quantity == scene::Quantity::number ? std::string() : axis.unit;
  const scene::QuantityReading reading = scene::read_quantity(text.toStdString(), axis.quantity, bare);
  if (!reading.value) {
    emit refused(QString::fromStdString(reading.failure));
    return false;
  }
  const auto row = static_cast<std::size_t>(index.row());
  core::Knot knot = knots_[row];
  (index.column() == 0 ? knot.x : knot.y) = *reading.value;
  emit entered(row, knot);
  return true;
}

Qt::ItemFlags FunctionTableModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
  return index.column() == 0 && per_pulse_ ? flags : flags | Qt::ItemIsEditable;
}

QVariant FunctionTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section + 1;
  return section >= 0 && section < 2 ? names_[section] : QVariant();
}

FunctionTable::FunctionTable(QWidget* parent)
    : QWidget(parent), model_(new FunctionTableModel(this)), view_(new NumbersView(this)), count_(new QSpinBox(this)) {
  view_->setObjectName("function_table");
  view_->setAccessibleName(tr("Samples of the function"));
  view_->setModel(model_);
  view_->setSelectionBehavior(QAbstractItemView::SelectItems);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setTabKeyNavigation(false);
  view_->setToolTip(tr("Any unit may be typed, such as 5 ms or 2 km; a bare number is in the unit of its column"));
  view_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  const int letter = fontMetrics().height();
  view_->verticalHeader()->setDefaultSectionSize(letter * 3 / 2);
  view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  view_->setMinimumHeight(letter * 9);
  count_->setObjectName("function_count");
  count_->setAccessibleName(tr("Number of samples"));
  count_->setRange(1, max_samples);
  count_->setKeyboardTracking(false);
  auto* insert = new QPushButton(tr("&Insert Sample"), this);
  insert->setObjectName("function_insert");
  insert->setToolTip(tr("Puts a sample halfway between this one and the next (Ins)"));
  delete_ = new QPushButton(tr("&Delete Sample"), this);
  delete_->setObjectName("function_delete");
  delete_->setToolTip(tr("Removes this sample; the last one stays (Del)"));

  auto* form = new QFormLayout;
  auto* label = new QLabel(tr("&Number of samples"), this);
  label->setBuddy(count_);
  form->addRow(label, count_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(insert);
  buttons->addWidget(delete_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(form);
  layout->addWidget(view_, 1);
  layout->addLayout(buttons);

  const auto key = [this](QKeySequence keys, auto signal) {
    auto* action = new QAction(view_);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    view_->addAction(action);
    connect(action, &QAction::triggered, this, signal);
  };
  key(Qt::Key_Insert, &FunctionTable::insert_wanted);
  key(Qt::Key_Delete, &FunctionTable::delete_wanted);
  connect(model_, &FunctionTableModel::entered, this, &FunctionTable::entered);
  connect(model_, &FunctionTableModel::refused, this, &FunctionTable::refused);
  connect(insert, &QPushButton::clicked, this, &FunctionTable::insert_wanted);
  connect(delete_, &QPushButton::clicked, this, &FunctionTable::delete_wanted);
  connect(count_, &QSpinBox::valueChanged, this, &FunctionTable::count_wanted);
  connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, &FunctionTable::current_changed);
}

void FunctionTable::show_function(const scene::FunctionInfo& info, std::size_t part,
                                  const core::SampledFunction& function) {
  model_->show(info, part, function);
  const QSignalBlocker quiet(count_);
  const int count = static_cast<int>(function.knots.size());
  count_->setMaximum(std::max(max_samples, count));
  count_->setValue(count);
  delete_->setEnabled(count > 1);
  if (count > 0 && !view_->currentIndex().isValid()) view_->setCurrentIndex(model_->index(0, 1));
}

void FunctionTable::set_current(std::size_t row) {
  const QModelIndex now = view_->currentIndex();
  view_->setCurrentIndex(model_->index(static_cast<int>(row), now.isValid() ? now.column() : 1));
}

std::optional<std::size_t> FunctionTable::current() const {
  const QModelIndex now = view_->currentIndex();
  return now.isValid() ? std::optional(static_cast<std::size_t>(now.row())) : std::nullopt;
}

}  // namespace sarsim::gui

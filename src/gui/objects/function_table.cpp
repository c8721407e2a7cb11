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

namespace sarsim::gui {

namespace {

constexpr int most_samples = 10'000;

QString heading(const std::string& name, const AxisUnit& axis) {
  const QString text = QString::fromStdString(name);
  return axis.unit.empty() ? text : text + QStringLiteral(" (%1)").arg(QString::fromStdString(axis.unit));
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
  beginResetModel();
  function_ = function;
  per_pulse_ = info.per_pulse;
  axes_[0] = per_pulse_ ? AxisUnit{} : axis_unit(info.x_unit);
  axes_[1] = axis_unit(info.parts[part].y_unit);
  names_[0] = heading(info.x_name, axes_[0]);
  names_[1] = heading(info.parts[part].name, axes_[1]);
  endResetModel();
}

void FunctionTableModel::show_knot(std::size_t row, core::Knot knot) {
  if (row >= function_.knots.size()) return;
  function_.knots[row] = knot;
  emit dataChanged(index(static_cast<int>(row), 0), index(static_cast<int>(row), 1));
}

int FunctionTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(function_.knots.size());
}

int FunctionTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 2; }

QVariant FunctionTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  const core::Knot& knot = function_.knots[static_cast<std::size_t>(index.row())];
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
  core::Knot knot = function_.knots[row];
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
    : QWidget(parent), model_(new FunctionTableModel(this)), view_(new QTableView(this)), count_(new QSpinBox(this)) {
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
  count_->setRange(1, most_samples);
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
  const QModelIndex before = view_->currentIndex();
  model_->show(info, part, function);
  const QSignalBlocker quiet(count_);
  const int count = static_cast<int>(function.knots.size());
  count_->setMaximum(std::max(most_samples, count));
  count_->setValue(count);
  delete_->setEnabled(count > 1);
  if (count > 0)
    view_->setCurrentIndex(
        model_->index(std::clamp(before.row(), 0, count - 1), before.isValid() ? before.column() : 1));
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

#include "gui/objects/list_model.hpp"

#include "gui/common/cell_delegate.hpp"

namespace sarsim::gui {

namespace {

// Of a vector the axis alone, so that a narrow table shows all of it.
QString column_heading(const scene::Field& field) {
  const QString label = QString::fromStdString(field.label);
  return field.spec->type == scene::FieldType::vector ? label.left(1) : label;
}

}  // namespace

ListModel::ListModel(const scene::Field& list, QObject* parent) : QAbstractTableModel(parent), list_(list) {}

void ListModel::show(const std::optional<scene::AnyObject>& object) {
  const int rows = object ? static_cast<int>(scene::entry_count(*object, list_)) : 0;
  if (rows == rows_) {
    object_ = object;
    if (rows > 0) emit dataChanged(index(0, 0), index(rows - 1, columnCount() - 1));
    return;
  }
  beginResetModel();
  object_ = object;
  rows_ = rows;
  endResetModel();
}

void ListModel::drop_typing() {
  beginResetModel();
  endResetModel();
}

std::optional<std::string> ListModel::text_at(int row, int column) const {
  if (!object_ || row < 0 || row >= rows_) return std::nullopt;
  return scene::entry_text(*object_, list_, static_cast<std::size_t>(row), field_at(column).id);
}

bool ListModel::means_something(int column) const {
  for (int row = 0; row < rows_; ++row)
    if (text_at(row, column)) return true;
  return false;
}

const scene::Field& ListModel::field_at(int column) const {
  return scene::entry_fields(list_).at(static_cast<std::size_t>(column));
}

int ListModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : rows_; }

int ListModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(scene::entry_fields(list_).size());
}

QVariant ListModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
  const scene::Field& field = field_at(section);
  if (role == Qt::DisplayRole) return column_heading(field);
  if (role == Qt::ToolTipRole) return "<p>" + QString::fromStdString(field.tooltip).toHtmlEscaped() + "</p>";
  return {};
}

QVariant ListModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const scene::Field& field = field_at(index.column());
  if (role == choices_role) {
    QStringList choices;
    for (const std::string& choice : field.choices) choices += QString::fromStdString(choice);
    return choices;
  }
  if (role == Qt::TextAlignmentRole) {
    const bool number = field.kind == scene::FieldKind::quantity;
    return QVariant::fromValue(Qt::Alignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
  }
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  if (const auto text = text_at(index.row(), index.column())) return QString::fromStdString(*text);
  return role == Qt::DisplayRole ? QStringLiteral("-") : QString();
}

Qt::ItemFlags ListModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
  return text_at(index.row(), index.column()) ? flags | Qt::ItemIsEditable : flags;
}

bool ListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid()) return false;
  if (value.toString() != data(index, Qt::EditRole).toString()) emit typed(index, value.toString());
  return true;
}

}  // namespace sarsim::gui

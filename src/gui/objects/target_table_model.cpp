#include "gui/objects/target_table_model.hpp"

#include <QApplication>
#include <QStyle>

#include <algorithm>
#include <compare>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "gui/common/cell_delegate.hpp"
#include "gui/common/problem_line.hpp"
#include "scene/edit/edit.hpp"
#include "scene/edit/typed_fields.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::gui {

namespace {

// The unit of a column as its cells take it: "m", "m2"; empty for pure numbers and texts.
std::string_view unit_of_column(const scene::Field& field) {
  if (field.kind != scene::FieldKind::quantity) return {};
  const std::vector<std::string_view> units = scene::units_of(field.quantity);
  return units.empty() ? std::string_view() : units.front();
}

QString heading_of(const scene::Field& field) {
  const std::string_view unit = unit_of_column(field);
  const QString label = QString::fromStdString(field.label);
  if (unit.empty()) return label;
  QString shown = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
  if (shown.endsWith('2')) shown.back() = QChar(0xB2);
  return QStringLiteral("%1 [%2]").arg(label, shown);
}

// "1.359 km" in the unit of its column without it: "1359".
std::string cell_text(const scene::Field& field, const scene::AnyObject& target) {
  std::string text = scene::field_text(target, field.id);
  const std::string_view unit = unit_of_column(field);
  if (unit.empty() || text.ends_with(' ' + std::string(unit)))
    return text.substr(0, text.size() - (unit.empty() ? 0 : unit.size() + 1));
  const scene::QuantityReading reading = scene::read_quantity(text, field.quantity);
  if (!reading.value) return text;
  text = scene::quantity_text(*reading.value, field.quantity, unit);
  return text.substr(0, text.size() - unit.size() - 1);
}

// What a target is put in order by: its number, or where there is none, its text. What means nothing comes last.
struct SortKey {
  double number = std::numeric_limits<double>::infinity();
  std::string text = {};
  friend auto operator<=>(const SortKey&, const SortKey&) = default;
};

SortKey sort_key(const scene::Field& field, const scene::AnyObject& target) {
  if (!scene::field_applies(target, field.id)) return {};
  std::string text = scene::field_text(target, field.id);
  if (field.kind != scene::FieldKind::quantity) return {0.0, std::move(text)};
  return {scene::read_quantity(text, field.quantity).value.value_or(std::numeric_limits<double>::infinity()), {}};
}

// Plain values need no names; those of [let] are only known once the text has been read.
std::string set_cell(const scene::Document& document, scene::AnyObject& target, scene::ObjectId id,
                     const scene::Field& field, const std::string& text, scene::Edit& edit) {
  if (!scene::field_applies(target, field.id))
    return "the " + field.label + " means nothing here; choose another reflectivity or gain first";
  std::string why = scene::set_field(target, field.id, text);
  if (why.empty() || field.kind != scene::FieldKind::quantity) return why;
  const scene::LetNames* const names = document.let_names();
  if (names == nullptr) return why;
  why = scene::set_field(target, field.id, text, names);
  if (!why.empty()) return why;
  edit.typed.push_back({id, &field, scene::text_as_typed(field, text, *names)});
  return {};
}

// What is put into a cell.
struct CellText {
  std::size_t target;
  const scene::Field* field;  // of `fields_of`
  std::string text;
};

// Puts texts into cells, those of a target one after the other; else says why not.
std::string fill_cells(const scene::Document& document, const std::vector<CellText>& cells, scene::Edit& edit) {
  for (auto at = cells.begin(); at != cells.end();) {
    const scene::ObjectId id{scene::ObjectKind::target, at->target};
    const scene::Target& before = document.scene().targets.at(id.index);
    scene::AnyObject target = before;
    for (; at != cells.end() && at->target == id.index; ++at) {
      const std::string why = set_cell(document, target, id, *at->field, at->text, edit);
      if (!why.empty()) return cells.size() == 1 ? why : fmt::format("target {}: {}", id.index + 1, why);
    }
    edit.changes.push_back({id, before, std::get<scene::Target>(std::move(target))});
  }
  edit.label = edit.changes.size() == 1 ? "Change target" : fmt::format("Change {} targets", edit.changes.size());
  return {};
}

}  // namespace

TargetTableModel::TargetTableModel(Session& session, QObject* parent) : QAbstractTableModel(parent), session_(session) {
  for (const scene::Field& field : scene::fields_of(scene::ObjectKind::target))
    if (field.kind != scene::FieldKind::function) columns_.push_back(&field);
  std::ranges::stable_partition(columns_, [](const scene::Field* field) { return !field->rare; });
  take_rows(wanted_rows());
  read_problems();
  connect(&session_, &Session::scene_changed, this, &TargetTableModel::follow);
  connect(&session_, &Session::problems_changed, this, &TargetTableModel::refresh);
}

void TargetTableModel::set_platform(const std::optional<std::string>& platform) {
  if (platform == platform_) return;
  platform_ = platform;
  refresh();
}

std::vector<std::size_t> TargetTableModel::wanted_rows() const {
  const std::vector<scene::Target>& targets = session_.scene().targets;
  std::vector<std::size_t> rows;
  if (!platform_) {
    rows.resize(targets.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    order(rows);
    return rows;
  }
  scene::SceneIndex names(session_.scene());
  const std::size_t wanted = names.platform(*platform_);
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (names.platform(*targets[i].platform) == wanted) rows.push_back(i);
  order(rows);
  return rows;
}

void TargetTableModel::order(std::vector<std::size_t>& rows) const {
  if (sort_column_ < 0) return;
  const scene::Field& field = field_at(sort_column_);
  std::vector<std::pair<SortKey, std::size_t>> keyed;
  keyed.reserve(rows.size());
  for (const std::size_t row : rows) keyed.emplace_back(sort_key(field, session_.scene().targets[row]), row);
  if (sort_order_ == Qt::AscendingOrder)
    std::ranges::stable_sort(keyed, std::ranges::less{}, &std::pair<SortKey, std::size_t>::first);
  else
    std::ranges::stable_sort(keyed, std::ranges::greater{}, &std::pair<SortKey, std::size_t>::first);
  std::ranges::transform(keyed, rows.begin(), &std::pair<SortKey, std::size_t>::second);
}

void TargetTableModel::take_rows(std::vector<std::size_t> rows) {
  rows_ = std::move(rows);
  row_of_.assign(session_.scene().targets.size(), -1);
  for (std::size_t row = 0; row < rows_.size(); ++row) row_of_[rows_[row]] = static_cast<int>(row);
}

void TargetTableModel::sort(int column, Qt::SortOrder order) {
  if (column == sort_column_ && order == sort_order_) return;
  sort_column_ = column;
  sort_order_ = order;
  beginResetModel();
  take_rows(wanted_rows());
  endResetModel();
}

void TargetTableModel::refresh() {
  read_problems();
  std::vector<std::size_t> rows = wanted_rows();
  if (rows == rows_) {
    if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    return;
  }
  beginResetModel();
  take_rows(std::move(rows));
  endResetModel();
}

// Only the targets that changed are looked at again, unless names may decide otherwise which are shown.
void TargetTableModel::follow(const scene::SceneChange& change) {
  if (change.concerns_names() || read_problems()) return refresh();
  int first = rowCount();
  int last = -1;
  for (const scene::ChangedObject& object : change.changed) {
    const int row = row_of(object.id);
    if (row < 0) continue;
    first = std::min(first, row);
    last = std::max(last, row);
  }
  if (last >= 0) emit dataChanged(index(first, 0), index(last, columnCount() - 1));
}

scene::ObjectId TargetTableModel::target_at(int row) const {
  return {scene::ObjectKind::target, rows_.at(static_cast<std::size_t>(row))};
}

int TargetTableModel::row_of(scene::ObjectId target) const {
  if (target.kind != scene::ObjectKind::target) return -1;
  return target.index < row_of_.size() ? row_of_[target.index] : -1;
}

const scene::Field& TargetTableModel::field_at(int column) const {
  return *columns_.at(static_cast<std::size_t>(column));
}

int TargetTableModel::column_of(const std::string& field) const {
  const auto found = std::ranges::find_if(columns_, [&](const scene::Field* one) { return one->id == field; });
  return found == columns_.end() ? -1 : static_cast<int>(found - columns_.begin());
}

int TargetTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int TargetTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant TargetTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) {
    if (role != Qt::DisplayRole || section >= rowCount()) return {};
    return static_cast<qulonglong>(target_at(section).index + 1);
  }
  const scene::Field& field = field_at(section);
  if (role == Qt::DisplayRole) return heading_of(field);
  if (role == Qt::ToolTipRole) return "<p>" + QString::fromStdString(field.tooltip).toHtmlEscaped() + "</p>";
  return {};
}

// The first problem of each cell. True where they are others than before.
bool TargetTableModel::read_problems() {
  const auto before = std::exchange(problems_, {});
  for (const core::Problem& problem : session_.problems()) {
    if (problem.subject.kind != "target") continue;
    const int column =
        column_of(std::string(scene::field_of_problem(scene::ObjectKind::target, problem.subject.field)));
    if (column >= 0) problems_.try_emplace({problem.subject.index, column}, problem);
  }
  return !std::ranges::equal(problems_, before, [](const auto& a, const auto& b) {
    return a.first == b.first && a.second.severity == b.second.severity &&
           problem_text(a.second) == problem_text(b.second);
  });
}

QStringList TargetTableModel::choices_of(const scene::Field& field) const {
  QStringList choices;
  for (const std::string& choice : field.choices) choices += QString::fromStdString(choice);
  if (field.kind == scene::FieldKind::platform)
    for (const scene::Platform& platform : session_.scene().platforms) choices += QString::fromStdString(platform.name);
  return choices;
}

QVariant TargetTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !scene::has_object(session_.scene(), target_at(index.row()))) return {};
  if (role == choices_role) return choices_of(field_at(index.column()));
  const bool value_wanted = role == Qt::DisplayRole || role == Qt::EditRole;
  if (!value_wanted && role != Qt::ToolTipRole && role != Qt::DecorationRole && role != Qt::TextAlignmentRole)
    return {};
  const scene::Field& field = field_at(index.column());
  if (role == Qt::TextAlignmentRole) {
    const bool number = field.kind == scene::FieldKind::quantity;
    return QVariant::fromValue(Qt::Alignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
  }
  if (value_wanted) {
    const scene::AnyObject target = session_.scene().targets[target_at(index.row()).index];
    // What means nothing for a target is not shown as if it did.
    if (!scene::field_applies(target, field.id)) return role == Qt::DisplayRole ? QStringLiteral("-") : QString();
    return QString::fromStdString(cell_text(field, target));
  }
  const auto problem = problems_.find({target_at(index.row()).index, index.column()});
  if (problem == problems_.end()) return {};
  if (role == Qt::ToolTipRole) return problem_text(problem->second);
  const bool error = problem->second.severity == core::Severity::error;
  return QApplication::style()->standardIcon(error ? QStyle::SP_MessageBoxCritical : QStyle::SP_MessageBoxWarning);
}

Qt::ItemFlags TargetTableModel::flags(const QModelIndex& index) const {
  if (!index.isValid() || !scene::has_object(session_.scene(), target_at(index.row()))) return Qt::NoItemFlags;
  const Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
  const bool applies = scene::field_applies(session_.scene(), target_at(index.row()), field_at(index.column()).id);
  return applies ? flags | Qt::ItemIsEditable : flags;
}

bool TargetTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid()) return false;
  const QString text = value.toString();
  if (text == data(index, Qt::EditRole).toString()) return true;
  const QString why = fill({index}, {text});
  if (why.isEmpty()) return true;
  emit refused(index, text, why);
  return false;
}

QString TargetTableModel::fill(const QModelIndexList& cells, const QStringList& texts) {
  std::vector<CellText> filled;
  filled.reserve(static_cast<std::size_t>(cells.size()));
  for (qsizetype i = 0; i < cells.size(); ++i)
    filled.push_back({target_at(cells[i].row()).index, &field_at(cells[i].column()),
                      (texts.size() == 1 ? texts.front() : texts.value(i)).toStdString()});
  std::ranges::stable_sort(filled, {}, &CellText::target);
  const std::size_t count = filled.size();
  const std::string why = session_.make_and_perform(
      tr("Change targets"), count, [filled = std::move(filled)](const scene::Document& document, scene::Edit& edit) {
        return fill_cells(document, filled, edit);
      });
  return QString::fromStdString(why);
}

}  // namespace sarsim::gui

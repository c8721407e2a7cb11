#include "gui/objects/object_tree_model.hpp"

#include <QDataStream>
#include <QFont>
#include <QGuiApplication>
#include <QIODevice>
#include <QMimeData>

#include <algorithm>
#include <utility>

#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "gui/common/object_names.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/objects/object_tree_icons.hpp"
#include "scene/edit/edit.hpp"
#include "scene/model/object.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::gui {

namespace {

bool can_be_hidden(scene::ObjectKind kind) { return !scene::belongs_to_radar(kind); }

}  // namespace

ObjectTreeModel::ObjectTreeModel(Session& session, QObject* parent) : QAbstractItemModel(parent), session_(session) {
  connect(&session_, &Session::scene_changed, this, &ObjectTreeModel::follow);
  connect(&session_, &Session::hidden_changed, this, &ObjectTreeModel::announce_all);
  connect(&session_, &Session::problems_changed, this, [this] {
    read_problems();
    announce_all();
  });
  refresh();
}

void ObjectTreeModel::set_filter(const QString& words) {
  QStringList list = words.split(' ', Qt::SkipEmptyParts);
  if (list == words_) return;
  words_ = std::move(list);
  refresh();
}

void ObjectTreeModel::refresh() {
  std::vector<Group> groups = groups_of_scene();
  if (!words_.isEmpty()) keep_matching(groups);
  if (std::ranges::equal(groups, groups_, [](const Group& a, const Group& b) { return a.same_shape(b); })) {
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (groups[i].key != groups_[i].key) emit key_changed(groups_[i].key, groups[i].key);
    groups_ = std::move(groups);
    read_problems();
    announce_all();
    return;
  }
  beginResetModel();
  groups_ = std::move(groups);
  index_rows();
  read_problems();
  endResetModel();
}

// Names decide what stands where, and the words of a filter what is shown.
void ObjectTreeModel::follow(const scene::SceneChange& change) {
  if (change.concerns_names() || !words_.isEmpty()) return refresh();
  constexpr std::size_t many = 100;  // Announcing all of them takes no longer.
  if (read_problems() || change.changed.size() > many) return announce_all();
  for (const scene::ChangedObject& object : change.changed) announce(object.id);
}

std::vector<ObjectTreeModel::Group> ObjectTreeModel::groups_of_scene() const {
  const scene::Scene& scene = session_.scene();
  std::vector<Group> groups(scene.platforms.size() + 1);
  for (std::size_t i = 0; i < scene.platforms.size(); ++i) {
    groups[i].platform = i;
    groups[i].key = '/' + QString::fromStdString(scene.platforms[i].name);
  }
  Group& world = groups.back();
  world.section = Section::world;
  world.key = QStringLiteral("world");
  scene::SceneIndex names(scene);
  const auto place = [&](scene::ObjectKind kind, const auto& objects) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const std::size_t platform = names.platform(*scene::carrier_in(objects[i]));
      (platform == scene::not_found ? world : groups[platform]).children.push_back({kind, i});
    }
  };
  place(scene::ObjectKind::radar, scene.radars);
  scene::for_each_kind([&](const auto& kind) {
    if constexpr (kind.stands_on_platform && !kind.is_named) place(kind.kind, scene.*kind.list);
  });
  if (world.children.empty()) groups.pop_back();
  const auto add_section = [&](Section section, scene::ObjectKind kind, const QString& key) {
    Group group{section, 0, {}, key};
    for (std::size_t i = 0; i < scene::count_of(scene, kind); ++i) group.children.push_back({kind, i});
    if (!group.children.empty()) groups.push_back(std::move(group));
  };
  add_section(Section::simulations, scene::ObjectKind::simulation, QStringLiteral("simulations"));
  add_section(Section::geometries, scene::ObjectKind::geometry, QStringLiteral("geometries"));
  return groups;
}

void ObjectTreeModel::keep_matching(std::vector<Group>& groups) const {
  std::erase_if(groups, [&](Group& group) {
    const bool itself = group.section == Section::platform &&
                        matches(label(scene::ObjectId{scene::ObjectKind::platform, group.platform}));
    if (itself) return false;
    group.children = matching(group.children);
    return group.children.empty();
  });
}

// On all cores: to write the labels of many takes a while.
std::vector<scene::ObjectId> ObjectTreeModel::matching(const std::vector<scene::ObjectId>& objects) const {
  constexpr std::size_t together = 4096;
  std::vector<std::uint8_t> fits(objects.size());
  core::parallel_ranges(objects.size(), together, {core::thread_count(0)}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fits[i] = matches(label(objects[i])) ? 1 : 0;
  });
  std::vector<scene::ObjectId> found;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (fits[i] != 0) found.push_back(objects[i]);
  return found;
}

bool ObjectTreeModel::matches(const QString& text) const {
  return std::ranges::all_of(words_, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

void ObjectTreeModel::index_rows() {
  for (std::size_t kind = 0; kind < rows_.size(); ++kind)
    rows_[kind].assign(scene::count_of(session_.scene(), static_cast<scene::ObjectKind>(kind)), {});
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const auto group = static_cast<std::int32_t>(g);
    if (groups_[g].section == Section::platform) rows_[0][groups_[g].platform] = {group, -1};
    for (std::size_t i = 0; i < groups_[g].children.size(); ++i) {
      const scene::ObjectId id = groups_[g].children[i];
      rows_[static_cast<std::size_t>(id.kind)][id.index] = {group, static_cast<std::int32_t>(i)};
    }
  }
}

// True where other objects are in trouble than before, or in another.
bool ObjectTreeModel::read_problems() {
  const std::map<scene::ObjectId, Trouble> before = std::exchange(troubles_, {});
  for (const core::Problem& problem : session_.problems()) {
    const auto kind = scene::kind_called(problem.subject.kind);
    if (!kind || problem.severity == core::Severity::note) continue;
    const auto [entry, is_new] = troubles_.try_emplace({*kind, problem.subject.index});
    Trouble& trouble = entry->second;
    trouble.severity = is_new ? problem.severity : std::min(trouble.severity, problem.severity);
    trouble.texts += problem_text(problem);
  }
  return troubles_ != before;
}

void ObjectTreeModel::announce_all() {
  if (groups_.empty()) return;
  emit dataChanged(index(0, 0), index(rowCount() - 1, column_count - 1));
  for (int g = 0; g < rowCount(); ++g) {
    const QModelIndex top = index(g, 0);
    if (const int rows = rowCount(top); rows > 0)
      emit dataChanged(index(0, 0, top), index(rows - 1, column_count - 1, top));
  }
}

void ObjectTreeModel::announce(scene::ObjectId id) {
  if (const QModelIndex name = index_of(id); name.isValid())
    emit dataChanged(name, name.siblingAtColumn(column_count - 1));
}

std::optional<scene::ObjectId> ObjectTreeModel::object_at(const QModelIndex& index) const {
  if (!index.isValid()) return std::nullopt;
  const auto row = static_cast<std::size_t>(index.row());
  if (index.internalId() == 0) {
    if (row >= groups_.size() || groups_[row].section != Section::platform) return std::nullopt;
    return scene::ObjectId{scene::ObjectKind::platform, groups_[row].platform};
  }
  const std::size_t group = static_cast<std::size_t>(index.internalId()) - 1;
  if (group >= groups_.size() || row >= groups_[group].children.size()) return std::nullopt;
  return groups_[group].children[row];
}

QModelIndex ObjectTreeModel::index_of(scene::ObjectId id) const {
  const auto& rows = rows_[static_cast<std::size_t>(id.kind)];
  if (id.index >= rows.size() || rows[id.index].group < 0) return {};
  const Row row = rows[id.index];
  if (row.row < 0) return index(row.group, 0);
  return createIndex(row.row, 0, static_cast<quintptr>(row.group) + 1);
}

QString ObjectTreeModel::key_of(const QModelIndex& index) const {
  const QModelIndex top = index.parent().isValid() ? index.parent() : index;
  if (!top.isValid() || static_cast<std::size_t>(top.row()) >= groups_.size()) return {};
  return groups_[static_cast<std::size_t>(top.row())].key;
}

std::vector<scene::ObjectId> ObjectTreeModel::with_children(scene::ObjectId platform) const {
  std::vector<scene::ObjectId> ids{platform};
  if (platform.kind != scene::ObjectKind::platform) return ids;
  const std::vector<scene::ObjectId> children = scene::objects_on(session_.scene(), platform.index);
  ids.insert(ids.end(), children.begin(), children.end());
  return ids;
}

QModelIndex ObjectTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : 0);
}

QModelIndex ObjectTreeModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == 0) return {};
  return createIndex(static_cast<int>(child.internalId()) - 1, 0, quintptr{0});
}

int ObjectTreeModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(groups_.size());
  if (parent.internalId() != 0 || parent.column() != 0) return 0;
  const auto group = static_cast<std::size_t>(parent.row());
  return group < groups_.size() ? static_cast<int>(groups_[group].children.size()) : 0;
}

int ObjectTreeModel::columnCount(const QModelIndex&) const { return column_count; }

QString ObjectTreeModel::label(scene::ObjectId id) const {
  return QString::fromStdString(scene::label_of(session_.scene(), id));
}

QVariant ObjectTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == name_column ? tr("Object") : tr("Shown");
}

QVariant ObjectTreeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto id = object_at(index);
  if (!id) {
    const auto group = static_cast<std::size_t>(index.row());
    return group < groups_.size() ? heading_data(groups_[group], index.column(), role) : QVariant();
  }
  // Between a change of the scene and its announcement the tree may still hold objects that are gone.
  if (!scene::has_object(session_.scene(), *id)) return {};
  return index.column() == name_column ? name_data(*id, role) : shown_data(*id, role);
}

QVariant ObjectTreeModel::heading_data(const Group& group, int column, int role) const {
  if (column != name_column) return {};
  if (role == Qt::FontRole) {
    QFont font = QGuiApplication::font();
    font.setItalic(true);
    return font;
  }
  if (role != Qt::DisplayRole) return {};
  switch (group.section) {
    case Section::world: return tr("World (no platform)");
    case Section::simulations: return tr("Stored simulations");
    case Section::geometries: return tr("Geometry tables");
    case Section::platform: break;
  }
  return {};
}

QIcon ObjectTreeModel::icon(scene::ObjectId id) const {
  const auto trouble = troubles_.find(id);
  const QPalette palette = QGuiApplication::palette();
  return trouble == troubles_.end() ? object_icon(id.kind, palette)
                                    : object_icon(id.kind, palette, trouble->second.severity);
}

QVariant ObjectTreeModel::name_data(scene::ObjectId id, int role) const {
  const auto trouble = troubles_.find(id);
  switch (role) {
    case Qt::DisplayRole: return label(id);
    case Qt::EditRole: return QString::fromStdString(name_of_object(session_.scene(), id));
    case Qt::DecorationRole: return icon(id);
    case Qt::ToolTipRole:
      return trouble == troubles_.end() ? label(id) : label(id) + '\n' + trouble->second.texts.mid(0, 5).join('\n');
    case Qt::AccessibleTextRole: {
      QStringList words{label(id)};
      if (session_.hidden().contains(id)) words += tr("hidden");
      if (trouble != troubles_.end()) words += severity_word(trouble->second.severity);
      return words.join(", ");
    }
    case Qt::ForegroundRole:
      if (session_.hidden().contains(id)) return QGuiApplication::palette().brush(QPalette::PlaceholderText);
      return {};
    default: return {};
  }
}

Qt::CheckState ObjectTreeModel::shown_state(scene::ObjectId id) const {
  if (!session_.hidden().contains(id)) return Qt::Checked;
  if (id.kind != scene::ObjectKind::platform) return Qt::Unchecked;
  const std::vector<scene::ObjectId> all = with_children(id);
  const bool none = std::ranges::all_of(all, [&](scene::ObjectId one) { return session_.hidden().contains(one); });
  return none ? Qt::Unchecked : Qt::PartiallyChecked;
}

QVariant ObjectTreeModel::shown_data(scene::ObjectId id, int role) const {
  if (!can_be_hidden(id.kind)) return {};
  switch (role) {
    case Qt::CheckStateRole: return static_cast<int>(shown_state(id));
    case Qt::ToolTipRole: return tr("Shown in the scene; a hidden object is simulated all the same");
    case Qt::AccessibleTextRole: return tr("%1 is shown").arg(label(id));
    default: return {};
  }
}

Qt::ItemFlags ObjectTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  Qt::ItemFlags flags = Qt::ItemIsEnabled;
  if (platform_for_drop(index)) flags |= Qt::ItemIsDropEnabled;
  const auto id = object_at(index);
  if (!id) return flags;
  flags |= Qt::ItemIsSelectable;
  if (index.column() == shown_column) return can_be_hidden(id->kind) ? flags | Qt::ItemIsUserCheckable : flags;
  if (scene::is_named(id->kind)) flags |= Qt::ItemIsEditable;
  if (can_be_hidden(id->kind) && id->kind != scene::ObjectKind::platform) flags |= Qt::ItemIsDragEnabled;
  return flags;
}

bool ObjectTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const auto id = object_at(index);
  if (!id || !scene::has_object(session_.scene(), *id)) return false;
  if (role == Qt::CheckStateRole && index.column() == shown_column) {
    const std::vector<scene::ObjectId> ids = with_children(*id);
    session_.set_hidden({ids.begin(), ids.end()}, value.toInt() == Qt::Unchecked);
    return true;
  }
  if (role != Qt::EditRole || index.column() != name_column || !scene::is_named(id->kind)) return false;
  const std::string name = value.toString().toStdString();
  if (name == name_of_object(session_.scene(), *id)) return true;
  if (const std::string why = scene::name_objection(session_.scene(), *id, name); !why.empty()) {
    emit refused(QString::fromStdString(why));
    return false;
  }
  session_.perform(scene::rename_object(session_.scene(), *id, name));
  return true;
}

// --- Targets, surfaces and radars can be dragged onto another platform.

namespace {

constexpr const char* objects_type = "application/x-sarsim-objects";

}  // namespace

QStringList ObjectTreeModel::mimeTypes() const { return {objects_type}; }

QMimeData* ObjectTreeModel::mimeData(const QModelIndexList& indexes) const {
  QByteArray bytes;
  QDataStream stream(&bytes, QIODevice::WriteOnly);
  for (const QModelIndex& index : indexes) {
    const auto id = object_at(index);
    if (id && index.column() == name_column && scene::stands_on_platform(id->kind))
      stream << static_cast<qint32>(id->kind) << static_cast<quint64>(id->index);
  }
  if (bytes.isEmpty()) return nullptr;
  auto* data = new QMimeData;
  data->setData(objects_type, bytes);
  return data;
}

std::vector<scene::ObjectId> ObjectTreeModel::dragged(const QMimeData* data) const {
  std::vector<scene::ObjectId> ids;
  if (data == nullptr || !data->hasFormat(objects_type)) return ids;
  const QByteArray bytes = data->data(objects_type);
  QDataStream stream(bytes);
  while (!stream.atEnd()) {
    qint32 kind = 0;
    quint64 index = 0;
    stream >> kind >> index;
    const scene::ObjectId id{static_cast<scene::ObjectKind>(kind), static_cast<std::size_t>(index)};
    // From another window the numbers may mean nothing here.
    const bool known = stream.status() == QDataStream::Ok && kind >= 0 && kind < static_cast<qint32>(scene::kind_count);
    if (!known || !scene::stands_on_platform(id.kind) || !scene::has_object(session_.scene(), id)) return {};
    ids.push_back(id);
  }
  return ids;
}

std::optional<std::string> ObjectTreeModel::platform_for_drop(const QModelIndex& index) const {
  const QModelIndex top = index.parent().isValid() ? index.parent() : index;
  if (!top.isValid() || static_cast<std::size_t>(top.row()) >= groups_.size()) return std::nullopt;
  const Group& group = groups_[static_cast<std::size_t>(top.row())];
  if (group.section == Section::world) return "Earth";
  if (group.section != Section::platform) return std::nullopt;
  const scene::ObjectId platform{scene::ObjectKind::platform, group.platform};
  if (!scene::has_object(session_.scene(), platform)) return std::nullopt;
  return name_of_object(session_.scene(), platform);
}

bool ObjectTreeModel::canDropMimeData(const QMimeData* data, Qt::DropAction action, int, int,
                                      const QModelIndex& parent) const {
  return action == Qt::MoveAction && platform_for_drop(parent).has_value() && !dragged(data).empty();
}

bool ObjectTreeModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                   const QModelIndex& parent) {
  if (!canDropMimeData(data, action, row, column, parent)) return false;
  const std::string platform = *platform_for_drop(parent);
  session_.perform(scene::carry_objects(session_.scene(), dragged(data), platform));
  return true;
}

}  // namespace sarsim::gui

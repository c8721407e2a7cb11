#include <QDataStream>
#include <QIODevice>
#include <QMimeData>

#include "gui/common/object_names.hpp"
#include "gui/objects/object_tree_model.hpp"
#include "scene/edit/edit.hpp"

// Targets, surfaces and radars can be dragged onto another platform.

namespace sarsim::gui {

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

#pragma once

#include <QAbstractItemModel>
#include <QIcon>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gui/common/session.hpp"

namespace sarsim::gui {

/// The objects of a scene as a tree: platforms with what stands on them, the world where things stand on no platform,
/// and headings for stored simulations and geometry tables. Labels are made when they are shown; a change of the scene
/// costs time linear in the number of objects and a few nanoseconds each.
class ObjectTreeModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  /// What the columns show; the last is their number.
  enum Column { name_column, shown_column, column_count };
  /// What the objects of the first level are.
  enum class Section { platform, world, simulations, geometries };

  explicit ObjectTreeModel(Session& session, QObject* parent = nullptr);

  /// Leaves out objects whose label holds not all of the words, in any case; a platform whose name holds them stays
  /// with everything on it.
  void set_filter(const QString& words);
  [[nodiscard]] bool filtered() const { return !words_.isEmpty(); }
  /// Looks at the scene again; resets where the tree has another shape.
  void refresh();
  /// The same where it is known what changed: rows of objects that stayed where they were are announced alone.
  void follow(const scene::SceneChange& change);

  /// Nothing for a heading.
  [[nodiscard]] std::optional<scene::ObjectId> object_at(const QModelIndex& index) const;
  /// Not valid where the object is not in the tree or is filtered out.
  [[nodiscard]] QModelIndex index_of(scene::ObjectId id) const;
  /// What identifies a row of the first level over changes of the scene.
  [[nodiscard]] QString key_of(const QModelIndex& index) const;
  /// The name of the platform that a drop on a row carries to; nothing where nothing can be dropped.
  [[nodiscard]] std::optional<std::string> platform_for_drop(const QModelIndex& index) const;
  /// The objects below a row of the first level, and the platform itself.
  [[nodiscard]] std::vector<scene::ObjectId> with_children(scene::ObjectId platform) const;

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
  using QObject::parent;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
  [[nodiscard]] bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                     const QModelIndex& parent) const override;
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

 signals:
  /// A row of the first level is called otherwise than before.
  void key_changed(const QString& before, const QString& now);
  /// A gesture that could not be carried out, and why.
  void refused(const QString& sentence);

 private:
  struct Group {
    Section section = Section::platform;
    std::size_t platform = 0;
    std::vector<scene::ObjectId> children;
    QString key;

    /// Same place and children; the name of the platform may be another.
    [[nodiscard]] bool same_shape(const Group& other) const {
      return section == other.section && platform == other.platform && children == other.children;
    }
  };
  struct Row {
    std::int32_t group = -1;
    std::int32_t row = -1;  // -1: the group itself
  };

  [[nodiscard]] std::vector<Group> groups_of_scene() const;
  void keep_matching(std::vector<Group>& groups) const;
  [[nodiscard]] std::vector<scene::ObjectId> matching(const std::vector<scene::ObjectId>& objects) const;
  [[nodiscard]] bool matches(const QString& text) const;
  void index_rows();
  bool read_problems();
  void announce_all();
  void announce(scene::ObjectId id);
  [[nodiscard]] QVariant heading_data(const Group& group, int column, int role) const;
  [[nodiscard]] QVariant name_data(scene::ObjectId id, int role) const;
  [[nodiscard]] QVariant shown_data(scene::ObjectId id, int role) const;
  [[nodiscard]] Qt::CheckState shown_state(scene::ObjectId id) const;
  [[nodiscard]] QString label(scene::ObjectId id) const;
  [[nodiscard]] QIcon icon(scene::ObjectId id) const;
  [[nodiscard]] std::vector<scene::ObjectId> dragged(const QMimeData* data) const;

  struct Trouble {
    core::Severity severity = core::Severity::note;
    QStringList texts;

    friend bool operator==(const Trouble&, const Trouble&) = default;
  };

  Session& session_;
  QStringList words_;
  std::vector<Group> groups_;
  std::array<std::vector<Row>, scene::kind_count> rows_;  // by kind, then index
  std::map<scene::ObjectId, Trouble> troubles_;
};

}  // namespace sarsim::gui

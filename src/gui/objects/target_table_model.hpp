#pragma once

#include <QAbstractTableModel>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gui/common/session.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::gui {

/// All targets of a scene, or those of one platform, one row each; a column for each of their fields that is text, a
/// number or a choice, those that are rarely needed last. Numbers of a column are in one unit, which its heading names;
/// cells take what the property panel takes: "3 km", "10 dBsm".
class TargetTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit TargetTableModel(Session& session, QObject* parent = nullptr);

  /// Shows the targets of one platform only; nothing: all.
  void set_platform(const std::optional<std::string>& platform);
  [[nodiscard]] const std::optional<std::string>& platform() const { return platform_; }

  /// The target of a row that there is.
  [[nodiscard]] scene::ObjectId target_at(int row) const;
  /// -1 where the target is not shown.
  [[nodiscard]] int row_of(scene::ObjectId target) const;
  /// The field of a column that there is.
  [[nodiscard]] const scene::Field& field_at(int column) const;
  /// -1 where no column shows the field.
  [[nodiscard]] int column_of(const std::string& field) const;

  /// Orders the rows by a column, numbers by their size and texts by their letters; -1: as the scene has them. New rows
  /// take their places at once, but a row that is edited stays until the rows are ordered again.
  void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

  /// Gives cells texts in one undo step, texts[i] to cells[i]; a single text goes to all of them. Nothing is changed
  /// where one of them is refused.
  /// @returns empty, or why not, in words
  [[nodiscard]] QString fill(const QModelIndexList& cells, const QStringList& texts);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 signals:
  /// A cell did not take what was typed, and why.
  void refused(const QModelIndex& cell, const QString& text, const QString& sentence);

 private:
  void refresh();
  void follow(const scene::SceneChange& change);
  [[nodiscard]] std::vector<std::size_t> wanted_rows() const;
  void order(std::vector<std::size_t>& rows) const;
  void take_rows(std::vector<std::size_t> rows);
  bool read_problems();
  [[nodiscard]] QStringList choices_of(const scene::Field& field) const;

  Session& session_;
  std::optional<std::string> platform_;
  std::vector<const scene::Field*> columns_;  // of `fields_of`
  int sort_column_ = -1;
  Qt::SortOrder sort_order_ = Qt::AscendingOrder;
  std::vector<std::size_t> rows_;                                  // positions in the scene's list of targets
  std::vector<int> row_of_;                                        // of each target of the list; -1: not shown
  std::map<std::pair<std::size_t, int>, core::Problem> problems_;  // by target and column
};

}  // namespace sarsim::gui

#pragma once

#include <QAbstractTableModel>

#include <optional>

#include "scene/schema/list_fields.hpp"

namespace sarsim::gui {

/// The entries of a list of an object, one row each; a column for each field that an entry can have. Changes nothing
/// itself: it asks.
class ListModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  /// @param list  of FieldKind::list
  explicit ListModel(const scene::Field& list, QObject* parent = nullptr);

  /// Shows the list of an object; nothing where several do not agree. What is being typed stays as long as the number
  /// of entries does.
  void show(const std::optional<scene::AnyObject>& object);
  /// Shows the same again; what is being typed is dropped.
  void drop_typing();
  /// Whether a field means something for any of the entries.
  [[nodiscard]] bool means_something(int column) const;
  /// The field of a column that there is.
  [[nodiscard]] const scene::Field& field_at(int column) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 signals:
  /// A cell is to have another text.
  void typed(const QModelIndex& cell, const QString& text);

 private:
  [[nodiscard]] std::optional<std::string> text_at(int row, int column) const;

  scene::Field list_;
  std::optional<scene::AnyObject> object_;
  int rows_ = 0;
};

}  // namespace sarsim::gui

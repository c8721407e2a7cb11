#pragma once

#include <QAbstractTableModel>
#include <QWidget>

class QScrollBar;
class QTableView;

namespace sarsim::gui {

/// A few rows of a very long model, for a view that keeps something for each row: rows offset ... offset + page - 1.
class ModelPage : public QAbstractTableModel {
  Q_OBJECT

 public:
  /// A page of a model that outlives it.
  explicit ModelPage(QAbstractItemModel* source, QObject* parent = nullptr);

  /// How many rows are shown.
  void set_page(int rows);
  /// Which row of the model is the first one.
  void set_offset(int offset);
  [[nodiscard]] int offset() const { return offset_; }
  [[nodiscard]] int page() const { return page_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void pass_on_change(const QModelIndex& first, const QModelIndex& last);

  QAbstractItemModel* source_;
  int offset_ = 0;
  int page_ = 1;
};

/// A table view of any number of rows, up to 2^31 - 1: it holds only those on screen, and its scroll bar counts rows.
class GeometryView : public QWidget {
  Q_OBJECT

 public:
  /// A view of a model that outlives it.
  explicit GeometryView(QAbstractItemModel* model, QWidget* parent = nullptr);

  /// Brings a row to the top, or as near as can be.
  void scroll_to(int row);
  [[nodiscard]] int first_row() const { return page_->offset(); }
  [[nodiscard]] QTableView* table() const { return table_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void fit();
  void take_columns();
  void move_to(int row);
  [[nodiscard]] bool move_by_key(int key, bool control);

  QAbstractItemModel* source_;
  ModelPage* page_;
  QTableView* table_;
  QScrollBar* bar_;
};

}  // namespace sarsim::gui

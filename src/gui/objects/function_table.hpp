#pragma once

#include <QAbstractTableModel>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

#include "scene/edit/function_model.hpp"
#include "scene/schema/quantity.hpp"

class QPushButton;
class QSpinBox;
class QTableView;

namespace sarsim::gui {

/// How the numbers of an axis are typed and shown in the table.
struct AxisUnit {
  scene::Quantity quantity = scene::Quantity::number;
  std::string unit;  ///< Of a number without one; empty for pure numbers.
};

/// The axis unit of a unit of FunctionInfo: frequencies in GHz as in scripts, all others as they are.
[[nodiscard]] AxisUnit axis_unit(const std::string& unit);
/// The number in the axis's unit, without it.
[[nodiscard]] QString axis_text(double value, const AxisUnit& axis);

/// The points of one part of a function as rows of x and y. Holds no points of its own longer than until the next
/// `show`; whoever holds the function hears `entered`.
class FunctionTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit FunctionTableModel(QObject* parent = nullptr);

  /// Shows the points of a part in the units of its axes.
  void show(const scene::FunctionInfo& info, std::size_t part, const core::SampledFunction& function);
  /// Shows one moved point.
  void show_knot(std::size_t row, core::Knot knot);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 signals:
  void entered(std::size_t row, sarsim::core::Knot knot);  ///< The point as it is to be; its x may belong elsewhere.
  void refused(const QString& why);                        ///< What was typed is not a number of the axis.

 private:
  void take(const std::vector<core::Knot>& knots);

  std::vector<core::Knot> knots_;
  bool per_pulse_ = false;
  QString names_[2];
  AxisUnit axes_[2];
};

/// The table of points with its buttons and the number of samples.
class FunctionTable : public QWidget {
  Q_OBJECT

 public:
  explicit FunctionTable(QWidget* parent = nullptr);

  /// Shows the points of a part; the current row stays where there is one.
  void show_function(const scene::FunctionInfo& info, std::size_t part, const core::SampledFunction& function);
  void show_knot(std::size_t row, core::Knot knot) { model_->show_knot(row, knot); }
  /// Makes a row the current one and brings it into sight.
  void set_current(std::size_t row);
  /// The current row; nothing where there is none.
  [[nodiscard]] std::optional<std::size_t> current() const;

 signals:
  void entered(std::size_t row, sarsim::core::Knot knot);  ///< See FunctionTableModel.
  void refused(const QString& why);                        ///< See FunctionTableModel.
  void current_changed();                                  ///< Another row is the current one.
  void insert_wanted();                                    ///< A point is wanted behind the current row.
  void delete_wanted();                                    ///< The current point is to go.
  void count_wanted(int count);                            ///< So many samples are wanted.

 private:
  FunctionTableModel* model_;
  QTableView* view_;
  QSpinBox* count_;
  QPushButton* delete_;
};

}  // namespace sarsim::gui

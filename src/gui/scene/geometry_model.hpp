#pragma once

#include <QAbstractTableModel>

#include <cstdint>
#include <list>
#include <memory>
#include <unordered_map>
#include <vector>

#include "gui/scene/geometry_rows.hpp"

namespace sarsim::gui {

/// A geometry table of any number of pulses for a view: a row is computed when somebody looks at it, in blocks, on a
/// thread of its own; until then its cells show "…". The latest blocks are kept.
class GeometryModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  /// The number itself, in SI units and degrees; invalid while it is not computed.
  static constexpr int value_role = Qt::UserRole;

  explicit GeometryModel(QObject* parent = nullptr);
  ~GeometryModel() override;

  /// Begins another table; `ready` or `failed` follows. Until then the model has no rows.
  void set_table(const scene::Scene& scene, const GeometryChoice& choice);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] const std::vector<GeometryHeading>& headings() const { return headings_; }
  /// Those of the table that was `ready` last; none before and after a failure.
  [[nodiscard]] const radar::PulseRange& pulses() const { return pulses_; }

 signals:
  void ready();                          ///< At most 2^31 - 1 of its `pulses` are rows.
  void failed(const QString& problems);  ///< One line for each.

 private:
  class Worker;
  using Block = std::vector<double>;
  static constexpr std::int64_t block_rows = 256;

  void take_headings(int generation, std::vector<GeometryHeading> headings, radar::PulseRange pulses);
  void take_failure(int generation, const QString& problems);
  void take_block(int generation, std::int64_t block, Block values);
  [[nodiscard]] const Block* block_of(std::int64_t block) const;
  [[nodiscard]] QString text_of(double value, int column) const;

  struct Kept {
    Block values;
    std::list<std::int64_t>::iterator use;
  };
  std::vector<GeometryHeading> headings_;
  radar::PulseRange pulses_;
  int rows_ = 0;
  int generation_ = 0;
  mutable std::list<std::int64_t> uses_;  // the latest first
  mutable std::unordered_map<std::int64_t, Kept> kept_;
  std::unique_ptr<Worker> worker_;
};

}  // namespace sarsim::gui

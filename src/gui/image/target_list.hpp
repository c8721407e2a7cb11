#pragma once

#include <QWidget>

#include <filesystem>
#include <memory>
#include <optional>

#include "gui/common/background_job.hpp"
#include "picture/image/target_table.hpp"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace sarsim::gui {

class ProblemLine;

/// The targets of a focused image: offsets, widths, sidelobes and SNR of each, as `sarsim measure` has them
/// ("target_list"). Measures in the background.
class TargetList : public QWidget {
  Q_OBJECT

 public:
  explicit TargetList(QWidget* parent = nullptr);
  ~TargetList() override;

  /// Measures the targets of an image anew; `measured` follows.
  void measure(const std::filesystem::path& image);
  /// Forgets what was measured, and stops what is under way.
  void forget();
  [[nodiscard]] const picture::TargetTable& table() const { return table_; }
  /// The row of the table that is chosen, in the order of the script.
  [[nodiscard]] std::optional<std::size_t> chosen() const;
  /// Chooses a row, as a click does.
  void choose(std::size_t row);

 signals:
  void measured();                      ///< The table is there, or it says why it is not.
  void target_chosen(std::size_t row);  ///< A row of the table, in the order of the script.

 private:
  void end(JobEnd end, const QString& failure);
  void clear();
  void fill();
  void copy();

  std::filesystem::path image_;
  std::shared_ptr<picture::TargetTable> made_;
  picture::TargetTable table_;
  QTableWidget* list_ = nullptr;
  QLabel* summary_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* copy_ = nullptr;
  ProblemLine* problems_ = nullptr;
  BackgroundJob job_;
  bool again_ = false;
};

}  // namespace sarsim::gui

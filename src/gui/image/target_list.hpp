#pragma once

#include <QWidget>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

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

  /// Asked for the file of a table to save; empty: cancelled. A file dialog unless replaced.
  std::function<QString()> ask_name;

  /// Measures the targets of an image anew; `measured` follows.
  void measure(const std::filesystem::path& image);
  /// Forgets what was measured, and stops what is under way.
  void forget();
  [[nodiscard]] const picture::TargetTable& table() const { return shown_.table; }
  /// The row of the table that is chosen, in the order of the script.
  [[nodiscard]] std::optional<std::size_t> chosen() const;
  /// Chooses a row, as a click does.
  void choose(std::size_t row);

 signals:
  void measured();                      ///< The table is there, or it says why it is not.
  void target_chosen(std::size_t row);  ///< A row of the table, in the order of the script.

 private:
  // What was measured: as it is shown, and as the command writes it.
  struct Measured {
    picture::TargetTable table;
    std::string csv;
  };

  void end(JobEnd end, const QString& failure);
  void clear();
  void fill();
  void copy();
  void save();

  std::filesystem::path image_;
  std::shared_ptr<Measured> made_;
  Measured shown_;
  QTableWidget* list_ = nullptr;
  QLabel* summary_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* copy_ = nullptr;
  QPushButton* save_ = nullptr;
  ProblemLine* problems_ = nullptr;
  BackgroundJob job_;
  bool again_ = false;
};

}  // namespace sarsim::gui

#pragma once

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <vector>

#include "core/task/observer.hpp"
#include "gui/common/background_job.hpp"
#include "picture/facts/report_pages.hpp"

namespace sarsim::gui {

/// What was made of echoes.
struct ProductResult {
  std::vector<std::filesystem::path> images;  ///< To be looked at; none where only detections were wanted.
  picture::ReportPages pages;
  core::Problems problems;  ///< Warnings and notes.
};

/// Makes a product of echoes on a thread of its own. Signals come on the thread of this object. Destroyed before the
/// end, the work is stopped and waited for.
class ProductJob : public QObject {
  Q_OBJECT

 public:
  /// The work: throws Interrupted when the observer says stop, core::InvalidRequest, and what has words for people.
  using Work = std::function<ProductResult(const core::Observer& observer)>;

  explicit ProductJob(QObject* parent = nullptr);
  ~ProductJob() override;

  /// Begins; std::logic_error where work is under way.
  void start(Work work);
  /// Asks the work to end; `ended` follows.
  void stop();
  [[nodiscard]] bool running() const { return job_.running(); }
  /// After `ended` with JobEnd::done.
  [[nodiscard]] const ProductResult& result() const { return result_; }
  /// After `ended` with JobEnd::failed: why the request was refused; empty where something else failed.
  [[nodiscard]] const core::Problems& refusals() const { return refusals_; }

 signals:
  /// How far a stage is, 0 to 1; seconds below 0: not known yet.
  void progressed(const QString& stage, double fraction, double seconds_left);
  void announced(const QString& line);                          ///< What comes next: size, duration.
  void ended(sarsim::gui::JobEnd end, const QString& failure);  ///< With words about its failure, where it failed.

 private:
  void work_through(const Work& work, const core::StopFlag& stop);
  [[nodiscard]] core::Observer observer(const core::StopFlag& stop);

  ProductResult result_;
  core::Problems refusals_;
  BackgroundJob job_;  // Last: its thread uses everything above.
};

}  // namespace sarsim::gui

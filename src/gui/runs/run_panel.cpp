#include "gui/runs/run_panel.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"

namespace sarsim::gui {

namespace {

// More than this is worth a question before it is taken.
constexpr double modest_memory_bytes = 2e9;

QLabel* selectable_label(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

}  // namespace

RunPanel::RunPanel(QWidget* parent)
    : QWidget(parent),
      title_(selectable_label("run_title", this)),
      state_(selectable_label("run_state", this)),
      bar_(new QProgressBar(this)),
      start_(new QPushButton(tr("S&tart"), this)),
      cancel_(new QPushButton(tr("&Cancel"), this)),
      use_lsb_(new QPushButton(tr("&Use best LSB"), this)),
      report_(selectable_label("run_report", this)),
      problems_(new ProblemLine(this)) {
  setObjectName("run_panel");
  setAccessibleName(tr("Run"));
  bar_->setObjectName("run_progress");
  bar_->setAccessibleName(tr("Progress of the run"));
  bar_->setRange(0, bar_steps);
  start_->setObjectName("run_start");
  start_->setAccessibleName(tr("Start the run"));
  cancel_->setObjectName("run_cancel");
  cancel_->setAccessibleName(tr("Cancel the run"));
  use_lsb_->setObjectName("run_use_lsb");
  use_lsb_->setAccessibleName(tr("Set the LSB of the simulation to the best one"));
  problems_->setObjectName("run_problems");

  auto* row = new QHBoxLayout;
  row->addWidget(bar_, 1);
  row->addWidget(start_);
  row->addWidget(cancel_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(title_);
  layout->addLayout(row);
  layout->addWidget(state_);
  layout->addWidget(report_);
  layout->addWidget(problems_);
  layout->addWidget(use_lsb_, 0, Qt::AlignLeft);
  setVisible(false);

  connect(start_, &QPushButton::clicked, this, &RunPanel::proceed);
  connect(cancel_, &QPushButton::clicked, this, &RunPanel::cancel);
  connect(use_lsb_, &QPushButton::clicked, this, [this] {
    use_lsb_->setVisible(false);
    emit lsb_wanted(job_->request().scene.simulations[job_->request().simulation], job_->summary().report.best_lsb_v);
  });
}

RunPanel::~RunPanel() = default;

void RunPanel::run(RunRequest request) {
  title_->setText(tr("Running into %1").arg(QString::fromStdString(request.file.string())));
  state_->setText(tr("Estimating time and memory …"));
  state_->setVisible(true);
  bar_->setValue(0);
  bar_->setVisible(true);
  start_->setVisible(false);
  cancel_->setVisible(true);
  cancel_->setEnabled(true);
  use_lsb_->setVisible(false);
  report_->clear();
  report_->setVisible(false);
  problems_->clear();
  setVisible(true);
  job_ = std::make_unique<RunJob>(std::move(request));
  connect(job_.get(), &RunJob::estimated, this, &RunPanel::show_estimate);
  connect(job_.get(), &RunJob::progressed, this, &RunPanel::show_progress);
  connect(job_.get(), &RunJob::ended, this, &RunPanel::show_end);
  job_->start();
}

void RunPanel::cancel() {
  if (!running()) return;
  state_->setText(tr("Cancelling …"));
  cancel_->setEnabled(false);
  job_->cancel();
}

void RunPanel::show_estimate(const RunEstimate& estimate) {
  report_->setText(estimate_text(estimate));
  report_->setVisible(true);
  if (!estimate.warnings.isEmpty()) problems_->show_texts(core::Severity::warning, estimate.warnings);
  if (!cancel_->isEnabled()) return;
  if (estimate.takes.seconds <= patience_s_ && estimate.takes.memory_bytes <= modest_memory_bytes) {
    proceed();
    return;
  }
  state_->setText(tr("This may take a while; press Start to begin."));
  start_->setVisible(true);
  start_->setFocus();
}

void RunPanel::proceed() {
  start_->setVisible(false);
  state_->setText(tr("Running …"));
  job_->proceed();
}

void RunPanel::show_progress(double fraction, double seconds_left) {
  bar_->setValue(static_cast<int>(fraction * bar_steps));
  if (!cancel_->isEnabled()) return;
  state_->setText(with_time_left(tr("%1 % done").arg(100.0 * fraction, 0, 'f', 0), seconds_left));
}

void RunPanel::show_end(JobEnd end, const QString& failure) {
  bar_->setVisible(false);
  start_->setVisible(false);
  cancel_->setVisible(false);
  state_->setVisible(end == JobEnd::cancelled);
  if (end == JobEnd::cancelled) {
    state_->setText(tr("The run was cancelled; no file was written."));
    report_->setVisible(false);
  } else if (end == JobEnd::failed) {
    report_->setVisible(false);
    problems_->show_texts(core::Severity::error, failure.split('\n'));
  } else {
    title_->setText(tr("Done"));
    report_->setText(summary_lines(job_->summary()).join('\n'));
    const QString warning = saturation_warning(job_->summary());
    if (!warning.isEmpty()) problems_->show_texts(core::Severity::warning, {warning});
    use_lsb_->setVisible(!warning.isEmpty());
  }
  emit ended(end);
}

}  // namespace sarsim::gui

#include "gui/runs/save_queue.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"

namespace sarsim::gui {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

QString state_word(SaveState state) {
  switch (state) {
    case SaveState::waiting: return SaveQueue::tr("Waiting");
    case SaveState::running: return SaveQueue::tr("Saving");
    case SaveState::done: return SaveQueue::tr("Saved");
    case SaveState::cancelled: return SaveQueue::tr("Cancelled");
    case SaveState::failed: break;
  }
  return SaveQueue::tr("Not saved");
}

bool has_ended(SaveState state) { return state != SaveState::waiting && state != SaveState::running; }

}  // namespace

SaveQueue::SaveQueue(QWidget* parent) : QWidget(parent) {
  setObjectName("saving");
  setWindowTitle(tr("Saving"));
  table_ = new QTableWidget(0, 2, this);
  table_->setObjectName("saving_table");
  table_->setAccessibleName(tr("Files that are saved"));
  table_->setHorizontalHeaderLabels({tr("File"), tr("State")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->verticalHeader()->hide();
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setTabKeyNavigation(false);
  bar_ = new QProgressBar(this);
  bar_->setObjectName("saving_progress");
  bar_->setAccessibleName(tr("Progress of the file that is saved"));
  bar_->setRange(0, bar_steps);
  report_ = new QLabel(tr("No files yet. Use Save Data in a simulation window."), this);
  report_->setObjectName("saving_report");
  report_->setWordWrap(true);
  report_->setTextFormat(Qt::PlainText);
  report_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  problems_ = new ProblemLine(this);
  problems_->setObjectName("saving_problems");
  auto* const column = new QVBoxLayout(this);
  column->addWidget(table_, 1);
  column->addWidget(bar_);
  column->addWidget(report_);
  column->addWidget(problems_);
  make_buttons();
  connect(table_, &QTableWidget::itemSelectionChanged, this, &SaveQueue::show_chosen);
  show_chosen();
  resize(fontMetrics().averageCharWidth() * 84, fontMetrics().lineSpacing() * 22);
}

SaveQueue::~SaveQueue() = default;

void SaveQueue::make_buttons() {
  auto* const row = new QHBoxLayout;
  const auto add_button = [&](const QString& text, const char* name, const QString& tip, auto slot) {
    auto* const button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, slot);
    row->addWidget(button);
    return button;
  };
  again_ = add_button(tr("Save Again with Best &LSB"), "saving_again",
                      tr("Save the same data again with an LSB that avoids clipping, replacing the file"),
                      &SaveQueue::save_again);
  row->addStretch(1);
  clear_ = add_button(tr("C&lear Finished"), "saving_clear", tr("Remove finished jobs from the list (files are kept)"),
                      &SaveQueue::clear_ended);
  cancel_ = add_button(tr("&Cancel"), "saving_cancel", tr("End the chosen run; no part of its file is left"), [this] {
    if (chosen() != none) cancel(chosen());
  });
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

std::size_t SaveQueue::add(RunRequest request) {
  const std::size_t run = runs_.size();
  runs_.push_back({});
  runs_.back().request = std::move(request);
  const int row = static_cast<int>(run);
  table_->insertRow(row);
  for (int column = 0; column < 2; ++column) table_->setItem(row, column, new QTableWidgetItem);
  show_run(run);
  table_->selectRow(row);
  start_next();
  return run;
}

bool SaveQueue::busy() const {
  return std::ranges::any_of(runs_, [](const Run& run) { return !has_ended(run.state); });
}

bool SaveQueue::will_write(const std::filesystem::path& file) const {
  return std::ranges::any_of(runs_, [&](const Run& run) {
    return !has_ended(run.state) && run.request.file.lexically_normal() == file.lexically_normal();
  });
}

void SaveQueue::start_next() {
  if (std::ranges::any_of(runs_, [](const Run& run) { return run.state == SaveState::running; })) return;
  const auto next = std::ranges::find(runs_, SaveState::waiting, &Run::state);
  if (next == runs_.end()) return;
  current_ = static_cast<std::size_t>(next - runs_.begin());
  next->state = SaveState::running;
  next->words = tr("Estimating time and memory ...");
  bar_->setValue(0);
  job_ = std::make_unique<RunJob>(next->request);
  connect(job_.get(), &RunJob::estimated, this, &SaveQueue::take_estimate);
  connect(job_.get(), &RunJob::progressed, this, &SaveQueue::take_progress);
  connect(job_.get(), &RunJob::ended, this, &SaveQueue::take_end);
  job_->start();
  show_run(current_);
}

// The user has seen size and time before: nothing more is asked.
void SaveQueue::take_estimate(const RunEstimate& estimate) {
  runs_[current_].words = estimate_text(estimate);
  runs_[current_].warnings = estimate.warnings;
  show_run(current_);
  job_->proceed();
}

void SaveQueue::take_progress(double fraction, double seconds_left) {
  bar_->setValue(static_cast<int>(fraction * bar_steps));
  table_->item(static_cast<int>(current_), 1)->setText(share_with_time_left(fraction, seconds_left));
}

void SaveQueue::take_end(JobEnd end, const QString& failure) {
  Run& run = runs_[current_];
  run.state = end == JobEnd::done        ? SaveState::done
              : end == JobEnd::cancelled ? SaveState::cancelled
                                         : SaveState::failed;
  run.failure = failure;
  if (end == JobEnd::done) run.summary = job_->summary();
  // Only what is to be saved again needs its scene.
  if (end != JobEnd::done || run.summary.report.saturated == 0) run.request.scene = scene::Scene();
  const std::size_t ended_run = current_;
  show_run(ended_run);
  emit ended(ended_run, run.state);
  // Not here: the job that tells this must not be replaced meanwhile.
  QMetaObject::invokeMethod(this, &SaveQueue::start_next, Qt::QueuedConnection);
}

void SaveQueue::cancel(std::size_t run) {
  Run& chosen_run = runs_.at(run);
  if (chosen_run.state == SaveState::running) {
    cancel_->setEnabled(false);
    job_->cancel();
  } else if (chosen_run.state == SaveState::waiting) {
    chosen_run.state = SaveState::cancelled;
    chosen_run.request.scene = scene::Scene();
    show_run(run);
    emit ended(run, SaveState::cancelled);
  }
}

void SaveQueue::cancel_all() {
  for (std::size_t run = runs_.size(); run-- > 0;) cancel(run);
}

void SaveQueue::save_again() {
  const std::size_t run = chosen();
  if (run == none || !may_repeat(runs_[run])) return;
  RunRequest request = runs_[run].request;
  runs_[run].request.scene = scene::Scene();
  runs_[run].repeated = true;
  request.scene.simulations.at(request.simulation).lsb_v = runs_[run].summary.report.best_lsb_v;
  request.replace = true;
  add(std::move(request));
}

void SaveQueue::clear_ended() {
  for (std::size_t run = runs_.size(); run-- > 0;) {
    if (!has_ended(runs_[run].state)) continue;
    runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(run));
    table_->removeRow(static_cast<int>(run));
    if (run < current_) --current_;
  }
  show_chosen();
}

QString SaveQueue::report(std::size_t run) const {
  const Run& shown = runs_.at(run);
  switch (shown.state) {
    case SaveState::waiting: return tr("Queued.");
    case SaveState::running: return shown.words;
    case SaveState::done: return summary_lines(shown.summary).join('\n');
    case SaveState::cancelled: return tr("Cancelled: not saved, and nothing was written.");
    case SaveState::failed: break;
  }
  return shown.failure;
}

void SaveQueue::show_run(std::size_t run) {
  const Run& shown = runs_[run];
  const QString path = QString::fromStdString(shown.request.file.string());
  const int row = static_cast<int>(run);
  table_->item(row, 0)->setText(path);
  table_->item(row, 0)->setToolTip(path);
  table_->item(row, 1)->setText(state_word(shown.state));
  show_chosen();
}

std::size_t SaveQueue::chosen() const {
  const int row = table_->currentRow();
  return row >= 0 && static_cast<std::size_t>(row) < runs_.size() ? static_cast<std::size_t>(row) : none;
}

void SaveQueue::show_chosen() {
  const std::size_t run = chosen();
  const bool any = run != none;
  clear_->setEnabled(std::ranges::any_of(runs_, [](const Run& r) { return has_ended(r.state); }));
  cancel_->setEnabled(any && !has_ended(runs_[run].state));
  bar_->setVisible(any && runs_[run].state == SaveState::running);
  again_->setVisible(any && may_repeat(runs_[run]));
  problems_->clear();
  if (!any) {
    report_->setText(tr("No files yet. Use Save Data in a simulation window."));
    return;
  }
  const Run& shown = runs_[run];
  const bool failed = shown.state == SaveState::failed;
  report_->setText(failed ? QString() : report(run));
  report_->setVisible(!failed);
  QStringList warnings = shown.warnings;
  if (const QString clipped = saturation_warning(shown.summary); !clipped.isEmpty()) warnings.prepend(clipped);
  if (failed)
    problems_->show_texts(core::Severity::error, shown.failure.split('\n'));
  else if (!warnings.isEmpty())
    problems_->show_texts(core::Severity::warning, warnings.mid(0, 5));
}

}  // namespace sarsim::gui

#include "gui/image/target_list.hpp"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>

#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"
#include "scene/edit/text_file.hpp"

namespace sarsim::gui {

namespace {

// Sorts by the number behind the words; what has none comes last.
class NumberItem : public QTableWidgetItem {
 public:
  NumberItem(const QString& words, double value) : QTableWidgetItem(words), value_(value) {
    setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
    if (std::isfinite(value)) setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  bool operator<(const QTableWidgetItem& other) const override {
    const auto* const number = dynamic_cast<const NumberItem*>(&other);
    if (number == nullptr || (!std::isfinite(value_) && !std::isfinite(number->value_)))
      return QTableWidgetItem::operator<(other);
    if (!std::isfinite(value_)) return false;
    return !std::isfinite(number->value_) || value_ < number->value_;
  }

 private:
  double value_;
};

constexpr int row_role = Qt::UserRole;  // of a line: its place in the table

}  // namespace

TargetList::TargetList(QWidget* parent) : QWidget(parent) {
  setObjectName("target_list");
  list_ = new QTableWidget(this);
  list_->setObjectName("target_list_table");
  list_->setAccessibleName(tr("Targets of the image"));
  list_->setSelectionBehavior(QAbstractItemView::SelectRows);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  list_->verticalHeader()->hide();
  list_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  list_->setMinimumHeight(fontMetrics().height() * 6);
  summary_ = new QLabel(this);
  summary_->setObjectName("target_list_summary");
  progress_ = new QProgressBar(this);
  progress_->setObjectName("target_list_progress");
  progress_->setAccessibleName(tr("Targets are being measured"));
  progress_->setRange(0, 1000);
  problems_ = new ProblemLine(this);
  problems_->setObjectName("target_list_problems");
  cancel_ = new QPushButton(tr("Cancel"), this);
  cancel_->setObjectName("target_list_cancel");
  copy_ = new QPushButton(tr("Copy Table"), this);
  copy_->setObjectName("target_list_copy");
  copy_->setToolTip(tr("The table with tabs, for a spreadsheet"));
  save_ = new QPushButton(tr("Save Table..."), this);
  save_->setObjectName("target_list_save");
  save_->setToolTip(tr("The table with commas, as sarsim measure --csv writes it"));
  for (QPushButton* button : {cancel_, copy_, save_}) button->setAutoDefault(false);
  auto* const foot = new QHBoxLayout;
  foot->addWidget(summary_, 1);
  foot->addWidget(progress_);
  foot->addWidget(cancel_);
  foot->addWidget(copy_);
  foot->addWidget(save_);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(problems_);
  column->addWidget(list_, 1);
  column->addLayout(foot);
  for (QWidget* widget : {static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)}) widget->hide();
  connect(cancel_, &QPushButton::clicked, this, [this] { job_.running() ? job_.cancel() : measure(image_); });
  connect(copy_, &QPushButton::clicked, this, &TargetList::copy);
  connect(save_, &QPushButton::clicked, this, &TargetList::save);
  ask_name = [this] {
    const QString folder = text_of(image_.parent_path() / "targets.csv");
    return QFileDialog::getSaveFileName(this, tr("Save Table"), folder, tr("Tables (*.csv)"));
  };
  connect(&job_, &BackgroundJob::ended, this, &TargetList::end);
  connect(&job_, &BackgroundJob::progressed, this, [this](double fraction, double seconds_left) {
    progress_->setValue(static_cast<int>(1000.0 * fraction));
    progress_->setFormat(with_time_left(QStringLiteral("%p %"), seconds_left));
  });
  connect(list_, &QTableWidget::itemSelectionChanged, this, [this] {
    if (const auto row = chosen()) emit target_chosen(*row);
  });
}

TargetList::~TargetList() = default;

void TargetList::forget() {
  again_ = false;
  if (job_.running()) job_.cancel();
  image_.clear();
  clear();
}

// Nothing of another image stays.
void TargetList::clear() {
  shown_ = {};
  problems_->show_texts(core::Severity::note, {});
  fill();
}

void TargetList::measure(const std::filesystem::path& image) {
  image_ = image;
  clear();
  if (job_.running()) {
    again_ = true;
    job_.cancel();
    return;
  }
  again_ = false;
  made_ = std::make_shared<Measured>();
  progress_->setValue(0);
  progress_->show();
  cancel_->setText(tr("Cancel"));
  cancel_->show();
  job_.start([this, image, made = made_](const core::StopFlag& stop, const BackgroundJob::Report& report) {
    workflow::MeasureRequest request;
    request.image = image;
    core::Observer observer;
    observer.stop = &stop;
    observer.progress = [&](const std::string&, const core::Progress& progress) {
      if (progress.total > 0) report(static_cast<double>(progress.done) / static_cast<double>(progress.total));
    };
    const workflow::MeasureReport report_of_image = workflow::measure(request, observer);
    *made = {picture::target_table(report_of_image), workflow::csv_of(report_of_image)};
  });
}

void TargetList::end(JobEnd end, const QString& failure) {
  progress_->hide();
  cancel_->hide();
  if (again_) return measure(image_);
  if (image_.empty()) return;
  if (end == JobEnd::done) shown_ = *made_;
  if (end == JobEnd::failed) problems_->show_texts(core::Severity::error, {failure});
  fill();
  if (end == JobEnd::cancelled) {
    summary_->setText(tr("Not measured: it was cancelled"));
    cancel_->setText(tr("Measure Again"));
    cancel_->show();
  }
  emit measured();
}

void TargetList::fill() {
  const QSignalBlocker quiet(list_);
  list_->setSortingEnabled(false);
  list_->clear();
  list_->setColumnCount(static_cast<int>(shown_.table.columns.size()));
  list_->setRowCount(static_cast<int>(shown_.table.rows.size()));
  for (std::size_t c = 0; c < shown_.table.columns.size(); ++c) {
    auto* const heading = new QTableWidgetItem(text_of(shown_.table.columns[c]));
    heading->setToolTip(text_of(shown_.table.meanings[c]));
    list_->setHorizontalHeaderItem(static_cast<int>(c), heading);
  }
  for (std::size_t r = 0; r < shown_.table.rows.size(); ++r)
    for (std::size_t c = 0; c < shown_.table.columns.size(); ++c) {
      auto* const item = new NumberItem(read_out(shown_.table.rows[r].words[c]), shown_.table.rows[r].values[c]);
      item->setData(row_role, static_cast<qulonglong>(r));
      list_->setItem(static_cast<int>(r), static_cast<int>(c), item);
    }
  list_->setSortingEnabled(true);
  list_->sortByColumn(0, Qt::AscendingOrder);
  list_->resizeColumnsToContents();
  summary_->setText(text_of(shown_.table.summary));
  for (QPushButton* button : {copy_, save_}) button->setEnabled(!shown_.table.rows.empty());
}

std::optional<std::size_t> TargetList::chosen() const {
  const QList<QTableWidgetItem*> items = list_->selectedItems();
  if (items.isEmpty()) return std::nullopt;
  return static_cast<std::size_t>(items.front()->data(row_role).toULongLong());
}

void TargetList::choose(std::size_t row) {
  for (int line = 0; line < list_->rowCount(); ++line)
    if (list_->item(line, 0)->data(row_role).toULongLong() == row) {
      list_->selectRow(line);
      list_->scrollToItem(list_->item(line, 0));
    }
}

void TargetList::copy() { QApplication::clipboard()->setText(text_of(picture::text_of(shown_.table))); }

void TargetList::save() {
  const QString name = ask_name();
  if (name.isEmpty()) return;
  try {
    scene::write_text_file(name.toStdString(), shown_.csv);
    problems_->show_texts(core::Severity::note, {tr("Saved %1").arg(name)});
  } catch (const std::exception& error) {
    problems_->show_texts(core::Severity::error, {QString::fromUtf8(error.what())});
  }
}

}  // namespace sarsim::gui

#include "gui/echo/radar_view_window.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSaveFile>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

#include "gui/common/figure_plot.hpp"
#include "gui/common/named.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/echo/simulation_window.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "workflow/record/plan_recording.hpp"

namespace sarsim::gui {

namespace {

constexpr std::array views{picture::RadarView::range_profile, picture::RadarView::range_doppler,
                           picture::RadarView::doppler_time, picture::RadarView::spectrum,
                           picture::RadarView::phase_history};
constexpr std::size_t usual_spectra = 16;  // one after another, of Doppler against time
constexpr int max_pulses = 1'000'000;
constexpr int max_padding = 16;
constexpr int settling_ms = 60;  // of a drag

QString title_text(picture::RadarView view) {
  const std::string_view title = picture::title_of(view);
  return QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size()));
}

// A view of how frequencies change wants more than one spectrum.
void take_enough_pulses(picture::RadarViewChoice& choice) {
  if (choice.view == picture::RadarView::doppler_time)
    choice.pulses = std::max(choice.pulses, usual_spectra * choice.interval);
}

}  // namespace

struct RadarViewWindow::Result {
  core::Problems problems;
  picture::Figure figure;
};

RadarViewWindow::RadarViewWindow(SimulationWindow& from, picture::RadarView view) : QWidget(&from), from_(from) {
  setObjectName("radar_view");
  setWindowFlag(Qt::Window);
  setAttribute(Qt::WA_DeleteOnClose);
  choice_.view = view;
  take_enough_pulses(choice_);
  auto* const column = new QVBoxLayout(this);
  auto* const controls = new QHBoxLayout;
  make_controls(controls);
  plot_ = named(new FigurePlot(this), "radar_view_plot", tr("The view as a figure"), {});
  problems_ = new ProblemLine(this);
  problems_->setObjectName("radar_view_problems");
  auto* const foot = new QHBoxLayout;
  make_foot(foot);
  column->addLayout(controls);
  column->addWidget(problems_);
  column->addWidget(plot_, 1);
  column->addLayout(foot);
  debounce_.setSingleShot(true);
  connect(&debounce_, &QTimer::timeout, this, &RadarViewWindow::compute);
  connect(&from_, &SimulationWindow::changed, this, &RadarViewWindow::compute_soon);
  connect(&work_, &LatestOnlyWork::ended, this, &RadarViewWindow::show_result);
  show_choice();
  resize(820,
         view == picture::RadarView::range_doppler ? 740 : 560);  // Two pictures below each other, one of them a map.
  compute_soon();
}

void RadarViewWindow::make_controls(QHBoxLayout* row) {
  view_ = named(new QComboBox(this), "radar_view_kind", tr("View"), tr("Quantity shown"));
  for (const picture::RadarView view : views) view_->addItem(title_text(view));
  pulses_label_ = new QLabel(tr("&Pulses"), this);
  pulses_ = named(new QSpinBox(this), "radar_view_pulses", tr("Pulses"),
                  tr("How many about the cursor: the burst, or the coherent interval"));
  pulses_->setRange(1, max_pulses);
  pulses_->setKeyboardTracking(false);
  pulses_label_->setBuddy(pulses_);
  interval_label_ = new QLabel(tr("Puls&es of a spectrum"), this);
  interval_ = named(new QSpinBox(this), "radar_view_interval", tr("Pulses of a spectrum"),
                    tr("More give finer Doppler resolution, fewer finer time resolution"));
  interval_->setRange(2, max_pulses);
  interval_->setKeyboardTracking(false);
  interval_label_->setBuddy(interval_);
  mean_ = named(new QComboBox(this), "radar_view_mean", tr("Mean"),
                tr("Of the power, or coherent: what keeps its phase from pulse to pulse"));
  mean_->addItems({tr("Mean power"), tr("Coherent mean")});
  window_ = named(new QComboBox(this), "radar_view_window", tr("Window"), tr("Window (weighting) of the spectrum"));
  window_->addItems({tr("Rectangular"), tr("Hann"), tr("Hamming")});
  padding_label_ = new QLabel(tr("&Bins per pulse"), this);
  padding_ = named(new QSpinBox(this), "radar_view_padding", tr("Bins per pulse"),
                   tr("Above 1, Doppler bins are closer together (zero padding)"));
  padding_->setRange(1, max_padding);
  padding_->setKeyboardTracking(false);
  padding_label_->setBuddy(padding_);
  decibels_ = named(new QCheckBox(tr("&Decibels"), this), "radar_view_decibels", tr("Decibels"), {});
  unwrapped_ = named(new QCheckBox(tr("&Unwrapped"), this), "radar_view_unwrapped", tr("Unwrapped"),
                     tr("Adds full turns so that no phase step exceeds 180 deg"));
  for (QWidget* widget :
       std::initializer_list<QWidget*>{view_, pulses_label_, pulses_, interval_label_, interval_, mean_, window_,
                                       padding_label_, padding_, decibels_, unwrapped_})
    row->addWidget(widget);
  row->addStretch(1);
  for (QComboBox* box : {view_, mean_, window_})
    connect(box, &QComboBox::activated, this, &RadarViewWindow::take_choice);
  for (QSpinBox* box : {pulses_, interval_, padding_})
    connect(box, &QSpinBox::valueChanged, this, &RadarViewWindow::take_choice);
  for (QCheckBox* box : {decibels_, unwrapped_}) connect(box, &QCheckBox::toggled, this, &RadarViewWindow::take_choice);
}

void RadarViewWindow::make_foot(QHBoxLayout* row) {
  progress_ = named(new QProgressBar(this), "radar_view_progress", tr("The view is being computed"), {});
  progress_->setRange(0, 0);
  progress_->setMaximumWidth(fontMetrics().averageCharWidth() * 20);
  QSizePolicy kept = progress_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(kept);
  progress_->hide();
  row->addWidget(progress_);
  row->addStretch(1);
  const auto add_button = [&](const QString& text, const char* name, const QString& tip, const auto& work) {
    auto* const button = named(new QPushButton(text, this), name, tip, tip);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, work);
    row->addWidget(button);
  };
  add_button(tr("&Copy Picture"), "radar_view_copy_picture", tr("The figure to the clipboard"),
             [this] { copy_picture(); });
  add_button(tr("Copy &Values"), "radar_view_copy_values", tr("The curves to the clipboard, for a spreadsheet"),
             [this] { copy_values(); });
  add_button(tr("S&ave Values..."), "radar_view_save_values", tr("The curves as CSV"), [this] { save_values(); });
  add_button(tr("&Save Picture..."), "radar_view_save_picture", tr("The figure as PNG, SVG or PDF"),
             [this] { save_picture(); });
}

void RadarViewWindow::set_choice(const picture::RadarViewChoice& choice) {
  if (choice == choice_) return;
  choice_ = choice;
  show_choice();
  compute_soon();
}

// Shows the choices that the view has.
void RadarViewWindow::show_choice() {
  showing_ = true;
  view_->setCurrentIndex(static_cast<int>(choice_.view));
  pulses_->setValue(static_cast<int>(choice_.pulses));
  interval_->setValue(static_cast<int>(choice_.interval));
  mean_->setCurrentIndex(choice_.mean == picture::ProfileMean::coherent ? 1 : 0);
  window_->setCurrentIndex(static_cast<int>(choice_.window));
  padding_->setValue(static_cast<int>(choice_.padding));
  decibels_->setChecked(choice_.decibels);
  unwrapped_->setChecked(choice_.unwrapped);
  showing_ = false;
  const picture::RadarView view = choice_.view;
  for (QWidget* widget : std::initializer_list<QWidget*>{pulses_label_, pulses_})
    widget->setVisible(view != picture::RadarView::spectrum);
  mean_->setVisible(view == picture::RadarView::range_profile);
  const bool map = view == picture::RadarView::range_doppler || view == picture::RadarView::doppler_time;
  window_->setVisible(map || view == picture::RadarView::spectrum);
  for (QWidget* widget : std::initializer_list<QWidget*>{padding_label_, padding_}) widget->setVisible(map);
  for (QWidget* widget : std::initializer_list<QWidget*>{interval_label_, interval_})
    widget->setVisible(view == picture::RadarView::doppler_time);
  decibels_->setVisible(view == picture::RadarView::range_profile || view == picture::RadarView::spectrum);
  unwrapped_->setVisible(view == picture::RadarView::phase_history);
  setWindowTitle(title_text(view) + QStringLiteral(" - ") + from_.windowTitle());
}

void RadarViewWindow::take_choice() {
  if (showing_) return;
  picture::RadarViewChoice choice = choice_;
  choice.view = views.at(static_cast<std::size_t>(view_->currentIndex()));
  choice.pulses = static_cast<std::size_t>(pulses_->value());
  choice.interval = static_cast<std::size_t>(interval_->value());
  if (choice_.view != choice.view) take_enough_pulses(choice);
  choice.mean = mean_->currentIndex() == 1 ? picture::ProfileMean::coherent : picture::ProfileMean::power;
  choice.window = static_cast<picture::SpectrumWindow>(window_->currentIndex());
  choice.padding = static_cast<std::size_t>(padding_->value());
  choice.decibels = decibels_->isChecked();
  choice.unwrapped = unwrapped_->isChecked();
  set_choice(choice);
}

void RadarViewWindow::compute_soon() {
  complete_ = false;
  debounce_.start(settling_ms);
}

void RadarViewWindow::compute() {
  const EchoPlot::Cursor place = from_.place();
  choice_.range_m = place.range_m;
  choice_.time_s = place.time_s;
  setWindowTitle(title_text(choice_.view) + QStringLiteral(" - ") + from_.windowTitle());
  result_ = std::make_shared<Result>();
  progress_->show();
  work_.run([scene = from_.scene(), simulation = from_.simulation(), choice = choice_, into = result_](
                const core::StopFlag& stop, const BackgroundJob::Report&) {
    const workflow::PlannedRecording planned = workflow::plan_recording(*scene, simulation, &stop);
    into->problems = planned.problems;
    if (!planned.plan) return;
    try {
      into->figure = picture::radar_figure(*planned.plan, choice, {core::thread_count(0), &stop});
    } catch (const simulate::ImpossibleEcho& error) {
      into->problems.push_back(error.problem);
    }
  });
}

void RadarViewWindow::show_result(bool good, const QString& failure) {
  progress_->hide();
  complete_ = !debounce_.isActive();
  QStringList texts;
  if (!good) texts << failure;
  for (const core::Problem& problem : result_->problems) texts << problem_text(problem);
  if (texts.isEmpty()) {
    problems_->clear();
    plot_->set_figure(result_->figure);
  } else {
    problems_->show_texts(core::Severity::error, texts.mid(0, 5));
    plot_->set_figure({});
  }
  emit finished();
}

void RadarViewWindow::copy_picture() { QApplication::clipboard()->setPixmap(plot_->grab()); }

void RadarViewWindow::copy_values() {
  QApplication::clipboard()->setText(QString::fromStdString(picture::curves_table(plot_->figure(), '\t')));
}

QString RadarViewWindow::suggested_file(const char* ending) const {
  return title_text(choice_.view).toLower().replace(' ', '-') + QLatin1String(ending);
}

void RadarViewWindow::save_values(const QString& path) {
  const QString file = path.isEmpty() ? QFileDialog::getSaveFileName(this, tr("Save values"), suggested_file(".csv"),
                                                                     tr("Tables (*.csv)"))
                                      : path;
  if (file.isEmpty()) return;
  const std::string text = picture::curves_table(plot_->figure(), ',');
  QSaveFile out(file);
  const auto size = static_cast<qint64>(text.size());
  if (out.open(QIODevice::WriteOnly) && out.write(text.data(), size) == size && out.commit()) return;
  QMessageBox::warning(this, tr("Save values"), tr("%1 cannot be written: %2.").arg(file, out.errorString()));
}

void RadarViewWindow::save_picture(const QString& path) {
  const QString file = path.isEmpty() ? QFileDialog::getSaveFileName(this, tr("Save picture"), suggested_file(".png"),
                                                                     tr("Pictures (*.png *.svg *.pdf)"))
                                      : path;
  if (file.isEmpty()) return;
  QString failure;
  if (!plot_->save(file, plot_->size(), devicePixelRatioF(), failure))
    QMessageBox::warning(this, tr("Save picture"), failure);
}

}  // namespace sarsim::gui

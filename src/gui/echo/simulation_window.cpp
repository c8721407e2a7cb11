#include "gui/echo/simulation_window.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "gui/common/figure_plot.hpp"
#include "gui/common/flow_layout.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/reserved_label.hpp"
#include "gui/common/text.hpp"
#include "gui/echo/echo_controls.hpp"
#include "gui/echo/radar_view_window.hpp"
#include "picture/echo/echo_figure.hpp"
#include "picture/echo/echo_readout.hpp"
#include "scene/check/check_objects.hpp"
#include "scene/edit/edit.hpp"
#include "scene/schema/quantity.hpp"
#include "simulate/resolve/conventions.hpp"

namespace sarsim::gui {

namespace {

constexpr int progress_steps = 1000;
constexpr int progress_after_ms = 300;

const scene::Radar* radar_of(const scene::Scene& scene, const picture::EchoWindow& window) {
  const auto found = std::ranges::find(scene.radars, window.recording.radar, &scene::Radar::name);
  return found == scene.radars.end() ? nullptr : &*found;
}

QString read_out_text(const picture::ReadOut& read) {
  QStringList parts;
  for (const picture::ReadOutLine& line : picture::lines_of(read))
    parts << text_of(line.name) + " " + text_of(line.value);
  return parts.join(QStringLiteral("   "));
}

QString difference_text(const picture::CursorDifference& d) {
  constexpr int digits = 9;
  const auto text = [](double value, scene::Quantity kind) {
    return read_out(scene::quantity_text(core::tidy(value, digits), kind));
  };
  QStringList parts{"Range " + text(d.range_m, scene::Quantity::length),
                    "Delay " + text(d.delay_s, scene::Quantity::time), "Time " + text(d.time_s, scene::Quantity::time),
                    QStringLiteral("Pulses %1").arg(d.pulses)};
  if (std::isfinite(d.level_db)) parts << QStringLiteral("Level %1 dB").arg(d.level_db, 0, 'f', 2);
  parts << QStringLiteral("Phase %1 deg").arg(d.phase_deg, 0, 'f', 2);
  if (std::isfinite(d.range_rate_mps)) parts << QStringLiteral("Range rate %1 m/s").arg(d.range_rate_mps, 0, 'g', 5);
  return parts.join(QStringLiteral("   "));
}

ReservedLabel* foot_label(QWidget* parent, const char* name, int lines) {
  auto* const label = new ReservedLabel(lines, parent);
  label->setObjectName(name);
  return label;
}

}  // namespace

SimulationWindow::SimulationWindow(Session& session, picture::EchoWindow window, bool show_all, QWidget* parent)
    : QWidget(parent), session_(session), document_(session.number()), window_(std::move(window)), show_all_(show_all) {
  setObjectName("simulation_window");
  scene_ = session_.shared_scene();
  controls_ = new EchoControls(this);
  plot_ = new EchoPlot(this);
  cuts_ = new FigurePlot(this);
  cuts_->setObjectName("echo_cuts");
  cuts_->hide();
  problems_ = new ProblemLine(this);
  problems_->setObjectName("echo_problems");
  auto* const area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setObjectName("echo_controls_area");
  area->setWidget(controls_);
  area->setMinimumWidth(controls_->sizeHint().width() + area->verticalScrollBar()->sizeHint().width());
  auto* const right = new QWidget(this);
  auto* const column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  auto* const pictures = new QSplitter(Qt::Vertical, right);
  pictures->addWidget(plot_);
  pictures->addWidget(cuts_);
  pictures->setStretchFactor(0, 3);
  pictures->setStretchFactor(1, 1);
  column->addWidget(make_tool_row());
  column->addWidget(problems_);
  column->addWidget(pictures, 1);
  column->addWidget(make_foot());
  auto* const split = new QSplitter(this);
  connect(settings_, &QToolButton::toggled, area, &QWidget::setVisible);
  split->addWidget(area);
  split->addWidget(right);
  split->setStretchFactor(1, 1);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(split);
  preview_ = std::make_unique<picture::Preview>([this](const picture::PreviewEvent& event) { take_event(event); });
  connect_all();
  show_state();
}

SimulationWindow::~SimulationWindow() = default;

void SimulationWindow::show_settings(bool shown) { settings_->setChecked(shown); }

QToolButton* SimulationWindow::add_tool(QWidget* row, const QString& text, const char* name, const QString& tip) {
  auto* const button = new QToolButton(row);
  button->setText(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  row->layout()->addWidget(button);
  return button;
}

QWidget* SimulationWindow::make_tool_row() {
  auto* const row = new QWidget(this);
  new FlowLayout(row);
  settings_ = add_tool(row, tr("Settings"), "echo_settings", tr("Radar, limits, sampling and colours"));
  settings_->setCheckable(true);
  settings_->setChecked(true);
  back_ = add_tool(row, tr("Back"), "echo_back", tr("Previous View (Backspace)"));
  forward_ = add_tool(row, tr("Forward"), "echo_forward", tr("Next View (after going back)"));
  connect(back_, &QToolButton::clicked, this, &SimulationWindow::go_back);
  connect(forward_, &QToolButton::clicked, this, &SimulationWindow::go_forward);
  auto* const all = add_tool(row, tr("Show All Targets"), "echo_show_all",
                             tr("Choose the ranges so that all targets are seen (Home)"));
  connect(all, &QToolButton::clicked, this, &SimulationWindow::show_all_targets);
  show_cuts_ =
      add_tool(row, tr("Cuts"), "echo_show_cuts", tr("Graphs along range and azimuth through the first cursor"));
  show_cuts_->setCheckable(true);
  connect(show_cuts_, &QToolButton::toggled, this, &SimulationWindow::show_cuts);
  add_views_menu(row);
  progress_ = new QProgressBar(row);
  progress_->setObjectName("echo_progress");
  progress_->setAccessibleName(tr("Share of the picture that is computed"));
  progress_->setRange(0, progress_steps);
  progress_->setFixedWidth(fontMetrics().averageCharWidth() * 16);
  // Its coming and going must not change the size of the plot, which would be computed anew.
  QSizePolicy kept = progress_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(kept);
  progress_->hide();
  row->layout()->addWidget(progress_);
  return row;
}

void SimulationWindow::add_views_menu(QWidget* row) {
  auto* const button = add_tool(
      row, tr("Views"), "echo_views",
      tr("Other views of the same samples: range profile, range-Doppler map, Doppler against time, spectrum, phase"));
  auto* const menu = new QMenu(button);
  for (const picture::RadarView view :
       {picture::RadarView::range_profile, picture::RadarView::range_doppler, picture::RadarView::doppler_time,
        picture::RadarView::spectrum, picture::RadarView::phase_history}) {
    const std::string_view title = picture::title_of(view);
    menu->addAction(QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size())), this,
                    [this, view] { open_radar_view(view); });
  }
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
}

RadarViewWindow* SimulationWindow::open_radar_view(picture::RadarView view) {
  auto* const window = new RadarViewWindow(*this, view);
  window->show();
  return window;
}

QWidget* SimulationWindow::make_foot() {
  auto* const foot = new QWidget(this);
  auto* const layout = new QVBoxLayout(foot);
  layout->setContentsMargins(0, 0, 0, 0);
  warning_ = foot_label(foot, "echo_warning", 2);
  read_out_ = foot_label(foot, "echo_read_out", 2);
  difference_ = foot_label(foot, "echo_difference", 2);
  highest_ = new QLabel(foot);
  highest_->setObjectName("echo_highest");
  highest_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  highest_->setMinimumWidth(1);  // What does not fit is cut before the picture is.
  for (QLabel* label : {warning_, read_out_, difference_}) layout->addWidget(label);
  auto* const row = new QWidget(foot);
  auto* const buttons = new FlowLayout(row);
  layout->addWidget(highest_);
  const auto button = [&](const QString& text, const char* name, const QString& tip, auto slot) {
    auto* const made = new QPushButton(text, row);
    made->setObjectName(name);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setAutoDefault(false);
    connect(made, &QPushButton::clicked, this, slot);
    buttons->addWidget(made);
  };
  button(tr("Copy Picture"), "echo_copy_picture", tr("The picture to the clipboard"), &SimulationWindow::copy_picture);
  button(tr("Copy Values"), "echo_copy_values",
         tr("The samples of the pulse at the first cursor to the clipboard, for a spreadsheet"),
         &SimulationWindow::copy_values);
  button(tr("Save Picture..."), "echo_save_picture", tr("The picture with its axes as PNG, SVG or PDF"),
         &SimulationWindow::save_picture);
  button(tr("Store"), "echo_store",
         tr("Keep these settings in the script, as a simulation that can be shown and run again"),
         &SimulationWindow::store_simulation);
  button(tr("Save Data..."), "echo_save_data",
         tr("Write the samples to a file, or the settings to the script, or both"),
         [this] { emit save_data_wanted(simulation()); });
  layout->addWidget(row);
  return foot;
}

void SimulationWindow::connect_all() {
  debounce_.setSingleShot(true);
  connect(&debounce_, &QTimer::timeout, this, &SimulationWindow::compute);
  connect(&session_, &Session::scene_changed, this, &SimulationWindow::follow_scene);
  connect(controls_, &EchoControls::edited, this, [this](const picture::EchoWindow& window) { take_state(window); });
  connect(controls_, &EchoControls::view_typed, this, &SimulationWindow::go_to);
  connect(controls_, &EchoControls::link_changed, this,
          [this] { emit view_changed(picture::view_of(window_), controls_->link()); });
  connect(plot_, &EchoPlot::view_wanted, this, &SimulationWindow::go_to);
  connect(plot_, &EchoPlot::drag_began, this, [this] { history_.leave(picture::view_of(window_)); });
  connect(plot_, &EchoPlot::view_dragged, this, [this](const picture::EchoView& view) { change_view(view); });
  connect(plot_, &EchoPlot::back_wanted, this, &SimulationWindow::go_back);
  connect(plot_, &EchoPlot::whole_wanted, this, &SimulationWindow::show_all_targets);
  connect(plot_, &EchoPlot::resized, this, &SimulationWindow::compute_soon);
  connect(plot_, &EchoPlot::hovered, this, &SimulationWindow::show_read_out);
  connect(plot_, &EchoPlot::cursors_changed, this, [this] {
    show_read_out();
    show_cuts();
    emit changed();
  });
}

void SimulationWindow::put_aside(bool aside) {
  if (aside) preview_->cancel();
  setAttribute(Qt::WA_ShowWithoutActivating);  // Whoever turned to the document goes on in the main window.
  if (isWindow()) setVisible(!aside);
  for (RadarViewWindow* view : findChildren<RadarViewWindow*>()) view->setVisible(!aside);
  emit set_aside(aside);
}

// Recordings and tables make no echoes, nor do comments of the script.
void SimulationWindow::follow_scene(const scene::SceneChange& change) {
  if (session_.number() != document_) return;
  const bool other_echoes = change.options || std::ranges::any_of(scene::all_object_kinds, [&](scene::ObjectKind kind) {
                              return !scene::belongs_to_radar(kind) && change.concerns(kind);
                            });
  if (!other_echoes) return;
  follow_radar(change);
  scene_ = session_.shared_scene();
  show_state();
  compute_soon();
  emit changed();
}

// The radar is known by its name, which the edit may have changed.
void SimulationWindow::follow_radar(const scene::SceneChange& change) {
  const std::size_t before = scene::find_radar(*scene_, window_.recording.radar);
  if (before == scene::not_found) return;
  const auto now = change.moved({scene::ObjectKind::radar, before});
  if (now && scene::has_object(session_.scene(), *now))
    window_.recording.radar = session_.scene().radars[now->index].name;
}

double SimulationWindow::bandwidth_hz() const {
  const scene::Radar* const radar = radar_of(*scene_, window_);
  return radar == nullptr ? 0.0 : scene::nominal_bandwidth_hz(*radar).value_or(0.0);
}

double SimulationWindow::largest_v() const { return finished_ ? plot_->colours().statistics.largest_v : 0.0; }

EchoPlot::Cursor SimulationWindow::place() const {
  if (const auto& cursor = plot_->cursor(0)) return *cursor;
  const picture::EchoView view = picture::view_of(window_);
  return {0.5 * (view.range_start_m + view.range_end_m), 0.5 * (view.time_start_s + view.time_end_s)};
}

scene::Simulation SimulationWindow::simulation() const { return picture::simulation_of(window_, bandwidth_hz()); }

QString SimulationWindow::title() const {
  const QString kind = window_.recording.processing == scene::Processing::raw ? tr("Raw return")
                       : window_.recording.processing == scene::Processing::matched_filter
                           ? tr("Range compressed")
                           : tr("Synthetic range profiles");
  return kind + QStringLiteral(" - ") + text_of(window_.recording.radar);
}

bool SimulationWindow::complete() const { return finished_; }

void SimulationWindow::take_state(const picture::EchoWindow& window) {
  const bool again = picture::needs_computing(window_, window);
  const bool moved = picture::view_of(window_) != picture::view_of(window);
  window_ = window;
  show_state();
  if (moved) emit view_changed(picture::view_of(window_), controls_->link());
  if (again)
    compute_soon();
  else
    show_cuts();
  if (again) emit changed();
}

void SimulationWindow::change_view(const picture::EchoView& view) {
  picture::EchoWindow changed = window_;
  picture::set_view(changed, view);
  if (changed == window_) return;
  take_state(changed);
}

void SimulationWindow::go_to(const picture::EchoView& view) {
  if (view == picture::view_of(window_)) return;
  history_.leave(picture::view_of(window_));
  change_view(view);
}

void SimulationWindow::go_back() { change_view(history_.back(picture::view_of(window_))); }

void SimulationWindow::go_forward() { change_view(history_.forward(picture::view_of(window_))); }

void SimulationWindow::follow(const picture::EchoView& view, picture::AxisLink link) {
  const picture::AxisLink own = controls_->link();
  change_view(picture::linked(picture::view_of(window_), view, {own.range && link.range, own.time && link.time}));
}

void SimulationWindow::show_all_targets() {
  show_all_ = true;
  history_.leave(picture::view_of(window_));
  compute();
}

void SimulationWindow::compute_soon() {
  // At once, but once for all that changed in one turn of the event loop.
  if (!debounce_.isActive()) debounce_.start(0);
}

void SimulationWindow::compute() {
  if (!isVisible() && testAttribute(Qt::WA_WState_ExplicitShowHide)) return;
  finished_ = false;
  computing_ = radar_of(*scene_, window_) != nullptr;
  if (!computing_) {
    preview_->cancel();
    progress_->hide();
    plot_->set_matrix(nullptr);
    problems_->show_texts(
        core::Severity::error,
        {tr("The scene has no radar '%1'; choose another one").arg(text_of(window_.recording.radar))});
    return;
  }
  request_ = preview_->show({scene_, window_, plot_->plot_size(), simulate::Engine::automatic, show_all_});
  QTimer::singleShot(progress_after_ms, this,
                     [this, request = request_] { progress_->setVisible(computing_ && request == request_); });
}

// On a thread that computes: only the newest is kept, and looked at when the window has time for it.
void SimulationWindow::take_event(const picture::PreviewEvent& event) {
  const std::scoped_lock hold(lock_);
  const bool waiting = latest_.has_value();
  latest_ = event;
  if (!waiting) QMetaObject::invokeMethod(this, &SimulationWindow::show_event, Qt::QueuedConnection);
}

void SimulationWindow::show_event() {
  picture::PreviewEvent event;
  {
    const std::scoped_lock hold(lock_);
    if (!latest_) return;
    event = std::move(*latest_);
    latest_.reset();
  }
  if (event.request != request_) return;
  if (event.kind == picture::PreviewEvent::Kind::failed) {
    show_failure(event.problems);
    return;
  }
  problems_->clear();
  if (show_all_ && event.matrix) {
    show_all_ = false;
    picture::set_view(window_, picture::view_of(event.matrix->window()));
    show_state();
    emit view_changed(picture::view_of(window_), controls_->link());
    emit changed();
  }
  finished_ = event.kind == picture::PreviewEvent::Kind::finished;
  if (event.matrix && event.matrix->ready_rows() > 0) plot_->set_matrix(event.matrix);
  if (event.matrix && event.matrix->rows() > 0) {
    progress_->setValue(static_cast<int>(progress_steps * event.matrix->ready_rows() / event.matrix->rows()));
    const std::string warning =
        picture::sampling_warning(window_, event.matrix->plan().acquisition.simulation.sample_rate_hz, bandwidth_hz());
    warning_->say(text_of(warning));
  }
  highest_->setText(text_of(picture::highest_magnitude_text(plot_->colours().statistics)));
  show_read_out();
  show_cuts();
  if (!finished_) return;
  computing_ = false;
  progress_->hide();
  emit finished();
}

void SimulationWindow::show_failure(const core::Problems& problems) {
  finished_ = false;
  computing_ = false;
  progress_->hide();
  plot_->set_matrix(nullptr);
  highest_->setText(tr("Highest magnitude: unknown"));
  QStringList texts;
  for (const core::Problem& problem : problems) texts << problem_text(problem);
  problems_->show_texts(core::Severity::error, texts.mid(0, 5));
}

void SimulationWindow::show_state() {
  setWindowTitle(title());
  controls_->show_window(window_, *scene_);
  plot_->set_window(window_, simulate::conventions_of(scene_->options.profile).light_speed_mps);
  back_->setEnabled(history_.can_go_back());
  forward_->setEnabled(history_.can_go_forward());
}

void SimulationWindow::show_read_out() {
  const auto at = plot_->read_out_at(plot_->mapFromGlobal(QCursor::pos()));
  const auto first = plot_->read_out_at_cursor(0);
  const auto second = plot_->read_out_at_cursor(1);
  read_out_->say(at ? read_out_text(*at) : first ? read_out_text(*first) : QString());
  difference_->say(first && second ? tr("From 1 to 2:   ") + difference_text(picture::difference(*first, *second))
                                   : QString());
}

void SimulationWindow::show_cuts() {
  cuts_->setVisible(show_cuts_->isChecked());
  if (!show_cuts_->isChecked() || !plot_->matrix() || plot_->matrix()->ready_rows() == 0) return;
  const auto at = plot_->read_out_at_cursor(0);
  const picture::EchoMatrix& matrix = *plot_->matrix();
  const std::size_t row = at ? at->row : matrix.nearest_ready()[matrix.rows() / 2];
  cuts_->set_figure(picture::cut_figure(matrix, plot_->colours(), row, at ? at->column : matrix.columns() / 2));
}

picture::Figure SimulationWindow::figure() const {
  picture::Figure figure = plot_->matrix() ? picture::echo_figure(*plot_->matrix(), window_) : picture::Figure();
  figure.title = title().toStdString();
  return figure;
}

void SimulationWindow::copy_picture() { QApplication::clipboard()->setImage(plot_->plot_image()); }

void SimulationWindow::copy_values() {
  if (!plot_->matrix() || plot_->matrix()->ready_rows() == 0) return;
  const auto at = plot_->read_out_at_cursor(0);
  const std::size_t row = at ? at->row : plot_->matrix()->nearest_ready()[plot_->matrix()->rows() / 2];
  QApplication::clipboard()->setText(text_of(picture::pulse_table(*plot_->matrix(), row, '\t')));
}

void SimulationWindow::save_picture() { ask_and_save_picture(*this, figure(), "echoes.png"); }

void SimulationWindow::store_simulation() {
  session_.perform(scene::add_object(session_.scene(), simulation()));
  session_.log(core::Severity::note,
               tr("Stored the settings of the window as simulation %1").arg(session_.scene().simulations.size()));
}

void SimulationWindow::closeEvent(QCloseEvent* event) {
  preview_->cancel();
  QWidget::closeEvent(event);
}

}  // namespace sarsim::gui

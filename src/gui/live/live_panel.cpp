#include "gui/live/live_panel.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/text/number_text.hpp"
#include "gui/common/figure_plot.hpp"
#include "gui/common/named.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/reserved_label.hpp"
#include "gui/common/text.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "picture/live/live_product_file.hpp"
#include "picture/live/live_workflows.hpp"
#include "scene/language/format_mark.hpp"
#include "workflow/focus/focus_options.hpp"

namespace sarsim::gui {

namespace {

using workflow::FocusAlgorithm;

constexpr std::array algorithms{FocusAlgorithm::automatic, FocusAlgorithm::omega_k, FocusAlgorithm::range_doppler,
                                FocusAlgorithm::chirp_scaling, FocusAlgorithm::back_projection};
constexpr std::array maps{picture::ColourMap::ocean, picture::ColourMap::ember, picture::ColourMap::grey};
constexpr int blink_ms = 500;
constexpr int busy_after_ms = 150;  // a bar for less would flicker
constexpr int resized_ms = 80;
// A hand moves faster than images come: each has so long until its first picture before a newer one takes its place.
constexpr int first_picture_ms = 400;
constexpr std::size_t min_px = 64;
constexpr std::size_t max_px = 1200;

QComboBox* narrow_list(QWidget* parent, const QString& name, const QString& spoken, const QString& tip) {
  auto* const list = named(new QComboBox(parent), name, spoken, tip);
  list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list->setMinimumContentsLength(8);
  return list;
}

QToolButton* word_button(QWidget* parent, const QString& text, const QString& name, const QString& tip) {
  auto* const button = named(new QToolButton(parent), name, tip, tip);
  button->setText(text);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  return button;
}

// Takes as little width as the panel has.
ReservedLabel* steady_label(QWidget* parent, const QString& name, int lines) {
  auto* const label = new ReservedLabel(lines, parent);
  label->setObjectName(name);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return label;
}

picture::PlotSize pixels_of(const QWidget& plot) {
  const auto pixels = [&](int length) {
    const auto device = static_cast<std::size_t>(std::max(0.0, length * plot.devicePixelRatioF()));
    return std::clamp(device, min_px, max_px);
  };
  return {pixels(plot.width()), pixels(plot.height())};
}

}  // namespace

LivePanel::LivePanel(Session& session, ImageViewers& viewers, QWidget* parent)
    : QWidget(parent), session_(session), viewers_(viewers) {
  setObjectName("live_panel");
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->setSpacing(4);
  make_choices();
  make_options();
  make_pictures();
  make_foot();
  picture_ = std::make_unique<picture::LivePicture>([this](const picture::LiveEvent& event) { take_event(event); });
  debounce_.setSingleShot(true);
  connect(&debounce_, &QTimer::timeout, this, &LivePanel::compute);
  blink_.setInterval(blink_ms);
  connect(&blink_, &QTimer::timeout, this, [this] {
    before_is_seen_ = !before_is_seen_;
    show_image();
  });
  connect(&session_, &Session::scene_changed, this, [this](const scene::SceneChange& change) {
    if (change.everything) take_kept();
    show_simulations();
    compute_soon();
  });
  connect(&session_, &Session::document_closed, this, [this](int number) { kept_of_.erase(number); });
  connect(&job_, &BackgroundJob::ended, this, &LivePanel::take_end);
  show_simulations();
  show_choices();
}

LivePanel::~LivePanel() {
  job_.disconnect(this);
  picture_.reset();
}

void LivePanel::make_choices() {
  auto* const row = new QHBoxLayout;
  product_ =
      narrow_list(this, "live_product", tr("Product"), tr("What to compute; Automatic chooses what suits the scene"));
  for (const picture::LiveProduct product : picture::live_products)
    product_->addItem(text_of(picture::title_of(product)));
  simulation_ = narrow_list(this, "live_simulation", tr("Recording"), tr("Recording to Process"));
  simulation_->setMinimumContentsLength(4);
  more_ = word_button(this, tr("Options"), "live_more", tr("Algorithm, window, motion compensation, colours"));
  more_->setCheckable(true);
  row->addWidget(product_, 2);
  row->addWidget(simulation_, 1);
  row->addWidget(more_);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
  for (QComboBox* list : {product_, simulation_})
    connect(list, &QComboBox::activated, this, [this] {
      simulation_->setToolTip(tr("Recording to Process: %1").arg(simulation_->currentText()));
      show_choices();
      compute_soon();
    });
}

void LivePanel::make_options() {
  options_ = new QWidget(this);
  auto* const grid = new QGridLayout(options_);
  grid->setContentsMargins(0, 0, 0, 0);
  algorithm_ = narrow_list(options_, "live_algorithm", tr("Algorithm"), tr("How a focused image is made"));
  algorithm_->addItem(tr("automatic"));
  for (std::size_t i = 1; i < algorithms.size(); ++i) algorithm_->addItem(workflow::word_of(algorithms.at(i)));
  window_ = narrow_list(options_, "live_window", tr("Window"), tr("Weighting: lower sidelobes for wider peaks"));
  for (const char* name : workflow::window_words) window_->addItem(name);
  compensation_ = named(new QCheckBox(tr("Motion compensation"), options_), "live_compensation",
                        tr("Motion compensation"), tr("Compensates deviations of the track from a straight line"));
  compensation_->setChecked(true);
  autofocus_ = named(new QCheckBox(tr("Autofocus"), options_), "live_autofocus", tr("Autofocus"),
                     tr("Removes residual phase errors, estimated from the image itself"));
  targets_ =
      named(new QCheckBox(tr("Mark True Positions"), options_), "live_targets", tr("Mark True Positions"),
            tr("Expected positions of the scene's targets in the image, at most %1").arg(picture::max_ringed_targets));
  colours_ = narrow_list(options_, "live_colours", tr("Colours"), tr("Colours of the image"));
  for (const picture::ColourMap map : maps) colours_->addItem(text_of(picture::info_of(map).title));
  span_ = named(new QSpinBox(options_), "live_span", tr("Dynamic Range"),
                tr("Range below the largest magnitude that is shown"));
  span_->setRange(10, 120);
  span_->setSingleStep(5);
  span_->setSuffix(tr(" dB"));
  span_->setValue(50);
  const auto add_titled = [&](const QString& title, QWidget* field, int row, int column) {
    auto* const label = new QLabel(title, options_);
    label->setBuddy(field);
    grid->addWidget(label, row, column);
    grid->addWidget(field, row + 1, column);
  };
  grid->setVerticalSpacing(2);
  add_titled(tr("&Algorithm"), algorithm_, 0, 0);
  add_titled(tr("&Window"), window_, 0, 1);
  add_titled(tr("&Colours"), colours_, 2, 0);
  add_titled(tr("&Dynamic Range"), span_, 2, 1);
  grid->addWidget(compensation_, 4, 0);
  grid->addWidget(autofocus_, 4, 1);
  grid->addWidget(targets_, 5, 0, 1, 2);
  static_cast<QVBoxLayout*>(layout())->addWidget(options_);
  options_->hide();
  connect(more_, &QToolButton::toggled, options_, &QWidget::setVisible);
  for (QComboBox* list : {algorithm_, window_}) connect(list, &QComboBox::activated, this, &LivePanel::compute_soon);
  for (QCheckBox* box : {compensation_, autofocus_, targets_})
    connect(box, &QCheckBox::toggled, this, &LivePanel::compute_soon);
  connect(colours_, &QComboBox::activated, this, &LivePanel::show_image);
  connect(span_, &QSpinBox::valueChanged, this, &LivePanel::show_image);
}

void LivePanel::make_pictures() {
  pictures_ = new QBoxLayout(QBoxLayout::LeftToRight);
  before_ = named(new FigurePlot(this), "live_before", tr("The pinned image"), {});
  plot_ = named(new FigurePlot(this), "live_plot", tr("The image of the current scene"), {});
  for (FigurePlot* plot : {before_, plot_}) {
    plot->setMinimumSize(140, 180);
    pictures_->addWidget(plot, 1);
  }
  before_->hide();
  static_cast<QVBoxLayout*>(layout())->addLayout(pictures_, 1);
  problems_ = steady_label(this, "live_problems", 2);
  layout()->addWidget(problems_);
}

void LivePanel::make_foot() {
  auto* const row = new QHBoxLayout;
  keep_ = word_button(this, tr("Keep"), "live_keep", tr("Pin this image, to compare later ones with it"));
  compare_ = narrow_list(this, "live_compare", tr("Compare"), tr("Comparison with the pinned image"));
  compare_->addItems({tr("Current Only"), tr("Side by side"), tr("Blink"), tr("Difference")});
  progress_ = named(new QProgressBar(this), "live_progress", tr("The image is being computed"), {});
  progress_->setRange(0, 0);
  progress_->setTextVisible(false);
  progress_->setMaximumWidth(fontMetrics().averageCharWidth() * 8);
  QSizePolicy kept = progress_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(kept);
  progress_->hide();
  row->addWidget(keep_);
  row->addWidget(compare_, 1);
  row->addWidget(progress_);
  auto* const menu = new QMenu(this);
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto slot) {
    QAction* const action = menu->addAction(text, this, slot);
    action->setObjectName(name);
    action->setToolTip(tip);
    return action;
  };
  open_ =
      add(tr("&Open in Viewer"), "live_open", tr("All its samples in the image viewer"), &LivePanel::open_in_viewer);
  add(tr("&Save Picture…"), "live_save", tr("The picture with its axes as PNG, SVG or PDF"), &LivePanel::save_picture);
  add(tr("&Copy Picture"), "live_copy", tr("The picture to the clipboard"), &LivePanel::copy_picture);
  add(tr("Copy as Co&mmand"), "live_copy_command", tr("The command that makes the same from a terminal"),
      &LivePanel::copy_command);
  menu->setToolTipsVisible(true);
  auto* const use = word_button(this, tr("Picture"), "live_picture", tr("Open, save or copy the image"));
  use->setMenu(menu);
  use->setPopupMode(QToolButton::InstantPopup);
  row->addWidget(use);
  state_ = steady_label(this, "live_state", 2);
  auto* const column = static_cast<QVBoxLayout*>(layout());
  column->addWidget(state_);
  column->addLayout(row);
  connect(keep_, &QToolButton::clicked, this, &LivePanel::keep);
  connect(compare_, &QComboBox::activated, this, [this] { compare(comparing()); });
}

// The recordings of the scene, by number and radar; the chosen number stays.
void LivePanel::show_simulations() {
  const auto& simulations = session_.scene().simulations;
  QStringList names;
  for (std::size_t i = 0; i < simulations.size(); ++i)
    names << tr("%1: %2").arg(i + 1).arg(text_of(simulations[i].radar));
  const bool same = names.size() == simulation_->count() && [&] {
    for (int i = 0; i < simulation_->count(); ++i)
      if (simulation_->itemText(i) != names[i]) return false;
    return true;
  }();
  if (!same) {
    const int chosen = std::max(0, simulation_->currentIndex());
    simulation_->clear();
    simulation_->addItems(names);
    simulation_->setCurrentIndex(std::min(chosen, simulation_->count() - 1));
  }
  simulation_->setToolTip(tr("Recording to Process: %1").arg(simulation_->currentText()));
  simulation_->setVisible(simulation_->count() > 1);
  show_choices();
}

// Algorithm and motion are choices of focused images.
void LivePanel::show_choices() {
  const auto simulation = static_cast<std::size_t>(std::max(0, simulation_->currentIndex()));
  picture::LiveProduct product = picture::live_products.at(static_cast<std::size_t>(product_->currentIndex()));
  if (product == picture::LiveProduct::automatic && simulation < session_.scene().simulations.size())
    product = picture::suitable_product(session_.scene(), simulation);
  for (QWidget* widget : std::initializer_list<QWidget*>{algorithm_, compensation_, autofocus_, targets_})
    widget->setEnabled(product == picture::LiveProduct::focused);
}

picture::LiveRequest LivePanel::request() const {
  picture::LiveRequest request;
  request.scene = session_.shared_scene();
  request.simulation = static_cast<std::size_t>(std::max(0, simulation_->currentIndex()));
  request.options.product = picture::live_products.at(static_cast<std::size_t>(product_->currentIndex()));
  request.options.algorithm = algorithms.at(static_cast<std::size_t>(algorithm_->currentIndex()));
  request.options.window = signal::window_from_text(window_->currentText().toStdString()).value_or(signal::SarWindow{});
  request.options.compensation = compensation_->isChecked();
  request.options.autofocus = autofocus_->isChecked();
  request.options.targets = targets_->isChecked();
  request.size = pixels_of(*plot_);
  return request;
}

LivePanel::Compare LivePanel::comparing() const {
  return kept_ ? static_cast<Compare>(compare_->currentIndex()) : Compare::off;
}

picture::LiveLook LivePanel::look() const {
  return {maps.at(static_cast<std::size_t>(colours_->currentIndex())), static_cast<double>(span_->value())};
}

QString LivePanel::command() const {
  const std::filesystem::path path = session_.document().path();
  const std::string script =
      path.empty() ? "scene." + scene::usual_ending(session_.document().text()) : path.filename().string();
  const picture::LiveRequest wanted = request();
  if (wanted.simulation >= wanted.scene->simulations.size()) return {};
  return "sarsim " + text_of(picture::live_command(wanted, script));
}

void LivePanel::compute_soon() {
  complete_ = false;
  if (!debounce_.isActive() && isVisible()) debounce_.start(0);
}

void LivePanel::compute() {
  if (!isVisible()) return;
  if (nothing_yet_ && !asked_.hasExpired(first_picture_ms)) {
    debounce_.start(std::max(1, first_picture_ms - static_cast<int>(asked_.elapsed())));
    return;
  }
  const picture::LiveRequest wanted = request();
  if (wanted.simulation >= wanted.scene->simulations.size()) {
    picture_->cancel();
    nothing_yet_ = false;
    image_.reset();
    complete_ = true;
    progress_->hide();
    show_image();
    problems_->say(tr("No recording yet: create one under Recordings, with New."));
    emit finished();
    return;
  }
  nothing_yet_ = true;
  asked_.start();
  request_ = picture_->show(wanted);
  QTimer::singleShot(busy_after_ms, this,
                     [this, number = request_] { progress_->setVisible(!complete_ && number == request_); });
}

// On the thread that computes: the newest is kept, and looked at when the window has time for it.
void LivePanel::take_event(const picture::LiveEvent& event) {
  if (event.kind == picture::LiveEvent::Kind::started) return;
  const std::scoped_lock hold(lock_);
  const bool waiting = latest_.has_value();
  latest_ = event;
  if (!waiting) QMetaObject::invokeMethod(this, &LivePanel::show_event, Qt::QueuedConnection);
}

void LivePanel::show_event() {
  picture::LiveEvent event;
  {
    const std::scoped_lock hold(lock_);
    if (!latest_) return;
    event = std::move(*latest_);
    latest_.reset();
  }
  const bool newest = event.request == request_ && !debounce_.isActive();
  if (event.request == request_) nothing_yet_ = false;
  if (debounce_.isActive()) debounce_.start(0);
  // An image that came while the hand went on is shown all the same: it is the newest that there is.
  if (event.kind == picture::LiveEvent::Kind::failed) {
    if (!newest) return;
    image_.reset();
  } else {
    image_ = event.image;
  }
  if (event.kind != picture::LiveEvent::Kind::image) rings_ = image_ ? image_->targets : decltype(rings_)();
  complete_ = newest && event.kind != picture::LiveEvent::Kind::image;
  show_image();
  if (event.kind == picture::LiveEvent::Kind::failed)
    show_problems(event.problems);
  else if (event.kind == picture::LiveEvent::Kind::finished)
    show_problems(event.image->problems);
  if (!complete_) return;
  progress_->hide();
  emit finished();
}

void LivePanel::show_problems(const core::Problems& problems) {
  QStringList texts;
  for (const core::Problem& problem : problems) texts << problem_text(problem);
  problems_->say(texts.isEmpty() ? QString() : texts.first());
  problems_->setToolTip(texts.join(QStringLiteral("\n\n")));
}

void LivePanel::show_image() {
  const Compare how = comparing();
  const bool both = how == Compare::side_by_side && image_;
  before_->setVisible(both);
  keep_->setEnabled(image_ != nullptr);
  compare_->setEnabled(kept_ != nullptr);
  if (how == Compare::blink && image_) {
    if (!blink_.isActive()) blink_.start();
  } else {
    blink_.stop();
    before_is_seen_ = false;
  }
  show_state();
  if (!image_) {
    plot_->set_figure({});
    return;
  }
  const float reference_v = how == Compare::off ? image_->largest_v : std::max(image_->largest_v, kept_->largest_v);
  const auto figure_of = [&](const picture::LiveImage& image) {
    picture::Figure figure = picture::live_figure(image, look(), reference_v);
    // Rings stay until the whole image has new ones.
    if (image.targets.empty() && &image == image_.get()) picture::add_rings(figure, rings_);
    return figure;
  };
  if (both) before_->set_figure(figure_of(*kept_));
  if (how == Compare::difference)
    plot_->set_figure(picture::difference_figure(*kept_, *image_, look()));
  else
    plot_->set_figure(figure_of(before_is_seen_ ? *kept_ : *image_));
}

void LivePanel::show_state() {
  if (!image_) {
    state_->say(complete_ ? tr("No image") : QString());
    return;
  }
  const picture::LiveImage& shown = before_is_seen_ ? *kept_ : *image_;
  QString text = text_of(picture::title_of(shown.product)) + ": ";
  if (shown.coarse) text += tr("coarse (%1), ").arg(text_of(shown.coarsely));
  const double seconds = shown.cost.seconds;
  text += text_of(shown.made) + ", " +
          (seconds < 1.0 ? tr("%1 ms").arg(1e3 * seconds, 0, 'f', 0) : text_of(core::duration_text(seconds)));
  if (comparing() == Compare::difference) text = tr("Current minus pinned. ") + text;
  if (comparing() == Compare::blink) text = (before_is_seen_ ? tr("Pinned. ") : tr("Current. ")) + text;
  if (comparing() == Compare::side_by_side) text = tr("Pinned first, then current. ") + text;
  state_->say(text);
}

// Each scene has its own.
void LivePanel::take_kept() {
  const auto found = kept_of_.find(session_.number());
  kept_ = found == kept_of_.end() ? nullptr : found->second;
  rings_.clear();
  compare_->setEnabled(kept_ != nullptr);
}

void LivePanel::keep() {
  if (!image_) return;
  kept_ = kept_of_[session_.number()] = image_;
  show_image();
}

void LivePanel::compare(Compare how) {
  compare_->setCurrentIndex(static_cast<int>(how));
  show_image();
}

void LivePanel::save_picture() { ask_and_save_picture(*this, plot_->figure(), "image.png"); }

void LivePanel::copy_picture() { QApplication::clipboard()->setPixmap(plot_->grab()); }

void LivePanel::copy_command() { QApplication::clipboard()->setText(command()); }

void LivePanel::open_in_viewer() {
  if (job_.running() || !image_) return;
  folder_ = std::make_shared<QTemporaryDir>();
  made_file_ = folder_->filePath("image.npy");
  open_->setEnabled(false);
  state_->say(tr("Making the image with all its samples…"));
  job_.start(
      [wanted = request(), file = made_file_.toStdString()](const core::StopFlag& stop, const BackgroundJob::Report&) {
        picture::write_live_product(wanted, file, &stop);
      });
}

void LivePanel::take_end(JobEnd end, const QString& failure) {
  open_->setEnabled(true);
  show_state();
  if (end == JobEnd::failed) session_.log(core::Severity::error, tr("The image was not made: %1").arg(failure));
  if (end == JobEnd::done) {
    ImageViewer* const viewer = viewers_.open_file(made_file_.toStdString());
    if (image_) viewer->setWindowTitle(text_of(picture::title_of(image_->product)));
    connect(viewer, &QObject::destroyed, [folder = folder_] {});
  }
  folder_.reset();
  emit opened();
}

void LivePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  compute_soon();
}

void LivePanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  picture_->cancel();
  nothing_yet_ = false;
}

void LivePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  pictures_->setDirection(width() > height() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  if (isVisible()) {
    complete_ = false;
    debounce_.start(resized_ms);
  }
}

}  // namespace sarsim::gui

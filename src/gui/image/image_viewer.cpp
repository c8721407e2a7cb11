#include "gui/image/image_viewer.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <variant>

#include "core/os/cache_folder.hpp"
#include "core/report/invalid_request.hpp"
#include "gui/common/export_question.hpp"
#include "gui/common/figure_plot.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/reserved_label.hpp"
#include "gui/common/text.hpp"
#include "gui/image/image_controls.hpp"
#include "gui/image/image_figures.hpp"
#include "gui/image/image_thumbnail.hpp"
#include "gui/image/target_list.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/image_export.hpp"
#include "raster/table/computed_raster.hpp"
#include "workflow/image/placed_image.hpp"

namespace sarsim::gui {

namespace {

constexpr int watch_ms = 500;
constexpr int overview_ms = 200;
constexpr int measure_after_ms = 150;

// How a file is read is part of what an overview of it is.
std::optional<picture::OverviewCache> cache_for(const raster::Raster& source, const raster::RasterHints& hints,
                                                const std::string& identity) {
  const std::filesystem::path folder = core::user_cache_folder();
  if (folder.empty()) return std::nullopt;
  const std::string how = hints.raw ? raster::to_string(*hints.raw) : std::string(source.info().format->title);
  return picture::OverviewCache(folder / "overviews", identity + "\n" + how + "\n" + std::to_string(source.columns()) +
                                                          " " + std::to_string(source.info().bits));
}

}  // namespace

ImageViewer::ImageViewer(QWidget* parent) : QWidget(parent), frame_(*this) {
  setObjectName("image_viewer");
  setWindowTitle(tr("Simulation output"));
  connect_all();
  show_info();
}

ImageViewer::~ImageViewer() = default;

void ImageViewer::open(const std::filesystem::path& path, const raster::RasterHints& hints) {
  path_ = path;
  hints_ = hints;
  algorithm_.clear();
  show_title();
  frame_.state->setText(tr("Opening..."));
  if (opening_.running()) {
    open_again_ = true;
    return;
  }
  auto result = std::make_shared<raster::OpenedRaster>();
  // Asked for before the file is opened: one that is replaced meanwhile is opened once more.
  file_number_ = core::identity_of(path);
  disconnect(&opening_, nullptr, this, nullptr);
  connect(&opening_, &BackgroundJob::ended, this, [this, result](JobEnd end, const QString& failure) {
    if (std::exchange(open_again_, false)) {
      open(path_, hints_);
      return;
    }
    if (end != JobEnd::done) result->raster.reset();
    if (end == JobEnd::failed) result->problems.emplace_back().message = failure.toStdString();
    take_source(*result);
  });
  opening_.start([result, path, hints](const core::StopFlag&, const BackgroundJob::Report&) {
    *result = raster::open_raster(raster::Integrity::partial, path, hints);
  });
}

void ImageViewer::set_name(const QString& name) {
  name_ = name;
  show_title();
}

bool ImageViewer::kept() const { return frame_.keep->isChecked(); }

void ImageViewer::show_title() {
  QString title = name_.isEmpty() ? text_of(path_.filename()) : name_;
  if (!algorithm_.isEmpty()) title += ", " + algorithm_;
  setWindowTitle(title + " - " + tr("Simulation output"));
}

void ImageViewer::take_source(raster::OpenedRaster& result) {
  const bool first = source_ == nullptr;
  const std::size_t columns_before = frame_.plot->part() && source_ ? source_->columns() : 0;
  reader_.forget();
  overview_.reset();
  source_ = std::move(result.raster);
  open_problems_ = std::move(result.problems);
  read_failure_.clear();
  forget_readings();
  frame_.state->clear();
  std::error_code ignored;
  file_bytes_ = std::filesystem::file_size(path_, ignored);
  file_time_ = std::filesystem::last_write_time(path_, ignored);
  if (!source_) {
    rows_ = 0;
    axes_.reset();
    frame_.plot->set_part(nullptr, {}, {});
    frame_.plot->set_coarse({});
    frame_.thumbnail->set_picture({}, 1, 1);
    complete_ = false;
    watch_.start(watch_ms);
    show_info();
    show_problems();
    emit open_failed();
    return;
  }
  rows_ = source_->rows();
  envi_ = source_->info().format->by_hand && raster::has_envi_header(path_);
  try {
    axes_ = source_->axes();
  } catch (const std::exception& error) {
    axes_.reset();
    read_failure_ = QString::fromUtf8(error.what());
  }
  if (first && !look_set_) look_ = look_for(source_->info().value, source_->info().format->picture);
  if (!has_quantity(source_->info().value, look_.quantity) && source_->info().value != raster::ImageValue::rgb)
    look_ = look_for(source_->info().value, source_->info().format->picture);
  frame_.controls->show_look(look_, source_->info().value, words().value_unit());
  frame_.plot->set_part(nullptr, {}, {});
  frame_.plot->set_size(rows_, source_->columns());
  frame_.plot->set_axes(look_.numbers, look_.equal_scale);
  frame_.plot->set_draw_as(look_.draw_as);
  take_places();
  if (columns_before != source_->columns()) {
    history_.clear();
    wanted_view_ = whole_view(rows_, source_->columns());
  }
  frame_.plot->set_view(frame_.plot->shown_view(wanted_view_));
  frame_.controls->show_view(frame_.plot->view(), frame_.plot->shown_places());
  frame_.plot->set_selection(std::nullopt);
  frame_.plot->set_rings({}, std::nullopt);
  if (frame_.show_targets->isChecked()) frame_.targets->measure(path_);
  begin_overview();
  watch_.start(watch_ms);
  show_info();
  show_problems();
  change_view(wanted_view_);
  emit opened();
}

void ImageViewer::take_places() {
  frame_.plot->set_places(std::nullopt);
  try {
    frame_.plot->set_places(workflow::drawn_places(path_, *source_));
    algorithm_ = QString::fromStdString(workflow::algorithm_said(path_));
    show_title();
  } catch (const core::InvalidRequest& refused) {
    core::append(open_problems_, refused.problems);
  } catch (const std::exception& error) {
    read_failure_ = QString::fromUtf8(error.what());
  }
}

// What was said of the file before.
void ImageViewer::forget_readings() {
  statistics_.reset();
  reading_.reset();
  for (ReservedLabel* label : {frame_.read_out, frame_.difference, frame_.figures, frame_.point}) label->say({});
  frame_.point->setVisible(frame_.reading_tool->isChecked());
  frame_.histogram->hide();
  for (FigurePlot* plot : {frame_.row_cut, frame_.column_cut}) plot->set_figure({});
}

void ImageViewer::begin_overview() {
  overview_.reset();
  overview_shown_ = false;
  overview_rows_ = rows_;
  picture::OverviewOptions options;
  const auto identity = picture::file_identity(path_);
  // A file that is still looked through or written has other rows the next time.
  if (identity && source_->indexed() >= 1.0) {
    options.cache = cache_for(*source_, hints_, *identity);
    options.still_the_same = [path = path_, identity] { return picture::file_identity(path) == identity; };
  }
  overview_ = std::make_shared<picture::Overview>(raster::first_rows(source_, rows_), options);
  overview_timer_.start(overview_ms);
  QTimer::singleShot(overview_ms / 4, this, &ImageViewer::show_overview);
}

// The whole image, as coarse as the thumbnail needs it, in the colours that are chosen.
void ImageViewer::show_overview() {
  if (!overview_ || !source_ || overview_rows_ == 0 || source_->columns() == 0) {
    overview_timer_.stop();
    return;
  }
  const bool ended = overview_->state() != picture::OverviewState::building;
  if (ended) overview_timer_.stop();
  const CoarsePicture coarse = coarse_picture(*overview_, *source_, overview_rows_, look_);
  frame_.thumbnail->set_picture(coarse.image, overview_rows_, source_->columns());
  frame_.thumbnail->set_view(frame_.plot->view());
  // Cells at the end may reach beyond the image; the plot shows only what is exact to a cell.
  frame_.plot->set_coarse(coarse.as_wanted ? coarse.image : QImage());
  overview_shown_ = true;
  if (const std::string failure = overview_->failure(); ended && !failure.empty() && read_failure_.isEmpty()) {
    read_failure_ = QString::fromStdString(failure);
    show_problems();
  }
}

// Twice a second: has the file grown, been cut off or replaced?
void ImageViewer::look_at_file() {
  std::error_code failure;
  const auto bytes = std::filesystem::file_size(path_, failure);
  const auto time = std::filesystem::last_write_time(path_, failure);
  const bool follows = frame_.follow_file->isChecked();
  if (failure || opening_.running()) return;  // A file that is gone can still be read where it is open.
  // What is open would never tell of another file that has taken the name, however large that is.
  if (follows && core::identity_of(path_) != file_number_) {
    refresh();
    return;
  }
  if (!source_) {
    if (follows && (bytes != file_bytes_ || time != file_time_)) refresh();
    file_bytes_ = bytes;
    file_time_ = time;
    return;
  }
  if (follows && (bytes < file_bytes_ || (bytes == file_bytes_ && time != file_time_))) {
    refresh();
    return;
  }
  if (!follows && source_->indexed() >= 1.0 && source_->rows() == rows_) return;
  const bool grew = bytes > file_bytes_;
  try {
    const std::size_t rows = follows ? source_->refresh() : source_->rows();
    file_bytes_ = follows ? bytes : file_bytes_;
    file_time_ = follows ? time : file_time_;
    if (rows != rows_)
      take_rows(rows);
    else if (!grew && overview_rows_ != rows_)
      begin_overview();
  } catch (const std::exception& error) {
    read_failure_ = QString::fromUtf8(error.what());
  }
  show_problems();
}

void ImageViewer::take_rows(std::size_t rows) {
  const bool whole = wanted_view_ == whole_view(rows_, source_->columns());
  rows_ = rows;
  frame_.plot->set_size(rows_, source_->columns());
  take_places();
  show_info();
  // An overview of a growing file is begun anew after a tenth more, and when it has come to rest.
  if (10 * rows_ > 11 * overview_rows_) begin_overview();
  if (whole)
    change_view(whole_view(rows_, source_->columns()));
  else
    read_soon();
}

void ImageViewer::set_look(const PartLook& look) {
  look_set_ = true;
  look_ = look;
  frame_.plot->set_axes(look_.numbers, look_.equal_scale);
  frame_.plot->set_draw_as(look_.draw_as);
  frame_.controls->show_look(look_, source_ ? source_->info().value : raster::ImageValue::complex,
                             words().value_unit());
  if (overview_shown_) show_overview();
  if (statistics_) show_statistics();
  change_view(wanted_view_);
}

void ImageViewer::change_view(const ImageView& view, bool tell) {
  if (!source_) return;
  wanted_view_ = mended(view, rows_, source_->columns());
  const ImageView wanted = frame_.plot->shown_view(view);
  const bool moved = wanted != frame_.plot->view();
  frame_.plot->set_view(wanted);
  frame_.controls->show_view(wanted, frame_.plot->shown_places());
  frame_.thumbnail->set_view(wanted);
  frame_.back->setEnabled(history_.can_go_back());
  frame_.forward->setEnabled(history_.can_go_forward());
  read_soon();
  if (!frame_.plot->selection()) measure_soon();
  if (moved && tell) emit view_changed(wanted, frame_.controls->link());
}

void ImageViewer::go_to(const ImageView& view) {
  if (!source_ || frame_.plot->shown_view(view) == frame_.plot->view()) return;
  history_.leave(frame_.plot->view());
  change_view(view);
}

void ImageViewer::go_back() {
  if (history_.can_go_back()) change_view(history_.back(frame_.plot->view()));
}

void ImageViewer::go_forward() {
  if (history_.can_go_forward()) change_view(history_.forward(frame_.plot->view()));
}

void ImageViewer::show_whole() {
  if (source_) go_to(whole_view(rows_, source_->columns()));
}

void ImageViewer::follow(const ImageView& view, picture::AxisLink link) {
  const picture::AxisLink own = frame_.controls->link();
  ImageView wanted = frame_.plot->view();
  if (own.range && link.range) {
    wanted.column_first = view.column_first;
    wanted.column_last = view.column_last;
  }
  if (own.time && link.time) {
    wanted.row_first = view.row_first;
    wanted.row_last = view.row_last;
  }
  // Told by the leader to all; where this image is smaller, its own view must not throw the leader about.
  if (wanted != frame_.plot->view()) change_view(wanted, false);
}

void ImageViewer::refresh() {
  if (!path_.empty()) open(path_, hints_);
}

// Once for all that changes within one round of events.
void ImageViewer::read_soon() {
  complete_ = false;
  debounce_.start(0);
}

void ImageViewer::read_part() {
  if (!source_) return;
  const QSize size = frame_.plot->device_size();
  raster::ImageWindow window =
      window_for(frame_.plot->view(), static_cast<std::size_t>(size.width()), static_cast<std::size_t>(size.height()),
                 rows_, source_->columns(), look_.wants_peaks());
  if (window.samples() == 0) {
    frame_.plot->set_part(nullptr, {}, {});
    return;
  }
  const auto overview = overview_ && overview_->state() == picture::OverviewState::complete ? overview_ : nullptr;
  request_ = reader_.ask({source_, overview, window, frame_.plot->view(), look_});
}

void ImageViewer::take_part(const PartResult& result) {
  if (!read_failure_.isEmpty()) {
    read_failure_.clear();
    show_problems();
  }
  frame_.plot->set_part(result.part, result.painted, words().unit());
  frame_.controls->set_present_limits(result.painted.colours.limits);
  complete_ = result.complete;
  show_read_out();
  if (!complete_) return;
  show_cuts();
  emit shown();
}

void ImageViewer::show_info() {
  frame_.describe->setEnabled(!path_.empty());
  frame_.export_samples->setEnabled(source_ != nullptr);
  if (!source_) {
    frame_.info->setText(path_.empty()
                             ? tr("No file. Display, Simulation Output opens one; or drop one on the main window.")
                             : tr("%1\ncould not be read").arg(text_of(path_.filename())));
    return;
  }
  const raster::RasterInfo& info = source_->info();
  const std::string_view values = info.value == raster::ImageValue::complex     ? "complex"
                                  : info.value == raster::ImageValue::real      ? "real"
                                  : info.value == raster::ImageValue::magnitude ? "magnitudes"
                                  : info.value == raster::ImageValue::power     ? "powers"
                                                                                : "colours";
  QString how = (envi_ ? QStringLiteral("ENVI") : text_of(info.format->title)) + ", " + text_of(values);
  if (info.bits > 0) how += tr(", %1 bits").arg(info.bits);
  frame_.info->setText(text_of(path_.filename()) + "\n" + how + "\n" +
                       tr("%1 rows of %2 samples").arg(rows_).arg(source_->columns()));
  frame_.info->setToolTip(text_of(path_));
}

QString ImageViewer::problem_words() const { return frame_.problems->text(); }

void ImageViewer::show_problems() {
  QStringList texts;
  core::Severity worst = core::Severity::note;
  const auto add = [&](const core::Problems& problems) {
    for (const core::Problem& problem : problems) {
      texts << problem_text(problem);
      worst = std::min(worst, problem.severity);
    }
  };
  if (!read_failure_.isEmpty()) {
    texts << read_failure_;
    worst = core::Severity::error;
  }
  add(open_problems_);
  if (source_) add(source_->problems());
  if (source_ && source_->indexed() < 1.0)
    frame_.state->setText(tr("Scanned %1 %").arg(static_cast<int>(100.0 * source_->indexed())));
  else if (frame_.state->text().startsWith(tr("Scanned")))
    frame_.state->clear();
  if (texts.isEmpty())
    frame_.problems->clear();
  else if (frame_.problems->text() != texts.mid(0, 5).join('\n'))
    frame_.problems->show_texts(worst, texts.mid(0, 5));
}

void ImageViewer::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_cuts();
}

void ImageViewer::connect_all() {
  for (QTimer* timer : {&debounce_, &measure_soon_}) timer->setSingleShot(true);
  connect(&debounce_, &QTimer::timeout, this, &ImageViewer::read_part);
  connect(&measure_soon_, &QTimer::timeout, this, &ImageViewer::measure);
  connect(&watch_, &QTimer::timeout, this, &ImageViewer::look_at_file);
  connect(&overview_timer_, &QTimer::timeout, this, &ImageViewer::show_overview);
  connect(&reader_, &ImageReader::ready, this, &ImageViewer::take_part);
  connect(&reader_, &ImageReader::failed, this, [this](const QString& words) {
    read_failure_ = words;
    show_problems();
  });
  connect(frame_.back, &QToolButton::clicked, this, &ImageViewer::go_back);
  connect(frame_.forward, &QToolButton::clicked, this, &ImageViewer::go_forward);
  connect(frame_.whole, &QToolButton::clicked, this, &ImageViewer::show_whole);
  connect(frame_.refresh, &QToolButton::clicked, this, &ImageViewer::refresh);
  connect(frame_.copy_picture, &QPushButton::clicked, this, &ImageViewer::copy_picture);
  connect(frame_.save_picture, &QPushButton::clicked, this, &ImageViewer::save_picture);
  connect(frame_.show_cuts, &QToolButton::toggled, this, &ImageViewer::show_cuts);
  for (FigurePlot* cut : {frame_.row_cut, frame_.column_cut}) {
    cut->setToolTip(tr("Click or drag to move the first cursor along the line"));
    connect(cut, &FigurePlot::pressed_at, this, [this, cut](std::size_t, double x, double) { press_cut(cut, x); });
  }
  connect(frame_.show_targets, &QToolButton::toggled, this, &ImageViewer::show_targets);
  connect(frame_.targets, &TargetList::measured, this, &ImageViewer::show_rings);
  connect(frame_.targets, &TargetList::target_chosen, this, &ImageViewer::frame_target);
  connect(frame_.plot, &ImagePlot::ring_clicked, this,
          [this](std::size_t ring) { frame_.targets->choose(rows_of_rings_.at(ring)); });
  connect(frame_.show_statistics, &QToolButton::toggled, this, [this] {
    show_statistics();
    measure_soon();
  });
  connect(frame_.reading_tool, &QToolButton::toggled, frame_.plot, &ImagePlot::set_reading_tool);
  connect(frame_.reading_tool, &QToolButton::toggled, this,
          [this](bool on) { frame_.point->setVisible(on || reading_); });
  connect(frame_.describe, &QPushButton::clicked, this, &ImageViewer::describe_wanted);
  connect(frame_.export_samples, &QPushButton::clicked, this, &ImageViewer::export_chosen);
  connect(frame_.controls, &ImageControls::edited, this, &ImageViewer::set_look);
  connect(frame_.controls, &ImageControls::view_typed, this, [this](const ImageView& view) {
    go_to(view);
    frame_.controls->show_view(frame_.plot->view(),
                               frame_.plot->shown_places());  // Also where it cannot be as it was typed.
  });
  connect(frame_.controls, &ImageControls::link_changed, this,
          [this] { emit view_changed(frame_.plot->view(), frame_.controls->link()); });
  const auto about = [this](double column, double row) -> ImageView {
    const ImageView& v = frame_.plot->view();
    return {column - v.columns() / 2.0, column + v.columns() / 2.0, row - v.rows() / 2.0, row + v.rows() / 2.0};
  };
  connect(frame_.thumbnail, &ImageThumbnail::centre_wanted, this,
          [this, about](double column, double row) { go_to(about(column, row)); });
  connect(frame_.thumbnail, &ImageThumbnail::centre_dragged, this,
          [this, about](double column, double row) { change_view(about(column, row)); });
  connect(frame_.plot, &ImagePlot::view_wanted, this, &ImageViewer::go_to);
  connect(frame_.plot, &ImagePlot::drag_began, this, [this] { history_.leave(frame_.plot->view()); });
  connect(frame_.plot, &ImagePlot::view_dragged, this, [this](const ImageView& view) { change_view(view); });
  connect(frame_.plot, &ImagePlot::back_wanted, this, &ImageViewer::go_back);
  connect(frame_.plot, &ImagePlot::whole_wanted, this, &ImageViewer::show_whole);
  connect(frame_.plot, &ImagePlot::resized, this, [this] {
    if (source_)
      change_view(wanted_view_, false);
    else
      read_soon();
  });
  connect(frame_.plot, &ImagePlot::hovered, this, &ImageViewer::show_read_out);
  connect(frame_.plot, &ImagePlot::cursors_changed, this, [this] {
    show_read_out();
    show_cuts();
  });
  connect(frame_.plot, &ImagePlot::selection_changed, this, [this] {
    if (frame_.plot->selection()) frame_.show_statistics->setChecked(true);
    measure_soon();
  });
  connect(frame_.plot, &ImagePlot::reading_wanted, this, &ImageViewer::read_point_at);
}

ImageWords ImageViewer::words() const { return {source_.get(), axes_, look_, !algorithm_.isEmpty()}; }

void ImageViewer::show_read_out() {
  const auto pointer = frame_.plot->pointer_place();
  const auto& first = frame_.plot->cursor(0);
  frame_.read_out->say(pointer ? words().at(*frame_.plot, *pointer)
                       : first ? words().at(*frame_.plot, *first)
                               : QString());
  frame_.difference->say(words().difference(*frame_.plot));
}

void ImageViewer::show_cuts() {
  const bool wanted = frame_.show_cuts->isChecked();
  for (FigurePlot* plot : {frame_.row_cut, frame_.column_cut}) plot->setVisible(wanted);
  if (!wanted) return;
  const std::optional<ImageCuts> cuts = cuts_of(*frame_.plot, words());
  if (!cuts) return;
  frame_.row_cut->set_figure(cuts->row);
  frame_.column_cut->set_figure(cuts->column);
}

// A place in a cut is one of the image, on the line that is cut.
void ImageViewer::press_cut(const FigurePlot* cut, double place) {
  const auto& part = frame_.plot->part();
  if (!part || part->samples.empty()) return;
  const ImageView& view = frame_.plot->view();
  SamplePlace at = frame_.plot->cursor(0).value_or(
      SamplePlace{(view.column_first + view.column_last) / 2.0, (view.row_first + view.row_last) / 2.0});
  const raster::FocusedPlaces places = frame_.plot->shown_places();
  const auto number = [place](const raster::ImagePlaces& axis, std::size_t count) {
    const double nearest = std::round((place - axis.first) / axis.step);
    return std::isfinite(nearest) ? std::clamp(nearest, 0.0, static_cast<double>(count - 1)) : 0.0;
  };
  if (cut == frame_.row_cut)
    at.column = number(places.range, source_->columns());
  else
    at.row = number(places.azimuth, rows_);
  frame_.plot->set_cursor(0, SamplePlace{std::round(at.column), std::round(at.row)});
}

raster::ImageWindow ImageViewer::chosen() const {
  if (!source_) return {};
  if (frame_.plot->selection()) return *frame_.plot->selection();
  return samples_in(frame_.plot->view(), rows_, source_->columns());
}

void ImageViewer::measure_soon() {
  if (!frame_.show_statistics->isChecked()) return;
  measure_soon_.start(measure_after_ms);
}

void ImageViewer::measure() {
  if (!source_) return;
  if (measuring_.running()) {
    measure_again_ = true;
    measuring_.cancel();
    return;
  }
  const raster::ImageWindow window = chosen();
  if (window.samples() == 0) return;
  auto result = std::make_shared<picture::SelectionStatistics>();
  disconnect(&measuring_, nullptr, this, nullptr);
  connect(&measuring_, &BackgroundJob::progressed, this, [this](double share, double left_s) {
    frame_.figures->say(tr("Measuring: %1").arg(share_with_time_left(share, left_s)));
  });
  connect(&measuring_, &BackgroundJob::ended, this, [this, result, of = source_](JobEnd end, const QString& failure) {
    if (std::exchange(measure_again_, false)) return measure();
    if (of != source_) return;  // Another file is shown by now.
    statistics_.reset();
    if (end == JobEnd::done) statistics_ = *result;
    show_statistics();
    if (end == JobEnd::failed) frame_.figures->say(failure);
  });
  measuring_.start([result, window, plane = raster::first_rows(source_, rows_)](const core::StopFlag& stop,
                                                                                const BackgroundJob::Report& report) {
    *result = picture::measure_selection(*plane, {window.row0, window.rows, window.col0, window.cols, 1, 1},
                                         {std::min(core::thread_count(0), 4U), &stop}, [&](const core::Progress& p) {
                                           if (p.total > 0)
                                             report(static_cast<double>(p.done) / static_cast<double>(p.total));
                                         });
  });
}

void ImageViewer::show_statistics() {
  const bool wanted = frame_.show_statistics->isChecked();
  frame_.figures->setVisible(wanted);
  frame_.histogram->setVisible(wanted && statistics_);
  if (!wanted || !statistics_) return;
  frame_.figures->say(words().of_selection(*statistics_, frame_.plot->selection().has_value()));
  frame_.histogram->set_figure(histogram_of(*statistics_, words()));
}

void ImageViewer::read_point_at(std::size_t row, std::size_t column) {
  if (!source_ || pointing_.running()) return;
  auto result = std::make_shared<std::variant<picture::PointReading, core::Problem>>();
  disconnect(&pointing_, nullptr, this, nullptr);
  connect(&pointing_, &BackgroundJob::ended, this, [this, result, of = source_](JobEnd end, const QString& failure) {
    if (of != source_) return;  // Another file is shown by now.
    reading_.reset();
    if (end == JobEnd::failed) return show_reading(failure);
    if (end != JobEnd::done) return;
    if (const auto* const problem = std::get_if<core::Problem>(result.get()))
      return show_reading(problem_text(*problem));
    reading_ = std::get<picture::PointReading>(*result);
    frame_.plot->set_cursor(0, SamplePlace{reading_->column, reading_->row});
    show_reading({});
  });
  // A hand aims at what it sees: at so many pixels of the screen, whatever the zoom.
  constexpr double aim_px = 12.0;
  const ImageView& view = frame_.plot->view();
  const QSize size = frame_.plot->plot_rect().size();
  picture::PointOptions options;
  const auto reach = [](double samples) { return static_cast<std::size_t>(std::ceil(std::clamp(samples, 4.0, 1e3))); };
  options.search_rows = reach(aim_px * view.rows() / size.height());
  options.search_columns = reach(aim_px * view.columns() / size.width());
  pointing_.start([result, row, column, options, plane = raster::first_rows(source_, rows_)](
                      const core::StopFlag&, const BackgroundJob::Report&) {
    *result = picture::read_point(*plane, row, column, options);
  });
}

void ImageViewer::show_reading(const QString& failure) {
  frame_.point->show();
  frame_.point->say(reading_ ? words().of_point(*reading_) : failure);
}

picture::Figure ImageViewer::figure() const {
  picture::Figure figure = figure_of(*frame_.plot, words());
  if (!figure.panels.empty()) figure.title = path_.filename().string();
  return figure;
}

void ImageViewer::copy_picture() { QApplication::clipboard()->setImage(frame_.plot->plot_image()); }

void ImageViewer::save_picture() { ask_and_save_picture(*this, figure(), "image.png"); }

void ImageViewer::export_chosen() {
  if (exporting()) return cancel_export();
  if (const auto choice = ask_export(this)) export_to(choice->path, choice->format);
}

void ImageViewer::export_to(const QString& path, scene::FileFormat format) {
  if (!source_ || exporting_.running()) return;
  // It is being read while the copy is written.
  std::error_code ignored;
  if (std::filesystem::equivalent(path.toStdString(), path_, ignored)) {
    read_failure_ = tr("'%1' is the file that is shown; export to another name").arg(path);
    show_problems();
    emit exported(false);
    return;
  }
  raster::ImageExport options;
  options.sink.format = format;
  options.sink.replace = true;
  options.sink.counts = source_->info().counts;
  disconnect(&exporting_, nullptr, this, nullptr);
  connect(&exporting_, &BackgroundJob::progressed, this, [this](double share, double left_s) {
    frame_.state->setText(tr("Writing: %1").arg(share_with_time_left(share, left_s)));
  });
  connect(&exporting_, &BackgroundJob::ended, this, [this, path](JobEnd end, const QString& failure) {
    frame_.export_samples->setText(tr("Export Samples..."));
    frame_.state->setText(end == JobEnd::done        ? tr("Wrote %1").arg(QFileInfo(path).fileName())
                          : end == JobEnd::cancelled ? tr("Export cancelled")
                                                     : QString());
    if (end == JobEnd::failed) {
      read_failure_ = failure;
      show_problems();
    }
    emit exported(end == JobEnd::done);
  });
  frame_.export_samples->setText(tr("Cancel Export"));
  exporting_.start([source = source_, window = chosen(), path, options](const core::StopFlag& stop,
                                                                        const BackgroundJob::Report& report) {
    raster::export_window(*source, window, path.toStdString(), options, {1, &stop}, [&](const core::Progress& p) {
      if (p.total > 0) report(static_cast<double>(p.done) / static_cast<double>(p.total));
    });
  });
}

void ImageViewer::show_targets(bool on) {
  frame_.targets->setVisible(on);
  if (on)
    frame_.targets->measure(path_);
  else
    frame_.targets->forget();
  if (!on) show_rings();
}

// A ring where each target should be that has echoes in the image.
void ImageViewer::show_rings() {
  std::vector<ImagePlot::Ring> rings;
  std::optional<std::size_t> chosen;
  rows_of_rings_.clear();
  const auto& places = frame_.plot->places();
  const std::vector<picture::TargetTable::Row>& rows = frame_.targets->table().rows;
  for (std::size_t i = 0; places && i < rows.size(); ++i) {
    if (!rows[i].inside) continue;
    if (frame_.targets->chosen() == i) chosen = rings.size();
    rows_of_rings_.push_back(i);
    rings.push_back({{(rows[i].expected.range_m - places->range.first) / places->range.step,
                      (rows[i].expected.azimuth_m - places->azimuth.first) / places->azimuth.step},
                     rows[i].found});
  }
  frame_.plot->set_rings(std::move(rings), chosen);
}

// Brings a target that is out of sight into the middle.
void ImageViewer::frame_target(std::size_t row) {
  show_rings();
  const auto at = std::ranges::find(rows_of_rings_, row);
  if (at == rows_of_rings_.end()) return;
  const SamplePlace place = frame_.plot->rings().at(static_cast<std::size_t>(at - rows_of_rings_.begin())).at;
  const ImageView& v = frame_.plot->view();
  if (place.column > v.column_first && place.column < v.column_last && place.row > v.row_first &&
      place.row < v.row_last)
    return;
  go_to({place.column - v.columns() / 2.0, place.column + v.columns() / 2.0, place.row - v.rows() / 2.0,
         place.row + v.rows() / 2.0});
}

}  // namespace sarsim::gui

#include "gui/image/image_viewer.hpp"
#include "gui/image/target_list.hpp"

#include <QCheckBox>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <bit>
#include <utility>

#include "core/os/cache_folder.hpp"
#include "core/report/invalid_request.hpp"
#include "gui/common/figure_plot.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/reserved_label.hpp"
#include "gui/common/text.hpp"
#include "gui/image/image_controls.hpp"
#include "gui/image/image_thumbnail.hpp"
#include "raster/format/envi.hpp"
#include "raster/table/computed_raster.hpp"
#include "workflow/image/placed_image.hpp"

namespace sarsim::gui {

namespace {

constexpr int watch_ms = 500;
constexpr int overview_ms = 200;
constexpr std::size_t coarse_side = 512;  // cells of the coarse picture of the whole image

// How a file is read is part of what an overview of it is.
std::optional<picture::OverviewCache> cache_for(const raster::Raster& source, const raster::RasterHints& hints,
                                                const std::string& identity) {
  const std::filesystem::path folder = core::user_cache_folder();
  if (folder.empty()) return std::nullopt;
  const std::string how = hints.raw ? raster::to_string(*hints.raw) : std::string(source.info().format->title);
  return picture::OverviewCache(folder / "overviews", identity + "\n" + how + "\n" + std::to_string(source.columns()) +
                                                          " " + std::to_string(source.info().bits));
}

unsigned coarser_log2(unsigned base, std::size_t samples) {
  unsigned log2 = base;
  while ((samples >> log2) > coarse_side) ++log2;
  return log2;
}

}  // namespace

ImageViewer::~ImageViewer() = default;

void ImageViewer::open(const std::filesystem::path& path, const raster::RasterHints& hints) {
  path_ = path;
  hints_ = hints;
  algorithm_.clear();
  show_title();
  state_->setText(tr("Opening..."));
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

bool ImageViewer::kept() const { return keep_->isChecked(); }

void ImageViewer::show_title() {
  QString title = name_.isEmpty() ? text_of(path_.filename()) : name_;
  if (!algorithm_.isEmpty()) title += ", " + algorithm_;
  setWindowTitle(title + " - " + tr("Simulation output"));
}

void ImageViewer::take_source(raster::OpenedRaster& result) {
  const bool first = source_ == nullptr;
  const std::size_t columns_before = plot_->part() && source_ ? source_->columns() : 0;
  reader_.forget();
  overview_.reset();
  source_ = std::move(result.raster);
  open_problems_ = std::move(result.problems);
  read_failure_.clear();
  forget_readings();
  state_->clear();
  std::error_code ignored;
  file_bytes_ = std::filesystem::file_size(path_, ignored);
  file_time_ = std::filesystem::last_write_time(path_, ignored);
  if (!source_) {
    rows_ = 0;
    axes_.reset();
    plot_->set_part(nullptr, {}, {});
    plot_->set_coarse({});
    thumbnail_->set_picture({}, 1, 1);
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
  controls_->show_look(look_, source_->info().value, value_unit());
  plot_->set_part(nullptr, {}, {});
  plot_->set_size(rows_, source_->columns());
  plot_->set_axes(look_.numbers, look_.equal_scale);
  plot_->set_draw_as(look_.draw_as);
  take_places();
  if (columns_before != source_->columns()) {
    history_.clear();
    wanted_view_ = whole_view(rows_, source_->columns());
  }
  plot_->set_view(plot_->shown_view(wanted_view_));
  controls_->show_view(plot_->view(), plot_->shown_places());
  plot_->set_selection(std::nullopt);
  plot_->set_rings({}, std::nullopt);
  if (show_targets_->isChecked()) targets_->measure(path_);
  begin_overview();
  watch_.start(watch_ms);
  show_info();
  show_problems();
  change_view(wanted_view_);
  emit opened();
}

void ImageViewer::take_places() {
  plot_->set_places(std::nullopt);
  try {
    plot_->set_places(workflow::drawn_places(path_, *source_));
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
  for (ReservedLabel* label : {read_out_, difference_, figures_, point_}) label->say({});
  point_->setVisible(reading_tool_->isChecked());
  histogram_->hide();
  for (FigurePlot* plot : {row_cut_, column_cut_}) plot->set_figure({});
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
  const unsigned row_log2 = coarser_log2(overview_->base().row_log2, overview_rows_);
  const unsigned col_log2 = coarser_log2(overview_->base().col_log2, source_->columns());
  const picture::OverviewLevel level = overview_->level(row_log2, col_log2);
  std::vector<float> cells(level.rows * level.columns);
  overview_->read(row_log2, col_log2, 0, level.rows, 0, level.columns, cells);
  ImagePart part;
  part.window = {0, level.rows, 0, level.columns, std::size_t{1} << row_log2, std::size_t{1} << col_log2};
  part.value = source_->info().value;
  part.samples.assign(cells.begin(), cells.end());
  PartLook look = look_;
  const bool same_quantity =
      look.quantity == picture::DisplayQuantity::magnitude || look.quantity == picture::DisplayQuantity::decibels;
  const bool grey = part.value == raster::ImageValue::rgb ||
                    (part.value == raster::ImageValue::real && look.map == picture::ColourMap::grey);
  if (!same_quantity) {
    look.quantity = grey ? picture::DisplayQuantity::magnitude : picture::DisplayQuantity::decibels;
    if (picture::kind_for(picture::DisplayQuantity::decibels) != picture::info_of(look.map).kind)
      look.map = picture::ColourMap::grey;
    look.limits = {};
  }
  const ImageView all = whole_view(part.window.rows * part.window.row_step, part.window.cols * part.window.col_step);
  const QImage picture = paint(part, look, all).image;
  thumbnail_->set_picture(picture, overview_rows_, source_->columns());
  thumbnail_->set_view(plot_->view());
  // Cells at the end may reach beyond the image; the plot shows only what is exact to a cell.
  plot_->set_coarse(same_quantity ? picture : QImage());
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
  const bool follows = follow_file_->isChecked();
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
  plot_->set_size(rows_, source_->columns());
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
  plot_->set_axes(look_.numbers, look_.equal_scale);
  plot_->set_draw_as(look_.draw_as);
  controls_->show_look(look_, source_ ? source_->info().value : raster::ImageValue::complex, value_unit());
  if (overview_shown_) show_overview();
  if (statistics_) show_statistics();
  change_view(wanted_view_);
}

void ImageViewer::change_view(const ImageView& view, bool tell) {
  if (!source_) return;
  wanted_view_ = mended(view, rows_, source_->columns());
  const ImageView wanted = plot_->shown_view(view);
  const bool moved = wanted != plot_->view();
  plot_->set_view(wanted);
  controls_->show_view(wanted, plot_->shown_places());
  thumbnail_->set_view(wanted);
  back_->setEnabled(history_.can_go_back());
  forward_->setEnabled(history_.can_go_forward());
  read_soon();
  if (!plot_->selection()) measure_soon();
  if (moved && tell) emit view_changed(wanted, controls_->link());
}

void ImageViewer::go_to(const ImageView& view) {
  if (!source_ || plot_->shown_view(view) == plot_->view()) return;
  history_.leave(plot_->view());
  change_view(view);
}

void ImageViewer::go_back() {
  if (history_.can_go_back()) change_view(history_.back(plot_->view()));
}

void ImageViewer::go_forward() {
  if (history_.can_go_forward()) change_view(history_.forward(plot_->view()));
}

void ImageViewer::show_whole() {
  if (source_) go_to(whole_view(rows_, source_->columns()));
}

void ImageViewer::follow(const ImageView& view, picture::AxisLink link) {
  const picture::AxisLink own = controls_->link();
  ImageView wanted = plot_->view();
  if (own.range && link.range) {
    wanted.column_first = view.column_first;
    wanted.column_last = view.column_last;
  }
  if (own.time && link.time) {
    wanted.row_first = view.row_first;
    wanted.row_last = view.row_last;
  }
  // Told by the leader to all; where this image is smaller, its own view must not throw the leader about.
  if (wanted != plot_->view()) change_view(wanted, false);
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
  const QSize size = plot_->device_size();
  raster::ImageWindow window =
      window_for(plot_->view(), static_cast<std::size_t>(size.width()), static_cast<std::size_t>(size.height()), rows_,
                 source_->columns(), look_.wants_peaks());
  if (window.samples() == 0) {
    plot_->set_part(nullptr, {}, {});
    return;
  }
  const auto overview = overview_ && overview_->state() == picture::OverviewState::complete ? overview_ : nullptr;
  request_ = reader_.ask({source_, overview, window, plot_->view(), look_});
}

void ImageViewer::take_part(const PartResult& result) {
  if (!read_failure_.isEmpty()) {
    read_failure_.clear();
    show_problems();
  }
  plot_->set_part(result.part, result.painted, unit());
  controls_->set_present_limits(result.painted.colours.limits);
  complete_ = result.complete;
  show_read_out();
  if (!complete_) return;
  show_cuts();
  emit shown();
}

void ImageViewer::show_info() {
  describe_->setEnabled(!path_.empty());
  export_->setEnabled(source_ != nullptr);
  if (!source_) {
    info_->setText(path_.empty() ? tr("No file. Display, Simulation Output opens one; or drop one on the main window.")
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
  info_->setText(text_of(path_.filename()) + "\n" + how + "\n" +
                 tr("%1 rows of %2 samples").arg(rows_).arg(source_->columns()));
  info_->setToolTip(text_of(path_));
}

QString ImageViewer::problem_words() const { return problems_->text(); }

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
    state_->setText(tr("Looked through %1 %").arg(static_cast<int>(100.0 * source_->indexed())));
  else if (state_->text().startsWith(tr("Looked through")))
    state_->clear();
  if (texts.isEmpty())
    problems_->clear();
  else if (problems_->text() != texts.mid(0, 5).join('\n'))
    problems_->show_texts(worst, texts.mid(0, 5));
}

void ImageViewer::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_cuts();
}

}  // namespace sarsim::gui

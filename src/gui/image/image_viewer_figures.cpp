// What an image viewer says of samples: read-out, cuts, statistics, points, pictures and files of them.

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <variant>

#include "gui/common/export_question.hpp"
#include "gui/common/figure_plot.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/reserved_label.hpp"
#include "gui/common/text.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/target_list.hpp"
#include "raster/format/image_export.hpp"
#include "raster/table/computed_raster.hpp"
#include "scene/schema/quantity.hpp"

namespace sarsim::gui {

namespace {

constexpr int measure_after_ms = 150;
constexpr std::size_t bars = 128;

QString number_text(double value, const QString& unit = {}) {
  const QString text = QString::number(value, 'g', 6);
  return unit.isEmpty() ? text : text + " " + unit;
}

picture::SampleQuantity measured(picture::DisplayQuantity quantity) {
  switch (quantity) {
    case picture::DisplayQuantity::real: return picture::SampleQuantity::real;
    case picture::DisplayQuantity::imaginary: return picture::SampleQuantity::imaginary;
    case picture::DisplayQuantity::phase: return picture::SampleQuantity::phase;
    case picture::DisplayQuantity::decibels: return picture::SampleQuantity::decibels;
    default: return picture::SampleQuantity::magnitude;
  }
}

// Bars of a histogram, wide enough to be seen, from the smallest value that is there to the largest.
picture::FigureCurve bars_of(const picture::QuantityStatistics& statistics) {
  const picture::Histogram& histogram = statistics.histogram;
  picture::FigureCurve curve;
  curve.bars = true;
  if (histogram.bins.empty() || statistics.count == 0) return curve;
  const auto bin = [&](double value) {
    const double at = (value - histogram.low) / histogram.bin_width();
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(histogram.bins.size() - 1)));
  };
  const std::size_t first = bin(statistics.minimum);
  const std::size_t last = bin(statistics.maximum);
  const std::size_t together = std::max<std::size_t>(1, (last - first + bars) / bars);
  for (std::size_t begin = first; begin <= last; begin += together) {
    std::uint64_t count = 0;
    const std::size_t end = std::min(begin + together, last + 1);
    for (std::size_t i = begin; i < end; ++i) count += histogram.bins[i];
    const double middle = static_cast<double>(begin) + 0.5 * static_cast<double>(together);
    curve.x.push_back(histogram.low + middle * histogram.bin_width());
    curve.y.push_back(static_cast<double>(count));
  }
  return curve;
}

// The span of numbers, never empty.
void set_span(picture::FigureAxis& axis, const std::vector<double>& values) {
  axis.first = std::numeric_limits<double>::infinity();
  axis.last = -axis.first;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    axis.first = std::min(axis.first, value);
    axis.last = std::max(axis.last, value);
  }
  if (axis.first > axis.last) axis.first = axis.last = 0.0;
  const double more = axis.last > axis.first ? 0.05 * (axis.last - axis.first) : 0.5;
  axis.first -= more;
  axis.last += more;
}

}  // namespace

QString ImageViewer::value_unit() const {
  if (!source_) return {};
  const raster::RasterInfo& info = source_->info();
  // A file that is described by hand does not say what its numbers are.
  const bool volts =
      info.value == raster::ImageValue::complex && !info.counts && (!info.format->by_hand || !algorithm_.isEmpty());
  return volts ? QStringLiteral("V") : QString();
}

QString ImageViewer::unit() const {
  const bool of_values =
      look_.quantity != picture::DisplayQuantity::phase && look_.quantity != picture::DisplayQuantity::decibels;
  return of_values ? value_unit() : text_of(picture::unit_of(look_.quantity));
}

// What is measured counts from 1 V, not from the strongest sample in view.
QString ImageViewer::decibel_unit() const { return value_unit() == "V" ? QStringLiteral("dBV") : QStringLiteral("dB"); }

QString ImageViewer::words_at(SamplePlace place) const {
  const auto& part = plot_->part();
  const auto index = part ? part->nearest(place.column, place.row) : std::nullopt;
  if (!index) return {};
  const std::size_t row = part->window.row(*index / part->window.cols);
  const std::size_t column = part->window.column(*index % part->window.cols);
  const std::complex<double> s = part->samples[*index];
  QStringList words{tr("Row %1").arg(row), tr("Sample %1").arg(column)};
  if (axes_) {  // exact, also where pulses are not evenly spaced
    if (row < axes_->row_time_s.size() && std::isfinite(axes_->row_time_s[row]))
      words << tr("Time %1").arg(number_text(axes_->row_time_s[row], "s"));
    if (column < axes_->column_range_m.size() && std::isfinite(axes_->column_range_m[column]))
      words << tr("Range %1").arg(number_text(axes_->column_range_m[column], "m"));
  } else if (const auto& places = plot_->places()) {
    const auto say = [&](const raster::ImagePlaces& axis, std::size_t number) {
      if (axis.unit.empty()) return;
      words << QString::fromStdString(axis.label) + " " +
                   number_text(axis.first + axis.step * static_cast<double>(number), axis.unit.c_str());
    };
    say(places->azimuth, row);
    say(places->range, column);
  }
  if (!part->colours.empty()) {
    const raster::Rgb& c = part->colours[*index];
    words << tr("Red %1  green %2  blue %3").arg(c.red).arg(c.green).arg(c.blue);
    return words.join("   ");
  }
  if (part->peaks) {
    words << tr("Largest magnitude here %1").arg(number_text(s.real(), value_unit()));
    return words.join("   ");
  }
  const double db = shown_value(part->value, picture::DisplayQuantity::decibels, s, 1.0);
  if (part->value == raster::ImageValue::complex)
    words << "I " + number_text(s.real(), value_unit()) << "Q " + number_text(s.imag(), value_unit())
          << tr("Magnitude %1").arg(number_text(std::abs(s), value_unit()))
          << tr("Phase %1 deg").arg(picture::value_of(picture::DisplayQuantity::phase, s), 0, 'f', 2);
  else
    words << tr("Value %1").arg(number_text(s.real(), value_unit()));
  words << (db <= picture::lowest_db ? tr("no power") : QStringLiteral("%1 %2").arg(db, 0, 'f', 2).arg(decibel_unit()));
  return words.join("   ");
}

void ImageViewer::show_read_out() {
  const auto pointer = plot_->pointer_place();
  const auto& first = plot_->cursor(0);
  const auto& second = plot_->cursor(1);
  read_out_->say(pointer ? words_at(*pointer) : first ? words_at(*first) : QString());
  if (!first || !second) {
    difference_->say({});
    return;
  }
  QString words =
      tr("From 1 to 2:   %1 samples   %2 rows").arg(second->column - first->column).arg(second->row - first->row);
  const auto& part = plot_->part();
  const auto a = part ? part->nearest(first->column, first->row) : std::nullopt;
  const auto b = part ? part->nearest(second->column, second->row) : std::nullopt;
  if (a && b) {
    const double db = shown_value(part->value, picture::DisplayQuantity::decibels, part->samples[*b], 1.0) -
                      shown_value(part->value, picture::DisplayQuantity::decibels, part->samples[*a], 1.0);
    words += tr("   Level %1 dB").arg(db, 0, 'f', 2);
  }
  difference_->say(words);
}

void ImageViewer::show_cuts() {
  const auto& part = plot_->part();
  const bool wanted = show_cuts_->isChecked();
  for (FigurePlot* plot : {row_cut_, column_cut_}) plot->setVisible(wanted);
  if (!wanted || !part || part->samples.empty()) return;
  const ImageView& view = plot_->view();
  const SamplePlace at = plot_->cursor(0).value_or(
      SamplePlace{(view.column_first + view.column_last) / 2.0, (view.row_first + view.row_last) / 2.0});
  const auto index = part->nearest(at.column, at.row);
  if (!index) return;
  const std::size_t row = *index / part->window.cols;
  const std::size_t column = *index % part->window.cols;
  const PartColours& colours = plot_->painted().colours;
  const auto value = [&](std::size_t i, std::size_t k) {
    const double v =
        shown_value(part->value, look_.quantity, part->samples[i * part->window.cols + k], colours.reference_v);
    // The floor of what is drawn; silence would make the rest flat.
    return look_.quantity == picture::DisplayQuantity::decibels ? std::max(v, colours.limits.low) : v;
  };
  const raster::FocusedPlaces places = plot_->shown_places();
  const auto place = [](const raster::ImagePlaces& axis, double number) { return axis.first + axis.step * number; };
  picture::FigureCurve along;
  for (std::size_t k = 0; k < part->window.cols; ++k) {
    along.x.push_back(place(places.range, static_cast<double>(part->window.column(k))));
    along.y.push_back(value(row, k));
  }
  picture::FigureCurve across;
  across.role = picture::Role::curve_2;
  for (std::size_t i = 0; i < part->window.rows; ++i) {
    across.x.push_back(place(places.azimuth, static_cast<double>(part->window.row(i))));
    across.y.push_back(value(i, column));
  }
  const auto show = [&](FigurePlot* plot, picture::FigureCurve curve, std::size_t marked,
                        const raster::ImagePlaces& axis, const QString& title, double from, double to) {
    picture::FigurePanel panel;
    panel.title = title.toStdString();
    panel.x = {axis.label, axis.unit, place(axis, from), place(axis, to), {}};
    panel.y = {std::string(picture::axis_title_of(look_.quantity)), unit().toStdString(), 0.0, 1.0, {}};
    set_span(panel.y, curve.y);
    if (std::isfinite(curve.y[marked]))
      panel.marks.push_back({curve.x[marked], curve.y[marked],
                             picture::read_out_text(number_text(curve.y[marked], unit()).toStdString())});
    panel.curves.push_back(std::move(curve));
    picture::Figure figure;
    figure.panels.push_back(std::move(panel));
    plot->set_figure(figure);
  };
  show(row_cut_, std::move(along), column, places.range, tr("Row %1").arg(part->window.row(row)), view.column_first,
       view.column_last);
  show(column_cut_, std::move(across), row, places.azimuth, tr("Sample %1").arg(part->window.column(column)),
       view.row_first, view.row_last);
}

// A place in a cut is one of the image, on the line that is cut.
void ImageViewer::press_cut(const FigurePlot* cut, double place) {
  const auto& part = plot_->part();
  if (!part || part->samples.empty()) return;
  const ImageView& view = plot_->view();
  SamplePlace at = plot_->cursor(0).value_or(
      SamplePlace{(view.column_first + view.column_last) / 2.0, (view.row_first + view.row_last) / 2.0});
  const raster::FocusedPlaces places = plot_->shown_places();
  const auto number = [place](const raster::ImagePlaces& axis, std::size_t count) {
    const double nearest = std::round((place - axis.first) / axis.step);
    return std::isfinite(nearest) ? std::clamp(nearest, 0.0, static_cast<double>(count - 1)) : 0.0;
  };
  if (cut == row_cut_)
    at.column = number(places.range, source_->columns());
  else
    at.row = number(places.azimuth, rows_);
  plot_->set_cursor(0, SamplePlace{std::round(at.column), std::round(at.row)});
}

raster::ImageWindow ImageViewer::chosen() const {
  if (!source_) return {};
  if (plot_->selection()) return *plot_->selection();
  return samples_in(plot_->view(), rows_, source_->columns());
}

void ImageViewer::measure_soon() {
  if (!show_statistics_->isChecked()) return;
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
    figures_->say(tr("Measuring: %1").arg(share_with_time_left(share, left_s)));
  });
  connect(&measuring_, &BackgroundJob::ended, this, [this, result, of = source_](JobEnd end, const QString& failure) {
    if (std::exchange(measure_again_, false)) return measure();
    if (of != source_) return;  // Another file is shown by now.
    statistics_.reset();
    if (end == JobEnd::done) statistics_ = *result;
    show_statistics();
    if (end == JobEnd::failed) figures_->say(failure);
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
  const bool wanted = show_statistics_->isChecked();
  figures_->setVisible(wanted);
  histogram_->setVisible(wanted && statistics_);
  if (!wanted || !statistics_) return;
  const picture::QuantityStatistics& of = (*statistics_)[measured(look_.quantity)];
  const bool decibels = look_.quantity == picture::DisplayQuantity::decibels;
  const bool powers = source_ && source_->info().value == raster::ImageValue::power;
  // Measured are radians, and 20 log10 of whatever the values are.
  const double scale = look_.quantity == picture::DisplayQuantity::phase ? 180.0 / M_PI
                       : decibels && powers                              ? 0.5
                                                                         : 1.0;
  const QString of_unit = decibels ? decibel_unit() : unit();
  QStringList words{
      tr("%1 %2 samples").arg(plot_->selection() ? tr("Selection:") : tr("In view:")).arg(statistics_->samples)};
  const QString name = text_of(picture::title_of(look_.quantity));
  const auto add = [&](const QString& what, double value) {
    words << what + " " + number_text(value * scale, of_unit);
  };
  if (of.count > 0) {
    words << name + ":";
    add(tr("from"), of.minimum);
    add(tr("to"), of.maximum);
    add(tr("mean"), of.mean);
    add(tr("deviation"), of.deviation);
    if (!decibels) add(tr("RMS"), of.rms);
  }
  if (statistics_->zeros > 0) words << tr("%1 zero").arg(statistics_->zeros);
  if (statistics_->not_finite > 0) words << tr("%1 no number").arg(statistics_->not_finite);
  figures_->say(words.join("   "));
  picture::FigurePanel panel;
  picture::FigureCurve curve = bars_of(of);
  for (double& x : curve.x) x *= scale;
  panel.title = tr("How often").toStdString();
  panel.x = {name.toStdString(), of_unit.toStdString(), 0.0, 1.0, {}};
  set_span(panel.x, curve.x);
  panel.y = {tr("Samples").toStdString(), "", 0.0, 1.0, {}};
  for (const double y : curve.y) panel.y.last = std::max(panel.y.last, 1.05 * y);
  panel.curves.push_back(std::move(curve));
  picture::Figure figure;
  figure.panels.push_back(std::move(panel));
  histogram_->set_figure(figure);
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
    plot_->set_cursor(0, SamplePlace{reading_->column, reading_->row});
    show_reading({});
  });
  // A hand aims at what it sees: at so many pixels of the screen, whatever the zoom.
  constexpr double aim_px = 12.0;
  const ImageView& view = plot_->view();
  const QSize size = plot_->plot_rect().size();
  picture::PointOptions options;
  const auto reach = [](double samples) { return static_cast<std::size_t>(std::ceil(std::clamp(samples, 4.0, 1e3))); };
  options.search_rows = reach(aim_px * view.rows() / size.height());
  options.search_columns = reach(aim_px * view.columns() / size.width());
  pointing_.start([result, row, column, options, plane = raster::first_rows(source_, rows_)](
                      const core::StopFlag&, const BackgroundJob::Report&) {
    *result = picture::read_point(*plane, row, column, options);
  });
}

void ImageViewer::show_reading(const QString& words) {
  point_->show();
  if (!reading_) {
    point_->say(words);
    return;
  }
  const picture::PointReading& r = *reading_;
  const auto cut = [](const picture::CutReading& c, const QString& unit) {
    return tr("width %1 %2, PSLR %3 dB, ISLR %4 dB")
        .arg(c.width, 0, 'f', 3)
        .arg(unit)
        .arg(c.pslr_db, 0, 'f', 2)
        .arg(c.islr_db, 0, 'f', 2);
  };
  QString text = tr("Point at row %1, sample %2: peak %3, phase %4 deg\nAlong samples: %5\nAlong rows: %6")
                     .arg(r.row, 0, 'f', 2)
                     .arg(r.column, 0, 'f', 2)
                     .arg(number_text(std::abs(r.value), value_unit()))
                     .arg(picture::value_of(picture::DisplayQuantity::phase, r.value), 0, 'f', 2)
                     .arg(cut(r.along_row, tr("samples")), cut(r.along_column, tr("rows")));
  if (std::max(r.along_row.pslr_db, r.along_column.pslr_db) > 0.0)
    text +=
        "\n" + tr("A stronger response lies beside this one, which may be its sidelobe: click on the stronger one.");
  point_->say(text);
}

picture::Figure ImageViewer::figure() const {
  picture::Figure figure;
  const auto& part = plot_->part();
  if (!part || plot_->painted().image.isNull()) return figure;
  figure.title = path_.filename().string();
  const ImageView& view = plot_->view();
  const QImage& picture = plot_->painted().image;
  picture::FigurePanel panel;
  const raster::FocusedPlaces places = plot_->shown_places();
  const auto across = [&](double column) { return places.range.first + places.range.step * column; };
  const auto down = [&](double row) { return places.azimuth.first + places.azimuth.step * row; };
  panel.x = {places.range.label, places.range.unit, across(view.column_first), across(view.column_last), {}};
  panel.y = {places.azimuth.label, places.azimuth.unit, down(view.row_last), down(view.row_first), {}};
  if (look_.equal_scale && places.range.unit == "m" && places.azimuth.unit == "m") panel.y_per_x = 1.0;
  if (look_.draw_as != picture::DrawAs::pixels && part->colours.empty()) {
    for (const ImageSlice& slice : plot_->slices()) {
      picture::FigureCurve& curve = panel.curves.emplace_back();
      for (const QPointF& point : slice.points) {
        curve.x.push_back(across(point.x()));
        curve.y.push_back(down(point.y()));
      }
    }
    figure.panels.push_back(std::move(panel));
    return figure;
  }
  const QRectF place = extent_of(part->window);
  picture::FigureImage image;
  image.width = part->window.cols;
  image.height = part->window.rows;
  image.x_first = across(place.left());
  image.x_last = across(place.right());
  image.y_first = down(place.top());
  image.y_last = down(place.bottom());
  image.cells.reserve(part->window.samples());
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb c = picture.pixel(x, y);
      image.cells.push_back({static_cast<std::uint8_t>(qRed(c)), static_cast<std::uint8_t>(qGreen(c)),
                             static_cast<std::uint8_t>(qBlue(c))});
    }
  panel.image = std::move(image);
  const PartColours& colours = plot_->painted().colours;
  if (colours.table.size() > 1)
    panel.colour_bar = picture::FigureColourBar{std::string(picture::axis_title_of(colours.quantity)),
                                                unit().toStdString(),
                                                colours.limits.low,
                                                colours.limits.high,
                                                colours.table,
                                                picture::kind_for(colours.quantity)};
  figure.panels.push_back(std::move(panel));
  return figure;
}

void ImageViewer::copy_picture() { QApplication::clipboard()->setImage(plot_->plot_image()); }

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
    state_->setText(tr("Writing: %1").arg(share_with_time_left(share, left_s)));
  });
  connect(&exporting_, &BackgroundJob::ended, this, [this, path](JobEnd end, const QString& failure) {
    export_->setText(tr("Export Samples..."));
    state_->setText(end == JobEnd::done        ? tr("Wrote %1").arg(QFileInfo(path).fileName())
                    : end == JobEnd::cancelled ? tr("Export cancelled")
                                               : QString());
    if (end == JobEnd::failed) {
      read_failure_ = failure;
      show_problems();
    }
    emit exported(end == JobEnd::done);
  });
  export_->setText(tr("Cancel Export"));
  exporting_.start([source = source_, window = chosen(), path, options](const core::StopFlag& stop,
                                                                        const BackgroundJob::Report& report) {
    raster::export_window(*source, window, path.toStdString(), options, {1, &stop}, [&](const core::Progress& p) {
      if (p.total > 0) report(static_cast<double>(p.done) / static_cast<double>(p.total));
    });
  });
}

void ImageViewer::show_targets(bool on) {
  targets_->setVisible(on);
  if (on)
    targets_->measure(path_);
  else
    targets_->forget();
  if (!on) show_rings();
}

// A ring where each target should be that has echoes in the image.
void ImageViewer::show_rings() {
  std::vector<ImagePlot::Ring> rings;
  std::optional<std::size_t> chosen;
  rows_of_rings_.clear();
  const auto& places = plot_->places();
  const std::vector<picture::TargetTable::Row>& rows = targets_->table().rows;
  for (std::size_t i = 0; places && i < rows.size(); ++i) {
    if (!rows[i].inside) continue;
    if (targets_->chosen() == i) chosen = rings.size();
    rows_of_rings_.push_back(i);
    rings.push_back({{(rows[i].expected.range_m - places->range.first) / places->range.step,
                      (rows[i].expected.azimuth_m - places->azimuth.first) / places->azimuth.step},
                     rows[i].found});
  }
  plot_->set_rings(std::move(rings), chosen);
}

// Brings a target that is out of sight into the middle.
void ImageViewer::frame_target(std::size_t row) {
  show_rings();
  const auto at = std::ranges::find(rows_of_rings_, row);
  if (at == rows_of_rings_.end()) return;
  const SamplePlace place = plot_->rings().at(static_cast<std::size_t>(at - rows_of_rings_.begin())).at;
  const ImageView& v = plot_->view();
  if (place.column > v.column_first && place.column < v.column_last && place.row > v.row_first &&
      place.row < v.row_last)
    return;
  go_to({place.column - v.columns() / 2.0, place.column + v.columns() / 2.0, place.row - v.rows() / 2.0,
         place.row + v.rows() / 2.0});
}

}  // namespace sarsim::gui

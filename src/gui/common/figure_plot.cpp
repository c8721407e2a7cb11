#include "gui/common/figure_plot.hpp"

#include <QFileDialog>
#include <QMessageBox>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "gui/common/figure_text.hpp"
#include "gui/common/palette_colours.hpp"
#include "picture/figure/picture_file.hpp"
#include "picture/figure/ticks.hpp"

namespace sarsim::gui {

namespace {

constexpr int bar_width_px = 14;
constexpr std::size_t max_stops = 256;
constexpr double words_turn_at = 0.75;  // share of a panel's width

// Marks at round numbers for whatever length and span the axis has when it is drawn, and the axis title with their
// unit: one object decides both, so that they cannot differ.
class RoundTicker : public QCPAxisTicker {
 public:
  /// @param name    of the axis, without its unit
  /// @param factor  what the values of the axis are multiplied by to be those of `unit`
  RoundTicker(QCPAxis* axis, const std::string& name, std::string unit, double spacing_px, double factor)
      : axis_(axis),
        name_(QString::fromStdString(name)),
        unit_(std::move(unit)),
        spacing_px_(spacing_px),
        factor_(factor) {}

  void generate(const QCPRange& range, const QLocale& /*locale*/, QChar /*format*/, int /*precision*/,
                QVector<double>& ticks, QVector<double>* sub_ticks, QVector<QString>* labels) override {
    const QRect area = axis_->axisRect()->rect();
    const QRect around = axis_->axisRect()->parentPlot()->viewport();
    const bool known = area.width() > 0 && area.height() > 0;
    const double length =
        axis_->orientation() == Qt::Horizontal ? (known ? area : around).width() : (known ? area : around).height();
    const picture::Ticks marks =
        picture::axis_ticks(range.lower * factor_, range.upper * factor_, length, spacing_px_, unit_);
    axis_->setLabel(marks.unit.empty() ? name_
                                       : name_ + QStringLiteral(" (%1)").arg(QString::fromStdString(marks.unit)));
    ticks.clear();
    if (sub_ticks != nullptr) sub_ticks->clear();
    if (labels != nullptr) labels->clear();
    for (const picture::Tick& mark : marks.ticks) {
      ticks.append(mark.value / factor_);
      if (labels != nullptr) labels->append(QString::fromStdString(mark.label));
    }
  }

 private:
  QCPAxis* axis_;
  QString name_;
  std::string unit_;
  double spacing_px_;
  double factor_;
};

QVector<double> numbers(const std::vector<double>& list) { return {list.begin(), list.end()}; }

}  // namespace

FigurePlot::FigurePlot(QWidget* parent) : QCustomPlot(parent) {
  setObjectName("figure");
  setAccessibleName(tr("Figure"));
  setInteractions(QCP::iNone);
  // The first legend would collect the curves of all panels.
  setAutoAddPlottableToLegend(false);
  setMinimumSize(200, 150);
  // Whatever changes the lengths of the axes, scales are equal before anything is drawn.
  connect(this, &QCustomPlot::afterLayout, this, &FigurePlot::keep_scales);
  rebuild();
}

// Whether another figure differs in the colours of cells alone.
bool FigurePlot::has_frame_of(const picture::Figure& figure) const {
  const auto frame_of = [](picture::Figure of) {
    for (picture::FigurePanel& panel : of.panels)
      if (panel.image) panel.image->cells.clear();
    return of;
  };
  const bool images =
      !figure.panels.empty() && std::ranges::all_of(images_, [](auto* item) { return item != nullptr; });
  return images && images_.size() == figure.panels.size() && frame_of(figure_) == frame_of(figure);
}

void FigurePlot::set_figure(const picture::Figure& figure) {
  // A picture that moves has the axes that it had.
  if (has_frame_of(figure)) {
    figure_ = figure;
    for (std::size_t i = 0; i < images_.size(); ++i)
      images_[i]->show(*figure_.panels[i].image, figure_.panels[i].colour_bar);
    replot(rpQueuedReplot);
    return;
  }
  figure_ = figure;
  rebuild();
  updateLayout();  // for the lengths of the axes, which the marks have to suit
  replot();
}

QColor FigurePlot::ink(picture::Role role) const { return colour_of(role, palette()); }

void FigurePlot::rebuild() {
  clearPlottables();
  clearItems();
  panels_.clear();
  images_.clear();
  plotLayout()->clear();
  legend = nullptr;
  qDeleteAll(findChildren<QCPMarginGroup*>(QString(), Qt::FindDirectChildrenOnly));  // Nobody else takes them away.
  setBackground(QBrush(ink(picture::Role::background)));
  int row = 0;
  if (!figure_.title.empty()) add_text(row++, QString::fromStdString(figure_.title), true);
  for (const picture::FigurePanel& panel : figure_.panels) {
    if (!panel.title.empty()) add_text(row++, QString::fromStdString(panel.title), false);
    add_panel(row++, panel);
  }
  if (!figure_.note.empty()) add_text(row, QString::fromStdString(figure_.note), false);
  // Axes below each other begin and end at the same place.
  auto* const margins = new QCPMarginGroup(this);
  for (const auto& rect : panels_) rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
}

void FigurePlot::add_text(int row, const QString& text, bool bold) {
  QFont shown = font();
  shown.setBold(bold);
  auto* const element = new FigureText(this, text, shown);
  element->setTextColor(ink(picture::Role::text));
  element->setMargins(QMargins(4, 4, 4, 2));
  plotLayout()->addElement(row, 0, element);
  // Words take the room they need; panels share the rest.
  plotLayout()->setRowStretchFactor(row, 0.001);
}

void FigurePlot::add_panel(int row, const picture::FigurePanel& panel) {
  auto* const rect = new QCPAxisRect(this);
  plotLayout()->addElement(row, 0, rect);
  panels_.emplace_back(rect);
  images_.push_back(nullptr);
  rect->setupFullAxesBox();
  for (QCPAxis* axis : rect->axes()) dress(axis);
  for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) rect->axis(side)->setTicks(false);
  add_axis(rect->axis(QCPAxis::atBottom), panel.x, 8.0 * fontMetrics().averageCharWidth() + 24.0);
  add_axis(rect->axis(QCPAxis::atLeft), panel.y, 2.5 * fontMetrics().height());
  if (panel.x.twin) add_twin(rect->axis(QCPAxis::atTop), panel.x, 8.0 * fontMetrics().averageCharWidth() + 24.0);
  if (panel.y.twin) add_twin(rect->axis(QCPAxis::atRight), panel.y, 2.5 * fontMetrics().height());
  if (panel.image && !panel.image->cells.empty()) {
    images_.back() = new CellsItem(*rect);
    images_.back()->show(*panel.image, panel.colour_bar);
    for (QCPAxis* axis : rect->axes()) axis->grid()->setVisible(false);
  }
  for (const picture::FigureCurve& curve : panel.curves) add_curve(rect, curve);
  for (const picture::FigureMark& mark : panel.marks) add_mark(rect, mark);
  add_legend(rect, panel);
  if (panel.colour_bar) add_colour_bar(row, rect, *panel.colour_bar);
}

void FigurePlot::dress(QCPAxis* axis) {
  for (const auto& set : {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
    (axis->*set)(QPen(ink(picture::Role::text)));
  axis->setTickLabelColor(ink(picture::Role::text));
  axis->setLabelColor(ink(picture::Role::text));
  axis->setTickLabelFont(font());
  axis->setLabelFont(font());
  axis->setSubTicks(false);
  axis->grid()->setPen(QPen(ink(picture::Role::faint), 0, Qt::DotLine));
  axis->grid()->setZeroLinePen(QPen(ink(picture::Role::faint)));
}

// A circle on the ground is one in the picture: the axis that has room to spare shows more than the image.
void FigurePlot::keep_scales() {
  constexpr double longest_strip = 3.0;
  for (std::size_t i = 0; i < panels_.size() && i < figure_.panels.size(); ++i) {
    const picture::FigurePanel& panel = figure_.panels[i];
    QCPAxisRect* const rect = panels_[i];
    if (rect == nullptr || !panel.image || panel.x.unit != "m" || panel.y.unit != "m") continue;
    const double across_m = std::abs(panel.x.last - panel.x.first);
    const double up_m = std::abs(panel.y.last - panel.y.first);
    if (!(across_m > 0.0) || !(up_m > 0.0) || rect->width() < 2 || rect->height() < 2) continue;
    if (std::max(across_m, up_m) > longest_strip * std::min(across_m, up_m)) continue;
    const double metres_per_px = std::max(across_m / rect->width(), up_m / rect->height());
    const auto show = [&](QCPAxis::AxisType first, QCPAxis::AxisType second, const picture::FigureAxis& axis,
                          int length_px) {
      const double middle = 0.5 * (axis.first + axis.last);
      const double half = 0.5 * metres_per_px * length_px;
      for (const auto side : {first, second}) rect->axis(side)->setRange(middle - half, middle + half);
    };
    show(QCPAxis::atBottom, QCPAxis::atTop, panel.x, rect->width());
    show(QCPAxis::atLeft, QCPAxis::atRight, panel.y, rect->height());
    rect->update(QCPLayoutElement::upPreparation);  // Marks were made for the ranges before.
  }
}

void FigurePlot::add_axis(QCPAxis* axis, const picture::FigureAxis& described, double spacing_px) {
  axis->setRange(std::min(described.first, described.last), std::max(described.first, described.last));
  axis->setRangeReversed(described.last < described.first);
  axis->setTicker(QSharedPointer<RoundTicker>::create(axis, described.label, described.unit, spacing_px, 1.0));
}

void FigurePlot::add_twin(QCPAxis* axis, const picture::FigureAxis& described, double spacing_px) {
  const picture::FigureAxis::Twin& twin = *described.twin;
  axis->setRange(std::min(described.first, described.last), std::max(described.first, described.last));
  axis->setRangeReversed(described.last < described.first);
  axis->setTicks(true);
  axis->setTickLabels(true);
  axis->setTicker(QSharedPointer<RoundTicker>::create(axis, twin.label, twin.unit, spacing_px, twin.factor));
}

void FigurePlot::add_curve(QCPAxisRect* rect, const picture::FigureCurve& curve) {
  QCPAxis* const across = rect->axis(QCPAxis::atBottom);
  QCPAxis* const up = rect->axis(QCPAxis::atLeft);
  QCPAbstractPlottable* drawn = nullptr;
  if (curve.bars) {
    auto* const bars = new QCPBars(across, up);
    bars->setData(numbers(curve.x), numbers(curve.y));
    bars->setWidthType(QCPBars::wtPlotCoords);
    if (curve.x.size() > 1) bars->setWidth(0.7 * std::abs(curve.x[1] - curve.x[0]));
    QColor filled = ink(curve.role);
    filled.setAlphaF(0.4F);
    bars->setBrush(filled);
    drawn = bars;
  } else {
    // Not a graph: what is plotted need not be a function of x.
    auto* const line = new QCPCurve(across, up);
    line->setData(numbers(curve.x), numbers(curve.y));
    drawn = line;
  }
  drawn->setPen(QPen(ink(curve.role), 1.5));
  drawn->setName(QString::fromStdString(curve.name));
}

// Light on dark, so that it is seen on any colour.
void FigurePlot::add_ring(QCPAxisRect* rect, const picture::FigureMark& mark) {
  for (const auto& [colour, width] : {std::pair{Qt::black, 3.0}, std::pair{Qt::white, 1.3}}) {
    auto* const ring = new QCPItemTracer(this);
    ring->position->setType(QCPItemPosition::ptPlotCoords);
    ring->position->setAxisRect(rect);
    ring->position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    ring->position->setCoords(mark.x, mark.y);
    ring->setStyle(QCPItemTracer::tsCircle);
    ring->setSize(16.0);
    ring->setPen(QPen(QColor(colour), width));
    ring->setClipAxisRect(rect);
    ring->setClipToAxisRect(true);
  }
}

void FigurePlot::add_mark(QCPAxisRect* rect, const picture::FigureMark& mark) {
  if (mark.ring) return add_ring(rect, mark);
  auto* const cross = new QCPItemTracer(this);
  auto* const words = new QCPItemText(this);
  for (QCPItemPosition* place : {cross->position, words->position}) {
    place->setType(QCPItemPosition::ptPlotCoords);
    place->setAxisRect(rect);
    place->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    place->setCoords(mark.x, mark.y);
  }
  cross->setStyle(QCPItemTracer::tsPlus);
  cross->setSize(9.0);
  cross->setPen(QPen(ink(picture::Role::error), 1.5));
  words->setText(QString::fromStdString(mark.text));
  // Words at the right end of the panel stand to the left of their place, where they have room.
  const QCPAxis* const across = rect->axis(QCPAxis::atBottom);
  const double share = (mark.x - across->range().lower) / across->range().size();
  const bool at_end = (across->rangeReversed() ? 1.0 - share : share) > words_turn_at;
  words->setPositionAlignment((at_end ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
  words->setPadding(QMargins(6, 2, 6, 4));
  words->setFont(font());
  words->setColor(ink(picture::Role::error));
  for (QCPAbstractItem* item : {static_cast<QCPAbstractItem*>(cross), static_cast<QCPAbstractItem*>(words)}) {
    item->setClipAxisRect(rect);
    item->setClipToAxisRect(true);
  }
}

void FigurePlot::add_legend(QCPAxisRect* rect, const picture::FigurePanel& panel) {
  const bool named = std::ranges::any_of(panel.curves, [](const picture::FigureCurve& c) { return !c.name.empty(); });
  if (!named) return;
  auto* const names = new QCPLegend;
  rect->insetLayout()->addElement(names, Qt::AlignTop | Qt::AlignRight);
  names->setLayer("legend");
  names->setBrush(ink(picture::Role::background));
  names->setBorderPen(QPen(ink(picture::Role::faint)));
  names->setTextColor(ink(picture::Role::text));
  names->setFont(font());
  for (QCPAbstractPlottable* plottable : rect->plottables())
    if (!plottable->name().isEmpty()) plottable->addToLegend(names);
}

void FigurePlot::add_colour_bar(int row, QCPAxisRect* rect, const picture::FigureColourBar& bar) {
  auto* const scale = new QCPColorScale(this);
  plotLayout()->addElement(row, 1, scale);
  scale->setType(QCPAxis::atRight);
  scale->setBarWidth(bar_width_px);
  QCPColorGradient gradient;
  gradient.clearColorStops();
  gradient.setColorInterpolation(QCPColorGradient::ciRGB);
  const std::size_t step = (bar.colours.size() + max_stops - 1) / max_stops;
  for (std::size_t i = 0; i < bar.colours.size(); i += step) {
    const raster::Rgb& c = bar.colours[i];
    gradient.setColorStopAt(static_cast<double>(i) / static_cast<double>(bar.colours.size() - 1),
                            QColor(c.red, c.green, c.blue));
  }
  scale->setGradient(gradient);
  scale->setDataRange(QCPRange(bar.first, bar.last));
  dress(scale->axis());
  scale->axis()->setRange(bar.first, bar.last);
  scale->axis()->setTicker(
      QSharedPointer<RoundTicker>::create(scale->axis(), bar.label, bar.unit, 2.5 * fontMetrics().height(), 1.0));
  auto* const margins = new QCPMarginGroup(this);
  scale->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
  rect->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
}

void FigurePlot::mousePressEvent(QMouseEvent* event) {
  QCustomPlot::mousePressEvent(event);
  tell_place(*event);
}

void FigurePlot::mouseMoveEvent(QMouseEvent* event) {
  QCustomPlot::mouseMoveEvent(event);
  tell_place(*event);
}

void FigurePlot::tell_place(const QMouseEvent& event) {
  if (!event.buttons().testFlag(Qt::LeftButton)) return;
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    const QCPAxisRect* const rect = panels_[i];
    if (rect == nullptr || !rect->rect().contains(event.position().toPoint())) continue;
    emit pressed_at(i, rect->axis(QCPAxis::atBottom)->pixelToCoord(event.position().x()),
                    rect->axis(QCPAxis::atLeft)->pixelToCoord(event.position().y()));
    return;
  }
}

void FigurePlot::resizeEvent(QResizeEvent* event) {
  QCustomPlot::resizeEvent(event);
  updateLayout();
  replot(rpQueuedReplot);
}

void FigurePlot::changeEvent(QEvent* event) {
  QCustomPlot::changeEvent(event);
  if (event->type() != QEvent::PaletteChange && event->type() != QEvent::FontChange) return;
  rebuild();
  replot(rpQueuedReplot);
}

bool FigurePlot::save(const QString& path, QSize size, double scale, QString& failure) {
  const std::filesystem::path file = path.toStdString();
  if (!picture::picture_kind_of(file)) {
    const std::string_view endings = picture::picture_endings;
    failure = tr("'%1': pictures are written as %2")
                  .arg(path, QString::fromUtf8(endings.data(), static_cast<qsizetype>(endings.size())));
    return false;
  }
  try {
    picture::write_picture(figure_, file, {size.width(), size.height(), scale, is_dark(palette())});
    return true;
  } catch (const std::system_error& error) {
    failure = tr("'%1' could not be written: %2").arg(path, QString::fromStdString(error.code().message()));
  } catch (const std::exception& error) {
    failure = QString::fromUtf8(error.what());
  }
  return false;
}

void ask_and_save_picture(QWidget& parent, const picture::Figure& figure, const QString& suggested) {
  const QString title = FigurePlot::tr("Save picture");
  const QString path =
      QFileDialog::getSaveFileName(&parent, title, suggested, FigurePlot::tr("Pictures (*.png *.svg *.pdf)"));
  if (path.isEmpty()) return;
  FigurePlot drawn;
  drawn.setPalette(parent.palette());
  drawn.set_figure(figure);
  QString failure;
  if (!drawn.save(path, parent.size(), parent.devicePixelRatioF(), failure))
    QMessageBox::warning(&parent, title, failure);
}

}  // namespace sarsim::gui

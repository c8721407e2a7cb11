#include "gui/objects/function_plot.hpp"

#include <QRubberBand>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/text/number_text.hpp"
#include "gui/common/palette_colours.hpp"
#include "picture/figure/ticks.hpp"

namespace sarsim::gui {

namespace {

constexpr double reach_px = 8.0;
constexpr int smallest_rectangle_px = 4;
constexpr double zoom_step = 2.0;
constexpr double wheel_step = 1.25;
constexpr double margin_share = 0.05;
constexpr std::size_t max_corners = 20'000;

bool finite(const core::Knot& knot) { return std::isfinite(knot.x) && std::isfinite(knot.y); }

QString text_of(double value) { return QString::fromStdString(core::format_number(value)); }

QVector<QCPGraphData> graph_data(const std::vector<core::Knot>& points) {
  QVector<QCPGraphData> shown;
  shown.reserve(static_cast<qsizetype>(points.size()));
  for (const core::Knot& point : points)
    if (finite(point)) shown.append({point.x, point.y});
  return shown;
}

std::array<double, 2> widened(std::array<double, 2> range, double share) {
  const double more = share * (range[1] - range[0]);
  return {range[0] - more, range[1] + more};
}

}  // namespace

FunctionPlot::FunctionPlot(QWidget* parent) : QCustomPlot(parent) {
  setObjectName("function_plot");
  setAccessibleName(tr("Graph of the function"));
  setAccessibleDescription(
      tr("Points can be dragged; a rectangle zooms in, a right click zooms out. The table has the same points."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setInteractions(QCP::iNone);
  const int letter = fontMetrics().height();
  setMinimumSize(letter * 20, letter * 14);
  make_items();
  redraw();
}

void FunctionPlot::make_items() {
  bars_ = new QCPBars(xAxis, yAxis);
  bars_->setWidthType(QCPBars::wtPlotCoords);
  bars_->setWidth(0.7);
  const std::array<QString, 3> names{tr("Linear"), tr("Cubic splines"), tr("Low-pass filter")};
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    curves_[i] = addGraph();
    curves_[i]->setName(names[i]);
  }
  points_ = addGraph();
  points_->setLineStyle(QCPGraph::lsNone);
  points_->setName(tr("Samples"));
  current_point_ = addGraph();
  current_point_->setLineStyle(QCPGraph::lsNone);
  coordinates_ = new QCPItemText(this);
  coordinates_->setVisible(false);
  coordinates_->position->setType(QCPItemPosition::ptAbsolute);
  coordinates_->setPadding(QMargins(4, 2, 4, 2));
  bars_->removeFromLegend();
  points_->removeFromLegend();
  current_point_->removeFromLegend();
  x_ticker_ = QSharedPointer<QCPAxisTickerText>::create();
  y_ticker_ = QSharedPointer<QCPAxisTickerText>::create();
  xAxis->setTicker(x_ticker_);
  yAxis->setTicker(y_ticker_);
  for (QCPAxis* axis : {xAxis2, yAxis2}) {
    axis->setVisible(true);
    axis->setTicks(false);
    axis->setTickLabels(false);
  }
  band_ = new QRubberBand(QRubberBand::Rectangle, this);
}

void FunctionPlot::set_info(const scene::FunctionInfo& info, std::size_t part) {
  info_ = info;
  part_ = part;
}

void FunctionPlot::set_function(const core::SampledFunction& function) {
  function_ = function;
  redraw();
}

void FunctionPlot::set_compare(bool compare) {
  compare_ = compare;
  redraw();
}

void FunctionPlot::set_current(std::optional<std::size_t> knot) {
  current_ = knot;
  refresh_knots();
  replot(rpQueuedReplot);
}

// Ends exchanged or moved apart, and not farther than a margin beyond what is legal.
void FunctionPlot::set_range(const std::array<double, 2>& limits, std::array<double, 2>& range) const {
  if (!std::isfinite(range[0]) || !std::isfinite(range[1])) range = {0.0, 1.0};
  if (range[0] > range[1]) std::swap(range[0], range[1]);
  constexpr double largest = 1e18;
  double low = std::max(limits[0], -largest);
  double high = std::min(limits[1], largest);
  const double margin = margin_share * (range[1] - range[0]);
  if (std::isfinite(limits[0]) && std::isfinite(limits[1])) {
    low -= margin_share * (high - low);
    high += margin_share * (limits[1] - limits[0]);
  } else {
    low -= margin;
    high += margin;
  }
  range = {std::clamp(range[0], low, high), std::clamp(range[1], low, high)};
  const double least = 1e-9 * std::max({std::abs(range[0]), std::abs(range[1]), 1e-12});
  if (range[1] - range[0] < least) {
    const double middle = 0.5 * (range[0] + range[1]);
    const double apart = std::max(least, middle == 0.0 ? 0.5 : 1e-3 * std::abs(middle));
    range = {middle - apart, middle + apart};
  }
}

void FunctionPlot::set_window(Window window) {
  constexpr double anything = std::numeric_limits<double>::infinity();
  set_range(info_.per_pulse ? std::array{-1.0, anything} : info_.x_limits, window.x);
  set_range({-anything, anything}, window.y);
  window_ = window;
  xAxis->setRange(window_.x[0], window_.x[1]);
  yAxis->setRange(window_.y[0], window_.y[1]);
  redraw();
  emit window_changed();
}

void FunctionPlot::zoom_about(double x, double y, double factor_x, double factor_y) {
  Window window = window_;
  for (double& end : window.x) end = x + factor_x * (end - x);
  for (double& end : window.y) end = y + factor_y * (end - y);
  set_window(window);
}

void FunctionPlot::zoom(double factor_x, double factor_y) {
  zoom_about(0.5 * (window_.x[0] + window_.x[1]), 0.5 * (window_.y[0] + window_.y[1]), factor_x, factor_y);
}

void FunctionPlot::fit() {
  Window window{info_.x_range, part_ < info_.parts.size() ? info_.parts[part_].y_range : std::array{0.0, 1.0}};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const std::size_t count = function_.knots.size();
  for (const core::Knot& knot : function_.knots) {
    if (!finite(knot)) continue;
    low = std::min(low, knot.y);
    high = std::max(high, knot.y);
  }
  if (info_.per_pulse)
    window.x = {-0.5, std::max(1.0, static_cast<double>(count)) - 0.5};
  else if (count > 1 && function_.knots.back().x > function_.knots.front().x)
    window.x = widened({function_.knots.front().x, function_.knots.back().x}, margin_share);
  else if (count == 1 && (function_.knots[0].x < window.x[0] || function_.knots[0].x > window.x[1]))
    window.x = {window.x[0] + function_.knots[0].x, window.x[1] + function_.knots[0].x};
  if (info_.per_pulse) low = std::min(low, 0.0);
  if (high > low)
    window.y = widened({low, high}, margin_share);
  else if (std::isfinite(low) && (low <= window.y[0] || low >= window.y[1]))
    window.y = {window.y[0] + low, window.y[1] + low};
  set_window(window);
}

core::Knot FunctionPlot::shown_knot(std::size_t knot) const {
  const core::Knot& at = function_.knots[knot];
  return info_.per_pulse ? core::Knot{static_cast<double>(knot), at.y} : at;
}

QPointF FunctionPlot::knot_pixel(std::size_t knot) const {
  const core::Knot at = shown_knot(knot);
  return {xAxis->coordToPixel(at.x), yAxis->coordToPixel(at.y)};
}

std::optional<std::size_t> FunctionPlot::knot_at(const QPointF& pixel) const {
  std::optional<std::size_t> nearest;
  double least = reach_px;
  for (std::size_t i = 0; i < function_.knots.size(); ++i) {
    const QPointF away = knot_pixel(i) - pixel;
    const double distance = std::hypot(away.x(), away.y());
    if (distance > least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

core::Knot FunctionPlot::value_at(const QPointF& pixel) const {
  return {xAxis->pixelToCoord(pixel.x()), yAxis->pixelToCoord(pixel.y())};
}

QPointF FunctionPlot::inside(const QPointF& pixel) const {
  const QRectF plot(axisRect()->rect());
  return {std::clamp(pixel.x(), plot.left(), plot.right()), std::clamp(pixel.y(), plot.top(), plot.bottom())};
}

void FunctionPlot::redraw() {
  refresh_colours();
  refresh_axes();
  refresh_curves();
  refresh_knots();
  replot(rpQueuedReplot);
}

void FunctionPlot::refresh_axes() {
  if (part_ >= info_.parts.size()) return;
  refresh_axis(xAxis, QString::fromStdString(info_.x_name), info_.x_unit, *x_ticker_);
  refresh_axis(yAxis, QString::fromStdString(info_.parts[part_].name), info_.parts[part_].y_unit, *y_ticker_);
}

void FunctionPlot::refresh_axis(QCPAxis* axis, const QString& name, const std::string& unit,
                                QCPAxisTickerText& ticker) {
  const bool across = axis == xAxis;
  const auto& range = across ? window_.x : window_.y;
  const double length = across ? axisRect()->width() : axisRect()->height();
  const double spacing =
      across ? fontMetrics().horizontalAdvance(QStringLiteral("-000.00  ")) : 2.5 * fontMetrics().height();
  const picture::Ticks ticks = picture::axis_ticks(range[0], range[1], length, spacing, unit);
  ticker.clear();
  for (const picture::Tick& tick : ticks.ticks) ticker.addTick(tick.value, QString::fromStdString(tick.label));
  axis->setLabel(ticks.unit.empty() ? name : name + QStringLiteral(" (%1)").arg(QString::fromStdString(ticks.unit)));
}

void FunctionPlot::refresh_curves() {
  const auto chosen = static_cast<std::size_t>(function_.method);
  const auto width = static_cast<std::size_t>(std::max(200, 2 * axisRect()->width()));
  bars_->setVisible(info_.per_pulse);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const bool shown = !info_.per_pulse && (i == chosen || compare_);
    curves_[i]->setVisible(shown);
    if (!shown) continue;
    const auto method = static_cast<core::Interpolation>(i);
    const auto role = part_ < info_.parts.size() ? info_.parts[part_].role : scene::FunctionRole::list;
    std::vector<core::Knot> points = scene::curve_points(function_, role, method, window_.x[0], window_.x[1], width);
    // Corners stand where the points are, not where the pixels are.
    if (method != core::Interpolation::low_pass && function_.knots.size() <= max_corners)
      for (const core::Knot& knot : function_.knots)
        if (knot.x >= window_.x[0] && knot.x <= window_.x[1]) points.push_back(knot);
    curves_[i]->data()->set(graph_data(points), false);
  }
  legend->setVisible(compare_ && !info_.per_pulse);
  if (!info_.per_pulse) return;
  QVector<QCPBarsData> bars;
  for (std::size_t i = 0; i < function_.knots.size(); ++i)
    if (finite(function_.knots[i])) bars.append({static_cast<double>(i), function_.knots[i].y});
  bars_->data()->set(bars, true);
}

void FunctionPlot::refresh_knots() {
  std::vector<core::Knot> shown;
  shown.reserve(function_.knots.size());
  for (std::size_t i = 0; i < function_.knots.size(); ++i) shown.push_back(shown_knot(i));
  points_->data()->set(graph_data(shown), false);
  std::vector<core::Knot> marked;
  if (current_ && *current_ < shown.size()) marked.push_back(shown[*current_]);
  current_point_->data()->set(graph_data(marked), true);
}

void FunctionPlot::refresh_colours() {
  const auto role = [this](picture::Role r) { return colour_of(r, palette()); };
  setBackground(QBrush(role(picture::Role::background)));
  for (QCPAxis* axis : {xAxis, yAxis, xAxis2, yAxis2}) {
    for (const auto& set : {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
      (axis->*set)(QPen(role(picture::Role::text)));
    axis->setTickLabelColor(role(picture::Role::text));
    axis->setLabelColor(role(picture::Role::text));
    axis->setTickLabelFont(font());
    axis->setLabelFont(font());
    axis->grid()->setPen(QPen(role(picture::Role::faint), 0, Qt::DotLine));
    axis->grid()->setZeroLinePen(QPen(role(picture::Role::faint)));
    axis->setSubTicks(false);
  }
  legend->setBrush(role(picture::Role::background));
  legend->setBorderPen(QPen(role(picture::Role::faint)));
  legend->setTextColor(role(picture::Role::text));
  legend->setFont(font());
  bars_->setPen(QPen(role(picture::Role::curve)));
  QColor filled = role(picture::Role::curve);
  filled.setAlphaF(0.4F);
  bars_->setBrush(filled);
  points_->setScatterStyle(
      {QCPScatterStyle::ssCircle, QPen(role(picture::Role::error), 1.5), QBrush(role(picture::Role::background)), 7.0});
  current_point_->setScatterStyle(
      {QCPScatterStyle::ssDisc, QPen(role(picture::Role::error), 2.0), QBrush(role(picture::Role::error)), 10.0});
  coordinates_->setColor(role(picture::Role::text));
  coordinates_->setBrush(role(picture::Role::background));
  coordinates_->setPen(QPen(role(picture::Role::faint)));
  coordinates_->setFont(font());
  // Told apart by their strokes as well: the chosen one is thick and solid.
  const std::array roles{picture::Role::curve, picture::Role::curve_2, picture::Role::curve_3};
  const std::array strokes{Qt::DashLine, Qt::DashDotLine, Qt::DotLine};
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const bool chosen = i == static_cast<std::size_t>(function_.method);
    QColor colour = role(roles[i]);
    if (!chosen) colour.setAlphaF(0.6F);
    curves_[i]->setPen(chosen ? QPen(colour, 2.0) : QPen(colour, 1.0, strokes[i]));
  }
}

QString FunctionPlot::coordinates_text(core::Knot at) const {
  const auto with_unit = [](double value, const std::string& unit) {
    return unit.empty() ? text_of(value) : text_of(value) + ' ' + QString::fromStdString(unit);
  };
  const std::string& y_unit = part_ < info_.parts.size() ? info_.parts[part_].y_unit : info_.x_unit;
  return with_unit(at.x, info_.x_unit) + QStringLiteral(", ") + with_unit(at.y, y_unit);
}

void FunctionPlot::show_coordinates(const QPointF& pixel, core::Knot at) {
  coordinates_->setText(coordinates_text({scene::rounded_to_range(at.x, window_.x[1] - window_.x[0]),
                                          scene::rounded_to_range(at.y, window_.y[1] - window_.y[0])}));
  const QRectF plot(axisRect()->rect());
  const bool left = pixel.x() > plot.center().x();
  const bool above = pixel.y() > plot.center().y();
  coordinates_->setPositionAlignment((left ? Qt::AlignRight : Qt::AlignLeft) |
                                     (above ? Qt::AlignBottom : Qt::AlignTop));
  const double away = reach_px + 2.0;
  coordinates_->position->setCoords(pixel.x() + (left ? -away : away), pixel.y() + (above ? -away : away));
  coordinates_->setVisible(true);
}

void FunctionPlot::hide_coordinates() {
  if (!coordinates_->visible()) return;
  coordinates_->setVisible(false);
  replot(rpQueuedReplot);
}

void FunctionPlot::mousePressEvent(QMouseEvent* event) {
  event->accept();
  if (event->button() != Qt::LeftButton) return;
  const QPointF at = event->position();
  if (const auto knot = knot_at(at)) {
    dragged_ = knot;
    moved_ = false;
    setCursor(Qt::ClosedHandCursor);
    emit knot_clicked(*knot);
    return;
  }
  if (!axisRect()->rect().contains(at.toPoint())) return;
  band_from_ = at.toPoint();
  band_->setGeometry(QRect(*band_from_, QSize()));
}

void FunctionPlot::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = inside(event->position());
  if (dragged_) {
    if (!moved_) emit drag_began(*dragged_);
    moved_ = true;
    emit dragged(*dragged_, value_at(at));
    if (*dragged_ < function_.knots.size()) show_coordinates(knot_pixel(*dragged_), shown_knot(*dragged_));
    replot(rpQueuedReplot);
  } else if (band_from_) {
    band_->setGeometry(QRect(*band_from_, at.toPoint()).normalized());
    band_->show();
  } else if (const auto knot = knot_at(event->position())) {
    setCursor(Qt::OpenHandCursor);
    show_coordinates(knot_pixel(*knot), shown_knot(*knot));
    replot(rpQueuedReplot);
  } else {
    unsetCursor();
    hide_coordinates();
  }
}

void FunctionPlot::mouseReleaseEvent(QMouseEvent* event) {
  event->accept();
  const QPointF at = inside(event->position());
  if (event->button() == Qt::RightButton) {
    const core::Knot centre = value_at(at);
    const double half_x = window_.x[1] - window_.x[0];
    const double half_y = window_.y[1] - window_.y[0];
    set_window({{centre.x - half_x, centre.x + half_x}, {centre.y - half_y, centre.y + half_y}});
    return;
  }
  if (event->button() != Qt::LeftButton) return;
  if (const auto knot = std::exchange(dragged_, std::nullopt)) {
    unsetCursor();
    hide_coordinates();
    const core::Knot to = value_at(at);
    if (moved_)
      emit drag_ended(*knot, {scene::rounded_to_range(to.x, window_.x[1] - window_.x[0]),
                              scene::rounded_to_range(to.y, window_.y[1] - window_.y[0])});
  } else if (const auto from = std::exchange(band_from_, std::nullopt)) {
    band_->hide();
    const QRect drawn = QRect(*from, at.toPoint()).normalized();
    if (drawn.width() < smallest_rectangle_px || drawn.height() < smallest_rectangle_px) return;
    const core::Knot first = value_at(*from);
    const core::Knot second = value_at(at);
    set_window({{first.x, second.x}, {first.y, second.y}});
  }
}

void FunctionPlot::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void FunctionPlot::wheelEvent(QWheelEvent* event) {
  event->accept();
  const QPoint turned = event->angleDelta();
  const int steps = turned.y() != 0 ? turned.y() : turned.x();  // Some systems turn Shift into a sideways wheel.
  if (steps == 0) return;
  const double factor = std::pow(wheel_step, -steps / 120.0);
  const core::Knot at = value_at(inside(event->position()));
  const bool x_alone = event->modifiers().testFlag(Qt::ControlModifier);
  const bool y_alone = event->modifiers().testFlag(Qt::ShiftModifier);
  zoom_about(at.x, at.y, y_alone ? 1.0 : factor, x_alone ? 1.0 : factor);
}

void FunctionPlot::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Plus: return zoom(1.0 / zoom_step, 1.0 / zoom_step);
    case Qt::Key_Minus: return zoom(zoom_step, zoom_step);
    case Qt::Key_Home: return fit();
    case Qt::Key_Escape:
      if (!dragged_ && !band_from_) break;
      band_->hide();
      band_from_.reset();
      hide_coordinates();
      unsetCursor();
      if (dragged_.has_value() && moved_) emit drag_cancelled();
      dragged_.reset();
      return;
    default: break;
  }
  QCustomPlot::keyPressEvent(event);
}

void FunctionPlot::leaveEvent(QEvent* event) {
  QCustomPlot::leaveEvent(event);
  if (!dragged_) hide_coordinates();
}

void FunctionPlot::resizeEvent(QResizeEvent* event) {
  QCustomPlot::resizeEvent(event);
  redraw();
}

void FunctionPlot::changeEvent(QEvent* event) {
  QCustomPlot::changeEvent(event);
  if (event->type() != QEvent::PaletteChange && event->type() != QEvent::FontChange) return;
  redraw();
}

}  // namespace sarsim::gui

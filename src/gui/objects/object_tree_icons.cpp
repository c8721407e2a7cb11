#include "gui/objects/object_tree_icons.hpp"

#include <QPainter>
#include <QPainterPath>

#include <optional>

#include "gui/common/painted_icon.hpp"
#include "gui/common/palette_colours.hpp"

namespace sarsim::gui {

namespace {

// Draws in a square of 16 units whatever size is asked for.
class ObjectIconEngine : public PaintedIcon {
 public:
  ObjectIconEngine(scene::ObjectKind kind, const QPalette& palette, std::optional<core::Severity> mark)
      : kind_(kind), palette_(palette), mark_(mark) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / 16.0, rect.height() / 16.0);
    if (mode == QIcon::Disabled) painter->setOpacity(0.4);
    const QPalette usual = palette_;
    // The ground of what is selected is dark in either theme.
    if (mode == QIcon::Selected) palette_ = on_highlight(usual);
    draw_kind(*painter);
    if (mark_ && *mark_ != core::Severity::note) draw_mark(*painter);
    palette_ = usual;
    painter->restore();
  }

  [[nodiscard]] QIconEngine* clone() const override { return new ObjectIconEngine(*this); }

 private:
  static QPalette on_highlight(const QPalette& palette) {
    QPalette turned = palette;
    const QColor ground = palette.color(QPalette::Highlight);
    const QColor text = palette.color(QPalette::HighlightedText);
    for (const QPalette::ColorRole role : {QPalette::Window, QPalette::Base}) turned.setColor(role, ground);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text}) turned.setColor(role, text);
    return turned;
  }

  void draw_kind(QPainter& painter) const {
    const QColor text = palette_.color(QPalette::Text);
    switch (kind_) {
      case scene::ObjectKind::platform: return draw_axes(painter);
      case scene::ObjectKind::target:
        painter.setPen(QPen(text, 1.0));
        painter.setBrush(colour_of(picture::Role::target, palette_));
        return painter.drawEllipse(QPointF(8, 8), 4.5, 4.5);
      case scene::ObjectKind::cloud:
        painter.setPen(QPen(text, 0.8));
        painter.setBrush(colour_of(picture::Role::target, palette_));
        for (const QPointF at : {QPointF(4, 5), QPointF(11, 4), QPointF(8, 9), QPointF(4, 13), QPointF(13, 12)})
          painter.drawEllipse(at, 2.0, 2.0);
        return;
      case scene::ObjectKind::surface:
        painter.setPen(QPen(text, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(colour_of(picture::Role::surface, palette_));
        return static_cast<void>(painter.drawPolygon(QPolygonF({{2, 13}, {14, 13}, {9, 3}})));
      case scene::ObjectKind::radar: return draw_beam(painter);
      case scene::ObjectKind::simulation: return draw_echo(painter, text);
      case scene::ObjectKind::geometry: return draw_table(painter, text);
    }
  }

  void draw_axes(QPainter& painter) const {
    const auto axis = [&](picture::Role role, QPointF end) {
      painter.setPen(QPen(colour_of(role, palette_), 2.0, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(QPointF(6, 10), end);
    };
    axis(picture::Role::x_axis, {14, 13});
    axis(picture::Role::y_axis, {13, 5});
    axis(picture::Role::z_axis, {6, 1.5});
  }

  void draw_beam(QPainter& painter) const {
    QPainterPath beam(QPointF(3, 13));
    beam.lineTo(9, 2.5);
    beam.quadTo(14, 4, 14, 8.5);
    beam.closeSubpath();
    QColor fill = colour_of(picture::Role::beam, palette_);
    painter.setPen(QPen(fill, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    fill.setAlphaF(0.4F);
    painter.setBrush(fill);
    painter.drawPath(beam);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour_of(picture::Role::radar, palette_));
    painter.drawEllipse(QPointF(3.5, 12.5), 2.5, 2.5);
  }

  static void draw_echo(QPainter& painter, const QColor& text) {
    painter.setPen(QPen(text, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(QPolygonF({{1.5, 11}, {5, 11}, {6.5, 3}, {8.5, 14}, {10, 9}, {11, 11}, {14.5, 11}}));
  }

  static void draw_table(QPainter& painter, const QColor& text) {
    painter.setPen(QPen(text, 1.1));
    painter.drawRect(QRectF(2, 3, 12, 10));
    for (const double y : {6.3, 9.6}) painter.drawLine(QPointF(2, y), QPointF(14, y));
    for (const double x : {6.0, 10.0}) painter.drawLine(QPointF(x, 3), QPointF(x, 13));
  }

  void draw_mark(QPainter& painter) const {
    const bool error = *mark_ == core::Severity::error;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour_of(error ? picture::Role::error : picture::Role::warning, palette_));
    painter.drawEllipse(QPointF(12, 12), 4, 4);
    painter.setPen(QPen(palette_.color(QPalette::Base), 1.4, Qt::SolidLine, Qt::RoundCap));
    if (error) {
      painter.drawLine(QPointF(10.4, 10.4), QPointF(13.6, 13.6));
      painter.drawLine(QPointF(13.6, 10.4), QPointF(10.4, 13.6));
    } else {
      painter.drawLine(QPointF(12, 9.8), QPointF(12, 12.2));
      painter.drawPoint(QPointF(12, 14.2));
    }
  }

  scene::ObjectKind kind_;
  QPalette palette_;
  std::optional<core::Severity> mark_;
};

}  // namespace

QIcon object_icon(scene::ObjectKind kind, const QPalette& palette) {
  return QIcon(new ObjectIconEngine(kind, palette, std::nullopt));
}

QIcon object_icon(scene::ObjectKind kind, const QPalette& palette, core::Severity mark) {
  return QIcon(new ObjectIconEngine(kind, palette, mark));
}

}  // namespace sarsim::gui

#include "gui/scene/scene_painter.hpp"

#include <QFontMetricsF>
#include <QImage>
#include <QLinearGradient>
#include <QList>
#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace sarsim::gui {

namespace {

// Beyond so many lines smooth edges and dots cost more than they show.
constexpr std::size_t max_fine_lines = 4000;
constexpr std::size_t max_halos = 200;
constexpr std::size_t max_kept_rims = 2000;

QColor paint_of(picture::Role role, bool dark) {
  const raster::Rgb rgb = picture::colour(role, dark);
  return {rgb.red, rgb.green, rgb.blue};
}

// Lighter towards the horizon.
void paint_sky(QPainter& painter, const QRectF& area, double horizon_px, bool dark) {
  QLinearGradient sky(0.0, 0.0, 0.0, std::max(1.0, horizon_px));
  sky.setColorAt(0.0, paint_of(picture::Role::sky, dark));
  sky.setColorAt(1.0, paint_of(picture::Role::background, dark));
  painter.fillRect(QRectF(area.left(), area.top(), area.width(), horizon_px), sky);
  painter.fillRect(QRectF(area.left(), horizon_px, area.width(), 1.0), paint_of(picture::Role::faint, dark));
}

// The bytes are the rendering's own: nothing is copied.
void paint_solids(QPainter& painter, const picture::Rendering& solids) {
  if (solids.empty()) return;
  const QImage image(reinterpret_cast<const uchar*>(solids.argb.data()), solids.width, solids.height,
                     QImage::Format_ARGB32_Premultiplied);
  painter.drawImage(QPointF(solids.left, solids.top), image);
}

// One call of the painter for all lines of a pen; pens in the order of their roles, so that faint lines lie below.
void paint_lines(QPainter& painter, const std::vector<picture::Drawing::Line>& lines, bool dark) {
  const bool fine = lines.size() <= max_fine_lines;
  std::map<std::tuple<picture::Role, std::uint8_t, float, bool>, QList<QLineF>> of_pen;
  for (const picture::Drawing::Line& line : lines)
    of_pen[{line.role, line.tone, line.width_px, line.dotted && fine}].append(
        QLineF(line.x0, line.y0, line.x1, line.y1));
  for (const auto& [key, group] : of_pen) {
    const auto& [role, tone, width_px, dotted] = key;
    const raster::Rgb rgb = picture::colour_of({0, 0, 0, 0, role, 1.0F, false, tone}, dark);
    QPen pen(QColor(rgb.red, rgb.green, rgb.blue), width_px);
    if (dotted) pen.setDashPattern({1.0, 3.0});
    pen.setCapStyle(Qt::FlatCap);
    painter.setPen(pen);
    painter.setRenderHint(QPainter::Antialiasing, fine && !dotted);  // Smoothed dots fade away.
    painter.drawLines(group);
  }
}

}  // namespace

void ScenePainter::paint(QPainter& painter, const QRectF& area, const picture::Drawing& drawing, const Look& look) {
  painter.fillRect(area, paint_of(picture::Role::background, look.dark));
  painter.setRenderHint(QPainter::Antialiasing, true);
  if (drawing.horizon_px) paint_sky(painter, area, *drawing.horizon_px, look.dark);
  paint_solids(painter, drawing.solids);
  paint_lines(painter, drawing.lines, look.dark);
  painter.setRenderHint(QPainter::Antialiasing, true);
  paint_discs(painter, drawing.discs, look.dark);
  paint_texts(painter, drawing.texts, look);
}

void ScenePainter::paint_texts(QPainter& painter, const std::vector<picture::Drawing::Text>& texts, const Look& look) {
  QFont plain = look.font;
  plain.setPixelSize(static_cast<int>(std::lround(QFontInfo(look.font).pixelSize() * look.pixel_scale)));
  QFont bold = plain;
  bold.setBold(true);
  const QFontMetricsF plain_metrics(plain);
  const QFontMetricsF bold_metrics(bold);
  const auto start_of = [&](const picture::Drawing::Text& text, const QString& words) {
    const double width = (text.bold ? bold_metrics : plain_metrics).horizontalAdvance(words);
    return QPointF(static_cast<double>(text.x) - (text.centred ? 0.5 * width : 0.0), text.y);
  };
  QColor ground = paint_of(picture::Role::background, look.dark);
  ground.setAlphaF(0.85F);
  // All rims first: none covers another word.
  if (texts.size() <= max_halos)
    for (const picture::Drawing::Text& text : texts) {
      const QString words = QString::fromStdString(text.text);
      const QPointF start = start_of(text, words);
      painter.translate(start);
      painter.fillPath(rim_of(words, text.bold ? bold : plain, 3.0 * look.pixel_scale), ground);
      painter.translate(-start);
    }
  for (const picture::Drawing::Text& text : texts) {
    const QString words = QString::fromStdString(text.text);
    painter.setFont(text.bold ? bold : plain);
    painter.setPen(paint_of(text.role, look.dark));
    painter.drawText(start_of(text, words), words);
  }
}

// A rim in the colour of the ground keeps words readable across lines. To find it takes ten times as long as to fill
// it.
const QPainterPath& ScenePainter::rim_of(const QString& words, const QFont& font, double width_px) {
  if (rims_.size() > max_kept_rims) rims_.clear();
  QPainterPath& rim = rims_[{words, font.key(), width_px}];
  if (!rim.isEmpty()) return rim;
  QPainterPath outline;
  outline.addText(QPointF(), font, words);
  QPainterPathStroker stroker(QPen(Qt::black, width_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  rim = stroker.createStroke(outline);
  rim.setFillRule(Qt::WindingFill);
  return rim;
}

// Qt's call for many pictures at once sets a transform for each of them, which takes longer than to draw it.
void ScenePainter::paint_discs(QPainter& painter, const std::vector<picture::Drawing::Disc>& discs, bool dark) {
  const auto alike = [](const picture::Drawing::Disc& a, const picture::Drawing::Disc& b) {
    return a.role == b.role && a.diameter_px == b.diameter_px && a.outlined == b.outlined;
  };
  const QPixmap* picture = nullptr;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (i == 0 || !alike(discs[i], discs[i - 1])) picture = &disc_picture(discs[i], dark);
    const double half = 0.5 * picture->width();
    painter.drawPixmap(QPointF(discs[i].x, discs[i].y) - QPointF(half, half), *picture);
  }
}

const QPixmap& ScenePainter::disc_picture(const picture::Drawing::Disc& disc, bool dark) {
  QPixmap& picture = disc_pictures_[{disc.role, disc.diameter_px, disc.outlined, dark}];
  if (!picture.isNull()) return picture;
  const auto diameter = static_cast<double>(disc.diameter_px);
  const int side = 2 * static_cast<int>(std::ceil(0.5 * diameter)) + 3;
  picture = QPixmap(side, side);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const double rim = disc.outlined ? std::max(1.0, diameter / 8.0) : 0.0;
  painter.setPen(disc.outlined ? QPen(paint_of(dark ? picture::Role::background : picture::Role::text, dark), rim)
                               : QPen(Qt::NoPen));
  painter.setBrush(paint_of(disc.role, dark));
  const double radius = 0.5 * (diameter - rim);
  painter.drawEllipse(QPointF(0.5 * side, 0.5 * side), radius, radius);
  return picture;
}

}  // namespace sarsim::gui

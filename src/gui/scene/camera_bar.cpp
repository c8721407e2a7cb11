#include "gui/scene/camera_bar.hpp"

#include <QEvent>
#include <QHBoxLayout>
#include <QIcon>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <QToolButton>

#include <array>
#include <utility>

#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"

namespace sarsim::gui {

namespace {

constexpr int sign_px = 16;
constexpr int sign_scale = 4;  // Signs are drawn so much larger.

using Points = QList<QPointF>;

void draw_cube(QPainter& painter, int filled) {
  const QPointF middle(8, 8), top(8, 1.5), bottom(8, 14.5), left(2.4, 4.7), right(13.6, 4.7), low_left(2.4, 11.3),
      low_right(13.6, 11.3);
  const std::array<Points, 3> faces{Points{top, right, middle, left}, Points{left, middle, bottom, low_left},
                                    Points{right, middle, bottom, low_right}};
  for (int i = 0; i < 3; ++i) {
    painter.setBrush(i == filled ? QBrush(painter.pen().color()) : QBrush(Qt::NoBrush));
    painter.drawPolygon(QPolygonF(faces[static_cast<std::size_t>(i)]));
  }
}

void draw_corners(QPainter& painter) {
  for (const double x : {2.0, 14.0})
    for (const double y : {2.0, 14.0}) {
      const double dx = x < 8.0 ? 3.5 : -3.5;
      const double dy = y < 8.0 ? 3.5 : -3.5;
      painter.drawPolyline(QPolygonF(Points{{x + dx, y}, {x, y}, {x, y + dy}}));
    }
}

void draw_disc(QPainter& painter, const QPointF& at, double radius) {
  painter.setBrush(painter.pen().color());
  painter.drawEllipse(at, radius, radius);
  painter.setBrush(Qt::NoBrush);
}

}  // namespace

CameraBar::CameraBar(ScenePanel& panel) : panel_(panel) {
  setObjectName(QStringLiteral("camera_bar"));
  setAccessibleName(tr("Views of the scene"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  SceneWidget& scene = panel.scene();
  add(Sign::all, "camera_all", tr("Show all"), tr("Show everything (Home)"), [&scene] { scene.fit(); });
  add(Sign::selection, "camera_selection", tr("Zoom to selection"), tr("Fill the scene with what is selected (F)"),
      [this] { panel_.zoom_to_selection(); });
  const auto look = [&scene](picture::ViewPreset view) { return [&scene, view] { scene.look(view); }; };
  add(Sign::above, "camera_above", tr("From above"), tr("Look from above (1)"), look(picture::ViewPreset::top));
  add(Sign::front, "camera_front", tr("From the front"), tr("Look from the front (2)"),
      look(picture::ViewPreset::front));
  add(Sign::side, "camera_side", tr("From the side"), tr("Look from the side (3)"), look(picture::ViewPreset::side));
  QToolButton* beam =
      add(Sign::beam, "camera_beam", tr("Along the beam"),
          tr("Look along the beam of the selected radar, or of the first (4)"), [this] { panel_.look_along_beam(); });
  QToolButton* follow = add(Sign::follow, "camera_follow", tr("Follow"),
                            tr("Go with what is selected as time runs (5)"), [this] { panel_.follow_selection(); });
  QToolButton* list = add(Sign::list, "camera_list", tr("All views"), tr("Every view by its name"), {});
  auto* menu = new QMenu(list);
  connect(menu, &QMenu::aboutToShow, &panel, [this, menu] { panel_.fill_cameras(*menu); });
  list->setMenu(menu);
  list->setPopupMode(QToolButton::InstantPopup);
  beam->setCheckable(true);
  follow->setCheckable(true);
  connect(&panel, &ScenePanel::ride_changed, this, [this, beam, follow] {
    beam->setChecked(panel_.ride() == ScenePanel::Ride::beam);
    follow->setChecked(panel_.ride() == ScenePanel::Ride::follow);
  });
  add_tools();
  show_signs();
}

void CameraBar::add_tools() {
  QToolButton* measure = add(Sign::measure, "camera_measure", tr("Measure distance"),
                             tr("Click two points: distance, height and angles (M)"), {});
  QToolButton* path = add(Sign::path, "camera_path", tr("Draw path"),
                          tr("Clicks go on with the path of the selected platform (P)"), {});
  measure->setCheckable(true);
  path->setCheckable(true);
  connect(measure, &QToolButton::clicked, &panel_, &ScenePanel::measure);
  connect(path, &QToolButton::clicked, &panel_, &ScenePanel::draw_path);
  connect(&panel_.scene(), &SceneWidget::tool_changed, this, [this, measure, path] {
    measure->setChecked(panel_.scene().tool() == SceneWidget::Tool::ruler);
    path->setChecked(panel_.scene().tool() == SceneWidget::Tool::path);
  });
}

QToolButton* CameraBar::add(Sign sign, const char* name, const QString& text, const QString& tip,
                            std::function<void()> work) {
  auto* button = new QToolButton(this);
  button->setObjectName(QLatin1String(name));
  button->setAccessibleName(text);
  button->setToolTip(tip);
  button->setAutoRaise(true);
  button->setIconSize({sign_px, sign_px});
  button->setFocusPolicy(Qt::TabFocus);  // A click leaves the keyboard to the scene.
  button->setProperty("sign", static_cast<int>(sign));
  if (work) connect(button, &QToolButton::clicked, this, std::move(work));
  layout()->addWidget(button);
  return button;
}

QIcon CameraBar::icon_of(Sign sign, const QColor& colour) {
  QPixmap picture(sign_scale * sign_px, sign_scale * sign_px);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(sign_scale, sign_scale);
  painter.setPen(QPen(colour, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  switch (sign) {
    case Sign::all: draw_corners(painter); break;
    case Sign::selection:
      draw_corners(painter);
      draw_disc(painter, {8, 8}, 2.2);
      break;
    case Sign::above: draw_cube(painter, 0); break;
    case Sign::front: draw_cube(painter, 1); break;
    case Sign::side: draw_cube(painter, 2); break;
    case Sign::beam:
      draw_disc(painter, {3, 3}, 1.2);
      painter.drawLine(QPointF(3, 3), QPointF(14, 7.5));
      painter.drawLine(QPointF(3, 3), QPointF(7.5, 14));
      painter.drawEllipse(QRectF(7, 7, 7.5, 7.5));
      break;
    case Sign::follow:
      painter.drawEllipse(QPointF(8, 8), 5.0, 5.0);
      draw_disc(painter, {8, 8}, 1.3);
      for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        painter.drawLine(QPointF(8, 8) + 5.0 * way, QPointF(8, 8) + 7.3 * way);
      break;
    case Sign::measure:
      painter.drawLine(QPointF(2.5, 13.5), QPointF(13.5, 2.5));
      for (const double at : {2.5, 6.2, 9.8, 13.5})
        painter.drawLine(QPointF(at - 1.6, 16 - at - 1.6), QPointF(at + 1.6, 16 - at + 1.6));
      break;
    case Sign::path:
      painter.drawPolyline(QPolygonF(Points{{2.5, 13}, {6, 5}, {10, 10}, {13.5, 3}}));
      for (const QPointF& at : {QPointF(2.5, 13), QPointF(6, 5), QPointF(10, 10), QPointF(13.5, 3)})
        draw_disc(painter, at, 1.4);
      break;
    case Sign::list:
      for (const double y : {4.0, 8.0, 12.0}) {
        draw_disc(painter, {3, y}, 0.6);
        painter.drawLine(QPointF(6, y), QPointF(14, y));
      }
      break;
  }
  return picture;
}

void CameraBar::show_signs() {
  for (QToolButton* button : findChildren<QToolButton*>())
    button->setIcon(
        icon_of(static_cast<Sign>(button->property("sign").toInt()), palette().color(QPalette::WindowText)));
}

void CameraBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_signs();
}

}  // namespace sarsim::gui

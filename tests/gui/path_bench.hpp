#pragma once

#include <QMouseEvent>
#include <QTest>

#include <string>
#include <vector>

#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/small_scene.hpp"
#include "scene/edit/path_points.hpp"

namespace sarsim::test {

/// A scene panel from above at 0.1 px/m, the first platform selected, so that its path can be taken hold of.
struct PathBench {
  explicit PathBench(const char* text) {
    session.take(scene::Document::from_text(text));
    panel.resize(900, 700);
    panel.show();
    session.select_only(test::platform(0));
    look_from_above(0.1);
  }
  void look_from_above(double pixels_per_m) {
    picture::Camera camera = picture::preset(view().camera(), picture::ViewPreset::top);
    camera.focus_world_m = points().front();
    camera.pixels_per_m = pixels_per_m * view().pixel_scale();
    view().set_camera(camera);
  }
  [[nodiscard]] gui::SceneWidget& view() { return panel.scene(); }
  [[nodiscard]] const scene::Platform& platform(std::size_t index = 0) { return session.scene().platforms.at(index); }
  [[nodiscard]] std::vector<core::Vec3> points() { return scene::path_points(platform(), session.scene().world); }
  [[nodiscard]] std::string undo_label() { return session.document().history().undo_label(); }
  [[nodiscard]] std::string text() { return session.document().text(); }
  [[nodiscard]] double pixel_m() { return view().pixel_scale() / view().camera().pixels_per_m; }
  [[nodiscard]] QPoint pixel_of(const core::Vec3& world_m) {
    const auto at = view().camera().project(world_m);
    return (QPointF(at->x, at->y) / view().pixel_scale()).toPoint();
  }
  void mouse(QEvent::Type type, QPoint at, Qt::MouseButton button = Qt::LeftButton) {
    const bool move = type == QEvent::MouseMove;
    QMouseEvent event(type, at, view().mapToGlobal(at), move ? Qt::NoButton : button,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : button, Qt::NoModifier);
    QCoreApplication::sendEvent(&view(), &event);
  }
  void hover(QPoint at) { mouse(QEvent::MouseMove, at, Qt::NoButton); }
  void click(QPoint at, Qt::MouseButton button = Qt::LeftButton) {
    hover(at);
    mouse(QEvent::MouseButtonPress, at, button);
    mouse(QEvent::MouseButtonRelease, at, button);
  }
  void drag(QPoint from, QPoint to) {
    mouse(QEvent::MouseButtonPress, from, Qt::LeftButton);
    mouse(QEvent::MouseMove, from + (to - from) / 2, Qt::LeftButton);
    mouse(QEvent::MouseMove, to, Qt::LeftButton);
    mouse(QEvent::MouseButtonRelease, to, Qt::LeftButton);
  }
  void double_click(QPoint at) {
    click(at);
    mouse(QEvent::MouseButtonDblClick, at, Qt::LeftButton);
    mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton);
  }
  void key(Qt::Key key) { QTest::keyClick(&view(), key); }

  gui::Session session;
  gui::ScenePanel panel{session};
};

}  // namespace sarsim::test

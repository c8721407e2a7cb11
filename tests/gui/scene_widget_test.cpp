#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <cmath>
#include <random>

#include "core/maths/constants.hpp"
#include "gui/gui_test.hpp"
#include "gui/paint_count.hpp"
#include "gui/scene/scene_widget.hpp"
#include "support/processor_time.hpp"

namespace sarsim::scene_widget_test {
namespace {

const scene::ObjectId first_target{scene::ObjectKind::target, 0};
const scene::ObjectId second_target{scene::ObjectKind::target, 1};
const scene::ObjectId plane{scene::ObjectKind::platform, 0};

picture::Snapshot::Target target_at(std::size_t index, const core::Vec3& at_m) {
  return {{scene::ObjectKind::target, index}, at_m, {at_m.x, at_m.y, 0.0}, {}, false};
}

// Two targets and a platform, seen along +y at one device pixel per metre.
class Bench {
 public:
  Bench() {
    widget.resize(400, 300);
    widget.show();
    picture::Snapshot snapshot;
    snapshot.targets = {target_at(0, {0, 0, 0}), target_at(1, {100, 0, 50})};
    picture::Snapshot::Platform platform;
    platform.id = plane;
    platform.name = "Plane";
    platform.pose.position_world_m = {-100, 0, 0};
    snapshot.platforms = {platform};
    widget.set_snapshot(snapshot);
    picture::Camera camera = picture::preset(picture::Camera{}, picture::ViewPreset::front);
    camera.pixels_per_m = 1.0;
    widget.set_camera(camera);
  }

  [[nodiscard]] QPoint place_of(const core::Vec3& world_m) const {
    const auto point = widget.camera().project(world_m);
    return (QPointF(point->x, point->y) / widget.pixel_scale()).toPoint();
  }
  void mouse(QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
    const bool down = type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick;
    const bool move = type == QEvent::MouseMove;
    QMouseEvent event(type, at, widget.mapToGlobal(at), move ? Qt::NoButton : button,
                      down || move ? Qt::MouseButtons(button) : Qt::NoButton, modifiers);
    QCoreApplication::sendEvent(&widget, &event);
  }
  void drag(QPoint from, QPoint to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
    mouse(QEvent::MouseButtonPress, from, button, modifiers);
    mouse(QEvent::MouseMove, from + (to - from) / 2, button, modifiers);
    mouse(QEvent::MouseMove, to, button, modifiers);
    mouse(QEvent::MouseButtonRelease, to, button, modifiers);
  }
  void click(QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
    mouse(QEvent::MouseButtonPress, at, button, modifiers);
    mouse(QEvent::MouseButtonRelease, at, button, modifiers);
  }

  gui::SceneWidget widget;
};

bool near(double a, double b, double tolerance = 1e-9) { return std::abs(a - b) <= tolerance; }

constexpr double deg = core::pi / 180.0;
const QPoint empty_place{30, 30};

}  // namespace

class SceneWidgetTest : public QObject {
  Q_OBJECT

 private slots:
  void has_its_names() {
    Bench bench;
    QCOMPARE(bench.widget.objectName(), QString("scene_view"));
    QVERIFY(!bench.widget.accessibleName().isEmpty());
  }

  void camera_has_the_size_of_the_widget_in_device_pixels() {
    Bench bench;
    bench.widget.resize(500, 200);
    QCOMPARE(bench.widget.camera().width_px, 500 * bench.widget.devicePixelRatioF());
    QCOMPARE(bench.widget.camera().height_px, 200 * bench.widget.devicePixelRatioF());
    bench.widget.set_camera(picture::Camera::start(7, 7));
    QCOMPARE(bench.widget.camera().width_px, 500 * bench.widget.devicePixelRatioF());
  }

  void left_drag_on_empty_space_turns_by_the_thesis_rates() {
    Bench bench;
    QSignalSpy changed(&bench.widget, &gui::SceneWidget::camera_changed);
    bench.drag(empty_place, empty_place + QPoint(40, 20), Qt::LeftButton);
    QVERIFY(near(std::remainder(bench.widget.camera().azimuth_rad - 190 * deg, 2 * core::pi), 0.0));
    QVERIFY(near(bench.widget.camera().elevation_rad, 10 * deg));
    QVERIFY(changed.size() >= 1);
  }

  void middle_drag_and_shift_left_drag_pan() {
    Bench bench;
    const QPoint before = bench.place_of({});
    bench.drag(empty_place, empty_place + QPoint(50, -10), Qt::MiddleButton);
    QCOMPARE(bench.place_of({}), before + QPoint(50, -10));
    bench.drag(empty_place, empty_place + QPoint(-20, 30), Qt::LeftButton, Qt::ShiftModifier);
    QCOMPARE(bench.place_of({}), before + QPoint(30, 20));
  }

  void right_drag_zooms_ten_times_per_200_pixels_upwards() {
    Bench bench;
    QSignalSpy menu(&bench.widget, &gui::SceneWidget::menu_requested);
    bench.drag({200, 250}, {200, 50}, Qt::RightButton);
    QVERIFY(near(bench.widget.camera().pixels_per_m, 10.0));
    QCOMPARE(menu.size(), 0);
  }

  void wheel_zooms_at_the_cursor() {
    Bench bench;
    const QPoint at(300, 100);
    const core::Vec3 held =
        bench.widget.camera().unproject(300 * bench.widget.pixel_scale(), 100 * bench.widget.pixel_scale());
    QWheelEvent wheel(at, bench.widget.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&bench.widget, &wheel);
    QVERIFY(near(bench.widget.camera().pixels_per_m, std::pow(10.0, 0.2)));
    QCOMPARE(bench.place_of(held), at);
  }

  void click_selects_and_control_adds() {
    Bench bench;
    QSignalSpy selected(&bench.widget, &gui::SceneWidget::selection_clicked);
    QSignalSpy empty(&bench.widget, &gui::SceneWidget::empty_clicked);
    bench.click(bench.place_of({100, 0, 50}), Qt::LeftButton);
    bench.click(bench.place_of({}), Qt::LeftButton, Qt::ControlModifier);
    bench.click(empty_place, Qt::LeftButton);
    QCOMPARE(selected.size(), 2);
    QVERIFY(selected[0][0].value<scene::ObjectId>() == second_target);
    QCOMPARE(selected[0][1].toBool(), false);
    QVERIFY(selected[1][0].value<scene::ObjectId>() == first_target);
    QCOMPARE(selected[1][1].toBool(), true);
    QCOMPARE(empty.size(), 1);
  }

  void double_click_edits_once() {
    Bench bench;
    QSignalSpy edit(&bench.widget, &gui::SceneWidget::edit_requested);
    QSignalSpy selected(&bench.widget, &gui::SceneWidget::selection_clicked);
    const QPoint at = bench.place_of({});
    bench.click(at, Qt::LeftButton);
    bench.mouse(QEvent::MouseButtonDblClick, at, Qt::LeftButton);
    bench.mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton);
    QCOMPARE(edit.size(), 1);
    QVERIFY(edit[0][0].value<scene::ObjectId>() == first_target);
    QCOMPARE(selected.size(), 1);
  }

  void right_click_asks_for_a_menu() {
    Bench bench;
    QSignalSpy menu(&bench.widget, &gui::SceneWidget::menu_requested);
    const QPoint at = bench.place_of({});
    bench.click(at, Qt::RightButton);
    bench.click(empty_place, Qt::RightButton);
    QCOMPARE(menu.size(), 2);
    QVERIFY(menu[0][0].value<std::optional<scene::ObjectId>>() == first_target);
    QCOMPARE(menu[0][1].toPoint(), bench.widget.mapToGlobal(at));
    QVERIFY(!menu[1][0].value<std::optional<scene::ObjectId>>());
  }

  void left_drag_on_a_target_moves_it_upright_where_the_ground_is_seen_from_its_edge() {
    Bench bench;
    QSignalSpy started(&bench.widget, &gui::SceneWidget::drag_started);
    QSignalSpy moved(&bench.widget, &gui::SceneWidget::dragged_to);
    QSignalSpy ended(&bench.widget, &gui::SceneWidget::drag_ended);
    QSignalSpy selected(&bench.widget, &gui::SceneWidget::selection_clicked);
    const double before = bench.widget.camera().azimuth_rad;
    const QPoint at = bench.place_of({});
    bench.drag(at, at + QPoint(60, -20), Qt::LeftButton);
    QCOMPARE(started.size(), 1);
    QVERIFY(started[0][0].value<scene::ObjectId>() == first_target);
    const core::Vec3 delta = moved.last()[1].value<core::Vec3>();
    const double scale = bench.widget.pixel_scale();
    QVERIFY(near(delta.x, 60.0 * scale));
    QCOMPARE(delta.y, 0.0);
    QVERIFY(near(delta.z, 20.0 * scale));
    QCOMPARE(ended.size(), 1);
    QCOMPARE(selected.size(), 0);
    QCOMPARE(bench.widget.camera().azimuth_rad, before);
  }

  void shift_snaps_a_dragged_platform_to_round_coordinates() {
    Bench bench;
    QSignalSpy moved(&bench.widget, &gui::SceneWidget::dragged_to);
    const QPoint at = bench.place_of({-100, 0, 0});
    bench.drag(at, at + QPoint(33, -48), Qt::LeftButton, Qt::ShiftModifier);
    const core::Vec3 place = core::Vec3{-100, 0, 0} + moved.last()[1].value<core::Vec3>();
    QVERIFY(moved.last()[0].value<scene::ObjectId>() == plane);
    QVERIFY(near(place.x, -70.0));
    QVERIFY(near(place.z, 50.0));
    QCOMPARE(place.y, 0.0);
  }

  void the_world_is_not_moved_by_accident() {
    Bench bench;
    picture::Snapshot snapshot = bench.widget.snapshot();
    snapshot.platforms[0].name = "Earth";
    bench.widget.set_snapshot(snapshot);
    QSignalSpy started(&bench.widget, &gui::SceneWidget::drag_started);
    const QPoint at = bench.place_of({-100, 0, 0});
    bench.drag(at, at + QPoint(8, 0), Qt::LeftButton);
    QCOMPARE(started.size(), 0);
    bench.drag(at, at + QPoint(-8, 0), Qt::LeftButton);  // turns back
    picture::DrawingOptions options;
    options.selected = {plane};
    bench.widget.set_options(options);
    bench.drag(at, at + QPoint(20, 0), Qt::LeftButton);
    QCOMPARE(started.size(), 1);
  }

  void escape_takes_a_drag_back() {
    Bench bench;
    QSignalSpy moved(&bench.widget, &gui::SceneWidget::dragged_to);
    QSignalSpy ended(&bench.widget, &gui::SceneWidget::drag_ended);
    const QPoint at = bench.place_of({});
    bench.mouse(QEvent::MouseButtonPress, at, Qt::LeftButton);
    bench.mouse(QEvent::MouseMove, at + QPoint(50, 0), Qt::LeftButton);
    QTest::keyClick(&bench.widget, Qt::Key_Escape);
    bench.mouse(QEvent::MouseButtonRelease, at + QPoint(50, 0), Qt::LeftButton);
    QVERIFY(moved.last()[1].value<core::Vec3>() == core::Vec3{});
    QCOMPARE(ended.size(), 1);
    const double azimuth = bench.widget.camera().azimuth_rad;
    bench.mouse(QEvent::MouseButtonPress, empty_place, Qt::LeftButton);
    bench.mouse(QEvent::MouseMove, empty_place + QPoint(50, 0), Qt::LeftButton);
    QVERIFY(bench.widget.camera().azimuth_rad != azimuth);
    QTest::keyClick(&bench.widget, Qt::Key_Escape);
    QCOMPARE(bench.widget.camera().azimuth_rad, azimuth);
  }

  void hovering_tells_the_object_once() {
    Bench bench;
    QSignalSpy hovered(&bench.widget, &gui::SceneWidget::hovered);
    const QPoint at = bench.place_of({});
    bench.mouse(QEvent::MouseMove, at, Qt::NoButton);
    bench.mouse(QEvent::MouseMove, at + QPoint(1, 0), Qt::NoButton);
    QCOMPARE(hovered.size(), 1);
    QVERIFY(hovered[0][0].value<std::optional<scene::ObjectId>>() == first_target);
    QVERIFY(bench.widget.options().hovered == first_target);
    bench.mouse(QEvent::MouseMove, empty_place, Qt::NoButton);
    QVERIFY(!hovered.last()[0].value<std::optional<scene::ObjectId>>());
    bench.mouse(QEvent::MouseMove, at, Qt::NoButton);
    bench.widget.set_snapshot({});
    QVERIFY(!bench.widget.options().hovered);
  }

  void keys_turn_zoom_fit_and_look_along_the_axes() {
    Bench bench;
    const picture::Camera before = bench.widget.camera();
    QTest::keyClick(&bench.widget, Qt::Key_Right);
    QVERIFY(near(std::remainder(bench.widget.camera().azimuth_rad - before.azimuth_rad, 2 * core::pi), 5 * deg));
    QTest::keyClick(&bench.widget, Qt::Key_Down);
    QVERIFY(near(bench.widget.camera().elevation_rad, 5 * deg));
    QTest::keyClick(&bench.widget, Qt::Key_Plus);
    QCOMPARE(bench.widget.camera().pixels_per_m, 1.25 * before.pixels_per_m);
    QTest::keyClick(&bench.widget, Qt::Key_1);
    QVERIFY(near(bench.widget.camera().elevation_rad, 90 * deg));
    QTest::keyClick(&bench.widget, Qt::Key_3);
    QVERIFY(near(bench.widget.camera().azimuth_rad, 90 * deg));
    QTest::keyClick(&bench.widget, Qt::Key_2);
    QTest::keyClick(&bench.widget, Qt::Key_Home);
    const QRect inside = bench.widget.rect();
    for (const core::Vec3& point : {core::Vec3{}, core::Vec3{100, 0, 50}, core::Vec3{-100, 0, 0}})
      QVERIFY(inside.contains(bench.place_of(point)));
    // The axes, which keep their size, are whole as well.
    const double axis_px = 200.0 * bench.widget.pixel_scale();
    const auto origin = bench.widget.camera().project({});
    QVERIFY(origin->x + axis_px <= bench.widget.camera().width_px);
  }

  void enter_edits_and_the_menu_key_opens_the_menu_of_the_selected_object() {
    Bench bench;
    QSignalSpy edit(&bench.widget, &gui::SceneWidget::edit_requested);
    QSignalSpy menu(&bench.widget, &gui::SceneWidget::menu_requested);
    QTest::keyClick(&bench.widget, Qt::Key_Return);
    QCOMPARE(edit.size(), 0);
    picture::DrawingOptions options;
    options.selected = {second_target};
    bench.widget.set_options(options);
    QTest::keyClick(&bench.widget, Qt::Key_Return);
    QCOMPARE(edit.size(), 1);
    QTest::keyClick(&bench.widget, Qt::Key_Menu);
    QVERIFY(menu.at(0)[0].value<std::optional<scene::ObjectId>>() == second_target);
    QCOMPARE(menu[0][1].toPoint(), bench.widget.mapToGlobal(bench.place_of({100, 0, 50})));
  }

  void delete_asks_for_it_where_something_is_selected() {
    Bench bench;
    QSignalSpy wanted(&bench.widget, &gui::SceneWidget::delete_wanted);
    QTest::keyClick(&bench.widget, Qt::Key_Delete);
    QCOMPARE(wanted.size(), 0);
    picture::DrawingOptions options;
    options.selected = {second_target};
    bench.widget.set_options(options);
    QTest::keyClick(&bench.widget, Qt::Key_Delete);
    QCOMPARE(wanted.size(), 1);
  }

  void paints_targets_in_their_colour_on_both_grounds() {
    Bench bench;
    for (const bool dark : {false, true}) {
      bench.widget.set_dark(dark);
      const QImage image = bench.widget.grab().toImage();
      const raster::Rgb ground = picture::colour(picture::Role::background, dark);
      const raster::Rgb target = picture::colour(picture::Role::target, dark);
      QCOMPARE(image.pixelColor(40, 40), QColor(ground.red, ground.green, ground.blue));
      const QPointF at = QPointF(bench.place_of({100, 0, 50})) * image.devicePixelRatio();
      const QColor seen = image.pixelColor(at.toPoint());
      QVERIFY(std::abs(seen.red() - target.red) + std::abs(seen.green() - target.green) +
                  std::abs(seen.blue() - target.blue) <
              12);
    }
  }

  // The event that comes next is handled before.
  void many_targets_are_painted_in_a_turn_of_their_own() {
    Bench bench;
    bench.widget.show();
    for (const std::size_t count : {std::size_t{100}, std::size_t{20'000}}) {
      picture::Snapshot snapshot;
      for (std::size_t i = 0; i < count; ++i)
        snapshot.targets.push_back(target_at(i, {static_cast<double>(i % 100), static_cast<double>(i / 100), 0.0}));
      bench.widget.set_snapshot(snapshot);
      QTest::qWait(100);
      test::PaintCount paints(&bench.widget);
      bench.widget.set_marks({{scene::ObjectKind::target, 7}}, {}, std::nullopt);
      QCoreApplication::sendPostedEvents();
      QCOMPARE(paints.count, count < 20'000 ? 1 : 0);
      QTRY_COMPARE(paints.count, 1);
    }
  }

  // Goal: 20 ms a frame; the bound leaves room for slow machines and sanitizers.
  void paints_ten_thousand_targets_quickly() {
    Bench bench;
    bench.widget.resize(1200, 800);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> side(-300.0, 300.0);
    picture::Snapshot snapshot;
    for (std::size_t i = 0; i < 10'000; ++i)
      snapshot.targets.push_back(target_at(i, {side(random), side(random), side(random)}));
    bench.widget.set_snapshot(snapshot);
    double best_ms = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 5; ++i) {
      bench.widget.set_camera(picture::turned(bench.widget.camera(), 20.0, 4.0));
      const test::ProcessorTime time;
      const QPixmap picture = bench.widget.grab();
      best_ms = std::min(best_ms, 1e3 * time.seconds());
      QVERIFY(!picture.isNull());
    }
    qInfo("a frame of 10 000 targets with drop lines: %.1f ms", best_ms);
    QVERIFY(best_ms < 1e3);
  }
};

const test::AddTest added("scene_widget_test", test::run_test<SceneWidgetTest>);

}  // namespace sarsim::scene_widget_test

#include "scene_widget_test.moc"

#include <QLabel>
#include <QMouseEvent>
#include <QTest>

#include <cmath>

#include "core/maths/constants.hpp"
#include "gui/gui_test.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/small_scene.hpp"
#include "picture/scene/framing.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::hands_test {
namespace {

constexpr const char* scene_text = R"(format = "sarsim 2"

[[platform]]
name = "Ship"
position = ["-300 m", "100 m", 0]
rotation = ["10 deg", 0, "30 deg"]

[[target]]
position = ["100 m", "50 m", "20 m"]

[[target]]
position = ["-100 m", "-50 m", "20 m"]
)";

// A scene panel that looks at two targets and a ship from an elevation of 30 degrees, 1 px/m.
struct Bench {
  Bench() {
    session.take(scene::Document::from_text(scene_text));
    panel.resize(900, 700);
    panel.show();
    picture::Camera camera = picture::preset(view().camera(), picture::ViewPreset::start);
    camera.focus_world_m = {};
    camera.pixels_per_m = view().pixel_scale();
    view().set_camera(camera);
  }
  [[nodiscard]] gui::SceneWidget& view() { return panel.scene(); }
  [[nodiscard]] core::Vec3 place(std::size_t target) const { return session.scene().targets.at(target).position_m; }
  [[nodiscard]] QPoint pixel_of(const core::Vec3& world_m) {
    const auto at = view().camera().project(world_m);
    return (QPointF(at->x, at->y) / view().pixel_scale()).toPoint();
  }
  [[nodiscard]] QPoint handle(picture::GizmoHandle::Kind kind, std::size_t index) {
    const auto at =
        picture::handle_point(view().handles()->gizmo, {kind, index}, view().camera(), view().pixel_scale());
    return (QPointF(at->x, at->y) / view().pixel_scale()).toPoint();
  }
  void mouse(QEvent::Type type, QPoint at, Qt::KeyboardModifiers modifiers = {}, bool held = true) {
    const bool move = type == QEvent::MouseMove;
    const bool down = held && type != QEvent::MouseButtonRelease;
    QMouseEvent event(type, at, view().mapToGlobal(at), move ? Qt::NoButton : Qt::LeftButton,
                      down ? Qt::LeftButton : Qt::NoButton, modifiers);
    QCoreApplication::sendEvent(&view(), &event);
  }
  void take(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
    mouse(QEvent::MouseButtonPress, from, modifiers);
    mouse(QEvent::MouseMove, from + (to - from) / 2, modifiers);
    mouse(QEvent::MouseMove, to, modifiers);
  }
  void let_go(QPoint at) { mouse(QEvent::MouseButtonRelease, at); }
  void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
    take(from, to, modifiers);
    let_go(to);
  }
  void key(Qt::Key key) { QTest::keyClick(&view(), key); }
  void type(const char* text) { QTest::keyClicks(&view(), text); }
  [[nodiscard]] QString words() { return panel.findChild<QLabel*>("hand_words")->text(); }

  gui::Session session;
  gui::ScenePanel panel{session};
};

using Kind = picture::GizmoHandle::Kind;

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

}  // namespace

class HandsTest : public QObject {
  Q_OBJECT

 private slots:
  void a_dragged_target_stays_on_its_level_and_is_selected() {
    Bench bench;
    const core::Vec3 to{180.0, -20.0, 20.0};
    bench.take(bench.pixel_of(bench.place(0)), bench.pixel_of(to));
    QVERIFY(bench.session.current() == test::target(0));
    auto* words = bench.panel.findChild<QLabel*>("hand_words");
    QVERIFY(words->isVisible());
    QVERIFY2(bench.words().contains("z 20 m") && bench.words().contains("Δ"), qPrintable(bench.words()));
    QVERIFY(bench.panel.findChild<QLabel*>("place_under_pointer")->text().contains("z 20 m"));
    bench.let_go(bench.pixel_of(to));
    QVERIFY(!words->isVisible());
    QCOMPARE(bench.place(0).z, 20.0);
    QVERIFY(core::norm(bench.place(0) - to) < 4.0);
    QCOMPARE(bench.session.document().history().undo_label(), std::string("Move target"));
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
  }

  void a_view_along_the_ground_moves_upright_and_says_so() {
    Bench bench;
    bench.view().look(picture::ViewPreset::front);
    const QPoint at = bench.pixel_of(bench.place(0));
    bench.take(at, at + QPoint(30, -40));
    QVERIFY2(bench.words().contains("seen from its edge"), qPrintable(bench.words()));
    bench.let_go(at + QPoint(30, -40));
    QCOMPARE(bench.place(0).y, 50.0);
    QVERIFY(near(bench.place(0).z, 60.0, 1.0));
    QVERIFY(near(bench.place(0).x, 130.0, 1.0));
  }

  void keys_lock_an_axis_and_free_it() {
    Bench bench;
    const QPoint at = bench.pixel_of(bench.place(0));
    bench.take(at, at + QPoint(60, 25));
    const core::Vec3 free = bench.place(0);
    QVERIFY(free.x != 100.0 && free.y != 50.0);
    for (const auto& [key, axis] : {std::pair{Qt::Key_X, 0}, std::pair{Qt::Key_Y, 1}, std::pair{Qt::Key_Z, 2}}) {
      bench.key(key);
      const core::Vec3 now = bench.place(0);
      QCOMPARE(now.x != 100.0, axis == 0);
      QCOMPARE(now.y != 50.0, axis == 1);
      QCOMPARE(now.z != 20.0, axis == 2);
      QVERIFY(bench.view().options().guide.has_value());
    }
    bench.key(Qt::Key_Z);
    QVERIFY(bench.place(0) == free);
    QVERIFY(!bench.view().options().guide);
    bench.let_go(at);
    QCOMPARE(bench.session.document().history().undo_label(), std::string("Move target"));
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
  }

  void a_typed_number_is_the_way_along_the_axis() {
    Bench bench;
    const QPoint at = bench.pixel_of(bench.place(0));
    bench.take(at, at + QPoint(60, 25));
    bench.key(Qt::Key_Y);
    bench.type("1234");
    bench.key(Qt::Key_Backspace);
    QCOMPARE(bench.place(0).y, 173.0);
    QVERIFY2(bench.words().contains("Δ 123 along y"), qPrintable(bench.words()));
    bench.type(" km");
    QCOMPARE(bench.place(0).y, 123'050.0);
    QCOMPARE(bench.place(0).x, 100.0);
    bench.key(Qt::Key_Return);
    // The hand has let go: what the pointer does now is nothing.
    bench.mouse(QEvent::MouseMove, at + QPoint(200, 0));
    bench.let_go(at + QPoint(200, 0));
    QCOMPARE(bench.place(0).y, 123'050.0);
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
  }

  void a_number_without_a_lock_goes_along_the_longest_way() {
    Bench bench;
    const QPoint at = bench.pixel_of(bench.place(0));
    bench.take(at, bench.pixel_of(bench.place(0) + core::Vec3{80.0, 5.0, 0.0}));
    bench.type("-40");
    QCOMPARE(bench.place(0).x, 60.0);
    QCOMPARE(bench.place(0).y, 50.0);
    bench.key(Qt::Key_Escape);
    bench.let_go(at);
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
  }

  void escape_puts_everything_back() {
    Bench bench;
    const QPoint at = bench.pixel_of(bench.place(0));
    bench.take(at, at + QPoint(60, 25));
    bench.key(Qt::Key_X);
    bench.type("7");
    bench.key(Qt::Key_Escape);
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
    QVERIFY(!bench.session.document().history().can_undo());
    QVERIFY(!bench.view().options().guide);
    QVERIFY(!bench.panel.findChild<QLabel*>("hand_words")->isVisible());
    bench.let_go(at);
  }

  void an_arrow_moves_along_its_axis_and_a_square_on_its_plane() {
    Bench bench;
    bench.session.select_only(test::target(0));
    const QPoint arrow = bench.handle(Kind::arrow, 2);
    bench.mouse(QEvent::MouseMove, arrow, {}, false);
    QVERIFY(bench.view().options().hovered_handle == (picture::GizmoHandle{Kind::arrow, 2}));
    bench.drag(arrow, arrow + QPoint(9, -50));
    QCOMPARE(bench.place(0).x, 100.0);
    QCOMPARE(bench.place(0).y, 50.0);
    QVERIFY(near(bench.place(0).z, 20.0 + 50.0 / std::cos(30.0 * core::rad_per_deg), 1.5));
    bench.session.undo();
    const QPoint square = bench.handle(Kind::square, 0);
    bench.drag(square, square + QPoint(30, -50));
    QCOMPARE(bench.place(0).x, 100.0);
    QVERIFY(bench.place(0).y != 50.0 && bench.place(0).z != 20.0);
  }

  void shift_rounds_along_an_arrow() {
    Bench bench;
    bench.session.select_only(test::target(0));
    const QPoint arrow = bench.handle(Kind::arrow, 0);
    bench.drag(arrow, arrow + QPoint(-37, 11), Qt::ShiftModifier);
    QVERIFY(bench.place(0).x != 100.0);
    QVERIFY(near(std::remainder(bench.place(0).x, 10.0), 0.0, 1e-9));
  }

  void a_ring_turns_a_platform_by_one_angle() {
    Bench bench;
    bench.session.select_only(test::platform(0));
    const auto angles = [&] { return bench.session.scene().platforms.at(0).rotation; };
    const QPoint ring = bench.handle(Kind::ring, 2);
    bench.take(ring, ring + QPoint(40, 0), Qt::ShiftModifier);
    QVERIFY2(bench.words().startsWith("yaw"), qPrintable(bench.words()));
    QCOMPARE(angles()[0].deg(), 10.0);
    QCOMPARE(angles()[1].deg(), 0.0);
    QVERIFY(angles()[2].deg() != 30.0);
    QCOMPARE(std::remainder(angles()[2].deg(), 5.0), 0.0);
    bench.type("12.5");
    QCOMPARE(angles()[2].deg(), 42.5);
    bench.key(Qt::Key_Return);
    bench.let_go(ring);
    QCOMPARE(bench.session.document().history().undo_label(), std::string("Turn platform"));
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
  }

  void everything_is_moved_and_turned_by_keys_alone() {
    Bench bench;
    bench.session.select_only(test::target(1));
    bench.key(Qt::Key_G);
    bench.key(Qt::Key_Z);
    bench.type("2.5");
    bench.key(Qt::Key_Return);
    QCOMPARE(bench.place(1).z, 22.5);
    bench.session.select_only(test::platform(0));
    bench.key(Qt::Key_R);
    bench.key(Qt::Key_X);
    bench.type("-15");
    bench.key(Qt::Key_Return);
    const auto& rotation = bench.session.scene().platforms.at(0).rotation;
    QCOMPARE(rotation[0].deg(), -5.0);
    QCOMPARE(rotation[2].deg(), 30.0);
    bench.session.undo();
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
  }

  void a_grab_follows_the_pointer_until_a_click() {
    Bench bench;
    bench.session.select_only(test::target(0));
    const QPoint at(400, 300);
    bench.mouse(QEvent::MouseMove, at, {}, false);
    bench.key(Qt::Key_G);
    bench.mouse(QEvent::MouseMove, at + QPoint(50, 0), {}, false);
    QVERIFY(bench.place(0) != (core::Vec3{100.0, 50.0, 20.0}));
    bench.mouse(QEvent::MouseButtonPress, at + QPoint(50, 0));
    bench.let_go(at + QPoint(50, 0));
    const core::Vec3 there = bench.place(0);
    bench.mouse(QEvent::MouseMove, at + QPoint(90, 0), {}, false);
    QVERIFY(bench.place(0) == there);
    QCOMPARE(bench.session.current(), std::optional(test::target(0)));
  }

  void handles_lie_along_the_platforms_own_axes_on_demand() {
    Bench bench;
    bench.session.select_only(test::platform(0));
    const auto along = bench.view().handles()->gizmo.axes_world[0];
    QVERIFY(along == (core::Vec3{1.0, 0.0, 0.0}));
    bench.key(Qt::Key_L);
    const core::Vec3 own = bench.view().handles()->gizmo.axes_world[0];
    QVERIFY(near(core::dot(own, along), std::cos(30.0 * core::rad_per_deg), 1e-12));
    bench.key(Qt::Key_G);
    bench.key(Qt::Key_X);
    bench.type("100");
    bench.key(Qt::Key_Return);
    const core::Vec3 way = bench.session.scene().platforms.at(0).position_m - core::Vec3{-300.0, 100.0, 0.0};
    QVERIFY(core::norm(way - 100.0 * own) < 1e-6);
  }

  void the_selection_fills_the_view_and_new_scenes_start_at_the_first_scale() {
    Bench bench;
    bench.session.select({test::target(0), test::target(1)});
    bench.key(Qt::Key_F);
    const auto points = picture::points_of(bench.view().snapshot(), bench.session.selection());
    QVERIFY(picture::shows_well(bench.view().camera(), points));
    QVERIFY(bench.view().camera().pixels_per_m > 1.5);
    const picture::Camera framed = bench.view().camera();
    bench.view().fit();
    QVERIFY(bench.view().camera().pixels_per_m < framed.pixels_per_m);
    bench.key(Qt::Key_Period);
    QCOMPARE(bench.view().camera().pixels_per_m, framed.pixels_per_m);
    bench.session.take(scene::Document());
    QCOMPARE(bench.view().camera().pixels_per_m, 0.01 * bench.view().pixel_scale());
    QVERIFY(bench.view().camera().focus_world_m == core::Vec3{});
  }

  void a_platform_is_framed_with_what_it_carries() {
    Bench bench;
    scene::Target mast;
    mast.platform = "Ship";
    mast.position_m = {0.0, 0.0, 40.0};
    bench.session.perform(scene::add_object(bench.session.scene(), mast));
    bench.session.select_only(test::platform(0));
    bench.key(Qt::Key_F);
    QVERIFY(bench.view().camera().pixels_per_m > 5.0);
  }

  void what_is_imported_is_shown_and_undo_leaves_the_view() {
    Bench bench;
    std::vector<scene::Target> targets(3);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      targets[i].platform = "Earth";
      targets[i].position_m = {50e3 + 10.0 * static_cast<double>(i), 0.0, 0.0};
    }
    const picture::Camera before = bench.view().camera();
    bench.session.perform(scene::add_targets(bench.session.scene(), targets));
    std::set<scene::ObjectId> came;
    for (std::size_t i = 2; i < 5; ++i) came.insert(test::target(i));
    QVERIFY(picture::shows_well(bench.view().camera(), picture::points_of(bench.view().snapshot(), came)));
    const picture::Camera shown = bench.view().camera();
    QVERIFY(shown.pixels_per_m != before.pixels_per_m);
    bench.session.undo();
    QCOMPARE(bench.view().camera().pixels_per_m, shown.pixels_per_m);
  }
};

const test::AddTest added("hands_test", test::run_test<HandsTest>);

}  // namespace sarsim::hands_test

#include "hands_test.moc"

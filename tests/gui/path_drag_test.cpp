#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "core/maths/constants.hpp"
#include "gui/common/session.hpp"
#include "gui/gui_test.hpp"
#include "gui/path_bench.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/scene/time_bar.hpp"
#include "scene/edit/path_points.hpp"

namespace sarsim::path_drag_test {
namespace {

constexpr const char* legs_text = R"(format = "sarsim 2"

[[platform]]
name = "Plane"
[platform.path]
type = "legs"
start = [0, "-1 km", "1 km"]
heading = "0 deg"
speed = "100 m/s"
legs = [
  { leg = "straight", length = "2 km" },        # past the target
  { leg = "turn", angle = "90 deg", radius = "500 m" },
  { leg = "straight", length = "1 km" },
]

[[target]]
position = [0, 0, 0]
)";

constexpr const char* waypoints_text = R"(format = "sarsim 2"

[world]
frame = "earth"
epoch = "2026-05-01T12:00:00Z"
anchor = { latitude = "54 deg", longitude = "10 deg" }

[[platform]]
name = "Boat"
[platform.path]
type = "waypoints"
speed = "20 m/s"
bank = "20 deg"
waypoints = [
  { position = { latitude = "54 deg", longitude = "10 deg", height = "0 m" } },
  { position = { latitude = "54.01 deg", longitude = "10 deg", height = "0 m" } },
  { position = { latitude = "54.01 deg", longitude = "10.02 deg", height = "0 m" } },
]
)";

constexpr const char* state_text = R"(format = "sarsim 2"

[world]
frame = "earth"

[[platform]]
name = "Satellite"
rotation = "zero-doppler"
[platform.path]
type = "state"
position = [7078000, 0, 0]            # over the anchor
velocity = [0, -1500, 7400]
)";

using Bench = test::PathBench;

QLabel* place(Bench& bench) { return bench.panel.findChild<QLabel*>("place_under_pointer"); }

}  // namespace

class PathDragTest : public QObject {
  Q_OBJECT

 private slots:
  void the_end_of_a_leg_follows_the_hand() {
    Bench bench(legs_text);
    const std::vector<core::Vec3> before = bench.points();
    QCOMPARE(before.size(), std::size_t{4});
    const core::Vec3 to = before[1] + core::Vec3{300.0, 500.0, 0.0};
    bench.drag(bench.pixel_of(before[1]), bench.pixel_of(to));
    const std::vector<core::Vec3> after = bench.points();
    QVERIFY(core::norm(after[1] - to) < 2.0 / bench.panel.scene().camera().pixels_per_m);
    QVERIFY(bench.platform().course.deg() > 5.0);
    QVERIFY(bench.platform().legs[0].length_m > 2400.0);
    QCOMPARE(bench.platform().legs[1].angle.deg(), 90.0);
    QVERIFY(bench.session.document().text().find("# past the target") != std::string::npos);
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(legs_text));
  }

  void a_leg_behind_a_turn_takes_the_turn_along() {
    Bench bench(legs_text);
    const core::Vec3 from = bench.points()[3];
    const core::Vec3 to = from + core::Vec3{0.0, -700.0, 0.0};
    bench.drag(bench.pixel_of(from), bench.pixel_of(to));
    QVERIFY(core::norm(bench.points()[3] - to) < 2.0 / bench.panel.scene().camera().pixels_per_m);
    QVERIFY(bench.platform().legs[1].angle.deg() > 100.0);
    QCOMPARE(bench.platform().legs[0].length_m, 2000.0);
  }

  void escape_takes_it_back() {
    Bench bench(legs_text);
    const QPoint at = bench.pixel_of(bench.points()[2]);
    bench.mouse(QEvent::MouseButtonPress, at);
    bench.mouse(QEvent::MouseMove, at + QPoint(40, 40));
    QVERIFY(bench.session.document().text() != legs_text);
    QTest::keyClick(&bench.panel.scene(), Qt::Key_Escape);
    QCOMPARE(bench.session.document().text(), std::string(legs_text));
  }

  void points_are_there_for_selected_platforms_alone() {
    Bench bench(legs_text);
    const QPoint at = bench.pixel_of(bench.points()[2]);
    bench.hover(at);
    QVERIFY(bench.panel.scene().options().hovered_point);
    bench.session.select({});
    bench.hover(at);
    QVERIFY(!bench.panel.scene().options().hovered_point);
    bench.drag(at, at + QPoint(40, 40));
    QCOMPARE(bench.session.document().text(), std::string(legs_text));
  }

  void waypoints_on_the_earth_are_moved_on_their_level() {
    Bench bench(waypoints_text);
    const core::Vec3 from = bench.points()[1];
    // Seen from the south at an angle: what goes up in the picture goes north on the ground.
    picture::Camera camera = bench.panel.scene().camera();
    camera.azimuth_rad = core::pi;
    camera.elevation_rad = 0.5;
    bench.panel.scene().set_camera(camera);
    const core::Vec3 to = from + core::Vec3{200.0, 400.0, 0.0};
    bench.drag(bench.pixel_of(from), bench.pixel_of(to));
    const core::Vec3 after = bench.points()[1];
    QVERIFY(std::abs(after.z - from.z) < 1e-6);
    QVERIFY(core::norm(after - to) < 4.0 / camera.pixels_per_m);
    QCOMPARE(bench.points()[0],
             scene::path_points(scene::Document::from_text(waypoints_text).scene().platforms[0], {})[0]);
  }

  void the_state_of_a_satellite_is_put_elsewhere() {
    Bench bench(state_text);
    const std::vector<core::Vec3> before = bench.points();
    QCOMPARE(before.size(), std::size_t{2});
    bench.look_from_above(1e-4);
    const core::Vec3 to = before[0] + core::Vec3{3e5, 8e5, 0.0};
    bench.drag(bench.pixel_of(before[0]), bench.pixel_of(to));
    const core::Vec3 after = bench.points()[0];
    QVERIFY(core::norm(after - to) < 2.0 * bench.pixel_m());
    const scene::Platform& moved = bench.platform();
    QVERIFY(std::abs(core::norm(moved.state_velocity_mps) - std::hypot(1500.0, 7400.0)) < 200.0);
    QVERIFY(std::abs(core::dot(moved.state_velocity_mps, moved.state_position_m)) <
            0.02 * core::norm(moved.state_velocity_mps) * core::norm(moved.state_position_m));
    QVERIFY(bench.text().find("# over the anchor") != std::string::npos);
    QVERIFY(bench.text().find("type = \"state\"") != std::string::npos);
    bench.session.undo();
    QCOMPARE(bench.text(), std::string(state_text));
  }

  void the_end_of_a_velocity_turns_the_orbit() {
    Bench bench(state_text);
    bench.look_from_above(1e-4);
    const core::Vec3 tip = bench.points()[1];
    const core::Vec3 to = tip + core::Vec3{2e5, 0.0, 0.0};
    bench.drag(bench.pixel_of(tip), bench.pixel_of(to));
    QVERIFY(core::norm(bench.points()[1] - to) < 2.0 * bench.pixel_m());
    QVERIFY((bench.platform().state_position_m == core::Vec3{7078e3, 0.0, 0.0}));
    QVERIFY(bench.platform().state_velocity_mps.y > 1500.0);
    QVERIFY(bench.undo_label().find("Move point of path") != std::string::npos);
  }

  void a_state_cannot_be_deleted() {
    Bench bench(state_text);
    bench.look_from_above(1e-4);
    bench.click(bench.pixel_of(bench.points()[1]));
    bench.key(Qt::Key_Delete);
    QCOMPARE(bench.text(), std::string(state_text));
  }

  void the_orbit_is_computed_anew_while_the_state_is_dragged() {
    Bench bench(state_text);
    bench.look_from_above(1e-4);
    const auto shown = [&] { return bench.view().snapshot().platforms[0]; };
    const core::Vec3 from = bench.points()[0];
    QVERIFY(core::norm(shown().pose.position_world_m - from) < 1e-3);
    bench.mouse(QEvent::MouseButtonPress, bench.pixel_of(from));
    bench.mouse(QEvent::MouseMove, bench.pixel_of(from + core::Vec3{-4e5, 6e5, 0.0}));
    QVERIFY(core::norm(bench.points()[0] - from) > 5e5);
    QVERIFY(core::norm(shown().pose.position_world_m - bench.points()[0]) < 1e-3);
    QVERIFY(shown().trail_world_m.size() > 10);
    QTest::keyClick(&bench.view(), Qt::Key_Escape);
    QVERIFY(core::norm(shown().pose.position_world_m - from) < 1e-3);
    QCOMPARE(bench.text(), std::string(state_text));
  }

  void the_place_under_the_pointer_is_told_in_the_worlds_own_terms() {
    Bench flat(legs_text);
    QVERIFY(!place(flat)->isVisible());
    flat.hover(flat.pixel_of({500.0, -700.0, 0.0}));
    QVERIFY(place(flat)->isVisible());
    QCOMPARE(place(flat)->text(), QString("x 500 m  y \u2212700 m  z 0 m"));
    flat.hover(flat.pixel_of(flat.points()[1]));
    QCOMPARE(place(flat)->text(), QString("x 0 m  y 1 km  z 1 km"));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&flat.panel.scene(), &leave);
    QVERIFY(!place(flat)->isVisible());

    Bench earth(waypoints_text);
    earth.hover(earth.pixel_of(earth.points()[1]));
    QVERIFY2(place(earth)->text().startsWith("54.01"), qPrintable(place(earth)->text()));
    QVERIFY(place(earth)->text().contains("° N  10.00000° E  height 0 m"));
    earth.hover(earth.pixel_of({-1000.0, 0.0, 0.0}));
    QVERIFY2(place(earth)->text().contains("9.984"), qPrintable(place(earth)->text()));
  }

  void time_is_shown_as_utc_where_there_is_an_epoch() {
    Bench flat(legs_text);
    QVERIFY(!flat.panel.findChild<QLabel*>("utc_label")->isVisible());
    Bench earth(waypoints_text);
    auto* const utc = earth.panel.findChild<QLabel*>("utc_label");
    QVERIFY(utc->isVisible());
    earth.session.set_time(90.5);
    QCOMPARE(utc->text(), QString("12:01:30.500 UTC"));
  }
};

const test::AddTest added("path_drag_test", test::run_test<PathDragTest>);

}  // namespace sarsim::path_drag_test

#include "path_drag_test.moc"

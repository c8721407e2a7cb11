#include <QLabel>
#include <QMenu>
#include <QTest>

#include <cmath>

#include "core/maths/constants.hpp"
#include "gui/gui_test.hpp"
#include "gui/path_bench.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "scene/edit/path_points.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::tools_test {
namespace {

constexpr const char* flat_text = R"(format = "sarsim 2"

[[platform]]
name = "Boat"
[platform.path]
type = "waypoints"
speed = "20 m/s"
bank = "20 deg"
waypoints = [
  { position = [0, 0, "5 m"] },      # the pier
  { position = ["1 km", 0, "5 m"] },
  { position = ["1 km", "2 km", "5 m"] },
]

[[platform]]
name = "Buoy"
position = ["500 m", "500 m", 0]

[[target]]
position = ["300 m", "400 m", "120 m"]
)";

constexpr const char* legs_text = R"(format = "sarsim 2"

[[platform]]
name = "Plane"
[platform.path]
type = "legs"
start = [0, "-1 km", "1 km"]
heading = "0 deg"
speed = "100 m/s"
legs = [
  { leg = "straight", length = "2 km" },
  { leg = "turn", angle = "90 deg", radius = "500 m" },
  { leg = "straight", length = "1 km" },
]
)";

constexpr const char* earth_text = R"(format = "sarsim 2"

[world]
frame = "earth"
anchor = { latitude = "54 deg", longitude = "10 deg" }

[[platform]]
name = "Boat"
[platform.path]
type = "waypoints"
speed = "20 m/s"
bank = "20 deg"
waypoints = [
  { position = { latitude = "54 deg", longitude = "10 deg", height = "30 m" } },
  { position = { latitude = "54.01 deg", longitude = "10 deg", height = "30 m" } },
]
)";

using Bench = test::PathBench;

using Tool = gui::SceneWidget::Tool;

}  // namespace

class ToolsTest : public QObject {
  Q_OBJECT

 private slots:
  void the_ruler_measures_from_click_to_click_and_takes_objects() {
    Bench bench(flat_text);
    bench.session.select({});
    bench.key(Qt::Key_M);
    QVERIFY(bench.view().tool() == Tool::ruler);
    bench.click(bench.pixel_of({-1000.0, 0.0, 0.0}));
    bench.hover(bench.pixel_of({-500.0, -500.0, 0.0}));
    bench.click(bench.pixel_of({300.0, 400.0, 120.0}));
    const auto ruler = bench.view().options().ruler;
    QVERIFY(ruler);
    QVERIFY(core::norm(ruler->from_world_m - core::Vec3{-1000.0, 0.0, 0.0}) <= bench.pixel_m());
    QVERIFY(ruler->to_world_m == (core::Vec3{300.0, 400.0, 120.0}));  // the target, not the ground below
    QCOMPARE(bench.view().options().ruler_words.size(), std::size_t{3});
    QVERIFY2(bench.view().options().ruler_words[0].starts_with("1.3"), bench.view().options().ruler_words[0].c_str());
    QVERIFY(bench.view().options().ruler_words[1].find("height 120 m") != std::string::npos);
    QVERIFY(bench.session.selection().empty());
    // Fixed now, and taken by its ends.
    bench.hover(bench.pixel_of({800.0, -900.0, 0.0}));
    QVERIFY(bench.view().options().ruler == ruler);
    bench.drag(bench.pixel_of({-1000.0, 0.0, 0.0}), bench.pixel_of({-1500.0, 300.0, 0.0}));
    QVERIFY(core::norm(bench.view().options().ruler->from_world_m - core::Vec3{-1500.0, 300.0, 0.0}) <=
            2.0 * bench.pixel_m());
    QVERIFY(bench.view().options().ruler->to_world_m == ruler->to_world_m);
    bench.key(Qt::Key_Escape);
    QVERIFY(!bench.view().options().ruler);
    QVERIFY(bench.view().tool() == Tool::hand);
    QCOMPARE(bench.text(), std::string(flat_text));
  }

  void nothing_is_moved_while_it_is_measured() {
    Bench bench(flat_text);
    bench.panel.measure(true);
    const double azimuth = bench.view().camera().azimuth_rad;
    const QPoint at = bench.pixel_of({300.0, 400.0, 120.0});
    bench.drag(at, at + QPoint(60, 0));
    QCOMPARE(bench.text(), std::string(flat_text));
    QVERIFY(bench.view().camera().azimuth_rad != azimuth);
  }

  void a_double_click_on_a_path_puts_a_waypoint_in() {
    Bench bench(flat_text);
    bench.double_click(bench.pixel_of({1000.0, 900.0, 5.0}));
    QCOMPARE(bench.points().size(), std::size_t{4});
    QVERIFY(core::norm(bench.points()[2] - core::Vec3{1000.0, 900.0, 5.0}) <= bench.pixel_m());
    QCOMPARE(bench.undo_label(), std::string("Add waypoint"));
    QVERIFY(bench.text().find("# the pier") != std::string::npos);
    QVERIFY(bench.view().options().selected_point == (picture::PathPointId{test::platform(0), 2}));
    // It is selected: Delete takes it out, and not the platform.
    bench.key(Qt::Key_Delete);
    QCOMPARE(bench.points().size(), std::size_t{3});
    QCOMPARE(bench.session.scene().platforms.size(), std::size_t{2});
    QCOMPARE(bench.undo_label(), std::string("Delete waypoint"));
    bench.session.undo();
    QCOMPARE(bench.points().size(), std::size_t{4});
    bench.session.undo();
    QCOMPARE(bench.text(), std::string(flat_text));
  }

  void a_click_takes_a_waypoint_and_its_arrow_lifts_it() {
    Bench bench(flat_text);
    bench.click(bench.pixel_of({1000.0, 2000.0, 5.0}));
    QVERIFY(bench.view().options().selected_point == (picture::PathPointId{test::platform(0), 2}));
    bench.key(Qt::Key_G);
    bench.key(Qt::Key_Z);
    QTest::keyClicks(&bench.view(), "45");
    bench.key(Qt::Key_Return);
    QVERIFY(bench.points()[2] == (core::Vec3{1000.0, 2000.0, 50.0}));
    bench.session.undo();
    QCOMPARE(bench.text(), std::string(flat_text));
  }

  void clicks_draw_a_path_on_its_level_one_step_each() {
    Bench bench(flat_text);
    bench.key(Qt::Key_P);
    QVERIFY(bench.view().tool() == Tool::path);
    bench.hover(bench.pixel_of({0.0, 2500.0, 5.0}));
    QVERIFY(bench.view().options().ruler);  // from the last point to the pointer
    bench.click(bench.pixel_of({0.0, 2500.0, 5.0}));
    bench.click(bench.pixel_of({-1500.0, 1000.0, 5.0}));
    QCOMPARE(bench.points().size(), std::size_t{5});
    QCOMPARE(bench.points()[4].z, 5.0);
    QVERIFY(core::norm(bench.points()[4] - core::Vec3{-1500.0, 1000.0, 5.0}) <= bench.pixel_m());
    bench.key(Qt::Key_Return);
    QVERIFY(bench.view().tool() == Tool::hand);
    QVERIFY(!bench.view().options().ruler);
    bench.session.undo();
    QCOMPARE(bench.points().size(), std::size_t{4});
    bench.session.undo();
    QCOMPARE(bench.text(), std::string(flat_text));
  }

  void a_platform_that_rests_is_sent_on_its_way() {
    Bench bench(flat_text);
    bench.session.select_only(test::platform(1));
    bench.panel.draw_path(true);
    bench.click(bench.pixel_of({-800.0, 500.0, 0.0}));
    QVERIFY(bench.platform(1).path == scene::Platform::Path::waypoints);
    QCOMPARE(scene::path_points(bench.platform(1), {}).size(), std::size_t{2});
    QVERIFY((scene::path_points(bench.platform(1), {})[0] == core::Vec3{500.0, 500.0, 0.0}));
  }

  void a_scene_in_the_language_of_1998_says_that_it_has_no_waypoints() {
    Bench bench(flat_text);
    test::open(bench.session, test::small_scene());
    const std::string before = bench.text();
    bench.session.select_only(test::platform(1));
    QStringList logged;
    connect(&bench.session, &gui::Session::logged, this, [&](int, const QString& text) { logged << text; });
    bench.panel.draw_path(true);
    emit bench.view().path_place_wanted({500.0, 500.0, 0.0});
    QCOMPARE(bench.text(), before);
    QVERIFY2(logged.join('\n').contains("sarsim convert"), qPrintable(logged.join('\n')));
    QVERIFY(bench.view().tool() == Tool::hand);
  }

  void without_a_platform_there_is_no_path_to_draw() {
    Bench bench(flat_text);
    bench.session.select({});
    bench.key(Qt::Key_P);
    QVERIFY(bench.view().tool() == Tool::hand);
  }

  void legs_are_divided_continued_and_taken_out() {
    Bench bench(legs_text);
    bench.double_click(bench.pixel_of({0.0, -300.0, 1000.0}));
    QCOMPARE(bench.platform().legs.size(), std::size_t{4});
    QCOMPARE(bench.platform().legs[0].length_m + bench.platform().legs[1].length_m, 2000.0);
    QCOMPARE(bench.undo_label(), std::string("Add leg"));
    bench.key(Qt::Key_P);
    const core::Vec3 to = bench.points().back() + core::Vec3{1000.0, -2000.0, 0.0};
    bench.click(bench.pixel_of(to));
    bench.key(Qt::Key_Escape);
    QCOMPARE(bench.platform().legs.size(), std::size_t{6});
    QVERIFY(core::norm(bench.points().back() - to) < 2.0 * bench.pixel_m());
    bench.session.undo();
    bench.session.undo();
    QCOMPARE(bench.text(), std::string(legs_text));
  }

  void over_the_earth_waypoints_keep_their_height() {
    Bench bench(earth_text);
    bench.key(Qt::Key_P);
    bench.click(bench.pixel_of({2000.0, 1500.0, 30.0}));
    QCOMPARE(bench.points().size(), std::size_t{3});
    const auto earth = scene::earth_of(bench.session.scene().world);
    const radar::Geodetic place = earth->geodetic_of(bench.points()[2]);
    QVERIFY2(std::abs(place.height_m - 30.0) < 1e-3, qPrintable(QString::number(place.height_m)));
    QVERIFY(bench.panel.findChild<QLabel*>("place_under_pointer")->text().contains("° N"));
  }

  void the_menu_has_what_the_place_allows() {
    Bench bench(flat_text);
    const auto entries = [&] {
      QMenu menu;
      bench.panel.add_hand_entries(menu);
      QStringList names;
      for (const QAction* action : menu.actions()) names << action->objectName();
      return names;
    };
    QVERIFY(!entries().contains("hand_add_point"));
    QVERIFY(entries().contains("hand_draw_path"));
    QStringList in_menu;
    connect(&bench.panel, &gui::ScenePanel::menu_requested, this, [&] { in_menu = entries(); });
    bench.click(bench.pixel_of({1000.0, 900.0, 5.0}), Qt::RightButton);
    QVERIFY(in_menu.contains("hand_add_point"));
    bench.session.select({});
    QVERIFY(!entries().contains("hand_draw_path"));
    QVERIFY(entries().contains("hand_all"));
  }
};

const test::AddTest added("tools_test", test::run_test<ToolsTest>);

}  // namespace sarsim::tools_test

#include "tools_test.moc"

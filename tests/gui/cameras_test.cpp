#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <set>

#include "core/maths/constants.hpp"
#include "gui/gui_test.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/small_scene.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::cameras_test {
namespace {

constexpr const char* scene_text = R"(format = "sarsim 2"

[[platform]]
name = "Ship"
position = [0, "500 m", 0]

[[platform]]
name = "Plane"
[platform.path]
type = "waypoints"
speed = "100 m/s"
waypoints = [{ position = ["-1 km", "-3 km", "3 km"] }, { position = ["1 km", "-3 km", "3 km"] }]

[[radar]]
name = "Camera"
platform = "Plane"
antenna = { type = "sinx", elevation_width = "4 deg", azimuth_width = "1.5 deg" }
beam = { type = "spot", point = [0, 0, 0] }

[[target]]
position = ["100 m", "50 m", 0]
)";

struct Bench {
  Bench() {
    session.take(scene::Document::from_text(scene_text));
    panel.resize(900, 700);
    panel.show();
  }
  [[nodiscard]] gui::SceneWidget& view() { return panel.scene(); }
  [[nodiscard]] core::Vec3 place(scene::ObjectId id) { return *picture::place_of(view().snapshot(), id); }
  [[nodiscard]] core::Vec3 eye() {
    const picture::Camera& camera = view().camera();
    return camera.focus_world_m +
           camera.viewer_distance_m() * core::direction(camera.azimuth_rad, camera.elevation_rad);
  }
  [[nodiscard]] QPointF pixel_of(const core::Vec3& world_m) {
    const auto at = view().camera().project(world_m);
    return at ? QPointF(at->x, at->y) : QPointF(-1.0, -1.0);
  }
  [[nodiscard]] QString words() { return panel.findChild<QLabel*>("view_direction")->text(); }
  [[nodiscard]] QToolButton* button(const char* name) { return panel.findChild<QToolButton*>(name); }

  gui::Session session;
  gui::ScenePanel panel{session};
};

bool near(const core::Vec3& a, const core::Vec3& b) { return core::norm(a - b) < 1e-6 * (1.0 + core::norm(a)); }

}  // namespace

class CamerasTest : public QObject {
  Q_OBJECT

 private slots:
  void the_scene_of_the_test_is_sound() {
    Bench bench;
    for (const core::Problem& problem : bench.session.problems()) qInfo("%s", problem.message.c_str());
    QCOMPARE(bench.session.scene().radars.size(), std::size_t{1});
    QCOMPARE(bench.session.scene().platforms.size(), std::size_t{2});
  }

  void what_is_hidden_or_selected_is_so_in_the_picture() {
    Bench bench;
    const scene::ObjectId ship{scene::ObjectKind::platform, 0};
    const QImage plain = bench.view().grab().toImage();
    QVERIFY(bench.view().grab().toImage() == plain);
    bench.session.set_hidden({ship}, true);
    QVERIFY(bench.view().options().hidden == std::set<scene::ObjectId>{ship});
    QVERIFY(bench.view().grab().toImage() != plain);
    bench.session.set_hidden({ship}, false);
    QVERIFY(bench.view().grab().toImage() == plain);
    bench.session.select_only(ship);
    QVERIFY(bench.view().grab().toImage() != plain);
    bench.session.select({});
    QVERIFY(bench.view().grab().toImage() == plain);
  }

  void along_the_beam_the_eye_is_at_the_antenna_as_time_runs() {
    Bench bench;
    const bool perspective = bench.view().camera().perspective;
    bench.button("camera_beam")->click();
    QVERIFY(bench.panel.ride() == gui::ScenePanel::Ride::beam);
    QVERIFY(bench.button("camera_beam")->isChecked());
    QVERIFY2(bench.words().startsWith("Along the beam of Camera"), qPrintable(bench.words()));
    for (const double time_s : {0.0, 5.0, 15.0}) {
      bench.session.set_time(time_s);
      QVERIFY(near(bench.eye(), bench.place(test::radar(0))));
      QVERIFY(near(bench.view().camera().focus_world_m, core::Vec3{}));
    }
    // The next view is seen as before.
    QTest::keyClick(&bench.view(), Qt::Key_1);
    QVERIFY(bench.panel.ride() == gui::ScenePanel::Ride::none);
    QVERIFY(!bench.button("camera_beam")->isChecked());
    QCOMPARE(bench.view().camera().perspective, perspective);
    QCOMPARE(bench.view().camera().heights_away, picture::distance_in_heights);
  }

  void turning_by_hand_ends_the_view_along_the_beam() {
    Bench bench;
    QTest::keyClick(&bench.view(), Qt::Key_4);
    QVERIFY(bench.panel.ride() == gui::ScenePanel::Ride::beam);
    QTest::keyClick(&bench.view(), Qt::Key_Left);
    QVERIFY(bench.panel.ride() == gui::ScenePanel::Ride::none);
    const core::Vec3 eye = bench.eye();
    bench.session.set_time(7.0);
    QVERIFY(near(bench.eye(), eye));
  }

  void a_platform_that_is_followed_stays_where_it_was_in_the_picture() {
    Bench bench;
    bench.view().fit();
    bench.session.select_only(test::platform(1));
    const QPointF before = bench.pixel_of(bench.place(test::platform(1)));
    bench.button("camera_follow")->click();
    QVERIFY2(bench.words().startsWith("Follows Plane"), qPrintable(bench.words()));
    bench.session.set_time(10.0);
    QVERIFY((bench.pixel_of(bench.place(test::platform(1))) - before).manhattanLength() < 1e-6);
    // Panning changes where it stays.
    QTest::keyClick(&bench.view(), Qt::Key_Right, Qt::ShiftModifier);
    const QPointF panned = bench.pixel_of(bench.place(test::platform(1)));
    QVERIFY((panned - before).manhattanLength() > 10.0);
    bench.session.set_time(15.0);
    QVERIFY((bench.pixel_of(bench.place(test::platform(1))) - panned).manhattanLength() < 1e-6);
    QTest::keyClick(&bench.view(), Qt::Key_5);
    QVERIFY(bench.panel.ride() == gui::ScenePanel::Ride::none);
    bench.session.set_time(3.0);
    QVERIFY((bench.pixel_of(bench.place(test::platform(1))) - panned).manhattanLength() > 10.0);
  }

  void what_is_followed_is_the_same_when_objects_before_it_go() {
    Bench bench;
    bench.panel.follow(test::platform(1));
    bench.session.perform(scene::remove_objects(bench.session.scene(), {test::platform(0)}));
    QCOMPARE(bench.panel.followed(), std::optional(test::platform(0)));
    bench.session.perform(scene::remove_objects(bench.session.scene(), {test::platform(0)}));
    QVERIFY(!bench.panel.followed());
  }

  void the_view_turns_about_the_selection() {
    Bench bench;
    bench.session.select_only(test::target(0));
    bench.panel.focus_on_selection();
    const QPointF middle = bench.pixel_of(bench.place(test::target(0)));
    for (int i = 0; i < 5; ++i) QTest::keyClick(&bench.view(), Qt::Key_Left);
    QVERIFY((bench.pixel_of(bench.place(test::target(0))) - middle).manhattanLength() < 1e-6);
  }

  void views_have_names_and_can_be_kept() {
    Bench bench;
    QMenu menu;
    const auto names = [&] {
      bench.panel.fill_cameras(menu);
      QStringList all;
      for (const QAction* action : menu.actions())
        if (!action->isSeparator()) all << action->text();
      return all;
    };
    QVERIFY(names().contains("Along the Beam of Camera"));
    QVERIFY(names().contains("Follow Plane"));
    const picture::Camera before = bench.view().camera();
    bench.panel.keep_view();
    bench.view().look(picture::ViewPreset::top);
    QVERIFY(names().contains("View 1"));
    for (QAction* action : menu.actions())
      if (action->text() == "View 1") action->trigger();
    QCOMPARE(bench.view().camera().azimuth_rad, before.azimuth_rad);
    QCOMPARE(bench.view().camera().pixels_per_m, before.pixels_per_m);
    bench.session.take(scene::Document());
    QVERIFY(!names().contains("View 1"));
  }

  void buttons_have_names_and_tips() {
    Bench bench;
    const auto buttons = bench.panel.findChild<QWidget*>("camera_bar")->findChildren<QToolButton*>();
    QVERIFY(buttons.size() >= 8);
    for (const QToolButton* button : buttons) {
      QVERIFY(!button->accessibleName().isEmpty());
      QVERIFY(!button->toolTip().isEmpty());
      QVERIFY(!button->icon().isNull());
    }
  }

  void words_and_buttons_do_not_keep_the_scene_wide() {
    Bench bench;
    QVERIFY(bench.view().minimumWidth() <= 160);
    QVERIFY(bench.panel.minimumSizeHint().height() < 300);
  }
};

const test::AddTest added("cameras_test", test::run_test<CamerasTest>);

}  // namespace sarsim::cameras_test

#include "cameras_test.moc"

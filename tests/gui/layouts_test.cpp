// Scene, echoes and image in one window, on small screens and large ones.

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QSettings>
#include <QtTest>

#include <algorithm>

#include "gui/echo/echo_panel.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/frame/problem_watch.hpp"
#include "gui/gui_test.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/small_scene.hpp"
#include "scene/edit/edit.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::layouts_test {

namespace {

QString example(const char* name) { return QString(SARSIM_SOURCE_DIR "/examples/") + name; }

bool is_seen(const gui::MainWindow& window, const char* dock) {
  return window.findChild<QDockWidget*>(QString("%1_dock").arg(dock))->isVisible();
}

}  // namespace

class LayoutsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  void scene_echoes_and_image_fit_small_screens_side_by_side_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("laptop") << QSize(1366, 700);
    QTest::newRow("2560 x 1440 at 200 %") << QSize(1280, 680);
  }

  // Finding B4.
  void scene_echoes_and_image_fit_small_screens_side_by_side() {
    QFETCH(QSize, size);
    gui::MainWindow window;
    window.use_layout("views");
    window.resize(size);
    window.show();
    QVERIFY(window.documents().open_file(example("satellite.toml")));
    gui::SimulationWindow* echoes = window.simulation_windows().open_new(scene::Processing::raw);
    QTest::qWait(50);
    QVERIFY2(window.width() <= size.width() && window.height() <= size.height(),
             qPrintable(QString("%1 x %2").arg(window.width()).arg(window.height())));
    QVERIFY(!echoes->isWindow() && echoes->isVisible());
    QVERIFY(is_seen(window, "image"));
    QVERIFY(window.scene().scene().width() >= 200);
    QVERIFY(echoes->plot().plot_rect().width() >= 80);
    // One after another, without a gap and without lying over each other.
    const auto left = [&](const QWidget* widget) { return widget->mapTo(&window, QPoint(0, 0)).x(); };
    const auto* image = window.findChild<QDockWidget*>("image_dock");
    QVERIFY(left(&window.scene()) + window.scene().width() <= left(echoes));
    QVERIFY(left(echoes) + echoes->width() <= left(image));
  }

  // Echoes of a scene that is opened beside them need no button, and once they are closed, nobody opens them again.
  void echoes_of_a_scene_that_is_opened_are_there_once() {
    gui::MainWindow window;
    window.use_layout("views");
    window.show();
    auto& echoes = window.simulation_windows();
    QTest::qWait(20);
    QVERIFY(echoes.windows().empty());  // There is no radar yet.
    QVERIFY(window.documents().open_file(example("satellite.toml")));
    QTRY_COMPARE(echoes.windows().size(), 1U);
    QCOMPARE(window.focusWidget(), &window.scene().scene());  // not what follows the page of welcome
    QVERIFY(!echoes.windows().front()->isWindow() && echoes.windows().front()->isVisible());
    const int first = window.session().number();
    auto* const text = window.findChild<QWidget*>("script_text");
    text->setFocus();
    QVERIFY(window.documents().open_file(example("sar_r.scr")));
    QTRY_COMPARE(echoes.windows().size(), 1U);
    QCOMPARE(window.focusWidget(), text);  // The keyboard stays where it was.
    echoes.windows().front()->close();
    QTRY_VERIFY(echoes.windows().empty());
    window.session().turn_to(0);
    QCOMPARE(window.session().number(), first);
    QTest::qWait(20);
    QCOMPARE(echoes.windows().size(), 1U);  // Those that it had.
    window.session().turn_to(1);
    QTest::qWait(20);
    QVERIFY(echoes.windows().empty());
    for (const char* layout : {"scene", "views"}) window.apply_layout(layout);
    QTest::qWait(20);
    QVERIFY(echoes.windows().empty());
  }

  // They would slow the image down.
  void echoes_of_very_many_targets_wait_until_they_are_wanted() {
    gui::MainWindow window;
    window.use_layout("views");
    window.show();
    const auto take = [&](std::size_t targets) {
      window.session().take(scene::Document::from_text(scene::write_script(test::many_targets(targets))));
      QTest::qWait(50);
    };
    take(4097);
    QVERIFY(window.simulation_windows().windows().empty());
    QTest::mouseClick(window.findChild<QWidget*>("echo_panel_raw"), Qt::LeftButton);
    QCOMPARE(window.simulation_windows().windows().size(), 1U);
    window.simulation_windows().windows().front()->close();
    take(4096);
    QCOMPARE(window.simulation_windows().windows().size(), 1U);
  }

  void echoes_of_a_scene_that_stores_no_recording_are_those_of_its_radar() {
    gui::MainWindow window;
    window.use_layout("scene");
    window.show();
    QVERIFY(window.documents().open_file(example("sar_r.scr")));
    QTest::qWait(20);
    QVERIFY(window.simulation_windows().windows().empty());  // Where they are not seen, nothing is computed.
    window.session().perform(scene::remove_objects(window.session().scene(), {{scene::ObjectKind::simulation, 0}}));
    window.apply_layout("echoes");
    QTRY_COMPARE(window.simulation_windows().windows().size(), 1U);
  }

  // The window must not grow beyond the screen when the script is asked for.
  void the_script_and_its_search_fit_beside_them() {
    gui::MainWindow window;
    window.use_layout("views");
    window.resize(1280, 680);
    window.show();
    QVERIFY(window.documents().open_file(example("satellite.toml")));
    window.simulation_windows().open_new(scene::Processing::raw);
    window.findChild<QAction*>("display_script")->trigger();
    window.findChild<QAction*>("script_find")->trigger();
    QTest::qWait(50);
    QVERIFY(window.findChild<QWidget*>("find_text")->isVisible());
    QVERIFY2(window.width() <= 1280 && window.height() <= 680,
             qPrintable(QString("%1 x %2").arg(window.width()).arg(window.height())));
  }

  void the_direction_of_the_view_is_whole_in_a_narrow_scene() {
    gui::MainWindow window;
    window.show();
    auto* words = window.findChild<QLabel*>("view_direction");
    QWidget& scene = window.scene().scene();
    for (const int width : {1500, 900}) {
      window.resize(width, 700);
      window.apply_layout(width > 1000 ? "scene" : "views");
      QTest::qWait(50);
      QTRY_VERIFY2(words->width() >= words->sizeHint().width(), qPrintable(QString::number(scene.width())));
      QVERIFY(words->geometry().right() <= scene.width());
      QVERIFY(words->geometry().bottom() < 100);
    }
  }

  void a_layout_that_is_saved_comes_back_and_can_be_left() {
    gui::MainWindow window;
    window.show();
    QVERIFY(!is_seen(window, "echoes") && is_seen(window, "log") == is_seen(window, "script"));
    QVERIFY(window.apply_layout("script"));
    QVERIFY(is_seen(window, "script") && !is_seen(window, "properties"));
    window.save_layout("Mine");
    QVERIFY(window.layout_names().contains("Mine"));
    QVERIFY(window.apply_layout("scene"));
    QVERIFY(is_seen(window, "properties"));
    QVERIFY(window.apply_layout("Mine"));
    QVERIFY(!is_seen(window, "properties"));
    QVERIFY(!window.apply_layout("nobody's"));
  }

  void the_layout_of_the_last_time_is_there_at_the_next_start() {
    {
      gui::MainWindow window;
      window.use_layout("echoes");
      window.show();
      QVERIFY(is_seen(window, "echoes"));
      window.documents().ask_unsaved = [] { return gui::DocumentKeeper::Answer::discard; };
      QVERIFY(window.close());
    }
    gui::MainWindow again;
    again.show();
    QTest::qWait(20);
    QVERIFY(is_seen(again, "echoes"));
  }

  void echoes_go_beside_the_scene_and_can_stand_by_themselves() {
    gui::MainWindow window;
    window.use_layout("echoes");
    window.show();
    QVERIFY(window.documents().open_file(example("sar_r.toml")));
    auto* panel = window.findChild<gui::EchoPanel*>();
    QCOMPARE(panel->count(), 0);
    panel->findChild<QAbstractButton*>("echo_panel_raw")->click();
    window.findChild<QAction*>("simulation_compressed")->trigger();
    QCOMPARE(panel->count(), 2);
    gui::SimulationWindow* echoes = panel->current();
    QVERIFY(echoes->windowTitle().startsWith("Range compressed"));
    panel->findChild<QAbstractButton*>("echo_alone")->click();
    QVERIFY(echoes->isWindow() && echoes->isVisible());
    QCOMPARE(panel->count(), 1);
    panel->current()->close();
    QTRY_COMPARE(panel->count(), 0);
    QVERIFY(window.documents().make_new());
    QTRY_VERIFY(window.simulation_windows().windows().empty());
  }

  // Findings B7 and B8: a warning moves nothing, neither the echoes nor the scene.
  void a_warning_moves_nothing() {
    gui::MainWindow window;
    window.resize(1366, 700);
    window.use_layout("echoes");
    window.show();
    QVERIFY(window.documents().open_file(example("sar_r.toml")));
    gui::SimulationWindow* echoes = window.simulation_windows().open_new(scene::Processing::raw);
    QVERIFY(QTest::qWaitFor([&] { return echoes->complete(); }, 20'000));
    const QRect scene = window.scene().scene().geometry();
    const QRect plot = echoes->plot().geometry();
    scene::Radar radar = window.session().scene().radars.at(0);
    radar.prf_hz = 300.0;
    window.session().perform(
        scene::replace_object(window.session().scene(), {scene::ObjectKind::radar, 0}, radar, "Change PRF"));
    const auto* watch = window.findChild<gui::ProblemWatch*>();
    QTRY_VERIFY_WITH_TIMEOUT(
        std::ranges::any_of(watch->problems(),
                            [](const core::Problem& problem) { return problem.severity == core::Severity::warning; }),
        20'000);
    QTest::qWait(50);
    QCOMPARE(window.scene().scene().geometry(), scene);
    QCOMPARE(echoes->plot().geometry(), plot);
  }
};

const test::AddTest added("layouts_test", test::run_test<LayoutsTest>);

}  // namespace sarsim::layouts_test

#include "layouts_test.moc"

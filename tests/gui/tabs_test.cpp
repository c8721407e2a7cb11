// Several documents in one window.

#include <QAction>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QToolBar>
#include <QtTest>

#include <filesystem>
#include <memory>

#include "gui/echo/echo_panel.hpp"
#include "gui/echo/radar_view_window.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/document_tabs.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/live/live_panel.hpp"
#include "gui/objects/property_panel.hpp"
#include "gui/runs/run_panel.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/small_scene.hpp"
#include "gui/start/welcome_page.hpp"
#include "scene/edit/edit.hpp"
#include "scene/edit/recovery.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::tabs_test {

namespace {

constexpr int patience_ms = 20'000;

std::filesystem::path recovery_folder() {
  return std::filesystem::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) /
         "recovery";
}

std::size_t copies_for_recovery() {
  std::error_code none;
  const auto files = std::filesystem::directory_iterator(recovery_folder(), none);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

// A workbench on two files of its own folder, a.scr and b.scr; the second is at hand.
struct Bench {
  Bench() {
    std::filesystem::remove_all(recovery_folder());  // of this test alone
    QSettings().clear();
    write("a.scr", test::small_scene());
    scene::Scene other = test::small_scene();
    other.targets.emplace_back().position_m.x = 4000.0;
    write("b.scr", other);
    window = std::make_unique<gui::MainWindow>();
    window->documents().ask_unsaved = [this] {
      asked.append(window->documents().shown_name());
      return answer;
    };
    if (!open("a.scr") || !open("b.scr")) qFatal("not opened");
    window->resize(1200, 700);
    window->show();
    QCoreApplication::processEvents();
  }

  void write(const char* name, const scene::Scene& scene) const {
    QFile file(folder.filePath(name));
    file.open(QIODevice::WriteOnly);
    file.write(scene::write_script(scene).c_str());
  }
  bool open(const QString& name) const { return window->documents().open_file(folder.filePath(name)); }
  void trigger(const char* name) const { window->findChild<QAction*>(name)->trigger(); }
  void move_target(double x) const {
    scene::Target target = session().scene().targets[0];
    target.position_m.x = x;
    session().perform(scene::replace_object(session().scene(), test::target(0), target, "Move target"));
    session().end_run();
  }
  [[nodiscard]] gui::Session& session() const { return window->session(); }
  [[nodiscard]] gui::DocumentTabs& tabs() const { return *window->findChild<gui::DocumentTabs*>(); }
  [[nodiscard]] double x() const { return session().scene().targets.at(0).position_m.x; }
  [[nodiscard]] QStringList names() const {
    QStringList texts;
    for (int i = 0; i < tabs().count(); ++i) texts << tabs().tabText(i);
    return texts;
  }

  QTemporaryDir folder;
  std::unique_ptr<gui::MainWindow> window;
  gui::DocumentKeeper::Answer answer = gui::DocumentKeeper::Answer::cancel;
  QStringList asked;
};

}  // namespace

class TabsTest : public QObject {
  Q_OBJECT

 private slots:
  void what_is_opened_comes_beside_what_is_open() {
    const Bench bench;
    QCOMPARE(bench.names(), QStringList({"a.scr", "b.scr"}));
    QCOMPARE(bench.tabs().currentIndex(), 1);
    QVERIFY(bench.tabs().isVisible());
    QCOMPARE(bench.session().scene().targets.size(), std::size_t{4});
    QVERIFY(bench.window->windowTitle().contains("b.scr"));
    QCOMPARE(bench.tabs().tabToolTip(0), bench.folder.filePath("a.scr"));
    bench.trigger("file_new");
    QCOMPARE(bench.names(), QStringList({"a.scr", "b.scr", "New scene"}));
    QVERIFY(bench.asked.isEmpty());
    QVERIFY(bench.open("a.scr"));
    QCOMPARE(bench.tabs().count(), 3);
    QCOMPARE(bench.tabs().currentIndex(), 0);
  }

  void a_new_scene_in_which_nothing_was_done_gives_way() {
    gui::MainWindow window;
    window.show();
    QCOMPARE(window.session().document_count(), std::size_t{1});
    QVERIFY(!window.findChild<gui::DocumentTabs*>()->isVisible());
    QVERIFY(window.documents().open_file(SARSIM_SOURCE_DIR "/examples/sar_r.toml"));
    QCOMPARE(window.session().document_count(), std::size_t{1});
    QVERIFY(!window.findChild<gui::DocumentTabs*>()->isVisible());
    window.documents().make_new();
    window.session().perform(scene::add_object(window.session().scene(), scene::Target()));
    window.session().undo();
    QVERIFY(window.documents().open_file(SARSIM_SOURCE_DIR "/examples/search_radar.toml"));
    QCOMPARE(window.session().document_count(), std::size_t{3});  // What was undone can be made again.
  }

  void each_document_is_found_again_as_it_was_left() {
    const Bench bench;
    bench.trigger("file_previous");
    bench.move_target(1500.0);
    bench.session().select({test::target(0), test::platform(1)});
    bench.session().set_hidden({test::target(1)}, true);
    bench.session().set_time(0.25);
    picture::Camera camera = bench.window->scene().scene().camera();
    camera.azimuth_rad = 1.0;
    camera.pixels_per_m *= 3.0;
    bench.window->scene().scene().set_camera(camera);
    bench.window->scene().follow(test::platform(1));
    const picture::Camera left = bench.window->scene().scene().camera();
    QCOMPARE(bench.names(), QStringList({"a.scr*", "b.scr"}));

    bench.trigger("file_next");
    QVERIFY(bench.session().selection().empty() && bench.session().hidden().empty());
    QCOMPARE(bench.session().time_s(), 0.0);
    QVERIFY(!bench.window->isWindowModified());
    QVERIFY(!bench.window->scene().followed());
    QVERIFY(!bench.window->findChild<QAction*>("edit_undo")->isEnabled());
    bench.session().set_time(0.5);

    bench.trigger("file_next");  // after the last one comes the first
    QVERIFY(bench.session().selection() == std::set({test::target(0), test::platform(1)}));
    QVERIFY(bench.session().hidden() == std::set({test::target(1)}));
    QCOMPARE(bench.session().time_s(), 0.25);
    QVERIFY(bench.window->isWindowModified());
    QVERIFY(bench.window->scene().followed() == test::platform(1));
    const picture::Camera& again = bench.window->scene().scene().camera();
    QCOMPARE(again.azimuth_rad, left.azimuth_rad);
    QCOMPARE(again.pixels_per_m, left.pixels_per_m);
    QVERIFY(again.focus_world_m == left.focus_world_m);
    bench.trigger("edit_undo");
    QCOMPARE(bench.x(), 1000.0);
    QCOMPARE(bench.names(), QStringList({"a.scr", "b.scr"}));
  }

  void what_is_typed_but_not_entered_belongs_to_the_document_that_is_left() {
    const Bench bench;
    bench.session().select_only(test::target(0));
    auto* const field = bench.window->findChild<gui::PropertyPanel*>()->findChild<QLineEdit*>("field_position_m.x");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "2 km");
    QTest::mouseClick(&bench.tabs(), Qt::LeftButton, {}, bench.tabs().tabRect(0).center());
    QCOMPARE(bench.session().at_hand(), std::size_t{0});
    QCOMPARE(bench.x(), 1000.0);
    QCOMPARE(bench.session().document_at(1).scene().targets[0].position_m.x, 2000.0);
    QCOMPARE(bench.names(), QStringList({"a.scr", "b.scr*"}));
  }

  void closing_asks_where_something_would_be_lost() {
    Bench bench;
    bench.move_target(7.0);
    bench.trigger("file_close");
    QCOMPARE(bench.asked, QStringList({bench.folder.filePath("b.scr")}));
    QCOMPARE(bench.tabs().count(), 2);
    bench.answer = gui::DocumentKeeper::Answer::discard;
    bench.trigger("file_close");
    QCOMPARE(bench.names(), QStringList({"a.scr"}));
    QVERIFY(!bench.tabs().isVisible());
    QCOMPARE(bench.session().scene().targets.size(), std::size_t{3});
    bench.asked.clear();
    bench.trigger("file_close");
    QVERIFY(bench.asked.isEmpty());
    QVERIFY(bench.session().scene().targets.empty() && bench.session().document().path().empty());
    QVERIFY(bench.window->findChild<gui::WelcomePage*>()->isVisible());
  }

  void a_tab_is_closed_by_its_button_or_the_middle_one() {
    const Bench bench;
    QTest::mouseClick(&bench.tabs(), Qt::MiddleButton, {}, bench.tabs().tabRect(0).center());
    QCOMPARE(bench.names(), QStringList({"b.scr"}));
    QVERIFY(bench.open("a.scr"));
    emit bench.tabs().tabCloseRequested(0);
    QCOMPARE(bench.names(), QStringList({"a.scr"}));
  }

  void the_window_closes_after_a_question_for_each_unsaved_document() {
    Bench bench;
    bench.move_target(7.0);
    bench.session().turn_to(0);
    bench.move_target(8.0);
    bench.trigger("file_new");
    QVERIFY(!bench.window->close());
    QCOMPARE(bench.asked, QStringList({bench.folder.filePath("a.scr")}));
    bench.asked.clear();
    bench.answer = gui::DocumentKeeper::Answer::save;
    QVERIFY(bench.window->close());
    QCOMPARE(bench.asked, QStringList({bench.folder.filePath("a.scr"), bench.folder.filePath("b.scr")}));
    QCOMPARE(scene::Document::open(bench.folder.filePath("a.scr").toStdString()).scene().targets[0].position_m.x, 8.0);
    QCOMPARE(scene::Document::open(bench.folder.filePath("b.scr").toStdString()).scene().targets[0].position_m.x, 7.0);
  }

  void each_unsaved_document_has_its_copy_for_recovery() {
    const Bench bench;
    bench.move_target(7.0);
    bench.session().turn_to(0);
    bench.move_target(8.0);
    QVERIFY(bench.window->documents().keep_copies());
    QCOMPARE(copies_for_recovery(), std::size_t{2});
    bench.trigger("file_save");
    QCOMPARE(copies_for_recovery(), std::size_t{1});
    bench.session().turn_to(1);
    bench.trigger("edit_undo");
    QCOMPARE(copies_for_recovery(), std::size_t{0});
  }

  void a_disk_that_takes_no_copies_is_told_of_and_stops_nothing() {
    const Bench bench;
    const QString folder = QString::fromStdString(recovery_folder().string());
    QVERIFY(QDir().mkpath(QFileInfo(folder).path()));
    QFile obstacle(folder);  // a file where the folder should be
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    obstacle.close();
    bench.move_target(7.0);
    QVERIFY(!bench.window->documents().keep_copies());
    QVERIFY(bench.window->findChild<QPlainTextEdit*>("log_panel")->toPlainText().contains("No copy for recovery"));
    QVERIFY(obstacle.remove());
    QVERIFY(bench.window->documents().keep_copies());  // as soon as it can be
    QCOMPARE(copies_for_recovery(), std::size_t{1});
  }

  // The copy of a document that was left before it was due.
  void turning_away_does_not_put_the_copy_off() {
    const Bench bench;
    bench.move_target(7.0);
    bench.session().turn_to(0);
    QTRY_COMPARE_WITH_TIMEOUT(copies_for_recovery(), std::size_t{1}, patience_ms);
  }

  void echoes_go_out_of_sight_with_their_document_and_come_back() {
    const Bench bench;
    bench.window->apply_layout("views");
    gui::SimulationWindow* const beside = bench.window->simulation_windows().open_new(scene::Processing::raw);
    auto& panel = *bench.window->findChild<gui::EchoPanel*>();
    QCOMPARE(panel.count(), 1);
    bench.window->apply_layout("scene");
    gui::SimulationWindow* const alone = bench.window->simulation_windows().open_new(scene::Processing::raw);
    gui::RadarViewWindow* const view = alone->open_radar_view(picture::RadarView::spectrum);
    QVERIFY(alone->isWindow() && alone->isVisible() && view->isVisible());
    bench.window->apply_layout("views");
    const auto scene = alone->scene();

    bench.session().turn_to(0);
    QVERIFY(!beside->isVisible() && !alone->isVisible() && !view->isVisible());
    QCOMPARE(panel.count(), 0);
    QVERIFY(panel.current() == nullptr);
    QVERIFY(bench.window->simulation_windows().windows().empty());
    bench.move_target(500.0);
    QVERIFY(alone->scene() == scene);
    gui::SimulationWindow* const other = bench.window->simulation_windows().open_new(scene::Processing::raw);
    QVERIFY(panel.current() == other);

    bench.session().turn_to(1);
    QVERIFY(beside->isVisible() && alone->isVisible() && view->isVisible() && !other->isVisible());
    QVERIFY(panel.current() == beside);
    QVERIFY(alone->scene() == scene);
    QTRY_VERIFY_WITH_TIMEOUT(alone->complete() && beside->complete(), patience_ms);
    QCOMPARE(bench.window->simulation_windows().windows().size(), std::size_t{2});
  }

  void echoes_end_with_their_document_although_another_is_at_hand() {
    const Bench bench;
    const QPointer<gui::SimulationWindow> echoes = bench.window->simulation_windows().open_new(scene::Processing::raw);
    bench.session().turn_to(0);
    bench.session().close(1);
    QTRY_VERIFY_WITH_TIMEOUT(echoes.isNull(), patience_ms);
    QCOMPARE(bench.names(), QStringList({"a.scr"}));
  }

  void the_image_is_that_of_the_document_at_hand() {
    Bench bench;
    bench.window->apply_layout("views");
    auto& live = *bench.window->findChild<gui::LivePanel*>();
    QVERIFY(bench.window->documents().open_file(SARSIM_SOURCE_DIR "/examples/sar_r.toml"));
    QTRY_VERIFY_WITH_TIMEOUT(live.complete() && live.image() != nullptr, patience_ms);
    const auto image = live.image();
    QVERIFY(bench.window->documents().open_file(SARSIM_SOURCE_DIR "/examples/search_radar.toml"));
    QTRY_VERIFY_WITH_TIMEOUT(live.complete() && live.image() != image, patience_ms);
    QVERIFY(live.command().contains("search_radar.toml"));
    bench.trigger("file_previous");
    QTRY_VERIFY_WITH_TIMEOUT(live.complete(), patience_ms);
    QVERIFY(live.command().contains("sar_r.toml"));
    QVERIFY(live.image()->magnitude_v == image->magnitude_v);
  }

  void files_of_one_name_say_their_folders() {
    const Bench bench;
    QVERIFY(QDir(bench.folder.path()).mkdir("other & more"));
    bench.write("other & more/b.scr", test::small_scene());
    QVERIFY(bench.open("other & more/b.scr"));
    const QString folder = QDir(bench.folder.path()).dirName();
    QCOMPARE(bench.names(), QStringList({"a.scr", folder + "/b.scr", "other && more/b.scr"}));
  }

  void many_tabs_keep_their_names() {
    const Bench bench;
    for (int i = 0; i < 30; ++i) {
      const QString name = QString("a scene with a name %1.scr").arg(i);
      bench.write(qPrintable(name), test::small_scene());
      QVERIFY(bench.open(name));
    }
    QCoreApplication::processEvents();
    for (int i = 0; i < bench.tabs().count(); ++i)
      QVERIFY(bench.tabs().tabRect(i).width() > bench.tabs().fontMetrics().horizontalAdvance(bench.tabs().tabText(i)));
    QVERIFY(bench.window->width() <= 1200);
    QVERIFY(bench.tabs().rect().contains(bench.tabs().tabRect(bench.tabs().currentIndex()).center()));
  }

  void tabs_can_be_put_in_another_order() {
    const Bench bench;
    bench.tabs().moveTab(1, 0);
    QCOMPARE(bench.names(), QStringList({"b.scr", "a.scr"}));
    QCOMPARE(bench.session().at_hand(), std::size_t{0});
    QCOMPARE(bench.session().scene().targets.size(), std::size_t{4});
    bench.trigger("file_next");
    QCOMPARE(bench.session().scene().targets.size(), std::size_t{3});
    QCOMPARE(bench.tabs().currentIndex(), 1);
  }

  void a_layout_neither_hides_nor_shows_the_row() {
    const Bench bench;
    bench.window->save_layout("mine");
    bench.session().close(1);
    QVERIFY(!bench.tabs().isVisible());
    QVERIFY(bench.window->apply_layout("mine"));
    QVERIFY(!bench.tabs().isVisible());
    QVERIFY(bench.open("b.scr"));
    QVERIFY(bench.window->apply_layout("mine"));
    QVERIFY(bench.tabs().isVisible());
  }

  void the_log_tells_of_each_document_once() {
    Bench bench;
    auto& log = *bench.window->findChild<QPlainTextEdit*>("log_panel");
    QTest::qWait(300);
    const auto lines = [&] { return log.toPlainText().count('\n'); };
    const auto before = lines();
    for (int i = 0; i < 4; ++i) {
      bench.trigger("file_next");
      QTest::qWait(200);
    }
    QVERIFY2(lines() <= before + 4, qPrintable(log.toPlainText()));  // a.scr was left before it was looked at
    const auto then = lines();
    for (int i = 0; i < 4; ++i) {
      bench.trigger("file_next");
      QTest::qWait(100);
    }
    QCOMPARE(lines(), then);
  }

  // The same recording stands in both.
  void a_run_sets_nothing_in_another_document() {
    const Bench bench;
    auto& stored = *bench.window->findChild<gui::StoredSimulations*>();
    stored.run_panel().set_patience_s(1e9);
    const scene::Simulation recording = bench.session().scene().simulations.at(0);
    stored.run_into({scene::ObjectKind::simulation, 0}, bench.folder.filePath("a.bin").toStdString(), true);
    stored.run_panel().cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!stored.run_panel().running(), patience_ms);
    bench.session().turn_to(0);
    emit stored.run_panel().lsb_wanted(recording, 1e-3);
    QVERIFY(!bench.session().document().changed());
    bench.session().turn_to(1);
    emit stored.run_panel().lsb_wanted(recording, 1e-3);
    QCOMPARE(bench.session().scene().simulations.at(0).lsb_v, 1e-3);
  }
};

const test::AddTest added("tabs_test", test::run_test<TabsTest>);

}  // namespace sarsim::tabs_test

#include "tabs_test.moc"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QStatusTipEvent>
#include <QTemporaryDir>
#include <QtTest>

#include "gui/echo/simulation_window.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::main_window_test {

class MainWindowTest : public QObject {
  Q_OBJECT

 private:
  static void trigger(gui::MainWindow& window, const char* name) {
    auto* action = window.findChild<QAction*>(name);
    QVERIFY2(action != nullptr, name);
    action->trigger();
  }
  static QString example() { return QStringLiteral(SARSIM_SOURCE_DIR "/examples/sar_r.scr"); }

 private slots:
  void menus_carry_the_words_of_the_thesis() {
    gui::MainWindow window;
    for (const char* name : {"file_new",
                             "file_open",
                             "file_save",
                             "file_save_as",
                             "file_exit",
                             "new_target",
                             "new_platform",
                             "new_radar",
                             "new_surface",
                             "simulation_raw",
                             "simulation_compressed",
                             "simulation_stored",
                             "simulation_geometry",
                             "display_script",
                             "view_focus",
                             "view_axes",
                             "view_triad",
                             "view_lines",
                             "view_filled",
                             "help_contents",
                             "help_about"})
      QVERIFY2(window.findChild<QAction*>(name) != nullptr, name);
  }

  void an_example_opens_and_a_new_target_is_one_step_of_undo() {
    gui::MainWindow window;
    QVERIFY(window.documents().open_file(example()));
    const std::size_t targets = window.session().scene().targets.size();
    const std::string text = window.session().document().text();
    QCOMPARE(targets, std::size_t{24});
    trigger(window, "new_target");
    QCOMPARE(window.session().scene().targets.size(), targets + 1);
    QVERIFY(window.isWindowModified());
    trigger(window, "edit_undo");
    QCOMPARE(window.session().scene().targets.size(), targets);
    QCOMPARE(window.session().document().text(), text);
    QVERIFY(!window.isWindowModified());
  }

  void new_objects_take_what_is_typed_next() {
    gui::MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    trigger(window, "new_platform");
    QVERIFY(QApplication::focusWidget() != nullptr);
    QTest::keyClicks(QApplication::focusWidget(), "Ship");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QCOMPARE(window.session().scene().platforms.back().name, std::string("Ship"));
    trigger(window, "new_target");
    QTest::keyClicks(QApplication::focusWidget(), "3000");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QCOMPARE(window.session().scene().targets.back().position_m.x, 3000.0);
    QCOMPARE(window.session().scene().targets.back().platform, std::string("Ship"));
  }

  void a_target_that_is_dragged_moves_in_the_script_as_one_step() {
    gui::MainWindow window;
    QVERIFY(window.documents().open_file(example()));
    gui::SceneWidget& view = window.scene().scene();
    const scene::ObjectId id{scene::ObjectKind::target, 0};
    const core::Vec3 before = window.session().scene().targets[0].position_m;
    emit view.drag_started(id);
    for (int i = 1; i <= 5; ++i) emit view.dragged_to(id, {1.0 * i, 0.0, 2.0 * i});
    emit view.drag_ended();
    QCOMPARE(window.session().scene().targets[0].position_m.x, before.x + 5.0);
    QCOMPARE(window.session().scene().targets[0].position_m.z, before.z + 10.0);
    QVERIFY(scene::read_script(window.session().document().text(), "x.scr", {}).scene == window.session().scene());
    trigger(window, "edit_undo");
    QVERIFY(window.session().scene().targets[0].position_m == before);
  }

  void closing_asks_before_changes_are_lost() {
    gui::MainWindow window;
    QVERIFY(window.documents().open_file(example()));
    trigger(window, "new_target");
    int asked = 0;
    auto answer = gui::DocumentKeeper::Answer::cancel;
    window.documents().ask_unsaved = [&] { return ++asked, answer; };
    QVERIFY(!window.close());
    QCOMPARE(asked, 1);
    answer = gui::DocumentKeeper::Answer::discard;
    QVERIFY(window.close());
    QCOMPARE(asked, 2);
  }

  void a_saved_scene_reads_back_equal() {
    QTemporaryDir folder;
    gui::MainWindow window;
    QVERIFY(window.documents().open_file(example()));
    trigger(window, "new_target");
    const QString path = folder.filePath("saved.scr");
    QVERIFY(window.documents().save_to(path));
    QVERIFY(!window.isWindowModified());
    QVERIFY(scene::read_script_file(path.toStdString()).scene == window.session().scene());
  }

  void the_picture_of_a_simulation_is_the_stored_one_that_is_selected() {
    gui::MainWindow window;
    QVERIFY(window.documents().open_file(example()));
    const scene::Simulation stored = window.session().scene().simulations.at(0);
    window.session().select_only({scene::ObjectKind::simulation, 0});
    auto* shown = qobject_cast<gui::SimulationWindow*>(window.window_named("simulation"));
    QVERIFY(shown != nullptr);
    QCOMPARE(shown->simulation().range_start_m, stored.range_start_m);
    QCOMPARE(shown->simulation().time_start_s, stored.time_start_s);
    QCOMPARE(shown->simulation().time_end_s, stored.time_end_s);
    window.session().select({});
    auto* made = qobject_cast<gui::SimulationWindow*>(window.window_named("simulation"));
    QVERIFY(made != nullptr);
    QVERIFY(made->simulation().time_start_s != stored.time_start_s);
  }

  // Findings B9 and B19.
  void the_status_bar_counts_what_there_is_and_keeps_its_words_when_a_menu_was_open() {
    gui::MainWindow window;
    window.show();
    const auto* state = window.findChild<QLabel*>("scene_state");
    QVERIFY(window.documents().open_file(QStringLiteral(SARSIM_SOURCE_DIR "/examples/surface.scr")));
    QVERIFY2(state->text().contains("6 surfaces") && !state->text().contains("0 targets"), qPrintable(state->text()));
    QStatusTipEvent tip("What the menu says");
    QApplication::sendEvent(&window, &tip);
    QVERIFY(!state->isVisible());
    QStatusTipEvent gone((QString()));
    QApplication::sendEvent(&window, &gone);
    QVERIFY(state->isVisible() && state->text().contains("6 surfaces"));
  }

  // Finding B10.
  void keys_of_the_main_window_work_in_simulation_windows_and_viewers() {
    gui::MainWindow window;
    window.show();
    QVERIFY(window.documents().open_file(example()));
    auto* echoes = qobject_cast<gui::SimulationWindow*>(window.window_named("simulation"));
    QVERIFY(echoes != nullptr);
    echoes->show();
    QWidget* viewer = window.image_viewers().open_empty();
    for (QWidget* other : {static_cast<QWidget*>(echoes), viewer}) {
      trigger(window, "new_target");
      other->activateWindow();
      QVERIFY(QTest::qWaitForWindowActive(other->window()));
      QTest::keyClick(other, Qt::Key_Z, Qt::ControlModifier);
      QCOMPARE(window.session().scene().targets.size(), std::size_t{24});
    }
  }

  void every_window_can_be_made_into_a_picture() {
    gui::MainWindow window;
    QVERIFY(window.documents().open_file(example()));
    window.show();
    for (const QString& name : gui::MainWindow::window_names()) {
      QWidget* shown = window.window_named(name);
      QVERIFY2(shown != nullptr, qPrintable(name));
      QVERIFY2(!shown->grab().isNull(), qPrintable(name));
    }
  }
};

const test::AddTest added("main_window_test", test::run_test<MainWindowTest>);

}  // namespace sarsim::main_window_test

#include "main_window_test.moc"

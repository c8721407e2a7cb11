#include <QtTest>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>

#include <filesystem>

#include "gui/echo/echo_plot.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/runs/save_data_dialog.hpp"
#include "scene/edit/edit.hpp"

/// Simulation windows while their scene changes or is faulty, and the dialog that saves from them.
namespace sarsim::simulation_changes_test {

namespace {

constexpr int patience_ms = 20'000;

// A workbench with the example of chapter 3 and a window of its echoes, computed.
struct Bench {
  explicit Bench(scene::Processing processing = scene::Processing::raw) {
    QSettings().setValue("saving/folder", folder.path());
    main.documents().open_file(SARSIM_SOURCE_DIR "/examples/thesis_chapter3.scr");
    window = main.simulation_windows().open_new(processing);
    window->resize(900, 600);
    QTest::qWait(50);  // The resize counts before the picture does.
    computed = wait();
  }
  [[nodiscard]] bool wait() const {
    return QTest::qWaitFor([&] { return window->complete() && window->plot().matrix() != nullptr; }, patience_ms);
  }
  gui::Session& session() { return main.session(); }
  void rename_radar(const std::string& name) {
    scene::Radar radar = session().scene().radars[0];
    radar.name = name;
    session().perform(scene::replace_object(session().scene(), {scene::ObjectKind::radar, 0}, radar, "Rename radar"));
  }
  gui::SaveDataDialog& ask() const {
    window->findChild<QPushButton*>("echo_save_data")->click();
    return *window->findChild<gui::SaveDataDialog*>();
  }

  QTemporaryDir folder;
  gui::MainWindow main;
  gui::SimulationWindow* window = nullptr;
  bool computed = false;
};

void type(gui::SaveDataDialog& dialog, const char* field, const QString& text) {
  auto* const line = dialog.findChild<QLineEdit*>(field);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, text);
}

}  // namespace

class SimulationChangesTest : public QObject {
  Q_OBJECT

 private slots:
  // The peak, 3 m wide, stands between the samples that are nearest to the pixels.
  void range_compressed_data_show_the_target_of_chapter_3() {
    Bench bench(scene::Processing::matched_filter);
    QVERIFY(bench.computed);
    const double highest_v = bench.window->largest_v();
    QVERIFY2(std::abs(highest_v - 4.1e-8) < 0.05e-8, qPrintable(QString::number(highest_v)));
  }

  void a_window_follows_its_radar_to_another_name() {
    Bench bench;
    QVERIFY(bench.computed);
    bench.rename_radar("Search radar");
    QCOMPARE(bench.window->window_state().recording.radar, std::string("Search radar"));
    QVERIFY(bench.window->windowTitle().contains("Search radar"));
    QVERIFY(bench.wait());
    bench.session().undo();
    QCOMPARE(bench.window->window_state().recording.radar, std::string("Radar1"));
    QVERIFY(bench.wait());
  }

  void a_window_follows_its_radar_where_another_one_goes() {
    Bench bench;
    scene::Radar second;
    second.name = "Second";
    bench.session().perform(scene::add_object(bench.session().scene(), second));
    bench.session().perform(scene::remove_objects(bench.session().scene(), {{scene::ObjectKind::radar, 1}}));
    QCOMPARE(bench.window->window_state().recording.radar, std::string("Radar1"));
    bench.session().perform(scene::remove_objects(bench.session().scene(), {{scene::ObjectKind::radar, 0}}));
    QCOMPARE(bench.window->window_state().recording.radar, std::string("Radar1"));
    bench.session().undo();
    QVERIFY(bench.wait());
  }

  void no_progress_is_shown_of_what_has_failed() {
    Bench bench;
    QVERIFY(bench.computed);
    scene::Radar radar = bench.session().scene().radars[0];
    radar.pulse_width_s = -1.0;
    bench.session().perform(
        scene::replace_object(bench.session().scene(), {scene::ObjectKind::radar, 0}, radar, "Change radar"));
    QTRY_VERIFY_WITH_TIMEOUT(bench.window->findChild<QWidget*>("echo_problems")->isVisible(), patience_ms);
    QTest::qWait(600);  // The bar comes after 300 ms where it comes.
    QVERIFY(!bench.window->findChild<QProgressBar*>("echo_progress")->isVisible());
  }

  // --- Save Data --------------------------------------------------------------------------------------------------

  void the_dialog_makes_room_for_what_it_objects_to() {
    Bench bench;
    gui::SaveDataDialog& dialog = bench.ask();
    QTRY_VERIFY(dialog.isVisible());
    type(dialog, "save_rate", "nonsense");
    type(dialog, "save_file", "");
    QTest::keyClick(dialog.findChild<QLineEdit*>("save_file"), Qt::Key_Delete);
    QTRY_VERIFY(dialog.findChild<QWidget*>("save_problems")->isVisible());
    QTest::qWait(50);
    for (const char* name : {"save_rate", "save_lsb", "save_file"}) {
      auto* const line = dialog.findChild<QLineEdit*>(name);
      QVERIFY2(line->height() >= line->minimumSizeHint().height(), name);
    }
    auto* const problems = dialog.findChild<QWidget*>("save_problems");
    QVERIFY(problems->height() >= problems->heightForWidth(problems->width()));
  }

  void a_typed_lsb_comes_back_with_its_mode() {
    Bench bench;
    gui::SaveDataDialog& dialog = bench.ask();
    auto* const mode = dialog.findChild<QComboBox*>("save_lsb_from");
    mode->setCurrentIndex(2);
    type(dialog, "save_lsb", "0.5 mV");
    QVERIFY(dialog.choice().has_value());
    for (const int other : {0, 1}) {
      mode->setCurrentIndex(other);
      mode->setCurrentIndex(2);
      QVERIFY(dialog.choice().has_value());
      QCOMPARE(dialog.choice()->recording.lsb_v, 0.5e-3);
    }
    auto* const save = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
    QTRY_VERIFY_WITH_TIMEOUT(save->isEnabled(), patience_ms);
  }

  void an_emptied_lsb_is_told() {
    Bench bench;
    gui::SaveDataDialog& dialog = bench.ask();
    dialog.findChild<QComboBox*>("save_lsb_from")->setCurrentIndex(2);
    type(dialog, "save_lsb", "2 mV");
    auto* const line = dialog.findChild<QLineEdit*>("save_lsb");
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Delete);
    QCOMPARE(line->text(), QString());
    QVERIFY(!dialog.choice().has_value());
  }
};

const test::AddTest added("simulation_changes_test", test::run_test<SimulationChangesTest>);

}  // namespace sarsim::simulation_changes_test

#include "simulation_changes_test.moc"

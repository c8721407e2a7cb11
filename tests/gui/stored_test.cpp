#include <QApplication>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <fstream>

#include "gui/common/problem_line.hpp"
#include "gui/gui_test.hpp"
#include "gui/runs/run_panel.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "raster/format/sinks.hpp"
#include "scene/check/check.hpp"
#include "simulate/run/run.hpp"
#include "small_scene.hpp"
#include "text_files.hpp"

namespace sarsim::stored_test {

namespace {

using test::file_text;

constexpr int patience_ms = 60'000;
constexpr scene::ObjectId first{scene::ObjectKind::simulation, 0};

// Radar1 looks at two targets for some pulses.
scene::Scene recorded_scene() {
  scene::Scene scene = test::small_scene();
  scene.simulations[0].range_end_m = 4000.0;
  scene.simulations[0].time_end_s = 0.049;
  scene.simulations[0].file = "echo.bin";
  return scene;
}

// What `sarsim run` writes for a simulation.
std::string run_by_hand(const scene::Scene& scene, const std::filesystem::path& path) {
  const simulate::Plan plan = simulate::make_plan(scene, 0, nullptr, simulate::Engine::automatic);
  const std::unique_ptr<raster::Sink> sink =
      raster::make_sink(path, simulate::product_of(plan, {}), {plan.acquisition.simulation.format, true, false, false});
  simulate::run(plan, simulate::resolved_lsb_v(plan, {}), *sink, {});
  return file_text(path);
}

struct Bench {
  explicit Bench(const scene::Scene& scene) {
    test::open(session, scene);
    folder_path = folder.path().toStdString();
    stored.ask_folder = [this]() -> std::optional<std::filesystem::path> {
      ++folder_questions;
      return folder_path;
    };
    stored.ask_replace = [this](const std::filesystem::path&) {
      ++replace_questions;
      return may_replace;
    };
    stored.resize(900, 600);
    stored.show();
    table = stored.findChild<QTableWidget*>("stored_table");
    ended = std::make_unique<QSignalSpy>(&stored.run_panel(), &gui::RunPanel::ended);
  }
  void click(const char* name) const { stored.findChild<QPushButton*>(name)->click(); }
  [[nodiscard]] QString label(const char* name) const { return stored.findChild<QLabel*>(name)->text(); }
  [[nodiscard]] gui::JobEnd wait_for_end() const {
    if (ended->isEmpty() && !ended->wait(patience_ms)) qFatal("the run did not end");
    return ended->last()[0].value<gui::JobEnd>();
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_path), {}));
  }

  QTemporaryDir folder;
  std::filesystem::path folder_path;
  gui::Session session;
  gui::StoredSimulations stored{session};
  QTableWidget* table = nullptr;
  std::unique_ptr<QSignalSpy> ended;
  int folder_questions = 0;
  int replace_questions = 0;
  bool may_replace = false;
};

}  // namespace

class StoredTest : public QObject {
  Q_OBJECT

 private slots:
  void simulations_are_listed_with_what_they_record() {
    scene::Scene scene = recorded_scene();
    scene.simulations.push_back(scene.simulations[0]);
    scene.simulations[1].processing = scene::Processing::matched_filter;
    scene.simulations[1].lsb_v = 2e-3;
    scene.simulations[1].file = "compressed.bin";
    const Bench bench(scene);
    QCOMPARE(bench.table->rowCount(), 2);
    QStringList first_line;
    QStringList second_line;
    for (int column = 0; column < bench.table->columnCount(); ++column) {
      first_line += bench.table->item(0, column)->text();
      second_line += bench.table->item(1, column)->text();
    }
    QCOMPARE(first_line,
             QStringList({"Raw", "Radar1", "0 m to 4 km", "0 s to 49 ms", "4 MHz", "8", "estimated", "echo.bin"}));
    QCOMPARE(second_line[0], QString("Compressed"));
    QCOMPARE(second_line[6], QString("2 mV"));
  }

  void show_edit_and_delete_work_on_the_chosen_line() {
    Bench bench(recorded_scene());
    QVERIFY(!bench.stored.findChild<QPushButton*>("stored_show")->isEnabled());
    bench.stored.choose(first);
    scene::ObjectId shown{};
    connect(&bench.stored, &gui::StoredSimulations::show_requested, this, [&](scene::ObjectId id) { shown = id; });
    bench.click("stored_show");
    QVERIFY(shown == first);
    bench.click("stored_edit");
    QVERIFY(bench.session.current() == first);
    bench.click("stored_delete");
    QVERIFY(bench.session.scene().simulations.empty());
    QCOMPARE(bench.table->rowCount(), 0);
    bench.session.undo();
    QCOMPARE(bench.session.scene().simulations, recorded_scene().simulations);
    QCOMPARE(bench.table->rowCount(), 1);
  }

  void a_new_simulation_suits_its_radar_and_scene() {
    Bench bench(recorded_scene());
    bench.click("stored_new");
    QCOMPARE(bench.session.scene().simulations.size(), std::size_t{2});
    const scene::Simulation& made = bench.session.scene().simulations[1];
    QCOMPARE(made.radar, std::string("Radar1"));
    QCOMPARE(made.file, std::string("sim2.bin"));
    // Targets stand at 1, 2 and 3 km; the pulse is 5 us long, 0.75 km.
    QVERIFY(made.range_start_m <= 1000.0 && made.range_end_m >= 3000.0 + 1500.0);
    QVERIFY(made.range_end_m < 6000.0);
    QVERIFY(made.sample_rate_hz > 0.0);
    QVERIFY(bench.stored.chosen() == (scene::ObjectId{scene::ObjectKind::simulation, 1}));
    QVERIFY(!core::has_errors(scene::check(bench.session.scene())));
  }

  void a_run_writes_the_file_of_the_command_line_and_reports() {
    Bench bench(recorded_scene());
    bench.stored.choose(first);
    bench.click("stored_run");
    QVERIFY(bench.stored.run_panel().isVisible());
    QCOMPARE(bench.wait_for_end(), gui::JobEnd::done);
    QCOMPARE(bench.folder_questions, 1);
    const std::string expected = run_by_hand(bench.session.scene(), bench.folder_path / "by_hand.bin");
    QVERIFY(expected.size() > 1000);
    QCOMPARE(file_text(bench.folder_path / "echo.bin"), expected);
    const QString report = bench.label("run_report");
    QVERIFY(report.contains("echo.bin") && report.contains("50 x 107") && report.contains("saturated"));
    QVERIFY(!bench.stored.findChild<QPushButton*>("run_use_lsb")->isVisible());
  }

  void a_saved_scene_is_run_into_its_folder_and_asks_before_replacing() {
    Bench bench(recorded_scene());
    bench.session.save(bench.folder_path / "scene.scr");
    std::ofstream(bench.folder_path / "echo.bin") << "precious";
    bench.stored.choose(first);
    bench.click("stored_run");
    QCOMPARE(bench.replace_questions, 1);
    QVERIFY(!bench.stored.run_panel().running());
    QCOMPARE(file_text(bench.folder_path / "echo.bin"), std::string("precious"));
    bench.may_replace = true;
    bench.click("stored_run");
    QCOMPARE(bench.wait_for_end(), gui::JobEnd::done);
    QCOMPARE(bench.folder_questions, 0);
    QVERIFY(file_text(bench.folder_path / "echo.bin") != "precious");
  }

  void a_long_run_gives_its_estimate_first_and_cancelling_leaves_nothing() {
    Bench bench(test::slow_scene());
    bench.stored.run_panel().set_patience_s(0.0);
    bench.stored.choose(first);
    bench.click("stored_run");
    auto* start = bench.stored.findChild<QPushButton*>("run_start");
    QTRY_VERIFY_WITH_TIMEOUT(start->isVisible(), patience_ms);
    QVERIFY(bench.label("run_report").contains("of memory"));
    QCOMPARE(bench.files(), std::size_t{0});
    start->click();
    auto* bar = bench.stored.findChild<QProgressBar*>("run_progress");
    QTRY_VERIFY_WITH_TIMEOUT(bar->value() > 0 && bench.label("run_state").contains("left"), patience_ms);
    QElapsedTimer timer;
    timer.start();
    bench.click("run_cancel");
    QCOMPARE(bench.wait_for_end(), gui::JobEnd::cancelled);
    qInfo() << "cancelled within" << timer.elapsed() << "ms";
    QCOMPARE(bench.files(), std::size_t{0});
    QVERIFY(bench.label("run_state").contains("no file was written"));
    QVERIFY(bench.stored.findChild<QPushButton*>("stored_run")->isEnabled());
  }

  void a_run_that_waits_for_start_can_be_cancelled() {
    Bench bench(recorded_scene());
    bench.stored.run_panel().set_patience_s(-1.0);
    bench.stored.choose(first);
    bench.click("stored_run");
    QTRY_VERIFY_WITH_TIMEOUT(bench.stored.findChild<QPushButton*>("run_start")->isVisible(), patience_ms);
    bench.click("run_cancel");
    QCOMPARE(bench.wait_for_end(), gui::JobEnd::cancelled);
    QCOMPARE(bench.files(), std::size_t{0});
  }

  void closing_ends_a_run_and_leaves_nothing() {
    const QTemporaryDir folder;
    {
      gui::Session session;
      test::open(session, test::slow_scene());
      gui::StoredSimulations stored(session);
      stored.run_panel().set_patience_s(1e9);
      stored.run_into(first, folder.filePath("slow.bin").toStdString(), false);
      const auto* bar = stored.findChild<QProgressBar*>("run_progress");
      QTRY_VERIFY_WITH_TIMEOUT(bar->value() > 0, patience_ms);
    }
    QVERIFY(std::filesystem::is_empty(folder.path().toStdString()));
  }

  void clipped_samples_are_warned_of_and_the_best_lsb_is_taken_over() {
    scene::Scene scene = recorded_scene();
    scene.simulations[0].lsb_v = 1e-12;
    Bench bench(scene);
    bench.stored.choose(first);
    bench.click("stored_run");
    QCOMPARE(bench.wait_for_end(), gui::JobEnd::done);
    QVERIFY(bench.stored.findChild<gui::ProblemLine*>("run_problems")->text().contains("clipped"));
    bench.click("run_use_lsb");
    const double lsb_v = bench.session.scene().simulations[0].lsb_v;
    QVERIFY(lsb_v > 1e-12);
    bench.may_replace = true;
    bench.ended->clear();
    bench.click("stored_run");
    QCOMPARE(bench.wait_for_end(), gui::JobEnd::done);
    QVERIFY(bench.label("run_report").contains("0 % of the samples saturated"));
    bench.session.undo();
    QCOMPARE(bench.session.scene().simulations[0].lsb_v, 1e-12);
  }

  void errors_are_told_in_words() {
    scene::Scene scene = recorded_scene();
    scene.simulations[0].range_end_m = 0.0;
    Bench bench(scene);
    bench.stored.choose(first);
    bench.click("stored_run");
    QCOMPARE(bench.wait_for_end(), gui::JobEnd::failed);
    auto* problems = bench.stored.findChild<gui::ProblemLine*>("run_problems");
    QVERIFY(problems->isVisible() && problems->text().startsWith("Error: "));
    QCOMPARE(bench.files(), std::size_t{0});

    Bench without_folder(recorded_scene());
    without_folder.folder_path = "/no/such/folder";
    without_folder.stored.choose(first);
    without_folder.click("stored_run");
    QCOMPARE(without_folder.wait_for_end(), gui::JobEnd::failed);
    QVERIFY(without_folder.stored.findChild<gui::ProblemLine*>("run_problems")->text().contains("/no/such/folder"));
  }

  void files_of_one_name_are_numbered_as_the_command_line_does() {
    scene::Scene scene = recorded_scene();
    scene.simulations.push_back(scene.simulations[0]);
    scene.simulations[1].file = "somewhere\\echo.bin";
    scene.simulations.push_back(scene.simulations[0]);
    scene.simulations[2].file = "folder/";
    QCOMPARE(gui::run_file(scene, 0, "out"), std::filesystem::path("out/echo.bin"));
    QCOMPARE(gui::run_file(scene, 1, "out"), std::filesystem::path("out/echo-2.bin"));
    QVERIFY(gui::run_file(scene, 2, "out").empty());
  }
};

const test::AddTest added("stored_test", test::run_test<StoredTest>);

}  // namespace sarsim::stored_test

#include "stored_test.moc"

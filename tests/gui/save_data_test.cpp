#include <QtTest>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>

#include <filesystem>
#include <fstream>

#include "gui/echo/data_saver.hpp"
#include "gui/echo/echo_plot.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/runs/save_data_dialog.hpp"
#include "gui/runs/save_queue.hpp"
#include "raster/format/sinks.hpp"
#include "scene/edit/edit.hpp"
#include "scene/script/writer.hpp"
#include "simulate/run/run.hpp"
#include "small_scene.hpp"
#include "text_files.hpp"

namespace sarsim::save_data_test {

namespace {

using test::file_text;

namespace fs = std::filesystem;

constexpr int patience_ms = 60'000;

// What `sarsim run` writes for a stored simulation.
std::string run_by_hand(const scene::Scene& scene, std::size_t index, const fs::path& path,
                        raster::SinkOptions options = {.replace = true}) {
  const simulate::Plan plan = simulate::make_plan(scene, index, nullptr, simulate::Engine::automatic);
  options.format = plan.acquisition.simulation.format;
  const bool with_script = plan.acquisition.simulation.format == scene::FileFormat::hdf5;
  const std::unique_ptr<raster::Sink> sink = raster::make_sink(
      path, simulate::product_of(plan, with_script ? scene::write_script(scene) : std::string()), options);
  simulate::run(plan, simulate::resolved_lsb_v(plan, {}), *sink, {});
  return file_text(path);
}

// A recording that takes minutes.
gui::RunRequest slow_request(const fs::path& file) { return {test::slow_scene(), 0, file, true}; }

gui::RunRequest quick_request(const fs::path& file, double lsb_v = 0.0) {
  scene::Scene scene = test::small_scene();
  scene.simulations[0].range_end_m = 4000.0;
  scene.simulations[0].time_end_s = 0.009;
  scene.simulations[0].lsb_v = lsb_v;
  return {scene, 0, file, false};
}

// A window of raw echoes of the example of chapter 3, and a folder to save into.
struct Bench {
  Bench() {
    QSettings().setValue("saving/folder", folder.path());
    main.session().take(scene::Document::from_text(file_text(SARSIM_SOURCE_DIR "/examples/thesis_chapter3.scr")));
    window = main.simulation_windows().open_new(scene::Processing::raw);
    window->resize(900, 600);
    QTest::qWait(50);
    shown = QTest::qWaitFor([&] { return window->complete(); }, patience_ms);
    window->go_to({2900.0, 3900.0, 0.0, 0.01});
    shown = shown && QTest::qWaitFor([&] { return window->complete(); }, patience_ms);
  }
  gui::SaveDataDialog* ask() {
    window->findChild<QPushButton*>("echo_save_data")->click();
    auto* const dialog = window->findChild<gui::SaveDataDialog*>();
    dialog->ask_replace = [this](const fs::path&) {
      ++questions;
      return may_replace;
    };
    return dialog;
  }
  static void type(gui::SaveDataDialog& dialog, const char* field, const QString& text) {
    auto* const line = dialog.findChild<QLineEdit*>(field);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
  }
  static void choose(gui::SaveDataDialog& dialog, const char* field, int index) {
    dialog.findChild<QComboBox*>(field)->setCurrentIndex(index);
  }
  gui::SaveState wait_for(std::size_t run) {
    gui::SaveQueue& queue = main.saver().queue();
    const auto ended = [&] {
      return queue.size() > run && queue.state(run) != gui::SaveState::running &&
             queue.state(run) != gui::SaveState::waiting;
    };
    if (!QTest::qWaitFor(ended, patience_ms)) qFatal("the run did not end");
    return queue.state(run);
  }
  [[nodiscard]] fs::path in_folder(const char* name) const { return fs::path(folder.path().toStdString()) / name; }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path().toStdString()), {}));
  }

  QTemporaryDir folder;
  gui::MainWindow main;
  gui::SimulationWindow* window = nullptr;
  bool shown = false;
  bool may_replace = false;
  int questions = 0;
};

bool wait_for_end(gui::SaveQueue& queue) {
  return QTest::qWaitFor([&] { return !queue.busy(); }, patience_ms);
}

}  // namespace

class SaveDataTest : public QObject {
  Q_OBJECT

 private slots:
  void the_dialog_proposes_what_the_window_shows() {
    Bench bench;
    QVERIFY(bench.shown);
    gui::SaveDataDialog& dialog = *bench.ask();
    const auto choice = dialog.choice();
    QVERIFY(choice.has_value());
    QCOMPARE(choice->recording.range_start_m, 2900.0);
    QCOMPARE(choice->recording.range_end_m, 3900.0);
    QCOMPARE(choice->recording.bits, 8);
    QCOMPARE(choice->file, bench.in_folder("sim1.bin"));
    QCOMPARE(dialog.findChild<QLineEdit*>("save_multiple")->text(), QString("1"));
    // 1.03 times the largest magnitude of the picture over 127.
    QVERIFY(std::abs(dialog.simulation().lsb_v - 1.03 * bench.window->largest_v() / 127.0) < 1e-20);
    QVERIFY(bench.window->largest_v() > 0.0);
  }

  void size_and_time_are_told_before() {
    Bench bench;
    gui::SaveDataDialog& dialog = *bench.ask();
    QSignalSpy told(&dialog, &gui::SaveDataDialog::forecast_ready);
    Bench::type(dialog, "save_rate", "100 MHz");
    QVERIFY(told.wait(patience_ms));
    // 2 x 100 MHz x 1000 m / c = 667 samples.
    const QString text = dialog.findChild<QLabel*>("save_estimate")->text();
    QVERIFY2(
        text.contains("667 samples") && (text.contains("about") || text.contains("below 1 ms")) && text.contains("LSB"),
        qPrintable(text));
  }

  void rate_and_multiple_follow_each_other() {
    Bench bench;
    gui::SaveDataDialog& dialog = *bench.ask();
    const double bandwidth_hz = bench.window->bandwidth_hz();
    Bench::type(dialog, "save_multiple", "0.5");
    QCOMPARE(dialog.choice()->recording.sample_rate_hz, 0.5 * bandwidth_hz);
    Bench::type(dialog, "save_rate", "100 MHz");
    QCOMPARE(dialog.choice()->recording.sample_rate_hz, 100e6);
    QCOMPARE(dialog.findChild<QLineEdit*>("save_multiple")->text(), QString::number(100e6 / bandwidth_hz, 'g', 10));
    Bench::type(dialog, "save_multiple", "0");
    QVERIFY(!dialog.choice().has_value());
    QVERIFY(dialog.findChild<QWidget*>("save_problems")->isVisibleTo(&dialog));
  }

  void the_extension_follows_the_format() {
    Bench bench;
    gui::SaveDataDialog& dialog = *bench.ask();
    const QStringList expected{"sim1.bin", "sim1.asc", "sim1.csv", "sim1.brk", "sim1.npy", "sim1.h5"};
    for (int i = 0; i < expected.size(); ++i) {
      Bench::choose(dialog, "save_format", i);
      QCOMPARE(QString::fromStdString(dialog.simulation().file), expected[i]);
    }
    dialog.ask_file = [&](const QString&) { return bench.folder.filePath("other.csv"); };
    dialog.findChild<QPushButton*>("save_select")->click();
    QCOMPARE(dialog.choice()->recording.format, scene::FileFormat::csv);
  }

  void what_cannot_be_written_is_told_and_not_accepted() {
    Bench bench;
    gui::SaveDataDialog& dialog = *bench.ask();
    Bench::type(dialog, "save_file", "/no/such/folder/x.bin");
    QVERIFY(!dialog.choice().has_value());
    dialog.accept();
    QVERIFY(dialog.isVisible());
    Bench::choose(dialog, "save_lsb_from", 2);
    Bench::type(dialog, "save_lsb", "heavy");
    Bench::type(dialog, "save_file", "x.bin");
    QVERIFY(!dialog.choice().has_value());
    Bench::type(dialog, "save_lsb", "2");
    QCOMPARE(dialog.choice()->recording.lsb_v, 2e-3);
  }

  void the_saved_file_is_that_of_the_stored_simulation() {
    for (const int format : {0, 1, 2, 3, 4, 5}) {
      Bench bench;
      gui::SaveDataDialog& dialog = *bench.ask();
      Bench::choose(dialog, "save_format", format);
      Bench::choose(dialog, "save_target", 2);
      const fs::path file = dialog.choice()->file;
      dialog.accept();
      QCOMPARE(bench.wait_for(0), gui::SaveState::done);
      const scene::Scene& scene = bench.main.session().scene();
      QCOMPARE(QString::fromStdString(scene.simulations.back().file), QString::fromStdString(file.filename().string()));
      const scene::Scene again = scene::Document::from_text(bench.main.session().document().text()).scene();
      QVERIFY(again == scene);
      QVERIFY(!file_text(file).empty());
      QVERIFY2(file_text(file) == run_by_hand(again, again.simulations.size() - 1, bench.in_folder("by_hand")),
               qPrintable(QString::fromStdString(file.string())));
    }
  }

  void the_list_of_samples_follows_the_format() {
    Bench bench;
    gui::SaveDataDialog& dialog = *bench.ask();
    auto* const samples = dialog.findChild<QComboBox*>("save_samples");
    QVERIFY(!samples->isEnabled());  // BINARY holds counts.
    QCOMPARE(samples->currentIndex(), static_cast<int>(workflow::SampleChoice::counts));
    Bench::choose(dialog, "save_format", 4);  // NPY
    QVERIFY(samples->isEnabled());
    QCOMPARE(samples->currentIndex(), static_cast<int>(workflow::SampleChoice::volts));
    Bench::choose(dialog, "save_samples", static_cast<int>(workflow::SampleChoice::doubles));
    Bench::choose(dialog, "save_format", 1);
    QCOMPARE(samples->currentIndex(), static_cast<int>(workflow::SampleChoice::counts));
    Bench::choose(dialog, "save_format", 5);  // HDF5: the choice is kept.
    QCOMPARE(samples->currentIndex(), static_cast<int>(workflow::SampleChoice::doubles));
    QVERIFY(dialog.choice()->samples == workflow::SampleChoice::doubles);
  }

  void counts_and_doubles_are_saved_as_sarsim_run_writes_them() {
    for (const auto samples : {workflow::SampleChoice::counts, workflow::SampleChoice::doubles}) {
      Bench bench;
      gui::SaveDataDialog& dialog = *bench.ask();
      Bench::choose(dialog, "save_format", 4);
      Bench::choose(dialog, "save_target", 2);
      Bench::choose(dialog, "save_samples", static_cast<int>(samples));
      const fs::path file = dialog.choice()->file;
      dialog.accept();
      QCOMPARE(bench.wait_for(0), gui::SaveState::done);
      const scene::Scene& scene = bench.main.session().scene();
      const raster::SinkOptions options{.format = scene::FileFormat::npy,
                                        .replace = true,
                                        .counts = samples == workflow::SampleChoice::counts,
                                        .doubles = samples == workflow::SampleChoice::doubles};
      QVERIFY(file_text(file) == run_by_hand(scene, scene.simulations.size() - 1, bench.in_folder("by_hand"), options));
    }
  }

  void disk_only_leaves_the_script_and_script_only_the_disk() {
    Bench bench;
    const std::string text = bench.main.session().document().text();
    bench.ask()->accept();
    QCOMPARE(bench.wait_for(0), gui::SaveState::done);
    QVERIFY(bench.main.session().document().text() == text);
    QCOMPARE(bench.files(), std::size_t{1});
    QTRY_VERIFY(bench.window->findChild<gui::SaveDataDialog*>() == nullptr);
    const std::size_t stored = bench.main.session().scene().simulations.size();
    gui::SaveDataDialog& dialog = *bench.ask();
    Bench::choose(dialog, "save_target", 1);
    dialog.accept();
    QCOMPARE(bench.main.session().scene().simulations.size(), stored + 1);
    QCOMPARE(bench.main.saver().queue().size(), std::size_t{1});
    QCOMPARE(bench.files(), std::size_t{1});
  }

  void an_existing_file_is_replaced_only_after_a_question() {
    Bench bench;
    std::ofstream(bench.in_folder("old.bin")) << "old";
    gui::SaveDataDialog& dialog = *bench.ask();
    Bench::type(dialog, "save_file", "old.bin");
    dialog.accept();
    QCOMPARE(bench.questions, 1);
    QVERIFY(dialog.isVisible());
    QCOMPARE(file_text(bench.in_folder("old.bin")), std::string("old"));
    bench.may_replace = true;
    dialog.accept();
    QCOMPARE(bench.wait_for(0), gui::SaveState::done);
    QVERIFY(file_text(bench.in_folder("old.bin")) != "old");
  }

  void cancel_leaves_nothing_and_keeps_what_was_there() {
    const QTemporaryDir folder;
    const fs::path path = folder.path().toStdString();
    std::ofstream(path / "old.bin") << "old";
    gui::SaveQueue queue;
    queue.add(slow_request(path / "old.bin"));
    queue.add(slow_request(path / "new.bin"));
    queue.add(quick_request(path / "third.bin"));
    QVERIFY(queue.will_write(path / "new.bin"));
    QTest::qWait(300);
    QCOMPARE(queue.state(0), gui::SaveState::running);
    QCOMPARE(queue.state(1), gui::SaveState::waiting);
    queue.cancel(1);
    queue.cancel(0);
    QVERIFY(wait_for_end(queue));
    QCOMPARE(queue.state(0), gui::SaveState::cancelled);
    QCOMPARE(queue.state(1), gui::SaveState::cancelled);
    QCOMPARE(queue.state(2), gui::SaveState::done);
    QVERIFY(!queue.will_write(path / "new.bin"));
    QCOMPARE(file_text(path / "old.bin"), std::string("old"));
    QCOMPARE(std::distance(fs::directory_iterator(path), {}), std::ptrdiff_t{2});
  }

  void a_destroyed_queue_leaves_nothing() {
    const QTemporaryDir folder;
    {
      gui::SaveQueue queue;
      queue.add(slow_request(fs::path(folder.path().toStdString()) / "new.bin"));
      QTest::qWait(200);
    }
    QVERIFY(fs::is_empty(folder.path().toStdString()));
  }

  void clipped_samples_are_told_and_saved_again_with_the_best_lsb() {
    const QTemporaryDir folder;
    const fs::path file = fs::path(folder.path().toStdString()) / "echo.bin";
    gui::SaveQueue queue;
    queue.add(quick_request(file, 1e-15));
    QVERIFY(wait_for_end(queue));
    QVERIFY(queue.report(0).contains("saturated"));
    auto* const again = queue.findChild<QPushButton*>("saving_again");
    QVERIFY(again->isVisibleTo(&queue));
    QVERIFY(queue.findChild<QWidget*>("saving_problems")->isVisibleTo(&queue));
    const std::string clipped = file_text(file);
    again->click();
    QCOMPARE(queue.size(), std::size_t{2});
    QVERIFY(wait_for_end(queue));
    QCOMPARE(queue.state(1), gui::SaveState::done);
    QVERIFY2(queue.report(1).contains("0 % of the samples saturated"), qPrintable(queue.report(1)));
    QVERIFY(file_text(file) != clipped);
    queue.findChild<QPushButton*>("saving_clear")->click();
    QCOMPARE(queue.size(), std::size_t{0});
  }

  void a_run_that_fails_says_why() {
    const QTemporaryDir folder;
    gui::SaveQueue queue;
    queue.add(quick_request(fs::path(folder.path().toStdString()) / "none" / "echo.bin"));
    QVERIFY(wait_for_end(queue));
    QCOMPARE(queue.state(0), gui::SaveState::failed);
    QVERIFY2(queue.report(0).contains("echo.bin"), qPrintable(queue.report(0)));
  }

  void closing_asks_while_data_are_being_saved() {
    Bench bench;
    int questions = 0;
    bool yes = false;
    bench.main.ask_end_work = [&](const QStringList& work) {
      ++questions;
      return yes && work.size() == 1;
    };
    bench.main.show();
    bench.main.saver().queue().add(slow_request(bench.in_folder("slow.bin")));
    QVERIFY(!bench.main.close());
    QVERIFY(bench.main.saver().queue().busy());
    yes = true;
    QVERIFY(bench.main.close());
    QCOMPARE(questions, 2);
    QVERIFY(wait_for_end(bench.main.saver().queue()));
    bench.main.show();
    QVERIFY(bench.main.close());
    QCOMPARE(questions, 2);
    QCOMPARE(bench.files(), std::size_t{0});
  }
};

const test::AddTest added("save_data_test", test::run_test<SaveDataTest>);

}  // namespace sarsim::save_data_test

#include "save_data_test.moc"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <fstream>
#include <map>
#include <sstream>

#include "core/text/number_text.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/gui_test.hpp"
#include "gui/scene/geometry_model.hpp"
#include "gui/scene/geometry_view.hpp"
#include "gui/scene/geometry_window.hpp"
#include "small_scene.hpp"
#include "support/processor_time.hpp"
#include "text_files.hpp"

namespace sarsim::geometry_test {

namespace {

using test::file_text;

constexpr int patience_ms = 20'000;

// A ship on a bent path that turns; the radar steps its carrier.
scene::Scene moving_scene() {
  scene::Scene scene = test::small_scene();
  scene::Platform& ship = scene.platforms[1];
  ship.path = scene::Platform::Path::trajectory;
  ship.trajectory_m.part[0] = {core::Interpolation::cubic, {{0.0, 0.0}, {1.0, 100.0}, {2.0, -50.0}}};
  ship.trajectory_m.part[1] = {core::Interpolation::linear, {{0.0, 500.0}, {2.0, 900.0}}};
  ship.trajectory_m.part[2] = {core::Interpolation::linear, {{0.0, 30.0}}};
  ship.rotation_rate[2] = core::Angle::from_deg(12.0);
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.targets[0].traits.edit().position_stddev_m = {0.1, 0.1, 0.1};
  return scene;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> found;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) found.push_back(cell);
  return found;
}

// Name of a column of write_geometry_csv.
std::string csv_name(const gui::GeometryHeading& heading) {
  static const std::map<std::string, std::string> names{
      {"Pulse", "pulse"},           {"Send time", "time_s"},      {"Frequency", "carrier_hz"},
      {"Position X", "x_m"},        {"Position Y", "y_m"},        {"Position Z", "z_m"},
      {"Velocity X", "vx_mps"},     {"Velocity Y", "vy_mps"},     {"Velocity Z", "vz_mps"},
      {"Rotation X", "rx_deg"},     {"Rotation Y", "ry_deg"},     {"Rotation Z", "rz_deg"},
      {"Distance", "distance_m"},   {"Two-way delay", "delay_s"}, {"Radial speed", "radial_speed_mps"},
      {"Amplitude", "amplitude_v"},
  };
  std::string owner = heading.owner;
  if (owner.starts_with("Target")) owner[0] = 't';
  return owner.empty() ? names.at(heading.quantity) : owner + " " + names.at(heading.quantity);
}

gui::GeometryChoice everything(const scene::Scene& scene, double end_s) {
  gui::GeometryChoice choice;
  choice.table.radar = "Radar1";
  choice.table.time_end_s = end_s;
  choice.table.columns = 255;
  choice.distance = true;
  for (std::size_t i = 0; i < scene.targets.size(); ++i) choice.targets.push_back(i);
  return choice;
}

bool computed(const gui::GeometryModel& model, int row) {
  return model.data(model.index(row, 0), gui::GeometryModel::value_role).isValid();
}

// A window on screen with its table computed.
struct Bench {
  explicit Bench(const scene::Scene& scene) {
    test::open(session, scene);
    window = std::make_unique<gui::GeometryWindow>(session);
    window->resize(1100, 700);
    ready = std::make_unique<QSignalSpy>(&window->model(), &gui::GeometryModel::ready);
    window->show();
    wait();
  }
  void wait() const { QVERIFY(!ready->isEmpty() || ready->wait(patience_ms)); }
  void enter(const char* field, const QString& text) const {
    auto* edit = window->findChild<QLineEdit*>(field);
    ready->clear();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  [[nodiscard]] QTableView* table() const { return window->view().table(); }

  gui::Session session;
  std::unique_ptr<gui::GeometryWindow> window;
  std::unique_ptr<QSignalSpy> ready;
};

}  // namespace

class GeometryTest : public QObject {
  Q_OBJECT

 private slots:
  void values_are_those_of_the_csv_table() {
    const scene::Scene scene = moving_scene();
    const gui::GeometryChoice choice = everything(scene, 1.5);
    std::string csv;
    simulate::write_geometry_csv(scene, choice.table, [&](std::string_view piece) { csv += piece; });
    std::stringstream stream(csv);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    const std::vector<std::string> names = cells(lines[0]);

    gui::GeometryModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QSignalSpy ready(&model, &gui::GeometryModel::ready);
    model.set_table(scene, choice);
    QVERIFY(ready.wait(patience_ms));
    QCOMPARE(model.rowCount() + 1, static_cast<int>(lines.size()));
    QCOMPARE(model.columnCount(), static_cast<int>(names.size()));
    for (const int row : {0, 1, 255, 256, 1000, 1500}) {
      QTRY_VERIFY(computed(model, row));
      const std::vector<std::string> expected = cells(lines[static_cast<std::size_t>(row) + 1]);
      for (int column = 0; column < model.columnCount(); ++column) {
        const std::string name = csv_name(model.headings()[static_cast<std::size_t>(column)]);
        const auto at = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
        QVERIFY2(at < names.size(), name.c_str());
        const double value = model.data(model.index(row, column), gui::GeometryModel::value_role).toDouble();
        QCOMPARE(QString::fromStdString(core::format_number(value)), QString::fromStdString(expected[at]));
      }
    }
  }

  void ten_million_pulses_open_at_once_and_scroll_at_once() {
    Bench bench(moving_scene());
    const test::ProcessorTime opening;
    bench.enter("field_time_end_s", "10000 s");
    bench.wait();
    QCOMPARE(bench.window->model().rowCount(), 10'000'001);
    QTRY_VERIFY(computed(bench.window->model(), 0));
    const double opened_s = opening.seconds();
    const test::ProcessorTime scrolling;
    bench.window->view().scroll_to(9'876'543);
    bench.window->repaint();
    const double scrolled_s = scrolling.seconds();
    QTRY_VERIFY(computed(bench.window->model(), 9'876'543));
    qInfo() << "10 million pulses [ms]: open" << 1e3 * opened_s << "scroll" << 1e3 * scrolled_s << "and compute"
            << 1e3 * scrolling.seconds();
    QCOMPARE(bench.window->view().first_row(), 9'876'543);
    QCOMPARE(bench.table()->model()->index(0, 0).data().toString(), QString("9876543"));
    // Far above what it takes, for slow machines.
    QVERIFY(opened_s < 3.0);
    QVERIFY(scrolled_s < 0.5);
    // Only what is on screen is held by the view.
    QVERIFY(bench.table()->model()->rowCount() < 100);
  }

  void cells_show_dots_until_they_are_computed() {
    gui::GeometryModel model;
    QSignalSpy ready(&model, &gui::GeometryModel::ready);
    model.set_table(moving_scene(), everything(moving_scene(), 1.0));
    QVERIFY(ready.wait(patience_ms));
    QCOMPARE(model.data(model.index(700, 1)).toString(), QString("…"));
    QTRY_COMPARE(model.data(model.index(700, 1)).toString(), QString("0.7"));
  }

  void keys_and_wheel_scroll_beyond_the_page() {
    Bench bench(moving_scene());
    const int page = bench.table()->model()->rowCount();
    QVERIFY(page > 3 && page < 101);
    bench.table()->setFocus();
    bench.table()->setCurrentIndex(bench.table()->model()->index(page - 1, 0));
    QTest::keyClick(bench.table(), Qt::Key_Down);
    QCOMPARE(bench.window->view().first_row(), 1);
    QTest::keyClick(bench.table(), Qt::Key_End, Qt::ControlModifier);
    QCOMPARE(bench.window->view().first_row(), 101 - page);
    QTest::keyClick(bench.table(), Qt::Key_Home, Qt::ControlModifier);
    QCOMPARE(bench.window->view().first_row(), 0);
    QWheelEvent wheel({20.0, 20.0}, bench.table()->viewport()->mapToGlobal(QPointF(20.0, 20.0)), {}, {0, -240},
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(bench.table()->viewport(), &wheel);
    QCOMPARE(bench.window->view().first_row(), 6);
    bench.enter("geometry_pulse", "50");
    QCOMPARE(bench.window->view().first_row(), 50);
  }

  void targets_outside_the_slant_range_have_a_dash() {
    Bench bench(moving_scene());
    bench.enter("field_range_end_m", "1500 m");
    bench.wait();
    const gui::GeometryModel& model = bench.window->model();
    const auto column = [&](const std::string& owner) {
      for (std::size_t i = 0; i < model.headings().size(); ++i)
        if (model.headings()[i].owner == owner && model.headings()[i].quantity == "Two-way delay")
          return static_cast<int>(i);
      return -1;
    };
    QTRY_VERIFY(computed(model, 0));
    QVERIFY(model.data(model.index(0, column("Target 1"))).toString() != "–");
    QCOMPARE(model.data(model.index(0, column("Target 2"))).toString(), QString("–"));
    QVERIFY(!model.data(model.index(0, column("Target 2")), Qt::ToolTipRole).toString().isEmpty());
  }

  void columns_and_targets_are_chosen() {
    Bench bench(moving_scene());
    // Bits 1, 2, 32, 64, 128: pulse, time, frequency and three columns for each of three targets.
    QCOMPARE(bench.window->model().columnCount(), 3 + 9);
    bench.ready->clear();
    bench.window->findChild<QCheckBox*>("field_columns.position")->click();
    QVERIFY(bench.ready->wait(patience_ms));
    QCOMPARE(bench.window->model().columnCount(), 3 + 6 + 9);
    bench.ready->clear();
    bench.window->findChild<QCheckBox*>("geometry_distance")->click();
    QVERIFY(bench.ready->wait(patience_ms));
    QCOMPARE(bench.window->model().columnCount(), 3 + 6 + 12);
    bench.enter("geometry_targets", "2-3");
    QVERIFY(bench.ready->wait(patience_ms));
    QCOMPARE(bench.window->model().columnCount(), 3 + 6 + 8);
    QCOMPARE(bench.window->choice().targets, (std::vector<std::size_t>{1, 2}));
    bench.enter("geometry_targets", "2-9");
    QCOMPARE(bench.window->choice().targets, (std::vector<std::size_t>{1, 2}));
  }

  void only_the_first_fifty_targets_are_shown_at_first() {
    Bench bench(test::many_targets(200));
    QCOMPARE(bench.window->choice().targets.size(), std::size_t{50});
    QCOMPARE(bench.window->findChild<QLineEdit*>("geometry_targets")->text(), QString("1-50"));
  }

  void numbers_and_ranges_are_read() {
    QCOMPARE(gui::read_numbers(" 3, 1-2,2 ", 5).indices, (std::vector<std::size_t>{0, 1, 2}));
    QVERIFY(gui::read_numbers("", 5).indices.empty() && gui::read_numbers("", 5).failure.empty());
    for (const char* bad : {"0", "6", "3-1", "a", "1-", "-3", "1-99999999999999999999"})
      QVERIFY2(!gui::read_numbers(bad, 5).failure.empty(), bad);
  }

  void faulty_scenes_are_explained() {
    scene::Scene scene = moving_scene();
    scene.radars[0].pulse_width_s = -1.0;
    gui::Session session;
    test::open(session, moving_scene());
    gui::GeometryWindow window(session);
    QSignalSpy failed(&window.model(), &gui::GeometryModel::failed);
    window.show();
    scene::GeometryTable table;
    table.radar = "Radar1";
    table.time_start_s = 2.0;
    table.time_end_s = 1.0;
    window.show_table(table);
    QTRY_VERIFY_WITH_TIMEOUT(!failed.isEmpty(), patience_ms);
    QVERIFY(window.findChild<gui::ProblemLine*>("geometry_problems")->isVisible());
    QCOMPARE(window.model().rowCount(), 0);
  }

  void saved_text_and_csv_are_those_of_the_command_line() {
    const scene::Scene scene = moving_scene();
    Bench bench(scene);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("table.txt").toStdString();
    QSignalSpy saved(bench.window.get(), &gui::GeometryWindow::saved);
    for (const bool csv : {false, true}) {
      std::string expected;
      const auto write = [&](std::string_view piece) { expected += piece; };
      const scene::GeometryTable& table = bench.window->choice().table;
      csv ? simulate::write_geometry_csv(bench.session.scene(), table, write)
          : simulate::write_geometry_text(bench.session.scene(), table, write);
      saved.clear();
      bench.window->save_to(path, csv);
      QVERIFY(saved.wait(patience_ms));
      QCOMPARE(file_text(path), expected);
      QVERIFY(!expected.empty());
    }
  }

  void saving_can_be_cancelled_and_leaves_nothing() {
    Bench bench(moving_scene());
    bench.enter("field_time_end_s", "100000 s");
    bench.wait();
    const QTemporaryDir folder;
    QSignalSpy saved(bench.window.get(), &gui::GeometryWindow::saved);
    bench.window->save_to(folder.filePath("table.txt").toStdString(), false);
    QTest::qWait(50);
    QVERIFY(bench.window->saving());
    bench.window->findChild<QPushButton*>("geometry_cancel")->click();
    QVERIFY(saved.wait(patience_ms));
    QCOMPARE(saved[0][0].value<gui::JobEnd>(), gui::JobEnd::cancelled);
    QVERIFY(std::filesystem::is_empty(folder.path().toStdString()));
    bench.window->save_to(folder.filePath("no/such/table.txt").toStdString(), false);
    saved.clear();
    QVERIFY(saved.wait(patience_ms));
    QCOMPARE(saved[0][0].value<gui::JobEnd>(), gui::JobEnd::failed);
    QVERIFY(bench.window->findChild<gui::ProblemLine*>("geometry_problems")->text().contains("table.txt"));
  }

  void tables_are_stored_shown_and_deleted() {
    Bench bench(moving_scene());
    auto* stored = bench.window->findChild<QComboBox*>("geometry_stored");
    QCOMPARE(stored->count(), 1);
    bench.enter("field_time_end_s", "50 ms");
    bench.window->to_script();
    QCOMPARE(bench.session.scene().geometries.size(), std::size_t{2});
    QCOMPARE(bench.session.scene().geometries[1].time_end_s, 0.05);
    QCOMPARE(stored->count(), 2);
    bench.enter("field_time_end_s", "1 s");
    stored->setCurrentIndex(1);
    bench.window->show_stored();
    QCOMPARE(bench.window->choice().table.time_end_s, 0.05);
    QCOMPARE(bench.window->findChild<QLineEdit*>("field_time_end_s")->text(), QString("50 ms"));
    bench.window->delete_stored();
    QCOMPARE(bench.session.scene().geometries.size(), std::size_t{1});
    bench.session.undo();
    QCOMPARE(bench.session.scene().geometries.size(), std::size_t{2});
  }
};

const test::AddTest added("geometry_test", test::run_test<GeometryTest>);

}  // namespace sarsim::geometry_test

#include "geometry_test.moc"

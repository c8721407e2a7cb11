#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include "gui/common/problem_line.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/property_panel.hpp"
#include "small_scene.hpp"

// Legs, waypoints and oscillations, and the world, in the form.

namespace sarsim::list_field_test {
namespace {

constexpr const char* scene_text = R"toml(format = "sarsim 2"

[world]
frame = "earth"
anchor = { latitude = "50 deg", longitude = "8 deg" }

[[platform]]
name = "Route"
path = { type = "waypoints", speed = "50 m/s", waypoints = [{ position = ["0 m", "0 m", "1 km"] }, { position = ["0 m", "10 km", "1 km"] }] }

[[platform]]
name = "Tour"
path = { type = "legs", speed = "50 m/s", start = [0, 0, 1000], legs = [{ leg = "straight", length = "10 km" }] }

[[target]]
platform = "Earth"
position = { latitude = "50.01 deg", longitude = "8 deg", height = "0 m" }
)toml";

struct Bench {
  explicit Bench(std::size_t platform) {
    session.take(scene::Document::from_text(scene_text));
    panel.resize(460, 1200);
    panel.show();
    session.select_only({scene::ObjectKind::platform, platform});
  }
  [[nodiscard]] QTableView* entries(const char* id) const {
    return panel.findChild<QTableView*>(QString("entries_%1").arg(id));
  }
  void press(const QString& button) const { panel.findChild<QToolButton*>(button)->click(); }
  [[nodiscard]] QString problem(const char* id) const {
    return panel.findChild<gui::ProblemLine*>(QString("problem_%1").arg(id))->text();
  }
  // As a user does: the cell is current, keys are pressed, Enter.
  void type(QTableView* view, int row, int column, const QString& text) const {
    view->setCurrentIndex(view->model()->index(row, column));
    view->edit(view->currentIndex());
    auto* const editor = view->findChild<QLineEdit*>("cell_editor");
    QVERIFY(editor != nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
    QApplication::processEvents();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the editor that was closed
  }
  [[nodiscard]] const scene::Platform& platform(std::size_t index) const { return session.scene().platforms[index]; }

  gui::Session session;
  gui::PropertyPanel panel{session};
};

}  // namespace

class ListFieldTest : public QObject {
  Q_OBJECT

 private slots:
  void a_cell_changes_its_waypoint_and_the_text() {
    const Bench bench(0);
    QTableView* const view = bench.entries("waypoints");
    QCOMPARE(view->model()->rowCount(), 2);
    QCOMPARE(view->model()->index(1, 1).data().toString(), QString("10 km"));
    bench.type(view, 1, 0, "3 km");
    QCOMPARE(bench.platform(0).waypoints[1].position_m.x, 3000.0);
    QVERIFY(bench.session.document().text().find("[{ position = [\"0 m\", \"0 m\", \"1 km\"] }") != std::string::npos);
    QCOMPARE(scene::Document::from_text(bench.session.document().text()).scene() == bench.session.scene(), true);
  }

  void what_is_refused_stays_to_be_mended() {
    const Bench bench(0);
    QTableView* const view = bench.entries("waypoints");
    bench.type(view, 1, 3, "fast");
    QVERIFY2(bench.problem("waypoints").contains("fast"), qPrintable(bench.problem("waypoints")));
    QTRY_VERIFY(view->findChild<QLineEdit*>("cell_editor") != nullptr);
    auto* const editor = view->findChild<QLineEdit*>("cell_editor");
    QCOMPARE(editor->text(), QString("fast"));
    editor->selectAll();
    QTest::keyClicks(editor, "70 m/s");
    QTest::keyClick(editor, Qt::Key_Return);
    QApplication::processEvents();
    QCOMPARE(bench.platform(0).waypoints[1].speed_mps, 70.0);
    QVERIFY2(!bench.problem("waypoints").contains("fast"), qPrintable(bench.problem("waypoints")));
  }

  void what_is_typed_goes_to_no_other_platform() {
    Bench bench(0);
    QTableView* const view = bench.entries("oscillations");
    bench.press("add_oscillations");
    bench.session.select_only({scene::ObjectKind::platform, 1});
    bench.press("add_oscillations");
    const std::string text = bench.session.document().text();
    view->setCurrentIndex(view->model()->index(0, 1));
    view->edit(view->currentIndex());
    auto* const editor = view->findChild<QLineEdit*>("cell_editor");
    QVERIFY(editor != nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, "7 m");
    bench.session.select_only({scene::ObjectKind::platform, 0});
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(view->findChild<QLineEdit*>("cell_editor") == nullptr);
    QVERIFY(bench.session.document().text() == text);
  }

  void entries_are_added_moved_and_removed() {
    Bench bench(0);
    QTableView* const view = bench.entries("waypoints");
    view->setCurrentIndex(view->model()->index(0, 0));
    bench.press("add_waypoints");
    QCOMPARE(bench.platform(0).waypoints.size(), std::size_t{3});
    QCOMPARE(bench.platform(0).waypoints[1].position_m.y, 5000.0);
    QCOMPARE(view->currentIndex().row(), 1);
    bench.press("down_waypoints");
    QCOMPARE(bench.platform(0).waypoints[2].position_m.y, 5000.0);
    QCOMPARE(view->currentIndex().row(), 2);
    bench.press("remove_waypoints");
    QCOMPARE(bench.platform(0).waypoints.size(), std::size_t{2});
    QCOMPARE(view->currentIndex().row(), 1);
    for (int i = 0; i < 3; ++i) bench.session.undo();
    QVERIFY(bench.session.document().text() == scene_text);
  }

  void columns_are_those_that_mean_something() {
    const Bench bench(1);
    QTableView* const view = bench.entries("legs");
    const auto column_of = [&](const QString& label) {
      for (int column = 0; column < view->model()->columnCount(); ++column)
        if (view->model()->headerData(column, Qt::Horizontal).toString() == label) return column;
      return -1;
    };
    QVERIFY(!view->isColumnHidden(column_of("Length")));
    QVERIFY(view->isColumnHidden(column_of("Bank")));
    bench.press("add_legs");
    view->setCurrentIndex(view->model()->index(1, 0));
    view->edit(view->currentIndex());
    auto* const choice = view->findChild<QComboBox*>("cell_editor");
    QVERIFY(choice != nullptr);
    choice->setCurrentText("Turn");
    QTest::keyClick(choice, Qt::Key_Return);
    QApplication::processEvents();
    QVERIFY(bench.platform(1).legs[1].kind == scene::Leg::Kind::turn);
    QVERIFY(!view->isColumnHidden(column_of("Bank")));
    QCOMPARE(view->model()->index(0, column_of("Bank")).data().toString(), QString("-"));
    QVERIFY(!view->model()->index(0, column_of("Bank")).flags().testFlag(Qt::ItemIsEditable));
  }

  void a_script_of_1998_says_why_it_has_no_lists() {
    gui::Session session;
    test::open(session, test::small_scene());
    gui::PropertyPanel panel{session};
    panel.resize(460, 1200);
    panel.show();
    session.select_only(test::platform(1));
    const std::string text = session.document().text();
    QVERIFY(panel.focus_field("oscillations"));
    panel.findChild<QToolButton*>("add_oscillations")->click();
    const QString problem = panel.findChild<gui::ProblemLine*>("problem_oscillations")->text();
    QVERIFY2(problem.contains("1998"), qPrintable(problem));
    QVERIFY(session.document().text() == text);
  }

  void a_list_of_several_platforms_is_not_for_hands() {
    Bench bench(0);
    bench.session.select({{scene::ObjectKind::platform, 0}, {scene::ObjectKind::platform, 1}});
    QVERIFY(!bench.panel.findChild<QWidget*>("field_oscillations")->isEnabled());
    QCOMPARE(bench.entries("oscillations")->model()->rowCount(), 0);
  }

  void the_world_is_typed_like_everything_else() {
    Bench bench(0);
    bench.session.select({});
    auto* const latitude = bench.panel.findChild<QLineEdit*>("field_latitude");
    QVERIFY(latitude != nullptr && latitude->isVisible());
    QCOMPARE(latitude->text(), QString("50 deg"));
    latitude->selectAll();
    QTest::keyClicks(latitude, "50.01 deg");
    QTest::keyClick(latitude, Qt::Key_Return);
    QVERIFY(std::abs(bench.session.scene().targets[0].position_m.y) < 1e-6);
    QCOMPARE(bench.session.document().history().undo_label(), std::string("Change latitude"));
    // Places by latitude cannot lie in a flat world.
    auto* const frame = bench.panel.findChild<QComboBox*>("field_frame");
    frame->setCurrentText("Flat");
    QVERIFY(!bench.problem("frame").isEmpty());
    QVERIFY(bench.session.scene().world.frame == scene::World::Frame::earth);
    bench.session.undo();
    QVERIFY(bench.session.document().text() == scene_text);
  }
};

const test::AddTest added("list_field_test", test::run_test<ListFieldTest>);

}  // namespace sarsim::list_field_test

#include "list_field_test.moc"

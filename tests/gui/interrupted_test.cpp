#include <QtTest>

#include <QMouseEvent>
#include <QTemporaryDir>

#include <filesystem>
#include <fstream>
#include <string>

#include "gui/echo/data_saver.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/runs/run_panel.hpp"
#include "gui/runs/save_queue.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/small_scene.hpp"
#include "scene/edit/edit.hpp"
#include "scene/script/writer.hpp"

/// What happens when something else comes between: an undo or a lost release in a drag, another program at the file,
/// the end of the workbench while work is under way.
namespace sarsim::interrupted_test {

namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 20'000;

// Its recording takes minutes.
scene::Scene slow_scene() {
  scene::Scene scene = test::many_targets(2000);
  for (scene::Target& target : scene.targets) target.position_m.x += 1000.0;
  scene::Simulation& simulation = scene.simulations.emplace_back();
  simulation.radar = "Radar1";
  simulation.range_end_m = 20e3;
  simulation.time_end_s = 100.0;
  simulation.sample_rate_hz = 50e6;
  simulation.lsb_v = 1e-6;
  return scene;
}

// A scene in the middle of the workbench, and a mouse.
class Bench {
 public:
  Bench() {
    test::open(session, test::small_scene());
    panel.resize(600, 500);
    panel.show();
    panel.scene().fit();
  }
  [[nodiscard]] QPoint place_of(scene::ObjectId id) {
    for (const picture::Snapshot::Target& target : panel.scene().snapshot().targets)
      if (target.id == id) {
        const auto point = panel.scene().camera().project(target.position_world_m);
        return (QPointF(point->x, point->y) / panel.scene().pixel_scale()).toPoint();
      }
    qFatal("the target is not in the picture");
    return {};
  }
  void mouse(QEvent::Type type, QPoint at, Qt::MouseButtons held) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, panel.scene().mapToGlobal(at), button, held, Qt::NoModifier);
    QCoreApplication::sendEvent(&panel.scene(), &event);
  }
  // Takes hold of a target and moves it some way.
  QPoint take_hold(scene::ObjectId id) {
    const QPoint from = place_of(id);
    mouse(QEvent::MouseButtonPress, from, Qt::LeftButton);
    mouse(QEvent::MouseMove, from + QPoint(20, 20), Qt::LeftButton);
    return from + QPoint(20, 20);
  }
  [[nodiscard]] core::Vec3 position(std::size_t index) const { return session.scene().targets.at(index).position_m; }

  gui::Session session;
  gui::ScenePanel panel{session};
};

// A workbench with a script from a folder.
struct Files {
  Files() {
    path = folder.filePath("a.scr").toStdString();
    write(test::small_scene());
    main.documents().ask_read_again = [this](bool) {
      ++questions;
      return read_again;
    };
    main.show();
  }
  void write(const scene::Scene& scene) const { std::ofstream(path) << scene::write_script(scene); }

  QTemporaryDir folder;
  fs::path path;
  gui::MainWindow main;
  int questions = 0;
  bool read_again = false;
};

}  // namespace

class InterruptedTest : public QObject {
  Q_OBJECT

 private slots:
  // --- Drags ------------------------------------------------------------------------------------------------------

  void a_drag_moves_a_target() {
    Bench bench;
    const core::Vec3 before = bench.position(1);
    const QPoint at = bench.take_hold(test::target(1));
    QVERIFY(bench.position(1) != before);
    bench.mouse(QEvent::MouseButtonRelease, at, Qt::NoButton);
  }

  void undoing_a_new_target_ends_the_drag_of_it() {
    Bench bench;
    bench.session.perform(scene::add_object(bench.session.scene(), scene::Target()));
    const std::size_t count = bench.session.scene().targets.size();
    const QPoint at = bench.take_hold(test::target(count - 1));
    for (int i = 0; i < 3; ++i) bench.session.undo();
    QVERIFY(bench.session.scene().targets.size() < count);
    bench.mouse(QEvent::MouseMove, at + QPoint(10, 0), Qt::LeftButton);
    bench.mouse(QEvent::MouseButtonRelease, at, Qt::NoButton);
    QVERIFY(bench.session.scene().targets.size() < count);
  }

  void undoing_a_drag_ends_it() {
    Bench bench;
    const core::Vec3 before = bench.position(1);
    const QPoint at = bench.take_hold(test::target(1));
    bench.session.undo();
    QVERIFY(bench.position(1) == before);
    bench.mouse(QEvent::MouseMove, at + QPoint(10, 0), Qt::LeftButton);
    QVERIFY(bench.position(1) == before);
  }

  void another_document_ends_a_drag() {
    Bench bench;
    const QPoint at = bench.take_hold(test::target(1));
    test::open(bench.session, test::small_scene());
    const core::Vec3 before = bench.position(1);
    bench.mouse(QEvent::MouseMove, at + QPoint(10, 0), Qt::LeftButton);
    QVERIFY(bench.position(1) == before);
  }

  void a_drag_whose_release_was_lost_ends_with_the_next_movement() {
    Bench bench;
    const QPoint at = bench.take_hold(test::target(1));
    const core::Vec3 dragged = bench.position(1);
    QSignalSpy ended(&bench.panel.scene(), &gui::SceneWidget::drag_ended);
    bench.mouse(QEvent::MouseMove, at + QPoint(50, 0), Qt::NoButton);
    QCOMPARE(ended.size(), 1);
    QVERIFY(bench.position(1) == dragged);
    bench.mouse(QEvent::MouseMove, at + QPoint(80, 0), Qt::LeftButton);
    QVERIFY(bench.position(1) == dragged);
  }

  void a_press_after_a_lost_release_begins_anew() {
    Bench bench;
    bench.take_hold(test::target(1));
    QSignalSpy ended(&bench.panel.scene(), &gui::SceneWidget::drag_ended);
    QSignalSpy clicked(&bench.panel.scene(), &gui::SceneWidget::selection_clicked);
    const QPoint other = bench.place_of(test::target(0));
    bench.mouse(QEvent::MouseButtonPress, other, Qt::LeftButton);
    QCOMPARE(ended.size(), 1);
    bench.mouse(QEvent::MouseButtonRelease, other, Qt::NoButton);
    QCOMPARE(clicked.size(), 1);
  }

  // --- Keys -------------------------------------------------------------------------------------------------------

  void the_keys_of_new_objects_work_while_the_scene_has_the_keyboard() {
    gui::MainWindow main;
    main.show();
    QVERIFY(QTest::qWaitForWindowActive(&main));
    main.scene().scene().setFocus();
    QTest::keyClick(&main.scene().scene(), Qt::Key_1, Qt::ControlModifier);
    QCOMPARE(main.session().scene().targets.size(), std::size_t{1});
    main.scene().scene().setFocus();
    QTest::keyClick(&main.scene().scene(), Qt::Key_3, Qt::ControlModifier);
    QCOMPARE(main.session().scene().radars.size(), std::size_t{1});
  }

  void digits_turn_the_camera() {
    Bench bench;
    bench.panel.scene().setFocus();
    QTest::keyClick(&bench.panel.scene(), Qt::Key_1);
    const picture::Camera above = picture::preset(bench.panel.scene().camera(), picture::ViewPreset::top);
    QCOMPARE(bench.panel.scene().camera().elevation_rad, above.elevation_rad);
    QTest::keyClick(&bench.panel.scene(), Qt::Key_2);
    const picture::Camera front = picture::preset(bench.panel.scene().camera(), picture::ViewPreset::front);
    QCOMPARE(bench.panel.scene().camera().elevation_rad, front.elevation_rad);
  }

  // --- The file on disk -------------------------------------------------------------------------------------------

  void a_version_that_is_not_wanted_is_asked_about_once_and_the_next_one_again() {
    Files files;
    QVERIFY(files.main.documents().open_file(QString::fromStdString(files.path.string())));
    files.main.documents().look_at_disk();
    QCOMPARE(files.questions, 0);
    scene::Scene scene = test::small_scene();
    scene.targets.emplace_back();
    files.write(scene);
    for (int i = 0; i < 2; ++i) files.main.documents().look_at_disk();
    QCOMPARE(files.questions, 1);
    scene.targets.emplace_back();
    files.write(scene);
    files.read_again = true;
    files.main.documents().look_at_disk();
    QCOMPARE(files.questions, 2);
    QCOMPARE(files.main.session().scene().targets.size(), scene.targets.size());
    files.main.documents().look_at_disk();
    QCOMPARE(files.questions, 2);
  }

  // --- Closing ----------------------------------------------------------------------------------------------------

  void closing_asks_about_the_document_before_it_ends_any_work() {
    Files files;
    gui::SaveQueue& queue = files.main.saver().queue();
    queue.add({slow_scene(), 0, files.path.parent_path() / "slow.bin", false});
    files.main.session().perform(scene::add_object(files.main.session().scene(), scene::Target()));
    auto answer = gui::DocumentKeeper::Answer::cancel;
    files.main.documents().ask_unsaved = [&] { return answer; };
    int asked = 0;
    bool end = false;
    files.main.ask_end_work = [&](const QStringList&) {
      ++asked;
      return end;
    };
    QVERIFY(!files.main.close());
    QCOMPARE(asked, 0);
    QVERIFY(queue.busy());
    answer = gui::DocumentKeeper::Answer::discard;
    QVERIFY(!files.main.close());
    QCOMPARE(asked, 1);
    QVERIFY(queue.busy());
    end = true;
    QVERIFY(files.main.close());
    QCOMPARE(asked, 2);
    QTRY_VERIFY_WITH_TIMEOUT(!queue.busy(), patience_ms);
    QVERIFY(!fs::exists(files.path.parent_path() / "slow.bin"));
  }

  void closing_asks_about_the_run_of_a_stored_simulation() {
    Files files;
    files.main.session().take(scene::Document::from_text(scene::write_script(slow_scene())));
    QVERIFY(files.main.work_under_way().isEmpty());
    auto* const stored = files.main.findChild<gui::StoredSimulations*>();
    stored->run_panel().set_patience_s(1e9);
    stored->run_into({scene::ObjectKind::simulation, 0}, files.path.parent_path() / "slow.bin", false);
    QVERIFY(stored->run_panel().running());
    QCOMPARE(files.main.work_under_way().size(), 1);
    bool end = false;
    files.main.ask_end_work = [&](const QStringList& work) { return end && work.size() == 1; };
    QVERIFY(!files.main.close());
    QVERIFY(stored->run_panel().running());
    end = true;
    QVERIFY(files.main.close());
    QTRY_VERIFY_WITH_TIMEOUT(!stored->run_panel().running(), patience_ms);
  }
};

const test::AddTest added("interrupted_test", test::run_test<InterruptedTest>);

}  // namespace sarsim::interrupted_test

#include "interrupted_test.moc"

#pragma once

#include <QCoreApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTableView>
#include <QTest>
#include <QWindow>

#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "gui/frame/main_window.hpp"
#include "gui/objects/target_table.hpp"
#include "gui/objects/target_table_model.hpp"
#include "gui/paint_count.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "scene/edit/document.hpp"
#include "scene/script/writer.hpp"
#include "support/processor_time.hpp"

/// Drags in the whole window, as a hand makes them, and the time until each is answered: for the benchmark and the
/// test.
namespace sarsim::test {

/// Half of the targets on Earth, half on a ship that sails past; a radar on a plane, a stored simulation of it.
inline scene::Scene wide_scene(std::size_t targets) {
  scene::Scene scene;
  scene.platforms.resize(3);
  const auto sail = [](scene::Platform& platform, const char* name, const core::Vec3& from_m, const core::Vec3& to_m) {
    platform.name = name;
    platform.path = scene::Platform::Path::trajectory;
    const double from[] = {from_m.x, from_m.y, from_m.z};
    const double to[] = {to_m.x, to_m.y, to_m.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
      platform.trajectory_m.part[axis].knots = {{0.0, from[axis]}, {10.0, to[axis]}};
  };
  sail(scene.platforms[1], "Ship", {0.0, 500.0, 0.0}, {100.0, 500.0, 0.0});
  sail(scene.platforms[2], "Plane", {-500.0, -3000.0, 3000.0}, {500.0, -3000.0, 3000.0});
  scene.radars.emplace_back().platform = "Plane";
  for (std::size_t i = 0; i < targets; ++i) {
    scene::Target& target = scene.targets.emplace_back();
    target.platform = i % 2 == 0 ? "Earth" : "Ship";
    target.position_m = {7.5 * static_cast<double>(i % 100), 7.5 * static_cast<double>(i / 100), 0.0};
  }
  scene::Simulation& simulation = scene.simulations.emplace_back();
  simulation.radar = "Radar1";
  simulation.range_start_m = 3000.0;
  simulation.range_end_m = 6000.0;
  simulation.time_end_s = 10.0;
  simulation.sample_rate_hz = 60e6;
  return scene;
}

/// Milliseconds from each movement of the hand until the window shows what it did.
struct AnswerTimes {
  std::vector<double> ms;
  std::vector<double> busy_ms;  ///< Of that, on a processor: what a machine without other work needs.

  [[nodiscard]] double worst() const { return *std::ranges::max_element(ms); }
  [[nodiscard]] double median() const { return middle(ms); }
  [[nodiscard]] double busy_worst() const { return *std::ranges::max_element(busy_ms); }
  [[nodiscard]] double busy_median() const { return middle(busy_ms); }

 private:
  static double middle(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
  }
};

/// The main window, 1600 by 1000 pixels, with the script in front, and a hand that moves sixty times a second. Work
/// that the window puts off until later delays the answer to a later movement and is counted with that.
class WindowDrags {
 public:
  explicit WindowDrags(std::size_t targets) {
    window_.session().take(scene::Document::from_text(scene::write_script(wide_scene(targets))));
    window_.resize(1600, 1000);
    window_.show();
    if (!QTest::qWaitForWindowExposed(&window_)) throw std::runtime_error("the window does not appear");
    window_.findChild<QDockWidget*>("script_dock")->raise();
    QTest::qWait(300);
    view().fit();
    QTest::qWait(300);
    paints_ = std::make_unique<PaintCount>(&view());
  }

  void open_target_table() {
    window_.window_named("targets")->show();
    QTest::qWait(300);
  }

  [[nodiscard]] gui::MainWindow& window() { return window_; }

  /// Turns the scene by dragging beside everything.
  AnswerTimes rotate(int steps) {
    const QPoint from = free_place();
    return drag(view(), from, steps, [&](int i) { return from + QPoint(20 + 3 * i, i % 20); });
  }

  /// Moves a target with the mouse, in small circles.
  AnswerTimes move_target(int steps) {
    const scene::ObjectId id{scene::ObjectKind::target, window_.session().scene().targets.size() / 2};
    window_.session().select_only(id);
    QTest::qWait(300);
    const QPoint from = place_of(id);
    const std::uint64_t before = window_.session().document().revision();
    AnswerTimes times = drag(view(), from, steps, [&](int i) { return from + QPoint(12 + i % 7 * 5, 8 + i % 11 * 4); });
    const std::uint64_t edits = window_.session().document().revision() - before;
    if (window_.session().document().history().undo_label() != "Move target" ||
        edits < static_cast<unsigned>(steps) / 2)
      throw std::runtime_error("the drag moved no target");
    return times;
  }

  /// Runs the x coordinate of a target up with the arrow key.
  AnswerTimes step_coordinate(int steps) {
    window_.session().select_only({scene::ObjectKind::target, window_.session().scene().targets.size() / 2});
    QTest::qWait(300);
    auto* field = window_.findChild<QLineEdit*>("field_position_m.x");
    field->setFocus();
    const QString before = field->text();
    AnswerTimes times = timed(steps, [&](int) { QTest::keyClick(field, Qt::Key_Up); });
    if (field->text() == before) throw std::runtime_error("the key changed nothing");
    return times;
  }

  /// Gives all targets of the table another cross-section, again and again.
  AnswerTimes fill_column(int steps) {
    auto* table = window_.findChild<gui::TargetTable*>();
    auto* view = table->findChild<QTableView*>("target_cells");
    const int column = static_cast<gui::TargetTableModel*>(view->model())->column_of("rcs_m2");
    const QItemSelection cells(view->model()->index(0, column),
                               view->model()->index(view->model()->rowCount() - 1, column));
    view->selectionModel()->select(cells, QItemSelectionModel::ClearAndSelect);
    QTest::qWait(500);
    AnswerTimes times = timed(steps, [&](int i) { table->fill_selection(QString("%1 m2").arg(i + 2)); });
    if (window_.session().scene().targets.back().rcs_m2 != 1.0 + steps)
      throw std::runtime_error("the column was not filled");
    return times;
  }

  /// Moves the time by dragging the slider.
  AnswerTimes scrub(int steps) {
    auto* slider = window_.findChild<QSlider*>("scrubber");
    QStyleOptionSlider option;
    option.initFrom(slider);
    option.maximum = slider->maximum();
    option.sliderPosition = option.sliderValue = slider->value();
    const QPoint from =
        slider->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider).center();
    const int turn = (slider->width() - 30) / 2;  // There and back, so that it never comes to its end.
    AnswerTimes times = drag(*slider, from, steps, [&](int i) {
      const int way = i % (2 * turn);
      return from + QPoint(2 * (way < turn ? way : 2 * turn - way), 0);
    });
    if (window_.session().time_s() == 0.0) throw std::runtime_error("the slider did not move");
    return times;
  }

 private:
  static constexpr double interval_ms = 1000.0 / 60.0;

  gui::SceneWidget& view() { return window_.scene().scene(); }

  [[nodiscard]] QPoint place_of(scene::ObjectId id) {
    for (const picture::Snapshot::Target& target : view().snapshot().targets)
      if (target.id == id)
        if (const auto point = view().camera().project(target.position_world_m))
          return (QPointF(point->x, point->y) / view().pixel_scale()).toPoint();
    throw std::runtime_error("the target is not in the picture");
  }

  // A corner where nothing is near.
  [[nodiscard]] QPoint free_place() {
    constexpr int below_buttons = 80;
    for (const QPoint corner :
         {QPoint(30, below_buttons), QPoint(view().width() - 30, below_buttons), QPoint(30, view().height() - 30)}) {
      const QPointF at = QPointF(corner) * view().pixel_scale();
      const bool taken = std::ranges::any_of(view().snapshot().targets, [&](const picture::Snapshot::Target& target) {
        const auto point = view().camera().project(target.position_world_m);
        return point && std::abs(point->x - at.x()) < 20.0 && std::abs(point->y - at.y()) < 20.0;
      });
      if (!taken) return corner;
    }
    throw std::runtime_error("every corner of the picture is taken");
  }

  // Through the window, so that the event passes all that a real one passes.
  AnswerTimes drag(QWidget& widget, QPoint from, int steps, const std::function<QPoint(int)>& at) {
    QWindow* const window = window_.windowHandle();
    const auto in_window = [&](QPoint place) { return widget.mapTo(&window_, place); };
    QTest::mousePress(window, Qt::LeftButton, {}, in_window(from));
    AnswerTimes times = timed(steps, [&](int i) { QTest::mouseMove(window, in_window(at(i + 1))); });
    QTest::mouseRelease(window, Qt::LeftButton, {}, in_window(at(steps)));
    QTest::qWait(500);
    return times;
  }

  AnswerTimes timed(int steps, const std::function<void(int)>& act) {
    AnswerTimes times;
    QElapsedTimer clock;
    clock.start();
    const auto now_ms = [&] { return 1e-6 * static_cast<double>(clock.nsecsElapsed()); };
    double due_ms = now_ms();
    for (int i = 0; i < steps; ++i) {
      while (now_ms() < due_ms) QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
      paints_->count = 0;
      const auto busy = ProcessorTime::of_this_thread();
      act(i);
      // Many targets are painted a few turns of the loop later.
      for (int turn = 0; turn < 10 && paints_->count == 0; ++turn) QCoreApplication::processEvents();
      if (paints_->count == 0)
        throw std::runtime_error("movement " + std::to_string(i) + " was not answered by a picture");
      times.ms.push_back(now_ms() - due_ms);
      times.busy_ms.push_back(1e3 * busy.seconds());
      // A hand rests at times; then what was put off begins.
      due_ms = std::max(due_ms + (i % 20 == 19 ? rest_ms : interval_ms), now_ms());
    }
    return times;
  }

  static constexpr double rest_ms = 400.0;

  gui::MainWindow window_;
  std::unique_ptr<PaintCount> paints_;
};

}  // namespace sarsim::test

// gui_drag [TARGETS or SCENE FILE...]: how long the window of the workbench takes to answer a hand that drags: with so
// many targets, or until the live image of a scene shows a target that was moved.

#include <QApplication>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/window_bench.hpp"
#include "gui/common/figure_plot.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/live/live_panel.hpp"
#include "gui/window_drags.hpp"
#include "scene/edit/edit.hpp"

namespace {

constexpr int steps = 50;

void print(std::size_t targets, bool with_table, const char* what, const sarsim::test::AnswerTimes& times) {
  std::printf("%8zu  %-6s %-20s %8.1f %8.1f %8.1f %8.1f\n", targets, with_table ? "table" : "", what, times.median(),
              times.worst(), times.busy_median(), times.busy_worst());
  std::fflush(stdout);
}

// Moves a target and waits until the image beside the scene shows it; busy is the thread of the windows alone.
// @param layout  scene, to which the image is added; or views, with the echoes of the first recording as well
void run_live(const std::string& file, const char* layout, const char* what) {
  constexpr int drags = 200;
  sarsim::gui::MainWindow window;
  window.use_layout(layout);
  window.resize(1600, 1000);
  window.show();
  window.documents().open_file(QString::fromStdString(file));
  static_cast<void>(window.window_named("image"));
  auto& panel = *window.findChild<sarsim::gui::LivePanel*>();
  if (!QTest::qWaitFor([&] { return panel.complete() && panel.image() != nullptr; }, 60'000)) return;
  sarsim::test::AnswerTimes times;
  for (int step = 0; step < drags; ++step) {
    const auto before = panel.image();
    const double busy = sarsim::bench::thread_ms();
    QElapsedTimer clock;
    clock.start();
    sarsim::scene::Target target = window.session().scene().targets.front();
    target.position_m.x += 0.5;
    window.session().perform(sarsim::scene::replace_object(
        window.session().scene(), {sarsim::scene::ObjectKind::target, 0}, target, "Move target", "drag"));
    while (panel.image() == before) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    panel.plot().repaint();
    times.ms.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
    times.busy_ms.push_back(sarsim::bench::thread_ms() - busy);
  }
  print(window.session().scene().targets.size(), false, what, times);
}

void run(std::size_t targets) {
  sarsim::test::WindowDrags drags(targets);
  for (const bool with_table : {false, true}) {
    if (with_table) drags.open_target_table();
    print(targets, with_table, "turn the scene", drags.rotate(steps));
    print(targets, with_table, "scrub the time", drags.scrub(steps));
    print(targets, with_table, "drag a target", drags.move_target(steps));
    print(targets, with_table, "step a coordinate", drags.step_coordinate(steps));
  }
  print(targets, true, "fill a column", drags.fill_column(5));
}

}  // namespace

int main(int argc, char** argv) {
  sarsim::bench::keep_apart();
  QApplication application(argc, argv);
  QApplication::setStyle("Fusion");
  std::printf("milliseconds from a movement of the hand to the picture, %d movements\n", steps);
  std::printf("%8s  %-6s %-20s %8s %8s %8s %8s\n", "targets", "open", "drag", "median", "worst", "busy", "worst");
  std::vector<std::string> wanted(argv + 1, argv + argc);
  if (wanted.empty()) wanted = {"10000", "100000"};
  for (const std::string& word : wanted) {
    const std::size_t targets = std::strtoul(word.c_str(), nullptr, 10);
    if (targets > 0) {
      run(targets);
      continue;
    }
    run_live(word, "scene", "with image");
    run_live(word, "views", "with echoes, image");
  }
  return EXIT_SUCCESS;
}

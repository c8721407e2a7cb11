// gui_drag [TARGETS...]: how long the window of the workbench takes to answer a hand that drags.

#include <QApplication>
#include <QStandardPaths>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "gui/window_drags.hpp"

namespace {

constexpr int steps = 50;

void print(std::size_t targets, bool with_table, const char* what, const sarsim::test::AnswerTimes& times) {
  std::printf("%8zu  %-6s %-20s %8.1f %8.1f %8.1f %8.1f\n", targets, with_table ? "table" : "", what, times.median(),
              times.worst(), times.busy_median(), times.busy_worst());
  std::fflush(stdout);
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
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
  QApplication::setStyle("Fusion");
  QCoreApplication::setOrganizationName("Sarsim test");
  QCoreApplication::setApplicationName("gui_drag");
  std::printf("milliseconds from a movement of the hand to the picture, %d movements\n", steps);
  std::printf("%8s  %-6s %-20s %8s %8s %8s %8s\n", "targets", "open", "drag", "median", "worst", "busy", "worst");
  std::vector<std::size_t> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::strtoul(argv[i], nullptr, 10));
  if (sizes.empty()) sizes = {10'000, 100'000};
  for (const std::size_t targets : sizes) run(targets);
  return EXIT_SUCCESS;
}

// gui_actions [TARGETS...]: processor time of the window's thread for what a user does with many targets.

#include <QAbstractEventDispatcher>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "bench/window_bench.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/objects/target_table_model.hpp"
#include "gui/script/script_editor.hpp"
#include "scene/edit/edit.hpp"

namespace {

using namespace sarsim;

// The processor time of the window's thread from one pause to the next, in which it takes keys and clicks: where its
// loop waits, and where it turns. Also within an action that waits for another thread.
class Stretches {
 public:
  Stretches() : begin_ms_(sarsim::bench::thread_ms()) {
    const auto* const dispatcher = QAbstractEventDispatcher::instance();
    waits_ = QObject::connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, [this] { pause(); });
    turns_ = QObject::connect(dispatcher, &QAbstractEventDispatcher::awake, [this] { pause(); });
  }
  Stretches(const Stretches&) = delete;
  Stretches& operator=(const Stretches&) = delete;
  ~Stretches() {
    QObject::disconnect(waits_);
    QObject::disconnect(turns_);
  }

  void pause() {
    const double now_ms = sarsim::bench::thread_ms();
    longest_ms_ = std::max(longest_ms_, now_ms - begin_ms_);
    begin_ms_ = now_ms;
  }
  [[nodiscard]] double longest_ms() const { return longest_ms_; }

 private:
  QMetaObject::Connection waits_;
  QMetaObject::Connection turns_;
  double begin_ms_;
  double longest_ms_ = 0.0;
};

// The action, and all that the window does of itself in the second after it; the longest stretch without an answer.
void measure(std::size_t targets, const char* what, const std::function<void()>& act) {
  QTest::qWait(700);
  const double begin = sarsim::bench::thread_ms();
  Stretches stretches;
  act();
  const double act_ms = sarsim::bench::thread_ms() - begin;
  stretches.pause();
  for (int i = 0; i < 100; ++i) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
    stretches.pause();
    QTest::qSleep(8);
  }
  std::printf("%8zu  %-24s %9.1f %9.1f %9.1f\n", targets, what, act_ms, stretches.longest_ms(),
              sarsim::bench::thread_ms() - begin);
  std::fflush(stdout);
}

std::vector<scene::Target> grid(std::size_t count) {
  std::vector<scene::Target> targets(count);
  for (std::size_t i = 0; i < count; ++i)
    targets[i].position_m = {10.0 * static_cast<double>(i % 300), 10.0 * static_cast<double>(i / 300), 0.25};
  return targets;
}

void edit_field(gui::MainWindow& window) {
  auto* field = window.findChild<QLineEdit*>("field_position_m.y");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "123.5");
  QTest::keyClick(field, Qt::Key_Return);
}

void run(std::size_t targets) {
  gui::MainWindow window;
  window.resize(1600, 1000);
  window.show();
  gui::Session& session = window.session();
  session.perform(scene::add_object(session.scene(), scene::Radar()));
  measure(targets, "import", [&] { session.perform(scene::add_targets(session.scene(), grid(targets))); });
  measure(targets, "undo", [&] { session.undo(); });
  measure(targets, "redo", [&] { session.redo(); });
  measure(targets, "select one", [&] { session.select_only({scene::ObjectKind::target, targets / 2}); });
  measure(targets, "edit one field", [&] { edit_field(window); });
  measure(targets, "undo of it", [&] { session.undo(); });
  auto* filter = window.findChild<gui::ObjectTree*>()->findChild<QLineEdit*>();
  measure(targets, "filter", [&] { filter->setText("9"); });
  measure(targets, "filter off", [&] { filter->clear(); });
  std::set<scene::ObjectId> all;
  for (std::size_t i = 0; i < targets; ++i) all.insert({scene::ObjectKind::target, i});
  measure(targets, "select all", [&] { session.select(all); });
  session.select({});
  measure(targets, "table, first time", [&] { window.findChild<QAction*>("edit_targets")->trigger(); });
  auto* cells = window.findChild<QTableView*>("target_cells");
  measure(targets, "sort by x", [&] { cells->sortByColumn(1, Qt::DescendingOrder); });
  const int rcs_column = qobject_cast<gui::TargetTableModel*>(cells->model())->column_of("rcs_m2");
  measure(targets, "select a column", [&] { cells->selectColumn(rcs_column); });
  measure(targets, "fill it", [&] {
    window.findChild<QLineEdit*>("fill_value")->setText("3 m2");
    window.findChild<QPushButton*>("fill_cells")->click();
  });
  measure(targets, "undo of it", [&] { session.undo(); });
  cells->clearSelection();
  measure(targets, "sort off", [&] { cells->sortByColumn(-1, Qt::AscendingOrder); });
  window.findChild<QWidget*>("target_table_dialog")->hide();
  std::vector<scene::ObjectId> odd;
  for (std::size_t i = 1; i < targets; i += 2) odd.push_back({scene::ObjectKind::target, i});
  measure(targets, "delete every other", [&] { session.perform(scene::remove_objects(session.scene(), odd)); });
  measure(targets, "undo of it", [&] { session.undo(); });
  measure(targets, "duplicate them", [&] { session.perform(scene::duplicate_objects(session.scene(), odd)); });
  measure(targets, "undo of it", [&] { session.undo(); });
  measure(targets, "rename their platform", [&] {
    session.perform(scene::rename_object(session.scene(), {scene::ObjectKind::platform, 0}, "Ground"));
  });
  measure(targets, "undo of it", [&] { session.undo(); });
  measure(targets, "hide them", [&] { session.set_hidden({all.begin(), all.end()}, true); });
  measure(targets, "show them", [&] { session.set_hidden({all.begin(), all.end()}, false); });
  auto* script = window.findChild<QDockWidget*>("script_dock");
  measure(targets, "script tab", [&] { script->raise(); });
  auto* text = window.findChild<QPlainTextEdit*>("script_text");
  measure(targets, "one character", [&] {
    text->setFocus();
    text->moveCursor(QTextCursor::Start);
    QTest::keyClicks(text, "#");
  });
  const QTemporaryDir folder;
  measure(targets, "save", [&] { session.save(folder.filePath("many.toml").toStdString()); });
}

}  // namespace

int main(int argc, char** argv) {
  sarsim::bench::keep_apart();
  QApplication application(argc, argv);
  QApplication::setStyle("Fusion");
  std::printf("processor milliseconds of the window's thread\n%8s  %-24s %9s %9s %9s\n", "targets", "action", "at once",
              "longest", "in all");
  std::vector<std::size_t> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::strtoul(argv[i], nullptr, 10));
  if (sizes.empty()) sizes = {24, 10'000, 100'000};
  for (const std::size_t targets : sizes) run(targets);
  return EXIT_SUCCESS;
}

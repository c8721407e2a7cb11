#include <QDockWidget>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QtTest>

#include <fstream>

#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/frame/problem_badge.hpp"
#include "gui/frame/problem_watch.hpp"
#include "gui/gui_test.hpp"
#include "gui/text_files.hpp"
#include "scene/edit/edit.hpp"

// What is wrong with the script is told in the log, once, and counted in the status bar.

namespace sarsim::problems_test {

namespace {

constexpr int patience_ms = 20'000;
const QString unknown = QStringLiteral("unknown command");
const QString empty_recording = QStringLiteral("the recording will be empty");

std::string example() { return test::file_text(SARSIM_SOURCE_DIR "/examples/sar_r.scr"); }

// One command of the example is not known.
std::string faulty_example() {
  std::string text = example();
  return text.replace(text.find("$TARGET"), 7, "$TARGTX");
}

core::Problem problem(core::Severity severity) {
  core::Problem made;
  made.severity = severity;
  made.message = "something is wrong";
  return made;
}

}  // namespace

class ProblemsTest : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;

  struct Bench {
    gui::MainWindow window;
    QPlainTextEdit* log = window.findChild<QPlainTextEdit*>("log_panel");
    gui::ProblemBadge* badge = window.findChild<gui::ProblemBadge*>("problem_badge");

    Bench() { window.show(); }
    [[nodiscard]] qsizetype told(const QString& words) const { return log->toPlainText().count(words); }
    [[nodiscard]] bool clean() const { return badge->isHidden(); }
    // The hand rests until a sound script was looked at once more: first the script, then the echoes.
    void rest() {
      QSignalSpy looked(window.findChild<gui::ProblemWatch*>(), &gui::ProblemWatch::changed);
      QTRY_VERIFY_WITH_TIMEOUT(looked.count() >= 2, patience_ms);
    }
    void move_window(double by_m) {
      scene::Simulation moved = window.session().scene().simulations.at(0);
      moved.range_start_m += by_m;
      moved.range_end_m += by_m;
      window.session().perform(scene::replace_object(window.session().scene(), {scene::ObjectKind::simulation, 0},
                                                     moved, "Move the window"));
    }
  };

  QString file(const std::string& text) {
    const QString path = folder_.filePath("scene.scr");
    std::ofstream(path.toStdString(), std::ios::binary) << text;
    return path;
  }

 private slots:
  void errors_and_warnings_are_counted_and_notes_are_not() {
    QCOMPARE(gui::problem_counts({}), QString());
    QCOMPARE(gui::problem_counts({problem(core::Severity::note)}), QString());
    QCOMPARE(gui::problem_counts({problem(core::Severity::warning)}), QString("1 warning"));
    QCOMPARE(gui::problem_counts(
                 {problem(core::Severity::error), problem(core::Severity::warning), problem(core::Severity::warning)}),
             QString("1 error, 2 warnings"));
  }

  void a_script_that_is_opened_has_its_errors_in_the_log() {
    Bench bench;
    QVERIFY(bench.window.documents().open_file(file(faulty_example())));
    QTRY_COMPARE_WITH_TIMEOUT(bench.told(unknown), qsizetype{1}, patience_ms);
    const QString log = bench.log->toPlainText();
    QVERIFY2(log.indexOf("Opened") < log.indexOf(unknown), qPrintable(log));
    QVERIFY2(log.contains("$TARGTX"), qPrintable(log));
    QVERIFY(bench.badge->isVisible());
    QCOMPARE(bench.badge->text(), QString("1 error"));
  }

  void a_script_without_faults_has_neither_lines_nor_a_badge() {
    Bench bench;
    QVERIFY(bench.window.documents().open_file(file(example())));
    bench.rest();
    QCOMPARE(bench.told("strongest echo"), qsizetype{1});  // how strong the echoes are, as `sarsim check` has it
    QCOMPARE(bench.told("off the beam"), qsizetype{2});
    QVERIFY2(bench.told("Error") + bench.told("Warning") == 0, qPrintable(bench.log->toPlainText()));
    QVERIFY(bench.clean());
  }

  void what_only_the_echoes_tell_is_told_too() {
    Bench bench;
    QVERIFY(bench.window.documents().open_file(file(example())));
    bench.rest();
    bench.move_window(10e3);
    QTRY_COMPARE_WITH_TIMEOUT(bench.told(empty_recording), qsizetype{1}, patience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(bench.badge->text(), QString("1 warning"), patience_ms);
    auto* list = bench.window.findChild<QListWidget*>("script_problems");
    // The note of the script before stands in the list until then.
    QTRY_VERIFY_WITH_TIMEOUT(list->count() == 1 && list->item(0)->text().contains(empty_recording), patience_ms);
  }

  void a_problem_that_stays_is_not_told_again() {
    Bench bench;
    QVERIFY(bench.window.documents().open_file(file(example())));
    bench.move_window(10e3);
    QTRY_COMPARE_WITH_TIMEOUT(bench.told(empty_recording), qsizetype{1}, patience_ms);
    // Its figures change, the places of its commands too.
    bench.move_window(5e3);
    bench.rest();
    bench.window.session().type_text("! one line more\n" + bench.window.session().document().text());
    bench.rest();
    QCOMPARE(bench.told(empty_recording), qsizetype{1});
    // An error hides it for a while.
    const std::string sound = bench.window.session().document().text();
    bench.window.session().type_text(sound + "\n$TARGTX\n");
    QTRY_COMPARE_WITH_TIMEOUT(bench.told(unknown), qsizetype{1}, patience_ms);
    bench.window.session().type_text(sound);
    bench.rest();
    QCOMPARE(bench.badge->text(), QString("1 warning"));
    QCOMPARE(bench.told(empty_recording), qsizetype{1});
  }

  void what_is_mended_leaves_the_badge_and_comes_back_as_new() {
    Bench bench;
    QVERIFY(bench.window.documents().open_file(file(faulty_example())));
    QTRY_COMPARE_WITH_TIMEOUT(bench.told(unknown), qsizetype{1}, patience_ms);
    bench.window.session().type_text(example());
    QTRY_VERIFY_WITH_TIMEOUT(bench.clean(), patience_ms);
    QCOMPARE(bench.told("All problems are fixed"), qsizetype{1});
    bench.window.session().type_text(faulty_example());
    QTRY_COMPARE_WITH_TIMEOUT(bench.told(unknown), qsizetype{2}, patience_ms);
    QVERIFY(bench.badge->isVisible());
  }

  void the_badge_leads_to_the_panel_that_lists_the_problems() {
    Bench bench;
    QVERIFY(bench.window.documents().open_file(file(faulty_example())));
    QTRY_VERIFY_WITH_TIMEOUT(bench.badge->isVisible(), patience_ms);
    auto* script = bench.window.findChild<QDockWidget*>("script_dock");
    script->hide();
    bench.badge->click();
    QVERIFY(!script->isHidden());
    QCOMPARE(bench.window.findChild<QListWidget*>("script_problems")->count(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<QPlainTextEdit*>("script_text")->isVisible(), patience_ms);
    QVERIFY(bench.window.findChild<QPlainTextEdit*>("script_text")->textCursor().block().text().startsWith("$TARGTX"));
  }
};

const test::AddTest added("problems_test", test::run_test<ProblemsTest>);

}  // namespace sarsim::problems_test

#include "problems_test.moc"

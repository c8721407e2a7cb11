#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/property_panel.hpp"
#include "scene/edit/edit.hpp"
#include "scene/edit/recovery.hpp"

// What is left of unsaved work when the workbench is killed. This program starts itself as the victim: with --edit it
// opens a script, types into the properties of a target and waits; with --write it keeps copies for recovery without
// end. Folders of the user are those of a temporary folder, for both.

namespace sarsim::recovery_kill_test {

namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 60'000;
constexpr const char* sound_script = R"(! precious comment
$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0
$TARGET Earth 1 2 3 0 0 0 1 0 ISO ! the target
)";

std::string text_in(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

// A script of some megabytes that says in every line which version it is.
std::string version(int number) {
  constexpr int lines = 60'000;
  const std::string line = "! version " + std::to_string(number) + std::string(80, '.') + "\n";
  std::string text;
  text.reserve(line.size() * lines);
  for (int i = 0; i < lines; ++i) text += line;
  return text + sound_script;
}

void type_x(gui::MainWindow& window, const QString& x) {
  window.session().select_only({scene::ObjectKind::target, 0});
  auto* field = window.findChild<gui::PropertyPanel*>()->findChild<QLineEdit*>("field_position_m.x");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, x);
  QTest::keyClick(field, Qt::Key_Return);
}

int edit_and_wait(const char* script, const char* x) {
  gui::MainWindow window;
  if (!window.documents().open_file(script)) return 1;
  window.show();
  type_x(window, x);
  std::puts("edited");
  std::fflush(stdout);
  return QApplication::exec();
}

int write_without_end(const char* script) {
  gui::MainWindow window;
  if (!window.documents().open_file(script)) return 1;
  for (int number = 1;; ++number) {
    window.session().type_text(version(number));
    if (!window.documents().keep_copies()) return 1;
    std::printf("%d\n", number);
    std::fflush(stdout);
  }
}

fs::path recovery_folder() {
  return fs::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) / "recovery";
}

std::size_t files_ending(const std::string& ending) {
  std::size_t count = 0;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(recovery_folder(), none))
    if (entry.path().filename().string().ends_with(ending)) ++count;
  return count;
}

std::size_t files_being_written() {
  std::size_t count = 0;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(recovery_folder(), none))
    if (entry.path().filename().string().find(".partial-") != std::string::npos) ++count;
  return count;
}

// A workbench in a process of its own.
class Victim {
 public:
  explicit Victim(const QStringList& arguments) {
    process_.start(QCoreApplication::applicationFilePath(), QStringList("recovery_kill_test") + arguments);
  }
  ~Victim() { kill(); }
  Victim(const Victim&) = delete;
  Victim& operator=(const Victim&) = delete;

  // The next line that it says; empty where it says none.
  QByteArray line() {
    while (!process_.canReadLine())
      if (!process_.waitForReadyRead(patience_ms)) return {};
    return process_.readLine().trimmed();
  }
  // kill -9: nothing in the program can see it coming.
  void kill() {
    process_.kill();
    process_.waitForFinished(patience_ms);
  }
  // The last line that it said before it was killed.
  QByteArray last_line() {
    QByteArray last;
    for (const QByteArray& said : process_.readAllStandardOutput().split('\n'))
      if (!said.trimmed().isEmpty()) last = said.trimmed();
    return last;
  }

 private:
  QProcess process_;
};

// Answers questions about recovery and remembers them.
class Answers {
 public:
  explicit Answers(std::vector<QMessageBox::StandardButton> answers) : answers_(std::move(answers)) {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr || !box->isVisible()) return;
      const auto answer = questions.size() < answers_.size() ? answers_[questions.size()] : QMessageBox::Cancel;
      questions.push_back(box->windowTitle() + ": " + box->text());
      buttons.clear();
      for (const QAbstractButton* button : box->buttons()) buttons << button->text().remove('&');
      box->button(answer)->click();
    });
    timer_.start(20);
  }

  std::vector<QString> questions;
  QStringList buttons;

 private:
  std::vector<QMessageBox::StandardButton> answers_;
  QTimer timer_;
};

}  // namespace

class RecoveryKillTest : public QObject {
  Q_OBJECT

 private:
  [[nodiscard]] QString file(const QString& name) const { return home_->filePath(name); }
  [[nodiscard]] fs::path path(const QString& name) const { return file(name).toStdString(); }

  // A program that was killed with an edit that it had kept a copy of.
  void leave_behind(const QString& name, const QString& x) const {
    const std::size_t before = files_ending(".recovery");
    Victim victim({"--edit", file(name), x});
    QCOMPARE(victim.line(), QByteArray("edited"));
    QTRY_COMPARE_WITH_TIMEOUT(files_ending(".recovery"), before + 1, patience_ms);
  }

  std::unique_ptr<QTemporaryDir> home_;

 private slots:
  void init() {
    home_ = std::make_unique<QTemporaryDir>();
    qputenv("XDG_DATA_HOME", file("data").toLocal8Bit());
    qputenv("XDG_CONFIG_HOME", file("config").toLocal8Bit());
    write(path("a.scr"), sound_script);
    write(path("b.scr"), sound_script);
  }

  void after_a_kill_the_next_start_offers_the_edit_and_restores_it() {
    leave_behind("a.scr", "1234.5");
    QCOMPARE(text_in(path("a.scr")), std::string(sound_script));
    gui::MainWindow window;
    window.show();
    const Answers answers({QMessageBox::Yes});
    window.documents().offer_recovery();
    QCOMPARE(answers.questions.size(), std::size_t{1});
    QVERIFY2(answers.questions[0].startsWith("Recovery: ") && answers.questions[0].contains(file("a.scr")),
             qPrintable(answers.questions[0]));
    // Finding B20: each button says what becomes of the copy.
    for (const char* words : {"Restore", "Discard", "Ask Next Time"}) QVERIFY2(answers.buttons.contains(words), words);
    QCOMPARE(window.session().scene().targets.at(0).position_m.x, 1234.5);
    QVERIFY(window.session().document().text().find("! precious comment\n") == 0);
    QVERIFY(window.isWindowModified());
    QCOMPARE(window.session().document().path(), path("a.scr"));
    QCOMPARE(text_in(path("a.scr")), std::string(sound_script));
    QVERIFY(scene::Recovery::orphans(recovery_folder()).empty());
    window.findChild<QAction*>("file_save")->trigger();
    QVERIFY(text_in(path("a.scr")).find("$TARGET Earth 1234.5 2 3") != std::string::npos);
    QCOMPARE(files_ending(".recovery"), std::size_t{0});
  }

  void what_was_recovered_survives_a_kill_before_it_is_saved() {
    leave_behind("a.scr", "1234.5");
    gui::MainWindow window;
    const Answers answers({QMessageBox::Yes});
    window.documents().offer_recovery();
    QCOMPARE(files_ending(".recovery"), std::size_t{1});
    window.documents().ask_unsaved = [] { return gui::DocumentKeeper::Answer::discard; };
    QVERIFY(window.close());
    QCOMPARE(files_ending(".recovery"), std::size_t{0});
  }

  void declined_work_is_not_offered_again_and_postponed_work_is() {
    leave_behind("a.scr", "1234.5");
    gui::MainWindow window;
    const Answers answers({QMessageBox::Cancel, QMessageBox::No});
    window.documents().offer_recovery();
    QCOMPARE(window.session().scene().targets.size(), std::size_t{0});
    window.documents().offer_recovery();
    window.documents().offer_recovery();
    QCOMPARE(answers.questions.size(), std::size_t{2});
    QCOMPARE(text_in(path("a.scr")), std::string(sound_script));
  }

  void work_on_a_file_that_is_gone_is_recovered_without_it() {
    leave_behind("a.scr", "1234.5");
    fs::remove(path("a.scr"));
    gui::MainWindow window;
    const Answers answers({QMessageBox::Yes});
    window.documents().offer_recovery();
    QCOMPARE(window.session().scene().targets.at(0).position_m.x, 1234.5);
    QVERIFY(window.isWindowModified());
  }

  // Moments are counted from when a copy begins to be written, which takes some milliseconds.
  void a_kill_while_the_copy_is_written_leaves_the_old_copy_or_the_new_one() {
    constexpr int moments = 10;
    constexpr int longest_wait_us = 20'000;
    std::size_t in_the_middle = 0;
    for (int moment = 0; moment < moments; ++moment) {
      fs::remove_all(recovery_folder());
      std::mt19937 random(static_cast<unsigned>(moment));
      const int wait_us = moment % 2 == 0 ? 0 : static_cast<int>(random() % longest_wait_us);
      Victim victim({"--write", file("a.scr")});
      int said = victim.line().toInt();
      QVERIFY(said >= 1);
      QElapsedTimer timer;
      timer.start();
      while (files_being_written() == 0 && timer.elapsed() < patience_ms) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::microseconds(wait_us));
      victim.kill();
      in_the_middle += files_being_written();
      if (const QByteArray last = victim.last_line(); !last.isEmpty()) said = last.toInt();
      const std::vector<scene::Recovery::Copy> copies = scene::Recovery::orphans(recovery_folder());
      QCOMPARE(copies.size(), std::size_t{1});
      QVERIFY2(copies[0].text == version(said) || copies[0].text == version(said + 1),
               qPrintable(QString::number(said)));
      QCOMPARE(copies[0].document, path("a.scr"));
    }
    QCOMPARE(text_in(path("a.scr")), std::string(sound_script));
    qInfo() << in_the_middle << "of" << moments << "kills came in the middle of writing";
    QVERIFY(in_the_middle > 0);
  }

  void workbenches_that_are_killed_leave_each_its_own_work_and_all_of_it_comes_back() {
    const std::size_t before = files_ending(".recovery");
    {
      Victim one({"--edit", file("a.scr"), "111"});
      Victim two({"--edit", file("b.scr"), "222"});
      Victim same({"--edit", file("b.scr"), "333"});
      for (Victim* victim : {&one, &two, &same}) QCOMPARE(victim->line(), QByteArray("edited"));
      QTRY_COMPARE_WITH_TIMEOUT(files_ending(".recovery"), before + 3, patience_ms);
    }
    gui::MainWindow window;
    const Answers answers({QMessageBox::Yes, QMessageBox::Yes, QMessageBox::Yes});
    window.documents().offer_recovery();
    QCOMPARE(answers.questions.size(), std::size_t{3});
    QCOMPARE(window.session().document_count(), std::size_t{3});
    std::multimap<double, fs::path> found;
    for (std::size_t i = 0; i < 3; ++i) {
      const scene::Document& document = window.session().document_at(i);
      found.emplace(document.scene().targets.at(0).position_m.x, document.path());
      QVERIFY(document.changed());
    }
    QVERIFY(answers.questions[0].contains(QString::fromStdString(window.session().document().path().string())));
    const std::multimap<double, fs::path> expected{
        {111.0, path("a.scr")}, {222.0, path("b.scr")}, {333.0, path("b.scr")}};
    QVERIFY(found == expected);
    QCOMPARE(files_ending(".recovery"), std::size_t{3});
    window.documents().end();
    QCOMPARE(files_ending(".recovery"), std::size_t{0});
  }

  void the_work_of_a_workbench_that_runs_is_not_offered_to_another() {
    Victim running({"--edit", file("a.scr"), "111"});
    QCOMPARE(running.line(), QByteArray("edited"));
    QTRY_COMPARE_WITH_TIMEOUT(files_ending(".recovery"), std::size_t{1}, patience_ms);
    leave_behind("b.scr", "222");
    gui::MainWindow window;
    const Answers answers({QMessageBox::Yes});
    window.documents().offer_recovery();
    QCOMPARE(window.session().scene().targets.at(0).position_m.x, 222.0);
    window.documents().offer_recovery();
    QCOMPARE(answers.questions.size(), std::size_t{1});
    window.documents().end();
    QCOMPARE(files_ending(".recovery"), std::size_t{1});
  }

  void whoever_edits_without_a_pause_has_copies_kept_too() {
    gui::MainWindow window;
    QVERIFY(window.documents().open_file(file("a.scr")));
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; files_ending(".recovery") == 0 && timer.elapsed() < patience_ms; ++i) {
      scene::Target target = window.session().scene().targets.at(0);
      target.position_m.y = 10.0 + i;
      window.session().perform(
          scene::replace_object(window.session().scene(), {scene::ObjectKind::target, 0}, target, "Move"));
      QTest::qWait(100);
    }
    QCOMPARE(files_ending(".recovery"), std::size_t{1});
    window.documents().end();
    QCOMPARE(files_ending(".recovery"), std::size_t{0});
  }
};

// Without the places that are for tests: copies are kept under the workbench's own name in the folders that init()
// chooses.
int run(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(false);
  QCoreApplication::setOrganizationName("Sarsim");
  QCoreApplication::setApplicationName("sarsim-gui");
  if (argc == 4 && std::strcmp(argv[1], "--edit") == 0) return edit_and_wait(argv[2], argv[3]);
  if (argc == 3 && std::strcmp(argv[1], "--write") == 0) return write_without_end(argv[2]);
  return test::run_test<RecoveryKillTest>(argc, argv);
}

const test::AddTest added("recovery_kill_test", run);

}  // namespace sarsim::recovery_kill_test

#include "recovery_kill_test.moc"

// A monkey at the workbench: actions, keys, clicks, drags and typed numbers in any order, drawn from a seed. Nothing
// may crash, no document may be lost, and all that was done can be undone.

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <set>

#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "harbour.hpp"
#include "scene/edit/recovery.hpp"

namespace sarsim::monkey_test {

namespace {

// What leaves the program, asks for files in dialogs of the desktop, or opens pages in a browser.
bool is_left_alone(const QAction& action) {
  static const QStringList names{"file_exit", "file_open", "file_save", "file_save_as"};
  return action.objectName().isEmpty() || names.contains(action.objectName());
}

bool is_left_alone(const QAbstractButton& button) {
  const auto* const tool = qobject_cast<const QToolButton*>(&button);
  return tool != nullptr && tool->defaultAction() != nullptr && is_left_alone(*tool->defaultAction());
}

// Closes whatever asks a question, so that the monkey goes on; counts what it closed.
class Closer {
 public:
  Closer() {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] {
      if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
      QWidget* modal = QApplication::activeModalWidget();
      if (modal == nullptr) return;
      ++closed;
      if (auto* dialog = qobject_cast<QDialog*>(modal))
        dialog->reject();
      else
        modal->close();
    });
    timer_.start(5);
  }

  int closed = 0;

 private:
  QTimer timer_;
};

class Monkey {
 public:
  Monkey(gui::MainWindow& window, unsigned seed) : window_(window), random_(seed) {}

  // One thing that a hand might do; says what it was.
  QString act() {
    switch (below(8)) {
      case 0:
      case 1: return trigger();
      case 2: return press_key();
      case 3: return click_somewhere();
      case 4: return drag_scene();
      case 5: return type_number();
      case 6: return below(2) == 0 ? select() : step(below(2) == 0);
      default: return press_button();
    }
  }

 private:
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  QString trigger() {
    QList<QAction*> actions;
    for (QAction* action : window_.findChildren<QAction*>())
      if (action->isEnabled() && action->menu() == nullptr && !is_left_alone(*action)) actions << action;
    if (actions.isEmpty()) return "nothing";
    QAction* const action = actions[below(static_cast<int>(actions.size()))];
    const QString name = action->objectName();
    action->trigger();
    return "action " + name;
  }

  QWidget* visible_widget() {
    QList<QWidget*> widgets;
    for (QWidget* widget : window_.findChildren<QWidget*>())
      if (widget->isVisible() && widget->isEnabled() && widget->focusPolicy() != Qt::NoFocus) widgets << widget;
    return widgets.isEmpty() ? nullptr : widgets[below(static_cast<int>(widgets.size()))];
  }

  QString press_key() {
    static const std::array keys{Qt::Key_Tab,    Qt::Key_Escape, Qt::Key_Return, Qt::Key_Delete, Qt::Key_Up,
                                 Qt::Key_Down,   Qt::Key_Left,   Qt::Key_Right,  Qt::Key_Home,   Qt::Key_F,
                                 Qt::Key_X,      Qt::Key_1,      Qt::Key_Plus,   Qt::Key_Minus,  Qt::Key_Space,
                                 Qt::Key_PageUp, Qt::Key_F2,     Qt::Key_A,      Qt::Key_Period, Qt::Key_Backspace};
    QWidget* at = QApplication::focusWidget();
    if (at == nullptr || below(3) == 0) at = visible_widget();
    if (at == nullptr) return "nothing";
    const Qt::Key key = keys[static_cast<std::size_t>(below(static_cast<int>(keys.size())))];
    QTest::keyClick(at, key, below(6) == 0 ? Qt::ControlModifier : Qt::NoModifier);
    return QString("key %1").arg(key);
  }

  QString click_somewhere() {
    QWidget* const at = visible_widget();
    if (at == nullptr) return "nothing";
    if (const auto* button = qobject_cast<QAbstractButton*>(at); button != nullptr && is_left_alone(*button))
      return "nothing";
    const QString name = at->objectName();
    QTest::mouseClick(at, below(5) == 0 ? Qt::RightButton : Qt::LeftButton, Qt::NoModifier,
                      QPoint(below(std::max(1, at->width())), below(std::max(1, at->height()))));
    return "click " + name;
  }

  QString drag_scene() {
    QWidget& scene = window_.scene().scene();
    const auto place = [&] { return QPoint(below(std::max(1, scene.width())), below(std::max(1, scene.height()))); };
    QTest::mousePress(&scene, Qt::LeftButton, Qt::NoModifier, place());
    for (int i = 0; i < 3; ++i) {
      QMouseEvent move(QEvent::MouseMove, place(), scene.mapToGlobal(place()), Qt::NoButton, Qt::LeftButton,
                       Qt::NoModifier);
      QApplication::sendEvent(&scene, &move);
    }
    if (below(4) == 0) QTest::keyClick(&scene, Qt::Key_Escape);
    QTest::mouseRelease(&scene, Qt::LeftButton, Qt::NoModifier, place());
    return "drag";
  }

  QString type_number() {
    static const QStringList texts{"0", "1", "-5", "300", "1e3", "2 km", "9.6 GHz", "nonsense", "", "1e999", "50 MHz"};
    QList<QLineEdit*> fields;
    for (QLineEdit* field : window_.findChildren<QLineEdit*>())
      if (field->isVisible() && field->isEnabled() && !field->isReadOnly()) fields << field;
    if (fields.isEmpty()) return "nothing";
    QLineEdit* const field = fields[below(static_cast<int>(fields.size()))];
    const QString name = field->objectName();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, texts[below(static_cast<int>(texts.size()))]);
    QTest::keyClick(field, Qt::Key_Return);
    return "type into " + name;
  }

  QString select() {
    const scene::Scene& scene = window_.session().scene();
    for (const scene::ObjectKind kind : scene::all_object_kinds) {
      const std::size_t count = scene::count_of(scene, kind);
      if (count > 0 && below(3) == 0) {
        window_.session().select_only({kind, static_cast<std::size_t>(below(static_cast<int>(count)))});
        return "select";
      }
    }
    return "nothing";
  }

  QString step(bool back) {
    if (back)
      window_.session().undo();
    else
      window_.session().redo();
    return back ? "undo" : "redo";
  }

  QString press_button() {
    QList<QAbstractButton*> buttons;
    for (QAbstractButton* button : window_.findChildren<QAbstractButton*>())
      if (button->isVisible() && button->isEnabled() && !is_left_alone(*button)) buttons << button;
    if (buttons.isEmpty()) return "nothing";
    QAbstractButton* const button = buttons[below(static_cast<int>(buttons.size()))];
    const QString name = button->objectName();
    button->click();
    return "button " + name;
  }

  gui::MainWindow& window_;
  std::mt19937 random_;
};

std::string text_in(const QString& path) {
  std::ifstream stream(path.toStdString(), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

int wanted(const char* variable, int usual) {
  const char* const said = std::getenv(variable);
  return said == nullptr ? usual : std::atoi(said);
}

// Nobody is there to answer.
void leave_questions(gui::MainWindow& window) {
  gui::DocumentKeeper& documents = window.documents();
  documents.ask_unsaved = [] { return gui::DocumentKeeper::Answer::cancel; };
  documents.ask_open_name = [] { return QString(); };
  documents.ask_save_name = [] { return QString(); };
  documents.ask_read_again = [](bool) { return false; };
  documents.show_failure = [](const QString&, const QString&) {};
  window.ask_end_work = [](const QStringList&) { return false; };
}

std::size_t mark_of(const std::string& text) { return std::hash<std::string>{}(text); }

// Those of the open documents that are not as they were saved.
std::string marks_of(const gui::Session& session) {
  std::string marks;
  for (std::size_t i = 0; i < session.document_count(); ++i)
    if (const scene::Document& document = session.document_at(i); document.changed())
      marks += " " + std::to_string(mark_of(document.text()));
  return marks;
}

// Works without end and says before and after each copy for recovery which texts it is of.
int be_a_victim(const QString& file, unsigned seed) {
  gui::MainWindow window;
  leave_questions(window);
  if (!window.documents().open_file(file)) return 1;
  window.show();
  const Closer closer;
  Monkey monkey(window, seed);
  while (true) {
    std::puts("acting");
    std::fflush(stdout);
    monkey.act();
    QApplication::processEvents();
    if (marks_of(window.session()).empty()) {
      std::puts("nothing");
      std::fflush(stdout);
      continue;
    }
    const std::string marks = marks_of(window.session());
    std::printf("writing%s\n", marks.c_str());
    std::fflush(stdout);
    if (!window.documents().keep_copies()) return 1;
    std::printf("kept%s\n", marks.c_str());
    std::fflush(stdout);
  }
}

std::filesystem::path recovery_folder() {
  return std::filesystem::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) /
         "recovery";
}

// What a victim said: the texts of which the newest copies may be.
struct Said {
  bool acting = false;
  std::size_t least = 0;  // So many copies are there: what one hand does takes one away at most.
  std::multiset<std::size_t> kept;
  std::multiset<std::size_t> writing;

  void hear(const QByteArray& line) {
    acting = line.startsWith("acting");
    std::multiset<std::size_t> marks;
    for (const QByteArray& mark : line.trimmed().split(' ').mid(1)) marks.insert(mark.toULongLong());
    if (line.startsWith("writing")) writing = marks;
    if (line.startsWith("kept")) kept = marks;
    if (line.startsWith("nothing")) kept.clear();
    least = std::min(kept.size(), line.startsWith("writing") ? marks.size() : kept.size());
    if (acting && least > 0) --least;
  }
};

// Starts a victim, kills it after so many words, and returns what it had said.
Said killed_victim(const QString& file, int seed, int words) {
  constexpr int patience_ms = 30'000;
  QProcess victim;
  victim.start(QCoreApplication::applicationFilePath(), {"monkey_test", "--victim", file, QString::number(seed)});
  Said said;
  for (int heard = 0; heard < words;) {
    if (!victim.canReadLine() && !victim.waitForReadyRead(patience_ms)) break;
    for (; victim.canReadLine(); ++heard) said.hear(victim.readLine());
  }
  victim.kill();
  victim.waitForFinished(patience_ms);
  while (victim.canReadLine()) said.hear(victim.readLine());
  return said;
}

}  // namespace

class MonkeyTest : public QObject {
  Q_OBJECT

 private slots:
  // SARSIM_MONKEY_ACTIONS and SARSIM_MONKEY_SEED change how many and which.
  void many_actions_in_any_order_lose_nothing() {
    const QTemporaryDir home;
    qputenv("XDG_DATA_HOME", home.filePath("data").toLocal8Bit());
    const QString file = test::small_harbour(home.path());
    QVERIFY(!file.isEmpty());
    const std::string before = text_in(file);
    const int actions = wanted("SARSIM_MONKEY_ACTIONS", 250);
    gui::MainWindow window;
    gui::DocumentKeeper& documents = window.documents();
    leave_questions(window);
    QVERIFY(documents.open_file(file));
    window.show();
    const Closer closer;
    Monkey monkey(window, static_cast<unsigned>(wanted("SARSIM_MONKEY_SEED", 1)));
    const bool loud = std::getenv("SARSIM_MONKEY_LOUD") != nullptr;
    for (int i = 0; i < actions; ++i) {
      const QString what = monkey.act();
      if (loud) std::fprintf(stderr, "%d %s\n", i, qPrintable(what));
      QApplication::processEvents();
      QVERIFY2(text_in(file) == before, qPrintable("the file was written, though nobody saved, by " + what));
    }
    QVERIFY(closer.closed >= 0);
    gui::Session& session = window.session();
    if (!marks_of(session).empty()) QVERIFY(documents.keep_copies());
    for (std::size_t at = 0; at < session.document_count(); ++at) {
      session.turn_to(at);
      // What is there is a document: its text says the scene that is shown.
      QVERIFY(scene::Document::from_text(session.document().text()).scene() == session.scene());
      for (int i = 0; i < 100'000 && session.document().history().can_undo(); ++i) session.undo();
      QVERIFY(!session.document().history().can_undo());
    }
  }

  // SARSIM_MONKEY_KILLS changes how often.
  void killed_at_any_moment_the_newest_copy_is_there() {
    const int kills = wanted("SARSIM_MONKEY_KILLS", 10);
    std::mt19937 random(7);
    int kept = 0;
    for (int i = 0; i < kills; ++i) {
      const QTemporaryDir home;
      qputenv("XDG_DATA_HOME", home.filePath("data").toLocal8Bit());
      const QString file = test::small_harbour(home.path());
      QVERIFY(!file.isEmpty());
      const std::string before = text_in(file);
      const Said said = killed_victim(file, i, 1 + static_cast<int>(random() % 60));
      QCOMPARE(text_in(file), before);
      if (said.kept.empty()) continue;
      ++kept;
      const auto copies = scene::Recovery::orphans(recovery_folder());
      QVERIFY2(copies.size() >= said.least, qPrintable(QString("kill %1").arg(i)));
      if (said.acting) continue;
      for (const auto& copy : copies) {
        const std::size_t mark = mark_of(copy.text);
        QVERIFY2(said.kept.contains(mark) || said.writing.contains(mark), qPrintable(QString("kill %1").arg(i)));
      }
    }
    qInfo() << kept << "of" << kills << "kills came while there was something to lose";
    QVERIFY(kept > 0);
  }
};

namespace {

// Without the places that are for tests: copies are kept in the folders that each test chooses.
int run(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(false);
  const QStringList arguments = QCoreApplication::arguments();
  if (const auto at = arguments.indexOf("--victim"); at >= 0 && at + 2 < arguments.size())
    return be_a_victim(arguments[at + 1], arguments[at + 2].toUInt());
  return test::run_test<MonkeyTest>(argc, argv);
}

const test::AddTest added("monkey_test", run);

}  // namespace

}  // namespace sarsim::monkey_test

#include "monkey_test.moc"

#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>
#include <QtTest>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "core/report/invalid_request.hpp"
#include "gui/common/session.hpp"
#include "gui/common/waiting.hpp"
#include "gui/gui_test.hpp"
#include "gui/small_scene.hpp"
#include "scene/edit/edit.hpp"

// Waiting for work on another thread, and giving it up.

namespace sarsim::waiting_test {

namespace {

using Clock = std::chrono::steady_clock;

QProgressDialog* waiting_dialog() {
  for (QWidget* window : QApplication::topLevelWidgets())
    if (window->objectName() == "waiting_dialog" && window->isVisible()) return qobject_cast<QProgressDialog*>(window);
  return nullptr;
}

// Clicks Cancel as soon as there is a dialog.
class Impatience {
 public:
  Impatience() {
    QObject::connect(&timer_, &QTimer::timeout, [this] {
      QProgressDialog* const dialog = waiting_dialog();
      if (dialog == nullptr) return;
      timer_.stop();
      words = dialog->labelText();
      dialog->findChild<QPushButton*>()->click();
    });
    timer_.start(20);
  }

  QString words;

 private:
  QTimer timer_;
};

}  // namespace

class WaitingTest : public QObject {
  Q_OBJECT

 private slots:
  void short_work_shows_no_dialog() {
    bool seen = false;
    QTimer watch;
    connect(&watch, &QTimer::timeout, [&] { seen |= waiting_dialog() != nullptr; });
    watch.start(5);
    int done = 0;
    const gui::Waited waited =
        gui::run_and_wait("Short work", [&](const core::StopFlag&, const gui::BackgroundJob::Report&) { done = 1; });
    QVERIFY(waited.end == gui::JobEnd::done);
    QCOMPARE(done, 1);
    QVERIFY(!seen);
    QVERIFY(QApplication::overrideCursor() == nullptr);
  }

  void work_that_fails_says_why() {
    const gui::Waited waited = gui::run_and_wait("Work", [](const core::StopFlag&, const gui::BackgroundJob::Report&) {
      throw std::runtime_error("there is no such object");
    });
    QVERIFY(waited.end == gui::JobEnd::failed);
    QCOMPARE(waited.failure, QString("there is no such object"));
  }

  void long_work_tells_how_far_it_is() {
    QString words;
    int value = 0;
    QTimer watch;
    connect(&watch, &QTimer::timeout, [&] {
      const QProgressDialog* const dialog = waiting_dialog();
      if (dialog == nullptr) return;
      words = dialog->labelText();
      value = std::max(value, dialog->value());
    });
    watch.start(5);
    const Clock::time_point begin = Clock::now();
    const gui::Waited waited = gui::run_and_wait("Fill RCS", [begin](const core::StopFlag&,
                                                                     const gui::BackgroundJob::Report& report) {
      for (double share = 0.0; share < 1.0; share = std::chrono::duration<double>(Clock::now() - begin).count() / 1.2) {
        report(share);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    });
    QVERIFY(waited.end == gui::JobEnd::done);
    QVERIFY2(words.startsWith("Fill RCS") && words.contains("left"), qPrintable(words));
    QVERIFY2(value > 500 && value < 1000, qPrintable(QString::number(value)));
    QVERIFY(waiting_dialog() == nullptr);
  }

  // Also work that does not look whether it is to stop: it is waited for no longer, and ends when it may.
  void work_is_given_up_at_once() {
    const auto go_on = std::make_shared<std::atomic<bool>>(false);
    const auto ended = std::make_shared<std::atomic<bool>>(false);
    Impatience impatience;
    const gui::Waited waited =
        gui::run_and_wait("Endless work", [=](const core::StopFlag&, const gui::BackgroundJob::Report&) {
          while (!*go_on) std::this_thread::sleep_for(std::chrono::milliseconds(10));
          *ended = true;
        });
    QVERIFY(waited.end == gui::JobEnd::cancelled);
    QVERIFY(!*ended);
    *go_on = true;
    QTRY_VERIFY(*ended);
  }

  void an_edit_that_is_given_up_leaves_the_scene_as_it_was() {
    // As many as it takes on this machine.
    std::size_t count = 100'000;
    bool given_up = false;
    for (; !given_up && count < 3'000'000; count *= 2) given_up = gives_up_adding(count);
    QVERIFY(given_up);
  }

  void an_edit_that_is_given_up_while_it_is_made_is_not_performed() {
    gui::Session session;
    test::open(session, test::small_scene());
    QStringList told;
    connect(&session, &gui::Session::logged, [&](int, const QString& words) { told += words; });
    int went_back = 0;  // windows that show what was asked for
    connect(&session, &gui::Session::scene_changed, [&](const scene::SceneChange& change) {
      if (change.empty()) ++went_back;
    });
    const auto go_on = std::make_shared<std::atomic<bool>>(false);
    const auto made = std::make_shared<std::atomic<bool>>(false);
    Impatience impatience;
    const std::string why = session.make_and_perform(
        "Change RCS", 1'000'000, [go_on, made](const scene::Document& document, scene::Edit& edit) {
          while (!*go_on) std::this_thread::sleep_for(std::chrono::milliseconds(10));
          edit = scene::remove_objects(document.scene(), {test::target(0)});
          *made = true;
          return std::string();
        });
    QCOMPARE(why, std::string());
    QCOMPARE(told, QStringList({"Change RCS was cancelled"}));
    QCOMPARE(went_back, 1);
    *go_on = true;
    QTRY_VERIFY(*made);
    QTest::qWait(50);
    QCOMPARE(session.scene().targets.size(), test::small_scene().targets.size());
  }

 private:
  // False where the edit was done before the dialog came.
  static bool gives_up_adding(std::size_t count) {
    gui::Session session;
    test::open(session, test::small_scene());
    const std::string text = session.document().text();
    const std::uint64_t revision = session.document().revision();
    QStringList told;
    connect(&session, &gui::Session::logged, [&](int, const QString& words) { told += words; });
    std::size_t inserted = 0;
    connect(&session, &gui::Session::scene_changed,
            [&](const scene::SceneChange& change) { inserted += change.inserted.size(); });
    Impatience impatience;
    session.perform(scene::add_targets(session.scene(), test::many_targets(count).targets));
    if (impatience.words.isEmpty()) return false;
    [&] {
      QVERIFY2(impatience.words.startsWith("Add"), qPrintable(impatience.words));
      QCOMPARE(session.document().revision(), revision);
      QCOMPARE(session.document().text(), text);
      QCOMPARE(inserted, std::size_t{0});
      QVERIFY2(told.size() == 1 && told[0].contains("was cancelled"), qPrintable(told.join('\n')));
      session.select({test::target(0), test::target(count - 1)});
      QCOMPARE(session.selection().size(), std::size_t{1});
    }();
    return true;
  }
};

const test::AddTest added("waiting_test", test::run_test<WaitingTest>);

}  // namespace sarsim::waiting_test

#include "waiting_test.moc"

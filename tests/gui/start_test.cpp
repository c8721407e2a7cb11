#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QTimer>
#include <QtTest>

#include "core/report/problem.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/guide_site.hpp"
#include "gui/frame/help_window.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/start/card_list.hpp"
#include "gui/start/help_headings.hpp"
#include "gui/start/search_box.hpp"
#include "gui/start/tour_panel.hpp"
#include "gui/start/welcome_page.hpp"
#include "scene/edit/document.hpp"
#include "scene/edit/starting_scenes.hpp"
#include "support/processor_time.hpp"

// The first minutes of somebody new: the welcome page, the search box, the tour.

namespace sarsim::start_test {

namespace {

constexpr int patience_ms = 10'000;

QString example(const char* name) { return QString(SARSIM_SOURCE_DIR "/examples/") + name; }

// Nothing where there is no error; otherwise the first, in words.
std::string error_in(const core::Problems& problems) {
  for (const core::Problem& problem : problems)
    if (problem.severity == core::Severity::error) return problem.message + "; found " + problem.found;
  return {};
}

struct Bench {
  Bench() {
    window.set_guide(gui::GuideSite({}, [](const QUrl&) { return false; }));
    window.documents().ask_unsaved = [] { return gui::DocumentKeeper::Answer::discard; };
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) qFatal("not shown");
    window.activateWindow();
    QCoreApplication::processEvents();
  }

  [[nodiscard]] gui::WelcomePage* welcome() const { return window.findChild<gui::WelcomePage*>("welcome_page"); }
  [[nodiscard]] gui::CardList* cards(const char* name) const { return window.findChild<gui::CardList*>(name); }
  void trigger(const char* name) const { window.findChild<QAction*>(name)->trigger(); }

  // Opens the search box, types, presses keys in it, and gives what was at the top before.
  QString search(const QString& typed, std::initializer_list<int> keys) {
    QString top;
    QTimer::singleShot(0, &window, [&] {
      auto* box = qobject_cast<gui::SearchBox*>(QApplication::activeModalWidget());
      if (box == nullptr) qFatal("no search box");
      auto* field = box->findChild<QLineEdit*>("search_field");
      QTest::keyClicks(field, typed);
      const auto* list = box->findChild<QListWidget*>("search_matches");
      top = list->count() == 0 ? QString() : list->item(0)->text();
      for (const int key : keys) QTest::keyClick(field, static_cast<Qt::Key>(key));
      if (QApplication::activeModalWidget() == box) box->reject();
    });
    trigger("edit_search");
    QCoreApplication::processEvents();
    return top;
  }

  gui::MainWindow window;
};

}  // namespace

class StartTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { QSettings().clear(); }

  void the_page_lies_over_an_empty_scene_until_something_is_made() {
    Bench bench;
    QVERIFY(bench.welcome()->isVisible());
    QCOMPARE(bench.welcome()->size(), bench.welcome()->parentWidget()->size());
    bench.window.resize(bench.window.width() + 60, bench.window.height() + 40);
    QCoreApplication::processEvents();
    QCOMPARE(bench.welcome()->size(), bench.welcome()->parentWidget()->size());
    bench.trigger("new_target");
    QVERIFY(!bench.welcome()->isVisible());
    bench.trigger("help_welcome");
    QVERIFY(bench.welcome()->isVisible());
    QVERIFY(bench.window.documents().open_file(example("sar_r.toml")));
    QVERIFY(!bench.welcome()->isVisible());
  }

  void escape_leaves_it_and_it_can_be_switched_off() {
    {
      Bench bench;
      QTRY_COMPARE(bench.window.focusWidget()->objectName(), QString("welcome_tour"));
      QTest::keyClick(bench.window.focusWidget(), Qt::Key_Escape);
      QVERIFY(!bench.welcome()->isVisible());
      bench.welcome()->findChild<QCheckBox*>("welcome_at_start")->setChecked(false);
    }
    Bench again;
    QVERIFY(!again.welcome()->isVisible());
    again.trigger("help_welcome");
    QVERIFY(again.welcome()->isVisible());
  }

  void fields_are_found_by_what_the_trade_calls_them() {
    Bench bench;
    for (const auto& [typed, found] :
         {std::pair{"wavelength", "Radar: Frequency"}, std::pair{"pri", "Radar: Pulse repetition frequency"},
          std::pair{"noise figure", "Radar: Noise temperature"}, std::pair{"tx power", "Radar: Power output"}})
      QCOMPARE(bench.search(typed, {}), QString(found));
  }

  void every_card_of_an_example_has_a_picture_and_opens_its_scene() {
    Bench bench;
    auto* cards = bench.cards("welcome_examples");
    QVERIFY(cards->count() >= 12);
    QTRY_VERIFY_WITH_TIMEOUT(!cards->item(cards->count() - 1)->data(Qt::UserRole + 2).isNull(), patience_ms);
    for (int row = 0; row < cards->count(); ++row) {
      QVERIFY2(!cards->item(row)->data(Qt::UserRole + 2).value<QPixmap>().isNull(),
               qPrintable(cards->item(row)->text()));
      bench.trigger("help_welcome");
      emit cards->chosen(row);
      QVERIFY2(!bench.welcome()->isVisible(), qPrintable(cards->item(row)->text()));
      QVERIFY(!bench.window.session().scene().radars.empty());
      const std::string error = error_in(bench.window.session().document().problems());
      QVERIFY2(error.empty(), error.c_str());
    }
  }

  void a_click_on_a_card_chooses_it_once_and_so_does_enter() {
    Bench bench;
    auto* cards = bench.cards("welcome_templates");
    const QSignalSpy chosen(cards, &gui::CardList::chosen);
    cards->setCurrentRow(1);
    cards->setFocus();
    QTest::keyClick(cards, Qt::Key_Return);
    QCOMPARE(chosen.size(), 1);
    bench.trigger("help_welcome");
    QTest::mouseClick(cards->viewport(), Qt::LeftButton, {}, cards->visualItemRect(cards->item(1)).center());
    QCOMPARE(chosen.size(), 2);
    QCOMPARE(chosen.last().first().toInt(), 1);
  }

  void cards_are_seen_whole_whatever_the_width() {
    Bench bench;
    for (const int width : {1000, 1366, 1900}) {
      bench.window.resize(width, 760);
      QCoreApplication::processEvents();
      for (const char* name : {"welcome_templates", "welcome_examples"}) {
        auto* cards = bench.cards(name);
        const QRect last = cards->visualItemRect(cards->item(cards->count() - 1));
        QVERIFY2(cards->viewport()->rect().contains(last), name);
      }
    }
  }

  void every_scene_to_begin_with_is_without_errors_and_has_a_recording() {
    Bench bench;
    auto* cards = bench.cards("welcome_templates");
    QCOMPARE(cards->count(), static_cast<int>(scene::starting_scenes().size()));
    for (int row = 0; row < cards->count(); ++row) {
      QVERIFY2(!cards->item(row)->text().isEmpty() && !cards->item(row)->icon().isNull(),
               qPrintable(QString::number(row)));
      emit cards->chosen(row);
      QVERIFY(!bench.window.session().scene().simulations.empty());
      const std::string error = error_in(bench.window.session().document().problems());
      QVERIFY2(error.empty(), error.c_str());
      QVERIFY(bench.window.session().document().path().empty());
    }
  }

  void one_box_finds_commands_fields_and_headings() {
    Bench bench;
    QCOMPARE(bench.search("new radar", {Qt::Key_Escape}), QString("Geometry: New Radar"));
    QVERIFY(bench.window.session().scene().radars.empty());
    bench.search("new radar", {Qt::Key_Return});
    QCOMPARE(bench.window.session().scene().radars.size(), std::size_t{1});
    QVERIFY(bench.window.documents().open_file(example("sar_r.toml")));
    bench.window.session().select({});
    QCOMPARE(bench.search("radar: pulse width", {Qt::Key_Return}), QString("Radar: Pulse width"));
    QCOMPARE(bench.window.session().current(), (scene::ObjectId{scene::ObjectKind::radar, 0}));
    QCOMPARE(bench.window.focusWidget()->objectName(), QString("field_pulse_width_s"));
    QCOMPARE(bench.search("mouse and keys in the scene", {Qt::Key_Return}), QString("Mouse and keys in the scene"));
    const auto* help = bench.window.findChild<gui::HelpWindow*>("help_window");
    QVERIFY(help != nullptr && help->isVisible());
    QCOMPARE(help->heading(), QString("Mouse and keys in the scene"));
  }

  // A field of an object that the scene has not, or that means nothing as the object is, leads to the reference.
  void a_field_without_an_object_shows_its_help() {
    Bench bench;
    bench.search("radar: pulse width", {Qt::Key_Return});
    const auto* help = bench.window.findChild<gui::HelpWindow*>("help_window");
    QVERIFY(help != nullptr && help->isVisible());
    QVERIFY(help->findChild<QTextBrowser*>()->source().toLocalFile().endsWith("formats/scene.md"));
  }

  void opening_the_box_takes_no_time_that_is_felt() {
    Bench bench;
    const test::ProcessorTime time;
    bench.search("", {Qt::Key_Escape});
    const double taken_s = time.seconds();
    QVERIFY2(taken_s < 1.0, qPrintable(QString::number(taken_s)));
    const auto headings = gui::help_headings(gui::HelpWindow::folder());
    QVERIFY(headings.size() > 100);
    for (const auto& found : headings) QVERIFY(!found.heading.startsWith('#'));
  }

  void the_tour_sees_what_the_user_does() {
    const QTemporaryDir folder;
    Bench bench;
    bench.trigger("help_tour");
    auto* tour = bench.window.findChild<gui::TourPanel*>("tour");
    QVERIFY(tour != nullptr && tour->isVisible() && !tour->isModal());
    QVERIFY(!bench.welcome()->isVisible());
    QVERIFY(tour->steps() >= 6 && tour->steps() <= 8);
    QVERIFY(!tour->step_done());
    bench.trigger("new_radar");
    QTRY_VERIFY(tour->step_done());
    QTest::mouseClick(tour->findChild<QPushButton*>("tour_next"), Qt::LeftButton);
    QCOMPARE(tour->step(), 1);
    QVERIFY(!tour->step_done());
    QTest::mouseClick(tour->findChild<QPushButton*>("tour_back"), Qt::LeftButton);
    QCOMPARE(tour->step(), 0);
    QVERIFY(tour->step_done());
  }

  void show_me_does_every_step_and_ends_with_the_number_of_the_thesis() {
    const QTemporaryDir folder;
    Bench bench;
    bench.window.documents().ask_save_name = [&] { return folder.filePath("tour.toml"); };
    bench.trigger("help_tour");
    auto* tour = bench.window.findChild<gui::TourPanel*>("tour");
    const QSize size = tour->size();
    for (int step = 0; step < tour->steps(); ++step) {
      QCOMPARE(tour->step(), step);
      QVERIFY(tour->step_done() || tour->findChild<QPushButton*>("tour_show")->isEnabled());
      QTest::mouseClick(tour->findChild<QPushButton*>("tour_show"), Qt::LeftButton);
      QTRY_VERIFY2_WITH_TIMEOUT(tour->step_done(), qPrintable(QString::number(step)), patience_ms);
      QCOMPARE(tour->size(), size);
      QTest::mouseClick(tour->findChild<QPushButton*>("tour_next"), Qt::LeftButton);
    }
    QVERIFY(!tour->isVisible());
    QVERIFY(QFile::exists(folder.filePath("tour.toml")));
    QVERIFY(bench.window.findChild<QLabel*>("echo_highest")->text().contains("40.9566 nV"));
  }
};

const test::AddTest added("start_test", test::run_test<StartTest>);

}  // namespace sarsim::start_test

#include "start_test.moc"

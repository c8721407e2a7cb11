#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QTextFrame>
#include <QTextTable>
#include <QToolButton>
#include <QtTest>

#include "gui/frame/document_keeper.hpp"
#include "gui/frame/guide_site.hpp"
#include "gui/frame/help_key.hpp"
#include "gui/frame/help_window.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/property_panel.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/scene/time_bar.hpp"

namespace sarsim::help_test {

namespace {

// The example of the thesis, at work on its first target.
struct Bench {
  Bench() {
    if (!window.documents().open_file(QStringLiteral(SARSIM_SOURCE_DIR "/examples/sar_r.scr"))) qFatal("not opened");
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) qFatal("not shown");
    window.activateWindow();
    window.session().select_only({scene::ObjectKind::target, 0});
    QCoreApplication::processEvents();
  }

  // Presses F1 in a widget and gives back the window that opened.
  [[nodiscard]] gui::HelpWindow* help_in(QWidget* widget) const {
    widget->setFocus();
    QTest::keyClick(widget, Qt::Key_F1);
    for (QWidget* top : QApplication::topLevelWidgets())
      if (auto* help = qobject_cast<gui::HelpWindow*>(top); help != nullptr && help->isVisible()) return help;
    return nullptr;
  }
  [[nodiscard]] static QString page(const gui::HelpWindow& help) {
    return help.findChild<QTextBrowser*>()->source().toLocalFile().remove(gui::HelpWindow::folder() + "/");
  }

  gui::MainWindow window;
};

// A site of empty pages, and the address that its browser was asked for.
struct Site {
  explicit Site(const QStringList& pages) {
    for (const QString& page : pages) {
      QDir(folder.path()).mkpath(QFileInfo(page).path());
      if (!QFile(folder.filePath(page)).open(QIODevice::WriteOnly)) qFatal("no page");
    }
  }
  [[nodiscard]] gui::GuideSite guide(bool shown) {
    return {folder.path(), [this, shown](const QUrl& url) {
              asked = url;
              return shown;
            }};
  }
  [[nodiscard]] QUrl address(const QString& page, const QString& fragment) const {
    QUrl url = QUrl::fromLocalFile(folder.filePath(page));
    if (!fragment.isEmpty()) url.setFragment(fragment);
    return url;
  }

  QTemporaryDir folder;
  QUrl asked;
};

}  // namespace

class HelpTest : public QObject {
  Q_OBJECT

 private slots:
  void every_place_that_f1_may_lead_to_is_in_the_guide() {
    gui::HelpWindow help;
    help.show();
    for (const gui::HelpPlace& place : gui::all_help_places()) {
      help.show_page(place.page, place.heading);
      const auto* browser = help.findChild<QTextBrowser*>();
      QVERIFY2(!browser->document()->isEmpty(), qPrintable(place.page));
      if (!place.heading.isEmpty()) QCOMPARE(help.heading(), place.heading);
    }
  }

  void a_page_is_laid_out_once() {
    gui::HelpWindow help;
    help.show();
    const QSignalSpy changed(help.findChild<QTextBrowser*>()->document(), &QTextDocument::contentsChange);
    help.show_page("formats/scene.md", "Functions");
    QCOMPARE(help.heading(), QString("Functions"));
    QVERIFY2(changed.size() < 10, qPrintable(QString::number(changed.size())));
    int tables = 0;
    for (QTextFrame* frame : help.findChild<QTextBrowser*>()->document()->rootFrame()->childFrames())
      if (const auto* table = qobject_cast<QTextTable*>(frame)) {
        QVERIFY(table->format().borderCollapse());  // Rows are told apart by one fine line.
        ++tables;
      }
    QVERIFY(tables > 10);
  }

  void f1_opens_the_page_of_the_window_that_has_the_keyboard_data() {
    QTest::addColumn<QString>("window");
    QTest::addColumn<QString>("page");
    QTest::addColumn<QString>("heading");
    const QString workbench = "guide/workbench.md";
    QTest::newRow("objects") << "objects" << workbench << "Objects";
    QTest::newRow("properties") << "properties" << workbench << "Values";
    QTest::newRow("simulations") << "simulations" << workbench << "Stored simulations";
    const QString echoes = "guide/simulation-window.md";
    QTest::newRow("simulation") << "simulation" << echoes << "";
    QTest::newRow("range_doppler") << "range_doppler" << echoes << "Other views of the same samples";
    QTest::newRow("viewer") << "viewer"
                            << "guide/image-viewer.md"
                            << "";
    QTest::newRow("products") << "products" << workbench << "Images from echoes";
    QTest::newRow("script") << "script"
                            << "formats/scene.md"
                            << "";
    QTest::newRow("log") << "log"
                         << "guide/troubleshooting.md"
                         << "";
    QTest::newRow("geometry") << "geometry"
                              << "formats/geometry-table.md"
                              << "";
    QTest::newRow("targets") << "targets" << workbench << "Many targets";
    QTest::newRow("import") << "import" << workbench << "Many targets";
    QTest::newRow("function") << "function" << workbench << "Functions";
    QTest::newRow("commands") << "commands" << workbench << "Search";
    QTest::newRow("welcome") << "welcome" << workbench << "The first minutes";
    QTest::newRow("tour") << "tour" << workbench << "The first minutes";
  }

  void f1_opens_the_page_of_the_window_that_has_the_keyboard() {
    QFETCH(QString, window);
    QFETCH(QString, page);
    QFETCH(QString, heading);
    Bench bench;
    QWidget* shown = bench.window.window_named(window);
    QVERIFY(shown != nullptr);
    shown->show();
    shown->activateWindow();
    QCoreApplication::processEvents();
    QWidget* inside = nullptr;
    for (QWidget* child : shown->findChildren<QWidget*>())
      if (child->focusPolicy() != Qt::NoFocus && child->isVisible() && child->isEnabled()) inside = child;
    QVERIFY(inside != nullptr);
    const gui::HelpWindow* help = bench.help_in(inside);
    QVERIFY(help != nullptr);
    QCOMPARE(Bench::page(*help), page);
    if (!heading.isEmpty()) QCOMPARE(help->heading(), heading);
  }

  void the_button_help_of_a_dialog_does_what_f1_does() {
    Bench bench;
    for (const char* name : {"function", "import", "targets"}) {
      QWidget* shown = bench.window.window_named(name);
      shown->show();
      auto* button = shown->findChild<QPushButton*>("help_button");
      QVERIFY2(button != nullptr, name);
      QTest::mouseClick(button, Qt::LeftButton);
      const auto* help = bench.window.findChild<gui::HelpWindow*>("help_window");
      QVERIFY2(help != nullptr && help->isVisible(), name);
      QCOMPARE(help->heading(), QString(name) == "function" ? QString("Functions") : QString("Many targets"));
    }
  }

  void pictures_fit_the_window_and_words_are_found() {
    Bench bench;
    auto* help = qobject_cast<gui::HelpWindow*>(bench.window.window_named("help"));
    QVERIFY(help != nullptr);
    help->resize(500, 400);
    help->show();
    QVERIFY(QTest::qWaitForWindowExposed(help));
    help->show_page("guide/workbench.md");
    QCoreApplication::processEvents();
    auto* page = help->findChild<QTextBrowser*>();
    QVERIFY(page->document()->size().width() <= page->viewport()->width() + 1);
    auto* find = help->findChild<QLineEdit*>("help_find");
    QTest::keyClicks(find, "scrubber");
    const int first = page->textCursor().selectionStart();
    QCOMPARE(page->textCursor().selectedText(), QString("scrubber"));
    QTest::keyClick(find, Qt::Key_Return);
    QCOMPARE(page->textCursor().selectedText(), QString("scrubber"));
    find->clear();
    QTest::keyClicks(find, "no such word");
    QVERIFY(!page->textCursor().hasSelection());
    QVERIFY(find->palette().color(QPalette::Text) != help->palette().color(QPalette::Text));
    QVERIFY(first > 0);
  }

  void f1_in_the_scene_and_in_the_bar_of_the_time_differ() {
    Bench bench;
    const gui::HelpWindow* help = bench.help_in(&bench.window.scene().scene());
    QVERIFY(help != nullptr);
    QCOMPARE(help->heading(), QString("Mouse and keys in the scene"));
    QVERIFY(bench.help_in(bench.window.scene().time_bar().findChild<QLineEdit*>("time_field")) == help);
    QCOMPARE(help->heading(), QString("Time"));
  }

  void f1_asks_the_browser_for_the_page_of_the_site_that_has_the_keyboard() {
    Site site({"index.html", "guide/workbench.html"});
    Bench bench;
    bench.window.set_guide(site.guide(true));
    QVERIFY(bench.help_in(&bench.window.scene().scene()) == nullptr);
    QCOMPARE(site.asked, site.address("guide/workbench.html", "mouse-and-keys-in-the-scene"));
    bench.window.findChild<QAction*>("help_contents")->trigger();
    QCOMPARE(site.asked, site.address("index.html", ""));
  }

  void without_a_page_or_a_browser_f1_opens_a_window_of_the_program() {
    Site site({"guide/workbench.html"});
    Bench bench;
    bench.window.set_guide(site.guide(false));
    const gui::HelpWindow* help = bench.help_in(&bench.window.scene().scene());
    QVERIFY(help != nullptr);
    QCOMPARE(site.asked, site.address("guide/workbench.html", "mouse-and-keys-in-the-scene"));
    site.asked.clear();
    bench.window.findChild<QAction*>("help_contents")->trigger();
    QVERIFY2(site.asked.isEmpty(), "the site has no index.html");
    QCOMPARE(Bench::page(*help), QString("README.md"));
  }

  void the_site_is_found_where_it_is_installed_and_where_it_is_built() {
    const QTemporaryDir root;
    const auto folder_with_index = [&](const QString& place) {
      QDir(root.path()).mkpath(place);
      QVERIFY(QFile(root.filePath(place + "/index.html")).open(QIODevice::WriteOnly));
    };
    QDir(root.path()).mkpath("bin");
    QCOMPARE(gui::GuideSite::folder_beside(root.filePath("bin")), QString());
    folder_with_index("site");
    QCOMPARE(gui::GuideSite::folder_beside(root.filePath("bin")), root.filePath("site"));
    folder_with_index("share/doc/sarsim/html");
    QCOMPARE(gui::GuideSite::folder_beside(root.filePath("bin")), root.filePath("share/doc/sarsim/html"));
  }

  // A modal dialog holds up all windows but its own.
  void the_help_of_a_modal_dialog_can_be_used_while_it_is_open() {
    Bench bench;
    QWidget* editor = bench.window.window_named("function");
    QVERIFY(editor != nullptr);
    static_cast<QDialog*>(editor)->open();
    QCoreApplication::processEvents();
    gui::HelpWindow* help = bench.help_in(editor->findChild<QPushButton*>());
    QVERIFY(help != nullptr);
    QVERIFY(help->parentWidget() == editor);
    auto* close = help->findChild<QPushButton*>();
    QVERIFY(close != nullptr);
    QTest::keyClick(help, Qt::Key_Escape);
    QVERIFY(!help->isVisible());
    QVERIFY(editor->isVisible());
  }

  void links_lead_to_pages_and_folders_and_back() {
    gui::HelpWindow help;
    help.show();
    help.show_page("README.md");
    auto* browser = help.findChild<QTextBrowser*>();
    emit browser->anchorClicked(QUrl("guide"));
    QVERIFY(browser->toPlainText().contains("workbench.md"));
    QUrl values = QUrl::fromLocalFile(gui::HelpWindow::folder() + "/guide/workbench.md");
    values.setFragment("values");
    emit browser->anchorClicked(values);
    QCOMPARE(Bench::page(help), QString("guide/workbench.md"));
    QCOMPARE(help.heading(), QString("Values"));
  }

  void space_plays_and_stops_the_time_in_the_scene() {
    Bench bench;
    gui::SceneWidget& scene = bench.window.scene().scene();
    const gui::TimeBar& bar = bench.window.scene().time_bar();
    scene.setFocus();
    QTest::keyClick(&scene, Qt::Key_Space);
    QVERIFY(bar.playing());
    const double begun_s = bench.window.session().time_s();
    QTRY_VERIFY(bench.window.session().time_s() > begun_s);
    QTest::keyClick(&scene, Qt::Key_Space);
    QVERIFY(!bar.playing());
    QTest::keyClick(&scene, Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(!bar.playing());
  }

  void space_in_a_field_is_a_space() {
    Bench bench;
    auto* field = bench.window.findChild<gui::PropertyPanel*>()->findChild<QLineEdit*>("field_position_m.x");
    field->setFocus();
    field->setText("1");
    QTest::keyClick(field, Qt::Key_Space);
    QCOMPARE(field->text(), QString("1 "));
    QVERIFY(!bench.window.scene().time_bar().playing());
  }
};

const test::AddTest added("help_test", test::run_test<HelpTest>);

}  // namespace sarsim::help_test

#include "help_test.moc"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QtTest>

#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/function_editor.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/objects/property_panel.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"

namespace sarsim::keys_test {

namespace {

struct Bench {
  Bench() {
    if (!window.documents().open_file(QStringLiteral(SARSIM_SOURCE_DIR "/examples/sar_r.scr"))) qFatal("not opened");
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) qFatal("not shown");
    window.activateWindow();
    QCoreApplication::processEvents();
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &window, key, modifiers);
  }
  template <class Panel>
  [[nodiscard]] bool keyboard_in() {
    const auto* panel = window.findChild<Panel*>();
    const QWidget* now = QApplication::focusWidget();
    return now != nullptr && (panel == now || panel->isAncestorOf(now));
  }
  [[nodiscard]] double x() { return window.session().scene().targets[0].position_m.x; }

  gui::MainWindow window;
};

// Letters that Alt takes to a widget of a window, each with the texts that claim it.
QMap<QString, QStringList> letters_of(const QWidget& window) {
  QMap<QString, QStringList> claims;
  const auto claim = [&](const QString& text) {
    const QKeySequence letter = QKeySequence::mnemonic(text);
    if (!letter.isEmpty()) claims[letter.toString()] += text;
  };
  for (const auto* button : window.findChildren<QAbstractButton*>())
    if (button->window() == &window && button->isVisible() && !button->visibleRegion().isEmpty()) claim(button->text());
  for (const auto* label : window.findChildren<QLabel*>())
    if (label->window() == &window && label->isVisible() && label->buddy() != nullptr) claim(label->text());
  if (const auto* main = qobject_cast<const QMainWindow*>(&window))
    for (const QAction* menu : main->menuBar()->actions()) claim(menu->text());
  return claims;
}

}  // namespace

class KeysTest : public QObject {
  Q_OBJECT

 private slots:
  void f6_takes_the_keyboard_from_panel_to_panel_and_back() {
    Bench bench;
    bench.window.scene().scene().setFocus();
    bench.press(Qt::Key_F6);
    QVERIFY(bench.keyboard_in<gui::StoredSimulations>());  // and not in the script, which lies behind it
    bench.press(Qt::Key_F6);
    QVERIFY(bench.keyboard_in<gui::PropertyPanel>());
    bench.press(Qt::Key_F6);
    QVERIFY(bench.keyboard_in<gui::ObjectTree>());
    bench.press(Qt::Key_F6);
    QVERIFY(bench.window.scene().scene().hasFocus());
    bench.press(Qt::Key_F6, Qt::ShiftModifier);
    QVERIFY(bench.keyboard_in<gui::ObjectTree>());
  }

  void delete_in_the_scene_deletes_the_selected_objects_in_one_step() {
    Bench bench;
    const scene::Scene before = bench.window.session().scene();
    bench.window.scene().scene().setFocus();
    bench.window.session().select({{scene::ObjectKind::target, 0}, {scene::ObjectKind::target, 2}});
    bench.press(Qt::Key_Delete);
    QCOMPARE(bench.window.session().scene().targets.size(), before.targets.size() - 2);
    QVERIFY(bench.window.session().scene().targets[0] == before.targets[1]);
    bench.window.session().undo();
    QVERIFY(bench.window.session().scene() == before);
  }

  // Switch and menu entry both follow the tool, which goes back at once.
  void a_path_that_cannot_be_drawn_leaves_no_tool_behind() {
    Bench bench;
    bench.window.session().select({});
    bench.window.scene().scene().setFocus();
    bench.press(Qt::Key_P);
    QVERIFY(bench.window.scene().scene().tool() == gui::SceneWidget::Tool::hand);
    QVERIFY(!bench.window.findChild<QAction*>("view_draw_path")->isChecked());
    bench.window.findChild<QAction*>("view_measure")->trigger();
    QVERIFY(bench.window.scene().scene().tool() == gui::SceneWidget::Tool::ruler);
    QVERIFY(bench.window.findChild<QAbstractButton*>("camera_measure")->isChecked());
    bench.press(Qt::Key_Escape);
    QVERIFY(!bench.window.findChild<QAction*>("view_measure")->isChecked());
  }

  // Of two that have the same letter Alt opens neither.
  void no_letter_of_a_window_is_claimed_twice() {
    Bench bench;
    QVERIFY(letters_of(bench.window).contains("Alt+F"));  // of a menu
    QVERIFY(letters_of(bench.window).contains("Alt+N"));  // of a button
    QStringList clashes;
    for (const QString& name : gui::MainWindow::window_names()) {
      QWidget* window = bench.window.window_named(name)->window();
      window->show();
      QCoreApplication::processEvents();
      for (const auto& [letter, texts] : letters_of(*window).asKeyValueRange())
        if (texts.size() > 1) clashes += name + ": " + texts.join(", ");
    }
    QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join('\n')));
  }

  void the_functions_of_an_object_open_from_the_menu() {
    Bench bench;
    auto* menu = bench.window.findChild<QMenu*>("edit_functions");
    QVERIFY(!menu->isEnabled());
    std::size_t moving = 0;
    const std::vector<scene::Platform>& platforms = bench.window.session().scene().platforms;
    while (moving < platforms.size() && platforms[moving].path != scene::Platform::Path::trajectory) ++moving;
    QVERIFY(moving < platforms.size());
    bench.window.session().select_only({scene::ObjectKind::platform, moving});
    QVERIFY(menu->isEnabled());
    QCOMPARE(menu->actions().size(), qsizetype{1});
    menu->actions()[0]->trigger();
    auto* editor = bench.window.findChild<gui::FunctionEditor*>();
    QVERIFY(editor != nullptr && editor->isVisible());
    editor->reject();
    bench.window.session().select_only({scene::ObjectKind::target, 0});
    QVERIFY(!menu->isEnabled());
  }

  void undo_in_a_field_is_of_its_typing_first_and_of_the_scene_then() {
    Bench bench;
    const double before = bench.x();
    bench.window.session().select_only({scene::ObjectKind::target, 0});
    auto* field = bench.window.findChild<gui::PropertyPanel*>()->findChild<QLineEdit*>("field_position_m.x");
    const QString shown = field->text();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "77");
    bench.press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(field->text(), shown);
    QCOMPARE(bench.x(), before);
    field->selectAll();
    QTest::keyClicks(field, "77");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(bench.x(), 77.0);
    bench.press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.x(), before);
    QCOMPARE(field->text(), shown);
    QVERIFY(!bench.window.isWindowModified());
    bench.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(bench.x(), 77.0);
  }
};

const test::AddTest added("keys_test", test::run_test<KeysTest>);

}  // namespace sarsim::keys_test

#include "keys_test.moc"

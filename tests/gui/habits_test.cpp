// What every window keeps to: names for screen readers and scripts, an order of Tab, keys that mean one thing.

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QtTest>

#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/frame/pictures.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/object_tree.hpp"
#include "harbour.hpp"

namespace sarsim::habits_test {

namespace {

// Parts that Qt makes of its own accord within a widget that has a name.
bool is_part(const QWidget& widget) {
  if (widget.objectName().startsWith("qt_")) return true;
  if (qobject_cast<const QHeaderView*>(&widget) != nullptr || qobject_cast<const QTabBar*>(&widget) != nullptr)
    return true;
  const QWidget* parent = widget.parentWidget();
  if (parent == nullptr) return false;
  return qobject_cast<const QComboBox*>(parent) != nullptr || parent->inherits("QAbstractSpinBox") ||
         parent->inherits("QDialogButtonBox") || parent->inherits("QToolBar") || parent->inherits("QMenuBar") ||
         parent->inherits("QDockWidget") || widget.inherits("QMenu") || parent->inherits("QLineEdit") ||
         parent->inherits("QComboBoxPrivateContainer") || parent->inherits("QTableView");
}

bool takes_keys(const QWidget& widget) {
  if (qobject_cast<const QLabel*>(&widget) != nullptr) return false;  // Its text is its name.
  return widget.focusPolicy() != Qt::NoFocus && widget.focusProxy() == nullptr && !is_part(widget);
}

QString spoken_name(const QWidget& widget) {
  if (!widget.accessibleName().isEmpty()) return widget.accessibleName();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  return {};
}

QString path_of(const QWidget& widget) {
  QStringList parts;
  for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget())
    parts.prepend(at->objectName().isEmpty() ? QString(at->metaObject()->className()) : at->objectName());
  return parts.join('/');
}

QStringList nameless(QWidget& window) {
  QStringList found;
  QList<QWidget*> widgets = window.findChildren<QWidget*>();
  widgets.append(&window);
  for (const QWidget* widget : widgets) {
    if (!takes_keys(*widget)) continue;
    if (widget->objectName().isEmpty()) found += path_of(*widget) + " has no object name";
    if (spoken_name(*widget).isEmpty()) found += path_of(*widget) + " has no accessible name";
  }
  return found;
}

}  // namespace

class HabitsTest : public QObject {
  Q_OBJECT

 private:
  QString harbour() const { return test::small_harbour(folder_.path()); }
  // Actions that a menu shows, with the menus below it.
  static void collect(const QMenu& menu, QList<QAction*>& actions) {
    for (QAction* action : menu.actions()) {
      if (action->menu() != nullptr)
        collect(*action->menu(), actions);
      else if (!action->isSeparator())
        actions.append(action);
    }
  }
  static QList<QAction*> menu_actions(const gui::MainWindow& window) {
    QList<QAction*> actions;
    for (const QAction* top : window.menuBar()->actions()) collect(*top->menu(), actions);
    return actions;
  }

 private slots:
  void the_walk_finds_a_field_without_names() {
    QWidget window;
    auto* field = new QLineEdit(&window);
    QCOMPARE(nameless(window).size(), 2);
    field->setObjectName("field");
    QCOMPARE(nameless(window).size(), 1);
    field->setAccessibleName("Field");
    QVERIFY(nameless(window).isEmpty());
  }

  void whatever_takes_keys_has_an_object_name_and_a_spoken_name() {
    gui::MainWindow main;
    QVERIFY(main.documents().open_file(harbour()));
    main.show();
    QStringList found;
    for (const QString& name : gui::MainWindow::window_names()) {
      QWidget* window = main.window_named(name);
      QVERIFY2(window != nullptr, qPrintable(name));
      found += nameless(*window);
    }
    for (const scene::ObjectId id :
         {scene::ObjectId{scene::ObjectKind::platform, 1}, scene::ObjectId{scene::ObjectKind::target, 2},
          scene::ObjectId{scene::ObjectKind::surface, 0}, scene::ObjectId{scene::ObjectKind::radar, 0},
          scene::ObjectId{scene::ObjectKind::radar, 1}, scene::ObjectId{scene::ObjectKind::simulation, 0},
          scene::ObjectId{scene::ObjectKind::geometry, 0}}) {
      main.session().select_only(id);
      found += nameless(*main.window_named("properties"));
    }
    found.removeDuplicates();
    QVERIFY2(found.isEmpty(), qPrintable('\n' + found.join('\n')));
  }

  void tab_reaches_every_field_of_a_window() {
    gui::MainWindow main;
    QVERIFY(main.documents().open_file(harbour()));
    main.show();
    main.session().select_only({scene::ObjectKind::radar, 0});
    QStringList unreached;
    for (const char* name : {"main", "targets", "geometry", "function", "import", "commands", "help"}) {
      QWidget* window = main.window_named(name);
      window->show();
      QSet<QWidget*> reached;
      QWidget* at = window;
      do {
        at = at->nextInFocusChain();
        reached.insert(at);
      } while (at != window && reached.size() < 10000);
      QCOMPARE(at, window);
      for (QWidget* widget : window->findChildren<QWidget*>())
        if (widget->window() == window && takes_keys(*widget) && !reached.contains(widget))
          unreached += path_of(*widget);
    }
    QVERIFY2(unreached.isEmpty(), qPrintable(unreached.join('\n')));
  }

  void no_two_commands_have_the_same_keys() {
    gui::MainWindow main;
    QMap<QString, QStringList> of_keys;
    for (const QAction* action : main.findChildren<QAction*>())
      if (action->shortcutContext() != Qt::WidgetShortcut &&
          action->shortcutContext() != Qt::WidgetWithChildrenShortcut)
        for (const QKeySequence& keys : action->shortcuts()) of_keys[keys.toString()] += action->objectName();
    QVERIFY(of_keys.contains("F1"));
    QVERIFY(of_keys.contains("F5"));
    for (const auto& [keys, names] : of_keys.asKeyValueRange())
      QVERIFY2(names.size() == 1, qPrintable(keys + ": " + names.join(' ')));
  }

  void no_two_entries_of_a_menu_have_the_same_letter() {
    gui::MainWindow main;
    QVERIFY(main.documents().open_file(harbour()));
    QList<QPair<QString, QList<QAction*>>> menus{{"menu bar", main.menuBar()->actions()}};
    for (const QMenu* menu : main.menuBar()->findChildren<QMenu*>()) menus.append({menu->title(), menu->actions()});
    QStringList clashes;
    for (const auto& [title, actions] : menus) {
      QMap<QString, QString> of_letter;
      for (const QAction* action : actions) {
        const QKeySequence letter = QKeySequence::mnemonic(action->text());
        if (letter.isEmpty() || action->isSeparator()) continue;
        QString& owner = of_letter[letter.toString()];
        if (!owner.isEmpty()) clashes += title + ": " + owner + " and " + action->text();
        owner = action->text();
      }
    }
    QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join('\n')));
  }

  // Those without keys of their own are found by their names.
  void every_command_has_keys_or_is_in_the_list_of_commands() {
    gui::MainWindow main;
    QVERIFY(main.documents().open_file(harbour()));
    const auto listed = main.findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly);
    QStringList lost;
    for (QAction* action : menu_actions(main)) {
      const bool file = action->text().endsWith(".scr") || action->text().endsWith(".toml");
      const bool panel = action->parent() != nullptr && action->parent()->inherits("QDockWidget");
      if (!file && !panel && action->shortcut().isEmpty() && !listed.contains(action)) lost += action->text();
    }
    QVERIFY2(lost.isEmpty(), qPrintable(lost.join('\n')));
  }

  void menus_bear_the_names_of_the_thesis() {
    gui::MainWindow main;
    QStringList names;
    for (const QAction* action : main.menuBar()->actions()) names += action->text().remove('&');
    int last = -1;
    for (const char* name : {"File", "Geometry", "Simulation", "Display", "View", "Help"}) {
      const auto at = static_cast<int>(names.indexOf(name));
      QVERIFY2(at > last, name);
      last = at;
    }
  }

  void names_of_pictures_are_windows_and_menus_that_exist() {
    gui::MainWindow main;
    QVERIFY(main.documents().open_file(harbour()));
    main.show();
    const QStringList names = gui::picture_names();
    QCOMPARE(QSet<QString>(names.begin(), names.end()).size(), names.size());
    for (const QString& name : gui::MainWindow::window_names()) QVERIFY2(names.contains(name), qPrintable(name));
    for (const QAction* menu : main.menuBar()->actions())
      QVERIFY2(names.contains("menu-" + menu->text().remove('&').toLower()), qPrintable(menu->text()));
  }

  void a_picture_is_written_in_the_size_and_state_asked_for() {
    QTemporaryDir folder;
    gui::MainWindow main;
    QVERIFY(main.documents().open_file(harbour()));
    gui::PictureRequest wish;
    wish.window = "targets";
    wish.file = folder.filePath("picture.png");
    wish.selected = {"radar:2"};
    wish.typed = {"prf_hz=2 kHz"};
    wish.size = {1300, 720};
    wish.few_colours = true;
    main.session().select_only({scene::ObjectKind::radar, 0});
    QVERIFY(!gui::make_picture(main, wish));  // radar 2 has intervals instead of a frequency
    wish.selected = {"radar:1"};
    wish.commands = {"view_filled"};
    QVERIFY(gui::make_picture(main, wish));
    const QImage picture(wish.file);
    QCOMPARE(picture.size(), wish.size);
    QVERIFY(picture.colorCount() > 16 && picture.colorCount() <= 256);
    QCOMPARE(main.session().scene().radars[0].prf_hz, 2000.0);
    QVERIFY(main.findChild<QAction*>("view_filled")->isChecked());
  }

  void a_picture_of_nothing_is_refused() {
    QTemporaryDir folder;
    gui::MainWindow main;
    gui::PictureRequest wish;
    wish.file = folder.filePath("picture.png");
    wish.window = "mirror";
    QVERIFY(!gui::make_picture(main, wish));
    wish = {};
    wish.file = folder.filePath("picture.png");
    wish.selected = {"radar:1"};
    QVERIFY(!gui::make_picture(main, wish));
    wish.selected = {};
    wish.commands = {"view_nothing"};
    QVERIFY(!gui::make_picture(main, wish));
    wish.commands = {};
    wish.file = folder.filePath("no/such/folder.png");
    QVERIFY(!gui::make_picture(main, wish));
    QVERIFY(QDir(folder.path()).isEmpty());
  }

 private:
  QTemporaryDir folder_;
};

const test::AddTest added("habits_test", test::run_test<HabitsTest>);

}  // namespace sarsim::habits_test

#include "habits_test.moc"

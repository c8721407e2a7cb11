#include "gui/frame/pictures.hpp"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QEventLoop>
#include <QFileInfo>
#include <QImage>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPixmap>
#include <QSaveFile>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/live/live_panel.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"

namespace sarsim::gui {

namespace {

constexpr int settling_ms = 700;          // work in the background and layouts end within it
constexpr int longest_image_ms = 10'000;  // the live image, which may take more
constexpr int max_colours = 256;

const QString menu_prefix = QStringLiteral("menu-");

// Dialogs that stay open until they are answered: the action that opens them.
const std::map<QString, const char*>& dialog_actions() {
  static const std::map<QString, const char*> actions{{"about", "help_about"}, {"focus", "view_focus"}};
  return actions;
}

bool complain(const QString& text) {
  std::fprintf(stderr, "sarsim-gui: %s\n", qPrintable(text));
  return false;
}

bool select_objects(MainWindow& main, const QStringList& texts) {
  std::set<scene::ObjectId> ids;
  for (const QString& text : texts) {
    const QStringList parts = text.split(':');
    const auto kind = scene::kind_called(parts.first().toStdString());
    const std::size_t number = parts.size() == 2 ? parts[1].toULongLong() : 0;
    if (!kind || number == 0 || !scene::has_object(main.session().scene(), {*kind, number - 1}))
      return complain(QStringLiteral("no object '%1'; the first radar is radar:1").arg(text));
    ids.insert({*kind, number - 1});
  }
  if (!ids.empty()) main.session().select(ids);
  return true;
}

bool trigger(MainWindow& main, const QString& name) {
  auto* action = main.findChild<QAction*>(name);
  if (action == nullptr) return complain(QStringLiteral("no command '%1'").arg(name));
  action->trigger();
  return true;
}

void press(QWidget& widget, int key, const QString& text = {}) {
  for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
    QKeyEvent event(type, key, Qt::NoModifier, text);
    QApplication::sendEvent(&widget, &event);
  }
}

// Types as a user does, and ends with Enter.
bool type_into(MainWindow& main, const QString& wish) {
  const QString id = wish.section('=', 0, 0);
  auto* widget = main.findChild<QWidget*>("field_" + id);
  auto* line = qobject_cast<QLineEdit*>(widget);
  if (line == nullptr && widget != nullptr) line = widget->findChild<QLineEdit*>();
  if (line == nullptr || !line->isVisible()) return complain(QStringLiteral("no field '%1' to type into").arg(id));
  line->setFocus();
  line->selectAll();
  for (const QChar letter : wish.section('=', 1)) press(*line, 0, letter);
  press(*line, Qt::Key_Return);
  return true;
}

QMenu* menu_named(MainWindow& main, const QString& name) {
  if (name == "object") {
    auto* tree = main.findChild<ObjectTree*>();
    QMenu* menu = tree == nullptr ? nullptr : tree->context_menu().release();
    if (menu != nullptr) menu->setParent(&main, menu->windowFlags());
    return menu;
  }
  for (const QAction* action : main.menuBar()->actions())
    if (action->text().remove('&').toLower() == name) return action->menu();
  return nullptr;
}

// The window of a wish, or null after a complaint. Dialogs that wait for an answer open a moment later.
QWidget* shown_window(MainWindow& main, const QString& name) {
  if (name.startsWith(menu_prefix)) {
    QMenu* menu = menu_named(main, name.mid(menu_prefix.size()));
    if (menu != nullptr) menu->popup(main.mapToGlobal(QPoint(10, 10)));
    return menu;
  }
  if (name == "unsaved") {
    trigger(main, "new_target");
    QTimer::singleShot(0, &main, [&main] { main.documents().may_close(); });
    return &main;
  }
  if (const auto found = dialog_actions().find(name); found != dialog_actions().end()) {
    QTimer::singleShot(0, &main, [&main, action = found->second] { trigger(main, action); });
    return &main;
  }
  QWidget* window = main.window_named(name);
  if (window != nullptr) window->show();
  return window;
}

// What a wish that names no window is about: the file that is shown.
QString window_of(MainWindow& main, const PictureRequest& wish) {
  if (!wish.window.isEmpty()) return wish.window;
  return main.image_viewers().viewers().empty() ? QStringLiteral("main") : QStringLiteral("viewer");
}

// The most frequent colour of every corner of the colour cube, so that no hue is lost, then the most frequent others;
// what is left becomes the nearest of them.
QImage with_few_colours(const QImage& picture) {
  std::map<QRgb, int> counts;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) ++counts[picture.pixel(x, y)];
  std::vector<std::pair<int, QRgb>> frequent;
  frequent.reserve(counts.size());
  for (const auto& [colour, count] : counts) frequent.emplace_back(count, colour);
  std::ranges::sort(frequent, std::ranges::greater{});
  const auto corner_of = [](QRgb colour) { return colour & 0xe0e0e0U; };
  std::set<QRgb> corners;
  QList<QRgb> table;
  for (const bool first_of_corner : {true, false})
    for (const auto& [count, colour] : frequent)
      if (table.size() < max_colours && corners.insert(corner_of(colour)).second == first_of_corner &&
          !table.contains(colour))
        table.append(colour);
  return picture.convertToFormat(QImage::Format_Indexed8, table, Qt::ThresholdDither | Qt::AvoidDither);
}

bool write_picture(QWidget& window, const PictureRequest& wish) {
  QImage picture = window.grab().toImage();
  if (wish.few_colours) picture = with_few_colours(picture.convertToFormat(QImage::Format_RGB32));
  constexpr int smallest_file = 0;  // quality of PNG: how hard it is packed
  QSaveFile file(wish.file);        // What is cut short leaves nothing, or what was there.
  if (file.open(QIODevice::WriteOnly) && picture.save(&file, "PNG", smallest_file) && file.commit()) return true;
  return complain(QStringLiteral("'%1' could not be written: %2").arg(wish.file, file.errorString()));
}

}  // namespace

QStringList picture_names() {
  QStringList names = MainWindow::window_names();
  for (const auto& [name, action] : dialog_actions()) names += name;
  names += "unsaved";
  for (const char* menu : {"file", "edit", "geometry", "simulation", "display", "view", "help", "object"})
    names += menu_prefix + menu;
  return names;
}

QString wrong_with_picture_name(const QString& file, const QStringList& shown) {
  // Two names of one file are found out, too.
  const auto is_it = [&](const QString& other) {
    std::error_code none;
    return std::filesystem::equivalent(file.toStdString(), other.toStdString(), none);
  };
  if (std::ranges::any_of(shown, is_it))
    return QStringLiteral("'%1' is the file that is shown: a picture would replace it").arg(file);
  if (QFileInfo(file).suffix().compare("png", Qt::CaseInsensitive) != 0)
    return QStringLiteral("'%1': pictures of windows are written as .png").arg(file);
  return {};
}

// An image that is seen belongs to the scene.
void wait_for_image(MainWindow& main) {
  auto* const panel = main.findChild<LivePanel*>();
  if (panel == nullptr || !panel->isVisible() || panel->complete()) return;
  QEventLoop until_shown;
  QObject::connect(panel, &LivePanel::finished, &until_shown, &QEventLoop::quit);
  QTimer::singleShot(longest_image_ms, &until_shown, &QEventLoop::quit);
  until_shown.exec();
}

bool make_picture(MainWindow& main, const PictureRequest& wish) {
  if (!wish.size.isEmpty()) main.resize(wish.size);
  main.show();
  QApplication::processEvents();  // The docks take their sizes.
  if (!select_objects(main, wish.selected)) return false;
  for (const QString& command : wish.commands)
    if (!trigger(main, command)) return false;
  for (const QString& text : wish.typed)
    if (!type_into(main, text)) return false;
  QApplication::processEvents();
  if (!wish.size.isEmpty()) main.resize(wish.size);  // Where a command has closed a panel it may be smaller now.
  const QString name = window_of(main, wish);
  QWidget* window = shown_window(main, name);
  if (window == nullptr) return complain(QStringLiteral("no window '%1' for this script").arg(name));
  if (!wish.size.isEmpty() && window->isWindow()) window->resize(wish.size);
  bool good = false;
  QTimer::singleShot(settling_ms / 2, &main, [&main, &wish] {
    main.scene().scene().fit();
    // What a command was to show is shown in the window's size.
    for (const char* command : {"view_zoom_selection", "view_focus_selection", "view_beam"})
      if (wish.commands.contains(QLatin1String(command))) main.findChild<QAction*>(QLatin1String(command))->trigger();
  });
  QTimer::singleShot(settling_ms, &main, [&] {
    wait_for_image(main);
    QWidget* modal = QApplication::activeModalWidget();
    good = write_picture(modal != nullptr ? *modal : *window, wish);
    QCoreApplication::exit();  // Not quit: that would close windows, which ask.
  });
  QCoreApplication::exec();
  return good;
}

}  // namespace sarsim::gui

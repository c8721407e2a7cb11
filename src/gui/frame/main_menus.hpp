#pragma once

#include <QKeySequence>
#include <QObject>
#include <QString>

#include <functional>

#include "gui/common/appearance.hpp"
#include "gui/frame/workbench.hpp"
#include "picture/scene/drawing.hpp"
#include "scene/model/object.hpp"

class QAction;
class QMainWindow;
class QMenu;

namespace sarsim::gui {

class LayoutKeeper;
class ToolWindows;

/// The menus and the tool bar of the main window, in the words of the thesis. What concerns a part of the workbench
/// they do; for the rest they send signals.
class MainMenus : public QObject {
  Q_OBJECT

 public:
  /// Makes them, with all actions below the window.
  MainMenus(const Workbench& parts, ToolWindows& tools, LayoutKeeper& layouts, QMainWindow& window);

 signals:
  void file_wanted(const QString& path);                                   ///< A recent file is to be opened.
  void close_wanted();                                                     ///< What is in front is to be closed.
  void document_step_wanted(int step);                                     ///< The next document, or the one before.
  void object_wanted(const sarsim::scene::AnyObject& object);              ///< Something new for the scene.
  void edit_wanted(sarsim::scene::ObjectId id);                            ///< Its properties are to be edited.
  void function_wanted(sarsim::scene::ObjectId id, const QString& field);  ///< So is one of its functions.
  void appearance_wanted(sarsim::gui::Appearance appearance);              ///< Other colours.
  void panel_step_wanted(int step);  ///< The keyboard is to go to the next panel, or the one before.
  void search_wanted();              ///< The box over all that can be found.
  void welcome_wanted();             ///< The page of the beginning.
  void tour_wanted();                ///< The example, step by step.

 private:
  void make_menus();
  void make_file_menu();
  void make_example_menu(QMenu* examples);
  void make_edit_menu();
  void make_geometry_menu();
  void make_simulation_menu();
  void make_view_menu();
  void make_hand_entries(QMenu* view);
  void make_track_menu(QMenu* menu);
  void make_help_menu();
  void make_tool_bar();
  QAction* add_action(QMenu* menu, const QString& text, const char* name, const QKeySequence& keys,
                      const std::function<void()>& work, const QString& tip = QString());
  void add_switch(QMenu* menu, const QString& text, const char* name, bool picture::DrawingOptions::*option);
  void fill_recent();
  void fill_functions(QMenu* menu);
  void give_icons();

  const Workbench parts_;
  ToolWindows& tools_;
  LayoutKeeper& layouts_;
  QMainWindow& window_;
  QMenu* recent_ = nullptr;
};

}  // namespace sarsim::gui

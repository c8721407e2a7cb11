#pragma once

#include <QSize>
#include <QStringList>

namespace sarsim::gui {

class MainWindow;

/// What a picture of the workbench is to show.
struct PictureRequest {
  QString window;            ///< One of picture_names(); empty: the viewer of a file of samples, else the main one.
  QString file;              ///< PNG file that is written.
  QStringList selected;      ///< Objects by kind and number from 1: "radar:2".
  QStringList commands;      ///< Object names of actions that are triggered first: "view_filled".
  QStringList typed;         ///< Fields of the property panel and what is typed there: "width=3 us".
  QSize size;                ///< Of the window in pixels of the screen; empty: its own.
  bool few_colours = false;  ///< At most 256 of them, for a small file.
};

/// Windows and states that can be made into a picture: those of MainWindow::window_names(), the small dialogs (about,
/// focus, unsaved) and the menus (menu-file, ..., menu-object).
[[nodiscard]] QStringList picture_names();

/// What keeps a picture from being written to `file`, or nothing: only PNG is written, and never over the file that is
/// shown.
/// @param shown  the script or the file of samples; may be empty
[[nodiscard]] QString wrong_with_picture_name(const QString& file, const QStringList& shown);

/// Brings a window into the wanted state, lets work in the background end and writes the picture. Runs the event loop.
/// Complaints go to standard error.
/// @return  true where the picture was written
[[nodiscard]] bool make_picture(MainWindow& main, const PictureRequest& wish);

}  // namespace sarsim::gui

#pragma once

#include <QIcon>
#include <QPixmap>
#include <QString>
#include <QStringList>

namespace sarsim::gui {

/// One of the workbench's own icons, in the colour of the text around it: it follows light and dark by itself, and is
/// drawn as lines at any size.
/// @param name  of a file in src/gui/icons, without its ending; another name gives an empty icon
[[nodiscard]] QIcon icon_of(const QString& name);

/// The names that `icon_of` knows.
[[nodiscard]] QStringList icon_names();

/// The icon of the program, as the desktop shows it.
[[nodiscard]] QIcon program_icon();

/// A picture of the gallery that the program carries; null for another name.
/// @param name  of its file, without the ending: "figure_7_2"
[[nodiscard]] QPixmap gallery_picture(const QString& name);

}  // namespace sarsim::gui

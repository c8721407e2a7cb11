#pragma once

#include <QPalette>

class QApplication;
class QStyle;

namespace sarsim::gui {

/// Light, dark, or as the desktop has it (Qt 6.4 tells no more than its palette).
enum class Appearance { system, light, dark };

/// The palette of the workbench's own light or dark colours: text on window and base at more than 7 : 1.
[[nodiscard]] QPalette palette_of(bool dark);

/// The style of the workbench: Fusion, whose rims of fields, check boxes and radio buttons vanish in dark colours, with
/// rims there that stand out 3 : 1 (WCAG 2.1, 1.4.11).
[[nodiscard]] QStyle* make_style();

/// Gives the application the colours; `system` puts back those it started with.
void set_appearance(QApplication& application, Appearance appearance);

}  // namespace sarsim::gui

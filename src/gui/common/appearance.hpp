#pragma once

#include <QColor>
#include <QPalette>

class QApplication;
class QStyle;

namespace sarsim::gui {

/// Light, dark, or as the desktop has it (Qt 6.4 tells no more than its palette).
enum class Appearance { system, light, dark };

/// The palette of the workbench's own light or dark colours: text stands out 4.5 : 1 and more wherever it is (WCAG 2.1,
/// 1.4.3), also of links, of hints in empty fields and of what is selected.
[[nodiscard]] QPalette palette_of(bool dark);

/// The rim of fields and buttons, which stands out 3 : 1 where they can be used (WCAG 2.1, 1.4.11).
[[nodiscard]] QColor rim_of(const QPalette& palette, bool enabled);

/// A property of buttons in a tool bar, true for those that the window is for: they stand out.
inline constexpr char primary_property[] = "primary";

/// The style of the workbench: Fusion, with rims of fields and buttons that stand out, groups of fields below a title
/// and a line in place of a frame, and the button that Enter presses in the colour of what is selected.
[[nodiscard]] QStyle* make_style();

/// Gives the application the colours; `system` puts back those it started with.
void set_appearance(QApplication& application, Appearance appearance);

}  // namespace sarsim::gui

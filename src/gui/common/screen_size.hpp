#pragma once

#include <QSize>

class QWidget;

namespace sarsim::gui {

/// A size that a window may have at most on the screen of a widget: what is wanted, but no more than nine tenths of
/// what the screen has room for.
[[nodiscard]] QSize size_on_screen(const QWidget& widget, QSize wanted);

}  // namespace sarsim::gui

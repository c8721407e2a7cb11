#include "gui/common/screen_size.hpp"

#include <QScreen>
#include <QWidget>

namespace sarsim::gui {

QSize size_on_screen(const QWidget& widget, QSize wanted) {
  const QScreen* const screen = widget.screen();
  if (screen == nullptr) return wanted;
  return wanted.boundedTo(screen->availableGeometry().size() * 9 / 10);
}

}  // namespace sarsim::gui

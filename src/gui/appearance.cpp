#include "gui/appearance.hpp"

#include <QApplication>
#include <QStyle>

namespace sarsim {

namespace {

struct Tones {
  QColor window, base, alternate, text, faint, button, highlight, highlighted, link;
};

constexpr QRgb rgb(unsigned value) { return 0xff000000U | value; }

Tones tones_of(bool dark) {
  if (dark)
    return {QColor(rgb(0x2b2d30)), QColor(rgb(0x1e1f22)), QColor(rgb(0x26282b)),
            QColor(rgb(0xe4e6e8)), QColor(rgb(0x9ea2a6)), QColor(rgb(0x3a3d41)),
            QColor(rgb(0x2f65a5)), QColor(rgb(0xffffff)), QColor(rgb(0x7ab8ff))};
  return {QColor(rgb(0xf1f2f4)), QColor(rgb(0xffffff)), QColor(rgb(0xf6f7f9)),
          QColor(rgb(0x1b1d20)), QColor(rgb(0x5f6368)), QColor(rgb(0xe4e6ea)),
          QColor(rgb(0x2f65a5)), QColor(rgb(0xffffff)), QColor(rgb(0x0b57b5))};
}

}  // namespace

QPalette palette_of(bool dark) {
  const Tones t = tones_of(dark);
  QPalette palette(t.text, t.button, dark ? t.button.lighter(130) : QColor(Qt::white), t.window.darker(160),
                   t.window.darker(130), t.text, QColor(Qt::white), t.base, t.window);
  palette.setColor(QPalette::AlternateBase, t.alternate);
  palette.setColor(QPalette::ButtonText, t.text);
  palette.setColor(QPalette::Highlight, t.highlight);
  palette.setColor(QPalette::HighlightedText, t.highlighted);
  palette.setColor(QPalette::Link, t.link);
  palette.setColor(QPalette::PlaceholderText, t.faint);
  palette.setColor(QPalette::ToolTipBase, t.base);
  palette.setColor(QPalette::ToolTipText, t.text);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, t.faint);
  return palette;
}

void set_appearance(QApplication& application, Appearance appearance) {
  application.setPalette(appearance == Appearance::system ? application.style()->standardPalette()
                                                          : palette_of(appearance == Appearance::dark));
}

}  // namespace sarsim

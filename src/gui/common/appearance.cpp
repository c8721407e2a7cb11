#include "gui/common/appearance.hpp"

#include <QApplication>
#include <QPainter>
#include <QProxyStyle>
#include <QStyle>
#include <QStyleOption>

#include "gui/common/palette_colours.hpp"

namespace sarsim::gui {

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

class WorkbenchStyle : public QProxyStyle {
 public:
  WorkbenchStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (!is_dark(option->palette)) return;
    const QRectF rect = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    const bool focus = option->state.testFlag(State_HasFocus);  // Fusion has a rim of its own for it.
    if (element == PE_FrameLineEdit && !focus)
      draw_rim(*painter, option, [&] { painter->drawRoundedRect(rect, 2, 2); });
    if (element == PE_IndicatorCheckBox) draw_rim(*painter, option, [&] { painter->drawRect(rect); });
    if (element == PE_IndicatorRadioButton) draw_rim(*painter, option, [&] { painter->drawEllipse(rect); });
  }

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control != CC_SpinBox || !is_dark(option->palette) || option->state.testFlag(State_HasFocus)) return;
    const QRectF rect = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    draw_rim(*painter, option, [&] { painter->drawRoundedRect(rect, 2, 2); });
  }

 private:
  template <class Draw>
  static void draw_rim(QPainter& painter, const QStyleOption* option, const Draw& draw) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(option->state.testFlag(State_Enabled) ? QColor(rgb(0x7d8288)) : QColor(rgb(0x55595e)));
    draw();
    painter.restore();
  }
};

}  // namespace

QStyle* make_style() { return new WorkbenchStyle; }

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

}  // namespace sarsim::gui

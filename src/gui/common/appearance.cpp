#include "gui/common/appearance.hpp"

#include <QApplication>
#include <QFontMetrics>
#include <QPainter>
#include <QProxyStyle>
#include <QStyle>
#include <QStyleOption>
#include <QWidget>

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

  // What the desktop says is light or dark; the colours are ours, whose contrast is known.
  [[nodiscard]] QPalette standardPalette() const override {
    return palette_of(is_dark(QProxyStyle::standardPalette()));
  }

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
    if (element == PE_PanelButtonCommand && button != nullptr && is_primary(*button))
      return draw_primary(*button, *painter);
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const QRectF rect = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    const bool focus = option->state.testFlag(State_HasFocus);  // Fusion has a rim of its own for it.
    if ((element == PE_FrameLineEdit || element == PE_PanelButtonCommand) && !focus)
      draw_rim(*painter, option, [&] { painter->drawRoundedRect(rect, 2, 2); });
    if (element == PE_IndicatorCheckBox) draw_rim(*painter, option, [&] { painter->drawRect(rect); });
    if (element == PE_IndicatorRadioButton) draw_rim(*painter, option, [&] { painter->drawEllipse(rect); });
  }

  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override {
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
    if (element != CE_PushButtonLabel || button == nullptr || !is_primary(*button))
      return QProxyStyle::drawControl(element, option, painter, widget);
    QStyleOptionButton primary(*button);
    primary.palette.setColor(QPalette::ButtonText, option->palette.color(QPalette::HighlightedText));
    QProxyStyle::drawControl(element, &primary, painter, widget);
  }

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override {
    if (const QStyleOptionGroupBox* section = section_of(control, option)) return draw_section(*section, *painter);
    if (control == CC_ToolButton && widget != nullptr && widget->property(primary_property).toBool())
      draw_tint(*painter, *option);
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if ((control != CC_SpinBox && control != CC_ComboBox) || option->state.testFlag(State_HasFocus)) return;
    const QRectF rect = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    draw_rim(*painter, option, [&] { painter->drawRoundedRect(rect, 2, 2); });
  }

  [[nodiscard]] QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                     const QWidget* widget) const override {
    const QStyleOptionGroupBox* section = section_of(control, option);
    if (section == nullptr) return QProxyStyle::subControlRect(control, option, part, widget);
    const int title = section->text.isEmpty() ? 0 : QFontMetrics(bold(*section)).height() + title_gap_px;
    if (part == SC_GroupBoxContents) return section->rect.adjusted(0, title, 0, 0);
    if (part == SC_GroupBoxLabel) return {section->rect.left(), section->rect.top(), section->rect.width(), title};
    return section->rect;
  }

 private:
  static constexpr int title_gap_px = 2;

  static bool is_primary(const QStyleOptionButton& button) {
    return button.features.testFlag(QStyleOptionButton::DefaultButton) && button.state.testFlag(State_Enabled) &&
           !button.features.testFlag(QStyleOptionButton::Flat);
  }

  // A group of fields with a title alone; one that can be checked stays as Fusion has it.
  static const QStyleOptionGroupBox* section_of(ComplexControl control, const QStyleOptionComplex* option) {
    const auto* box = control == CC_GroupBox ? qstyleoption_cast<const QStyleOptionGroupBox*>(option) : nullptr;
    return box == nullptr || box->subControls.testFlag(SC_GroupBoxCheckBox) ? nullptr : box;
  }

  static QFont bold(const QStyleOptionGroupBox&) {
    QFont font = QApplication::font("QGroupBox");
    font.setBold(true);
    return font;
  }

  // A title and a line behind it, in place of a frame.
  static void draw_section(const QStyleOptionGroupBox& box, QPainter& painter) {
    painter.save();
    const QFontMetrics letters(bold(box));
    const int height = letters.height();
    const int words = letters.horizontalAdvance(QString(box.text).remove('&'));
    painter.setFont(bold(box));
    const bool on = box.state.testFlag(State_Enabled);
    painter.setPen(box.palette.color(on ? QPalette::Normal : QPalette::Disabled, QPalette::WindowText));
    painter.drawText(QRect(box.rect.left(), box.rect.top(), box.rect.width(), height),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextShowMnemonic, box.text);
    painter.setPen(rim_of(box.palette, false));
    const int begin = box.rect.left() + (words == 0 ? 0 : words + height / 2);
    const int y = box.rect.top() + height / 2;
    if (begin < box.rect.right()) painter.drawLine(begin, y, box.rect.right(), y);
    painter.restore();
  }

  // The button that Enter presses.
  static void draw_primary(const QStyleOptionButton& button, QPainter& painter) {
    QColor ground = button.palette.color(QPalette::Highlight);
    if (button.state.testFlag(State_Sunken))
      ground = ground.darker(130);
    else if (button.state.testFlag(State_MouseOver))
      ground = ground.darker(112);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(ground.darker(120));
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(button.rect).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    if (button.state.testFlag(State_HasFocus) && button.state.testFlag(State_KeyboardFocusChange)) {
      painter.setPen(button.palette.color(QPalette::HighlightedText));
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(QRectF(button.rect).adjusted(2.5, 2.5, -2.5, -2.5), 2, 2);
    }
    painter.restore();
  }

  // A tool that the window is for.
  static void draw_tint(QPainter& painter, const QStyleOption& option) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const bool on = option.state.testFlag(State_Enabled);
    QColor tint = on ? option.palette.color(QPalette::Highlight) : rim_of(option.palette, false);
    painter.setPen(on && is_dark(option.palette) ? option.palette.color(QPalette::Link) : tint);
    tint.setAlpha(on ? 36 : 0);
    painter.setBrush(tint);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5), 3, 3);
    painter.restore();
  }

  template <class Draw>
  static void draw_rim(QPainter& painter, const QStyleOption* option, const Draw& draw) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(rim_of(option->palette, option->state.testFlag(State_Enabled)));
    draw();
    painter.restore();
  }
};

}  // namespace

QColor rim_of(const QPalette& palette, bool enabled) {
  if (is_dark(palette)) return enabled ? QColor(rgb(0x7d8288)) : QColor(rgb(0x55595e));
  return enabled ? QColor(rgb(0x7d8288)) : QColor(rgb(0xb5b8bc));
}

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

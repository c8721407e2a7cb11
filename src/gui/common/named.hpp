#pragma once

#include <QWidget>

namespace sarsim::gui {

/// Gives a widget its name for tests and scripts, the words that a screen reader speaks, and a tip; returns the widget.
template <class Widget>
Widget* named(Widget* widget, const QString& name, const QString& spoken, const QString& tip) {
  widget->setObjectName(name);
  widget->setAccessibleName(spoken);
  widget->setToolTip(tip);
  return widget;
}

}  // namespace sarsim::gui

#include "gui/frame/tool_bar.hpp"

#include <QActionEvent>
#include <QStyle>
#include <QToolButton>

#include "gui/common/appearance.hpp"

namespace sarsim::gui {

namespace {

// Buttons change their width by a pixel when they are pressed or focused in some fonts.
constexpr int spare_px = 8;
constexpr char worded_property[] = "worded";

}  // namespace

ToolBar::ToolBar(const QString& title, QWidget* parent) : QToolBar(title, parent) {
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  const int line = fontMetrics().height();
  setIconSize({line * 5 / 4, line * 5 / 4});
}

void ToolBar::add_worded(QAction* action) {
  addAction(action);
  widgetForAction(action)->setProperty(worded_property, true);
}

void ToolBar::add_primary(QAction* action) {
  add_worded(action);
  QWidget* button = widgetForAction(action);
  button->setProperty(primary_property, true);
  button->setObjectName("primary_" + action->objectName());
}

void ToolBar::add_gap() {
  auto* gap = new QWidget(this);
  gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  addWidget(gap);
}

void ToolBar::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  fold();
}

void ToolBar::changeEvent(QEvent* event) {
  QToolBar::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) needed_ = {};
}

void ToolBar::actionEvent(QActionEvent* event) {
  QToolBar::actionEvent(event);
  if (event->type() != QEvent::ActionChanged) needed_ = {};
}

int ToolBar::width_needed() const {
  int width = 2 * style()->pixelMetric(QStyle::PM_ToolBarItemMargin) + spare_px +
              style()->pixelMetric(QStyle::PM_ToolBarHandleExtent);
  for (QAction* action : actions())
    if (const QWidget* widget = widgetForAction(action))
      width += widget->sizeHint().expandedTo({0, 0}).width() + style()->pixelMetric(QStyle::PM_ToolBarItemSpacing);
  return width;
}

void ToolBar::give_words(Words words) {
  words_ = words;
  for (QAction* action : actions()) {
    auto* button = qobject_cast<QToolButton*>(widgetForAction(action));
    if (button == nullptr) continue;
    const bool worded = words == Words::all || (words == Words::some && button->property(worded_property).toBool());
    button->setToolButtonStyle(worded ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
  }
}

// The most words that fit.
void ToolBar::fold() {
  constexpr std::array all{Words::all, Words::some, Words::none};
  if (needed_.front() == 0)
    for (const Words words : all) {
      give_words(words);
      needed_.at(static_cast<std::size_t>(words)) = width_needed();
    }
  Words best = Words::none;
  for (const Words words : {Words::some, Words::all})
    if (needed_.at(static_cast<std::size_t>(words)) <= width()) best = words;
  give_words(best);
}

}  // namespace sarsim::gui

#include "gui/echo/echo_panel.hpp"

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QStyle>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/common/named.hpp"
#include "gui/echo/simulation_window.hpp"

namespace sarsim::gui {

EchoPanel::EchoPanel(QWidget* parent)
    : QWidget(parent), stack_(new QStackedWidget(this)), tabs_(new QTabWidget(stack_)) {
  setObjectName("echo_panel");
  tabs_->setObjectName("echo_tabs");
  tabs_->setDocumentMode(true);
  tabs_->setTabsClosable(true);
  tabs_->setMovable(true);
  tabs_->setElideMode(Qt::ElideMiddle);
  tabs_->setUsesScrollButtons(true);
  auto* const alone =
      named(new QToolButton(tabs_), "echo_alone", tr("Detach"), tr("Show the echoes in a separate window"));
  alone->setIcon(style()->standardIcon(QStyle::SP_TitleBarNormalButton));
  alone->setAutoRaise(true);
  tabs_->setCornerWidget(alone);
  connect(alone, &QToolButton::clicked, this, [this] {
    if (SimulationWindow* window = current()) emit alone_wanted(window);
  });
  connect(tabs_, &QTabWidget::tabCloseRequested, this, [this](int index) {
    if (QWidget* window = tabs_->widget(index)) window->close();
  });
  stack_->addWidget(make_placeholder());
  stack_->addWidget(tabs_);
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(stack_);
  follow_tabs();
}

// Windows that go with it have no tabs left to tell of.
EchoPanel::~EchoPanel() {
  for (int i = 0; i < tabs_->count(); ++i) tabs_->widget(i)->disconnect(this);
}

QWidget* EchoPanel::make_placeholder() {
  auto* const page = new QWidget(stack_);
  auto* const column = new QVBoxLayout(page);
  auto* const words = new QLabel(tr("The echoes of a radar appear here and follow every change of the scene."), page);
  words->setWordWrap(true);
  words->setAlignment(Qt::AlignCenter);
  auto* const raw = named(new QPushButton(tr("&Raw Echoes"), page), "echo_panel_raw", tr("Raw echoes"),
                          tr("Show what the receiver records"));
  auto* const compressed = named(new QPushButton(tr("Range &Compressed"), page), "echo_panel_compressed",
                                 tr("Range compressed"), tr("Show the echoes after the matched filter"));
  connect(raw, &QPushButton::clicked, this, &EchoPanel::raw_wanted);
  connect(compressed, &QPushButton::clicked, this, &EchoPanel::compressed_wanted);
  column->addStretch(2);
  column->addWidget(words);
  for (QPushButton* button : {raw, compressed}) {
    button->setAutoDefault(false);
    column->addWidget(button, 0, Qt::AlignHCenter);
  }
  column->addStretch(3);
  return page;
}

void EchoPanel::take(SimulationWindow* window) {
  window->setWindowFlag(Qt::Window, false);
  window->show_settings(false);  // Beside the scene the picture needs the room.
  const int index = tabs_->addTab(window, window->windowTitle());
  tabs_->setTabToolTip(index, window->windowTitle());
  connect(window, &QWidget::windowTitleChanged, tabs_, [this, window](const QString& title) {
    const int at = tabs_->indexOf(window);
    if (at < 0) return;
    tabs_->setTabText(at, title);
    tabs_->setTabToolTip(at, title);
  });
  connect(window, &QObject::destroyed, this, &EchoPanel::follow_tabs);
  connect(window, &SimulationWindow::set_aside, tabs_, [this, window](bool aside) {
    if (const int at = tabs_->indexOf(window); at >= 0) tabs_->setTabVisible(at, !aside);
    follow_tabs();
  });
  tabs_->setCurrentIndex(index);
  window->show();
  follow_tabs();
}

int EchoPanel::count() const {
  int seen = 0;
  for (int i = 0; i < tabs_->count(); ++i) seen += tabs_->isTabVisible(i) ? 1 : 0;
  return seen;
}

SimulationWindow* EchoPanel::current() const {
  const int at = tabs_->currentIndex();
  return at >= 0 && tabs_->isTabVisible(at) ? qobject_cast<SimulationWindow*>(tabs_->widget(at)) : nullptr;
}

void EchoPanel::follow_tabs() { stack_->setCurrentIndex(count() > 0 ? 1 : 0); }

}  // namespace sarsim::gui

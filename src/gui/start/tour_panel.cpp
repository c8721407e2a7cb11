#include "gui/start/tour_panel.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sarsim::gui {

namespace {

constexpr int look_every_ms = 500;

}  // namespace

TourPanel::TourPanel(std::vector<TourStep> steps, QWidget* parent)
    : QDialog(parent), steps_(std::move(steps)), done_(steps_.size(), false) {
  setObjectName("tour");
  setWindowTitle(tr("Tour"));
  setModal(false);
  title_ = new QLabel;
  title_->setObjectName("tour_title");
  text_ = new QLabel;
  text_->setObjectName("tour_text");
  text_->setWordWrap(true);
  text_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  state_ = new QLabel;
  state_->setObjectName("tour_state");
  auto* buttons = new QHBoxLayout;
  const auto add = [&](const QString& words, const char* name, const QString& tip) {
    auto* button = new QPushButton(words);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setAutoDefault(false);
    buttons->addWidget(button);
    return button;
  };
  back_ = add(tr("&Back"), "tour_back", tr("The step before"));
  show_ = add(tr("&Show Me"), "tour_show", tr("Does this step for you"));
  next_ = add(tr("&Next"), "tour_next", tr("The next step"));
  buttons->addStretch();
  QPushButton* end = add(tr("&End"), "tour_end", tr("Leaves the tour; the scene stays"));
  connect(back_, &QPushButton::clicked, this, [this] { go_to(at_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] { at_ + 1 == this->steps() ? hide() : go_to(at_ + 1); });
  connect(show_, &QPushButton::clicked, this, [this] {
    current().show();
    look();
  });
  connect(end, &QPushButton::clicked, this, &QWidget::hide);
  connect(&timer_, &QTimer::timeout, this, &TourPanel::look);
  auto* layout = new QVBoxLayout(this);
  for (QLabel* label : {title_, text_, state_}) layout->addWidget(label);
  layout->setStretch(1, 1);
  layout->addLayout(buttons);
  // As high as the longest step, so that the buttons stay where they are.
  const int width = fontMetrics().averageCharWidth() * 60;
  int height = 0;
  for (const TourStep& step : steps_)
    height = std::max(height, fontMetrics().boundingRect(0, 0, width, 0, Qt::TextWordWrap, step.text).height());
  text_->setMinimumSize(width, height + fontMetrics().height());
  if (!steps_.empty()) go_to(0);
}

void TourPanel::begin() {
  done_.assign(steps_.size(), false);
  if (!steps_.empty()) go_to(0);
}

void TourPanel::go_to(int step) {
  at_ = std::clamp(step, 0, steps() - 1);
  look();
}

void TourPanel::look() {
  if (steps_.empty()) return;
  if (!step_done() && current().done()) done_[static_cast<std::size_t>(at_)] = true;
  show_state();
}

void TourPanel::show_state() {
  title_->setText(tr("<b>%1</b> &nbsp; step %2 of %3").arg(current().title).arg(at_ + 1).arg(steps()));
  text_->setText(current().text);
  state_->setText(step_done() ? QString::fromUtf8("\xE2\x9C\x93 ") + tr("Done") : tr("Waiting for you"));
  const bool last = at_ + 1 == steps();
  next_->setText(last ? tr("&Finish") : tr("&Next"));
  back_->setEnabled(at_ > 0);
  show_->setEnabled(!step_done());
  next_->setDefault(step_done());
  show_->setDefault(!step_done());
}

void TourPanel::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  timer_.start(look_every_ms);
  look();
}

void TourPanel::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  timer_.stop();
}

}  // namespace sarsim::gui

#include "gui/scene/time_bar.hpp"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/maths/rounding.hpp"
#include "gui/common/palette_colours.hpp"
#include "gui/common/text.hpp"
#include "picture/figure/ticks.hpp"
#include "scene/schema/quantity.hpp"

namespace sarsim::gui {

namespace {

constexpr int scrubber_steps = 10'000;
constexpr int repeat_ms = 100;       // of a held button (thesis 4.1.1)
constexpr int frame_ms = 33;         // while playing
constexpr double frame_parts = 1e5;  // of the span: times that playing announces are rounded to about one of them

QString time_text(double time_s) { return display_of(scene::quantity_text(time_s, scene::Quantity::time)); }

// The clock of a moment to a millisecond, always as wide.
QString clock_text(const radar::Instant& moment) {
  const radar::CivilTime clock = radar::civil_of(radar::later(moment, 0.0005), radar::TimeScale::utc);
  const auto two = [](int number) { return QStringLiteral("%1").arg(number, 2, 10, QLatin1Char('0')); };
  return QStringLiteral("%1:%2:%3.%4 UTC")
      .arg(two(clock.hour), two(clock.minute), two(clock.second))
      .arg(static_cast<int>(clock.fraction_s * 1e3), 3, 10, QLatin1Char('0'));
}

// Marks a field whose text cannot be taken and says why, or takes the mark off where `failure` is empty. The mark is a
// thicker frame, so that it is not told by colour alone.
void mark(QLineEdit& field, const QString& failure) {
  field.setProperty("refused", !failure.isEmpty());
  field.setAccessibleDescription(failure);
  const QString colour = colour_of(picture::Role::error, field.palette()).name();
  field.setStyleSheet(failure.isEmpty() ? QString()
                                        : QStringLiteral("QLineEdit { border: 2px solid %1; }").arg(colour));
  if (!failure.isEmpty() && field.isVisible())
    QToolTip::showText(field.mapToGlobal(field.rect().bottomLeft()), failure, &field);
}

// Reads a field; where the text is no time the text stays, marked, until it is mended.
std::optional<double> taken_from(QLineEdit& field) {
  const scene::QuantityReading reading = scene::read_quantity(field.text().toStdString(), scene::Quantity::time);
  mark(field, QString::fromStdString(reading.failure));
  if (reading.value) field.setModified(false);
  return reading.value;
}

// The style's own are dark, whatever they stand on.
QIcon drawn_in(const QColor& colour, const QIcon& icon) {
  constexpr int max_side = 64;
  QPixmap picture = icon.pixmap(max_side, max_side);
  QPainter painter(&picture);
  painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
  painter.fillRect(picture.rect(), colour);
  painter.end();
  return picture;
}

QToolButton* make_button(QWidget* parent, const char* name, const QString& text, const QString& tip) {
  auto* button = new QToolButton(parent);
  button->setObjectName(QLatin1String(name));
  button->setText(text);
  button->setAccessibleName(text);
  button->setToolTip(tip);
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

QLineEdit* make_field(QWidget* parent, const char* name, const QString& spoken, const QString& tip) {
  auto* field = new QLineEdit(parent);
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(spoken);
  field->setToolTip(tip);
  field->setMinimumWidth(field->fontMetrics().horizontalAdvance(QStringLiteral("000.00 ms ")));
  field->setMaximumWidth(field->fontMetrics().horizontalAdvance(QStringLiteral("-0000.000000 ms ")));
  return field;
}

}  // namespace

TimeBar::TimeBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("time_bar"));
  setAccessibleName(tr("Time of the scene"));
  add_buttons();
  add_fields();
  lay_out();
  show_icons();
  timer_.setInterval(frame_ms);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &TimeBar::advance);
  show_time();
}

// A field that has the focus announces the end of typing while it is taken down; then this is no time bar any more.
TimeBar::~TimeBar() {
  time_field_->disconnect(this);
  step_field_->disconnect(this);
}

void TimeBar::add_buttons() {
  earlier_button_ =
      make_button(this, "earlier_button", tr("Earlier"), tr("Earlier: one step back; held, ten steps a second"));
  play_button_ = make_button(this, "play_button", tr("Play"), tr("Play or stop: let the time run"));
  later_button_ = make_button(this, "later_button", tr("Later"), tr("Later: one step on; held, ten steps a second"));
  for (QToolButton* button : {earlier_button_, later_button_}) {
    button->setAutoRepeat(true);
    button->setAutoRepeatDelay(3 * repeat_ms);
    button->setAutoRepeatInterval(repeat_ms);
  }
  connect(earlier_button_, &QToolButton::clicked, this, &TimeBar::earlier);
  connect(later_button_, &QToolButton::clicked, this, &TimeBar::later);
  connect(play_button_, &QToolButton::clicked, this, [this] { set_playing(!playing()); });

  scrubber_ = new QSlider(Qt::Horizontal, this);
  scrubber_->setObjectName(QStringLiteral("scrubber"));
  scrubber_->setAccessibleName(tr("Time"));
  scrubber_->setRange(0, scrubber_steps);
  scrubber_->setSingleStep(scrubber_steps / 100);
  scrubber_->setPageStep(scrubber_steps / 10);
  scrubber_->setMinimumWidth(60);
  connect(scrubber_, &QSlider::valueChanged, this, [this](int value) {
    const double length_s = span_s_[1] - span_s_[0];
    set_time(value == scrubber_steps ? span_s_[1]
                                     : span_s_[0] + core::rounded_to(length_s * value / scrubber_steps,
                                                                     picture::round_below(length_s / scrubber_steps)));
  });
}

void TimeBar::add_fields() {
  time_field_ = make_field(this, "time_field", tr("Time"), tr("Time of the scene; any unit: 0.1 s, 5 ms"));
  connect(time_field_, &QLineEdit::editingFinished, this, &TimeBar::take_time_text);
  utc_ = new QLabel(this);
  utc_->setObjectName(QStringLiteral("utc_label"));
  utc_->setAccessibleName(tr("Time, UTC"));
  utc_->hide();
  step_field_ = make_field(this, "step_field", tr("Step"), tr("How far Earlier and Later go; any unit: 0.1 s, 5 ms"));
  step_field_->setText(time_text(step_s_));
  connect(step_field_, &QLineEdit::editingFinished, this, &TimeBar::take_step_text);

  speed_box_ = new QComboBox(this);
  speed_box_->setObjectName(QStringLiteral("speed_box"));
  speed_box_->setAccessibleName(tr("Speed"));
  speed_box_->setToolTip(tr("Seconds of the scene per second"));
  for (const double speed : {0.001, 0.01, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    speed_box_->addItem(QStringLiteral("x%1").arg(speed), speed);
  speed_box_->setCurrentIndex(speed_box_->findText(QStringLiteral("x1")));
  connect(speed_box_, &QComboBox::currentIndexChanged, this, [this] {
    played_from_s_ = time_s_;
    clock_.restart();
  });
  loop_box_ = new QCheckBox(tr("Loop"), this);
  loop_box_->setObjectName(QStringLiteral("loop_box"));
  loop_box_->setToolTip(tr("Play again from the beginning at the end"));
}

void TimeBar::lay_out() {
  const auto label = [this](const QString& text, QWidget* buddy) {
    auto* words = new QLabel(text, this);
    words->setBuddy(buddy);
    return words;
  };
  rows_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
  rows_->setContentsMargins(4, 2, 4, 2);
  auto* now = new QHBoxLayout;
  for (QToolButton* button : {earlier_button_, play_button_, later_button_}) now->addWidget(button);
  now->addWidget(scrubber_, 3);
  now->addWidget(label(tr("Time"), time_field_));
  now->addWidget(time_field_, 1);
  now->addWidget(utc_);
  auto* how = new QHBoxLayout;
  how->addWidget(label(tr("Step"), step_field_));
  how->addWidget(step_field_, 1);
  how->addWidget(label(tr("Speed"), speed_box_));
  how->addWidget(speed_box_);
  how->addWidget(loop_box_);
  rows_->addLayout(now, 4);
  rows_->addLayout(how, 1);
}

// How it goes stands below when it is, where there is no room beside it.
void TimeBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int beside = rows_->itemAt(0)->minimumSize().width() + rows_->itemAt(1)->minimumSize().width() + 60;
  rows_->setDirection(width() < beside ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

QSize TimeBar::minimumSizeHint() const {
  const QSize now = rows_->itemAt(0)->minimumSize();
  const QSize how = rows_->itemAt(1)->minimumSize();
  return {std::max(now.width(), how.width()) + 8, QWidget::minimumSizeHint().height()};
}

double TimeBar::speed() const { return speed_box_->currentData().toDouble(); }

void TimeBar::set_span(double first_s, double last_s) {
  if (!std::isfinite(first_s) || !std::isfinite(last_s) || !(first_s < last_s)) return;
  span_s_ = {first_s, last_s};
  scrubber_->setToolTip(tr("%1 to %2").arg(time_text(first_s), time_text(last_s)));
  show_time();
}

void TimeBar::set_epoch(const std::optional<radar::Instant>& epoch) {
  if (epoch == epoch_) return;
  epoch_ = epoch;
  utc_->setVisible(epoch.has_value());
  time_field_->setToolTip(epoch ? tr("Time of the scene; any unit: 0.1 s, 5 ms; or UTC: 2026-05-01T12:00:00Z")
                                : tr("Time of the scene; any unit: 0.1 s, 5 ms"));
  show_time();
}

void TimeBar::set_step(double step_s) {
  if (!std::isfinite(step_s) || step_s < 0.0) return;
  step_s_ = step_s;
  step_field_->setText(time_text(step_s));
}

void TimeBar::set_time(double time_s) {
  if (!std::isfinite(time_s) || time_s == time_s_) return;
  time_s_ = time_s;
  // Somebody else moved the time while it runs: it runs on from there.
  if (playing() && time_s != played_to_s_) {
    played_from_s_ = time_s;
    clock_.restart();
  }
  show_time();
  emit time_changed(time_s);
}

void TimeBar::show_time() {
  const double part = (time_s_ - span_s_[0]) / (span_s_[1] - span_s_[0]);
  const QSignalBlocker quiet(scrubber_);
  scrubber_->setValue(static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * scrubber_steps)));
  show_utc();
  // What is being typed stays.
  if (!(time_field_->hasFocus() && time_field_->isModified())) {
    time_field_->setText(time_text(time_s_));
    mark(*time_field_, {});
  }
}

void TimeBar::show_utc() {
  constexpr double longest_s = 1e12;
  if (!epoch_ || !(std::abs(time_s_) < longest_s)) return utc_->clear();
  const radar::Instant moment = radar::later(*epoch_, time_s_);
  utc_->setText(clock_text(moment));
  utc_->setToolTip(tr("The time of the scene as UTC, from the epoch of the world: %1")
                       .arg(QString::fromStdString(radar::format_instant(moment, radar::TimeScale::utc))));
}

void TimeBar::take_time_text() {
  if (!time_field_->isModified()) return;
  if (const auto time_s = typed_time()) {
    set_time(*time_s);
    show_time();
  }
}

// Seconds, or a moment where the world has an epoch: only a date has two hyphens.
std::optional<double> TimeBar::typed_time() {
  const std::string text = time_field_->text().trimmed().toStdString();
  if (!epoch_ || std::ranges::count(text, '-') < 2) return taken_from(*time_field_);
  const radar::InstantReading reading = radar::parse_instant(text, radar::TimeScale::utc);
  mark(*time_field_, QString::fromStdString(reading.failure));
  if (!reading.instant) return std::nullopt;
  time_field_->setModified(false);
  return core::tidy(radar::seconds_between(*epoch_, *reading.instant));
}

void TimeBar::take_step_text() {
  if (!step_field_->isModified()) return;
  const auto step_s = taken_from(*step_field_);
  if (!step_s) return;
  if (*step_s >= 0.0)
    set_step(*step_s);
  else
    mark(*step_field_, tr("Enter a step of 0 or more; Earlier goes back"));
}

void TimeBar::earlier() { set_time(core::tidy(time_s_ - step_s_)); }

void TimeBar::later() { set_time(core::tidy(time_s_ + step_s_)); }

void TimeBar::set_playing(bool play) {
  if (play == playing()) return;
  if (play) {
    if (time_s_ >= span_s_[1] || time_s_ < span_s_[0]) set_time(span_s_[0]);
    played_from_s_ = played_to_s_ = time_s_;
    clock_.start();
    timer_.start();
  } else {
    timer_.stop();
  }
  play_button_->setText(play ? tr("Stop") : tr("Play"));
  play_button_->setAccessibleName(play_button_->text());
  show_icons();
  emit playing_changed(play);
}

void TimeBar::show_icons() {
  const auto show = [this](QToolButton* button, QStyle::StandardPixmap icon) {
    button->setIcon(drawn_in(palette().color(QPalette::ButtonText), style()->standardIcon(icon)));
  };
  show(earlier_button_, QStyle::SP_MediaSeekBackward);
  show(play_button_, playing() ? QStyle::SP_MediaStop : QStyle::SP_MediaPlay);
  show(later_button_, QStyle::SP_MediaSeekForward);
}

void TimeBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) show_icons();
}

void TimeBar::advance() {
  const double length_s = span_s_[1] - span_s_[0];
  double now_s = played_from_s_ + speed() * 1e-9 * static_cast<double>(clock_.nsecsElapsed());
  const bool ended = now_s >= span_s_[1];
  if (ended && loop_box_->isChecked())
    now_s = span_s_[0] + std::fmod(now_s - span_s_[0], length_s);
  else if (ended)
    now_s = span_s_[1];
  played_to_s_ =
      ended && !loop_box_->isChecked() ? now_s : core::rounded_to(now_s, picture::round_below(length_s / frame_parts));
  set_time(played_to_s_);
  if (ended && loop_box_->isChecked()) {
    played_from_s_ = now_s;
    clock_.restart();
  } else if (ended) {
    set_playing(false);
  }
}

}  // namespace sarsim::gui

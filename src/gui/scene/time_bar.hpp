#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <array>
#include <optional>

#include "radar/earth/instant.hpp"

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QSlider;
class QToolButton;

namespace sarsim::gui {

/// The time of the scene ("time_bar"): a scrubber over the scene's span, the time in a field that takes any unit of
/// time, Earlier and Later that step ten times a second while held (thesis 4.1.1), and playing at a chosen speed.
/// Times outside the span are allowed; only the scrubber and playing stay within it.
class TimeBar : public QWidget {
  Q_OBJECT

 public:
  explicit TimeBar(QWidget* parent = nullptr);
  ~TimeBar() override;

  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] std::array<double, 2> span_s() const { return span_s_; }
  [[nodiscard]] double step_s() const { return step_s_; }
  [[nodiscard]] bool playing() const { return timer_.isActive(); }
  /// Seconds of the scene per second.
  [[nodiscard]] double speed() const;

  /// Ends that are no numbers, or not in order, are passed over.
  void set_span(double first_s, double last_s);
  /// What time 0 of the scene is: with it the time is shown, and can be typed, as UTC too.
  void set_epoch(const std::optional<radar::Instant>& epoch);
  /// A step of 0 is none. What is no number, or negative, is passed over.
  void set_step(double step_s);

  /// Announces the time where it is another one. What is no number is passed over.
  void set_time(double time_s);
  /// Playing starts again from the beginning where the time is at or beyond the end.
  void set_playing(bool play);
  /// One step back.
  void earlier();
  /// One step on.
  void later();

  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  void time_changed(double time_s);    ///< Another time was chosen, or has come.
  void playing_changed(bool playing);  ///< Playing began or ended.

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_icons();
  void add_buttons();
  void add_fields();
  void lay_out();
  void take_time_text();
  [[nodiscard]] std::optional<double> typed_time();
  void take_step_text();
  void show_time();
  void show_utc();
  void advance();

  std::array<double, 2> span_s_{0.0, 1.0};
  double time_s_ = 0.0;
  double step_s_ = 0.1;
  QTimer timer_;
  QElapsedTimer clock_;
  double played_from_s_ = 0.0;  // the time of the scene when `clock_` started
  double played_to_s_ = 0.0;    // the time that playing has announced last
  QBoxLayout* rows_ = nullptr;
  QToolButton* earlier_button_ = nullptr;
  QToolButton* play_button_ = nullptr;
  QToolButton* later_button_ = nullptr;
  QSlider* scrubber_ = nullptr;
  QLineEdit* time_field_ = nullptr;
  QLabel* utc_ = nullptr;
  std::optional<radar::Instant> epoch_;
  QLineEdit* step_field_ = nullptr;
  QComboBox* speed_box_ = nullptr;
  QCheckBox* loop_box_ = nullptr;
};

}  // namespace sarsim::gui

#pragma once

#include <QDialog>
#include <QTimer>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace sarsim::gui {

/// One step of a guided tour.
struct TourStep {
  QString title;
  QString text;                ///< What is to be done, and why.
  std::function<bool()> done;  ///< Whether the user has done it; asked often.
  std::function<void()> show;  ///< Does it for the user.
};

/// A guided tour in a small window that leaves the others free ("tour"): what to do, whether it is done, and a button
/// that does it. A step that was done once stays done.
class TourPanel : public QDialog {
  Q_OBJECT

 public:
  /// @param steps  from the first to the last
  explicit TourPanel(std::vector<TourStep> steps, QWidget* parent = nullptr);

  /// From the first step on, with none done.
  void begin();
  /// Looks whether the step has been done. Called twice a second; sooner by who knows that something changed.
  void look();
  [[nodiscard]] int step() const { return at_; }
  [[nodiscard]] bool step_done() const { return done_[static_cast<std::size_t>(at_)]; }
  [[nodiscard]] int steps() const { return static_cast<int>(steps_.size()); }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void go_to(int step);
  void show_state();
  [[nodiscard]] const TourStep& current() const { return steps_[static_cast<std::size_t>(at_)]; }

  std::vector<TourStep> steps_;
  std::vector<bool> done_;
  int at_ = 0;
  QTimer timer_;
  QLabel* title_ = nullptr;
  QLabel* text_ = nullptr;
  QLabel* state_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* show_ = nullptr;
  QPushButton* next_ = nullptr;
};

}  // namespace sarsim::gui

#pragma once

#include <QWidget>

class QStackedWidget;
class QTabWidget;

namespace sarsim::gui {

class SimulationWindow;

/// The place of simulation windows beside the scene: a tab for each of them, and what to do where there are none yet.
class EchoPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EchoPanel(QWidget* parent = nullptr);
  ~EchoPanel() override;

  /// Takes a window in, in front of the others; its tab goes with it.
  void take(SimulationWindow* window);
  [[nodiscard]] int count() const;  ///< How many windows it shows: those of the document at hand.
  /// The window in front; null where there is none.
  [[nodiscard]] SimulationWindow* current() const;

  [[nodiscard]] QSize sizeHint() const override { return {460, 520}; }

 signals:
  void raw_wanted();                                         ///< A window of raw echoes is wanted.
  void compressed_wanted();                                  ///< A window of range-compressed echoes is wanted.
  void alone_wanted(sarsim::gui::SimulationWindow* window);  ///< A window is to stand by itself.

 private:
  [[nodiscard]] QWidget* make_placeholder();
  void follow_tabs();

  QStackedWidget* stack_ = nullptr;
  QTabWidget* tabs_ = nullptr;
};

}  // namespace sarsim::gui

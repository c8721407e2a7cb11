#pragma once

#include <QToolBar>

#include <array>

namespace sarsim::gui {

/// The tool bar of the main window: icons with words beside them where there is room. Where there is not, only
/// some keep their words, and in a very narrow window none does. Nothing is hidden before that.
class ToolBar : public QToolBar {
  Q_OBJECT

 public:
  /// @param title  for the menu that shows and hides tool bars
  explicit ToolBar(const QString& title, QWidget* parent = nullptr);

  /// Adds an action that keeps its words longer than others.
  void add_worded(QAction* action);
  /// The same for the one that the window is for; it stands out.
  void add_primary(QAction* action);
  /// Adds room that grows, so that what follows stands at the right.
  void add_gap();

  /// Which buttons have words now.
  enum class Words { all, some, none };
  [[nodiscard]] Words words() const { return words_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void actionEvent(QActionEvent* event) override;

 private:
  void fold();
  void give_words(Words words);
  [[nodiscard]] int width_needed() const;

  Words words_ = Words::all;
  std::array<int, 3> needed_{};  // with each kind of words; 0: not known
};

}  // namespace sarsim::gui

#pragma once

#include <QLabel>

#include <optional>

namespace sarsim::gui {

/// Words below or beside a picture whose room stays the same whatever they say, so that the picture does not move under
/// the pointer. Words that need more lines end in an ellipsis; the tool tip has all of them.
class ReservedLabel : public QLabel {
  Q_OBJECT

 public:
  /// @param lines  that are kept free, at least 1
  explicit ReservedLabel(int lines, QWidget* parent = nullptr);

  /// Says something else in the same room.
  void say(const QString& words);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void reserve();

  int lines_;
  std::optional<bool> is_cut_;  // Not all words have room; unknown after a change.
};

}  // namespace sarsim::gui

#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace sarsim::gui {

/// A line to search a text with: the next or previous place, round the ends; says where nothing is found.
class FindBar : public QWidget {
  Q_OBJECT

 public:
  /// A bar for a text, hidden until it is opened.
  explicit FindBar(QPlainTextEdit* text, QWidget* parent = nullptr);

  /// Shows the bar with the selected word, if any, ready to type.
  void open();
  void find_next() { find(false); }
  void find_previous() { find(true); }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void close_bar();
  void find(bool backwards);
  void find_as_typed();

  QPlainTextEdit* text_;
  QLineEdit* word_ = nullptr;
  QCheckBox* case_ = nullptr;
  QLabel* result_ = nullptr;
};

}  // namespace sarsim::gui

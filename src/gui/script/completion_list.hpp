#pragma once

#include <QTreeWidget>

#include <vector>

#include "scene/language/completion.hpp"

namespace sarsim::gui {

/// A list of what may be typed, beside what is being typed: words with their meanings. It never takes the keyboard; who
/// has it passes on the keys that move in the list.
class CompletionList : public QTreeWidget {
  Q_OBJECT

 public:
  /// @param text  the widget that is typed into
  explicit CompletionList(QWidget* text);

  /// Shows the list with its first line chosen.
  /// @param beside  the area, on screen, of what is being typed
  void offer(const std::vector<scene::language::Completion>& offered, const QRect& beside);
  /// Chooses another line; false for keys that do not move in lists.
  bool move_by(int key);
  /// The line that is chosen, from 0; -1 for none.
  [[nodiscard]] int chosen() const;

 private:
  void place(const QRect& beside);
};

}  // namespace sarsim::gui

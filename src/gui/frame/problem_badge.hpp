#pragma once

#include <QToolButton>

#include "core/report/problem.hpp"

namespace sarsim::gui {

/// How many errors and warnings there are: "1 error, 2 warnings"; empty where there is neither.
[[nodiscard]] QString problem_counts(const core::Problems& problems);

/// A button of the status bar that says how much is wrong; not there where nothing is ("problem_badge").
class ProblemBadge : public QToolButton {
  Q_OBJECT

 public:
  explicit ProblemBadge(QWidget* parent = nullptr);

  /// Says how much is wrong; the tooltip has the first of the problems in words.
  void show_problems(const core::Problems& problems);
};

}  // namespace sarsim::gui

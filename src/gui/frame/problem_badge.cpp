#include "gui/frame/problem_badge.hpp"

#include <QStringList>

#include <algorithm>

#include "gui/common/problem_line.hpp"

namespace sarsim::gui {

namespace {

constexpr std::size_t max_in_tip = 5;

}  // namespace

QString problem_counts(const core::Problems& problems) {
  const auto errors = std::ranges::count(problems, core::Severity::error, &core::Problem::severity);
  const auto warnings = std::ranges::count(problems, core::Severity::warning, &core::Problem::severity);
  QStringList parts;
  if (errors > 0) parts += errors == 1 ? ProblemBadge::tr("1 error") : ProblemBadge::tr("%1 errors").arg(errors);
  if (warnings > 0)
    parts += warnings == 1 ? ProblemBadge::tr("1 warning") : ProblemBadge::tr("%1 warnings").arg(warnings);
  return parts.join(", ");
}

ProblemBadge::ProblemBadge(QWidget* parent) : QToolButton(parent) {
  setObjectName("problem_badge");
  setAccessibleName(tr("Problems of the script"));
  setAutoRaise(true);
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  const int size = fontMetrics().height();
  setIconSize({size, size});
  hide();
}

void ProblemBadge::show_problems(const core::Problems& problems) {
  const QString counts = problem_counts(problems);
  setVisible(!counts.isEmpty());
  if (counts.isEmpty()) return;
  setText(counts);
  setAccessibleName(tr("Problems of the script: %1").arg(counts));
  setIcon(severity_icon(core::has_errors(problems) ? core::Severity::error : core::Severity::warning, *this));
  QStringList tip;
  for (std::size_t i = 0; i < std::min(problems.size(), max_in_tip); ++i)
    tip += problem_text(problems[i]).toHtmlEscaped();
  if (problems.size() > max_in_tip) tip += tr("and %1 more").arg(problems.size() - max_in_tip);
  setToolTip("<p>" + tip.join("</p><p>") + "</p>");
}

}  // namespace sarsim::gui

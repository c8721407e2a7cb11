#include "gui/frame/log_panel.hpp"

#include <QRegularExpression>
#include <QTime>

#include <algorithm>
#include <utility>

#include "gui/common/problem_line.hpp"
#include "gui/frame/problem_watch.hpp"

namespace sarsim::gui {

namespace {

constexpr std::size_t max_at_once = 100;
constexpr QChar error_mark = u'!';

// What makes two problems the same one: neither its line, nor which object of many it is about, nor a figure, all of
// which change while something else is edited. What cannot be read has no object and goes by its text.
QString cause_of(const core::Problem& problem) {
  static const QRegularExpression figures(QStringLiteral("[0-9][0-9.,]*"));
  const QChar mark = problem.severity == core::Severity::error ? error_mark : QChar(u'?');
  const QString words = QString::fromStdString(problem.message).remove(figures);
  const std::string& about = problem.subject.kind.empty() ? problem.found : problem.subject.field;
  return QStringList{mark, QString::fromStdString(problem.subject.kind), QString::fromStdString(about), words}.join(
      u'\n');
}

}  // namespace

LogPanel::LogPanel(Session& session, const ProblemWatch& watch, QWidget* parent)
    : QPlainTextEdit(parent), session_(session) {
  setObjectName("log_panel");
  setAccessibleName(tr("Log"));
  setReadOnly(true);
  setMaximumBlockCount(10'000);
  connect(&session, &Session::logged, this, [this](int severity, const QString& text) {
    const QString word = severity == static_cast<int>(core::Severity::error)     ? tr("Error: ")
                         : severity == static_cast<int>(core::Severity::warning) ? tr("Warning: ")
                                                                                 : QString();
    add_line(word + text);
  });
  connect(&session, &Session::document_closed, this, [this](int number) { told_.erase(number); });
  connect(&watch, &ProblemWatch::changed, this, [this, &watch] {
    tell_problems(watch.problems());
    tell_echoes(watch.echoes());
  });
}

void LogPanel::add_line(const QString& text) { appendPlainText(QTime::currentTime().toString("HH:mm:ss ") + text); }

void LogPanel::tell_problems(const core::Problems& problems) {
  std::map<QString, std::size_t>& told = told_[session_.number()].problems;
  std::map<QString, std::size_t> now;
  std::size_t added = 0;
  for (const core::Problem& problem : problems) {
    const QString cause = cause_of(problem);
    if (const auto before = told.find(cause); ++now[cause] <= (before == told.end() ? 0 : before->second)) continue;
    if (++added <= max_at_once) add_line(placed_problem_text(problem, session_.document().path()));
  }
  if (added > max_at_once) add_line(tr("and %1 more").arg(added - max_at_once));
  if (!told.empty() && now.empty()) add_line(tr("All problems are fixed."));
  // Errors hide what else is wrong: it is not new when it is seen again.
  if (core::has_errors(problems))
    for (const auto& [cause, count] : told)
      if (!cause.startsWith(error_mark)) now[cause] = std::max(now[cause], count);
  told = std::move(now);
}

void LogPanel::tell_echoes(const QString& echoes) {
  if (echoes.isEmpty() || std::exchange(told_[session_.number()].echoes, true)) return;
  for (const QString& line : echoes.split(u'\n', Qt::SkipEmptyParts)) add_line(line.trimmed());
}

}  // namespace sarsim::gui

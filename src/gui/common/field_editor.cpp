#include "gui/common/field_editor.hpp"

#include <QLabel>
#include <QRegularExpression>

#include <algorithm>

#include "gui/common/problem_line.hpp"

namespace sarsim::gui {

namespace {

// Wraps, as only rich text does in tooltips.
QString tooltip_of(const scene::Field& field) {
  QString text = "<p>" + QString::fromStdString(field.tooltip).toHtmlEscaped() + "</p>";
  if (field.kind != scene::FieldKind::quantity) return text;
  QStringList units;
  for (const std::string_view unit : scene::units_of(field.quantity))
    units += QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
  if (!units.isEmpty())
    text += "<p>" + FieldEditor::tr("Units: %1").arg(units.join(QStringLiteral(", "))).toHtmlEscaped() + "</p>";
  return text;
}

}  // namespace

QString stepped_text(const QString& text, int steps) {
  static const QRegularExpression form(
      QStringLiteral(R"(^\s*([+-]?)(\d*)(?:\.(\d*))?([eE][+-]?\d+)?(\s*[^\s\d.].*)?$)"));
  const QRegularExpressionMatch match = form.match(text);
  const qsizetype decimals = match.captured(3).size();
  bool is_number = false;
  // All digits as one whole number, so that no step is lost to rounding.
  qint64 digits = (match.captured(2) + match.captured(3)).toLongLong(&is_number);
  if (!match.hasMatch() || !is_number || digits > 900'000'000'000'000'000) return {};
  if (match.captured(1) == "-") digits = -digits;
  digits += steps;
  QString number = QString::number(digits < 0 ? -digits : digits).rightJustified(decimals + 1, '0');
  if (decimals > 0) number.insert(number.size() - decimals, '.');
  return (digits < 0 ? "-" : "") + number + match.captured(4) + match.captured(5);
}

FieldEditor::FieldEditor(const scene::Field& field, QWidget* parent)
    : QObject(parent), field_(field), problem_line_(new ProblemLine(parent)) {
  problem_line_->setObjectName("problem_" + id());
}

void FieldEditor::describe(QWidget* widget, bool with_label) {
  const QString name = QString::fromStdString(field_.label);
  widget->setObjectName("field_" + id());
  widget->setAccessibleName(name);
  widget->setToolTip(tooltip_of(field_));
  if (!with_label) return;
  label_ = new QLabel(QString(name).replace('&', QStringLiteral("&&")), widget->parentWidget());
  label_->setBuddy(widget);
  label_->setToolTip(widget->toolTip());
}

void FieldEditor::show_value(const QString& text) {
  const bool same = !different_ && text == value_;
  if ((same && (pending() || refused())) || keeps(text)) {
    value_ = text;
    different_ = false;
    return;
  }
  value_ = text;
  different_ = false;
  clear_failure();
  display();
}

void FieldEditor::show_different() {
  if (different_ && (pending() || refused())) return;
  value_.clear();
  different_ = true;
  clear_failure();
  display();
}

void FieldEditor::set_choices(const QStringList&) {}

bool FieldEditor::keeps(const QString&) const { return false; }

void FieldEditor::show_failure(const QString& sentence) {
  failure_ = sentence;
  mark(true);
  refresh_problem_line();
}

void FieldEditor::refuse_step(const QString& sentence) {
  display();
  failure_ = sentence;
  refresh_problem_line();
}

void FieldEditor::clear_failure() {
  if (failure_.isEmpty()) return;
  failure_.clear();
  mark(false);
  refresh_problem_line();
}

void FieldEditor::mark(bool) {}

void FieldEditor::restore() {
  clear_failure();
  display();
}

void FieldEditor::show_problems(const std::vector<core::Problem>& problems) {
  problems_ = problems;
  refresh_problem_line();
}

void FieldEditor::refresh_problem_line() {
  constexpr std::size_t most = 3;
  core::Severity worst = core::Severity::note;
  QStringList texts;
  if (!failure_.isEmpty()) {
    worst = core::Severity::error;
    texts += tr("Error: %1.").arg(failure_);
  }
  for (std::size_t i = 0; i < problems_.size(); ++i) {
    worst = std::min(worst, problems_[i].severity);
    if (i < most) texts += problem_text(problems_[i]);
  }
  if (problems_.size() > most) texts += tr("and %1 more").arg(problems_.size() - most);
  if (texts.isEmpty() || !shown_)
    problem_line_->clear();
  else
    problem_line_->show_texts(worst, texts);
  if (QWidget* own = widget()) own->setAccessibleDescription(texts.join(' '));
}

bool FieldEditor::troubled() const {
  const auto serious = [](const core::Problem& problem) { return problem.severity != core::Severity::note; };
  return refused() || std::ranges::any_of(problems_, serious);
}

void FieldEditor::set_shown(bool shown) {
  shown_ = shown;
  widget()->setVisible(shown);
  if (label_ != nullptr) label_->setVisible(shown);
  refresh_problem_line();
}

}  // namespace sarsim::gui

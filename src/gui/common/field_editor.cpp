#include "gui/common/field_editor.hpp"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QRegularExpression>
#include <QScopedValueRollback>

#include <algorithm>

#include "gui/common/palette_colours.hpp"
#include "gui/common/problem_line.hpp"

namespace sarsim::gui {

namespace {

// The colour of a text that is there without having been said. Dark buttons are lighter than the ground of lines, on
// which alone the palette's own can be read.
QColor faint_colour(const QPalette& palette, QPalette::ColorRole role) {
  const QColor faint = palette.color(QPalette::PlaceholderText);
  if (role != QPalette::ButtonText || !is_dark(palette)) return faint;
  const QColor full = palette.color(QPalette::WindowText);
  return {(faint.red() + full.red()) / 2, (faint.green() + full.green()) / 2, (faint.blue() + full.blue()) / 2};
}

// Sign, digits, decimals, exponent and unit.
const QRegularExpression& number_form() {
  static const QRegularExpression form(
      QStringLiteral(R"(^\s*([+-]?)(\d*)(?:\.(\d*))?([eE][+-]?\d+)?(\s*[^\s\d.].*)?$)"));
  return form;
}

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

QString upsampled_text(const QString& text) {
  const QRegularExpressionMatch match = number_form().match(text);
  if (!match.hasMatch() || (match.captured(2) + match.captured(3)).isEmpty()) return {};
  return match.captured(1) + match.captured(2) + '.' + match.captured(3) + '0' + match.captured(4) + match.captured(5);
}

QString stepped_text(const QString& text, int steps) {
  const QRegularExpressionMatch match = number_form().match(text);
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
  described_ = widget;
  widget->setObjectName("field_" + id());
  widget->setAccessibleName(name);
  widget->installEventFilter(this);
  reset_ = new QAction(tr("Back to Default"), widget);
  reset_->setObjectName("reset_" + id());
  reset_->setToolTip(tr("Remove this setting from the script and use the default"));
  reset_->setVisible(false);
  widget->addAction(reset_);
  connect(reset_, &QAction::triggered, this, &FieldEditor::reset_wanted);
  if (with_label) {
    label_ = new QLabel(QString(name).replace('&', QStringLiteral("&&")), widget->parentWidget());
    label_->setBuddy(widget);
  }
  refresh_tooltip();
}

void FieldEditor::refresh_tooltip() {
  QString text = tooltip_of(field_);
  if (!content_.expression.isEmpty())
    text += "<p>" + tr("Set to %1, which is %2.").arg(content_.expression, content_.value).toHtmlEscaped() + "</p>";
  if (content_.origin == FieldOrigin::by_default && !different_)
    text += "<p>" + tr("Default value (not set in the script).") + "</p>";
  described_->setToolTip(text);
  if (label_ != nullptr) label_->setToolTip(text);
}

void FieldEditor::show(const FieldContent& content) {
  const bool same = !different_ && content == content_;
  const bool stays = (same && (pending() || refused())) || keeps(content.value);
  content_ = content;
  different_ = false;
  if (!stays) {
    clear_failure();
    display();
  }
  if (same) return;
  mark(refused());
  refresh_tooltip();
  refresh_problem_line();
}

void FieldEditor::show_different(FieldOrigin origin) {
  const bool same = different_ && origin == content_.origin;
  if (different_ && (pending() || refused())) return;
  content_ = {.origin = origin};
  different_ = true;
  clear_failure();
  display();
  if (same) return;
  mark(refused());
  refresh_tooltip();
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

void FieldEditor::mark(bool failed) {
  const QScopedValueRollback marking(marking_, true);
  QPalette palette;  // Only what is set here is the field's own; the rest follows the theme.
  if (failed)
    palette.setColor(text_role(), colour_of(picture::Role::error, described_->palette()));
  else if (content_.origin == FieldOrigin::by_default && !different_)
    palette.setColor(text_role(), faint_colour(described_->palette(), text_role()));
  described_->setPalette(palette);
  reset_->setVisible(content_.origin == FieldOrigin::said);
  described_->setContextMenuPolicy(reset_->isVisible() ? Qt::ActionsContextMenu : Qt::DefaultContextMenu);
}

bool FieldEditor::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::PaletteChange && watched == described_ && !marking_) mark(refused());
  return QObject::eventFilter(watched, event);
}

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
  if (content_.origin == FieldOrigin::by_default) texts += tr("Default.");
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
  show_result();
  refresh_problem_line();
}

}  // namespace sarsim::gui

#include "gui/common/problem_line.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QStyle>

#include "gui/common/palette_colours.hpp"

namespace sarsim::gui {

QString severity_word(core::Severity severity) {
  switch (severity) {
    case core::Severity::error: return QCoreApplication::translate("ProblemLine", "Error");
    case core::Severity::warning: return QCoreApplication::translate("ProblemLine", "Warning");
    case core::Severity::note: return QCoreApplication::translate("ProblemLine", "Note");
  }
  return {};
}

QString problem_text(const core::Problem& problem) {
  QString text = severity_word(problem.severity) + ": " + QString::fromStdString(problem.message);
  const QString found = QString::fromStdString(problem.found);
  const QString expected = QString::fromStdString(problem.expected);
  if (!found.isEmpty()) text += QCoreApplication::translate("ProblemLine", "; found %1").arg(found);
  if (!expected.isEmpty())
    text += (found.isEmpty() ? QStringLiteral("; ") : QStringLiteral(", ")) +
            QCoreApplication::translate("ProblemLine", "expected %1").arg(expected);
  text += '.';
  QString hint = QString::fromStdString(problem.hint);
  if (hint.isEmpty()) return text;
  hint[0] = hint[0].toUpper();
  return text + ' ' + hint;
}

bool stands_in(const core::Place& place, const std::filesystem::path& script) {
  return place.line > 0 && (place.file.empty() || place.file == script.string());
}

QString placed_problem_text(const core::Problem& problem, const std::filesystem::path& script) {
  const QString text = problem_text(problem);
  const core::Place& place = problem.place;
  if (place.line == 0) return text;
  if (stands_in(place, script))
    return QCoreApplication::translate("ProblemLine", "Line %1: %2").arg(place.line).arg(text);
  return QCoreApplication::translate("ProblemLine", "%1, line %2: %3")
      .arg(QString::fromStdString(place.file))
      .arg(place.line)
      .arg(text);
}

QIcon severity_icon(core::Severity severity, const QWidget& widget) {
  const auto icon = severity == core::Severity::error     ? QStyle::SP_MessageBoxCritical
                    : severity == core::Severity::warning ? QStyle::SP_MessageBoxWarning
                                                          : QStyle::SP_MessageBoxInformation;
  return widget.style()->standardIcon(icon, nullptr, &widget);
}

ProblemLine::ProblemLine(QWidget* parent) : QWidget(parent), icon_(new QLabel(this)), text_(new QLabel(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(icon_, 0, Qt::AlignTop);
  layout->addWidget(text_, 1);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setFocusPolicy(Qt::NoFocus);
  setVisible(false);
}

void ProblemLine::show_texts(core::Severity severity, const QStringList& texts) {
  severity_ = severity;
  const int size = fontMetrics().height();
  icon_->setPixmap(severity_icon(severity, *this).pixmap(size, size));
  text_->setText(texts.join('\n'));
  text_->setAccessibleName(text_->text());
  colour_text();
  setVisible(!texts.isEmpty());
}

void ProblemLine::clear() {
  text_->clear();
  setVisible(false);
}

QString ProblemLine::text() const { return text_->text(); }

void ProblemLine::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colour_text();
}

void ProblemLine::colour_text() {
  const picture::Role role = severity_ == core::Severity::error     ? picture::Role::error
                             : severity_ == core::Severity::warning ? picture::Role::warning
                                                                    : picture::Role::text;
  const QColor wanted = colour_of(role, palette());
  if (text_->palette().color(QPalette::WindowText) == wanted) return;
  QPalette own;  // Only what is set here is the label's own; the rest follows the theme.
  own.setColor(QPalette::WindowText, wanted);
  text_->setPalette(own);
}

}  // namespace sarsim::gui

#include "gui/script/explanation_tip.hpp"

#include <QCoreApplication>
#include <QStringList>

#include "gui/common/text.hpp"

namespace sarsim::gui {

namespace {

using scene::language::AlternativeExplanation;
using scene::language::Explanation;
using scene::language::ExplanationLine;

constexpr std::size_t max_explained = 12;

QString html_of(const std::string& text) {
  return text_of(text).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
}

QString translated(const char* text) { return QCoreApplication::translate("ExplanationTip", text); }

QString row(const QString& name, const QString& html) {
  if (html.isEmpty()) return {};
  return QStringLiteral("<tr><td style='padding-right: 1em'>%1</td><td>%2</td></tr>").arg(name.toHtmlEscaped(), html);
}

QString units(const Explanation& explanation) {
  if (explanation.unit.empty()) return {};
  QString text = html_of(explanation.unit);
  for (const std::string& unit : explanation.other_units) text += ", " + html_of(unit);
  return text;
}

QString facts(const Explanation& explanation) {
  return row(translated("Takes"), html_of(explanation.takes)) + row(translated("Unit"), units(explanation)) +
         row(translated("Range"), html_of(explanation.range)) + row(translated("Likely"), html_of(explanation.likely)) +
         row(translated("Default"), html_of(explanation.initial)) +
         row(translated("Applies to"), html_of(explanation.applies_to)) +
         row(translated("Shorthand"), html_of(explanation.shorthand)) +
         row(translated("In a script"), html_of(explanation.in_script)) +
         row(translated("Workbench"), html_of(explanation.label));
}

QString types(const Explanation& explanation) {
  QString rows;
  for (const AlternativeExplanation& one : explanation.alternatives)
    rows += row(text_of(one.word), html_of(one.meaning));
  return rows;
}

// The last part of a path: all have the same ones before it.
QString last_part(const std::string& name) { return text_of(name.substr(name.rfind('.') + 1)); }

QString lines(const Explanation& explanation) {
  QString rows;
  for (const ExplanationLine& line : explanation.lines) {
    const QString value = line.value.empty() ? QString() : " (" + html_of(line.value) + ")";
    rows += row(last_part(line.name), html_of(line.meaning) + value);
  }
  return rows;
}

// Of paths their first parts, each once.
QString names_alone(const Explanation& explanation) {
  QStringList names;
  for (const ExplanationLine& line : explanation.lines) {
    QString name = text_of(line.name);
    if (name.startsWith(text_of(explanation.name) + '.')) name = name.section('.', 1, 1);
    if (!names.contains(name)) names += name.toHtmlEscaped();
  }
  return names.join(", ");
}

QString table(const QString& rows) {
  return rows.isEmpty() ? QString()
                        : "<table cellspacing='0' cellpadding='1' style='margin-top: 6px'>" + rows + "</table>";
}

QString paragraph(const QString& html) { return html.isEmpty() ? QString() : "<p>" + html + "</p>"; }

}  // namespace

QString explanation_tip(const Explanation& explanation) {
  const bool is_long = explanation.lines.size() > max_explained;
  QString tip = paragraph("<b>" + html_of(explanation.name) + "</b><br>" + html_of(explanation.meaning));
  tip += table(facts(explanation)) + table(types(explanation));
  tip += is_long ? paragraph(names_alone(explanation)) : table(lines(explanation));
  if (!explanation.example.empty()) tip += paragraph("<code>" + html_of(explanation.example) + "</code>");
  return tip;
}

}  // namespace sarsim::gui

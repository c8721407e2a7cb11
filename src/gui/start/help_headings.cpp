#include "gui/start/help_headings.hpp"

#include <QDir>
#include <QFile>

namespace sarsim::gui {

namespace {

// "## A heading" is two; other lines are none.
qsizetype level_of_heading(const QString& line) {
  qsizetype level = 0;
  while (level < line.size() && line[level] == u'#') ++level;
  return level < line.size() && line[level] == u' ' ? level : 0;
}

// A heading as it is read: without the signs of code.
QString plain_heading(const QString& line, qsizetype level) { return line.mid(level + 1).remove('`').trimmed(); }

void add_page(const QString& folder, const QString& page, std::vector<HelpHeading>& headings) {
  constexpr qsizetype deepest = 3;
  QFile file(folder + "/" + page);
  if (!file.open(QIODevice::ReadOnly)) return;
  QString title;
  bool code = false;
  while (!file.atEnd()) {
    const QString line = QString::fromUtf8(file.readLine());
    if (line.startsWith("```")) code = !code;
    const qsizetype level = code ? 0 : level_of_heading(line);
    if (level == 0 || level > deepest) continue;
    const QString heading = plain_heading(line, level);
    if (title.isEmpty())
      headings.push_back({page, title = heading, {}});
    else
      headings.push_back({page, title, heading});
  }
}

}  // namespace

std::vector<HelpHeading> help_headings(const QString& folder) {
  std::vector<HelpHeading> headings;
  if (folder.isEmpty()) return headings;
  for (const char* room : {"guide", "guide/recipes", "formats", "theory"})
    for (const QString& name : QDir(folder + "/" + room).entryList({"*.md"}, QDir::Files, QDir::Name))
      add_page(folder, QString(room) + "/" + name, headings);
  return headings;
}

}  // namespace sarsim::gui

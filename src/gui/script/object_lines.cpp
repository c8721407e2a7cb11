#include "gui/script/object_lines.hpp"

#include <QTextBlock>

#include "scene/language/cursor.hpp"

namespace sarsim::gui {

namespace {

constexpr int max_lines_above = 2000;
constexpr int max_lines_below = 300;

bool begins_object(const QTextBlock& line) {
  const QString text = line.text();
  return text.trimmed().startsWith(u'[') && scene::language::begins_object(text.toStdString());
}

}  // namespace

int ObjectLines::position_of(std::size_t byte) const {
  return begin + static_cast<int>(QString::fromUtf8(text.data(), static_cast<qsizetype>(byte)).size());
}

std::optional<ObjectLines> object_lines(const QTextDocument& document, int position) {
  const QTextBlock here = document.findBlock(position);
  QTextBlock first = here;
  for (int above = 0; !begins_object(first) && first.previous().isValid(); first = first.previous())
    if (++above > max_lines_above) return std::nullopt;
  ObjectLines lines;
  lines.begin = first.position();
  QTextBlock line = first;
  for (; line != here; line = line.next()) lines.text += line.text().toStdString() + '\n';
  lines.offset = lines.text.size() + here.text().left(position - here.position()).toStdString().size();
  for (int below = 0; line.isValid() && below < max_lines_below; line = line.next(), ++below) {
    if (line != here && begins_object(line)) break;
    lines.text += line.text().toStdString() + '\n';
  }
  if (!line.isValid()) lines.text.pop_back();
  return lines;
}

}  // namespace sarsim::gui

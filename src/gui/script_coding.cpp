#include "gui/script_coding.hpp"

#include <QStringDecoder>

#include <algorithm>

namespace sarsim {

namespace {

QByteArrayView view_of(std::string_view text) { return {text.data(), static_cast<qsizetype>(text.size())}; }

ScriptCoding::LineEnd line_end_of(std::string_view text) {
  const std::size_t feed = text.find('\n');
  if (feed == std::string_view::npos)
    return text.find('\r') == std::string_view::npos ? ScriptCoding::LineEnd::lf : ScriptCoding::LineEnd::cr;
  return feed > 0 && text[feed - 1] == '\r' ? ScriptCoding::LineEnd::crlf : ScriptCoding::LineEnd::lf;
}

}  // namespace

ScriptCoding coding_of(std::string_view text) { return {!view_of(text).isValidUtf8(), line_end_of(text)}; }

QString decoded(std::string_view text, const ScriptCoding& coding) {
  QString result = coding.latin1 ? QString::fromLatin1(view_of(text)) : QString::fromUtf8(view_of(text));
  if (!result.contains(u'\r')) return result;
  if (coding.line_end == ScriptCoding::LineEnd::cr) return result.replace(u'\r', u'\n');
  return result.replace(QStringLiteral("\r\n"), QStringLiteral("\n")).replace(u'\r', u' ');
}

std::string encoded(const QString& text, const ScriptCoding& coding) {
  QString lines = text;
  if (coding.line_end == ScriptCoding::LineEnd::crlf) lines.replace(u'\n', QStringLiteral("\r\n"));
  if (coding.line_end == ScriptCoding::LineEnd::cr) lines.replace(u'\n', u'\r');
  const bool fits = std::ranges::all_of(lines, [](QChar c) { return c.unicode() <= 0xFF; });
  return (coding.latin1 && fits ? lines.toLatin1() : lines.toUtf8()).toStdString();
}

int position_of_column(const QString& line, std::size_t column, const ScriptCoding& coding) {
  const auto offset = static_cast<qsizetype>(column > 0 ? column - 1 : 0);
  if (coding.latin1) return static_cast<int>(std::min(offset, line.size()));
  qsizetype bytes = 0;
  qsizetype at = 0;
  while (at < line.size() && bytes < offset) {
    const bool pair = line[at].isHighSurrogate() && at + 1 < line.size();
    const char16_t unit = line[at].unicode();
    bytes += pair ? 4 : unit < 0x80 ? 1 : unit < 0x800 ? 2 : 3;
    at += pair ? 2 : 1;
  }
  return static_cast<int>(at);
}

}  // namespace sarsim

#include "gui/script/script_highlighter.hpp"

#include <QTextLayout>

#include "gui/common/palette_colours.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/schema/grammar.hpp"
#include "scene/script/tokens.hpp"

namespace sarsim::gui {

namespace {

ScriptPart part_of(const scene::script::Token& token) {
  if (token.kind == scene::script::TokenKind::command) return ScriptPart::command;
  if (token.kind == scene::script::TokenKind::quoted) return ScriptPart::name;
  if (scene::script::is_keyword(token.text)) return ScriptPart::keyword;
  return scene::script::begins_like_number(token.text) ? ScriptPart::number : ScriptPart::name;
}

// A header and nothing else but a comment, rather than a row of an array.
bool is_header(QStringView rest) {
  const qsizetype comment = rest.indexOf(u'#');
  const QStringView text = (comment < 0 ? rest : rest.left(comment)).trimmed();
  return text.endsWith(u']') && !text.contains(u',') && text.size() > 2 &&
         (text[1] == u'[' || text[1].isLetter() || text[1] == u'"');
}

}  // namespace

std::vector<ScriptSpan> script_spans(const QString& line) {
  // One byte for each character, so that offsets in both are the same; the language's own characters are all in ASCII.
  const QByteArray bytes = line.toLatin1();
  std::vector<ScriptSpan> spans;
  scene::script::Tokens tokens(std::string_view(bytes.data(), static_cast<std::size_t>(bytes.size())));
  qsizetype behind = 0;
  for (scene::script::Token token = tokens.take(); token.kind != scene::script::TokenKind::end; token = tokens.take()) {
    const int at = static_cast<int>(token.column) - 1;
    behind = token.text.data() - bytes.data() + static_cast<qsizetype>(token.text.size());
    if (token.kind == scene::script::TokenKind::quoted && !token.open_quote) ++behind;
    spans.push_back({at, static_cast<int>(behind) - at, part_of(token)});
  }
  const qsizetype comment = line.indexOf(u'!', behind);
  if (comment >= 0)
    spans.push_back({static_cast<int>(comment), static_cast<int>(line.size() - comment), ScriptPart::comment});
  return spans;
}

std::vector<ScriptSpan> format_2_spans(const QString& line) {
  std::vector<ScriptSpan> spans;
  const auto is_word = [](QChar c) { return c.isLetterOrNumber() || QStringLiteral("_-+.:").contains(c); };
  const auto add = [&](qsizetype from, qsizetype to, ScriptPart part) {
    spans.push_back({static_cast<int>(from), static_cast<int>(to - from), part});
    return to;
  };
  for (qsizetype at = 0; at < line.size();) {
    const QChar c = line[at];
    if (c == u'#') {
      at = add(at, line.size(), ScriptPart::comment);
    } else if (c == u'"' || c == u'\'') {
      qsizetype end = at + 1;
      while (end < line.size() && line[end] != c) end += c == u'"' && line[end] == u'\\' ? 2 : 1;
      at = add(at, std::min(end + 1, line.size()), ScriptPart::name);
    } else if (c == u'[' && spans.empty() && QStringView(line).left(at).trimmed().isEmpty() &&
               is_header(QStringView(line).sliced(at))) {
      at = add(at, line.lastIndexOf(u']', line.indexOf(u'#') < 0 ? -1 : line.indexOf(u'#')) + 1, ScriptPart::command);
    } else if (is_word(c)) {
      qsizetype end = at;
      while (end < line.size() && is_word(line[end])) ++end;
      const bool is_key = QStringView(line).sliced(end).trimmed().startsWith(u'=');
      at = add(at, end, is_key ? ScriptPart::keyword : ScriptPart::number);
    } else {
      ++at;
    }
  }
  return spans;
}

bool is_format_2(const QTextDocument& text) {
  QTextBlock first = text.firstBlock();
  while (first.isValid() && first.text().trimmed().isEmpty()) first = first.next();
  return first.isValid() && scene::is_format_2(first.text().toStdString());
}

void ScriptHighlighter::set_palette(const QPalette& palette) {
  dark_ = is_dark(palette);
  const auto set = [&](ScriptPart part, picture::Role role, bool bold, bool italic) {
    QTextCharFormat& format = formats_[static_cast<std::size_t>(part)];
    format.setForeground(colour_of(role, palette));
    format.setFontWeight(bold ? QFont::Bold : QFont::Normal);
    format.setFontItalic(italic);
  };
  set(ScriptPart::command, picture::Role::curve, true, false);
  set(ScriptPart::keyword, picture::Role::curve_2, true, false);
  set(ScriptPart::number, picture::Role::text, false, false);
  set(ScriptPart::name, picture::Role::hovered, false, false);
  set(ScriptPart::comment, picture::Role::curve_3, false, true);
}

void ScriptHighlighter::colour(QTextBlock line) const {
  const QString text = line.text();
  const bool format_2 = is_format_2(*line.document());
  const std::size_t kind = (dark_ ? 1U : 2U) + (format_2 ? 2U : 0U);
  const int stamp = static_cast<int>(qHash(text, kind) & 0x7FFFFFFF);  // Lines that were never coloured have -1.
  if (line.userState() == stamp) return;
  QList<QTextLayout::FormatRange> ranges;
  for (const ScriptSpan& span : format_2 ? format_2_spans(text) : script_spans(text))
    ranges += {span.at, span.length, formats_[static_cast<std::size_t>(span.part)]};
  line.setUserState(stamp);
  line.layout()->setFormats(ranges);
  line.clearLayout();
}

}  // namespace sarsim::gui

#include "gui/script/script_highlighter.hpp"

#include <QTextLayout>

#include "gui/common/palette_colours.hpp"
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
  const int stamp =
      static_cast<int>(qHash(text, dark_ ? 1 : 2) & 0x7FFFFFFF);  // Lines that were never coloured have -1.
  if (line.userState() == stamp) return;
  QList<QTextLayout::FormatRange> ranges;
  for (const ScriptSpan& span : script_spans(text))
    ranges += {span.at, span.length, formats_[static_cast<std::size_t>(span.part)]};
  line.setUserState(stamp);
  line.layout()->setFormats(ranges);
  line.clearLayout();
}

}  // namespace sarsim::gui

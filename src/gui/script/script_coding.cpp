#include "gui/script/script_coding.hpp"

#include <QStringDecoder>

#include <algorithm>
#include <cstdint>

namespace sarsim::gui {

namespace {

QByteArrayView view_of(std::string_view text) { return {text.data(), static_cast<qsizetype>(text.size())}; }

ScriptCoding::LineEnd line_end_of(std::string_view text) {
  const std::size_t feed = text.find('\n');
  if (feed == std::string_view::npos)
    return text.find('\r') == std::string_view::npos ? ScriptCoding::LineEnd::lf : ScriptCoding::LineEnd::cr;
  return feed > 0 && text[feed - 1] == '\r' ? ScriptCoding::LineEnd::crlf : ScriptCoding::LineEnd::lf;
}

bool is_ascii(std::string_view text) {
  unsigned char all = 0;
  for (const char c : text) all |= static_cast<unsigned char>(c);
  return all < 0x80;
}

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

// How many UTF-16 units a part of a text takes when it is decoded. In 32 bits, which the compiler counts in vectors.
int decoded_size(std::string_view text, const ScriptCoding& coding) {
  std::uint32_t units = 0;
  if (coding.latin1) {
    units = static_cast<std::uint32_t>(text.size());
  } else {
    for (const char c : text)
      units += (static_cast<unsigned char>(c) & 0xC0) == 0x80 ? 0U : static_cast<unsigned char>(c) >= 0xF0 ? 2U : 1U;
  }
  if (coding.line_end == ScriptCoding::LineEnd::cr) return static_cast<int>(units);
  std::uint32_t pairs = 0;
  for (std::size_t i = 1; i < text.size(); ++i) pairs += text[i] == '\n' && text[i - 1] == '\r' ? 1U : 0U;
  return static_cast<int>(units - pairs);
}

// True where a change leaves the coding of the rest as it is and cuts through nothing.
bool is_simple(std::string_view out, std::string_view in, std::string_view text, std::size_t begin,
               const ScriptCoding& coding) {
  if (!is_ascii(out) || !is_ascii(in)) return false;
  const std::size_t end = begin + in.size();
  // What stood apart may have become one character.
  if ((begin > 0 && !is_ascii(text[begin - 1])) || (end < text.size() && !is_ascii(text[end]))) return false;
  if (coding.line_end == ScriptCoding::LineEnd::cr) return true;
  if (begin > 0 && text[begin - 1] == '\r') return false;
  return end >= text.size() || text[end] != '\n' || (!out.ends_with('\r') && !in.ends_with('\r'));
}

}  // namespace

std::optional<std::vector<DecodedChange>> decoded_changes(const scene::TextChanges& changes, bool forwards,
                                                          std::string_view text, const ScriptCoding& coding) {
  if (line_end_of(text) != coding.line_end) return std::nullopt;
  std::vector<DecodedChange> decoded_ones;
  std::size_t grown = 0;    // modulo 2^n
  std::size_t counted = 0;  // bytes of the text
  int position = 0;         // of those in the decoded text
  for (const scene::TextChange& change : changes) {
    const std::string& out = forwards ? change.before : change.after;
    const std::string& in = forwards ? change.after : change.before;
    const std::size_t begin = forwards ? change.at + grown : change.at;
    grown += change.after.size() - change.before.size();
    if (begin < counted || begin + in.size() > text.size() || !is_simple(out, in, text, begin, coding))
      return std::nullopt;
    position += decoded_size(text.substr(counted, begin - counted), coding);
    DecodedChange made{position, decoded_size(out, coding), decoded(in, coding)};
    position += static_cast<int>(made.put_in.size());
    counted = begin + in.size();
    decoded_ones.push_back(std::move(made));
  }
  return decoded_ones;
}

QString changed_text(QString text, const std::vector<DecodedChange>& changes) {
  // Each moves what stands behind it: of many at once all of it is put together anew.
  constexpr std::size_t few = 8;
  if (changes.size() <= few) {
    for (const DecodedChange& change : changes) text.replace(change.at, change.removed, change.put_in);
    return text;
  }
  QString result;
  result.reserve(text.size());
  qsizetype taken = 0;  // of the text before
  for (const DecodedChange& change : changes) {
    const qsizetype before = change.at - result.size();
    result.append(QStringView(text).mid(taken, before));
    result.append(change.put_in);
    taken += before + change.removed;
  }
  return result.append(QStringView(text).mid(taken));
}

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

}  // namespace sarsim::gui

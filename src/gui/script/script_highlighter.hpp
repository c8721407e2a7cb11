#pragma once

#include <QPalette>
#include <QTextBlock>
#include <QTextCharFormat>
#include <QTextDocument>

#include <array>
#include <vector>

namespace sarsim::gui {

/// What a stretch of script text is.
enum class ScriptPart { command, keyword, number, name, comment, count };

/// One stretch of a line, in characters.
struct ScriptSpan {
  int at = 0;
  int length = 0;
  ScriptPart part = ScriptPart::name;

  friend bool operator==(const ScriptSpan&, const ScriptSpan&) = default;
};

/// The words and the comment of one line of a script, in order.
[[nodiscard]] std::vector<ScriptSpan> script_spans(const QString& line);

/// The same of a line of format 2: headers are commands, keys are keywords, strings are names. A line alone does not
/// show that it is inside of a string of several lines, which scenes do not need.
[[nodiscard]] std::vector<ScriptSpan> format_2_spans(const QString& line);

/// Whether a text is format 2, told by its first line that holds anything.
[[nodiscard]] bool is_format_2(const QTextDocument& text);

/// Colours a script: commands, keywords, numbers, comments. Weight and slant tell the parts apart as well as colour
/// does. Lines are coloured one by one, when they are about to be seen, so that long scripts cost no more than short
/// ones.
class ScriptHighlighter {
 public:
  /// Takes the colours that suit a palette.
  void set_palette(const QPalette& palette);
  /// Colours a line, unless that was done since its text or the colours changed; it has to be laid out again then.
  void colour(QTextBlock line) const;

 private:
  std::array<QTextCharFormat, static_cast<std::size_t>(ScriptPart::count)> formats_;
  bool dark_ = false;
};

}  // namespace sarsim::gui

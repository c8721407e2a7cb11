#pragma once

#include <QPalette>
#include <QSyntaxHighlighter>
#include <QTextCharFormat>

#include <array>
#include <vector>

namespace sarsim {

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

/// Colours a script: commands, keywords, numbers, comments. Weight and slant tell the parts apart as well as colour
/// does.
class ScriptHighlighter : public QSyntaxHighlighter {
  Q_OBJECT

 public:
  explicit ScriptHighlighter(QTextDocument* document);

  /// Takes the colours that suit a palette and colours the text anew.
  void set_palette(const QPalette& palette);

 protected:
  void highlightBlock(const QString& line) override;

 private:
  std::array<QTextCharFormat, static_cast<std::size_t>(ScriptPart::count)> formats_;
  bool dark_ = false;
  bool coloured_ = false;
};

}  // namespace sarsim

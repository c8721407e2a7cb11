#pragma once

#include <QString>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/edit/text_change.hpp"

namespace sarsim::gui {

/// How the characters and lines of a script stand in its bytes, so that an editor gives back what it was given: UTF-8,
/// or Latin-1 where that cannot be (scripts of the 1998 programs); line ends LF, CR LF or CR.
struct ScriptCoding {
  /// The bytes that end a line.
  enum class LineEnd { lf, crlf, cr };

  bool latin1 = false;
  LineEnd line_end = LineEnd::lf;

  friend bool operator==(const ScriptCoding&, const ScriptCoding&) = default;
};

/// The coding of a text: that of its first line end; LF where it has none.
[[nodiscard]] ScriptCoding coding_of(std::string_view text);

/// The text with '\n' at the ends of lines. A carriage return that ends no line, a separator like a blank, becomes one.
[[nodiscard]] QString decoded(std::string_view text, const ScriptCoding& coding);
/// Back to bytes. Characters that Latin-1 has not turn the whole text into UTF-8.
[[nodiscard]] std::string encoded(const QString& text, const ScriptCoding& coding);

/// A stretch of a decoded text put in place of another.
struct DecodedChange {
  int at = 0;
  int removed = 0;
  QString put_in;
};

/// What changes of the bytes are to the decoded text, to be made in turn. Takes a fraction of the time of decoding;
/// where only decoding all of the text would tell, because of characters of several bytes or line ends cut through,
/// nothing.
///
/// @param forwards  the changes were applied, rather than reverted
/// @param text      after that
/// @param coding    of the text before
[[nodiscard]] std::optional<std::vector<DecodedChange>> decoded_changes(const scene::TextChanges& changes,
                                                                        bool forwards, std::string_view text,
                                                                        const ScriptCoding& coding);

/// The decoded text after changes that come in the order of their places; takes time linear in the text.
[[nodiscard]] QString changed_text(QString text, const std::vector<DecodedChange>& changes);

/// Position in a decoded line (from 0) of a column in bytes (from 1); the line's length for a column beyond its end.
[[nodiscard]] int position_of_column(const QString& line, std::size_t column, const ScriptCoding& coding);

}  // namespace sarsim::gui

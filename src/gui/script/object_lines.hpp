#pragma once

#include <QTextDocument>

#include <cstddef>
#include <optional>
#include <string>

namespace sarsim::gui {

/// The lines of a script of format 2 that belong to the object around a place, as bytes.
struct ObjectLines {
  std::string text;
  std::size_t offset = 0;  ///< Of the place, in `text`.
  int begin = 0;           ///< Of the first line, in the document.

  /// The position in the document of a byte of `text`.
  [[nodiscard]] int position_of(std::size_t byte) const;
};

/// The object around a position: from its header up to the next one, or a few hundred lines of it. Nothing where the
/// header is so far above that looking for it would be felt while one types. Takes no longer in a longer document.
[[nodiscard]] std::optional<ObjectLines> object_lines(const QTextDocument& document, int position);

}  // namespace sarsim::gui

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/toml/document.hpp"

namespace sarsim::core::toml {

/// Where a byte stands; both count from 1, the column in bytes.
struct Position {
  std::size_t line = 1;
  std::size_t column = 1;

  friend bool operator==(const Position&, const Position&) = default;
};

/// Lines and columns of the bytes of a text, which must outlive it. A question costs the way from the one before, so
/// that ascending offsets cost one pass over the text. Lines end with line feeds.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  /// The place of a byte; offsets behind the text are taken as its end.
  [[nodiscard]] Position at(std::uint32_t offset);

 private:
  std::string_view text_;
  std::size_t offset_ = 0;      // of the question before
  std::size_t line_ = 1;        // its line
  std::size_t line_begin_ = 0;  // where that begins
};

/// Where the comment lines directly above a header or key begin: at the first byte of the first of them, blanks
/// included. Where the line above is none, the begin of the line itself. Lines that belong to the value or header above
/// are not taken for comments, even if they look so.
/// @param offset  of the first byte of a header or key of the document
[[nodiscard]] std::uint32_t comments_begin(std::string_view text, const Document& document, std::uint32_t offset);

}  // namespace sarsim::core::toml

#pragma once

#include <cstddef>
#include <vector>

#include "core/task/parallel.hpp"
#include "scene/script/tokens.hpp"

namespace sarsim::scene::script {

/// A part of a script that means the same read by itself: whole lines, up to the next part, of which the first (but not
/// that of the script) begins with a command.
struct Piece {
  std::size_t begin = 0;  ///< In `Tokens::text`.
  std::size_t end = 0;
  std::size_t first_line = 1;
  std::size_t end_line = static_cast<std::size_t>(-1);  ///< First line of the next part; of the last: no line at all.
};

/// Cuts a script into parts of about `piece_bytes`, longer where no line begins with a command for so long. Comments
/// and quotes end with their line, and nothing but a command can begin a line with '$', so that nothing is ever cut
/// through.
/// @param whole        the tokens of the script, none of them taken
/// @param piece_bytes  at least 1
[[nodiscard]] std::vector<Piece> cut(const Tokens& whole, std::size_t piece_bytes, const core::WorkControl& control);

}  // namespace sarsim::scene::script

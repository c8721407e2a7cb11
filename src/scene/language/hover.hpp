#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "scene/language/explanation.hpp"

namespace sarsim::scene::language {

/// The explanation of what stands at a byte of a text of format 2: of a key, a header, the word of a choice. Nothing
/// where there is none.
/// @param text    may begin with the header of the object around the byte, and end behind it
/// @param offset  of the byte
[[nodiscard]] std::optional<Explanation> explanation_at(std::string_view text, std::size_t offset);

/// The explanation of a command of the 1998 language, without `$`: of what it makes, with the values behind it in their
/// order. Nothing where there is none.
[[nodiscard]] std::optional<Explanation> explanation_of_command(std::string_view command);

}  // namespace sarsim::scene::language

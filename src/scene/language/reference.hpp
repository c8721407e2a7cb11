#pragma once

#include <string>

namespace sarsim::scene::language {

/// The reference of format 2 in Markdown: each kind of object with its fields, each choice with its alternatives, and
/// what the 1998 language calls them.
[[nodiscard]] std::string reference();

}  // namespace sarsim::scene::language

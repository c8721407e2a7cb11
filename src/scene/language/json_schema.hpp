#pragma once

#include <string>

namespace sarsim::scene::language {

/// The JSON Schema (draft 4) of format 2, for editors: every field with its meaning, unit, range and default. It
/// refuses no unknown keys: editors that mark each of them do so better without, and `sarsim check` says more.
[[nodiscard]] std::string json_schema();

}  // namespace sarsim::scene::language

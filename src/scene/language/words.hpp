#pragma once

#include <string>

#include "core/report/problem.hpp"

namespace sarsim::scene {

/// A sentence that names commands and options of the language of 1998, in the words of format 2: "$SIMULATION" becomes
/// "[[recording]]", "CUBIC_ENDS NOT_A_KNOT in $OPTIONS" becomes "cubic_ends = "not-a-knot" in [options]".
[[nodiscard]] std::string in_format_2(std::string sentence);

/// The same for all that problems say; what was found stays as it is.
void say_in_format_2(core::Problems& problems);

}  // namespace sarsim::scene

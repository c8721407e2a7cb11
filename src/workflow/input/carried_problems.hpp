#pragma once

#include "core/report/problem.hpp"

namespace sarsim::workflow {

/// Takes out of a problem of a file that a script inside a recording names what that file says: nobody asked for it. Of
/// what was found, numbers and the words of measurements stay, "about 0.034 m off near 12 s"; anything else becomes
/// "...", and what has no number at all is dropped. Quotes in messages become '...'.
void drop_quotes(core::Problem& problem);
/// The same of all.
[[nodiscard]] core::Problems without_quotes(core::Problems problems);

}  // namespace sarsim::workflow

#pragma once

#include <string>

namespace sarsim::workflow {

/// Has everybody take one instruction set, so that different processors make the same bytes; an empty level leaves the
/// best there is. Throws core::InvalidRequest with the levels of this processor where it has no such one.
void choose_simd(const std::string& level);

}  // namespace sarsim::workflow

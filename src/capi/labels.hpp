#pragma once

#include <cstddef>
#include <vector>

#include "workflow/options/option.hpp"

namespace sarsim::capi {

/// The options "NAME=VALUE" of a caller, as requests take them. Throws core::InvalidRequest with everything that is
/// wrong with them, BadArgument where a pointer is null.
[[nodiscard]] workflow::GivenWords words_of(const std::vector<workflow::Option>& options, const char* const* words,
                                            std::size_t count);

}  // namespace sarsim::capi

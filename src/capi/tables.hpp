#pragma once

#include <string>

#include "capi/sarsim.h"

namespace sarsim::capi {

/// A table as a handle, from the comma-separated values that it is written as.
[[nodiscard]] sarsim_table* table_handle(std::string csv);

}  // namespace sarsim::capi

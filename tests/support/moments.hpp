#pragma once

#include "workflow/verify/moments.hpp"

namespace sarsim::test {

using namespace verify;

}  // namespace sarsim::test

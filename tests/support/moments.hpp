#pragma once

#include "workflow/verify/moments.hpp"

namespace sarsim::test {

using namespace workflow::verify;

}  // namespace sarsim::test

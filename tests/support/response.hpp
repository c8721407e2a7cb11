#pragma once

#include "support/scenes.hpp"
#include "workflow/verify/response.hpp"

namespace sarsim::test {

using namespace workflow::verify;

}  // namespace sarsim::test

#pragma once

#include "workflow/verify/scenes.hpp"

/// The scenes that `sarsim verify` measures with serve the tests, too.
namespace sarsim::test {

using namespace workflow::verify;

}  // namespace sarsim::test

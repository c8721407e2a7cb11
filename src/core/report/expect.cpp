#include "core/report/expect.hpp"

namespace sarsim::core {

bool checks_expectations() {
#if defined(SARSIM_EXPECTATIONS) && SARSIM_EXPECTATIONS
  return true;
#else
  return false;
#endif
}

}  // namespace sarsim::core

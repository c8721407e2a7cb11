// The header as C++20: it has no C++ in it, but may be included there.
#include "sarsim.h"

int main() {
  sarsim_work work = SARSIM_INIT(sarsim_work);
  return sarsim_abi_version() == SARSIM_ABI_VERSION && work.struct_size == sizeof work && work.stop == nullptr ? 0 : 1;
}

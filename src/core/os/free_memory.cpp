#include "core/os/free_memory.hpp"

#include <fstream>
#include <string>

namespace sarsim::core {

std::optional<std::size_t> free_memory_bytes() {
  std::ifstream info("/proc/meminfo");
  std::string name;
  std::size_t kilobytes = 0;
  std::string unit;
  while (info >> name >> kilobytes) {
    std::getline(info, unit);
    if (name == "MemAvailable:") return kilobytes * 1024;
  }
  return std::nullopt;
}

}  // namespace sarsim::core

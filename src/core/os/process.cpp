#include "core/os/process.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>

#include <fmt/format.h>

namespace sarsim::core {

long process_id() { return ::getpid(); }

std::string host_name() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return host.data();
}

std::uint64_t process_start(long process) {
  std::ifstream stream(fmt::format("/proc/{}/stat", process));
  std::string line;
  std::getline(stream, line);
  const std::size_t name_end = line.rfind(')');  // the name may hold anything, blanks too
  if (name_end == std::string::npos) return 0;
  std::size_t at = name_end + 1;
  constexpr int fields_between = 20;
  for (int i = 0; i < fields_between && at != std::string::npos; ++i) at = line.find(' ', at + (i > 0 ? 1 : 0));
  if (at == std::string::npos) return 0;
  std::uint64_t ticks = 0;
  std::from_chars(line.data() + at + 1, line.data() + line.size(), ticks);
  return ticks;
}

bool is_running(long process, std::uint64_t start) {
  if (process <= 0 || (::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH)) return false;
  const std::uint64_t present = process_start(process);
  return start == 0 || present == 0 || start == present;
}

std::error_code write_failure(const std::filesystem::path& path) {
  if (::access(path.c_str(), W_OK) == 0) return {};
  return {errno, std::generic_category()};
}

}  // namespace sarsim::core

#include "core/os/disk_room.hpp"

#include <optional>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::core {

namespace fs = std::filesystem;

namespace {

// Bytes that are free, where they are too few.
std::optional<double> room_if_too_little(const fs::path& folder, double bytes) {
  fs::path there = fs::absolute(folder);
  while (!fs::exists(there) && there.has_relative_path()) there = there.parent_path();
  std::error_code failure;
  const fs::space_info space = fs::space(there, failure);
  if (failure || bytes <= static_cast<double>(space.available)) return std::nullopt;
  return static_cast<double>(space.available);
}

}  // namespace

void expect_room(const fs::path& folder, double bytes, const std::string& advice) {
  const std::optional<double> free = room_if_too_little(folder, bytes);
  if (!free) return;
  throw std::runtime_error(
      fmt::format("the disk of '{}' has not enough room: {} are needed, {} are free. Make room, {}.", folder.string(),
                  bytes_text(bytes), bytes_text(*free), advice));
}

}  // namespace sarsim::core

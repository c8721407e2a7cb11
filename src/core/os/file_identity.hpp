#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace sarsim::core {

/// What tells a file from every other on this machine, whatever names it has: its file system and its number there.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t number = 0;
  auto operator<=>(const FileIdentity&) const = default;
};

/// When the content of a file was changed last.
struct FileTime {
  std::int64_t seconds = 0;  ///< Since 1970.
  std::int64_t nanoseconds = 0;
  auto operator<=>(const FileTime&) const = default;
};

/// What a file system knows of a file.
struct FileStatus {
  FileIdentity identity;
  bool folder = false;
  bool regular = false;
  std::uint64_t bytes = 0;
  FileTime changed;
};

/// Links are followed. Nothing where there is no such file.
[[nodiscard]] std::optional<FileStatus> file_status(const std::filesystem::path& path);

/// The same of what has the name itself, a link for instance.
[[nodiscard]] std::optional<FileStatus> link_status(const std::filesystem::path& path);

/// Of whatever a path leads to; nothing where there is nothing.
[[nodiscard]] std::optional<FileIdentity> identity_of(const std::filesystem::path& path);

/// Of a regular file; nothing for anything else.
[[nodiscard]] std::optional<FileIdentity> identity_of_file(const std::filesystem::path& path);

}  // namespace sarsim::core

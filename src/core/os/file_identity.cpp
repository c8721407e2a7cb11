#include "core/os/file_identity.hpp"

#include <sys/stat.h>

namespace sarsim::core {

namespace {

FileStatus status_of(const struct stat& status) {
  return {.identity = {status.st_dev, status.st_ino},
          .folder = S_ISDIR(status.st_mode),
          .regular = S_ISREG(status.st_mode),
          .bytes = static_cast<std::uint64_t>(status.st_size),
          .changed = {status.st_mtim.tv_sec, status.st_mtim.tv_nsec}};
}

}  // namespace

std::optional<FileStatus> file_status(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status_of(status);
}

std::optional<FileStatus> link_status(const std::filesystem::path& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return std::nullopt;
  return status_of(status);
}

std::optional<FileIdentity> identity_of(const std::filesystem::path& path) {
  const std::optional<FileStatus> status = file_status(path);
  return status ? std::optional(status->identity) : std::nullopt;
}

std::optional<FileIdentity> identity_of_file(const std::filesystem::path& path) {
  const std::optional<FileStatus> status = file_status(path);
  return status && status->regular ? std::optional(status->identity) : std::nullopt;
}

}  // namespace sarsim::core

#include "core/os/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/os/write_behind.hpp"

namespace sarsim::core {

namespace fs = std::filesystem;

namespace {

constexpr int max_links = 40;
constexpr std::size_t longest_name = 255;  // NAME_MAX of every common file system.

[[noreturn]] void throw_error(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

int rename_without_replacing(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != ENOSYS && errno != EINVAL) return errno;
  if (::link(from.c_str(), to.c_str()) == 0) {
    ::unlink(from.c_str());
    return 0;
  }
  if (errno == EEXIST) return errno;
  // Neither call is known to this file system. An empty file made exclusively reserves the name.
  const int reserved = ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (reserved < 0) return errno;
  ::close(reserved);
  if (::rename(from.c_str(), to.c_str()) == 0) return 0;
  const int error = errno;
  ::unlink(to.c_str());
  return error;
}

}  // namespace

fs::path end_of_links(const fs::path& path) {
  fs::path place = path;
  for (int i = 0; i < max_links; ++i) {
    std::error_code error;
    const fs::path next = fs::read_symlink(place, error);
    if (error) return place;
    place = next.is_absolute() ? next : place.parent_path() / next;
  }
  throw_error(ELOOP, fmt::format("cannot create {}", path.string()));
}

fs::path temporary_name(const fs::path& target) {
  static std::atomic<unsigned> serial{0};
  const std::string tail = fmt::format(".partial-{}-{}", ::getpid(), serial.fetch_add(1));
  std::string name = target.filename().string();
  name.resize(std::min(name.size(), longest_name - 1 - tail.size()));
  return target.parent_path() / ("." + name + tail);
}

OutputFile::OutputFile(fs::path path, bool replace) : path_(std::move(path)), replace_(replace) {
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail(errno, "create");
  if (!path_.has_filename()) fail(exists || path_.has_parent_path() ? EISDIR : ENOENT, "create");
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR, "create");
  if (exists && S_ISBLK(status.st_mode)) throw_error(ENOTSUP, "cannot write to the block device " + path_.string());
  if (exists && !S_ISREG(status.st_mode)) {
    open_directly();
    return;
  }
  if (exists && !replace) throw_error(EEXIST, fmt::format("cannot create {}", path_.string()));
  target_ = end_of_links(path_);
  create_temporary(exists ? status.st_mode & 07777U : 0U);
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::fail(int error, const char* action) const {
  throw_error(error, fmt::format("cannot {} {}", action, path_.string()));
}

void OutputFile::open_directly() {
  direct_ = true;
  working_path_ = path_;
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail(errno, "open");
  seekable_ = ::lseek(descriptor_, 0, SEEK_CUR) >= 0;
}

void OutputFile::create_temporary(unsigned mode) {
  constexpr int max_attempts = 1000;  // A killed process of the same number may have left some names behind.
  for (int i = 0; i < max_attempts && descriptor_ < 0; ++i) {
    working_path_ = temporary_name(target_);
    temporary_ = TemporaryName(working_path_);
    descriptor_ = ::open(working_path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST && errno != EINTR) break;
  }
  if (descriptor_ < 0) {
    const int error = errno;
    temporary_.forget();
    working_path_.clear();
    const std::string folder = target_.has_parent_path() ? target_.parent_path().string() : ".";
    throw_error(error, fmt::format("cannot create {} in folder {}", path_.string(), folder));
  }
  if (mode != 0) ::fchmod(descriptor_, static_cast<mode_t>(mode));  // As near to the old file's as we may.
}

void OutputFile::write(std::span<const std::byte> bytes) {
  if (descriptor_ < 0) throw std::logic_error("OutputFile: written after the end: " + path_.string());
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), std::min(bytes.size(), write_behind_bytes));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      failed_ = true;
      fail(written < 0 ? errno : EIO, "write");
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    const off_t end = direct_ ? -1 : ::lseek(descriptor_, 0, SEEK_CUR);
    if (end < 0) continue;
    const auto offset = static_cast<std::uint64_t>(end - written);
    if (const int error = write_behind(descriptor_, offset, static_cast<std::size_t>(written)); error != 0) {
      failed_ = true;
      fail(error, "write");
    }
  }
}

void OutputFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  if (descriptor_ < 0) throw std::logic_error("OutputFile: written after the end: " + path_.string());
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(descriptor_, bytes.data(), std::min(bytes.size(), write_behind_bytes), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      failed_ = true;
      fail(written < 0 ? errno : EIO, "write");
    }
    const int error = direct_ ? 0 : write_behind(descriptor_, offset, static_cast<std::size_t>(written));
    if (error != 0) {
      failed_ = true;
      fail(error, "write");
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
}

void OutputFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty() && !direct_) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(errno, "read back");
    if (got == 0) break;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += static_cast<std::uint64_t>(got);
  }
  std::ranges::fill(bytes, std::byte{0});
}

void OutputFile::resize(std::uint64_t size) {
  if (direct_) return;
  while (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) {
    if (errno == EINTR) continue;
    failed_ = true;
    fail(errno, "set the size of");
  }
}

void OutputFile::secure() {
  if (descriptor_ < 0) throw std::logic_error("OutputFile: completed twice: " + path_.string());
  if (failed_) throw std::logic_error("OutputFile: completed after a failed write: " + path_.string());
  if (!direct_) synchronise();
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0 && errno != EINTR) {
    const int error = errno;
    discard();
    fail(error, "complete");
  }
  secured_ = true;
}

void OutputFile::synchronise() {
  while (::fsync(descriptor_) != 0) {
    if (errno == EINTR) continue;
    if (errno == EINVAL || errno == ENOTSUP) return;  // This kind of file has nothing to synchronise.
    fail(errno, "complete");
  }
}

void OutputFile::commit() {
  if (committed_) throw std::logic_error("OutputFile: completed twice: " + path_.string());
  if (!secured_) secure();
  committed_ = true;
  if (!direct_) publish();
}

void OutputFile::publish() {
  const int error = replace_ ? (std::rename(working_path_.c_str(), target_.c_str()) == 0 ? 0 : errno)
                             : rename_without_replacing(working_path_, target_);
  if (error != 0) {
    discard();
    fail(error, "complete");
  }
  temporary_.forget();
  working_path_.clear();
  sync_folder_of(target_);
}

void OutputFile::discard() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (!direct_ && !working_path_.empty()) ::unlink(working_path_.c_str());
  temporary_.forget();
  working_path_.clear();
}

void sync_folder_of(const fs::path& path) noexcept {
  const fs::path folder = path.parent_path();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

void publish_file(const fs::path& complete, const fs::path& output, bool replace) {
  const fs::path target = end_of_links(output);
  struct stat status {};
  if (::stat(target.c_str(), &status) == 0) {
    if (!S_ISREG(status.st_mode))
      throw_error(ENOTSUP, fmt::format("cannot replace {}: it is not a regular file", output.string()));
    if (replace) ::chmod(complete.c_str(), status.st_mode & 07777U);  // As near to the old file's as we may.
  }
  const int error = replace ? (std::rename(complete.c_str(), target.c_str()) == 0 ? 0 : errno)
                            : rename_without_replacing(complete, target);
  if (error != 0) throw_error(error, fmt::format("cannot complete {}", output.string()));
  sync_folder_of(target);
}

}  // namespace sarsim::core

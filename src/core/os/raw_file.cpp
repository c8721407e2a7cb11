#include "core/os/raw_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "core/os/write_behind.hpp"
#include "core/report/invalid_request.hpp"

namespace sarsim::core {

namespace fs = std::filesystem;

namespace {

// Without waiting for the other end of a pipe.
int flags_of(RawFile::Mode mode) {
  constexpr int all = O_CLOEXEC | O_NONBLOCK;
  switch (mode) {
    case RawFile::Mode::read: break;
    case RawFile::Mode::write: return O_RDWR | O_CREAT | O_NOFOLLOW | all;
    case RawFile::Mode::write_new: return O_RDWR | O_CREAT | O_EXCL | all;
    case RawFile::Mode::append: return O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | all;
  }
  return O_RDONLY | all;
}

std::string kind_of(mode_t mode) {
  if (S_ISLNK(mode)) return "a symbolic link";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISSOCK(mode) ? "a socket" : "a device";
}

[[noreturn]] void refuse(const fs::path& path, Problem problem) {
  problem.place.file = path.string();
  throw InvalidRequest(Problems{std::move(problem)});
}

[[noreturn]] void refuse_kind(const fs::path& path, mode_t mode) {
  refuse(path, error("this is not a regular file")
                   .found(kind_of(mode))
                   .expected("a regular file")
                   .hint("move it away, or put the file itself in its place"));
}

// What is written in place changes under all names of a file, wherever they are.
[[noreturn]] void refuse_names(const fs::path& path, nlink_t names) {
  refuse(path, error("the file to be written has other names, which would change with it")
                   .found(fmt::format("{} hard links", names))
                   .expected("a file with one name")
                   .hint("move it away, or put a copy of it in its place"));
}

// Of a name that cannot be opened because of what it stands for.
void expect_regular(const fs::path& path, bool through_links) {
  struct stat status {};
  const int failure = through_links ? ::stat(path.c_str(), &status) : ::lstat(path.c_str(), &status);
  if (failure == 0 && !S_ISREG(status.st_mode)) refuse_kind(path, status.st_mode);
}

int flock_patiently(int descriptor, int operation) {
  while (::flock(descriptor, operation) != 0)
    if (errno != EINTR) return errno;
  return 0;
}

}  // namespace

RawFile::RawFile(fs::path path, Mode mode) : path_(std::move(path)) {
  do descriptor_ = ::open(path_.c_str(), flags_of(mode), 0666);
  while (descriptor_ < 0 && errno == EINTR);
  const char* const action = mode == Mode::read ? "read" : mode == Mode::append ? "write" : "open";
  if (descriptor_ < 0) {
    const int error = errno;
    expect_regular(path_, mode == Mode::read);
    errno = error;
    fail(action);
  }
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail(action);
  const bool regular = S_ISREG(status.st_mode);
  if (regular && (mode == Mode::read || status.st_nlink <= 1)) return;
  ::close(std::exchange(descriptor_, -1));
  if (!regular) refuse_kind(path_, status.st_mode);
  refuse_names(path_, status.st_nlink);
}

RawFile::RawFile(RawFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

RawFile& RawFile::operator=(RawFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

RawFile::~RawFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void RawFile::fail(const char* action) const {
  throw std::system_error(errno, std::generic_category(), fmt::format("cannot {} {}", action, path_.string()));
}

std::uint64_t RawFile::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail("find the size of");
  return static_cast<std::uint64_t>(status.st_size);
}

void RawFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(descriptor_, bytes.data(), std::min(bytes.size(), write_behind_bytes), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = EIO;
    if (written <= 0) fail("write");
    if ((errno = write_behind(descriptor_, offset, static_cast<std::size_t>(written))) != 0) fail("write");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
}

void RawFile::append(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), std::min(bytes.size(), write_behind_bytes));
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = EIO;
    if (written <= 0) fail("write");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

bool RawFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("read");
    if (got == 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += static_cast<std::uint64_t>(got);
  }
  return true;
}

void RawFile::allocate(std::uint64_t bytes) {
  if (bytes == 0) return;
  while (::fallocate(descriptor_, 0, 0, static_cast<off_t>(bytes)) != 0) {
    if (errno == EINTR) continue;
    // A full disk is better known now; a file system that cannot promise room only learns the size.
    if (errno == ENOSPC || errno == EFBIG || errno == EDQUOT) fail("make room for");
    if (size() < bytes) resize(bytes);
    return;
  }
}

void RawFile::resize(std::uint64_t bytes) {
  while (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0)
    if (errno != EINTR) fail("set the size of");
}

void RawFile::sync() {
  while (::fdatasync(descriptor_) != 0) {
    if (errno == EINTR) continue;
    if (errno == EINVAL || errno == ENOTSUP) return;  // This kind of file has nothing to synchronise.
    fail("bring to the disk");
  }
}

bool RawFile::try_lock() { return flock_patiently(descriptor_, LOCK_EX | LOCK_NB) != EWOULDBLOCK; }

void RawFile::lock() { flock_patiently(descriptor_, LOCK_EX); }

bool RawFile::still_there() const {
  struct stat mine {};
  struct stat named {};
  return ::fstat(descriptor_, &mine) == 0 && ::stat(path_.c_str(), &named) == 0 && mine.st_ino == named.st_ino &&
         mine.st_dev == named.st_dev;
}

void RawFile::unlink() noexcept { ::unlink(path_.c_str()); }

RawFile replace_file(const fs::path& path, std::span<const std::byte> bytes) {
  expect_regular(path, false);
  OutputFile output(path, true);
  output.write(bytes);
  RawFile file(output.working_path(), RawFile::Mode::write);
  file.lock();
  output.commit();
  file.path_ = path;
  return file;
}

}  // namespace sarsim::core

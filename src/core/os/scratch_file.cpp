#include "core/os/scratch_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace sarsim::core {

namespace {

// Whoever can be stopped asks between two of them.
constexpr std::size_t max_bytes = std::size_t{4} << 20U;

}  // namespace

ScratchFile::ScratchFile(std::filesystem::path folder) : folder_(std::move(folder)) {
  if (folder_.empty()) folder_ = std::filesystem::temp_directory_path();
  std::string name = (folder_ / "sarsim-XXXXXX").string();
  descriptor_ = ::mkstemp(name.data());
  if (descriptor_ < 0) fail(errno, "make a temporary file in");
  ::unlink(name.c_str());
}

ScratchFile::~ScratchFile() { ::close(descriptor_); }

void ScratchFile::fail(int error, const char* what) const {
  throw std::system_error(error, std::generic_category(),
                          std::string("cannot ") + what + " '" + folder_.string() + "'");
}

void ScratchFile::reserve(std::uint64_t bytes) const {
  int error = EINTR;
  while (error == EINTR) error = ::posix_fallocate(descriptor_, 0, static_cast<off_t>(bytes));
  if (error != 0) fail(error, "make room for a temporary file in");
}

std::size_t ScratchFile::read_some(std::uint64_t offset, std::span<std::byte> bytes) const {
  ssize_t done = -1;
  do {
    done = ::pread(descriptor_, bytes.data(), std::min(bytes.size(), max_bytes), static_cast<off_t>(offset));
  } while (done < 0 && errno == EINTR);
  if (done <= 0) fail(done == 0 ? EIO : errno, "read a temporary file in");
  return static_cast<std::size_t>(done);
}

std::size_t ScratchFile::write_some(std::uint64_t offset, std::span<const std::byte> bytes) const {
  ssize_t done = -1;
  do {
    done = ::pwrite(descriptor_, bytes.data(), std::min(bytes.size(), max_bytes), static_cast<off_t>(offset));
  } while (done < 0 && errno == EINTR);
  if (done <= 0) fail(done == 0 ? EIO : errno, "write a temporary file in");
  return static_cast<std::size_t>(done);
}

}  // namespace sarsim::core

#include "scene/edit/text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "scene/script/reader.hpp"

namespace sarsim::scene {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, int error) {
  throw std::runtime_error(
      fmt::format("cannot write {}: {}", path.string(), std::error_code(error, std::generic_category()).message()));
}

// A file that is open for writing and, until it is kept, goes away again.
class PartialFile {
 public:
  explicit PartialFile(fs::path target) : target_(std::move(target)) {}
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  ~PartialFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!name_.empty()) ::unlink(name_.c_str());
  }

  // 0 or the error, as all of these.
  int open_directly() {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    return descriptor_ < 0 ? errno : 0;
  }

  int create_beside() {
    constexpr int most_attempts = 100;  // A killed process of the same number may have left some behind.
    int error = EEXIST;
    for (int i = 0; i < most_attempts && error == EEXIST; ++i) {
      fs::path name = target_.parent_path() / fmt::format(".sarsim-{}-{}.part", ::getpid(), i);
      descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      error = descriptor_ < 0 ? errno : 0;
      if (error == 0) name_ = std::move(name);
    }
    return error;
  }

  void set_mode(mode_t mode) const { static_cast<void>(::fchmod(descriptor_, mode)); }

  [[nodiscard]] int write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t written = ::write(descriptor_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return written < 0 ? errno : EIO;
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
  }

  int close() {
    // EINVAL and ENOTSUP: this kind of file has nothing to synchronise.
    const int synchronised = ::fsync(descriptor_) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
    const int closed = ::close(std::exchange(descriptor_, -1)) == 0 || errno == EINTR ? 0 : errno;
    return synchronised != 0 ? synchronised : closed;
  }

  int keep() {
    if (std::rename(name_.c_str(), target_.c_str()) != 0) return errno;
    name_.clear();
    // Makes the new name last over a loss of power, where the file system can.
    const fs::path folder = target_.parent_path();
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return 0;
    ::fsync(descriptor);
    ::close(descriptor);
    return 0;
  }

 private:
  fs::path target_;
  fs::path name_;
  int descriptor_ = -1;
};

// The file that a chain of links means, which need not exist.
fs::path end_of_links(fs::path path) {
  constexpr int most_links = 40;
  for (int i = 0; i < most_links; ++i) {
    std::error_code no_link;
    const fs::path next = fs::read_symlink(path, no_link);
    if (no_link) return path;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  fail(path, ELOOP);
}

}  // namespace

std::optional<std::string> read_text_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  if (const auto size = fs::file_size(path, error); error || size > largest_script_bytes) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) return std::nullopt;
  return text;
}

void write_text_file(const fs::path& path, std::string_view text) {
  const fs::path target = end_of_links(path);
  struct stat status {};
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail(path, errno);
  if (exists && S_ISDIR(status.st_mode)) fail(path, EISDIR);
  PartialFile file(target);
  const bool direct = exists && !S_ISREG(status.st_mode);
  // Whoever may not write the file itself shall not replace it either.
  if (exists && !direct && ::access(target.c_str(), W_OK) != 0) fail(path, errno);
  if (const int error = direct ? file.open_directly() : file.create_beside()) fail(path, error);
  if (exists && !direct) file.set_mode(status.st_mode & 07777U);
  if (const int error = file.write(text)) fail(path, error);
  if (const int error = file.close()) fail(path, error);
  if (const int error = direct ? 0 : file.keep()) fail(path, error);
}

}  // namespace sarsim::scene

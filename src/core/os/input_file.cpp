#include "core/os/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace sarsim::core {

namespace {

Problem cannot_open(const std::filesystem::path& path, const std::string& why,
                    const char* hint = "give a file that you may read") {
  return error("cannot read the file: " + why).in(path.string()).hint(hint);
}

}  // namespace

std::variant<InputFile, Problem> InputFile::open(const std::filesystem::path& path) {
  // Without O_NONBLOCK the opening of a pipe would wait for somebody to write.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    const int error = errno;
    return cannot_open(path, std::generic_category().message(error),
                       error == ENOENT ? "check the name and the folder" : "give a file that you may read");
  }
  struct stat status {};
  const bool known = ::fstat(descriptor, &status) == 0;
  if (!known || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return cannot_open(path, known && S_ISDIR(status.st_mode) ? "it is a folder" : "it is not a regular file");
  }
  return InputFile(path, descriptor, static_cast<std::uint64_t>(status.st_size));
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::uint64_t InputFile::current_size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot ask for the size of " + path_.string());
  return static_cast<std::uint64_t>(status.st_size);
}

std::size_t InputFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got =
        ::pread(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw std::system_error(errno, std::generic_category(), "cannot read " + path_.string());
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

void InputFile::read_all_at(std::uint64_t offset, std::span<std::byte> bytes) const {
  if (read_at(offset, bytes) != bytes.size())
    throw std::runtime_error("cannot read " + path_.string() + ": it has become shorter");
}

std::string beginning_of(const std::filesystem::path& path, std::size_t most) try {
  const auto opened = InputFile::open(path);
  const auto* const file = std::get_if<InputFile>(&opened);
  if (file == nullptr) return {};
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(most, file->size())), '\0');
  text.resize(file->read_at(0, std::as_writable_bytes(std::span(text))));
  return text;
} catch (const std::system_error&) {
  return {};
}

}  // namespace sarsim::core

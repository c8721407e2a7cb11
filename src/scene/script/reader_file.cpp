#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <memory>
#include <optional>
#include <span>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/os/large_pages.hpp"
#include "core/text/number_text.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::scene {

namespace {

namespace fs = std::filesystem;

struct FileBytes {
  std::string text;
  std::string failure;  // why there is no text, in words; empty for none
};

// Why nothing can be read from here at all; empty where something might.
std::string refusal(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  switch (status.type()) {
    case fs::file_type::not_found: return "no such file";
    case fs::file_type::directory: return "is a folder, not a file";
    case fs::file_type::regular:
    case fs::file_type::fifo: return {};
    case fs::file_type::none: return error.message();
    default: return "is not a file";
  }
}

std::string too_large() { return fmt::format("is larger than {}", core::bytes_text(double{largest_script_bytes})); }

std::string failure_text(int error) {
  return std::error_code(error != 0 ? error : EIO, std::generic_category()).message();
}

// A file that is read from its begin to its end, whatever it is: the work that waits for a pipe can be stopped.
class Stream {
 public:
  // Without O_NONBLOCK the opening of a pipe would wait for somebody to write.
  Stream(const fs::path& path, const core::StopFlag* stop)
      : stop_(stop), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0) failure_ = errno;
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  // Bytes that were read; 0 at the end, and where there is a `failure`.
  std::size_t read(std::span<char> bytes) {
    while (failure_ == 0) {
      if (stop_ != nullptr && stop_->requested()) throw core::Interrupted();
      const ssize_t got = ::read(descriptor_, bytes.data(), bytes.size());
      if (got > 0) return begun_ = true, static_cast<std::size_t>(got);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0 && errno != EAGAIN) return failure_ = errno, 0;
      // A pipe that nobody has opened yet to write into ends like one that somebody has left.
      if (got == 0 && (begun_ || !waits())) return 0;
      if (got < 0) static_cast<void>(waits());
    }
    return 0;
  }
  // Why it cannot be read, as errno has it; 0 for none.
  [[nodiscard]] int failure() const { return failure_; }

 private:
  // Waits a little for more; false where nothing more can come.
  bool waits() const {
    constexpr int patience_ms = 20;
    pollfd wanted{.fd = descriptor_, .events = POLLIN, .revents = 0};
    static_cast<void>(::poll(&wanted, 1, patience_ms));
    struct stat status {};
    const bool pipe = ::fstat(descriptor_, &status) == 0 && S_ISFIFO(status.st_mode);
    return pipe && (wanted.revents & (POLLHUP | POLLERR)) == 0;
  }

  const core::StopFlag* stop_;
  int descriptor_;
  int failure_ = 0;
  bool begun_ = false;
};

FileBytes read_bytes(const fs::path& path, const core::StopFlag* stop) {
  FileBytes bytes;
  bytes.failure = refusal(path);
  if (!bytes.failure.empty()) return bytes;
  std::error_code unknown_size;
  const std::uintmax_t size = fs::file_size(path, unknown_size);
  if (!unknown_size && size > largest_script_bytes) return {{}, too_large()};
  Stream stream(path, stop);
  constexpr std::size_t piece = std::size_t{1} << 20;
  if (!unknown_size) bytes.text.reserve(static_cast<std::size_t>(size));
  std::vector<char> buffer(piece);
  while (const std::size_t got = stream.read(buffer)) {
    bytes.text.append(buffer.data(), got);
    if (bytes.text.size() > largest_script_bytes) return {{}, too_large()};
  }
  if (stream.failure() != 0) return {{}, failure_text(stream.failure())};
  return bytes;
}

// A file that all threads read at once, each at its own place, also where it is replaced meanwhile.
class SharedFile {
 public:
  explicit SharedFile(const fs::path& path) : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;
  ~SharedFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }

  // Whether all bytes that were asked for could be had.
  [[nodiscard]] bool read(std::size_t offset, std::span<char> bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      offset += static_cast<std::size_t>(count);
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
  }

 private:
  int descriptor_;
};

struct LargeText {
  std::unique_ptr<char[]> bytes;  // NOLINT: not a vector, which would write to all of it first
  std::size_t size = 0;
};

// The bytes of a large ordinary file, read by all threads; nothing for other files and for any that cannot be read so.
std::optional<LargeText> read_large(const fs::path& path, const core::WorkControl& control) {
  constexpr std::uintmax_t large = std::uintmax_t{1} << 18;
  constexpr std::size_t range_bytes = std::size_t{1} << 19;
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) return std::nullopt;
  const std::uintmax_t size = fs::file_size(path, failure);
  if (failure || size < large || size > largest_script_bytes) return std::nullopt;
  LargeText text{std::make_unique_for_overwrite<char[]>(size), static_cast<std::size_t>(size)};  // NOLINT
  core::prefer_large_pages(text.bytes.get(), text.size);
  const SharedFile file(path);
  std::atomic<bool> complete{true};
  core::parallel_ranges(text.size, range_bytes, control, [&](std::size_t begin, std::size_t end) {
    if (!file.read(begin, {text.bytes.get() + begin, end - begin})) complete = false;
  });
  if (!complete) return std::nullopt;
  return text;
}

// The name as typed and, for scripts from systems that part folders with a backslash, with slashes.
std::vector<std::string> spellings(const std::string& name) {
  std::vector<std::string> names{name};
  std::string slashed = name;
  std::ranges::replace(slashed, '\\', '/');
  if (slashed != name) names.push_back(slashed);
  return names;
}

std::vector<fs::path> places_to_look(const fs::path& script_folder, const std::string& name) {
  std::vector<fs::path> places;
  for (const std::string& spelling : spellings(name)) {
    places.push_back((script_folder / spelling).lexically_normal());
    const fs::path here = fs::path(spelling).lexically_normal();
    if (std::ranges::find(places, here) == places.end()) places.push_back(here);
  }
  return places;
}

DataFileText load(const fs::path& script_folder, const std::string& name) {
  const fs::path place = data_file_on_disk(script_folder, name);
  if (place.empty()) {
    std::string looked_at;
    for (const fs::path& other : places_to_look(script_folder, name))
      looked_at += (looked_at.empty() ? "" : " and ") + other.string();
    return {{}, {}, "data file not found; looked for " + looked_at};
  }
  // Nobody stands at the other end of a pipe that a script names, and one would wait for ever.
  std::error_code ignored;
  FileBytes bytes = fs::is_fifo(place, ignored) ? FileBytes{{}, "is not a file"} : read_bytes(place, nullptr);
  if (bytes.failure.empty()) return {place.string(), std::move(bytes.text), {}};
  return {place.string(), {}, fmt::format("data file {}: {}", place.string(), bytes.failure)};
}

// What to do about a script that cannot be read.
std::string remedy(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  for (const char* const ending : {".toml", ".scr", ".json"}) {
    fs::path script = path;
    script += ending;
    if (!fs::exists(status) && fs::exists(script, ignored)) return fmt::format("did you mean {}?", script.string());
  }
  if (!fs::exists(status)) return "look at the name and the folder; file names are case-sensitive";
  if (fs::is_directory(status)) return "name a script in that folder";
  return "give a text file that you may read";
}

}  // namespace

DataFileLoader disk_loader(const fs::path& script_folder) {
  return [script_folder](const std::string& name) { return load(script_folder, name); };
}

PointsLoader disk_points(const fs::path& script_folder) {
  return [script_folder](const std::string& name, const FunctionBlock& block) -> NamedPoints {
    DataFileText data = load(script_folder, name);
    if (!data.failure.empty()) return {{}, std::move(data.failure)};
    DataFileReading reading = read_data_file(data.text, data.path, block);
    for (const core::Problem& problem : reading.problems)
      if (problem.severity == core::Severity::error) return {{}, core::to_string(problem)};
    return {std::move(reading.functions), {}};
  };
}

fs::path data_file_on_disk(const fs::path& script_folder, const std::string& name) {
  for (fs::path& place : places_to_look(script_folder, name)) {
    std::error_code ignored;
    if (fs::exists(place, ignored)) return std::move(place);
  }
  return {};
}

ScriptReading read_script_file(const fs::path& path, const ReadControl& control) {
  return read_text_of_file(path, control, read_script);
}

ScriptReading read_text_of_file(const fs::path& path, const ReadControl& control, TextReader& read) {
  if (const std::optional<LargeText> text = read_large(path, control.work))
    return read({text->bytes.get(), text->size}, path.string(), disk_loader(path.parent_path()), control);
  const FileBytes bytes = read_bytes(path, control.work.stop);
  if (bytes.failure.empty()) return read(bytes.text, path.string(), disk_loader(path.parent_path()), control);
  ScriptReading result;
  core::Problem problem;
  problem.message = fmt::format("cannot read the script: {}", bytes.failure);
  problem.place.file = path.string();
  problem.hint = remedy(path);
  result.problems.push_back(std::move(problem));
  return result;
}

}  // namespace sarsim::scene

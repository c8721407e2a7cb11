#include "cli/command/picture_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "cli/shell/signals.hpp"
#include "core/os/output_file.hpp"
#include "core/task/stop.hpp"

extern char** environ;

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* program_name = "sarsim-gui";

[[noreturn]] void fail(const fs::path& file, const char* what, const std::error_code& cause) {
  throw std::runtime_error(fmt::format("'{}' could not be {}: {}; TMPDIR names another folder for temporary files",
                                       file.string(), what, cause.message()));
}

// A folder for one picture, gone with it.
class Workshop {
 public:
  Workshop() {
    std::error_code failure;
    const fs::path folder = fs::temp_directory_path(failure);
    if (failure) fail(std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : "/tmp", "used", failure);
    std::string pattern = (folder / "sarsim-plot-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) fail(pattern, "made", {errno, std::generic_category()});
    folder_ = pattern;
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_ / name; }
  // Whether words are about a file of this folder.
  [[nodiscard]] bool is_named_in(const std::string& words) const {
    return words.find(folder_.string()) != std::string::npos;
  }

 private:
  fs::path folder_;
};

std::string program() {
  std::error_code failure;
  const fs::path own = fs::read_symlink("/proc/self/exe", failure);
  const fs::path beside = own.parent_path() / program_name;
  return !failure && fs::exists(beside, failure) ? beside.string() : program_name;
}

void write_figure(const fs::path& file, const picture::Figure& figure) {
  const std::string bytes = picture::figure_bytes(figure);
  try {
    core::OutputFile output(file, false);
    output.write(std::as_bytes(std::span(bytes)));
    output.commit();
  } catch (const std::system_error& error) {
    fail(file, "written", error.code());
  }
}

// A whole file that is not empty.
std::string bytes_of(const fs::path& file) {
  std::error_code failure;
  const auto size = fs::file_size(file, failure);
  if (failure) fail(file, "read", failure);
  std::string bytes(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream || bytes.empty()) fail(file, "read", std::make_error_code(std::errc::io_error));
  return bytes;
}

// What a program said, as far as it can be read.
std::string words_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string words{std::istreambuf_iterator<char>(stream), {}};
  while (!words.empty() && words.back() == '\n') words.pop_back();
  return words;
}

// Waits for a child; a signal that asks this program to stop is passed on.
int wait_status_of(pid_t child) {
  int status = 0;
  for (bool told = false;;) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) return status;
    if (ended < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), program_name);
    if (received_signal() != 0 && !told) told = ::kill(child, SIGTERM) == 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

// The exit status of a program whose standard error goes to a file; nothing where there is no such program. A program
// whose libraries are missing ends with 127, after words of the loader.
std::optional<int> status_of(const std::vector<std::string>& arguments, const fs::path& errors) {
  std::vector<char*> list;
  list.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) list.push_back(const_cast<char*>(argument.c_str()));
  list.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  // In a process group of its own: signals of the terminal reach it through this program alone.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = -1;
  const int failure = ::posix_spawnp(&child, list[0], &actions, &attributes, list.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT) return std::nullopt;
  if (failure != 0)
    throw std::system_error(failure, std::generic_category(), std::string(program_name) + " could not be started");
  const int status = wait_status_of(child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

void draw_picture(const picture::Figure& figure, const fs::path& out, const PictureStyle& style) {
  const Workshop workshop;
  const fs::path handed = workshop.file("figure");
  // Whatever ends the program that draws leaves nothing beside the picture.
  const fs::path drawn = workshop.file("picture" + out.extension().string());
  write_figure(handed, figure);
  std::vector<std::string> arguments{program(),
                                     "--draw-figure",
                                     handed.string(),
                                     "--out",
                                     drawn.string(),
                                     "--width",
                                     std::to_string(style.width_px),
                                     "--height",
                                     std::to_string(style.height_px),
                                     "--scale",
                                     fmt::format("{}", style.scale)};
  if (style.dark) arguments.emplace_back("--dark");
  const std::optional<int> status = status_of(arguments, workshop.file("errors"));
  if (!status)
    throw std::runtime_error(
        "pictures are drawn by sarsim-gui, which is not installed: install it, or build with Qt 6 and QCustomPlot "
        "(tools/install-deps gui)");
  if (*status != 0) {
    if (received_signal() != 0) throw core::Interrupted();
    std::string words = words_of(workshop.file("errors"));
    if (workshop.is_named_in(words)) words += "; TMPDIR names another folder for temporary files";
    throw std::runtime_error(
        fmt::format("'{}' could not be drawn: {}", out.string(),
                    words.empty() ? fmt::format("{} ended with status {}", program_name, *status) : words));
  }
  const std::string bytes = bytes_of(drawn);
  core::OutputFile picture(out, true);
  picture.write(std::as_bytes(std::span(bytes)));
  picture.commit();
}

}  // namespace sarsim::cli

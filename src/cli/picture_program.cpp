#include "cli/picture_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

extern char** environ;

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* program_name = "sarsim-gui";

// A folder for one picture, gone with it.
class Workshop {
 public:
  Workshop() {
    std::string pattern = (fs::temp_directory_path() / "sarsim-plot-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), "a folder for the picture could not be made");
    folder_ = pattern;
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  [[nodiscard]] fs::path file(const char* name) const { return folder_ / name; }

 private:
  fs::path folder_;
};

std::string program() {
  std::error_code failure;
  const fs::path own = fs::read_symlink("/proc/self/exe", failure);
  const fs::path beside = own.parent_path() / program_name;
  return !failure && fs::exists(beside, failure) ? beside.string() : program_name;
}

std::string words_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string words{std::istreambuf_iterator<char>(stream), {}};
  while (!words.empty() && words.back() == '\n') words.pop_back();
  return words;
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
  pid_t child = -1;
  const int failure = ::posix_spawnp(&child, list[0], &actions, nullptr, list.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT) return std::nullopt;
  if (failure != 0)
    throw std::system_error(failure, std::generic_category(), std::string(program_name) + " could not be started");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), program_name);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

void draw_picture(const Figure& figure, const fs::path& out, const PictureStyle& style) {
  const Workshop workshop;
  const fs::path handed = workshop.file("figure");
  {
    std::ofstream file(handed, std::ios::binary);
    const std::string bytes = figure_bytes(figure);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw std::runtime_error(fmt::format("'{}' could not be written", handed.string()));
  }
  std::vector<std::string> arguments{program(),
                                     "--draw-figure",
                                     handed.string(),
                                     "--out",
                                     out.string(),
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
    const std::string words = words_of(workshop.file("errors"));
    throw std::runtime_error(words.empty() ? fmt::format("{} ended with status {}", program_name, *status) : words);
  }
}

}  // namespace sarsim::cli

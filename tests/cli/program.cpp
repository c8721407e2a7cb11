#include "program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>

#include "support/test_folder.hpp"

namespace sarsim::test {

namespace fs = std::filesystem;

namespace {

void redirect(int descriptor, const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0) _exit(126);
  dup2(file, descriptor);
  close(file);
}

[[noreturn]] void become(std::vector<std::string> words, const Start& start, const std::string& out,
                         const std::string& err) {
  if (chdir(start.folder.c_str()) != 0) _exit(126);
  if (start.largest_file_bytes > 0) {
    const auto bytes = static_cast<rlim_t>(start.largest_file_bytes);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (start.max_open_files > 0) {
    const auto files = static_cast<rlim_t>(start.max_open_files);
    const rlimit limit{files, files};
    setrlimit(RLIMIT_NOFILE, &limit);
  }
  std::signal(SIGHUP, start.ignores_hangup ? SIG_IGN : SIG_DFL);
  redirect(STDOUT_FILENO, out);
  redirect(STDERR_FILENO, err);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(pointers[0], pointers.data());
  _exit(127);
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void pause_briefly() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const Start& start) {
  static int counter = 0;
  const std::string stem = ".streams-" + std::to_string(getpid()) + "-" + std::to_string(counter++);
  out_path_ = fs::path(testing::TempDir()) / (stem + "-out");
  err_path_ = fs::path(testing::TempDir()) / (stem + "-err");
  std::vector<std::string> words{start.program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::string out = start.standard_output.empty() ? out_path_.string() : start.standard_output;
  process_ = fork();
  if (process_ == 0) become(words, start, out, err_path_.string());
}

Program::~Program() {
  if (!ended()) {
    kill(process_, SIGKILL);
    waitpid(process_, &wait_status_, 0);
  }
  fs::remove(out_path_);
  fs::remove(err_path_);
}

void Program::send(int signal) const { kill(process_, signal); }

std::string Program::err() const { return text_of(err_path_); }

bool Program::ended() {
  if (ended_) return true;
  rusage usage{};
  ended_ = wait4(process_, &wait_status_, WNOHANG, &usage) == process_;
  if (ended_) processor_s_ = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  return ended_;
}

double Program::processor_s() const {
  clockid_t clock{};
  timespec now{};
  if (clock_getcpuclockid(process_, &clock) != 0 || clock_gettime(clock, &now) != 0) return processor_s_;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool Program::catches(int signal) const {
  std::ifstream status("/proc/" + std::to_string(process_) + "/status");
  for (std::string word; status >> word;)
    if (word == "SigCgt:") {
      std::uint64_t caught = 0;
      status >> std::hex >> caught;
      return (caught >> (signal - 1) & 1U) != 0;
    }
  return false;
}

bool Program::wait_until_it_catches(int signal, double seconds) {
  for (const double end_s = now_s() + seconds; now_s() < end_s; pause_briefly()) {
    if (catches(signal)) return true;
    if (ended()) return false;
  }
  return false;
}

bool Program::wait_for(const std::string& text, double seconds) {
  for (const double end_s = now_s() + seconds; now_s() < end_s; pause_briefly()) {
    if (err().find(text) != std::string::npos) return true;
    if (ended()) return false;
  }
  return false;
}

Finished Program::finish(double seconds) {
  const double end_s = now_s() + seconds;
  while (!ended() && now_s() < end_s) pause_briefly();
  Finished result;
  if (ended_) result.status = WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : -WTERMSIG(wait_status_);
  result.processor_s = processor_s_;
  result.out = text_of(out_path_);
  result.err = text_of(err_path_);
  return result;
}

std::string text_of(const fs::path& path) { return contents(path); }

void write_text(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

bool is_json(const std::string& text, const fs::path& folder) {
  write_text(folder / ".json", text);
  const std::string command =
      std::string(SARSIM_PYTHON) + " -m json.tool '" + (folder / ".json").string() + "' > /dev/null 2>&1";
  const bool good = std::system(command.c_str()) == 0;
  fs::remove(folder / ".json");
  return good;
}

std::string SceneText::text() const {
  std::ostringstream s;
  s << "! a target that passes a radar at the origin\n"
       "$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
       "$PLATFORM Car TRAJECTORY LINEAR LINEAR LINEAR INLINE 2 0, 0 1, 20 1 0, "
    << target_m
    << " 1 0, 0\n"
       "NOT_ALIGNED CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
       "$TARGET Car 0 0 0 0 0 0 1 0 ISOTROPIC\n"
       "$RADAR Radar1 Earth CHIRP 0.05 1000 RECT CONSTANT 1000 SINGLE 1 100 0 "
    << noise_k << "\n  ISOTROPIC SAME FIXED 0 0 RECT NO_STC\n";
  for (const std::string& file : files)
    s << "$SIMULATION Radar1 900 1400 0 " << (pulses - 1) * 0.001 << " 8 0.1 " << lsb_mv << " " << format << " RAW "
      << file << " BEGIN 1 1\n";
  if (!geometry.empty()) s << "$GEOMETRY Radar1 0 2000 0 " << (pulses - 1) * 0.001 << " SPACE 227 " << geometry << "\n";
  return s.str();
}

void CommandTest::SetUp() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  folder_ = fs::path(testing::TempDir()) /
            (std::string("sarsim-") + info->test_suite_name() + "-" + info->name() + "-" + std::to_string(getpid()));
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

void CommandTest::TearDown() { fs::remove_all(folder_); }

Finished CommandTest::sarsim(const std::vector<std::string>& arguments) const {
  Start start;
  start.folder = folder_;
  return Program(arguments, start).finish();
}

std::vector<std::string> CommandTest::entries(const std::string& folder) const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_ / folder)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace sarsim::test

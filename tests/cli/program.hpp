#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace sarsim::test {

/// What a finished program left.
struct Finished {
  int status = -1;           ///< Exit status; -signal where one ended it.
  double processor_s = 0.0;  ///< What it took of processors, all its threads together.
  std::string out;
  std::string err;
};

/// How a program is started.
struct Start {
  std::filesystem::path folder;  ///< Its current folder.
  std::string standard_output;   ///< A file instead of what is captured, such as /dev/full.
  long largest_file_bytes = 0;   ///< Limit of the system for a file; 0: none.
  long max_open_files = 0;       ///< Limit of the system for the process; 0: none.
  bool ignores_hangup = false;   ///< As nohup has it.
  std::filesystem::path program = SARSIM_PROGRAM;
};

/// A running `sarsim`, whose streams go to files in its folder.
class Program {
 public:
  Program(const std::vector<std::string>& arguments, const Start& start);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  void send(int signal) const;
  /// What has arrived on standard error so far.
  [[nodiscard]] std::string err() const;
  /// Waits until standard error holds a text; false after `seconds`, or where the program ends before.
  [[nodiscard]] bool wait_for(const std::string& text, double seconds);
  /// Waits until the program has said what it does at a signal; false after `seconds`, or where it ends before.
  [[nodiscard]] bool wait_until_it_catches(int signal, double seconds);
  /// Processor seconds so far, of all threads of the running program.
  [[nodiscard]] double processor_s() const;
  /// Waits for the end; status -1 where it does not end within `seconds`.
  Finished finish(double seconds = 60.0);

 private:
  [[nodiscard]] bool ended();
  [[nodiscard]] bool catches(int signal) const;

  pid_t process_ = -1;
  int wait_status_ = 0;
  double processor_s_ = 0.0;  // Of the ended program.
  bool ended_ = false;
  std::filesystem::path out_path_;
  std::filesystem::path err_path_;
};

/// The bytes of a file; of a folder the names and bytes of all files in it.
[[nodiscard]] std::string text_of(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

/// Whether Python reads a text as JSON.
[[nodiscard]] bool is_json(const std::string& text, const std::filesystem::path& folder);

/// A script with one moving target, with noise, made to measure.
struct SceneText {
  int pulses = 20;
  std::string format = "BINARY";
  std::vector<std::string> files{"sim.bin"};
  std::string lsb_mv = "0";
  std::string noise_k = "300";
  std::string geometry;  ///< File of a $GEOMETRY; empty: none.
  double target_m = 1000.0;

  [[nodiscard]] std::string text() const;
};

/// A test with a folder of its own.
class CommandTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Runs sarsim in the test's folder.
  [[nodiscard]] Finished sarsim(const std::vector<std::string>& arguments) const;
  /// Writes scene.scr.
  void write_scene(const SceneText& scene) const { write_text(folder_ / "scene.scr", scene.text()); }
  /// Names of the entries of a folder below the test's, sorted; hidden ones too.
  [[nodiscard]] std::vector<std::string> entries(const std::string& folder) const;

  std::filesystem::path folder_;
};

}  // namespace sarsim::test

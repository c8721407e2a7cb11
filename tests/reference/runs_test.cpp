// Every script of the original program, through the command, twice, each time into an empty folder.

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/folders.hpp"

namespace sarsim {
namespace runs_test {

namespace fs = std::filesystem;

struct Case {
  const char* script;
  std::vector<std::string> outputs;
};

// Outputs take the base name that the script gives; a name that comes again gets a number.
const std::vector<Case>& cases() {
  static const std::vector<std::string> exam3{"Sim100-2.asc", "Sim100-3.asc", "Sim100-4.asc",
                                              "Sim100.asc",   "Sim1a.asc",    "sim1a.bin"};
  static const std::vector<Case> all{
      {"examples/exam1.scr", {"sim1.bin"}},
      {"examples/exam2.scr", {"sim1.asc"}},
      {"examples/exam3.scr", exam3},
      {"helvin/exam1.scr", {"sim1.bin", "sim10.asc"}},
      {"helvin/exam2.scr", {"sim1-2.bin", "sim1-3.bin", "sim1.bin", "sims2.asc"}},
      {"helvin/exam3.scr", exam3},
      {"helvin/radarz.scr", {}},
      {"helvin/sar_pl.scr", {"sim1-2.bin", "sim1.bin"}},
      {"helvin/sim2a0.scr", {"sim1.bin"}},
      {"linux/exam2.scr", {"final.h5"}},
      {"stc/newsim3.scr", {"sim1.bin"}},
      {"stc/sim1.scr", {"sim1.asc"}},
      {"stc/sim2.scr", {"sim1.asc", "sim1.bin"}},
      {"stc/sim3-noise.scr", {"sim1-2.bin", "sim1.asc", "sim1.bin"}},
      {"stc/sim3.scr", {"sim1-2.bin", "sim1.asc", "sim1.bin"}},
      {"windows/SAR_RC.SCR", {"SIM1.ASC"}},
      {"windows/SURF.SCR", {"TEST.BIN"}},
      {"windows/badfill.scr", {}},
      {"windows/gain.scr", {}},
      {"windows/kw.scr", {}},
      {"windows/kw2.scr", {}},
      {"windows/longcalc.scr", {"sim1.bin"}},
      {"windows/nice.scr", {"sim1.bin"}},
      {"windows/singlept.scr", {}},
      {"windows/test.scr", {"sim1-2.bin", "sim1.bin"}},
  };
  return all;
}

int status_of(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    files[entry.path().filename().string()] = text.str();
  }
  return files;
}

TEST(OriginalScriptsThroughTheCommand, PassCheckAndRunTwiceInAnEmptyFolderToTheSameBytes) {
  if (!test::have_reference_folder()) GTEST_SKIP() << "no reference folder at " << test::reference_folder();
  const fs::path base = fs::temp_directory_path() / ("sarsim_original_" + std::to_string(::getpid()));
  for (const Case& c : cases()) {
    const std::string script = (test::reference_folder() / "original" / c.script).string();
    const std::string program = SARSIM_PROGRAM;
    EXPECT_EQ(status_of(program + " check '" + script + "' >/dev/null 2>&1"), 0) << c.script;
    std::map<std::string, std::string> first;
    for (const char* run : {"first", "second"}) {
      const fs::path folder = base / run;
      fs::remove_all(folder);
      fs::create_directories(folder);
      EXPECT_EQ(status_of("cd '" + folder.string() + "' && " + program + " '" + script + "' >/dev/null 2>messages"), 0)
          << c.script;
      fs::remove(folder / "messages");
      const auto files = files_in(folder);
      std::vector<std::string> names;
      for (const auto& [name, bytes] : files) {
        names.push_back(name);
        EXPECT_FALSE(bytes.empty()) << c.script << name;
      }
      EXPECT_EQ(names, c.outputs) << c.script;
      if (first.empty())
        first = files;
      else
        EXPECT_EQ(files, first) << c.script;
    }
  }
  fs::remove_all(base);
}

}  // namespace runs_test
}  // namespace sarsim

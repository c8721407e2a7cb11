#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace exit_status_test {

constexpr const char* mark = "format = \"sarsim 2\"\n";
constexpr const char* scene = R"(format = "sarsim 2"
[[target]]
position = [1000, 0, 0]
[[radar]]
name = "R"
pulse = { type = "chirp", bandwidth = "50 MHz", width = "1 us" }
carrier = "9.6 GHz"
[[recording]]
radar = "R"
range = ["900 m", "1200 m"]
time = ["0 s", "10 ms"]
sample_rate = "60 MHz"
file = "r.npy"
format = "npy"
)";

// The table of docs/guide/commands.md, "Exit status"; interruptions are tested in interrupt_test.cpp, 75 with parts.
class ExitStatus : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_text(folder_ / "s.toml", scene);
    write_text(folder_ / "empty.toml", mark);
    write_text(folder_ / "idle.toml", std::string(mark) + "[[target]]\nposition = [1, 2, 3]\n");
    write_text(folder_ / "idle.scr", "$PLATFORM P STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n");
    write_text(folder_ / "broken.toml", std::string(scene) + "bits = 65\n");
    write_text(folder_ / "odd.toml", std::string(scene) + "bits = 1\n");
    write_text(folder_ / "there.npy", "precious");
    write_text(folder_ / "file", "");
  }
};

TEST_F(ExitStatus, IsThatOfTheGuide) {
  struct Row {
    std::vector<std::string> words;
    int status;
  };
  const Row rows[]{
      // Done.
      {{"--help"}, 0},
      {{"--version"}, 0},
      {{"run", "--help"}, 0},
      {{"check", "s.toml"}, 0},
      {{"run", "s.toml", "--quiet", "--out", "done"}, 0},
      {{"explain", "radar.pulse"}, 0},
      {{"explain", "noise"}, 0},
      {{"explain", "range", "migration"}, 0},
      {{"run", "idle.scr"}, 0},
      // Done, with warnings.
      {{"check", "odd.toml"}, 0},
      {{"check", "idle.toml"}, 0},
      // Usage.
      {{"rnu", "s.toml"}, 2},
      {{"run"}, 2},
      {{"run", "s.toml", "--bogus"}, 2},
      {{"run", "s.toml", "--threads", "many"}, 2},
      {{"explain", "xyzzy"}, 2},
      {{"run", "s.toml", "--format", "tiff"}, 2},
      // Input that is refused.
      {{"check", "broken.toml"}, 2},
      {{"run", "broken.toml"}, 2},
      {{"run", "missing.toml"}, 2},
      {{"run", "empty.toml"}, 2},
      {{"run", "idle.toml"}, 2},
      {{"check", "idle.toml", "--strict"}, 2},
      {{"run", "s.toml", "--set", "R.wavelength=3 cm"}, 2},
      {{"run", "s.toml", "--out", "there.npy"}, 2},
      {{"convert", "s.toml", "s.h5"}, 2},
      // The environment.
      {{"run", "s.toml", "--out", "file/below"}, 1},
      {{"format", "s.toml", "-o", "/dev/full", "--force"}, 1},
  };
  for (const Row& row : rows) {
    const Finished run = sarsim(row.words);
    EXPECT_EQ(run.status, row.status) << testing::PrintToString(row.words) << "\n" << run.out << run.err;
  }
  EXPECT_EQ(text_of(folder_ / "there.npy"), "precious");
}

}  // namespace exit_status_test
}  // namespace sarsim::test

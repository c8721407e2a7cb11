#include <gmock/gmock.h>

#include "csv.hpp"
#include "program.hpp"

namespace sarsim::test {
namespace sweep_let_test {

using testing::HasSubstr;
using testing::Not;

constexpr const char* scene = R"(format = "sarsim 2"
include = ["place.toml"]
[let]
speed = "240 m/s"
turn = "2 * speed / 1 km"
[[platform]]
name = "P"
[platform.path]
type = "line"
start = ["away", "0 m", "100 m"]
velocity = ["-speed", "0 m/s", "0 m/s"]
[[target]]
platform = "P"
[[radar]]
name = "R"
pulse = { type = "chirp", bandwidth = "2 MHz", width = "1 us" }
beam = { type = "fixed", azimuth = "90 deg" }
[[recording]]
radar = "R"
file = "sim.npy"
format = "npy"
range = ["14 km", "16 km"]
time = ["0 s", "0.01 s"]
sample_rate = "4 MHz"
)";

/// Sweeps over names of [let]: all that follows from a name follows from its values.
class SweepLet : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_text(folder_ / "scene.toml", scene);
    write_text(folder_ / "place.toml", "format = \"sarsim 2\"\n[let]\naway = \"15 km\"\n");
  }
};

TEST_F(SweepLet, MakesTheBytesThatARunWithTheSameNamesMakes) {
  const Finished sweep =
      sarsim({"sweep", "scene.toml", "--let", "speed=100:100:300", "--let", "away=14.5,15km", "--out", "o"});
  ASSERT_EQ(sweep.status, 0) << sweep.err;
  const auto rows = read_csv(text_of(folder_ / "o/sweep.csv"));
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[5].at("let.speed [m/s]"), "300");
  EXPECT_EQ(rows[5].at("let.away [m]"), "15000");
  const std::string file = rows[5].at("file");
  EXPECT_EQ(file, "sim_let.speed=300_let.away=15km.npy");
  ASSERT_EQ(sarsim({"run", "scene.toml", "--let", "speed=300 m/s", "--let", "away=15 km", "--out", "r"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "o" / file), text_of(folder_ / "r/sim.npy"));
  EXPECT_NE(text_of(folder_ / "o" / rows[3].at("file")), text_of(folder_ / "r/sim.npy"));
}

TEST_F(SweepLet, TakesNamesFromSetTablesAndLaws) {
  write_text(folder_ / "cases.csv", "let.speed [km/s], seed\n0.1, 1\n0.2, 2\n");
  const Finished sweep = sarsim({"sweep", "scene.toml", "--values", "cases.csv", "--set", "let.away=normal(15, 0.1km)",
                                 "--draws", "2", "--dry-run"});
  EXPECT_EQ(sweep.status, 0) << sweep.err;
  EXPECT_THAT(sweep.out, HasSubstr("let.speed=0.1km/s seed=1 let.away="));
}

TEST_F(SweepLet, PrintsCommandsThatMakeTheSame) {
  const Finished plan = sarsim({"sweep", "scene.toml", "--let", "speed=100,200m/s", "--dry-run", "--commands"});
  EXPECT_THAT(plan.out, HasSubstr("sarsim run scene.toml --let speed=200m/s --set Simulation1.file="));
}

TEST_F(SweepLet, FollowsUpWithTheSameNames) {
  const Finished sweep = sarsim({"sweep", "scene.toml", "--let", "speed=100,200", "--discard", "--search", "--quiet"});
  EXPECT_EQ(sweep.status, 0) << sweep.err;
}

TEST_F(SweepLet, SaysWhatIsWrongWithANameOrAValue) {
  EXPECT_THAT(sarsim({"sweep", "scene.toml", "--let", "sped=1,2"}).err, HasSubstr("did you mean 'speed'?"));
  EXPECT_THAT(sarsim({"sweep", "scene.toml", "--let", "speed=1km,2km"}).err, HasSubstr("is not a valid speed"));
  EXPECT_THAT(sarsim({"sweep", "scene.toml", "--let", "turn=x"}).err, HasSubstr("turn=x"));
  EXPECT_THAT(sarsim({"sweep", "scene.toml", "--let", "speed=1,2", "--set", "let.speed=3"}).err,
              HasSubstr("this field is set by let.speed already"));
  const Finished far = sarsim({"sweep", "scene.toml", "--let", "away=20 km,30 km", "--dry-run"});
  EXPECT_THAT(far.err, HasSubstr("scene.toml:"));
}

TEST_F(SweepLet, ListsTheNames) {
  EXPECT_THAT(sarsim({"sweep", "scene.toml", "--fields"}).out, HasSubstr("let.speed"));
}

TEST_F(SweepLet, NoOutputReplacesAnIncludedFile) {
  for (const char* const command : {"format", "convert"}) {
    std::vector<std::string> words{command, "scene.toml"};
    if (std::string(command) == "format") words.emplace_back("-o");
    words.emplace_back("place.toml");
    words.emplace_back("--force");
    const Finished end = sarsim(words);
    EXPECT_EQ(end.status, 2) << command;
    EXPECT_THAT(text_of(folder_ / "place.toml"), HasSubstr("away")) << command;
    EXPECT_THAT(text_of(folder_ / "place.toml"), Not(HasSubstr("radar"))) << command;
  }
}

TEST_F(SweepLet, PlotOverlaysTheValues) {
  const Finished plot =
      sarsim({"plot", "scene.toml", "--kind", "pulse", "--vary", "let.away=14.5km,15km", "--csv", "a.csv"});
  EXPECT_EQ(plot.status, 0) << plot.err;
}

}  // namespace sweep_let_test
}  // namespace sarsim::test

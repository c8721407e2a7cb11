#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace inputs_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// Which file is meant, which simulation wrote it, and which options concern it.
class Inputs : public CommandTest {
 protected:
  // Two recordings whose names differ by the extension alone, of different shape.
  void write_two_of_one_stem() const {
    SceneText scene;
    scene.files = {"r.bin", "r.asc"};
    scene.lsb_mv = "3e-5";
    std::string text = scene.text();
    const std::size_t second = text.rfind("900 1400");
    text.replace(second, 8, "900 1200");
    text.replace(text.find("BINARY", second), 6, "ASCII");
    write_text(folder_ / "scene.scr", text);
  }

  void expect_refusal(const std::vector<std::string>& words, const std::string& sentence) const {
    const Finished refused = sarsim(words);
    EXPECT_EQ(refused.status, 2) << sentence << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(sentence));
  }

  void expect_done(const std::vector<std::string>& words) const {
    const Finished done = sarsim(words);
    EXPECT_EQ(done.status, 0) << done.err;
  }
};

TEST_F(Inputs, ArraysTakeNoHeaderOfAnImageBesideThem) {
  write_scene({});
  expect_done({"run", "scene.scr", "--format", "npy", "--quiet"});
  const std::vector<std::string> plot{"plot", "sim.npy", "--kind", "pulse", "--csv", "a.csv", "--force"};
  expect_done(plot);
  const std::string alone = text_of(folder_ / "a.csv");
  expect_done({"doppler", "scene.scr", "--out", "sim.img", "--quiet"});
  ASSERT_TRUE(fs::exists(folder_ / "sim.hdr"));
  expect_done(plot);
  EXPECT_EQ(text_of(folder_ / "a.csv"), alone);
  expect_refusal({"measure", "sim.npy"}, "the header beside the array is that of another file");
}

TEST_F(Inputs, ASampleThatIsNotANumberIsNamedBeforeItSpreads) {
  write_scene({});
  expect_done({"run", "scene.scr", "--format", "npy", "--quiet"});
  const std::string sound = text_of(folder_ / "sim.npy");
  struct Damage {
    float value;
    const char* words;
  };
  for (const Damage& damage : {Damage{std::numeric_limits<float>::quiet_NaN(), "is not a number"},
                               Damage{std::numeric_limits<float>::infinity(), "is too large to compute with"},
                               Damage{1e30F, "is too large to compute with"}}) {
    std::string bytes = sound;
    std::memcpy(bytes.data() + bytes.size() - sizeof(float), &damage.value, sizeof(float));
    write_text(folder_ / "sim.npy", bytes);
    expect_refusal({"doppler", "sim.npy", "--script", "scene.scr", "--out", "m.img"}, damage.words);
    expect_refusal({"doppler", "sim.npy", "--script", "scene.scr", "--out", "m.img"}, "row 19, sample");
    EXPECT_FALSE(fs::exists(folder_ / "m.img"));
  }
  write_text(folder_ / "sim.npy", sound);
  expect_done({"doppler", "sim.npy", "--script", "scene.scr", "--out", "m.img", "--quiet"});
}

// The shape fits, the ranges are others: targets would be found 50 m beside their places.
TEST_F(Inputs, AxesOfAFileThatAreNotThoseOfItsScriptAreWarnedOf) {
  write_scene({});
  expect_done({"run", "scene.scr", "--format", "hdf5", "--quiet"});
  std::string other = SceneText{}.text();
  other.replace(other.find("900 1400"), 8, "950 1450");
  write_text(folder_ / "other.scr", other);
  const Finished done = sarsim({"doppler", "sim.h5", "--script", "other.scr", "--out", "m.img"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_THAT(done.err, HasSubstr("the axis slant_range_m of the file is not that of its script"));
  EXPECT_THAT(done.err, testing::Not(HasSubstr("pulse_time_s")));
  const Finished own = sarsim({"doppler", "sim.h5", "--out", "own.img"});
  EXPECT_THAT(own.err, testing::Not(HasSubstr("the axis")));
}

// What a recording in SigMF or Zarr says of itself stands in texts, where anybody may change it.
TEST_F(Inputs, FactsOfAFileThatAreNotThoseOfItsScriptAreWarnedOf) {
  write_scene({});
  expect_done({"run", "scene.scr", "--format", "zarr", "--quiet"});
  const auto change = [&](const fs::path& file, const std::string& old, const std::string& by) {
    std::string text = text_of(file);
    const std::size_t at = text.find(old);
    ASSERT_NE(at, std::string::npos) << old << text;
    write_text(file, text.replace(at, old.size(), by));
  };
  fs::remove(folder_ / "sim.zarr/.zmetadata");
  const Finished own = sarsim({"doppler", "sim.zarr", "--out", "own.img"});
  EXPECT_EQ(own.status, 0) << own.err;
  EXPECT_THAT(own.err, testing::Not(HasSubstr("is not that of its script")));
  change(folder_ / "sim.zarr/.zattrs", "\"sample_rate_hz\": 1", "\"sample_rate_hz\": 2");
  change(folder_ / "sim.zarr/.zattrs", "\"radar\": \"", "\"radar\": \"Another");
  change(folder_ / "sim.zarr/.zattrs", "\"seed\": ", "\"seed\": 1");
  change(folder_ / "sim.zarr/.zattrs", "\"profile\": \"", "\"profile\": \"un");
  change(folder_ / "sim.zarr/.zattrs", "\"pulse\": \"", "\"pulse\": \"un");
  const fs::path places = folder_ / "sim.zarr/platform_position_m/0.0";
  std::string bytes = text_of(places);
  const double elsewhere = 1234.5;
  std::memcpy(bytes.data() + 3 * 3 * sizeof(double), &elsewhere, sizeof elsewhere);
  write_text(places, bytes);
  const Finished done = sarsim({"doppler", "sim.zarr", "--out", "m.img"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_THAT(done.err, HasSubstr("sample_rate_hz of the file is not that of its script, which counts"));
  EXPECT_THAT(done.err, HasSubstr("sample_rate_hz of the file contradicts its slant_range_m"));
  for (const char* const fact : {"radar", "seed", "profile", "pulse"})
    EXPECT_THAT(done.err, HasSubstr(std::string(fact) + " of the file is not that of its script, which counts"));
  EXPECT_THAT(done.err, testing::Not(HasSubstr("cubic_ends of the file")));
  EXPECT_THAT(done.err, HasSubstr("the axis platform_position_m of the file is not that of its script"));
  EXPECT_THAT(done.err, HasSubstr("1234.5 for x at position 3"));
}

// It would be compressed twice, or not at all.
TEST_F(Inputs, RecordingsWhoseProcessingIsNotThatOfTheirScriptAreRefused) {
  write_scene({});
  expect_done({"run", "scene.scr", "--format", "zarr", "--quiet"});
  fs::remove(folder_ / "sim.zarr/.zmetadata");
  const std::string sound = text_of(folder_ / "sim.zarr/.zattrs");
  const std::string raw = "\"processing\": \"raw\"";
  const std::size_t at = sound.find(raw);
  ASSERT_NE(at, std::string::npos) << sound;
  for (const std::string found : {"matched_filter", "srp", "RAW", "another"}) {
    std::string changed = sound;
    write_text(folder_ / "sim.zarr/.zattrs", changed.replace(at, raw.size(), "\"processing\": \"" + found + "\""));
    const Finished refused = sarsim({"doppler", "sim.zarr", "--out", "m.img"});
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_THAT(refused.err, AllOf(HasSubstr("processing of the file is not that of its script"), HasSubstr("sim.zarr"),
                                   HasSubstr("found '" + found + "', expected raw"),
                                   HasSubstr("give the scene that wrote it with --script")));
    EXPECT_FALSE(fs::exists(folder_ / "m.img"));
  }
  write_text(folder_ / "sim.zarr/.zattrs", sound);
  std::string other = SceneText{}.text();
  other.replace(other.find(" RAW "), 5, " MATCHED_FILTER ");
  write_text(folder_ / "other.scr", other);
  expect_refusal({"doppler", "sim.zarr", "--script", "other.scr", "--out", "m.img"},
                 "processing of the file is not that of its script");
}

// CPHD and CRSD are made of raw pulses.
TEST_F(Inputs, RecordingsOfOtherProcessingBecomeNoPhaseHistory) {
  write_text(folder_ / "small.toml", R"(format = "sarsim 2"
[[platform]]
name = "Plane"
path = { type = "line", start = [0, -2500, 1500], velocity = [100, 0, 0] }
[[target]]
positions = [[0, 0, 0], [12, 9, 0]]
[[radar]]
name = "X"
platform = "Plane"
pulse = { type = "chirp", bandwidth = "60 MHz", width = "0.5 us" }
repetition = "120 Hz"
carrier = "9.6 GHz"
power = "1 kW"
[[recording]]
radar = "X"
file = "small.zarr"
format = "zarr"
sample_rate = "75 MHz"
range = ["2850 m", "3000 m"]
time = ["-0.6 s", "0.6 s"]
)");
  expect_done({"run", "small.toml", "--quiet"});
  fs::remove(folder_ / "small.zarr/.zmetadata");
  expect_done({"convert", "small.zarr", "sound.cphd", "--anchor", "-33.9,18.4,0"});
  std::string attributes = text_of(folder_ / "small.zarr/.zattrs");
  const std::string raw = "\"processing\": \"raw\"";
  const std::size_t at = attributes.find(raw);
  ASSERT_NE(at, std::string::npos) << attributes;
  write_text(folder_ / "small.zarr/.zattrs", attributes.replace(at, raw.size(), "\"processing\": \"matched_filter\""));
  expect_refusal({"convert", "small.zarr", "small.cphd", "--anchor", "-33.9,18.4,0"},
                 "processing of the file is not that of its script");
  EXPECT_FALSE(fs::exists(folder_ / "small.cphd"));
}

TEST_F(Inputs, WhatIsNoSceneIsNamedByEveryCommandThatReadsScenes) {
  write_text(folder_ / "a.yaml", "radar:\n  carrier: 9.6 GHz\n");
  write_text(folder_ / "b.scr", "x,y,z\n1,2,3\n4,5,6\n");
  const auto expect_named = [&](const std::vector<std::string>& words, const char* kind) {
    const Finished refused = sarsim(words);
    EXPECT_EQ(refused.status, 2) << words.front();
    EXPECT_THAT(refused.err + refused.out, HasSubstr(std::string("this is no scene: it seems to be ") + kind))
        << words.front();
  };
  using Words = std::vector<std::string>;
  for (const Words& words : {Words{"check", "a.yaml"}, Words{"run", "a.yaml"}}) expect_named(words, "YAML");
  for (const Words& words : {Words{"check", "b.scr"}, Words{"run", "b.scr"}, Words{"info", "b.scr"},
                             Words{"focus", "b.scr", "--out", "i.img"}, Words{"convert", "b.scr", "b.toml"}})
    expect_named(words, "a table of numbers (CSV)");
}

TEST_F(Inputs, ValuesThatAreNotFiniteAreNoLineOfNames) {
  for (const char* first : {"nan,inf", "-inf,1", "1,nan", "Infinity,NaN"}) {
    write_text(folder_ / "a.csv", std::string(first) + "\n1,2\n3,4\n");
    const Finished info = sarsim({"info", "a.csv", "--statistics"});
    EXPECT_EQ(info.status, 2) << first << info.out;
    EXPECT_THAT(info.err, HasSubstr("a.csv:1:")) << first;
  }
  write_text(folder_ / "a.csv", "I0,Q0\n1,2\n3,4\n");
  EXPECT_EQ(sarsim({"info", "a.csv", "--statistics"}).status, 0);
}

TEST_F(Inputs, VoltsOfACountKeepSamplesFinite) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--quiet"}).status, 0);
  const Finished large = sarsim({"convert", "sim.bin", "sim.npy", "--columns", "334", "--bits", "8", "--lsb", "1e300"});
  EXPECT_EQ(large.status, 2);
  EXPECT_THAT(large.err, HasSubstr("--lsb is too large; found 1e+300 V"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "sim.npy"));
}

TEST_F(Inputs, ArraysTakeTheHeaderThatIsTheirs) {
  write_scene({});
  expect_done({"doppler", "scene.scr", "--out", "map.npy", "--quiet"});
  expect_done({"plot", "map.npy", "--kind", "pulse", "--csv", "a.csv"});
  EXPECT_THAT(text_of(folder_ / "a.csv"), HasSubstr("slant range [m]"));
  expect_refusal({"plot", "map.npy", "--columns", "5", "--csv", "b.csv"}, "has a header, which says all");
}

TEST_F(Inputs, TheWholeNameOfAFileTellsItsSimulation) {
  write_two_of_one_stem();
  expect_done({"run", "scene.scr", "--quiet"});
  for (const char* file : {"r.bin", "r.asc"})
    expect_done({"doppler", file, "--script", "scene.scr", "--out", "m.img", "--force", "--quiet"});
  EXPECT_THAT(sarsim({"info", "r.asc", "--script", "scene.scr", "--json"}).out, HasSubstr("\"rows\": 20"));
}

TEST_F(Inputs, ANameThatTwoSimulationsMayHaveMadeIsRefused) {
  write_two_of_one_stem();
  expect_done({"run", "scene.scr", "2", "--quiet"});
  expect_done({"convert", "r.asc", "r.npy", "--script", "scene.scr"});
  const std::vector<std::string> doppler{"doppler", "r.npy", "--script", "scene.scr", "--out", "m.img"};
  expect_refusal(doppler, "'r.npy' could come from r.bin or from r.asc");
  std::vector<std::string> chosen = doppler;
  chosen.insert(chosen.end(), {"--simulation", "2"});
  expect_done(chosen);
  expect_refusal({"info", "r.npy", "--script", "scene.scr"}, "could come from r.bin or from r.asc");
}

TEST_F(Inputs, NamesThatRunGivesWithAnotherFormatAreKnown) {
  write_two_of_one_stem();
  expect_done({"run", "scene.scr", "--format", "npy", "--quiet"});
  expect_done({"doppler", "r-2.npy", "--script", "scene.scr", "--out", "m.img"});
}

TEST_F(Inputs, RecordingsThatCarryTheirScriptTakeNoOptionsOfScripts) {
  const std::string scene = SARSIM_SOURCE_DIR "/examples/stepped_aircraft.scr";
  expect_done({"run", scene, "--format", "hdf5", "--out", "d", "--quiet"});
  ASSERT_EQ(entries("d").size(), 1U);
  const std::string file = "d/" + entries("d").front();
  expect_refusal({"profiles", file, "--seed", "5", "--out", "p.img"}, "--seed means nothing for '" + file + "'");
  expect_refusal({"isar", file, "--profile", "classic", "--out", "p.img"}, "--profile means nothing");
  expect_done({"profiles", file, "--script", scene, "--seed", "5", "--out", "p.img", "--quiet"});
}

TEST_F(Inputs, PlotRefusesWhatItWouldIgnore) {
  write_scene({});
  expect_done({"run", "scene.scr", "--format", "npy", "--quiet"});
  const auto refused = [&](const char* input, const std::vector<std::string>& option, const char* sentence) {
    std::vector<std::string> words{"plot", input, "--csv", "a.csv", "--kind", "pulse"};
    words.insert(words.end(), option.begin(), option.end());
    expect_refusal(words, option.front() + sentence);
  };
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{
           {"--rate", "1e8"}, {"--data", "compressed"}, {"--screen"}, {"--seed", "2"}, {"--radar", "Radar1"}})
    refused("sim.npy", option, " means nothing for a file");
  for (const std::vector<std::string>& option :
       std::vector<std::vector<std::string>>{{"--columns", "3"}, {"--bits", "8"}, {"--script", "scene.scr"}})
    refused("scene.scr", option, " means nothing for a script");
  refused("sim.npy", {"--simulation", "1"}, " is a number in a script");
  EXPECT_FALSE(fs::exists(folder_ / "a.csv"));
}

TEST_F(Inputs, PlotTakesTheSimulationOfAFileByItsNumber) {
  write_scene({});
  expect_done({"run", "scene.scr", "--format", "npy", "--quiet"});
  fs::rename(folder_ / "sim.npy", folder_ / "other.npy");
  const std::vector<std::string> plot{"plot",  "other.npy", "--kind",   "phase",    "--force",
                                      "--csv", "a.csv",     "--script", "scene.scr"};
  expect_refusal(plot, "no recording of scene.scr writes 'other.npy'");
  std::vector<std::string> chosen = plot;
  chosen.insert(chosen.end(), {"--simulation", "1"});
  expect_done(chosen);
  chosen.back() = "2";
  expect_refusal(chosen, "the scene has no recording 2");
}

TEST_F(Inputs, OutputsWithOneNameAreRefused) {
  write_scene({});
  expect_refusal({"plot", "scene.scr", "-o", "a.svg", "--csv", "./a.svg"}, "is the name of two outputs");
  const std::string sentence = "'x.hdr' is the name of two outputs";
  const std::string examples = SARSIM_SOURCE_DIR "/examples/";
  expect_refusal({"focus", examples + "sar_r.scr", "--out", "x.hdr"}, sentence);
  expect_refusal({"profiles", examples + "stepped_aircraft.scr", "--out", "x.hdr"}, sentence);
  expect_refusal({"doppler", "scene.scr", "--out", "x.hdr"}, sentence);
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

TEST_F(Inputs, PicturesOfTextsThatAreNoConvertersAreRefused) {
  write_text(folder_ / "a.csv", "0,0,0,0\n-5,3,7,-2\n");
  const std::vector<std::string> plot{"plot", "a.csv", "--kind", "pulse", "--at-time", "1", "--csv", "p.csv"};
  std::vector<std::string> with_bits = plot;
  with_bits.insert(with_bits.end(), {"--bits", "8"});
  expect_refusal(with_bits, "a value is not that of an A/D converter with an offset");
  EXPECT_FALSE(fs::exists(folder_ / "p.csv"));
  expect_done(plot);
  EXPECT_THAT(text_of(folder_ / "p.csv"), HasSubstr("-5"));
}

TEST_F(Inputs, AnImageMustNameASimulation) {
  expect_done({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--out", "r.img", "--quiet"});
  const std::string header = text_of(folder_ / "r.hdr");
  const std::string field = "simulation = {1}";
  ASSERT_NE(header.find(field), std::string::npos);
  for (const char* number : {"0", "-3", "0.5", "1e300", "one"}) {
    std::string other = header;
    other.replace(other.find(field), field.size(), std::string("simulation = {") + number + "}");
    write_text(folder_ / "r.hdr", other);
    expect_refusal({"measure", "r.img"}, "'simulation' is not a number from 1");
  }
}

TEST_F(Inputs, ImagesAreDescribedAndConverted) {
  expect_done({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--out", "r.img", "--magnitude", "--quiet"});
  const Finished info = sarsim({"info", "r.img"});
  ASSERT_EQ(info.status, 0) << info.err;
  EXPECT_THAT(info.out, AllOf(HasSubstr("envi"), HasSubstr("omega-k"), HasSubstr("complex float")));
  expect_done({"convert", "r.img", "r.npy"});
  const auto figures = [&](const char* file) {
    const std::string said = sarsim({"info", file, "--json", "--statistics"}).out;
    return std::pair(said.substr(said.find("\"rows\""), 200), said.substr(said.find("\"lowest\""), 200));
  };
  fs::remove(folder_ / "r.hdr");
  const auto array = figures("r.npy");
  expect_done({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--out", "r.img", "--force", "--quiet"});
  EXPECT_EQ(figures("r.img"), array);
  EXPECT_THAT(sarsim({"info", "r-magnitude.img", "--statistics"}).out, HasSubstr("lowest I or Q            0 V"));
}

TEST_F(Inputs, ImagesAreNotFocusedAgain) {
  const std::string script = SARSIM_SOURCE_DIR "/examples/sar_r.scr";
  for (const char* image : {"sar_r.img", "sar_r.npy"}) {
    expect_done({"focus", script, "--out", image, "--force", "--quiet"});
    for (const char* command : {"focus", "doppler", "search"})
      expect_refusal({command, image, "--script", script, "--out", "other.img"},
                     "is a focused image, as its header 'sar_r.hdr' says, not a recording");
    expect_refusal({"focus", "sar_r.hdr"}, "is a focused image, as its header 'sar_r.hdr' says, not a recording");
    fs::remove(folder_ / image);  // The header can be that of one image only.
  }
  for (const char* image : {"sar_r.h5", "sar_r.zarr"}) {
    expect_done({"focus", script, "--out", image, "--force", "--quiet"});
    for (const char* command : {"focus", "doppler", "search"})
      expect_refusal({command, image, "--out", "other.img"},
                     "is a focused image, as its field image_plane says, not a recording");
  }
}

TEST_F(Inputs, ImagesAndProfilesSayHowTheirEchoesWereMade) {
  const std::string examples = SARSIM_SOURCE_DIR "/examples/";
  write_text(folder_ / "sar.scr", "$OPTIONS SEED 4711\n" + text_of(examples + "sar_r.scr"));
  expect_done({"focus", "sar.scr", "--out", "i.h5", "--quiet"});
  expect_done({"profiles", examples + "stepped_aircraft.scr", "--seed", "4711", "--out", "p.h5", "--quiet"});
  expect_done({"isar", examples + "turning_ship.scr", "--seed", "4711", "--out", "t.h5", "--quiet"});
  for (const char* file : {"i.h5", "p.h5", "t.h5"}) {
    const std::string said = sarsim({"info", file, "--json"}).out;
    EXPECT_THAT(said, HasSubstr("\"seed\": \"4711\"")) << file;
    EXPECT_THAT(said, testing::Not(HasSubstr("\"radar\": \"\""))) << file;
  }
}

}  // namespace inputs_test
}  // namespace sarsim::test

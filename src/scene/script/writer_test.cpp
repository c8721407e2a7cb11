// How a written script looks.

#include "scene/script/writer.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "core/build/version.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::scene {

namespace writer_test {

bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

Scene scene_with_radar() {
  Scene scene;
  scene.radars.emplace_back();
  return scene;
}

TEST(WriteScript, NamesTheProgramAndItsVersion) { EXPECT_TRUE(holds(write_script({}), core::program_version)); }

TEST(WriteScript, PutsTheCommentsOfShortValuesIntoColumn22) {
  std::istringstream lines(write_script(scene_with_radar()));
  std::size_t counted = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '!' || line[0] == '$') continue;
    EXPECT_EQ(line.find('!'), 21U) << line;
    ++counted;
  }
  EXPECT_GT(counted, 15U);
}

TEST(WriteScript, WritesNumbersAsTheyWouldBeTyped) {
  Scene scene = scene_with_radar();
  scene.radars[0].carrier_hz = 5.3e9;
  scene.radars[0].pulse_width_s = 800e-9;
  const std::string text = write_script(scene);
  EXPECT_TRUE(holds(text, "\n5.3                  ! (GHz) Carrier frequency\n")) << text;
  EXPECT_TRUE(holds(text, "\n800                  ! (ns) Pulse width: from edge to edge\n")) << text;
}

TEST(WriteScript, WritesGainsOnlyWhereThereAreSome) {
  Scene scene = scene_with_radar();
  EXPECT_FALSE(holds(write_script(scene), "Gain of the"));
  scene.radars[0].receive_gain = core::PowerRatio::from_db(3.0);
  EXPECT_TRUE(holds(write_script(scene),
                    "0                    ! (dB) Gain of the transmitter\n"
                    "3                    ! (dB) Gain of the receiver\n"));
}

TEST(WriteScript, WritesOnlyTheOptionsThatDiffer) {
  Scene scene;
  EXPECT_FALSE(holds(write_script(scene), "$OPTIONS"));
  scene.options.seed = 7;
  const std::string text = write_script(scene);
  EXPECT_TRUE(holds(text, "$OPTIONS\nSEED 7 ")) << text;
  EXPECT_FALSE(holds(text, "PROFILE"));
  EXPECT_FALSE(holds(text, "TOLERANCE"));
}

TEST(WriteScript, OrdersCommandsAsTheOriginals) {
  Scene scene = scene_with_radar();
  scene.platforms.emplace_back();
  scene.surfaces.emplace_back();
  scene.targets.emplace_back();
  scene.clouds.emplace_back().file = "points.npy";
  scene.simulations.emplace_back();
  scene.geometries.emplace_back();
  scene.options.seed = 2;
  const std::string text = write_script(scene);
  std::size_t last = 0;
  for (const char* word :
       {"$PLATFORM", "$SURFACE", "$TARGET", "$CLOUD", "$RADAR", "$SIMULATION", "$GEOMETRY", "$OPTIONS"}) {
    const std::size_t at = text.find(word);
    ASSERT_NE(at, std::string::npos) << word;
    EXPECT_GT(at, last) << word;
    last = at;
  }
}

TEST(WriteScript, WritesTheNameOfADataFileInPlaceOfItsData) {
  Scene scene;
  Target target;
  target.traits.edit().reflectivity = Target::Reflectivity::directional;
  target.traits.edit().gain = Target::Gain::user;
  target.traits.edit().gain_db.file = "my gain.dat";
  target.traits.edit().gain_db.part[0].knots = {{0.0, -1.0}};
  scene.targets.push_back(target);
  const std::string text = write_script(scene);
  EXPECT_TRUE(holds(text, "FILE \"my gain.dat\"")) << text;
  EXPECT_FALSE(holds(text, "INLINE"));
  const ScriptReading reading = read_script(text, "", [](const std::string& name) {
    EXPECT_EQ(name, "my gain.dat");
    return DataFileText{name, "1 0 -1", {}};
  });
  EXPECT_TRUE(reading.problems.empty());
  EXPECT_TRUE(reading.scene == scene);
}

TEST(WriteScript, QuotesNamesOnlyWhereNeeded) {
  Scene scene = scene_with_radar();
  EXPECT_FALSE(holds(write_script(scene), "\""));
  scene.radars[0].name = "my radar";
  EXPECT_TRUE(holds(write_script(scene), "\n\"my radar\"           ! Name of the radar\n"));
}

TEST(WriteScript, WritesTheSameOnAnyNumberOfThreads) {
  Scene scene;
  scene.targets.resize(20'000);
  for (std::size_t i = 0; i < scene.targets.size(); ++i) {
    scene.targets[i].position_m = {0.1 * static_cast<double>(i), -1e-7 * static_cast<double>(i), 1e20};
    if (i % 3 == 0) scene.targets[i].traits.edit().reflectivity = Target::Reflectivity::directional;
  }
  scene.radars.resize(1);
  const std::string one = write_script(scene);
  for (const unsigned threads : {2U, 3U, 8U}) EXPECT_TRUE(write_script(scene, {threads}) == one) << threads;
  scene.targets.resize(4096);
  EXPECT_TRUE(write_script(scene, {2}) == write_script(scene));
}

TEST(WriteScript, EndsWhenAskedTo) {
  Scene scene;
  scene.targets.resize(20'000);
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW(static_cast<void>(write_script(scene, {2, &stop})), core::Interrupted);
}

}  // namespace writer_test
}  // namespace sarsim::scene

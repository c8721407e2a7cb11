#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "scene/script/random_scene_test_support.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::scene {

namespace round_trip_test {

std::string printed(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
  return text;
}

void expect_same_when_read_back(const Scene& scene) {
  const std::string text = write_script(scene);
  const ScriptReading reading = read_script(text, "written.scr", {});
  EXPECT_EQ(printed(reading.problems), "") << text;
  EXPECT_TRUE(reading.scene == scene) << text;
}

// A stationary platform, a radar and a recording: what most single changes are tried on.
Scene small_scene() {
  Scene scene;
  scene.platforms.emplace_back();
  scene.targets.emplace_back();
  scene.radars.emplace_back();
  scene.simulations.emplace_back();
  scene.simulations[0].radar = "Radar1";
  scene.simulations[0].sample_rate_hz = 1e8;
  return scene;
}

core::SampledFunction some_points(core::Interpolation method) {
  return {method, {{-1.5, 0.1}, {0.25, -7.0}, {3.0, 1e-30}}};
}

template <std::size_t N>
UserFunction<N> some_function() {
  UserFunction<N> function;
  constexpr std::array methods{core::Interpolation::cubic, core::Interpolation::low_pass, core::Interpolation::linear};
  for (std::size_t i = 0; i < N; ++i) function.part[i] = some_points(methods[i]);
  return function;
}

// Intervals or carriers, which have to be above zero.
UserFunction<1> some_list() {
  UserFunction<1> list = some_function<1>();
  list.part[0].knots[1].y = 7.0;
  return list;
}

TEST(RoundTrip, KeepsAThousandRandomScenesBitForBit) {
  constexpr std::uint64_t first_seed = 20240;
  test::RandomScenes scenes(first_seed);
  std::size_t platforms = 0;
  for (int i = 0; i < 1000 && !HasFailure(); ++i) {
    const Scene scene = scenes.scene();
    SCOPED_TRACE(testing::Message() << "scene " << i << " of seed " << first_seed);
    // Points that carry no data give a warning each, so only errors count here.
    const std::string text = write_script(scene);
    const ScriptReading reading = read_script(text, "written.scr", {});
    EXPECT_FALSE(core::has_errors(reading.problems)) << printed(reading.problems) << text;
    EXPECT_TRUE(reading.scene == scene) << text;
    platforms += scene.platforms.size();
  }
  EXPECT_GT(platforms, 1000U);
}

TEST(RoundTrip, KeepsAnEmptyScene) {
  const ScriptReading reading = read_script(write_script({}), "", {}, {.work = {}, .draft = true});
  EXPECT_FALSE(core::has_errors(reading.problems));
  EXPECT_TRUE(reading.scene == Scene{});
}

TEST(RoundTrip, KeepsTheSmallestScene) { expect_same_when_read_back(small_scene()); }

TEST(RoundTrip, KeepsAUserFunctionInEveryPlaceOfTheLanguage) {
  Scene scene = small_scene();
  Platform& platform = scene.platforms[0];
  platform.path = Platform::Path::trajectory;
  platform.trajectory_m = some_function<3>();
  platform.aligned = true;
  platform.rotation_kind = Platform::Rotation::user;
  platform.rotation_deg = some_function<3>();
  platform.position_error = Platform::MotionError::envelope;
  platform.position_envelope = some_function<3>();
  platform.rotation_error = Platform::MotionError::envelope;
  platform.rotation_envelope = some_function<3>();
  Target& target = scene.targets[0];
  target.traits.edit().reflectivity = Target::Reflectivity::directional;
  target.traits.edit().gain = Target::Gain::user;
  target.traits.edit().gain_db = some_function<1>();
  Radar& radar = scene.radars[0];
  radar.pulse = Radar::Pulse::user;
  radar.pulse_iq = some_function<2>();
  radar.envelope = Radar::Envelope::user;
  radar.envelope_gain = some_function<1>();
  radar.repetition = Radar::Repetition::user;
  radar.pri_s = some_list();
  radar.carrier = Radar::Carrier::user;
  radar.carrier_list_hz = some_list();
  radar.transmit_antenna.pattern = Antenna::Pattern::user;
  radar.transmit_antenna.gain_db = some_function<2>();
  radar.same_antenna = false;
  radar.receive_antenna = radar.transmit_antenna;
  radar.beam = Radar::Beam::user;
  radar.beam_target_world_m = some_function<3>();
  radar.window = Radar::Window::user;
  radar.window_gain = some_function<1>();
  radar.stc = Radar::Stc::user;
  radar.stc_gain = some_function<1>();
  expect_same_when_read_back(scene);
}

TEST(RoundTrip, KeepsEveryKeywordOfTheRadar) {
  for (int i = 0; i < 5; ++i) {
    Scene scene = small_scene();
    Radar& radar = scene.radars[0];
    if (i < 4) radar.pulse = static_cast<Radar::Pulse>(i);
    if (i < 3) radar.envelope = static_cast<Radar::Envelope>(i);
    if (i < 2) radar.repetition = static_cast<Radar::Repetition>(i);
    if (i < 3) radar.carrier = static_cast<Radar::Carrier>(i);
    if (i < 3) radar.transmit_antenna.pattern = static_cast<Antenna::Pattern>(i);
    radar.same_antenna = i > 2;
    if (i < 3) radar.receive_antenna.pattern = static_cast<Antenna::Pattern>(i);
    if (i < 4) radar.beam = static_cast<Radar::Beam>(i);
    radar.window = static_cast<Radar::Window>(i);
    if (i < 3) radar.stc = static_cast<Radar::Stc>(i);
    const ScriptReading reading = read_script(write_script(scene), "", {});
    EXPECT_FALSE(core::has_errors(reading.problems)) << printed(reading.problems);
    EXPECT_TRUE(reading.scene == scene) << write_script(scene);
  }
}

TEST(RoundTrip, KeepsEveryKeywordOfRecordingsAndTables) {
  for (int i = 0; i < 6; ++i) {
    Scene scene = small_scene();
    Simulation& simulation = scene.simulations[0];
    simulation.format = static_cast<FileFormat>(i);
    simulation.processing = static_cast<Processing>(i % 3);
    simulation.pulse_position = static_cast<Simulation::PulsePosition>(i % 2);
    GeometryTable table;
    table.radar = "Radar1";
    table.separator = static_cast<GeometryTable::Separator>(i % 2);
    scene.geometries.push_back(table);
    scene.surfaces.emplace_back();
    Cloud& cloud = scene.clouds.emplace_back();
    cloud.file = "a \"cloud\".npy";
    cloud.rcs_m2 = 0.1;
    cloud.traits.position_stddev_m = {0.1, 0.2, 0.3};
    cloud.traits.reflectivity = static_cast<Target::Reflectivity>(i % 2);
    if (i % 2 == 1) cloud.traits.azimuth = core::Angle::from_deg(12.3);
    expect_same_when_read_back(scene);
  }
}

TEST(RoundTrip, KeepsOptions) {
  Scene scene = small_scene();
  scene.options = {Profile::classic, UINT64_MAX, PulseDefinition::band_limited, 1e-9};
  expect_same_when_read_back(scene);
}

TEST(RoundTrip, KeepsTheSignOfADownChirp) {
  Scene scene = small_scene();
  scene.radars[0].pulse = Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = -0.1e9;
  expect_same_when_read_back(scene);
}

TEST(RoundTrip, KeepsTheLastBitOfNumbersInScaledUnits) {
  Scene scene = small_scene();
  double value = 5.3e9;
  for (int i = 0; i < 200; ++i) {
    value = std::nextafter(value, 1e300);
    scene.radars[0].carrier_hz = value;
    scene.radars[0].pulse_width_s = value * 1e-17;
    scene.radars[0].power_w = value * 1e-7;
    scene.simulations[0].lsb_v = value * 1e-25;
    const ScriptReading reading = read_script(write_script(scene), "", {});
    ASSERT_EQ(std::bit_cast<std::uint64_t>(reading.scene.radars.at(0).carrier_hz), std::bit_cast<std::uint64_t>(value));
    ASSERT_TRUE(reading.scene == scene);
  }
}

TEST(RoundTrip, KeepsNamesThatNeedQuotes) {
  for (const char* name : {"two words", "a,b", "wow!", "say \"so\"", "\"", "$RADAR", "tab\there", "5", "CHIRP",
                           "a name far longer than fifteen characters", "M\xC3\xB6we", "M\xF6we", "C:\\data\\x.bin"}) {
    Scene scene = small_scene();
    scene.platforms[0].name = name;
    scene.radars[0].name = name;
    scene.radars[0].platform = name;
    scene.targets[0].platform = name;
    scene.simulations[0].radar = name;
    scene.simulations[0].file = name;
    expect_same_when_read_back(scene);
  }
}

}  // namespace round_trip_test
}  // namespace sarsim::scene

// What the reader understands: commands, keywords, units, defaults and the dialects of all programs.

#include "scene/script/reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/script/writer.hpp"

namespace sarsim::scene {

namespace reader_test {

std::string printed(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
  return text;
}

// Reads a script that must give no problem at all.
Scene read_clean(std::string_view text) {
  const ScriptReading reading = read_script(text, "t.scr", {});
  EXPECT_EQ(printed(reading.problems), "") << text;
  return reading.scene;
}

constexpr std::string_view example = R"(! example
$PLATFORM Earth STATIONARY 0,0,0 CONST 0,0,0 0,0,0 STDDEV 0,0,0 STDDEV 0,0,0
$platform Plane TRAJ LIN lin LINEAR INLINE
 2  -1,-100 1,100    ! X vs t
 1   0 -4500         ! Y
 1   0, 3500         ! Z
 NOT_ALIGNED CONST 0 0 0 0 0 0 STD 0 0 0 STD 0 0 0
$TARG Earth 0 0 0, 0 0 0, 1 0 ISO
$RADAR R1 Plane CHIRP 0.1 1000 RECT CONST 400 SINGLE 5.3 1 0 0
 SINX 60 6 SAME FIXED -40 0 HAMM NO_STC
$SIM R1 5550 5870 -0.64 0.6399 8 0.12 1E-7 BIN RAW out.bin CEN 1 1
)";

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  const std::size_t at = result.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return result.replace(at, from.size(), to);
}

std::string radar_with(std::string_view middle) { return "$RADAR R P " + std::string(middle); }

Radar read_radar(std::string_view middle) {
  const Scene scene = read_clean(radar_with(middle));
  return scene.radars.empty() ? Radar{} : scene.radars[0];
}

std::string simulation_with(std::string_view end) { return "$SIM R 1 2 3 4 8 0.1 0 " + std::string(end); }

TEST(ReadScript, ReadsAnExampleOfTheCurrentDialect) {
  const Scene scene = read_clean(example);
  ASSERT_EQ(scene.platforms.size(), 2U);
  ASSERT_EQ(scene.targets.size(), 1U);
  ASSERT_EQ(scene.radars.size(), 1U);
  ASSERT_EQ(scene.simulations.size(), 1U);
  const Platform& plane = scene.platforms[1];
  EXPECT_EQ(plane.name, "Plane");
  EXPECT_EQ(plane.path, Platform::Path::trajectory);
  EXPECT_EQ(plane.trajectory_m.part[0].knots, (std::vector<core::Knot>{{-1, -100}, {1, 100}}));
  EXPECT_EQ(plane.trajectory_m.part[2].knots, (std::vector<core::Knot>{{0, 3500}}));
  const Radar& radar = scene.radars[0];
  EXPECT_EQ(radar.pulse, Radar::Pulse::chirp);
  EXPECT_EQ(radar.bandwidth_hz, 100e6);
  EXPECT_EQ(radar.pulse_width_s, 1e-6);
  EXPECT_EQ(radar.prf_hz, 400.0);
  EXPECT_EQ(radar.carrier_hz, 5.3e9);
  EXPECT_EQ(radar.power_w, 1000.0);
  EXPECT_EQ(radar.transmit_antenna.elevation_beamwidth.deg(), 60.0);
  EXPECT_EQ(radar.transmit_antenna.azimuth_beamwidth.deg(), 6.0);
  EXPECT_TRUE(radar.same_antenna);
  EXPECT_EQ(radar.beam_elevation.deg(), -40.0);
  EXPECT_EQ(radar.window, Radar::Window::hamming);
  const Simulation& simulation = scene.simulations[0];
  EXPECT_EQ(simulation.sample_rate_hz, 0.12e9);
  EXPECT_EQ(simulation.lsb_v, 1e-10);
  EXPECT_EQ(simulation.format, FileFormat::binary);
  EXPECT_EQ(simulation.pulse_position, Simulation::PulsePosition::centre);
  EXPECT_EQ(simulation.file, "out.bin");
}

TEST(ReadScript, TakesTheirDefaultsWhereTheOverSamplingFieldsAreAbsent) {
  EXPECT_EQ(read_clean(simulation_with("ASC RAW f BEGIN")).simulations.at(0).width_factor, 0.0);
  const Scene half = read_clean(simulation_with("ASC RAW f BEGIN 3"));
  EXPECT_EQ(half.simulations.at(0).oversampling, 3.0);
  EXPECT_EQ(half.simulations.at(0).width_factor, 0.0);
}

TEST(ReadScript, TellsGainsByTheNumberOfValuesBehindThePower) {
  const Scene without = read_clean(example);
  EXPECT_EQ(without.radars.at(0).transmit_gain.db(), 0.0);
  const Scene zero = read_clean(replaced(example, "5.3 1 0 0", "5.3 1 0 0 0 0"));
  EXPECT_TRUE(zero == without);
  const Radar gains = read_clean(replaced(example, "5.3 1 0 0", "5.3 1 30 20 3 290")).radars.at(0);
  EXPECT_EQ(gains.transmit_gain.db(), 30.0);
  EXPECT_EQ(gains.receive_gain.db(), 20.0);
  EXPECT_EQ(gains.losses.db(), 3.0);
  EXPECT_EQ(gains.noise_temperature_k, 290.0);
}

TEST(ReadScript, TakesTheThesisSpellingOfTheSimpleAntenna) {
  EXPECT_TRUE(read_clean(replaced(example, "SINX 60 6", "SIMPLE 60 6")) == read_clean(example));
  const Radar both = read_clean(replaced(example, "SAME", "SIMPLE 5 4")).radars.at(0);
  EXPECT_FALSE(both.same_antenna);
  EXPECT_EQ(both.receive_antenna.pattern, Antenna::Pattern::sinx);
  EXPECT_EQ(both.receive_antenna.azimuth_beamwidth.deg(), 4.0);
}

TEST(ReadScript, ReadsThePlatformsOf1997WithoutKeywordAndRates) {
  const Platform platform =
      read_clean("$PLATFORM E STATIONARY 1 2 3 10 20 30 STDDEV 4 5 6 STDDEV 7 8 9").platforms.at(0);
  EXPECT_EQ(platform.position_m, (core::Vec3{1, 2, 3}));
  EXPECT_EQ(platform.rotation[2].deg(), 30.0);
  EXPECT_EQ(platform.rotation_rate[0].deg(), 0.0);
  EXPECT_EQ(platform.position_stddev_m, (core::Vec3{4, 5, 6}));
  EXPECT_EQ(platform.rotation_stddev[0].deg(), 7.0);
}

TEST(ReadScript, GoesOnWithTheRotationErrorsAfterPositionErrorsOfItsOwn) {
  const Platform platform = read_clean(
                                "$PLATFORM E STAT 1 2 3 CONST 0 0 0 0 0 0 OTHER LIN LIN CUB INLINE 1 0 1 1 0 2 "
                                "1 0 3 STD 7 8 9")
                                .platforms.at(0);
  EXPECT_EQ(platform.position_error, Platform::MotionError::envelope);
  EXPECT_EQ(platform.position_envelope.part[2].knots.at(0).y, 3.0);
  EXPECT_EQ(platform.position_envelope.part[2].method, core::Interpolation::cubic);
  EXPECT_EQ(platform.rotation_stddev[2].deg(), 9.0);
}

TEST(ReadScript, ReadsThreeFunctionsForTheBeamDirection) {
  const Radar radar = read_radar(
      "MONO 1 RECT CON 1 SIN 1 1 0 0 ISO ISO OTHER LIN LIN LIN INLINE 1 0 1 1 0 2 1 0 3 "
      "BARTLETT APPLY_STC OTHER MFI INLINE 1 0 5");
  EXPECT_EQ(radar.beam, Radar::Beam::user);
  EXPECT_EQ(radar.beam_target_world_m.part[1].knots.at(0).y, 2.0);
  EXPECT_EQ(radar.window, Radar::Window::bartlett);
  EXPECT_EQ(radar.stc, Radar::Stc::user);
  EXPECT_EQ(radar.stc_gain.part[0].method, core::Interpolation::low_pass);
  EXPECT_FALSE(radar.same_antenna);
}

TEST(ReadScript, TakesBarAsBarkerForThePulseAndAsBartlettForTheWindow) {
  const Radar radar = read_radar("BAR 3 1 RECT CON 1 SIN 1 1 0 0 ISO SAM FIX 1 2 BAR NO_STC");
  EXPECT_EQ(radar.pulse, Radar::Pulse::barker);
  EXPECT_EQ(radar.barker_code, 3);
  EXPECT_EQ(radar.window, Radar::Window::bartlett);
}

TEST(ReadScript, ReadsTheCarrierListInGigahertz) {
  const Radar radar = read_radar(
      "MONO 1 LIN 20 30 OTH LIN INLINE 2 0 0.001 0 0.002 OTH LIN INLINE 2 0 5.3 0 0.141 1 0 "
      "0 ISO SAM ROT 1 2 HAN 0.5 APP 1OV");
  EXPECT_EQ(radar.carrier_list_hz.part[0].knots, (std::vector<core::Knot>{{0, 5.3e9}, {0, 0.141e9}}));
  EXPECT_EQ(radar.pri_s.part[0].knots.at(1).y, 0.002);
  EXPECT_EQ(radar.rise_s, 20e-9);
  EXPECT_EQ(radar.fall_s, 30e-9);
  EXPECT_EQ(radar.beam_rate.deg(), 2.0);
  EXPECT_EQ(radar.hanning_pedestal, 0.5);
  EXPECT_EQ(radar.stc, Radar::Stc::range_law);
}

TEST(ReadScript, ReadsSteppedCarriersAndTheSpot) {
  const Radar radar = read_radar("CHIRP -0.1 1 RECT CON 1 STE 1 0.1 3 2 1 0 0 ISO SAM SPOT 1 2 3 HAM NO_STC");
  EXPECT_EQ(radar.bandwidth_hz, -0.1e9);
  EXPECT_EQ(radar.carrier_step_hz, 0.1e9);
  EXPECT_EQ(radar.carrier_steps, 3);
  EXPECT_EQ(radar.pulses_per_step, 2);
  EXPECT_EQ(radar.spot_world_m, (core::Vec3{1, 2, 3}));
}

TEST(ReadScript, TakesWholeNumbersInAnyNotation) {
  EXPECT_EQ(read_clean("$SIM R 1 2 3 4 8.0 1 0 ASC RAW f BEG").simulations.at(0).bits, 8);
  EXPECT_EQ(read_clean("$SIM R 1 2 3 4 +1.2E1 1 0 ASC RAW f BEG").simulations.at(0).bits, 12);
}

TEST(ReadScript, TakesShortenedCommandsInTheOriginalsOrder) {
  const Scene scene = read_clean(
      "$P E STA 0 0 0 CON 0 0 0 0 0 0 STD 0 0 0 STD 0 0 0\n$T E 0 0 0 0 0 0 1 0 I\n"
      "$S R 1 2 3 4 8 1 0 A R f C\n$SU E 1 2 3 4 5 6 7 8 9\n$G R 1 2 3 4 C 5 f\n"
      "$O PRO CLA\n$TARGEX E 0 0 0 0 0 0 1 0 ISO");
  EXPECT_EQ(scene.platforms.size(), 1U);
  EXPECT_EQ(scene.targets.size(), 2U);
  EXPECT_EQ(scene.simulations.size(), 1U);
  ASSERT_EQ(scene.surfaces.size(), 1U);
  EXPECT_EQ(scene.surfaces[0].corner_m[2], (core::Vec3{7, 8, 9}));
  ASSERT_EQ(scene.geometries.size(), 1U);
  EXPECT_EQ(scene.geometries[0].separator, GeometryTable::Separator::comma);
  EXPECT_EQ(scene.options.profile, Profile::classic);
}

TEST(ReadScript, ReadsCloudsWithTheNameOfTheirFile) {
  const Scene scene = read_clean(
      "$CLOUD Earth FILE \"my points.npy\" 1 2 3 4 5 ISOTROPIC\n"
      "$C Earth fil b.csv 0 0 0 1 0 DIR 10 20 1 2 COS_GAIN");
  ASSERT_EQ(scene.clouds.size(), 2U);
  EXPECT_EQ(scene.clouds[0].file, "my points.npy");
  EXPECT_EQ(scene.clouds[0].traits.position_stddev_m, (core::Vec3{1, 2, 3}));
  EXPECT_EQ(scene.clouds[0].rcs_m2, 4.0);
  EXPECT_EQ(scene.clouds[0].traits.rcs_stddev_m2, 5.0);
  EXPECT_EQ(scene.clouds[1].file, "b.csv");
  EXPECT_EQ(scene.clouds[1].traits.reflectivity, Target::Reflectivity::directional);
  EXPECT_EQ(scene.clouds[1].traits.elevation, core::Angle::from_deg(20.0));
  EXPECT_FALSE(scene.clouds[1].points) << "the reader of scripts reads no tables";
}

TEST(ReadScript, RefusesACloudWithoutTheWordFile) {
  const ScriptReading reading = read_script("$CLOUD Earth points.npy 0 0 0 1 0 ISOTROPIC", "a.scr", {});
  ASSERT_FALSE(reading.problems.empty());
  EXPECT_EQ(reading.problems[0].expected, "FILE");
  EXPECT_EQ(reading.problems[0].subject, (core::Subject{"cloud", 0, "file"}));
}

TEST(ReadScript, ReadsOptionsInAnyOrder) {
  const RunOptions options =
      read_clean("$OPTIONS TOLERANCE 1e-9 PULSE BAND_LIMITED SEED 18446744073709551615 PROFILE PHYSICAL").options;
  EXPECT_EQ(options.tolerance, 1e-9);
  EXPECT_EQ(options.pulse, PulseDefinition::band_limited);
  EXPECT_EQ(options.seed, UINT64_MAX);
  EXPECT_EQ(options.profile, Profile::physical);
}

TEST(ReadScript, ReadsEveryOutputFormat) {
  const std::array<std::pair<const char*, FileFormat>, 8> formats{{{"ASCII", FileFormat::ascii},
                                                                   {"BINARY", FileFormat::binary},
                                                                   {"bracket", FileFormat::bracket},
                                                                   {"HDF5", FileFormat::hdf5},
                                                                   {"CSV", FileFormat::csv},
                                                                   {"NPY", FileFormat::npy},
                                                                   {"B", FileFormat::binary},
                                                                   {"BRA", FileFormat::bracket}}};
  for (const auto& [word, format] : formats)
    EXPECT_EQ(read_clean(simulation_with(word + std::string(" SRP f CENTER"))).simulations.at(0).format, format)
        << word;
}

TEST(ReadScript, KeepsNamesAsTyped) {
  const Scene scene = read_clean(
      "$TARGET \"Old ship\" 0 0 0 0 0 0 1 0 ISO $TARGET a_name_of_more_than_15_characters 0 "
      "0 0 0 0 0 1 0 ISO ! M\xF6we\n");
  EXPECT_EQ(scene.targets.at(0).platform, "Old ship");
  EXPECT_EQ(scene.targets.at(1).platform, "a_name_of_more_than_15_characters");
}

// Otherwise a script of a million targets takes three times the memory.
TEST(ReadScript, LetsTargetsShareWhatTheyHaveInCommon) {
  const Scene scene = read_clean(
      "$TARGET Ship 1 0 0 0 0 0 1 0 DIRECTIONAL 10 20 0 0 COS_GAIN $TARGET Ship 2 0 0 0 0 0 2 0 DIRECTIONAL 10 20 0 0 "
      "COS_GAIN $TARGET Earth 2 0 0 0 0 0 2 0 ISO $TARGET Earth 2 0 0 -0 0 0 2 0 ISO\n");
  EXPECT_EQ(&*scene.targets.at(0).platform, &*scene.targets.at(1).platform);
  EXPECT_EQ(&*scene.targets.at(0).traits, &*scene.targets.at(1).traits);
  EXPECT_EQ(&*scene.targets.at(2).traits, &*Target().traits);
  EXPECT_EQ(&*scene.targets.at(2).platform, &*Target().platform);
  EXPECT_TRUE(std::signbit(scene.targets.at(3).traits->position_stddev_m.x));
}

TEST(ReadScript, ReadsCarriageReturnsAsSeparators) {
  std::string dos;
  for (const char c : example) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(read_clean(dos + "\x1A") == read_clean(example));
}

TEST(ReadScript, ReadsTheShortenedScriptOfTheThesis) {
  // The layout of figure 7.5 (1997): no rotation keyword, no rates, no over-sampling fields.
  const Scene scene = read_clean(
      "$PLATFORM EARTH\nSTATIONARY\n0 ! x\n0\n0\n0 ! (deg)\n0\n0\nSTDDEV\n0\n0\n0\nSTDDEV\n0\n0\n0\n\n"
      "$PLATFORM PLANE\nTRAJECTORY\nCUBIC\nCUBIC\nCUBIC\nINLINE\n2 ! n\n0, 100 1, -100\n1\n0, -10000\n1\n0, 2000\n"
      "NOT_ALIGNED\n0\n0\n0\nSTDDEV\n0\n0\n0\nSTDDEV\n0\n0\n0\n\n"
      "$TARGET EARTH ! p\n0, -100, 0\n0, 0, 0\n1, 0\nISOTROPIC\n\n"
      "$RADAR\nRADAR1\nPLANE\nCHIRP\n0.1\n800\nRECT\nCONSTANT\n300\nSINGLE\n5.3\n1\n0\n0\nSINX\n30\n30\nSAME\nFIXED\n"
      "-11.3\n0\nRECT\nNO_STC\n\n"
      "$SIMULATION\nRADAR1\n10010\n10510\n-0.5\n1.499\n8\n0.15\n1.68257E-07\nASCII\nRAW\nSIM1.ASC\n ! Size\nBEGIN\n");
  EXPECT_EQ(scene.platforms.at(1).trajectory_m.part[0].knots.at(1).y, -100.0);
  EXPECT_EQ(scene.radars.at(0).pulse_width_s, 800e-9);
  EXPECT_EQ(scene.simulations.at(0).lsb_v, 1.68257e-10);
}

TEST(ReadScript, AllowsObjectsInAnyOrder) {
  const Scene scene = read_clean("$SIM R 1 2 3 4 8 1 0 ASC RAW f BEG\n$TARGET E 0 0 0 0 0 0 1 0 ISO");
  EXPECT_EQ(scene.simulations.size(), 1U);
  EXPECT_EQ(scene.targets.size(), 1U);
}

TEST(ReadScript, NotesWhereEveryFieldStands) {
  const ScriptReading reading = read_script(example, "t.scr", {});
  const auto at = [&](const char* kind, std::size_t index, const char* field) {
    const core::Place place = reading.places.find({kind, index, field});
    EXPECT_EQ(place.file, "t.scr");
    return std::pair(place.line, place.column);
  };
  EXPECT_EQ(at("platform", 1, "name"), (std::pair<std::size_t, std::size_t>(3, 11)));
  EXPECT_EQ(at("platform", 1, "trajectory_m"), (std::pair<std::size_t, std::size_t>(3, 22)));
  EXPECT_EQ(at("radar", 0, "pulse_width_s"), (std::pair<std::size_t, std::size_t>(9, 27)));
  EXPECT_EQ(at("radar", 0, "transmit_antenna.azimuth_beamwidth"), (std::pair<std::size_t, std::size_t>(10, 10)));
  EXPECT_EQ(at("radar", 0, "spot_world_m"), (std::pair<std::size_t, std::size_t>(9, 1)));
  EXPECT_EQ(at("simulation", 0, "bits"), (std::pair<std::size_t, std::size_t>(11, 32)));
}

TEST(Locate, FillsInThePlacesOfSceneProblemsOnly) {
  const ScriptReading reading = read_script(example, "t.scr", {});
  core::Problems problems(3);
  problems[0].subject = {"radar", 0, "prf_hz"};
  problems[1].subject = {"radar", 0, "prf_hz"};
  problems[1].place = {"other", 7, 8};
  locate(problems, reading.places);
  EXPECT_EQ(problems[0].place, (core::Place{"t.scr", 9, 43}));
  EXPECT_EQ(problems[1].place, (core::Place{"other", 7, 8}));
  EXPECT_EQ(problems[2].place, core::Place{});
}

}  // namespace reader_test
}  // namespace sarsim::scene

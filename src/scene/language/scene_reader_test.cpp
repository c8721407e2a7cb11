#include "scene/language/scene_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "scene/language/format_mark.hpp"
#include "scene/language/scene_writer.hpp"

namespace sarsim::scene {

namespace {

const std::string mark = "format = \"sarsim 2\"\n";

ScriptReading read(const std::string& text, const ReadControl& control = {}) {
  return read_format_2(mark + text, "scene.toml", {}, control);
}

Scene sound(const std::string& text, const ReadControl& control = {}) {
  ScriptReading reading = read(text, control);
  for (const core::Problem& problem : reading.problems) ADD_FAILURE() << core::to_string(problem);
  return std::move(reading.scene);
}

// All problems as people see them, a line each.
std::string complaints(const std::string& text, const ReadControl& control = {}) {
  std::string lines;
  for (const core::Problem& problem : read(text, control).problems) lines += core::to_string(problem) + "\n";
  return lines;
}

using testing::HasSubstr;

}  // namespace

TEST(FormatMark, TellsTheLanguagesApartByTheirFirstLine) {
  for (const char* text : {"format = \"sarsim 2\"", "# a comment\n", "\n\n  [let]\n",
                           "\xEF\xBB\xBF# with a mark of the order of bytes", "a.\"b c\" = 1"})
    EXPECT_TRUE(is_format_2(text)) << text;
  EXPECT_FALSE(is_format_2("# free text\n$PLATFORM Earth"));
  EXPECT_TRUE(is_format_2("# a comment\nformat = \"sarsim 2\"\n$RADAR"));
  for (const char* text :
       {"", "! a comment = 1\n", "$PLATFORM Earth", "text before the first command\n$RADAR", "= 3", "12 (3) = 4"})
    EXPECT_FALSE(is_format_2(text)) << text;
}

TEST(Format2, BareNumbersAreInBaseUnitsAndQuantitiesCarryTheirs) {
  const Scene scene = sound(
      "[[radar]]\nname = \"R\"\npulse = { type = \"chirp\", bandwidth = 1e8, width = \"800 ns\" }\n"
      "carrier = \"5.3 GHz\"\nrepetition = 620\npower = \"30 dBm\"\nbeam = { type = \"fixed\", elevation = -11.3 }\n");
  const Radar& radar = scene.radars.at(0);
  EXPECT_EQ(radar.bandwidth_hz, 1e8);
  EXPECT_EQ(radar.pulse_width_s, 800e-9);
  EXPECT_EQ(radar.carrier_hz, 5.3e9);
  EXPECT_EQ(radar.prf_hz, 620.0);
  EXPECT_NEAR(radar.power_w, 1.0, 1e-15);
  EXPECT_DOUBLE_EQ(radar.beam_elevation.deg(), -11.3);
}

TEST(Format2, WhatIsNotSaidHasItsDefault) {
  const Scene scene = sound("[[radar]]\n[[target]]\n");
  EXPECT_EQ(scene.radars.at(0), Radar{});
  EXPECT_EQ(scene.targets.at(0), Target{});
}

TEST(Format2, TargetsShareWhatTheyHaveInCommon) {
  const std::string ship = "[[platform]]\nname = \"Ship\"\n";
  const std::string target =
      "[[target]]\nplatform = \"Ship\"\nreflectivity = { type = \"directional\", azimuth = \"9 deg\" }\n";
  for (const Scene& scene : {sound(ship + target + "position = [1, 0, 0]\n" + target + "position = [2, 0, 0]\n"),
                             sound(ship + target + "positions = [[1, 0, 0], [2, 0, 0]]\n")}) {
    EXPECT_EQ(scene.targets.at(1).position_m.x, 2.0);
    EXPECT_EQ(&*scene.targets.at(0).platform, &*scene.targets.at(1).platform);
    EXPECT_EQ(&*scene.targets.at(0).traits, &*scene.targets.at(1).traits);
  }
}

TEST(Format2, OneValueMayBeWrittenInManyWays) {
  const Scene one = sound("[[radar]]\npulse = { type = \"chirp\", width = 2e-6 }\n");
  const Scene two = sound("[[radar]]\n[radar.pulse]\ntype = \"chirp\"\nwidth = 2e-6\n");
  const Scene three = sound("[[radar]]\npulse.type = \"chirp\"\npulse.\"width\" = \"2 us\"\n");
  EXPECT_EQ(one, two);
  EXPECT_EQ(one, three);
  EXPECT_EQ(one.radars.at(0).pulse, Radar::Pulse::chirp);
}

TEST(Format2, AlternativesWithoutFieldsAreWordsAndTheFirstMayBeItsValue) {
  const Scene scene =
      sound("[[radar]]\nwindow = \"hamming\"\ncarrier = \"9 GHz\"\n[[platform]]\nrotation = [1, 2, 3]\n");
  EXPECT_EQ(scene.radars.at(0).window, Radar::Window::hamming);
  EXPECT_EQ(scene.radars.at(0).carrier_hz, 9e9);
  EXPECT_DOUBLE_EQ(scene.platforms.at(0).rotation[1].deg(), 2.0);
}

TEST(Format2, TheCarrierIsTheFirstOfSteps) {
  const Scene scene = sound(
      "[[radar]]\ncarrier = { type = \"stepped\", first = \"9 GHz\", step = \"5 MHz\", count = 64, pulses = 1 }\n");
  EXPECT_EQ(scene.radars.at(0).carrier_hz, 9e9);
  EXPECT_EQ(scene.radars.at(0).carrier_steps, 64);
  EXPECT_THAT(complaints("[[radar]]\ncarrier = { type = \"stepped\", frequency = \"9 GHz\" }\n"),
              HasSubstr("frequency"));
}

TEST(Format2, PositionsMakeManyTargetsThatAreAlike) {
  const ScriptReading reading =
      read("[[target]]\nrcs = 2\npositions = [[1, 2, 3], # first\n  [\"4 m\", 5, 6],\n]\n[[target]]\n");
  ASSERT_EQ(reading.scene.targets.size(), 3U);
  EXPECT_EQ(reading.scene.targets[1].position_m, (core::Vec3{4, 5, 6}));
  EXPECT_EQ(reading.scene.targets[1].rcs_m2, 2.0);
  EXPECT_EQ(reading.scene.targets[2].rcs_m2, 1.0);
  EXPECT_EQ(reading.places.find({"target", 1, "position_m"}).line, 5U);
  EXPECT_EQ(reading.places.find({"target", 2, "rcs_m2"}).line, 7U);
}

TEST(Format2, PositionsInAFileMakeACloud) {
  const Scene scene = sound("[[target]]\npositions = { file = \"points.npy\" }\nrcs = 3\n");
  ASSERT_EQ(scene.clouds.size(), 1U);
  EXPECT_TRUE(scene.targets.empty());
  EXPECT_EQ(scene.clouds[0].file, "points.npy");
  EXPECT_EQ(scene.clouds[0].rcs_m2, 3.0);
  EXPECT_THAT(complaints("[[target]]\npositions = { file = \"points.npy\" }\nposition = [1, 2, 3]\n"),
              HasSubstr("scene.toml:4:1: error: a target has either position or positions"));
}

TEST(Format2, NamesOfLetStandForNumbers) {
  const std::string text =
      "[let]\nazimuth = \"30 deg\"\nspeed = \"2 * half\"\nhalf = \"50 m/s\"\n[[platform]]\nname = "
      "\"P\"\n[platform.path]\n"
      "type = \"line\"\nstart = [\"15 km * sin(azimuth)\", 0, \"100 m\"]\nvelocity = [\"-speed\", 0, 0]\n";
  const auto path = sound(text).platforms.at(0).trajectory_m.part;
  EXPECT_NEAR(path[0].knots.at(0).y, 7500.0, 1e-9);
  EXPECT_NEAR(path[0].knots.at(1).y - path[0].knots.at(0).y, -100.0, 1e-9);
  EXPECT_EQ(path[2].knots, (std::vector<core::Knot>{{0.0, 100.0}}));
  ReadControl control;
  control.let = {{"half", "10 m/s"}};
  EXPECT_NEAR(sound(text, control).platforms.at(0).trajectory_m.part[0].knots.at(1).y, 7480.0, 1e-9);
  control.let = {{"halve", "10 m/s"}};
  EXPECT_THAT(complaints(text, control), HasSubstr("did you mean 'half'?"));
}

TEST(Format2, IncludedFilesComeFirstAndShareTheirNames) {
  const std::map<std::string, std::string> files{
      {"ground.toml", mark + "include = [\"more/deep.toml\"]\n[let]\nheight = \"2 km\"\n[[target]]\nrcs = 5\n"},
      {"more/deep.toml", mark + "[[target]]\nrcs = 4\nposition = [0, 0, \"height\"]\n"}};
  const DataFileLoader loader = [&](const std::string& name) {
    const auto found = files.find(name);
    return found == files.end() ? DataFileText{{}, {}, "data file not found"} : DataFileText{name, found->second, {}};
  };
  const ScriptReading reading =
      read_format_2(mark + "include = [\"ground.toml\"]\n[[target]]\nrcs = 6\nposition = [0, 0, \"height/2\"]\n",
                    "scene.toml", loader);
  EXPECT_TRUE(reading.problems.empty());
  ASSERT_EQ(reading.scene.targets.size(), 3U);
  EXPECT_EQ(reading.scene.targets[0].position_m.z, 2000.0);
  EXPECT_EQ(reading.scene.targets[1].rcs_m2, 5.0);
  EXPECT_EQ(reading.scene.targets[2].position_m.z, 1000.0);
  EXPECT_EQ(reading.places.find({"target", 0, "rcs_m2"}).file, "more/deep.toml");
  const ScriptReading missing = read_format_2(mark + "include = [\"no.toml\"]\n", "scene.toml", loader);
  ASSERT_EQ(missing.problems.size(), 1U);
  EXPECT_EQ(missing.problems[0].place.line, 2U);
}

TEST(Format2, UnknownFieldsAreErrorsThatSayWhereTheyBelong) {
  EXPECT_THAT(complaints("[[target]]\npostion = [1, 2, 3]\n"),
              HasSubstr("scene.toml:3:1: error: target has no field 'postion'"));
  EXPECT_THAT(complaints("[[target]]\npostion = [1, 2, 3]\n"), HasSubstr("did you mean 'position'?"));
  EXPECT_THAT(complaints("[[radar]]\nbeam = { type = \"fixed\", rate = 3 }\n"), HasSubstr("beam of type rotating"));
  EXPECT_THAT(complaints("[[tagret]]\n"), HasSubstr("did you mean 'target'?"));
  EXPECT_THAT(complaints("[[platform]]\n[platform.path]\ntype = \"points\"\nrotation_rate = [0, 0, 1]\n"),
              HasSubstr("move it"));
  EXPECT_EQ(complaints("x-mine = 1\n[[target]]\nx-colour = \"red\"\n[x-notes]\na = 1\n"), "");
}

// A platform whose first leg is sound and whose second one is on line 6.
std::string with_second_leg(const std::string& leg) {
  return "[[platform]]\n[platform.path]\ntype = \"legs\"\nlegs = [{ leg = \"straight\", length = 1000 },\n  " + leg +
         "]\n";
}

TEST(Format2, ProblemsInAnEntryOfAListNameItAndItsLine) {
  EXPECT_THAT(complaints(with_second_leg("{ leg = \"loop\" }")),
              HasSubstr("scene.toml:6:11: error: leg 2: unknown kind of leg"));
  EXPECT_THAT(complaints(with_second_leg("{ leg = \"turn\", angle = 90, bank = 95 }")),
              HasSubstr("scene.toml:6:38: error: leg 2: bank of the turn is out of range"));
  EXPECT_THAT(complaints(with_second_leg("{ leg = \"straight\", lenght = 5 }")),
              HasSubstr("scene.toml:6:23: error: leg 2 has no field 'lenght'"));
  EXPECT_THAT(complaints("[[platform]]\noscillations = [\n3]\n"),
              HasSubstr("scene.toml:4:1: error: oscillation 1 is not a table"));
  const std::string waypoints = "[[platform]]\npath.type = \"waypoints\"\npath.waypoints = [{ speed = 3 }]\n";
  EXPECT_THAT(complaints(waypoints), HasSubstr("scene.toml:4:19: error: waypoint 1 lacks the position"));
}

TEST(Format2, PlacesOfEntriesAreKept) {
  const ScriptReading reading =
      read_format_2(mark + with_second_leg("{ leg = \"hold\", duration = 5 }"), "scene.toml", {});
  EXPECT_EQ(reading.places.find({"platform", 0, "legs[1]"}).line, 6U);
  EXPECT_EQ(reading.places.find({"platform", 0, "legs[0]"}).line, 5U);
  EXPECT_EQ(reading.places.find({"platform", 0, "legs[7]"}).line, 5U);  // that of the list
}

TEST(Format2, FieldsOfAnotherKindOfLegBelongThere) {
  const std::string told = complaints(with_second_leg("{ leg = \"straight\", length = 5, radius = 300 }"));
  EXPECT_THAT(told, HasSubstr("scene.toml:6:35: error: leg 2: 'radius' does not apply here"));
  EXPECT_THAT(told, HasSubstr("it belongs to leg turn, turn-to or circle"));
  EXPECT_THAT(complaints("[[platform]]\noscillations = [{ axis = \"roll\", amplitude = 3, frequency = 1 }]\n"),
              HasSubstr("it belongs to axis x, y or z"));
}

TEST(Format2, WhatALegCannotDoWithoutMustBeSaid) {
  const std::string turn = complaints(with_second_leg("{ leg = \"turn-to\", bank = 20 }"));
  EXPECT_THAT(turn, HasSubstr("scene.toml:6:3: error: leg 2 lacks the heading behind the turn"));
  EXPECT_THAT(complaints(with_second_leg("{ leg = \"climb-to\", rate = 2 }")),
              HasSubstr("leg 2 lacks the height behind the climb"));
  EXPECT_EQ(complaints(with_second_leg("{ leg = \"turn-to\", heading = 0, bank = 20 }")), "");
  EXPECT_EQ(complaints(with_second_leg("{ leg = \"climb-to\", height = 0, rate = 2 }")), "");
  // A word that is misspelt may be what is missing.
  const std::string misspelt = complaints(with_second_leg("{ leg = \"turn-to\", headnig = 5, bank = 20 }"));
  EXPECT_THAT(misspelt, HasSubstr("did you mean 'heading'?"));
  EXPECT_THAT(misspelt, testing::Not(HasSubstr("lacks")));
}

// A heading of 0 is no default: what is written must be read again.
TEST(Format2, WhatALegCannotDoWithoutIsWritten) {
  const std::string text = mark + with_second_leg("{ leg = \"turn-to\", heading = 0, bank = 20 }");
  const ScriptReading reading = read_format_2(text, "scene.toml", {});
  const ScriptReading again = read_format_2(write_format_2(reading.scene), "again.toml", {});
  EXPECT_EQ(again.scene, reading.scene);
  EXPECT_THAT(again.problems, testing::IsEmpty());
}

TEST(Format2, EveryMistakeOfATextIsTold) {
  const std::string told = complaints(
      "[[target]]\nrcs = \"1 km\"\n[[radar]]\nname = \"R\"\npower = -3\ncarrier = \"5,3 GHz\"\npulse = \"chrip\"\n"
      "[[recording]]\nradar = \"r\"\nbits = 100\nrange = [1]\n");
  EXPECT_THAT(told, HasSubstr("scene.toml:3:8: error: radar cross-section"));
  EXPECT_THAT(told, HasSubstr("scene.toml:6:9: error: transmitted power is out of range"));
  EXPECT_THAT(told, HasSubstr("scene.toml:7:1"));
  EXPECT_THAT(told, HasSubstr("did you mean \"chirp\"?"));
  EXPECT_THAT(told, HasSubstr("Capital letters count"));
  EXPECT_THAT(told, HasSubstr("bits of the A/D converter is out of range"));
  EXPECT_THAT(told, HasSubstr("range needs 2 values"));
}

TEST(Format2, UnlikelyNumbersAreRemarkedOn) {
  const std::string told = complaints("[[radar]]\ncarrier = 5.3\n");
  EXPECT_THAT(told, HasSubstr("warning: carrier frequency of 5.3 Hz is unusual"));
  EXPECT_THAT(told, HasSubstr("is a unit missing?"));
  EXPECT_THAT(complaints("[[radar]]\ncarrier = \"5.3 Hz\"\n"), testing::Not(HasSubstr("is a unit missing?")));
}

// Where there is one, it may be anywhere: in the Gulf of Guinea, too.
TEST(Format2, AWorldWithoutAnAnchorIsWarnedOf) {
  const std::string earth = "[world]\nframe = \"earth\"\n";
  EXPECT_THAT(complaints(earth), testing::StartsWith("scene.toml:3:9: warning: the world has no anchor: it lies at "
                                                     "latitude 0 and longitude 0; expected anchor = { latitude"));
  EXPECT_THAT(complaints(earth + "anchor = { height = \"10 m\" }\n"), HasSubstr("the world has no anchor"));
  EXPECT_THAT(complaints(earth + "anchor = { latitude = 0 }\n"),
              HasSubstr("anchor has no longitude: it lies at longitude 0"));
  EXPECT_THAT(complaints(earth + "anchor.longitude = 0\n"), HasSubstr("anchor has no latitude: it lies at latitude 0"));
  EXPECT_EQ(complaints(earth + "anchor = { latitude = 0, longitude = 0 }\n"), "");
  EXPECT_EQ(complaints(earth + "[world.anchor]\nlatitude = \"0 deg\"\nlongitude = \"0 deg\"\n"), "");
  EXPECT_EQ(complaints("[world]\nepoch = \"2024-04-01T00:00:00Z\"\n"), "");
}

// What is written says the anchor, so that reading it again is no surprise.
TEST(Format2, AnAnchorAtZeroIsWritten) {
  const Scene scene = sound("[world]\nframe = \"earth\"\nanchor = { latitude = 0, longitude = 0 }\n");
  const std::string written = write_format_2(scene);
  EXPECT_THAT(written, HasSubstr("anchor = { latitude = \"0 deg\", longitude = \"0 deg\" }"));
  EXPECT_TRUE(read_format_2(written, "scene.toml", {}).problems.empty());
}

TEST(Format2, TheWorldInOtherLettersIsTheWorld) {
  const std::string text = mark + "[[platform]]\nname = \"EARTH\"\n[[target]]\nplatform = \"EARTH\"\n[[target]]\n";
  const ScriptReading reading = read_format_2(text, "scene.toml", {});
  ASSERT_EQ(reading.problems.size(), 1U);
  EXPECT_EQ(reading.problems[0].severity, core::Severity::warning);
  EXPECT_THAT(core::to_string(reading.problems[0]), HasSubstr("scene.toml:3:8: warning: the world is called Earth"));
  EXPECT_THAT(complaints("[[platform]]\nname = \"EARTH\"\n[[platform]]\nname = \"Earth\"\n"),
              HasSubstr("another platform has this name, but for capital letters"));
}

TEST(Format2, UnknownTablesAreUnknownAndNotOneTooMany) {
  const std::string told = complaints("[[radar]]\n[[radar.swath]]\nlook = 3\n");
  EXPECT_THAT(told, HasSubstr("radar has no field '[[radar.swath]]'"));
  EXPECT_THAT(told, testing::Not(HasSubstr("there is one such table")));
  EXPECT_THAT(complaints("[[radar]]\n[[radar.pulse]]\nwidth = 3\n"), HasSubstr("there is one such table"));
}

TEST(Format2, TheMarkMustBeThere) {
  const ScriptReading reading = read_format_2("[[target]]\n", "scene.toml", {});
  ASSERT_EQ(reading.problems.size(), 1U);
  EXPECT_THAT(core::to_string(reading.problems[0]), HasSubstr("format = \"sarsim 2\""));
  EXPECT_THAT(core::to_string(read_format_2("format = \"sarsim 3\"\n", "scene.toml", {}).problems.at(0)),
              HasSubstr("newer"));
}

TEST(Format2, EitherLanguageIsReadByItsContent) {
  EXPECT_EQ(read_scene_text(mark + "[[target]]\n", "a.scr", {}).language, Language::format_2);
  EXPECT_EQ(
      read_scene_text("$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n", "a.toml", {})
          .scene.platforms.size(),
      1U);
}

TEST(ReadSceneText, NamesWhatIsNoSceneAlthoughItsLinesMightBeToml) {
  const std::pair<const char*, const char*> cases[] = {{"# a comment\nradar:\n  carrier: 9.6 GHz\n", "YAML"},
                                                       {"#!/bin/sh\nNAME=1\n", "a shell script"},
                                                       {"# a program\nimport math\nx = 3\n", "a Python program"}};
  for (const auto& [text, kind] : cases) {
    const ScriptReading reading = read_scene_text(text, "a", {});
    ASSERT_EQ(reading.problems.size(), 1U) << text;
    EXPECT_EQ(reading.problems[0].message, std::string("this is no scene: it seems to be ") + kind);
  }
  const ScriptReading unmarked = read_scene_text("# a scene\n[world]\nframe = \"flat\"\n", "a", {});
  ASSERT_FALSE(unmarked.problems.empty());
  EXPECT_EQ(unmarked.problems[0].message, "the format of the scene is not stated");
}

}  // namespace sarsim::scene

#include "scene/edit/splice_format_2.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "scene/edit/document.hpp"
#include "scene/edit/edit_test_support.hpp"
#include "scene/edit/script_values.hpp"
#include "scene/edit/splice_tables.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/scene_writer.hpp"
#include "support/processor_time.hpp"

namespace sarsim::scene {
namespace splice_format_2_test {

namespace fs = std::filesystem;

constexpr const char* commented = R"(# A scene for tests.
format = "sarsim 2"

[let]
speed = "240 m/s"

# The ship
[[platform]]
name = "Ship"  # as in the log
path = { type = "line", start = [0, 0, 10], velocity = ["speed", 0, 0] }

# the lone one
[[target]]
platform = "Ship"
position = ["2 * 5 m", 20, 0]  # surveyed in May
rcs = "2 m2"  # a small one

# -- the letter --

# four points
[[target]]
positions = [
  [1, 0, 0],  # first
  [2, 0, 0],
  # the third
  [3, 0, 0],
  [4, 0, 0]   # last
]
rcs = "3 m2"

[[radar]]
name = "R"
pulse = { type = "chirp", bandwidth = "100 MHz", width = "2 us" }
carrier = "5.3 GHz"

# how it looks
[radar.beam]
type = "rotating"  # once a second
rate = "360 deg/s"
elevation = "-2 deg"

[[recording]]
radar = "R"
range = ["speed * 1 s", "12 km"]
file = "a.bin"

[options]
seed = 7  # lucky
)";

std::string with(std::string text, std::string_view old_part, std::string_view new_part) {
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return at == std::string::npos ? text : text.replace(at, old_part.size(), new_part);
}

Target target_at(core::Vec3 position, double rcs_m2 = 1.0) {
  Target target;
  target.position_m = position;
  target.rcs_m2 = rcs_m2;
  return target;
}

Scene scene_of(const std::string& text) {
  const ScriptReading reading = read_format_2(text, "", {});
  EXPECT_FALSE(core::has_errors(reading.problems)) << reading.problems[0].message << "\n" << text;
  return reading.scene;
}

// The text after an edit; what the edit makes of the scene must be what it says.
std::string after_edit(const std::string& text, const Edit& edit) {
  const Scene before = scene_of(text);
  const Format2Splice splice = splice_format_2(text, format_2::find_tables(text), {}, before, edit, "", {});
  EXPECT_EQ(apply_changes(text, splice.changes), splice.text);
  EXPECT_EQ(revert_changes(splice.text, splice.changes), text);
  Scene after = before;
  apply(edit, after);
  EXPECT_TRUE(scene_of(splice.text) == after) << splice.text;
  return splice.text;
}

template <class Object, class Change>
std::string after_change(const std::string& text, ObjectKind kind, std::size_t index, Change change) {
  const Scene scene = scene_of(text);
  Object object = std::get<Object>(object_of(scene, {kind, index}));
  change(object);
  return after_edit(text, replace_object(scene, {kind, index}, object, "Change"));
}

template <class Change>
std::string after_target(const std::string& text, std::size_t index, Change change) {
  return after_change<Target>(text, ObjectKind::target, index, change);
}
template <class Change>
std::string after_radar(const std::string& text, Change change) {
  return after_change<Radar>(text, ObjectKind::radar, 0, change);
}

TEST(SpliceFormat2, ReplacesOnlyTheNumberThatDiffers) {
  EXPECT_EQ(after_target(commented, 0, [](Target& t) { t.position_m.y = 21.5; }),
            with(commented, "[\"2 * 5 m\", 20, 0]", "[\"2 * 5 m\", 21.5, 0]"));
  EXPECT_EQ(after_target(commented, 0, [](Target& t) { t.position_m.x = 11.0; }),
            with(commented, "[\"2 * 5 m\", 20, 0]", "[11, 20, 0]"));
  EXPECT_EQ(after_target(commented, 0, [](Target& t) { t.rcs_m2 = 2.5; }),
            with(commented, "rcs = \"2 m2\"", "rcs = \"2.5 m2\""));
}

TEST(SpliceFormat2, ReplacesInnerValuesOfInlineTablesAndSubTables) {
  EXPECT_EQ(after_radar(commented, [](Radar& r) { r.bandwidth_hz = 120e6; }),
            with(commented, "\"100 MHz\"", "\"120 MHz\""));
  EXPECT_EQ(after_radar(commented, [](Radar& r) { r.beam_elevation = core::Angle::from_deg(-3.0); }),
            with(commented, "\"-2 deg\"", "\"-3 deg\""));
  EXPECT_EQ(after_radar(commented, [](Radar& r) { r.carrier_hz = 5.4e9; }), with(commented, "5.3 GHz", "5.4 GHz"));
  EXPECT_EQ(after_change<Simulation>(commented, ObjectKind::simulation, 0, [](Simulation& s) { s.range_end_m = 13e3; }),
            with(commented, "[\"speed * 1 s\", \"12 km\"]", "[\"speed * 1 s\", \"13 km\"]"));
}

TEST(SpliceFormat2, AddsKeysBehindTheLastOfTheirTable) {
  EXPECT_EQ(after_target(commented, 0, [](Target& t) { t.traits.edit().rcs_stddev_m2 = 0.5; }),
            with(commented, "# a small one\n", "# a small one\nrcs_deviation = \"0.5 m2\"\n"));
  EXPECT_EQ(after_radar(commented, [](Radar& r) { r.power_w = 5.0; }),
            with(commented, "carrier = \"5.3 GHz\"\n", "carrier = \"5.3 GHz\"\npower = \"5 W\"\n"));
}

TEST(SpliceFormat2, RemovesTheLineOfWhatIsAtItsDefaultAgain) {
  EXPECT_EQ(after_target(commented, 0, [](Target& t) { t.rcs_m2 = 1.0; }),
            with(commented, "rcs = \"2 m2\"  # a small one\n", ""));
  EXPECT_EQ(after_radar(commented, [](Radar& r) { r.beam_elevation = {}; }),
            with(commented, "elevation = \"-2 deg\"\n", ""));
  EXPECT_EQ(after_radar(commented, [](Radar& r) { r.pulse_width_s = 5e-6; }),
            with(commented, ", width = \"2 us\" }", " }"));
}

TEST(SpliceFormat2, FollowsAChoice) {
  const auto chirp_to_mono = [](Radar& r) {
    r.pulse = Radar::Pulse::mono;
    r.bandwidth_hz = Radar().bandwidth_hz;
  };
  EXPECT_EQ(after_radar(commented, chirp_to_mono),
            with(commented, "type = \"chirp\", bandwidth = \"100 MHz\", width", "type = \"mono\", width"));
  const auto to_spot = [](Radar& r) {
    r.beam = Radar::Beam::spot;
    r.beam_rate = r.beam_elevation = {};
    r.spot_world_m = {1.0, 2.0, 3.0};
  };
  EXPECT_EQ(after_radar(commented, to_spot),
            with(commented, "type = \"rotating\"  # once a second\nrate = \"360 deg/s\"\nelevation = \"-2 deg\"\n",
                 "type = \"spot\"  # once a second\npoint = [1, 2, 3]\n"));
  const auto to_fixed = [](Radar& r) {
    r.beam = Radar::Beam::fixed;
    r.beam_rate = r.beam_elevation = {};
  };
  EXPECT_EQ(after_radar(commented, to_fixed),
            with(commented,
                 "\n# how it looks\n[radar.beam]\ntype = \"rotating\"  # once a second\nrate = \"360 deg/s\"\n"
                 "elevation = \"-2 deg\"\n",
                 ""));
  const auto to_stepped = [](Radar& r) { r.carrier = Radar::Carrier::stepped; };
  EXPECT_EQ(after_radar(commented, to_stepped),
            with(commented, "carrier = \"5.3 GHz\"", "carrier = { type = \"stepped\", first = \"5.3 GHz\" }"));
}

TEST(SpliceFormat2, KeepsDottedKeys) {
  const std::string text =
      "format = \"sarsim 2\"\n[[radar]]\n  pulse.type = \"chirp\" # a\n  pulse.width = \"2 us\"\n  name = \"R\"";
  EXPECT_EQ(after_radar(text, [](Radar& r) { r.pulse_width_s = 3e-6; }), with(text, "2 us", "3 us"));
  EXPECT_EQ(after_radar(text, [](Radar& r) { r.bandwidth_hz = 1e6; }),
            with(text, "\"2 us\"\n", "\"2 us\"\n  pulse.bandwidth = \"1 MHz\"\n"));
  EXPECT_EQ(after_radar(text, [](Radar& r) { r.power_w = 5.0; }), text + "\n  power = \"5 W\"");
  EXPECT_EQ(after_radar(text,
                        [](Radar& r) {
                          r.pulse = Radar::Pulse::mono;
                          r.pulse_width_s = 5e-6;
                        }),
            "format = \"sarsim 2\"\n[[radar]]\n  name = \"R\"");
}

TEST(SpliceFormat2, KeepsTheOtherPointsOfAFunction) {
  const std::string text =
      "format = \"sarsim 2\"\n[[platform]]\n[platform.path]\ntype = \"points\"\nx = { points = [\n"
      "  [0, \"2 km\"], # begin\n  [1, 5],\n  [2, 7], # end\n] }\n";
  const auto change = [&](auto how) {
    return after_change<Platform>(text, ObjectKind::platform, 0,
                                  [&](Platform& p) { how(p.trajectory_m.part[0].knots); });
  };
  using Knots = std::vector<core::Knot>;
  EXPECT_EQ(change([](Knots& k) { k[1].y = 6.0; }), with(text, "[1, 5]", "[1, 6]"));
  EXPECT_EQ(change([](Knots& k) { k.erase(k.begin() + 1); }), with(text, ", # begin\n  [1, 5]", ""));
  EXPECT_EQ(change([](Knots& k) { k.insert(k.begin() + 2, {1.5, 6.0}); }), with(text, "[1, 5]", "[1, 5], [1.5, 6]"));
  EXPECT_EQ(change([](Knots& k) { k.push_back({3.0, 6.0}); }), with(text, "[2, 7]", "[2, 7], [3, 6]"));
  EXPECT_EQ(change([](Knots& k) { k.insert(k.begin(), {-1.0, 6.0}); }), with(text, "[0, \"2", "[-1, 6], [0, \"2"));
}

TEST(SpliceFormat2, WritesAPathOfTypeLineAsPoints) {
  const std::string after = after_change<Platform>(commented, ObjectKind::platform, 0,
                                                   [](Platform& p) { p.trajectory_m.part[2].knots[0].y = 20.0; });
  EXPECT_EQ(after, with(commented, "path = { type = \"line\", start = [0, 0, 10], velocity = [\"speed\", 0, 0] }",
                        "path = { type = \"points\", x = { points = [[0, 0], [1, 240]] }, y = { points = [[0, 0]] }, "
                        "z = { points = [[0, 20]] } }"));
  EXPECT_EQ(after_change<Platform>(commented, ObjectKind::platform, 0,
                                   [](Platform& p) { p.rotation_rate[0] = core::Angle::from_deg(1.0); }),
            with(commented, "0, 0] }\n", "0, 0] }\nrotation_rate = [1, 0, 0]\n"));
}

TEST(SpliceFormat2, GivesALongTableAHeader) {
  const std::string text = "format = \"sarsim 2\"\n\n[[radar]]\npulse = \"mono\" # simple\nname = \"R\"\n\n# end\n";
  const std::string after = after_radar(text, [](Radar& r) {
    r.pulse = Radar::Pulse::user;
    for (int i = 0; i <= 20; ++i) r.pulse_iq.part[0].knots.push_back({i / 20.0, i * 0.125});
  });
  EXPECT_TRUE(after.starts_with("format = \"sarsim 2\"\n\n[[radar]]\nname = \"R\"\n[radar.pulse]\ntype = \"points\"\n"))
      << after;
  EXPECT_TRUE(after.ends_with("\n\n# end\n"));
}

TEST(SpliceFormat2, ReplacesTheRowOfATargetThatMoves) {
  EXPECT_EQ(after_target(commented, 2,
                         [](Target& t) {
                           t.position_m = {2.0, 5.0, 0.0};
                         }),
            with(commented, "[2, 0, 0]", "[2, 5, 0]"));
  const Scene scene = scene_of(commented);
  Edit both = replace_object(scene, {ObjectKind::target, 1}, target_at({9, 0, 0}, 3.0), "");
  both.changes.push_back(replace_object(scene, {ObjectKind::target, 4}, target_at({8, 0, 0}, 3.0), "").changes[0]);
  EXPECT_EQ(after_edit(commented, both), with(with(commented, "[1, 0", "[9, 0"), "[4, 0", "[8, 0"));
}

TEST(SpliceFormat2, RemovesTheRowOfATarget) {
  const auto without = [](std::vector<std::size_t> rows) {
    std::vector<ObjectId> ids;
    for (const std::size_t row : rows) ids.push_back({ObjectKind::target, row + 1});
    return after_edit(commented, remove_objects(scene_of(commented), ids));
  };
  EXPECT_EQ(without({0}), with(commented, "  [1, 0, 0],  # first\n", ""));
  EXPECT_EQ(without({1}), with(commented, "  [2, 0, 0],\n", ""));
  EXPECT_EQ(without({3}), with(commented, "[3, 0, 0],\n  [4, 0, 0]   # last\n", "[3, 0, 0]\n"));
  EXPECT_EQ(without({2, 3}), with(commented, ",\n  # the third\n  [3, 0, 0],\n  [4, 0, 0]   # last\n", "\n"));
  EXPECT_EQ(without({2}), with(commented, "  # the third\n  [3, 0, 0],\n", ""));
  EXPECT_EQ(without({0, 1, 2, 3}), with(commented, R"(# four points
[[target]]
positions = [
  [1, 0, 0],  # first
  [2, 0, 0],
  # the third
  [3, 0, 0],
  [4, 0, 0]   # last
]
rcs = "3 m2"

)",
                                        ""));
}

TEST(SpliceFormat2, RemovesRowsOfOneLine) {
  const std::string text = "format = \"sarsim 2\"\n[[target]]\npositions = [[1, 0, 0], [2, 0, 0], [3, 0, 0]]\n";
  const auto without = [&](std::size_t row) {
    return after_edit(text, remove_objects(scene_of(text), {{ObjectKind::target, row}}));
  };
  EXPECT_EQ(without(0), with(text, "[1, 0, 0], ", ""));
  EXPECT_EQ(without(1), with(text, "[2, 0, 0], ", ""));
  EXPECT_EQ(without(2), with(text, ", [3, 0, 0]", ""));
}

TEST(SpliceFormat2, SplitsAListOfPositions) {
  const auto larger = [](Target& t) { t.rcs_m2 = 4.0; };
  const std::string list = R"([[target]]
positions = [
  [1, 0, 0],  # first
  [2, 0, 0],
  # the third
  [3, 0, 0],
  [4, 0, 0]   # last
]
rcs = "3 m2"
)";
  EXPECT_EQ(after_target(commented, 2, larger), with(commented, list, R"([[target]]
positions = [
  [1, 0, 0]  # first
]
rcs = "3 m2"

[[target]]
position = [2, 0, 0]
rcs = "4 m2"

[[target]]
positions = [
  # the third
  [3, 0, 0],
  [4, 0, 0]   # last
]
rcs = "3 m2"
)"));
  EXPECT_EQ(after_target(commented, 1, larger), with(commented, "# four points\n" + list, R"([[target]]
position = [1, 0, 0]
rcs = "4 m2"

# four points
[[target]]
positions = [
  [2, 0, 0],
  # the third
  [3, 0, 0],
  [4, 0, 0]   # last
]
rcs = "3 m2"
)"));
}

TEST(SpliceFormat2, SplitsALongListIntoManyParts) {
  Scene scene;
  scene.platforms.resize(1);
  scene.platforms[0].name = "Ship";
  for (int i = 0; i < 10000; ++i) scene.targets.push_back(target_at({1.0 * i, 0.0, 0.0}));
  const std::string text = write_format_2(scene);
  std::vector<ObjectId> every_other;
  for (std::size_t i = 0; i < 10000; i += 2) every_other.push_back({ObjectKind::target, i});
  const std::string after = after_edit(text, carry_objects(scene, every_other, "Ship"));
  EXPECT_NE(after.find("\n\n[[target]]\nposition = [9999, 0, 0]\n"), std::string::npos);
}

TEST(SpliceFormat2, ChangesAListAsAWholeWhereAllOfItChanges) {
  const std::string text = with(commented, "rcs = \"3 m2\"\n", "rcs = \"3 m2\"\nplatform = \"Ship\" # all\n");
  EXPECT_EQ(after_edit(text, rename_object(scene_of(text), {ObjectKind::platform, 0}, "Boat")),
            with(with(with(text, "\"Ship\"", "\"Boat\""), "\"Ship\"", "\"Boat\""), "\"Ship\"", "\"Boat\""));
}

TEST(SpliceFormat2, PutsANewObjectBehindTheLastOfItsKind) {
  EXPECT_EQ(after_edit(commented, add_object(scene_of(commented), target_at({7, 8, 9}))),
            with(commented, "rcs = \"3 m2\"\n", "rcs = \"3 m2\"\n\n[[target]]\nposition = [7, 8, 9]\n"));
  std::vector<Target> many(2);
  many[1].position_m = {1, 2, 3};
  EXPECT_EQ(after_edit(commented, add_targets(scene_of(commented), many)),
            with(commented, "rcs = \"3 m2\"\n",
                 "rcs = \"3 m2\"\n\n[[target]]\npositions = [\n  [0, 0, 0],\n  [1, 2, 3]\n]\n"));
  const std::string with_surface = after_edit(commented, add_object(scene_of(commented), Surface{}));
  EXPECT_EQ(with_surface, with(commented, "[options]", "[[surface]]\n\n[options]"));
  const std::string bare = "format = \"sarsim 2\"";
  EXPECT_EQ(after_edit(bare, add_object(scene_of(bare), Surface{})), bare + "\n\n[[surface]]\n");
}

TEST(SpliceFormat2, RemovesAnObjectWithTheCommentAboveIt) {
  EXPECT_EQ(after_edit(commented, remove_objects(scene_of(commented), {{ObjectKind::target, 0}})),
            with(commented,
                 "# the lone one\n[[target]]\nplatform = \"Ship\"\nposition = [\"2 * 5 m\", 20, 0]  # surveyed in "
                 "May\nrcs = \"2 m2\"  # a small one\n\n",
                 ""));
}

TEST(SpliceFormat2, ChangesAddsAndRemovesTheAtmosphere) {
  const std::string text(commented);
  Atmosphere air;
  air.rain_mm_per_h = 20.0;
  const std::string rainy = after_edit(text, change_atmosphere(scene_of(text), air));
  EXPECT_EQ(rainy, text + "\n[atmosphere]\nrain = { rate = 20 }\n");
  const std::string said = with(rainy, "rain = { rate = 20 }", "rain = { rate = 20 }  # a shower");
  air.gases = true;
  EXPECT_EQ(after_edit(said, change_atmosphere(scene_of(said), air)), said + "gases = true\n");
  EXPECT_EQ(after_edit(said, change_atmosphere(scene_of(said), Atmosphere{})), text + "\n");
}

TEST(SpliceFormat2, ChangesAddsAndRemovesOptions) {
  RunOptions options = scene_of(commented).options;
  options.seed = 8;
  EXPECT_EQ(after_edit(commented, change_options(scene_of(commented), options)), with(commented, "= 7", "= 8"));
  options.tolerance = 0.5;
  EXPECT_EQ(after_edit(commented, change_options(scene_of(commented), options)),
            with(commented, "seed = 7  # lucky\n", "seed = 8  # lucky\ntolerance = 0.5\n"));
  const std::string none = after_edit(commented, change_options(scene_of(commented), RunOptions{}));
  EXPECT_EQ(none, with(commented, "[options]\nseed = 7  # lucky\n", ""));
  options.tolerance = 1e-6;
  EXPECT_EQ(after_edit(none, change_options(scene_of(none), options)), none + "[options]\nseed = 8\n");
}

TEST(SpliceFormat2, KeepsCarriageReturns) {
  std::string text;
  for (const char c : std::string_view(commented)) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const auto right_ends = [&](const std::string& after) {
    EXPECT_EQ(std::ranges::count(after, '\n'), std::ranges::count(after, '\r'));
    std::string plain = after;
    std::erase(plain, '\r');
    return plain;
  };
  const auto larger = [](Target& t) { t.rcs_m2 = 4.0; };
  EXPECT_EQ(right_ends(after_target(text, 2, larger)), after_target(commented, 2, larger));
  EXPECT_EQ(right_ends(after_edit(text, add_object(scene_of(text), Surface{}))),
            after_edit(commented, add_object(scene_of(commented), Surface{})));
  const auto to_fixed = [](Radar& r) {
    r.beam = Radar::Beam::fixed;
    r.beam_rate = r.beam_elevation = {};
  };
  EXPECT_EQ(right_ends(after_radar(text, to_fixed)), after_radar(commented, to_fixed));
}

TEST(SpliceFormat2, KnowsIncludedObjects) {
  const std::string text = "format = \"sarsim 2\"\ninclude = [\"ground.toml\"]\n\n[[target]]\nrcs = \"2 m2\" # own\n";
  const DataFileLoader loader = [](const std::string& name) {
    return DataFileText{name, "format = \"sarsim 2\"\n[[target]]\nrcs = \"5 m2\"\n", ""};
  };
  const Scene scene = read_format_2(text, "", loader).scene;
  ASSERT_EQ(scene.targets.size(), 2U);
  const auto changed = [&](std::size_t index) {
    Target target = scene.targets[index];
    target.rcs_m2 = 3.0;
    const Edit edit = replace_object(scene, {ObjectKind::target, index}, target, "");
    Scene expected = scene;
    apply(edit, expected);
    const std::string after = splice_format_2(text, format_2::find_tables(text), {}, scene, edit, "", loader).text;
    EXPECT_TRUE(read_format_2(after, "", loader).scene == expected) << after;
    return after;
  };
  EXPECT_EQ(changed(1), with(text, "2 m2", "3 m2"));
  EXPECT_EQ(changed(0).find("include"), std::string::npos);  // written anew
}

TEST(SpliceFormat2, StaysInPlaceWhereAnObjectCannotBeSaid) {
  const Scene scene = scene_of(commented);
  Target target = scene.targets[0];
  target.position_m.x = std::numeric_limits<double>::quiet_NaN();
  const Edit edit = replace_object(scene, {ObjectKind::target, 0}, target, "");
  EXPECT_EQ(splice_format_2(commented, format_2::find_tables(commented), {}, scene, edit, "", {}).text,
            with(commented, "\"2 * 5 m\"", "nan"));
}

TEST(FindObjects, FindsTablesAndRows) {
  const std::string text = commented;
  const CommandPlaces places = find_objects(text, format_2::find_tables(text));
  EXPECT_TRUE(places.fits(scene_of(text)));
  const auto piece = [&](TextStretch at) { return text.substr(at.begin, at.end - at.begin); };
  EXPECT_EQ(piece(places[ObjectKind::target][2]), "[2, 0, 0]");
  EXPECT_TRUE(piece(places[ObjectKind::radar][0]).starts_with("[[radar]]\nname"));
  EXPECT_TRUE(piece(places[ObjectKind::radar][0]).ends_with("\"-2 deg\"\n"));
  EXPECT_EQ(piece(places.of[CommandPlaces::options].at(0)), "[options]\nseed = 7  # lucky\n");
}

// A written scene with comments wherever they may stand.
std::string sprinkled(const Scene& scene, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::string text;
  const std::string written = write_format_2(scene);
  for (std::size_t at = 0; at < written.size();) {
    const std::size_t end = written.find('\n', at);
    const std::string line = written.substr(at, end - at);
    if (engine() % 6 == 0) text += "# above " + std::to_string(at) + "\n";
    text += line + (engine() % 4 == 0 ? "  # beside " + std::to_string(at) : "") + "\n";
    if (engine() % 12 == 0) text += "\n# alone\n\n";
    at = end + 1;
  }
  return text;
}

// Everything before and behind a single object that was changed in its table or row is as it was.
void expect_rest_unchanged(const Document& document, const Edit& edit, const std::string& before,
                           const CommandPlaces& places) {
  if (edit.changes.size() != 1 || !edit.changes[0].before || !edit.changes[0].after || edit.options_after) return;
  const ObjectId id = edit.changes[0].id;
  if (id.kind == ObjectKind::target && edit.label != "nudge") return;  // it may get a table of its own
  const TextStretch was = places[id.kind][id.index];
  ASSERT_EQ(document.commands()[id.kind][id.index].begin, was.begin);
  ASSERT_EQ(document.text().substr(0, was.begin), before.substr(0, was.begin));
  ASSERT_TRUE(document.text().ends_with(before.substr(was.end)));
}

void edit_and_undo(Document document, std::uint64_t seed, int count) {
  const std::string first_text = document.text();
  const Scene first_scene = document.scene();
  test::RandomEdits edits(seed);
  for (int i = 0; i < count && !testing::Test::HasFatalFailure(); ++i) {
    const std::string before = document.text();
    const CommandPlaces places = document.commands();
    const Edit edit = edits.edit(document.scene());
    document.perform(edit);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", edit " << i << ": " << edit.label << "\n--- before\n"
                                    << before << "\n--- after\n"
                                    << document.text());
    ASSERT_TRUE(read_format_2(document.text(), "", {}).scene == document.scene());
    ASSERT_TRUE(document.commands().fits(document.scene()));
    ASSERT_EQ(document.commands(), find_objects(document.text(), format_2::find_tables(document.text())));
    expect_rest_unchanged(document, edit, before, places);
    ASSERT_EQ(document.text().find("# alone") == std::string::npos, before.find("# alone") == std::string::npos);
  }
  const std::string last_text = document.text();
  while (document.history().can_undo()) document.undo();
  EXPECT_EQ(document.text(), first_text);
  EXPECT_TRUE(document.scene() == first_scene);
  while (document.history().can_redo()) document.redo();
  EXPECT_EQ(document.text(), last_text);
}

// A scene that format 2 can say, with a list of positions in some.
Scene sayable_scene(std::uint64_t seed) {
  Scene scene = test::RandomScenes(seed).scene();
  for_each_kind([&](const auto& kind) {
    for (auto& object : scene.*kind.list) {
      AnyObject any = object;
      make_names_sayable(any, Language::format_2);
      object = std::get<std::remove_cvref_t<decltype(object)>>(any);
    }
  });
  for (std::uint64_t i = seed % 4; i > 0 && !scene.targets.empty(); --i) {
    scene.targets.push_back(scene.targets[0]);
    scene.targets.back().position_m.z += static_cast<double>(i);
  }
  return scene;
}

TEST(SpliceFormat2Property, TextAndSceneAgreeThroughRandomEdits) {
  for (std::uint64_t seed = 1; seed <= 60 && !HasFatalFailure(); ++seed) {
    const Scene scene = sayable_scene(seed);
    const Document document = Document::from_text(sprinkled(scene, seed));
    ASSERT_TRUE(document.scene() == scene) << document.text();
    edit_and_undo(document, seed, 25);
  }
}

TEST(SpliceFormat2Property, TextAndSceneAgreeThroughRandomEditsOfTypedTexts) {
  const std::string cramped =
      "format = \"sarsim 2\" # "
      "alone\n[[platform]]\nname='A'\nposition=[1,2,3]\n[[target]]\npositions=[[1,2,3],[4,5,6,],"
      "[7,8,9],]\n[[target]]\nplatform='A'\n[[radar]]\npulse.type='chirp'\npulse.bandwidth=5e6\nname=\"R\"\n"
      "[radar.antenna.azimuth]\npoints=[[0,1]]\n[radar.antenna]\ntype='points'\n[options]\nseed=3\n[[recording]]";
  std::string cr_lf = "# alone\r\n";
  for (const char c : std::string_view(commented)) cr_lf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::uint64_t seed = 99;
  for (const std::string& text : {std::string(commented), cramped, cr_lf, "\xEF\xBB\xBF" + std::string(commented)})
    for (int i = 0; i < 8 && !HasFatalFailure(); ++i) edit_and_undo(Document::from_text(text), ++seed, 40);
}

TEST(SpliceFormat2Property, CommentsStayWhereOneObjectChanges) {
  for (std::uint64_t seed = 1; seed <= 40 && !HasFatalFailure(); ++seed) {
    test::RandomEdits edits(seed);
    const std::string text = commented;
    const Scene scene = scene_of(text);
    const ObjectId id{ObjectKind::radar, 0};
    Radar radar = std::get<Radar>(edits.random_object(ObjectKind::radar));
    radar.name = "R";
    radar.platform = "Earth";
    const std::string after = after_edit(text, replace_object(scene, id, radar, ""));
    const CommandPlaces was = find_objects(text, format_2::find_tables(text));
    const CommandPlaces is = find_objects(after, format_2::find_tables(after));
    ASSERT_EQ(after.substr(0, is[id.kind][0].begin), text.substr(0, was[id.kind][0].begin));
    ASSERT_EQ(after.substr(is[id.kind][0].end), text.substr(was[id.kind][0].end));
  }
}

TEST(DocumentFormat2, FollowsTypedTextInEitherLanguage) {
  Document document = Document::from_text(commented);
  document.type_text(with(commented, "rcs = \"2 m2\"", "rcs = \"4 m2\""));
  EXPECT_EQ(document.scene().targets[0].rcs_m2, 4.0);
  document.type_text(with(commented, "rcs = \"2 m2\"", "rcs = \"4 m"));
  EXPECT_TRUE(document.text_broken());
  EXPECT_EQ(document.scene().targets[0].rcs_m2, 4.0);
  EXPECT_EQ(document.commands()[ObjectKind::target].size(), 5U);
  document.perform(remove_objects(document.scene(), {{ObjectKind::target, 0}}));
  EXPECT_FALSE(document.text_broken());
  EXPECT_NE(document.text().find("# once a second"), std::string::npos);
  document.undo();
  EXPECT_TRUE(document.text_broken());
  document.perform(remove_objects(document.scene(), {{ObjectKind::target, 0}}));  // what was sound is not known
  EXPECT_TRUE(document.text().starts_with("# Radar scene"));
  document.type_text("$TARGET Earth 1 2 3 0 0 0 1 0 ISO\n");
  EXPECT_EQ(document.scene().targets.size(), 1U);
  EXPECT_EQ(document.commands()[ObjectKind::target].size(), 1U);
  while (document.history().can_undo()) document.undo();
  EXPECT_EQ(document.text(), commented);
}

TEST(DocumentFormat2, MakesOneStepOfADrag) {
  Document document = Document::from_text(commented);
  for (int i = 1; i <= 20; ++i) {
    Target target = document.scene().targets[3];
    target.position_m.y = i;
    document.perform(replace_object(document.scene(), {ObjectKind::target, 3}, target, "Move target", "drag"));
  }
  document.end_run();
  EXPECT_EQ(document.text(), with(commented, "[3, 0, 0]", "[3, 20, 0]"));
  document.undo();
  EXPECT_EQ(document.text(), commented);
  EXPECT_FALSE(document.history().can_undo());
}

TEST(DocumentFormat2, NamesHoldNoTabs) {
  Document document = Document::from_text(commented);
  document.perform(rename_object(document.scene(), {ObjectKind::platform, 0}, "My\tship"));
  EXPECT_EQ(document.scene().platforms[0].name, "My_ship");
  EXPECT_EQ(document.scene().targets[0].platform, "My_ship");
  EXPECT_TRUE(scene_of(document.text()) == document.scene());
}

TEST(DocumentFormat2, DragsOneOfTenThousandTargets) {
  for (const bool alike : {true, false}) {
    Scene scene;
    for (int i = 0; i < 10000; ++i)
      scene.targets.push_back(target_at({i * 1.25, -i * 2.5, 3.0}, alike ? 2.0 : 2.0 + i));
    Document document = Document::from_text(write_format_2(scene));
    const sarsim::test::ProcessorTime time;
    constexpr int steps = 20;
    for (int i = 1; i <= steps; ++i) {
      Target target = document.scene().targets[5000];
      target.position_m.y = i;
      document.perform(replace_object(document.scene(), {ObjectKind::target, 5000}, target, "Move target", "drag"));
    }
    const double step_ms = 1e3 * time.seconds() / steps;
    RecordProperty(alike ? "list_ms" : "tables_ms", std::to_string(step_ms));
    EXPECT_LT(step_ms, 300.0);  // some 30
  }
}

}  // namespace splice_format_2_test
}  // namespace sarsim::scene

#include "scene/edit/splice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "scene/edit/document.hpp"
#include "scene/edit/edit_test_support.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"
#include "support/folders.hpp"

namespace sarsim::scene {
namespace splice_test {

namespace fs = std::filesystem;

constexpr const char* commented = R"(! A scene for tests.
! It has comments everywhere.

! The ground
$PLATFORM Earth
STATIONARY                ! stays
0, 0, 0                   ! (m) where
CONST
0 0 0  ! turned so
0 0 0  ! turning so
STDDEV
0 0 0
STDDEV
0 0 0

! -- three reflectors --

! the left one
$TARGET Earth
10, 20, 0                 ! (m) surveyed in May
0, 0, 0
1, 0                      ! (m2) a small one
ISOTROPIC

! the right one
$TARGET Earth
-10, 20, 0                ! (m) guessed
0, 0, 0
! between the lines
2, 0
ISOTROPIC

! the last one
$TARGET Earth  5 5 5  0 0 0  3 0  ISO
! the end
)";

std::string with(std::string text, std::string_view old_part, std::string_view new_part) {
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return at == std::string::npos ? text : text.replace(at, old_part.size(), new_part);
}

Edit move_target(const Scene& scene, std::size_t index, core::Vec3 to) {
  Target target = scene.targets.at(index);
  target.position_m = to;
  return replace_object(scene, {ObjectKind::target, index}, target, "Move target");
}

std::string after_edit(const std::string& text, const Edit& edit) {
  return splice(text, find_commands(text), edit, {}).text;
}

Scene scene_of(const std::string& text) { return read_script(text, "", {}).scene; }

TEST(Splice, ReplacesOnlyTheValuesThatDiffer) {
  const std::string text = commented;
  EXPECT_EQ(after_edit(text, move_target(scene_of(text), 0, {12.5, 20.0, 0.0})),
            with(text, "10, 20, 0                 ! (m) surveyed", "12.5, 20, 0               ! (m) surveyed"));
}

TEST(Splice, KeepsOneLineCommandsOnTheirLine) {
  const std::string text = commented;
  EXPECT_EQ(after_edit(text, move_target(scene_of(text), 2, {5.0, 5.0, -7.25})),
            with(text, "5 5 5  0 0 0", "5 5 -7.25  0 0 0"));
}

TEST(Splice, ReplacesTheLinesOfAChoiceAndLeavesTheOthers) {
  const std::string text = commented;
  const Scene scene = scene_of(text);
  Target target = scene.targets[1];
  target.traits.edit().reflectivity = Target::Reflectivity::directional;
  target.traits.edit().azimuth = core::Angle::from_deg(30.0);
  const std::string after = after_edit(text, replace_object(scene, {ObjectKind::target, 1}, target, "Change target"));
  EXPECT_NE(after.find("-10, 20, 0                ! (m) guessed\n0, 0, 0\n! between the lines\n2, 0\nDIRECTIONAL"),
            std::string::npos)
      << after;
  Scene expected = scene;
  expected.targets[1] = target;
  EXPECT_TRUE(scene_of(after) == expected);
}

TEST(Splice, ExplainsAChangedKeywordAnew) {
  std::string text =
      write_script(scene_of("$RADAR R Earth MONO 5 RECT CONST 1 SINGLE 1 1 0 0 ISO SAME FIXED 0 0 RECT NO"));
  const Scene scene = scene_of(text);
  Radar radar = scene.radars.at(0);
  radar.window = Radar::Window::hamming;
  Scene expected = scene;
  expected.radars[0] = radar;
  EXPECT_EQ(after_edit(text, replace_object(scene, {ObjectKind::radar, 0}, radar, "")), write_script(expected));
}

TEST(Splice, RemovesAnObjectWithTheCommentAboveIt) {
  const std::string text = commented;
  const std::string after = after_edit(text, remove_objects(scene_of(text), {{ObjectKind::target, 1}}));
  EXPECT_EQ(after.find("the right one"), std::string::npos);
  EXPECT_EQ(after.find("guessed"), std::string::npos);
  EXPECT_NE(after.find("ISOTROPIC\n\n! the last one\n$TARGET"), std::string::npos) << after;
  EXPECT_NE(after.find("-- three reflectors --"), std::string::npos);
}

TEST(Splice, KeepsTheCommentsThatBeginTheText) {
  const std::string text = "! About all of it\n$TARGET Earth 0 0 0 0 0 0 1 0 ISO\n$TARGET E 1 0 0 0 0 0 1 0 ISO\n";
  EXPECT_EQ(after_edit(text, remove_objects(scene_of(text), {{ObjectKind::target, 0}})),
            "! About all of it\n$TARGET E 1 0 0 0 0 0 1 0 ISO\n");
}

TEST(Splice, PutsANewObjectBehindTheLastOfItsKind) {
  const std::string text = commented;
  Target target;
  target.position_m = {1.0, 2.0, 3.0};
  const std::string after = after_edit(text, add_object(scene_of(text), target));
  const std::size_t at = after.find("1, 2, 3");
  EXPECT_GT(at, after.find("3 0  ISO"));
  EXPECT_LT(at, after.find("! the end"));
  EXPECT_EQ(scene_of(after).targets.size(), 4U);
}

TEST(Splice, BeginsAListWhereTheWriterWould) {
  const std::string text = commented;
  const std::string after = after_edit(text, add_object(scene_of(text), Surface{}));
  EXPECT_LT(after.find("$SURFACE"), after.find("-- three reflectors --"));
  EXPECT_GT(after.find("$SURFACE"), after.find("turning so"));
  const std::string with_radar = after_edit(text, add_object(scene_of(text), Radar{}));
  EXPECT_GT(with_radar.find("$RADAR"), with_radar.find("3 0  ISO"));
}

TEST(Splice, WritesIntoAnEmptyText) {
  for (const std::string text : {"", "\n", "! only a comment", "! a comment\r\n"}) {
    const std::string after = after_edit(text, add_object(Scene{}, Target{}));
    EXPECT_TRUE(after.starts_with(text)) << after;
    EXPECT_EQ(scene_of(after).targets.size(), 1U) << after;
  }
}

TEST(Splice, KeepsCarriageReturns) {
  std::string text;
  for (const char c : std::string_view(commented)) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const Scene scene = scene_of(text);
  Radar radar;
  std::string after = after_edit(text, add_object(scene, radar));
  EXPECT_EQ(std::ranges::count(after, '\n'), std::ranges::count(after, '\r'));
  Scene expected = scene;
  expected.radars.push_back(radar);
  EXPECT_TRUE(scene_of(after) == expected);
  EXPECT_EQ(after_edit(text, move_target(scene, 0, {12.5, 20.0, 0.0})),
            with(text, "10, 20, 0                 !", "12.5, 20, 0               !"));
}

TEST(Splice, WritesBeforeTheEndOfFileMark) {
  const std::string text = "$TARGET Earth 0 0 0 0 0 0 1 0 ISO\r\n\x1A";
  const std::string after = after_edit(text, add_object(scene_of(text), Target{}));
  EXPECT_EQ(after.back(), '\x1A');
  EXPECT_EQ(scene_of(after).targets.size(), 2U);
  EXPECT_FALSE(core::has_errors(read_script(after, "", {}).problems));
}

TEST(Splice, ManagesSeveralCommandsOnALine) {
  const std::string text = "$TARGET A 0 0 0 0 0 0 1 0 ISO $TARGET B 1 0 0 0 0 0 1 0 ISO $TARGET C 2 0 0 0 0 0 1 0 ISO";
  const Scene scene = scene_of(text);
  ASSERT_EQ(scene.targets.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    Scene removed = scene;
    removed.targets.erase(removed.targets.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_TRUE(scene_of(after_edit(text, remove_objects(scene, {{ObjectKind::target, i}}))) == removed) << i;
    Scene inserted = scene;
    inserted.targets.insert(inserted.targets.begin() + static_cast<std::ptrdiff_t>(i), Target{});
    Edit insertion;
    insertion.changes.push_back({{ObjectKind::target, i}, std::nullopt, AnyObject(Target{})});
    EXPECT_TRUE(scene_of(after_edit(text, insertion)) == inserted) << i;
  }
}

TEST(Splice, RewritesAnOlderDialectOnlyWhereItChanges) {
  const std::string old_platform = "$PLATFORM Ship STATIONARY 1 2 3  0 0 0 STDDEV 0 0 0 STDDEV 0 0 0 ! of 1997\n";
  const std::string text = old_platform + "$PLATFORM Buoy STATIONARY 1 2 3  0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n";
  const Scene scene = scene_of(text);
  Platform buoy = scene.platforms.at(1);
  buoy.rotation_rate[2] = core::Angle::from_deg(6.0);
  const std::string after = after_edit(text, replace_object(scene, {ObjectKind::platform, 1}, buoy, ""));
  EXPECT_TRUE(after.starts_with(old_platform));
  EXPECT_TRUE(scene_of(after).platforms.at(1) == buoy);
}

TEST(Splice, MakesOneOfSeveralOptionCommands) {
  const std::string text = "$OPTIONS SEED 5 ! lucky\n$TARGET E 0 0 0 0 0 0 1 0 ISO\n$OPTIONS TOLERANCE 1E-4\n";
  const Scene scene = scene_of(text);
  RunOptions options = scene.options;
  options.seed = 1;
  options.profile = Profile::classic;
  const std::string after = after_edit(text, change_options(scene, options));
  EXPECT_TRUE(scene_of(after).options == options) << after;
  EXPECT_EQ(find_commands(after).of[CommandPlaces::options].size(), 1U);
}

TEST(Splice, AddsChangesAndRemovesOptions) {
  const std::string text = "$TARGET E 0 0 0 0 0 0 1 0 ISO\n! end\n";
  RunOptions options;
  options.seed = 7;
  const std::string added = after_edit(text, change_options(scene_of(text), options));
  EXPECT_EQ(scene_of(added).options.seed, 7U);
  options.seed = 8;
  EXPECT_EQ(after_edit(added, change_options(scene_of(added), options)), with(added, "SEED 7", "SEED 8"));
  const std::string removed = after_edit(added, change_options(scene_of(added), RunOptions{}));
  EXPECT_TRUE(scene_of(removed) == scene_of(text));
  EXPECT_EQ(removed.find("$OPT"), std::string::npos);
}

TEST(Splice, KnowsWhereTheCommandsStandAfterwards) {
  const std::string text = commented;
  const Scene scene = scene_of(text);
  const Splice spliced = splice(text, find_commands(text), duplicate_objects(scene, {{ObjectKind::platform, 0}}), {});
  EXPECT_EQ(spliced.text, apply_changes(text, spliced.changes));
  EXPECT_TRUE(spliced.places == find_commands(spliced.text)) << spliced.text;
  EXPECT_EQ(spliced.places[ObjectKind::target].size(), 6U);
}

TEST(Splice, RefusesAnEditOfAnotherScene) {
  Scene other;
  other.targets.resize(9);
  const std::string text = commented;
  EXPECT_THROW(static_cast<void>(after_edit(text, remove_objects(other, {{ObjectKind::target, 8}}))), std::logic_error);
}

TEST(FindCommands, PassesOverDollarsInCommentsAndWords) {
  const std::string text =
      "! costs 5$\n$TARGET a$b 0 0 0 0 0 0 1 0 ISO ! $RADAR\n$ $ SURFACE \"$TARGET x\" 1 2 3 4 5 6 7 8 9";
  const CommandPlaces places = find_commands(text);
  EXPECT_TRUE(places.fits(scene_of(text)));
  ASSERT_EQ(places[ObjectKind::surface].size(), 1U);
  EXPECT_EQ(places[ObjectKind::surface][0], (TextStretch{text.find("$ $"), text.size()}));
}

std::vector<fs::path> all_scripts() {
  std::vector<fs::path> scripts;
  for (const fs::path& folder : {sarsim::test::source_folder() / "examples", sarsim::test::direct_reference_folder(),
                                 sarsim::test::reference_folder() / "original"}) {
    if (!fs::is_directory(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string ending = entry.path().extension().string();
      if (ending == ".scr" || ending == ".SCR") scripts.push_back(entry.path());
    }
  }
  std::ranges::sort(scripts);
  return scripts;
}

// What must hold after each edit of a document.
void expect_text_says_scene(const Document& document, const fs::path& path) {
  const ScriptReading reading =
      read_script(document.text(), "", disk_loader(path.parent_path()), {.work = {}, .draft = true});
  ASSERT_FALSE(core::has_errors(reading.problems)) << document.text();
  ASSERT_TRUE(reading.scene == document.scene()) << document.text();
  ASSERT_TRUE(document.commands() == find_commands(document.text())) << document.text();
}

// Everything before and behind a single command that an edit replaced is as it was.
void expect_rest_unchanged(const Document& document, const std::string& before, const CommandPlaces& places) {
  const Edit& edit = *document.last_edit()->edit;
  if (edit.changes.size() != 1 || !edit.changes[0].before || !edit.changes[0].after || edit.options_after) return;
  const ObjectId id = edit.changes[0].id;
  const TextStretch was = places[id.kind][id.index];
  const TextStretch is = document.commands()[id.kind][id.index];
  ASSERT_EQ(document.text().substr(0, is.begin), before.substr(0, was.begin));
  ASSERT_EQ(document.text().substr(is.end), before.substr(was.end));
}

void edit_and_undo(Document document, const fs::path& path, std::uint64_t seed, int count) {
  const std::string first_text = document.text();
  const Scene first_scene = document.scene();
  test::RandomEdits edits(seed);
  for (int i = 0; i < count && !testing::Test::HasFatalFailure(); ++i) {
    const std::string before = document.text();
    const CommandPlaces places = document.commands();
    const Edit edit = edits.edit(document.scene());
    SCOPED_TRACE(testing::Message() << path << ", edit " << i << ": " << edit.label << "\n" << before);
    Scene expected = document.scene();
    apply(edit, expected);
    document.perform(edit);
    ASSERT_TRUE(document.scene() == expected);
    expect_text_says_scene(document, path);
    if (document.text() != before) expect_rest_unchanged(document, before, places);
  }
  const std::string last_text = document.text();
  const Scene last_scene = document.scene();
  while (document.history().can_undo()) document.undo();
  EXPECT_EQ(document.text(), first_text) << path;
  EXPECT_TRUE(document.scene() == first_scene) << path;
  while (document.history().can_redo()) document.redo();
  EXPECT_EQ(document.text(), last_text) << path;
  EXPECT_TRUE(document.scene() == last_scene) << path;
}

TEST(SpliceProperty, TextAndSceneAgreeThroughRandomEditsOfEveryScript) {
  constexpr std::uint64_t seed = 4711;
  const std::vector<fs::path> scripts = all_scripts();
  EXPECT_GE(scripts.size(), 6U);
  for (const fs::path& path : scripts) {
    if (HasFatalFailure()) return;
    const Document document = Document::open(path);
    ASSERT_FALSE(core::has_errors(read_script_file(path).problems)) << path;
    edit_and_undo(document, path, seed, 25);
  }
}

TEST(SpliceProperty, TextAndSceneAgreeThroughRandomEditsOfCommentedAndCrampedTexts) {
  const std::string cramped =
      "$PLAT E STAT 0 0 0 0 0 0 STDDEV 0 0 0 STD 0 0 0 $TARGET E 0 0 0 0 0 0 1 0 ISO $TARGET \"E\"1 0 0 0 0 0 1 0 "
      "ISO!x\n"
      "$RADAR R E MONO 5 REC CON 1 SIN 1 1 0 0 ISO SAM FIX 0 0 REC NO $SIM R 0 1 0 1 8 1 0 BIN RAW a BEG";
  std::string cr_lf;
  for (const char c : std::string_view(commented)) cr_lf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::string cr = commented;
  std::ranges::replace(cr, '\n', '\r');
  std::uint64_t seed = 99;
  for (const std::string& text : {std::string(commented), cramped, cr_lf, cr, std::string()})
    for (int i = 0; i < 8 && !HasFatalFailure(); ++i) edit_and_undo(Document::from_text(text), "text", ++seed, 40);
}

}  // namespace splice_test
}  // namespace sarsim::scene

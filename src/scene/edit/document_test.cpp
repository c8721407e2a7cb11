#include "scene/edit/document.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <stdexcept>

#include "scene/edit/edit_test_support.hpp"
#include "scene/edit/text_file.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/script/writer.hpp"
#include "support/processor_time.hpp"

namespace sarsim::scene {
namespace document_test {

namespace fs = std::filesystem;

constexpr const char* small_script = R"(! A test
$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0
! the target
$TARGET Earth 1 2 3  0 0 0  1 0  ISO ! it
)";

ObjectId target(std::size_t index) { return {ObjectKind::target, index}; }

Edit move_to(const Document& document, double x, std::string key = "") {
  Target moved_target = document.scene().targets.at(0);
  moved_target.position_m.x = x;
  return replace_object(document.scene(), target(0), moved_target, "Move target", std::move(key));
}

Scene scene_of(const std::string& text) { return read_script(text, "", {}).scene; }

// A folder of its own for each test, gone afterwards.
class DocumentFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("sarsim-document-test-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name) const { return folder_ / name; }
  static void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  [[nodiscard]] std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

std::string failure_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Document, BeginsWithThePlatformEarthInFormat2) {
  const Document document;
  ASSERT_EQ(document.scene().platforms.size(), 1U);
  EXPECT_EQ(document.scene().platforms[0].name, "Earth");
  EXPECT_TRUE(is_format_2(document.text()));
  EXPECT_TRUE(read_format_2(document.text(), "", {}).scene == document.scene());
  EXPECT_FALSE(document.changed());
  EXPECT_FALSE(document.text_broken());
  EXPECT_TRUE(document.path().empty());
}

TEST(Document, WritesANewSceneInFormat2) {
  Document document;
  const std::string empty = document.text();
  document.perform(add_object(document.scene(), Target()));
  document.perform(add_object(document.scene(), Radar()));
  EXPECT_NE(document.text().find("[[target]]"), std::string::npos) << document.text();
  EXPECT_NE(document.text().find("[[radar]]"), std::string::npos) << document.text();
  EXPECT_TRUE(read_format_2(document.text(), "", {}).scene == document.scene());
  document.undo();
  document.undo();
  EXPECT_EQ(document.text(), empty);
}

TEST(Document, WritesAnEditIntoTheTextAndTakesItBackByteByByte) {
  Document document = Document::from_text(small_script);
  document.perform(move_to(document, 7.5));
  EXPECT_TRUE(scene_of(document.text()) == document.scene());
  EXPECT_NE(document.text().find("! the target\n$TARGET Earth 7.5 2 3"), std::string::npos) << document.text();
  EXPECT_TRUE(document.changed());
  ASSERT_TRUE(document.last_edit());
  EXPECT_TRUE(document.last_edit()->forwards);
  EXPECT_EQ(document.last_edit()->edit->label, "Move target");
  document.undo();
  EXPECT_EQ(document.text(), small_script);
  EXPECT_FALSE(document.changed());
  EXPECT_FALSE(document.last_edit()->forwards);
  document.redo();
  EXPECT_EQ(document.scene().targets[0].position_m.x, 7.5);
}

TEST(Document, CopiesShareTheSceneUntilOneChanges) {
  Document one = Document::from_text(small_script);
  one.perform(move_to(one, 7.5));
  Document other = one;
  EXPECT_EQ(&other.scene(), &one.scene());
  EXPECT_EQ(other.last_edit()->edit, one.last_edit()->edit);
  const std::shared_ptr<const Scene> before = one.shared_scene();
  other.perform(move_to(other, 8.5));
  EXPECT_NE(&other.scene(), &one.scene());
  EXPECT_EQ(other.scene().targets[0].position_m.x, 8.5);
  EXPECT_EQ(one.shared_scene(), before);
  EXPECT_EQ(before->targets[0].position_m.x, 7.5);
  one.undo();
  EXPECT_EQ(before->targets[0].position_m.x, 7.5);
  EXPECT_EQ(one.scene().targets[0].position_m.x, 1.0);
  EXPECT_EQ(one.text(), small_script);
  other.undo();
  EXPECT_TRUE(other.scene() == *before);
  // A comment changes no scene.
  const std::shared_ptr<const Scene> shared = one.shared_scene();
  one.type_text(one.text() + "! a comment\n");
  EXPECT_EQ(one.shared_scene(), shared);
  EXPECT_THROW(Document().undo(), std::logic_error);
  EXPECT_THROW(Document().redo(), std::logic_error);
}

std::vector<std::string> words_of(const core::Problems& problems) {
  std::vector<std::string> words;
  for (const core::Problem& problem : problems) words.push_back(core::to_string(problem));
  return words;
}

TEST(Document, TakesWhatASearchOnAnotherThreadHasFound) {
  Document document = Document::from_text(std::string(small_script) + "$RADAR R Earth 0 0 0 1e9 0 1e-6\n");
  EXPECT_FALSE(document.search());  // known
  document.perform(move_to(document, 5.0));
  const auto search = document.search();
  ASSERT_TRUE(search);
  Document other = document;
  const std::uint64_t revision = document.revision();
  const Document::Findings found = search();
  EXPECT_EQ(words_of(found.problems), words_of(other.problems()));
  EXPECT_FALSE(found.problems.empty());
  document.perform(move_to(document, 6.0));
  document.take(found, revision);  // too late
  EXPECT_TRUE(document.search());
  document.undo();
  document.take(found, document.revision());
  EXPECT_FALSE(document.search());
  EXPECT_EQ(words_of(document.problems()), words_of(other.problems()));
}

TEST(Document, BringsBackTheCommentsOfARemovedObject) {
  Document document = Document::from_text(small_script);
  document.perform(remove_objects(document.scene(), {target(0)}));
  EXPECT_EQ(document.text().find("the target"), std::string::npos);
  document.undo();
  EXPECT_EQ(document.text(), small_script);
}

TEST(Document, MakesOneStepOfADrag) {
  Document document = Document::from_text(small_script);
  for (int i = 1; i <= 50; ++i) document.perform(move_to(document, 10.25 * i, "drag"));
  document.end_run();
  EXPECT_EQ(scene_of(document.text()).targets[0].position_m.x, 512.5);
  document.undo();
  EXPECT_EQ(document.text(), small_script);
  EXPECT_FALSE(document.history().can_undo());
}

TEST(Document, FollowsTypedText) {
  Document document = Document::from_text(small_script);
  std::string text = document.text();
  text.replace(text.find("1 2 3"), 5, "4 5 6");
  document.type_text(text);
  EXPECT_EQ(document.scene().targets[0].position_m, (core::Vec3{4.0, 5.0, 6.0}));
  EXPECT_EQ(document.text(), text);
  EXPECT_EQ(document.last_edit()->edit->changes.size(), 1U);
  document.undo();
  EXPECT_EQ(document.text(), small_script);
  EXPECT_TRUE(document.scene() == scene_of(small_script));
}

TEST(Document, RemembersTypedCommentsToo) {
  Document document = Document::from_text(small_script);
  document.type_text(std::string(small_script) + "! more\n");
  EXPECT_TRUE(document.changed());
  document.undo();
  EXPECT_EQ(document.text(), small_script);
  EXPECT_FALSE(document.changed());
}

TEST(Document, KeepsTheLastSceneWhileTheTextIsBroken) {
  Document document = Document::from_text(small_script);
  const Scene before = document.scene();
  std::string text = document.text();
  text.replace(text.find("ISO"), 3, "ISQ");
  document.type_text(text);
  EXPECT_TRUE(document.text_broken());
  EXPECT_TRUE(document.scene() == before);
  ASSERT_TRUE(core::has_errors(document.problems()));
  EXPECT_EQ(document.problems()[0].place.line, 4U);
  document.type_text(small_script);
  EXPECT_FALSE(document.text_broken());
  EXPECT_FALSE(core::has_errors(document.problems()));
  EXPECT_FALSE(document.changed());  // typed and taken back: nothing has happened
}

TEST(Document, MakesOneStepOfTypingThroughBrokenTexts) {
  Document document = Document::from_text(small_script);
  std::string text = small_script;
  for (const char c : std::string_view("$TARGET Earth 9 9 9 0 0 0 1 0 ISO\n")) document.type_text(text += c);
  EXPECT_FALSE(document.text_broken());
  EXPECT_EQ(document.scene().targets.size(), 2U);
  document.undo();
  EXPECT_EQ(document.text(), small_script);
  EXPECT_EQ(document.scene().targets.size(), 1U);
  EXPECT_FALSE(document.history().can_undo());
  document.redo();
  EXPECT_EQ(document.text(), text);
  EXPECT_EQ(document.scene().targets.size(), 2U);
}

TEST(Document, EditsTheLastReadableTextWhileTheTextIsBroken) {
  Document document = Document::from_text(small_script);
  const std::string broken = std::string(small_script) + "$TARGET Earth 9 9";
  document.type_text(broken);
  ASSERT_TRUE(document.text_broken());
  document.end_run();
  document.perform(move_to(document, 8.0));
  EXPECT_FALSE(document.text_broken());
  EXPECT_TRUE(scene_of(document.text()) == document.scene());
  EXPECT_NE(document.text().find("! the target\n$TARGET Earth 8 2 3"), std::string::npos) << document.text();
  document.undo();
  EXPECT_EQ(document.text(), broken);
  EXPECT_TRUE(document.text_broken());
  EXPECT_TRUE(document.scene() == scene_of(small_script));
  // Now the last readable text is not known any more; the scene is.
  document.perform(move_to(document, 9.0));
  EXPECT_TRUE(scene_of(document.text()) == document.scene());
  document.undo();
  EXPECT_EQ(document.text(), broken);
  document.undo();
  EXPECT_EQ(document.text(), small_script);
  EXPECT_FALSE(document.text_broken());
}

TEST(Document, TakesTypingAndEditsInTurn) {
  Document document = Document::from_text(small_script);
  test::RandomEdits edits(12);
  std::vector<std::string> texts{document.text()};
  for (int i = 0; i < 60; ++i) {
    if (i % 3 == 0) {
      document.type_text(document.text() + "! typed " + std::to_string(i) + "\n$TARGET Earth " + std::to_string(i) +
                         " 0 0 0 0 0 1 0 ISO\n");
    } else {
      document.perform(edits.edit(document.scene()));
    }
    document.end_run();
    ASSERT_TRUE(scene_of(document.text()) == document.scene()) << document.text();
    if (document.text() != texts.back()) texts.push_back(document.text());
  }
  EXPECT_NE(document.text().find("! typed 57"), std::string::npos);
  for (auto text = texts.rbegin() + 1; text != texts.rend(); ++text) {
    document.undo();
    ASSERT_EQ(document.text(), *text);
    ASSERT_TRUE(scene_of(*text) == document.scene());
  }
  EXPECT_FALSE(document.history().can_undo());
}

TEST(Document, LeavesOutOfTheSceneWhatAScriptCannotSay) {
  Document document = Document::from_text(small_script);
  Radar radar;
  radar.bandwidth_hz = 3e6;  // of a chirp; the pulse is monochrome
  radar.name = "a\nb";
  document.perform(add_object(document.scene(), radar));
  EXPECT_EQ(document.scene().radars.at(0).bandwidth_hz, Radar{}.bandwidth_hz);
  EXPECT_EQ(document.scene().radars.at(0).name, "a_b");
  EXPECT_TRUE(scene_of(document.text()) == document.scene());
}

TEST(Document, HoldsFaultyValuesAndSaysWhereTheyAre) {
  Document document = Document::from_text(small_script);
  Target faulty = document.scene().targets[0];
  faulty.traits.edit().rcs_stddev_m2 = -4.0;
  document.perform(replace_object(document.scene(), target(0), faulty, ""));
  EXPECT_TRUE(document.scene().targets[0] == faulty);
  EXPECT_FALSE(document.text_broken());
  ASSERT_TRUE(core::has_errors(document.problems()));
  EXPECT_EQ(document.problems()[0].place.line, 4U);
  faulty.traits.edit().rcs_stddev_m2 = std::numeric_limits<double>::quiet_NaN();
  document.perform(replace_object(document.scene(), target(0), faulty, ""));
  EXPECT_TRUE(core::has_errors(document.problems()));
  faulty.traits.edit().rcs_stddev_m2 = 0.5;
  document.perform(replace_object(document.scene(), target(0), faulty, ""));
  EXPECT_FALSE(core::has_errors(document.problems()));
  EXPECT_TRUE(scene_of(document.text()) == document.scene());
  while (document.history().can_undo()) document.undo();
  EXPECT_EQ(document.text(), small_script);
}

TEST(Document, LocatesTheProblemsOfTheSceneInTheText) {
  Document document = Document::from_text(small_script);
  document.perform(carry_objects(document.scene(), {target(0)}, "Nowhere"));
  ASSERT_FALSE(document.problems().empty());
  const core::Problem& problem = document.problems()[0];
  EXPECT_EQ(problem.severity, core::Severity::error);
  EXPECT_EQ(problem.subject.kind, "target");
  EXPECT_EQ(problem.place.line, 4U);
  EXPECT_EQ(document.places().find({"target", 0, "position_m"}).line, 4U);
}

TEST(Document, RefusesAnEditOfAnotherScene) {
  Document document = Document::from_text(small_script);
  const Edit stale = move_to(document, 5.0);
  document.perform(move_to(document, 6.0));
  const std::string text = document.text();
  EXPECT_THROW(document.perform(stale), std::logic_error);
  EXPECT_THROW(document.perform(remove_objects(
                   [] {
                     Scene other;
                     other.radars.resize(3);
                     return other;
                   }(),
                   {{ObjectKind::radar, 2}})),
               std::logic_error);
  EXPECT_EQ(document.text(), text);
  EXPECT_TRUE(scene_of(text) == document.scene());
}

TEST(Document, UnderstandsWhatItCanOfAFaultyScript) {
  const std::string text = std::string(small_script) + "$TARGT Earth 0 0 0 0 0 0 1 0 ISO ! misspelt\n$WRONG 1 2\n";
  Document document = Document::from_text(text);
  EXPECT_TRUE(core::has_errors(document.problems()));
  EXPECT_EQ(document.text(), text);
  EXPECT_EQ(document.scene().targets.size(), 1U);
  document.perform(move_to(document, 6.0));
  EXPECT_NE(document.text().find("$TARGET Earth 6 2 3"), std::string::npos);
  EXPECT_NE(document.text().find("! misspelt\n$WRONG 1 2\n"), std::string::npos);
}

TEST_F(DocumentFiles, AreOpenedAndSaved) {
  write(file("a.scr"), small_script);
  Document document = Document::open(file("a.scr"));
  EXPECT_EQ(document.text(), small_script);
  EXPECT_EQ(document.path(), file("a.scr"));
  document.perform(move_to(document, 6.0));
  EXPECT_TRUE(document.changed());
  document.save(file("b.scr"));
  EXPECT_EQ(document.path(), file("b.scr"));
  EXPECT_FALSE(document.changed());
  EXPECT_EQ(read_text_file(file("b.scr")), document.text());
  EXPECT_EQ(read_text_file(file("a.scr")), small_script);
  EXPECT_EQ(files_in_folder(), 2U);
  document.undo();
  EXPECT_TRUE(document.changed());
}

TEST_F(DocumentFiles, ThatCannotBeReadGiveAnEmptyDocument) {
  write(file("binary.scr"), std::string("ab\0cd", 5));
  for (const fs::path& path : {file("none.scr"), folder_, file("binary.scr")}) {
    const Document document = Document::open(path);
    EXPECT_TRUE(core::has_errors(document.problems())) << path;
    EXPECT_EQ(document.problems()[0].place.file, path.string());
    EXPECT_TRUE(document.path().empty());
    EXPECT_TRUE(document.scene() == Document().scene());
  }
}

TEST_F(DocumentFiles, ThatChangedOnDiskAreNoticed) {
  write(file("a.scr"), small_script);
  Document document = Document::open(file("a.scr"));
  EXPECT_FALSE(document.changed_on_disk());
  write(file("a.scr"), std::string(small_script) + " ");
  EXPECT_TRUE(document.changed_on_disk());
  document.save(file("a.scr"));
  EXPECT_FALSE(document.changed_on_disk());
  fs::remove(file("a.scr"));
  EXPECT_TRUE(document.changed_on_disk());
  EXPECT_FALSE(Document().changed_on_disk());
}

TEST_F(DocumentFiles, KeepTheirPermissionsAndLinks) {
  write(file("a.scr"), "old");
  fs::permissions(file("a.scr"), fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink("a.scr", file("link.scr"));
  Document document = Document::from_text(small_script);
  document.save(file("link.scr"));
  EXPECT_TRUE(fs::is_symlink(file("link.scr")));
  EXPECT_EQ(read_text_file(file("a.scr")), small_script);
  EXPECT_EQ(fs::status(file("a.scr")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST_F(DocumentFiles, ThatCannotBeWrittenAreLeftAlone) {
  Document document = Document::from_text(small_script);
  document.perform(move_to(document, 6.0));
  const fs::path nowhere = file("none/a.scr");
  EXPECT_EQ(failure_of([&] { document.save(nowhere); }),
            "cannot write " + nowhere.string() + ": No such file or directory");
  EXPECT_EQ(failure_of([&] { document.save(folder_); }), "cannot write " + folder_.string() + ": Is a directory");
  EXPECT_TRUE(document.path().empty());
  EXPECT_TRUE(document.changed());
  EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(DocumentFiles, OnAFullDiskGiveAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  Document document = Document::from_text(small_script);
  EXPECT_EQ(failure_of([&] { document.save("/dev/full"); }), "cannot write /dev/full: No space left on device");
}

TEST_F(DocumentFiles, InAReadOnlyFolderGiveAnError) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  write(file("a.scr"), "old");
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  Document document = Document::from_text(small_script);
  EXPECT_NE(failure_of([&] { document.save(file("a.scr")); }), "");
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_EQ(read_text_file(file("a.scr")), "old");
}

std::string directional_script(const std::string& data) {
  return "$TARGET Earth 1 2 3 0 0 0 1 0 DIRECTIONAL 0 0 0 0 OTHER_GAIN LINEAR FILE " + data + "\n";
}

TEST_F(DocumentFiles, OfFunctionsKeepTheirNamesWhenTheFunctionIsEdited) {
  write(file("gain.dat"), "2\n0 0\n90 -10\n");
  write(file("a.scr"), directional_script("gain.dat"));
  Document document = Document::open(file("a.scr"));
  ASSERT_FALSE(core::has_errors(document.problems()));
  const Scene before = document.scene();
  Target edited = before.targets.at(0);
  edited.traits.edit().gain_db.part[0].knots[1].y = -20.0;
  document.perform(replace_object(before, target(0), edited, "Change function"));
  EXPECT_EQ(document.text(), directional_script("gain.dat"));
  EXPECT_EQ(document.scene().targets[0].traits->gain_db.part[0].knots[1].y, -20.0);
  ASSERT_EQ(document.pending_data().count("gain.dat"), 1U);
  // Typing reads the text again but must not read the old points.
  document.type_text(document.text() + "! typed\n");
  EXPECT_EQ(document.scene().targets[0].traits->gain_db.part[0].knots[1].y, -20.0);
  document.end_run();
  // Once the data are written, what stands on disk counts.
  write(file("gain.dat"), document.pending_data().at("gain.dat"));
  document.type_text(document.text() + "! again\n");
  EXPECT_TRUE(document.pending_data().empty());
  EXPECT_EQ(document.scene().targets[0].traits->gain_db.part[0].knots[1].y, -20.0);
  while (document.history().can_undo()) document.undo();
  EXPECT_TRUE(document.scene() == before);
  EXPECT_EQ(document.text(), directional_script("gain.dat"));
  EXPECT_EQ(document.pending_data().count("gain.dat"), 1U);  // the points before have to be written again
}

TEST_F(DocumentFiles, OfFunctionsThatAreMissingAreAProblem) {
  write(file("a.scr"), directional_script("none.dat"));
  const Document document = Document::open(file("a.scr"));
  ASSERT_TRUE(core::has_errors(document.problems()));
  EXPECT_EQ(document.text(), directional_script("none.dat"));
  EXPECT_EQ(document.path(), file("a.scr"));
}

TEST(DocumentSpeed, AnEditOfALargeSceneDoesNotReadItAll) {
  Scene scene;
  scene.targets.resize(10'000);
  for (std::size_t i = 0; i < scene.targets.size(); ++i) scene.targets[i].position_m.x = static_cast<double>(i);
  Document document = Document::from_text(write_script(scene));
  constexpr int moves = 50;
  const sarsim::test::ProcessorTime time;
  for (int i = 1; i <= moves; ++i) {
    Target moved_target = document.scene().targets[5000];
    moved_target.position_m.y = i;
    document.perform(replace_object(document.scene(), target(5000), moved_target, "Move target", "drag"));
  }
  const double seconds = time.seconds() / moves;
  RecordProperty("milliseconds_per_edit", std::to_string(1e3 * seconds));
  // Some ten times what an optimised build takes; reading the text takes longer than that.
  EXPECT_LT(seconds, 0.05);
  EXPECT_EQ(document.scene().targets[5000].position_m.y, moves);
  EXPECT_TRUE(scene_of(document.text()) == document.scene());
}

}  // namespace document_test
}  // namespace sarsim::scene

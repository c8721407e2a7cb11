#include "scene/edit/included_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "scene/edit/document.hpp"
#include "scene/edit/document_data.hpp"
#include "scene/edit/text_file.hpp"
#include "scene/language/scene_reader.hpp"

namespace sarsim::scene {
namespace included_texts_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string ground = R"(# The ground.
format = "sarsim 2"
[[target]]
position = [1, 0, 0]   # the first
[[target]]
positions = [[2, 0, 0],
             [3, 0, 0]]  # two more
rcs = "far / 1 km * 1 m2"
)";

const std::string more = R"(format = "sarsim 2"
[[target]]
position = [4, 0, 0]
[[platform]]
name = "Plane"
)";

const std::string whole = R"(format = "sarsim 2"
include = ["ground.toml", "more.toml"]
[let]
far = "2 km"
# The own one.
[[target]]
position = ["far", 0, 0]
)";

/// A document whose scene stands in three files.
class IncludedTexts : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("sarsim-included-test-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write("ground.toml", ground);
    write("more.toml", more);
    write("scene.toml", whole);
    document_ = Document::open(folder_ / "scene.toml");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  void move_target(std::size_t index, double x) {
    Target target = document_.scene().targets.at(index);
    target.position_m.x = x;
    document_.perform(replace_object(document_.scene(), {ObjectKind::target, index}, target, "Move target"));
  }

  [[nodiscard]] std::string pending(const std::string& name) const {
    const auto found = document_.pending_data().find(name);
    return found == document_.pending_data().end() ? "" : found->second;
  }

  // The scene that its files say, after they are written.
  [[nodiscard]] Scene saved() {
    write_data(data_to_write(document_, folder_ / "scene.toml"));
    document_.save(folder_ / "scene.toml");
    return read_scene_file(folder_ / "scene.toml").scene;
  }

  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  }

  fs::path folder_;
  Document document_;
};

TEST_F(IncludedTexts, AnObjectIsChangedInTheFileWhereItStands) {
  ASSERT_THAT(document_.scene().targets, testing::SizeIs(5));
  move_target(0, 10.0);
  move_target(2, 30.0);
  EXPECT_EQ(pending("ground.toml"), replaced(replaced(ground, "[1, 0, 0]", "[10, 0, 0]"), "[3, 0, 0]", "[30, 0, 0]"));
  EXPECT_EQ(pending("more.toml"), "");
  EXPECT_EQ(document_.text(), whole);
  EXPECT_EQ(saved(), document_.scene());
  EXPECT_EQ(read_text_file(folder_ / "ground.toml"),
            replaced(replaced(ground, "[1, 0, 0]", "[10, 0, 0]"), "[3, 0, 0]", "[30, 0, 0]"));
  EXPECT_THAT(data_to_write(document_, folder_ / "scene.toml"), IsEmpty());
}

TEST_F(IncludedTexts, UndoTakesItBackInThatFile) {
  move_target(0, 10.0);
  move_target(4, 50.0);
  document_.undo();
  EXPECT_EQ(document_.text(), whole);
  document_.undo();
  EXPECT_EQ(saved().targets.at(0).position_m.x, 1.0);
  EXPECT_EQ(read_text_file(folder_ / "ground.toml"), ground);
  document_.redo();
  EXPECT_EQ(pending("ground.toml"), replaced(ground, "[1, 0, 0]", "[10, 0, 0]"));
}

TEST_F(IncludedTexts, FormsKnowWhatTheirFilesSay) {
  const TypedFields first = document_.typed_fields(ObjectId{ObjectKind::target, 0});
  EXPECT_TRUE(first.at("position_m.x").said);
  EXPECT_FALSE(first.at("rcs_m2").said);
  EXPECT_EQ(document_.typed_fields(ObjectId{ObjectKind::target, 2}).at("rcs_m2").expression, "far / 1 km * 1 m2");
  EXPECT_TRUE(document_.typed_fields(ObjectId{ObjectKind::target, 3}).at("position_m.x").said);
  EXPECT_EQ(document_.typed_fields(ObjectId{ObjectKind::target, 4}).at("position_m.x").expression, "far");
}

TEST_F(IncludedTexts, AnExpressionIsTypedIntoTheFile) {
  const ObjectId id{ObjectKind::target, 0};
  const std::vector<Field>& fields = fields_of(id.kind);
  const Field& field = *std::ranges::find(fields, std::string("rcs_m2"), &Field::id);
  Target target = document_.scene().targets.at(0);
  target.rcs_m2 = 4.0;
  Edit edit = replace_object(document_.scene(), id, target, "Change target");
  edit.typed.push_back({id, &field, "\"2 * far / 1 km * 1 m2\""});
  document_.perform(edit);
  EXPECT_THAT(pending("ground.toml"), HasSubstr("rcs = \"2 * far / 1 km * 1 m2\""));
  EXPECT_EQ(document_.text(), whole);
  EXPECT_EQ(saved().targets.at(0).rcs_m2, 4.0);
}

TEST_F(IncludedTexts, ADragIsOneStep) {
  for (const double x : {5.0, 6.0, 7.0}) {
    Target target = document_.scene().targets.at(3);
    target.position_m.x = x;
    document_.perform(replace_object(document_.scene(), {ObjectKind::target, 3}, target, "Move target", "drag"));
  }
  EXPECT_EQ(pending("more.toml"), replaced(more, "[4, 0, 0]", "[7, 0, 0]"));
  document_.undo();
  EXPECT_EQ(saved().targets.at(3).position_m.x, 4.0);
  EXPECT_EQ(read_text_file(folder_ / "more.toml"), more);
}

TEST_F(IncludedTexts, RemovedObjectsGoFromTheirFilesAndNewOnesComeIntoTheText) {
  document_.perform(remove_objects(document_.scene(), {{ObjectKind::target, 0}, {ObjectKind::target, 3}}));
  EXPECT_THAT(pending("ground.toml"), Not(HasSubstr("the first")));
  EXPECT_THAT(pending("ground.toml"), HasSubstr("two more"));
  EXPECT_THAT(pending("more.toml"), HasSubstr("Plane"));
  EXPECT_THAT(pending("more.toml"), Not(HasSubstr("[[target]]")));
  document_.perform(add_object(document_.scene(), Platform{}));
  EXPECT_THAT(document_.text(), HasSubstr("[[platform]]"));
  EXPECT_EQ(saved(), document_.scene());
}

TEST_F(IncludedTexts, AScenesCopyElsewhereIncludesNothing) {
  const std::string text = self_contained_script(document_);
  const ScriptReading reading = read_scene_text(text, "", {});
  EXPECT_THAT(reading.problems, IsEmpty());
  EXPECT_EQ(reading.scene, document_.scene());
}

TEST_F(IncludedTexts, GoWithTheSceneIntoAnotherFolder) {
  move_target(0, 10.0);
  const std::vector<DataFileWrite> files = data_to_write(document_, folder_ / "new" / "scene.toml");
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "ground.toml");
  EXPECT_THAT(files[0].text, HasSubstr("[10, 0, 0]"));
  EXPECT_EQ(files[1].text, more);
}

TEST_F(IncludedTexts, AFileThatAnotherProgramChangedStaysAsItIs) {
  move_target(0, 10.0);
  write_data(data_to_write(document_, folder_ / "scene.toml"));
  write("ground.toml", "format = \"sarsim 2\"\n");
  EXPECT_NO_THROW(document_.undo());
}

TEST_F(IncludedTexts, ASceneInJsonGoesOnInToml) {
  write("scene.json", R"({"format": "sarsim 2", "target": [{"position": [7, 0, 0]}]})");
  Document document = Document::open(folder_ / "scene.json");
  EXPECT_THAT(document.path().string(), IsEmpty());
  EXPECT_THAT(document.text(), HasSubstr("[[target]]\nposition = [7, 0, 0]"));
  write("broken.json", R"({"format": "sarsim 2", "target": [{"postion": [7, 0, 0]}]})");
  const Document broken = Document::open(folder_ / "broken.json");
  EXPECT_THAT(core::to_string(broken.problems().at(0)), HasSubstr("did you mean 'position'?"));
  EXPECT_THAT(broken.scene().targets, IsEmpty());
  document.type_text("{}");
  EXPECT_TRUE(document.text_broken());
  EXPECT_THAT(document.scene().targets, testing::SizeIs(1));
}

TEST_F(IncludedTexts, ANameThatMeansNothingYetDoesNotBreakTheText) {
  document_.type_text("format = \"sarsim 2\"\n[[target]]\nplatform = \"Pla\"\nposition = [9, 0, 0]\n");
  EXPECT_FALSE(document_.text_broken());
  EXPECT_EQ(document_.scene().targets.at(0).position_m.x, 9.0);
  ASSERT_THAT(document_.problems(), testing::SizeIs(testing::Ge(1U)));
  EXPECT_EQ(document_.problems().at(0).severity, core::Severity::error);
  EXPECT_THAT(core::to_string(document_.problems().at(0)), HasSubstr("no platform of this name"));
  EXPECT_EQ(std::ranges::count(document_.problems(), core::Severity::error, &core::Problem::severity), 1);
}

}  // namespace included_texts_test
}  // namespace sarsim::scene

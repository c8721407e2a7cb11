#include "scene/edit/document_data.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>

#include "scene/edit/edit.hpp"
#include "scene/edit/text_file.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::scene {

namespace document_data_test {

namespace fs = std::filesystem;

constexpr const char* gain_points = "! measured\n2\n0 0\n90 -10\n";

std::string directional_script(const std::string& data) {
  return "$TARGET Earth 1 2 3 0 0 0 1 0 DIRECTIONAL 0 0 0 0 OTHER_GAIN LINEAR FILE " + data + "\n";
}

// Two folders, the first with a script and its data file.
class DataFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("sarsim-document-data-test-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "old");
    fs::create_directories(folder_ / "new");
    write("old/gain.dat", gain_points);
    write("old/a.scr", directional_script("gain.dat"));
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path file(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
  }
  [[nodiscard]] Document opened(const std::string& name = "old/a.scr") const { return Document::open(file(name)); }

  static void set_gain(Document& document, double y) {
    Target target = document.scene().targets.at(0);
    target.traits.edit().gain_db.part[0].knots.at(1).y = y;
    document.perform(replace_object(document.scene(), {ObjectKind::target, 0}, target, "Change function"));
  }
  [[nodiscard]] static double gain_in(const fs::path& script) {
    return read_script_file(script).scene.targets.at(0).traits->gain_db.part[0].knots.at(1).y;
  }

  fs::path folder_;
};

TEST_F(DataFiles, AreWithinASelfContainedScript) {
  Document document = opened();
  set_gain(document, -12.5);
  const std::string text = self_contained_script(document);
  EXPECT_EQ(text.find("FILE"), std::string::npos) << text;
  write("new/b.scr", text);
  EXPECT_EQ(gain_in(file("new/b.scr")), -12.5);
}

TEST_F(DataFiles, AbsentOrFaultyLeaveASelfContainedScriptAsItIsTyped) {
  write("new/none.scr", directional_script("none.dat"));
  EXPECT_EQ(self_contained_script(opened("new/none.scr")), directional_script("none.dat"));
  write("new/plain.scr", "! a remark\n$TARGET Earth 1 2 3 0 0 0 1 0 ISOTROPIC\n");
  EXPECT_EQ(self_contained_script(opened("new/plain.scr")), opened("new/plain.scr").text());
}

TEST_F(DataFiles, StayAsTheyAreWhereNothingWasEditedAndTheScriptStays) {
  EXPECT_TRUE(data_to_write(opened(), file("old/a.scr")).empty());
  EXPECT_TRUE(data_to_write(opened(), file("old/b.scr")).empty());
  EXPECT_TRUE(data_to_write(opened(), file("new/../old/b.scr")).empty());
}

TEST_F(DataFiles, OfEditedFunctionsHaveToBeWritten) {
  Document document = opened();
  set_gain(document, -20.0);
  const auto files = data_to_write(document, file("old/a.scr"));
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].name, "gain.dat");
  EXPECT_EQ(files[0].path, file("old/gain.dat"));
  EXPECT_TRUE(files[0].replaces);
  write_data(files);
  document.save(file("old/a.scr"));
  EXPECT_EQ(gain_in(file("old/a.scr")), -20.0);
  EXPECT_TRUE(data_to_write(document, file("old/a.scr")).empty());
}

// The function editor writes the file when a function is changed; undo then has to write it again.
TEST_F(DataFiles, OfFunctionsThatWereTakenBackHaveToBeWrittenToo) {
  Document document = opened();
  set_gain(document, -20.0);
  write_data(data_to_write(document, file("old/a.scr")));
  document.type_text(document.text() + "! seen\n");
  ASSERT_TRUE(document.pending_data().empty());
  while (document.history().can_undo()) document.undo();
  EXPECT_FALSE(document.changed());
  const auto files = data_to_write(document, file("old/a.scr"));
  ASSERT_EQ(files.size(), 1U);
  write_data(files);
  EXPECT_EQ(gain_in(file("old/a.scr")), -10.0);
}

TEST_F(DataFiles, OfFunctionsThatAreGoneAreNotWritten) {
  Document document = opened();
  set_gain(document, -20.0);
  document.perform(remove_objects(document.scene(), {{ObjectKind::target, 0}}));
  EXPECT_TRUE(data_to_write(document, file("old/a.scr")).empty());
}

TEST_F(DataFiles, GoWithTheScriptToAnotherFolderByteByByte) {
  Document document = opened();
  const auto files = data_to_write(document, file("new/a.scr"));
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].path, file("new/gain.dat"));
  EXPECT_FALSE(files[0].replaces);
  write_data(files);
  document.save(file("new/a.scr"));
  EXPECT_EQ(read_text_file(file("new/gain.dat")), gain_points);
  EXPECT_EQ(gain_in(file("new/a.scr")), -10.0);
  EXPECT_FALSE(core::has_errors(document.problems()));
}

TEST_F(DataFiles, ThatStandInTheOtherFolderAreReplacedOnlyWhereTheyDiffer) {
  write("new/gain.dat", gain_points);
  EXPECT_TRUE(data_to_write(opened(), file("new/a.scr")).empty());
  write("new/gain.dat", "1\n0 0\n");
  const auto files = data_to_write(opened(), file("new/a.scr"));
  ASSERT_EQ(files.size(), 1U);
  EXPECT_TRUE(files[0].replaces);
}

TEST_F(DataFiles, WithWholePathsStayWhereTheyAre) {
  write("old/b.scr", directional_script(file("old/gain.dat").string()));
  Document document = opened("old/b.scr");
  ASSERT_FALSE(core::has_errors(document.problems()));
  EXPECT_TRUE(data_to_write(document, file("new/b.scr")).empty());
  set_gain(document, -20.0);
  const auto files = data_to_write(document, file("new/b.scr"));
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].path, file("old/gain.dat"));
}

TEST_F(DataFiles, InSubfoldersBringTheirFolderAlong) {
  fs::create_directories(file("old/data"));
  write("old/data/gain.dat", gain_points);
  write("old/b.scr", directional_script("data\\gain.dat"));
  const Document document = opened("old/b.scr");
  ASSERT_FALSE(core::has_errors(document.problems()));
  write_data(data_to_write(document, file("new/b.scr")));
  EXPECT_EQ(read_text_file(file("new/data/gain.dat")), gain_points);
}

TEST_F(DataFiles, ThatCannotBeReadAreNotInvented) {
  write("old/b.scr", directional_script("none.dat"));
  EXPECT_TRUE(data_to_write(opened("old/b.scr"), file("new/b.scr")).empty());
}

TEST_F(DataFiles, ThatCannotBeWrittenAreNamed) {
  Document document = opened();
  set_gain(document, -20.0);
  auto files = data_to_write(document, file("old/a.scr"));
  files.at(0).path = file("old/a.scr/gain.dat");
  try {
    write_data(files);
    FAIL() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("a.scr"), std::string::npos) << error.what();
  }
}

}  // namespace document_data_test
}  // namespace sarsim::scene

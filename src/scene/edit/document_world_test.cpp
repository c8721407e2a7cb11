#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "scene/edit/document.hpp"
#include "scene/edit/edit.hpp"
#include "scene/schema/fields.hpp"

// The world of a scene, edited.

namespace sarsim::scene {
namespace {

constexpr const char* on_earth = R"toml(format = "sarsim 2"

[world]  # where we are
frame = "earth"
anchor = { latitude = "50 deg", longitude = "8 deg" }

[[target]]
position = { latitude = "50.01 deg", longitude = "8 deg", height = "0 m" }

[[target]]
position = [100, 200, 0]
)toml";

World changed(const Document& document, std::string_view id, std::string_view text) {
  World world = document.scene().world;
  EXPECT_EQ(set_field(world, id, text), "");
  return world;
}

void change(Document& document, std::string_view id, std::string_view text) {
  const World world = changed(document, id, text);
  ASSERT_EQ(document.world_objection(world), "");
  document.perform(change_world(document.scene(), world));
}

TEST(DocumentWorld, KeepsOnTheEarthWhatStandsThereByItsLatitude) {
  Document document = Document::from_text(on_earth);
  ASSERT_FALSE(core::has_errors(document.problems()));
  const Scene before = document.scene();
  EXPECT_NEAR(before.targets[0].position_m.y, 1112.3, 0.5) << "0.01 degrees of latitude at 50 degrees";
  change(document, "latitude", "50.01 deg");
  EXPECT_NEAR(document.scene().targets[0].position_m.y, 0.0, 1e-6);
  EXPECT_EQ(document.scene().targets[1].position_m, before.targets[1].position_m) << "it goes with the anchor";
  EXPECT_NE(document.text().find("latitude = \"50.01 deg\", longitude = \"8 deg\", height"), std::string::npos);
  EXPECT_NE(document.text().find("# where we are"), std::string::npos);
  EXPECT_EQ(Document::from_text(document.text()).scene(), document.scene());

  document.undo();
  EXPECT_EQ(document.scene(), before);
  EXPECT_EQ(document.text(), on_earth);
  document.redo();
  EXPECT_NEAR(document.scene().targets[0].position_m.y, 0.0, 1e-6);
}

TEST(DocumentWorld, SaysWhyATextCannotBeReadInIt) {
  Document document = Document::from_text(on_earth);
  EXPECT_NE(document.world_objection(changed(document, "frame", "Flat")), "");
  EXPECT_NE(document.world_objection(changed(document, "geoid", "no-such-grid.pgm")), "");
  EXPECT_EQ(document.text(), on_earth);
}

TEST(DocumentWorld, ComesBeforeTheObjectsWhereTheTextHasNone) {
  Document document =
      Document::from_text("format = \"sarsim 2\"\n\n# the only one\n[[target]]\nposition = [1, 2, 3]\n");
  change(document, "frame", "Earth");
  change(document, "longitude", "8 deg");
  const std::string& text = document.text();
  EXPECT_LT(text.find("[world]"), text.find("# the only one")) << text;
  const Scene read = Document::from_text(text).scene();
  EXPECT_EQ(read, document.scene());
  EXPECT_EQ(read.world.frame, World::Frame::earth);
  EXPECT_EQ(read.world.longitude.deg(), 8.0);
  EXPECT_EQ(read.targets.size(), 1u);
}

// Until somebody says where it is.
TEST(DocumentWorld, WithoutAnAnchorIsWarnedOf) {
  const auto warned = [](const Document& document) {
    return std::ranges::any_of(document.problems(), [](const core::Problem& problem) {
      return problem.message.find("has no anchor") != std::string::npos;
    });
  };
  Document document = Document::from_text("format = \"sarsim 2\"\n\n[[target]]\n");
  change(document, "frame", "Earth");
  EXPECT_TRUE(warned(document)) << document.text();
  change(document, "longitude", "8 deg");
  EXPECT_FALSE(warned(document)) << document.text();
  EXPECT_NE(document.text().find("latitude = \"0 deg\""), std::string::npos) << document.text();
}

TEST(DocumentWorld, LosesItsTableWhereNothingIsLeftToSay) {
  Document document =
      Document::from_text("format = \"sarsim 2\"\n\n[world]\nepoch = \"2024-04-01T00:00:00Z\"\n\n[[target]]\n");
  change(document, "epoch", "");
  EXPECT_EQ(document.text().find("[world]"), std::string::npos) << document.text();
}

// The world of an included text gives way to one that the text itself says.
TEST(DocumentWorld, OfAnIncludedTextIsLeftThere) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "sarsim_document_world_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "world.toml") << "format = \"sarsim 2\"\n[world]\nframe = \"earth\"\n"
                                       << "anchor = { latitude = \"50 deg\", longitude = \"8 deg\" }\n";
  std::ofstream(folder / "scene.toml")
      << "format = \"sarsim 2\"\ninclude = [\"world.toml\"]\n\n[[target]]\nposition = [1, 2, 3]\n";
  Document document = Document::open(folder / "scene.toml");
  ASSERT_EQ(document.scene().world.latitude.deg(), 50.0);
  change(document, "latitude", "51 deg");
  EXPECT_NE(document.text().find("include = "), std::string::npos) << document.text();
  EXPECT_NE(document.text().find("latitude = \"51 deg\""), std::string::npos) << document.text();
  EXPECT_EQ(document.scene().world.latitude.deg(), 51.0);
  EXPECT_EQ(document.scene().world.longitude.deg(), 8.0);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sarsim::scene

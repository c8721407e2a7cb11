#include <gtest/gtest.h>

#include <algorithm>

#include "program.hpp"

namespace sarsim::test {
namespace {

#ifdef SARSIM_HAS_GUI

std::string signature(const std::filesystem::path& path, std::size_t length) { return text_of(path).substr(0, length); }

// Width of a PNG, from its header.
unsigned png_width(const std::filesystem::path& path) {
  const std::string bytes = text_of(path);
  unsigned width = 0;
  for (std::size_t i = 16; i < 20; ++i) width = width << 8U | static_cast<unsigned char>(bytes.at(i));
  return width;
}

using Plot = CommandTest;

TEST_F(Plot, OfAScriptIsAPictureOfTheAskedSize) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "-o", "a.png", "--size", "400", "300", "--scale", "2"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(signature(folder_ / "a.png", 4), "\x89PNG");
  EXPECT_EQ(png_width(folder_ / "a.png"), 800U);
}

TEST_F(Plot, IsWrittenAsSvgAndPdfToo) {
  write_scene({});
  EXPECT_EQ(sarsim({"plot", "scene.scr", "-o", "a.svg", "--size", "400", "300"}).status, 0);
  EXPECT_EQ(sarsim({"plot", "scene.scr", "-o", "a.pdf", "--size", "400", "300"}).status, 0);
  EXPECT_NE(text_of(folder_ / "a.svg").find("Slant range"), std::string::npos);
  EXPECT_EQ(signature(folder_ / "a.pdf", 4), "%PDF");
}

TEST_F(Plot, OfAFileOfSamplesNeedsNoScript) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "npy", "--quiet"}).status, 0);
  const Finished done = sarsim({"plot", "sim.npy", "-o", "b.png", "--show", "db"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(signature(folder_ / "b.png", 4), "\x89PNG");
}

TEST_F(Plot, OfAPulseGivesItsValuesAsATable) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "--kind", "pulse", "-o", "c.png", "--csv", "c.csv"});
  EXPECT_EQ(done.status, 0) << done.err;
  const std::string table = text_of(folder_ / "c.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')), "slant range [m],I [V],Q [V],magnitude [V],phase [deg]");
  EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 10);
}

TEST_F(Plot, LeavesWhatStandsUnderTheName) {
  write_scene({});
  write_text(folder_ / "a.png", "mine");
  const Finished refused = sarsim({"plot", "scene.scr", "-o", "a.png"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(text_of(folder_ / "a.png"), "mine");
  EXPECT_EQ(sarsim({"plot", "scene.scr", "-o", "a.png", "--force"}).status, 0);
  EXPECT_EQ(signature(folder_ / "a.png", 4), "\x89PNG");
}

TEST_F(Plot, IntoAFolderThatIsNotThereFailsInWordsAndLeavesNothing) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "-o", "none/a.png"});
  EXPECT_NE(done.status, 0);
  EXPECT_NE(done.err.find("none"), std::string::npos) << done.err;
}

#endif

using PlotArguments = CommandTest;

TEST_F(PlotArguments, OfAnotherKindOfPictureAreRefused) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "-o", "a.gif"});
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.err.find(".png, .svg or .pdf"), std::string::npos) << done.err;
}

TEST_F(PlotArguments, NamingASimulationThatIsNotThereAreRefused) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "--simulation", "9", "-o", "a.png"});
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.err.find("no simulation 9"), std::string::npos) << done.err;
}

TEST_F(PlotArguments, NamingAFileThatIsNotThereAreRefused) {
  EXPECT_NE(sarsim({"plot", "nothing.npy", "-o", "a.png"}).status, 0);
}

}  // namespace
}  // namespace sarsim::test

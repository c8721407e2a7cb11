// A script read in pieces, by any number of threads, says exactly what it says read as a whole: the same scene, the
// same problems in the same words at the same places.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

#include "scene/script/random_scene_test_support.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"
#include "support/folders.hpp"

namespace sarsim::scene {

namespace piecewise_test {

namespace fs = std::filesystem;

DataFileText load(const std::string& name) {
  if (name == "good.dat") return {"folder/good.dat", "2 0 0 1 1 2 0 0 1 1 2 0 0 1 1", {}};
  if (name == "bad.dat") return {"folder/bad.dat", "2 0 x 1 1 rest", {}};
  return {{}, {}, "data file not found"};
}

std::string printed(const ScriptReading& reading) {
  std::ostringstream text;
  for (const core::Problem& p : reading.problems)
    text << core::to_string(p) << " [" << p.subject.kind << " " << p.subject.index << " " << p.subject.field << "]\n";
  return text.str();
}

ScriptReading read_whole(std::string_view text) { return read_script(text, "t.scr", load, {{}, std::string::npos}); }

struct Cutting {
  std::size_t piece_bytes;
  unsigned threads;
};

// False, with the text, where pieces make a difference.
void expect_same(std::string_view text, const ScriptReading& whole, const Cutting& cutting) {
  const ScriptReading pieces = read_script(text, "t.scr", load, {{cutting.threads}, cutting.piece_bytes});
  const bool same_places = pieces.places == whole.places;
  const std::string expected = printed(whole);
  const std::string got = printed(pieces);
  if (pieces.scene == whole.scene && got == expected && same_places) return;
  ADD_FAILURE() << cutting.piece_bytes << " bytes, " << cutting.threads << " threads"
                << (same_places ? "" : ", places differ") << "\n"
                << (got == expected ? "" : "expected " + expected + "\ngot " + got) << "text:\n"
                << text.substr(0, 2000);
}

void expect_same(std::string_view text) {
  const ScriptReading whole = read_whole(text);
  for (const std::size_t piece_bytes : {1U, 50U, 400U, 5000U})
    for (const unsigned threads : {1U, 2U, 3U, 8U}) expect_same(text, whole, {piece_bytes, threads});
}

std::vector<std::string> scripts_in(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".scr") paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<std::string> texts;
  for (const fs::path& path : paths) {
    std::ifstream stream(path, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return texts;
}

// Small texts of all sorts, good and bad, to be put together and spoilt.
std::vector<std::string> fragments() {
  std::vector<std::string> texts{
      "$TARGET Earth 1 2 3 0 0 0 1 0 ISOTROPIC\n",
      "$target Earth 1,2,3 0 0 0 1 0 DIR 10 20 0 0 OTHER LINEAR INLINE 3 0 0 1 -1 2 -2\n",
      "$TARGET E 1 2 3 0 0 0 1 0 DIR 10 20 0 0 OTHER LINEAR INLINE 30 0 0 1 -1\n",
      "$TARGET E 1 2 3 0 0 0 1 0 DIR 10 20 0 0 OTHER LINEAR INLINE\n",
      "$TARGET E 1 2 3 0 0 0 1 0 DIR 10 20 0 0 OTHER LINEAR FILE good.dat\n",
      "$TARGET E 1 2 3 0 0 0 1 0 DIR 10 20 0 0 OTHER LINEAR FILE bad.dat\n",
      "$TARGET E 1 2 3 0 0 0 1 0 DIR 10 20 0 0 OTHER LINEAR FILE \n",
      "$TARGET \"a name\" 1 2 x 0 -1 0 1e-400 0 ISO 7 8\n",
      "$TARGET\n",
      "$TARGET \"\" 1 2 3 ! comment\n ! $TARGET\n 0 0 0 1 0 \"ISO\n",
      "$PLATFORM P TRAJ LIN LIN LIN INLINE 2 0 0 1 1 1 0 0\n 1 0 0 NOT_ALIGNED CONST 0 0 0 0 0 0 STD 0 0 0 STD 0 0 0\n",
      "$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0 $TARGET E 1 1 1 0 0 0 1 0 ISO\n",
      "$SURFACE Earth 1 2 3 4 5 6 7 8 9\n",
      "$SURF Earth 1 2 3 4 5\n",
      "$RADAR R P CHIRP 0.1 1000 RECT CONST 400 SINGLE 5.3 1 0 0 SINX 60 6 SAME FIXED -40 0 HAMM NO_STC\n",
      "$RADAR R P CHIRP 0.1 1000 RECT OTHER LIN INLINE 3 0 1 1 -1 2 1 STEPPED 1 0.1 0 2 1 0 0 0 0 ISO SAME SPOT 1 2 "
      "3\n",
      "$SIM R1 5550 5870 -0.64 0.6399 8 0.12 1E-7 BIN RAW out.bin CEN 1 1\n",
      "$SIMULATION R1 5550 5870 -0.64 0.6399 8.5 0.12 1E-7 BIN RAW out.bin! CEN\n",
      "$GEOMETRY R 0 1 0 1 SPACE 227 a.txt\n",
      "$OPTIONS SEED 7\n",
      "$OPTIONS PROFILE classic TOLERANCE 1e-3 SEED x\n",
      "$OPTIONS SEED 1 SEED 2 PULSE BAND\n",
      "$UNKNOWN 1 2 3\n",
      "$\n",
      "$ $ TARGET E 1 2 3 0 0 0 1 0 ISO\n",
      ", \t$TARGET E 1 2 3 0 0 0 1 0 ISO",
      "values without a command 1 2 3\n",
      "! only a comment $TARGET\n",
      "1$TARGET E\n",
      "\n\n\r\n",
      "\r",
      "\x1A",
      "\xEF\xBB\xBF"};
  return texts;
}

std::size_t below(std::mt19937& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

const std::string& any_of(std::mt19937& random, const std::vector<std::string>& texts) {
  return texts[below(random, texts.size())];
}

std::string concatenation(std::mt19937& random, const std::vector<std::string>& texts) {
  std::string text;
  for (std::size_t i = below(random, 12) + 1; i > 0; --i) text += any_of(random, texts);
  return text;
}

void spoil(std::mt19937& random, std::string& text) {
  static constexpr std::string_view bytes = "$$$!!\"\"\n\n\r,  \t01-.eEIx";
  const std::size_t at = below(random, text.size() + 1);
  const std::size_t length = below(random, 20);
  switch (random() % 4) {
    case 0: text.insert(at, 1, bytes[below(random, bytes.size())]); break;
    case 1: text.erase(at, length); break;
    case 2: text.insert(below(random, text.size() + 1), text.substr(at, 10 * length)); break;
    default:
      if (at < text.size()) text[at] = bytes[below(random, bytes.size())];
  }
}

// Other ends of lines, and none at the very end.
void change_line_ends(std::mt19937& random, std::string& text) {
  const std::size_t kind = random() % 6;
  if (kind == 0) std::ranges::replace(text, '\n', '\r');
  if (kind == 1)
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) text.insert(at, "\r");
  if (kind == 2 && !text.empty() && text.back() == '\n') text.pop_back();
}

TEST(PiecewiseReading, IsTheSameForTheExamples) {
  const std::vector<std::string> texts = scripts_in(sarsim::test::source_folder() / "examples");
  ASSERT_GE(texts.size(), 5U);
  for (const std::string& text : texts) expect_same(text);
}

TEST(PiecewiseReading, IsTheSameForTheSeedsOfTheFuzzer) {
  const std::vector<std::string> texts = scripts_in(sarsim::test::source_folder() / "fuzz/corpus/script");
  ASSERT_GE(texts.size(), 5U);
  for (const std::string& text : texts) expect_same(text);
}

void expect_same_in_many_cuttings(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) {
    const ScriptReading whole = read_whole(text);
    for (const Cutting& cutting : {Cutting{1, 1}, Cutting{1, 3}, Cutting{300, 2}, Cutting{3000, 8}})
      expect_same(text, whole, cutting);
    all += text;
  }
  expect_same(all);
}

TEST(PiecewiseReading, IsTheSameForTheReferenceScripts) {
  const std::vector<std::string> texts = scripts_in(sarsim::test::direct_reference_folder());
  ASSERT_EQ(texts.size(), 34U);
  expect_same_in_many_cuttings(texts);
}

TEST(PiecewiseReading, IsTheSameForTheScriptsOfTheOriginalProgram) {
  const fs::path folder = sarsim::test::reference_folder() / "original";
  if (!fs::is_directory(folder))
    GTEST_SKIP() << "no scripts at " << folder << "; SARSIM_REFERENCE may name the folder above";
  const std::vector<std::string> texts = scripts_in(folder);
  ASSERT_GE(texts.size(), 20U);
  expect_same_in_many_cuttings(texts);
}

TEST(PiecewiseReading, IsTheSameForRandomScenes) {
  for (unsigned seed = 1; seed <= 20; ++seed) expect_same(write_script(test::RandomScenes(seed).scene()));
}

TEST(PiecewiseReading, IsTheSameForEachFragmentAndForPairsOfThem) {
  const std::vector<std::string> texts = fragments();
  for (const std::string& first : texts)
    for (const std::string& second : texts) {
      const std::string text = first + second;
      expect_same(text, read_whole(text), {1, static_cast<unsigned>(1 + text.size() % 3)});
    }
}

TEST(PiecewiseReading, IsTheSameForRandomConcatenationsAndMutations) {
  std::mt19937 random(1998);
  std::vector<std::string> texts = fragments();
  for (const std::string& text : scripts_in(sarsim::test::source_folder() / "fuzz/corpus/script"))
    texts.push_back(text);
  for (const std::string& text : scripts_in(sarsim::test::source_folder() / "examples"))
    if (text.size() < 3000) texts.push_back(text);
  static constexpr std::size_t sizes[] = {1, 1, 20, 100, 700};
  static constexpr unsigned threads[] = {1, 1, 2, 3, 8};
  for (int i = 0; i < 3000 && !testing::Test::HasFailure(); ++i) {
    std::string text = concatenation(random, texts);
    change_line_ends(random, text);
    for (std::size_t k = random() % 6; k > 0; --k) spoil(random, text);
    expect_same(text, read_whole(text), {sizes[random() % 5], threads[random() % 5]});
  }
}

TEST(PiecewiseReading, StopsAfterTheSameErrors) {
  // Errors one by one, several at once, and within a list of points that goes on and on.
  const std::string bad = "$TARGET E 1 2 x 0 0 0 1 0 ISO\n";
  const std::string worse = "$TARGET E x x x x x x x x ISO\n";
  std::string list = "$TARGET E 1 2 3 0 0 0 1 0 DIR 10 20 0 0 OTHER LINEAR INLINE 3000\n";
  for (int i = 0; i < 3000; ++i) list += "x 1\n";
  for (const std::size_t count : {990U, 998U, 999U, 1000U, 1001U, 1500U})
    for (const std::string& end : {bad, worse, list}) {
      std::string text;
      for (std::size_t i = 0; i < count; ++i) text += i % 7 == 0 ? "$TARGET E 1 2 3 0 0 0 1 0 ISO 9\n" + bad : bad;
      text += end + bad + "$OPTIONS SEED 3\n" + worse + end;
      const ScriptReading whole = read_whole(text);
      EXPECT_TRUE(core::has_errors(whole.problems));
      for (const Cutting& cutting : {Cutting{1, 1}, Cutting{60, 3}, Cutting{1000, 2}, Cutting{20000, 8}})
        expect_same(text, whole, cutting);
    }
}

TEST(PiecewiseReading, CountsTheSameWarnings) {
  for (const std::size_t count : {999U, 1000U, 1001U, 3500U}) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += "$TARGET E 1 2 3 0 0 0 1 0 ISO 9\n";
    text += "$TARGET E x 2 3 0 0 0 1 0 ISO 9\n";
    const ScriptReading whole = read_whole(text);
    for (const Cutting& cutting : {Cutting{1, 1}, Cutting{60, 3}, Cutting{50000, 2}}) expect_same(text, whole, cutting);
  }
}

TEST(PiecewiseReading, KeepsOptionsUntilOthersAreGiven) {
  std::string text = "$OPTIONS SEED 5 PROFILE classic\n";
  for (int i = 0; i < 50; ++i) text += "$TARGET E 1 2 3 0 0 0 1 0 ISO\n";
  text += "$OPTIONS TOLERANCE 1e-4\n$TARGET E 1 2 3 0 0 0 1 0 ISO\n$OPTIONS SEED 6";
  const RunOptions options = read_script(text, "t.scr", {}, {{2}, 1}).scene.options;
  EXPECT_EQ(options.seed, 6U);
  EXPECT_EQ(options.profile, Profile::classic);
  EXPECT_EQ(options.tolerance, 1e-4);
  expect_same(text);
}

TEST(PiecewiseReading, OfALongScriptIsTheSameByDefault) {
  std::string text;
  for (int i = 0; i < 30000; ++i)
    text += "$TARGET Earth " + std::to_string(i) + ".25 -17.5 0.001 0 0 0 1 0 ISOTROPIC ! t\n\n";
  const ScriptReading whole = read_whole(text);
  EXPECT_EQ(whole.scene.targets.size(), 30000U);
  expect_same(text, whole, {ReadControl{}.piece_bytes, 2});
}

TEST(PiecewiseReading, EndsWhereItIsAskedTo) {
  core::StopFlag stop;
  stop.request();
  const std::string text = "$TARGET E 1 2 3 0 0 0 1 0 ISO\n$TARGET E 1 2 3 0 0 0 1 0 ISO\n";
  for (const unsigned threads : {1U, 2U})
    EXPECT_THROW(static_cast<void>(read_script(text, "t.scr", {}, {{threads, &stop}, 1})), core::Interrupted);
}

TEST(PiecewiseReading, PassesOnWhatALoaderThrows) {
  const DataFileLoader failing = [](const std::string&) -> DataFileText { throw std::bad_alloc(); };
  const std::string target = "$TARGET E 1 2 3 0 0 0 1 0 DIR 10 20 0 0 OTHER LINEAR FILE a.dat\n";
  for (const unsigned threads : {1U, 2U})
    EXPECT_THROW(static_cast<void>(read_script(target + target, "t.scr", failing, {{threads}, 1})), std::bad_alloc);
}

}  // namespace piecewise_test
}  // namespace sarsim::scene

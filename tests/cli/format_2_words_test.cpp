#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "program.hpp"

namespace sarsim::test {
namespace format_2_words_test {

// Lines of a scene of format 2, sound ones and such as people get wrong; a broken scene has some of either.
const std::vector<std::string> lines_of_radar{
    "pulse = { type = \"chirp\", bandwidth = \"50 MHz\", width = \"1 us\" }",
    "pulse = { type = \"chirp\", bandwidth = \"0 MHz\", width = \"1 us\" }",
    "pulse = { type = \"barker\", length = 13, width = \"1 us\" }",
    "pulse = { type = \"mono\", width = \"0 s\" }",
    "pulse = { type = \"lfm\" }",
    "carrier = \"9.6 GHz\"",
    "carrier = { type = \"stepped\", first = \"9 GHz\", step = \"0 MHz\", count = 8, pulses = 1 }",
    "carrier = { type = \"stepped\", first = \"9 GHz\", step = \"10 MHz\", count = 8, pulses = 1 }",
    "carrier = { type = \"list\", frequencies = [\"9 GHz\", \"9.1 GHz\", \"9.3 GHz\"] }",
    "repetition = \"1 kHz\"",
    "repetition = { type = \"list\", intervals = [\"1 ms\", \"1.3 ms\"] }",
    "repetition = \"100 kHz\"",
    "repetition = \"2 ms\"",
    "antenna = { type = \"sinx\", azimuth_width = \"120 deg\", elevation_width = \"400 deg\" }",
    "antenna = { type = \"points\", azimuth = { points = [[0, 0]] }, elevation = { points = [[1, 0], [0, 0]] } }",
    "antenna = { type = \"sinx\", azimuth_width = \"1 m\", elevation_width = \"5 deg\" }",
    "beam = { type = \"rotating\", elevation = \"0 deg\", rate = \"10 rpm\" }",
    "beam = { type = \"fixed\", elevation = \"90 deg\", azimuth = \"-20 deg\" }",
    "window = { type = \"hann\", pedestal = 1 }",
    "window = { type = \"points\", points = [[0, 0], [1, 0]] }",
    "envelope = { type = \"linear\", rise = \"3 us\", fall = \"3 us\" }",
    "stc = { type = \"points\", interpolation = \"low-pass\", points = [[0, 1], [5, 1], [7, 2]] }",
    "power = \"-1 kW\"",
    "losses = \"400 dB\"",
    "noise_temperature = \"1 MK\"",
    "platform = \"SPOT\"",
};
const std::vector<std::string> lines_of_recording{
    "processing = \"srp\"",
    "processing = \"matched-filter\"",
    "sample_rate = \"1 MHz\"",
    "sample_rate = \"10 GHz\"",
    "bits = 1",
    "lsb = \"1 V\"",
    "oversampling = 2",
    "width_factor = 0.5",
    "pulse_position = \"centre\"",
    "time = [\"0 s\", \"0.1 ms\"]",
    "time = [\"1 s\", \"0 s\"]",
    "range = [\"200 km\", \"201 km\"]",
    "range = [\"0 m\", \"0 m\"]",
    "file = \"a.bin\"",
    "format = \"hdf5\"",
    "radar = \"Q\"",
    "range = [\"0 m\", \"300 m\"]",
};
const std::vector<std::string> lines_of_platform{
    "path = { type = \"points\", x = { interpolation = \"cubic\", points = [[0, 0], [1, 100], [1.5, 0], [2, 90]] }, y "
    "= { "
    "points = [[0, 0]] }, z = { points = [[0, 100]] } }",
    "path = { type = \"points\", x = { interpolation = \"low-pass\", points = [[0, 0], [1, 9], [3, 8]] }, y = { points "
    "= "
    "[[0, 0]] }, z = { points = [[0, 100]] } }",
    "path = { type = \"line\", start = [0, 0, -5], velocity = [20000, 0, 0] }",
    "rotation = [\"10 deg\", 0, 0]",
    "position_error = [5, 5, 5]",
};

class Format2Words : public CommandTest {
 protected:
  std::string scene_of(std::mt19937_64& random) const {
    const auto some = [&](const std::vector<std::string>& lines, std::size_t most) {
      std::map<std::string, std::string> chosen;  // A key stands once in its table.
      for (std::size_t i = 0; i < most; ++i) {
        const std::string& line = lines[random() % lines.size()];
        chosen[line.substr(0, line.find(' '))] = line;
      }
      std::string text;
      for (const auto& [key, line] : chosen) text += line + "\n";
      return text;
    };
    std::string text = "format = \"sarsim 2\"\n";
    if (random() % 3 == 0) text += "[options]\nambiguous_echoes = \"none\"\neclipsing = \"none\"\n";
    text += "[[platform]]\nname = \"P\"\n" + some(lines_of_platform, random() % 2);
    if (random() % 8 != 0) text += "[[target]]\nposition = [1000, 0, 0]\n";
    text += "[[radar]]\nname = \"R\"\n" + some(lines_of_radar, 1 + random() % 5);
    if (random() % 8 == 0) return text;
    return text + "[[recording]]\n" + some(lines_of_recording, 1 + random() % 4) +
           (text.find("radar = ") == std::string::npos ? "radar = \"R\"\n" : "");
  }
};

// Those of the language of 1998, which have no place in what is said of a scene of format 2.
const std::set<std::string> words_of_1998{
    "NONE",           "RECT",      "MONO",         "CHIRP",      "BARKER",           "ROTATING",  "STEPPED",
    "MATCHED_FILTER", "RAW",       "SRP",          "SINGLE",     "CONSTANT",         "OTHER",     "FIXED",
    "SPOT_",          "ISOTROPIC", "SINX",         "HANNING",    "HAMMING",          "BARTLETT",  "NO_STC",
    "CUBIC",          "LINEAR",    "MFILTER",      "STATIONARY", "TRAJECTORY",       "STDDEV",    "ENVELOPE",
    "CENTRE",         "BEGIN",     "BAND_LIMITED", "STRONG",     "AMBIGUOUS_ECHOES", "ECLIPSING", "CUBIC_ENDS",
    "NOT_A_KNOT",     "CHORDS",    "DIRECTIONAL",  "script",     "scripts"};

std::string forbidden_in(const std::string& text) {
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const bool part = i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
    if (part) {
      word += text[i];
      continue;
    }
    if (words_of_1998.contains(word)) return word;
    word.clear();
    if (i + 1 < text.size() && text[i] == '$' && std::isupper(static_cast<unsigned char>(text[i + 1])) != 0) return "$";
  }
  return {};
}

TEST_F(Format2Words, OfMessagesAboutFormat2AreThoseOfFormat2) {
  std::mt19937_64 random(54);
  std::set<std::string> said;
  std::size_t with_problems = 0;
  for (int turn = 0; turn < 40; ++turn) {
    std::vector<std::string> command{"check"};
    for (int i = 0; i < 10; ++i) {
      const std::string name = "s" + std::to_string(i) + ".toml";
      write_text(folder_ / name, scene_of(random));
      command.push_back(name);
    }
    const Finished run = sarsim(command);
    ASSERT_TRUE(run.status == 0 || run.status == 2) << run.err;
    std::istringstream lines(run.out + run.err);
    for (std::string line; std::getline(lines, line);) {
      if (line.find("error:") != std::string::npos || line.find("warning:") != std::string::npos) ++with_problems;
      if (const std::string word = forbidden_in(line); !word.empty()) said.insert(word + ": " + line);
    }
  }
  EXPECT_GT(with_problems, 400U) << "the scenes are to be broken";
  EXPECT_THAT(said, testing::IsEmpty());
}

}  // namespace format_2_words_test
}  // namespace sarsim::test

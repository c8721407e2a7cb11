#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace sarsim::test {

/// Every format of recordings with its extension, and options that change what it holds.
struct FormatCase {
  std::string name;
  std::vector<std::string> options;
  std::string file;
};

inline const std::vector<FormatCase>& format_cases() {
  static const std::vector<FormatCase> cases{
      {"binary", {"--format", "binary"}, "sim.bin"},
      {"hdf5", {"--format", "hdf5"}, "sim.h5"},
      {"hdf5_counts", {"--format", "hdf5", "--counts"}, "sim.h5"},
      {"npy", {"--format", "npy"}, "sim.npy"},
      {"npy_counts", {"--format", "npy", "--counts"}, "sim.npy"},
      {"csv", {"--format", "csv", "--header"}, "sim.csv"},
      {"ascii", {"--format", "ascii"}, "sim.asc"},
      {"ascii_classic", {"--format", "ascii", "--profile", "classic"}, "sim.asc"},
      {"bracket", {"--format", "bracket"}, "sim.brk"},
  };
  return cases;
}

/// Recordings with noise and jitter, made whole and in parts.
class PartsTest : public CommandTest {
 protected:
  /// A target that shakes, seen by a noisy receiver.
  void write_shaking_scene(int pulses, const std::string& lsb_mv, const std::string& more = {}) const {
    SceneText scene;
    scene.pulses = pulses;
    scene.lsb_mv = lsb_mv;
    std::string text = scene.text();
    const std::string still = "STDDEV 0 0 0 STDDEV 0 0 0\n$TARGET";
    text.replace(text.find(still), still.size(), "STDDEV 0.1 0.2 0.3 STDDEV 0.1 0.1 0.1\n$TARGET");
    write_text(folder_ / "scene.scr", text + more);
  }

  [[nodiscard]] static std::vector<std::string> words(std::vector<std::string> first,
                                                      const std::vector<std::string>& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
  }

  [[nodiscard]] Finished run(const std::vector<std::string>& more) const {
    return sarsim(words({"run", "scene.scr"}, more));
  }

  void expect_same_bytes(const std::string& a, const std::string& b) const {
    const std::string left = text_of(folder_ / a);
    EXPECT_FALSE(left.empty()) << a;
    EXPECT_TRUE(left == text_of(folder_ / b)) << a << " and " << b << " differ";
  }

  /// The lines of the report that do not speak of time.
  [[nodiscard]] static std::string figures(const std::string& err) {
    const std::size_t begin = err.rfind("  largest magnitude");
    return begin == std::string::npos ? "no report" : err.substr(begin);
  }
};

}  // namespace sarsim::test

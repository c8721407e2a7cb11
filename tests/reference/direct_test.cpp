// The sample files that the June 1998 program wrote, against the classic profile.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "scene/script/reader.hpp"
#include "simulate/run/run.hpp"
#include "support/ascii_samples.hpp"
#include "support/folders.hpp"

namespace sarsim {
namespace direct_test {

using test::ascii_samples;
// Largest deviation of a run from a file of counts, over the file's largest magnitude. Nearest counts of 30 bits: a
// deviation of one count is 2e-9, so the comparison in volts needs no rounding of its own.
double deviation(const simulate::Recording& recording, const std::vector<std::complex<double>>& counts, double lsb_v) {
  double largest = 0.0;
  double worst = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    largest = std::max(largest, std::abs(counts[i]) * lsb_v);
    worst = std::max(worst, std::abs(recording.samples[i] - counts[i] * lsb_v));
  }
  return worst / largest;
}

TEST(DirectReference, ClassicProfileReproducesEveryCase) {
  std::vector<std::filesystem::path> scripts;
  for (const auto& entry : std::filesystem::directory_iterator(test::direct_reference_folder()))
    if (entry.path().extension() == ".scr") scripts.push_back(entry.path());
  std::ranges::sort(scripts);
  ASSERT_EQ(scripts.size(), 34u);
  for (const auto& path : scripts) {
    scene::ScriptReading reading = scene::read_script_file(path);
    ASSERT_FALSE(core::has_errors(reading.problems)) << path << core::to_string(reading.problems.front());
    reading.scene.options.profile = scene::Profile::classic;
    const simulate::Recording recording = simulate::record(simulate::make_plan(reading.scene, 0));
    auto samples = path;
    const auto counts = ascii_samples(samples.replace_extension(".asc"));
    ASSERT_EQ(recording.samples.size(), counts.size()) << path;
    const double worst = deviation(recording, counts, reading.scene.simulations[0].lsb_v);
    std::printf("%-28s %8zu samples, largest deviation %.1e\n", path.stem().c_str(), counts.size(), worst);
    EXPECT_LT(worst, 1e-6) << path;
  }
}

}  // namespace direct_test
}  // namespace sarsim

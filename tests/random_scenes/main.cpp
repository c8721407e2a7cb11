// Holds random scenes against what is promised of all of them, for as long as one likes:
//
//   random_scenes [--seconds S] [--scenes N] [--first SEED]
//
// Prints a line every minute and, where a scene fails, its seed, what fails, and the script of the plainest scene that
// fails alike. Ends with a count; exit status 1 where a scene failed or a field of the language was never used.

#include <chrono>
#include <cstdlib>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "random_scenes/comparison.hpp"
#include "random_scenes/field_cover.hpp"
#include "random_scenes/scene_maker.hpp"
#include "random_scenes/shrink.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::test {
namespace {

using Clock = std::chrono::steady_clock;

struct Limits {
  double seconds = 20.0;
  std::uint64_t scenes = UINT64_MAX;
  std::uint64_t first = 1;
};

// What was met; failures by the word of their check.
struct Count {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;
  std::uint64_t rows = 0;
  double worst_error = 0.0;
  std::map<std::string, std::uint64_t> failures;
};

bool fails_alike(const scene::Scene& scene, const std::string& check) {
  for (const Finding& finding : examine(scene).findings)
    if (finding.check == check) return true;
  return false;
}

// The first few failures of each kind in full, all of them in a line.
void tell(std::uint64_t seed, const scene::Scene& scene, const Finding& finding, Count& count) {
  constexpr std::uint64_t max_in_full = 3;
  fmt::print("seed {}: {}: {}\n", seed, finding.check, finding.text);
  if (++count.failures[finding.check] > max_in_full) return;
  const scene::Scene plain = shrunk(scene, [&](const scene::Scene& s) { return fails_alike(s, finding.check); });
  for (const Finding& left : examine(plain).findings) fmt::print("  plainest: {}: {}\n", left.check, left.text);
  fmt::print("{}\n", scene::write_script(plain));
}

void print_count(const Count& count, const FieldCover& cover, double seconds) {
  std::uint64_t failures = 0;
  for (const auto& [check, times] : count.failures) failures += times;
  fmt::print(
      "{:.0f} s: {} scenes, {} refused, {} rows compared, largest error {:.3g} of the promise; "
      "{} fields, {} keywords, {} kinds of functions, {} of them not used; {} failures\n",
      seconds, count.scenes, count.refused, count.rows, count.worst_error, cover.fields(), cover.keywords(),
      cover.blocks(), cover.missing().size(), failures);
  std::fflush(stdout);
}

int run(const Limits& limits) {
  FieldCover cover;
  Count count;
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  double told = 0.0;
  for (std::uint64_t seed = limits.first; count.scenes < limits.scenes && seconds() < limits.seconds; ++seed) {
    const scene::Scene scene = random_scene(seed);
    cover.note(scene);
    const Examination examination = examine(scene);
    ++count.scenes;
    count.refused += examination.refused.empty() ? 0U : 1U;
    count.rows += examination.rows;
    count.worst_error = std::max(count.worst_error, examination.worst_error);
    for (const Finding& finding : examination.findings) tell(seed, scene, finding, count);
    if (seconds() < told + 60.0) continue;
    told = seconds();
    print_count(count, cover, told);
  }
  print_count(count, cover, seconds());
  for (const auto& [check, times] : count.failures) fmt::print("failed: {}, {} times\n", check, times);
  const auto missing = cover.missing();
  for (const std::string& name : missing) fmt::print("never used: {}\n", name);
  return count.failures.empty() && missing.empty() ? 0 : 1;
}

int parse_and_run(int count, char** words) {
  Limits limits;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string_view word = words[i];
    if (word == "--seconds")
      limits.seconds = std::atof(words[i + 1]);
    else if (word == "--scenes")
      limits.scenes = std::strtoull(words[i + 1], nullptr, 10);
    else if (word == "--first")
      limits.first = std::strtoull(words[i + 1], nullptr, 10);
    else
      count = 0;
  }
  if (count % 2 == 0) {
    fmt::print(stderr, "random_scenes [--seconds S] [--scenes N] [--first SEED]\n");
    return 2;
  }
  return run(limits);
}

}  // namespace
}  // namespace sarsim::test

int main(int count, char** words) { return sarsim::test::parse_and_run(count, words); }

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "scene/ephemeris/ephemeris_test_support.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"

namespace sarsim::scene {

namespace mutation_test {

using namespace ephemeris_test;

// Numbers of a fixed sequence (splitmix64).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t end) {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<std::size_t>((z ^ (z >> 31U)) % end);
  }

 private:
  std::uint64_t state_;
};

// Some bytes changed, left out, doubled, or the rest cut off.
std::string mutated(std::string text, Numbers& numbers) {
  constexpr std::string_view bytes = "\n\r\t <>/=\"'&;[]{}\\,.-+0129eEPV*#%\xFF\xC3";
  for (std::size_t changes = 1 + numbers.below(4); changes > 0 && !text.empty(); --changes) {
    const std::size_t at = numbers.below(text.size());
    const std::size_t length = std::min(1 + numbers.below(40), text.size() - at);
    switch (numbers.below(6)) {
      case 0: text[at] = static_cast<char>(numbers.below(256)); break;
      case 1: text[at] = bytes[numbers.below(bytes.size())]; break;
      case 2: text.erase(at, length); break;
      case 3: text.insert(at, text.substr(numbers.below(text.size()), length)); break;
      case 4: text.insert(at, 1, bytes[numbers.below(bytes.size())]); break;
      default:
        if (numbers.below(8) == 0) text.resize(at);
    }
  }
  return text;
}

// What readers promise where they report no error.
void expect_sound(const EphemerisReading& reading) {
  if (core::has_errors(reading.problems)) return;
  ASSERT_FALSE(reading.file.segments.empty());
  for (const EphemerisSegment& segment : reading.file.segments) {
    ASSERT_FALSE(segment.states.empty());
    for (const EphemerisState& state : segment.states) ASSERT_LT(core::norm(state.position_m), 1.0000001e9);
  }
}

void expect_sound(const AttitudeReading& reading) {
  if (core::has_errors(reading.problems)) return;
  ASSERT_FALSE(reading.file.segments.empty());
  for (const AttitudeSegment& segment : reading.file.segments) ASSERT_FALSE(segment.states.empty());
}

void expect_sound(const MeanElementsReading& reading) {
  if (core::has_errors(reading.problems)) return;
  ASSERT_FALSE(reading.file.sets.empty());
}

TEST(EphemerisReaders, SurviveTenThousandMutations) {
  constexpr std::string_view texts[] = {eof_text,     oem_text,     sp3_text,     csv_text,      tle_text,
                                        omm_kvn_text, omm_xml_text, omm_csv_text, omm_json_text, aem_text};
  const EphemerisOptions choices[] = {{""}, {"L51"}, {"39634"}, {"SENTINEL-1A"}};
  Numbers numbers(20260728);
  std::size_t refused = 0;
  for (int i = 0; i < 10'000; ++i) {
    const std::string text = mutated(std::string(texts[numbers.below(std::size(texts))]), numbers);
    const EphemerisOptions& options = choices[numbers.below(std::size(choices))];
    const EphemerisReading ephemeris = read_ephemeris(text, "m", options);
    expect_sound(ephemeris);
    expect_sound(read_mean_elements(text, "m", options));
    expect_sound(read_attitude(text, "m", options));
    refused += core::has_errors(ephemeris.problems) ? 1U : 0U;
    for (const core::Problem& problem : ephemeris.problems) {
      ASSERT_FALSE(problem.message.empty());
      ASSERT_LE(problem.place.column, text.size() + 1);
    }
  }
  EXPECT_GT(refused, 5'000U);
  EXPECT_LT(refused, 10'000U);
}

}  // namespace mutation_test

}  // namespace sarsim::scene

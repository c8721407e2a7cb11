// Any bytes as a file of orbits or attitudes: no crash, every problem has words, and what has no errors holds
// something.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "scene/ephemeris/read_ephemeris.hpp"

namespace {

template <class Reading>
void expect_words(const Reading& reading) {
  for (const sarsim::core::Problem& problem : reading.problems)
    if (problem.message.empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sarsim::scene;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const EphemerisReading orbit = read_ephemeris(text, "fuzz");
  expect_words(orbit);
  if (!sarsim::core::has_errors(orbit.problems) && orbit.file.segments.empty()) std::abort();
  const MeanElementsReading elements = read_mean_elements(text, "fuzz");
  expect_words(elements);
  if (!sarsim::core::has_errors(elements.problems) && elements.file.sets.empty()) std::abort();
  expect_words(read_attitude(text, "fuzz"));
  return 0;
}

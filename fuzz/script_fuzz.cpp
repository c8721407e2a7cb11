// Any bytes as a script: no crash; read in the smallest pieces the same as in one; and where the reader finds nothing
// wrong, what is written for its scene must be read as the same scene.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"

namespace {

bool same(const sarsim::core::Problem& a, const sarsim::core::Problem& b) {
  return a.subject == b.subject && a.place == b.place && sarsim::core::to_string(a) == sarsim::core::to_string(b);
}

bool same(const sarsim::scene::ScriptReading& a, const sarsim::scene::ScriptReading& b) {
  if (!(a.scene == b.scene) || !(a.places == b.places) || a.problems.size() != b.problems.size()) return false;
  for (std::size_t i = 0; i < a.problems.size(); ++i)
    if (!same(a.problems[i], b.problems[i])) return false;
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const sarsim::scene::ScriptReading reading = sarsim::scene::read_script(text, "fuzz.scr", {});
  if (!same(reading, sarsim::scene::read_script(text, "fuzz.scr", {}, {{}, 1}))) std::abort();
  if (sarsim::core::has_errors(reading.problems)) return 0;
  const sarsim::scene::ScriptReading again =
      sarsim::scene::read_script(sarsim::scene::write_script(reading.scene), "again.scr", {});
  if (sarsim::core::has_errors(again.problems) || !(again.scene == reading.scene)) std::abort();
  return 0;
}

// Any bytes as format 2: no crash, every mistake at a place of the text; and where the reader finds nothing wrong, what
// is written for its scene must be read as the same scene.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "scene/language/scene_reader.hpp"
#include "scene/language/scene_writer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sarsim;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const scene::ScriptReading reading = scene::read_format_2(text, "fuzz.toml", {});
  for (const core::Problem& problem : reading.problems)
    if (problem.place.column > size + 1 || problem.message.empty()) std::abort();
  if (core::has_errors(reading.problems)) return 0;
  for (const scene::Saying saying : {scene::Saying::differences, scene::Saying::everything}) {
    const scene::ScriptReading again =
        scene::read_format_2(scene::write_format_2(reading.scene, saying), "again.toml", {});
    if (core::has_errors(again.problems) || !(again.scene == reading.scene)) std::abort();
  }
  return 0;
}

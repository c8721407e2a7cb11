// Any bytes as a script: no crash; and where the reader finds nothing wrong, what is written for its scene must be read
// as the same scene.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "script/reader.hpp"
#include "script/writer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const sarsim::ScriptReading reading = sarsim::read_script(text, "fuzz.scr", {});
  if (sarsim::has_errors(reading.problems)) return 0;
  const sarsim::ScriptReading again = sarsim::read_script(sarsim::write_script(reading.scene), "again.scr", {});
  if (sarsim::has_errors(again.problems) || !(again.scene == reading.scene)) std::abort();
  return 0;
}

// Any bytes as a user-function data file, for every kind of block: no crash; and where nothing is wrong, what is
// written for the points must be read as the same points.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "scene/script/data_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const sarsim::scene::FunctionBlock* block : sarsim::scene::function_blocks::all) {
    const sarsim::scene::DataFileReading reading = sarsim::scene::read_data_file(text, "fuzz.dat", *block);
    if (reading.functions.size() != block->count) std::abort();
    // The points of HDF5 come from that library (fuzz target point_table).
    if (reading.deferred || sarsim::core::has_errors(reading.problems)) continue;
    std::vector<sarsim::core::SampledFunction> functions(block->count);
    for (std::size_t i = 0; i < block->count; ++i) functions[i].knots = reading.functions[i];
    const auto again =
        sarsim::scene::read_data_file(sarsim::scene::write_data_file(functions, *block), "again.dat", *block);
    if (!again.problems.empty() || again.functions != reading.functions) std::abort();
  }
  return 0;
}

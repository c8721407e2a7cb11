#pragma once

#include <string>
#include <string_view>

namespace sarsim::picture {

/// A quantity as people read it: "5 us" is "5 µs", "3 m2" is "3 m²", "9.81 m/s2" is "9.81 m/s²", "1E-06" is "1e-6".
/// What is typed so is understood (scene::read_quantity). Scripts and commands keep the plain letters. Any other text
/// stays as it is, names and files too: only what stands behind a number and a blank is a unit.
[[nodiscard]] std::string display_text(std::string_view quantity);

/// The same for what is only read, not typed: with the sign of minus for that of a hyphen, "−500 ms to 1.499 s".
[[nodiscard]] std::string read_out_text(std::string_view quantity);

}  // namespace sarsim::picture

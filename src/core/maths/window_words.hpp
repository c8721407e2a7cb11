#pragma once

#include <string_view>

namespace sarsim::core {

/// The canonical word of a window: "rectangular", "hann", "hamming", "bartlett", "blackman", "kaiser" or "taylor",
/// for any spelling of the trade ("hanning", "rect", "none", "boxcar", "triangular", "taylorwin") in any letters; the
/// word itself where it names none of these.
[[nodiscard]] std::string_view window_word(std::string_view typed);

}  // namespace sarsim::core

#pragma once

#include <string_view>

namespace sarsim::core {

/// The canonical name of a window: "rectangular", "hann", "hamming", "bartlett", "blackman", "kaiser" or "taylor",
/// for any usual spelling ("hanning", "rect", "none", "boxcar", "triangular", "taylorwin"), ignoring case; `typed`
/// itself if it names none of these.
[[nodiscard]] std::string_view window_word(std::string_view typed);

}  // namespace sarsim::core

#pragma once

#include <string>

#include "signal/compress/range_compression.hpp"
#include "signal/sar/sar_window.hpp"

namespace sarsim::cli {

/// The window that an option's text names, the rectangular one where it names none; throws core::Refused for another
/// text.
[[nodiscard]] signal::SarWindow window_of(const std::string& option, const std::string& text);

/// The same as weights over 0 to 1, 1 where none is named.
[[nodiscard]] signal::WindowFunction window_function(const std::string& option, const std::string& text);

}  // namespace sarsim::cli

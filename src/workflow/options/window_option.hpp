#pragma once

#include <string>

#include "signal/sar/sar_window.hpp"

namespace sarsim::workflow {

/// The window that an option's text names, the rectangular one where it names none; throws core::InvalidRequest for
/// another text.
[[nodiscard]] signal::SarWindow window_of(const std::string& option, const std::string& text);

}  // namespace sarsim::workflow

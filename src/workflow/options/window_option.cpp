#include "workflow/options/window_option.hpp"

#include <string>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"

namespace sarsim::workflow {

signal::SarWindow window_of(const std::string& option, const std::string& text) {
  if (text.empty()) return {};
  if (const auto window = signal::window_from_text(text)) return *window;
  throw core::InvalidRequest(fmt::format("{}: '{}' is not a valid window", option, text),
                             std::string(signal::window_texts));
}

}  // namespace sarsim::workflow

#pragma once

#include <string>

#include "workflow/verify/record.hpp"

namespace sarsim::workflow::verify {

/// A chart as an SVG element for a page: axes with ticks, curves with a legend. Values that are not finite, and on
/// logarithmic axes those that are not positive, are left out.
[[nodiscard]] std::string svg_of(const Chart& chart);

/// Text with the characters that mean something to XML written as entities.
[[nodiscard]] std::string xml_text(const std::string& text);

}  // namespace sarsim::workflow::verify

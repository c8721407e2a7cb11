#pragma once

#include <span>
#include <string_view>

namespace sarsim::scene::language {

/// A heading of the documentation.
struct GuideHeading {
  std::string_view page;     ///< File below docs: "guide/commands.md".
  std::string_view title;    ///< That of the page.
  std::string_view heading;  ///< Empty: the page itself.
};

/// All headings of the guide, its recipes, theory and formats, down to the third level; generated from the pages during
/// the build (cmake/WriteHeadings.cmake).
[[nodiscard]] std::span<const GuideHeading> guide_headings();

}  // namespace sarsim::scene::language

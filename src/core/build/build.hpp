#pragma once

#include <string_view>

namespace sarsim::core {

/// From what and how a program was built. Nothing of it goes into files: the same input gives the same bytes.
struct Build {
  std::string_view source;    ///< Where the sources stand beside the release; empty for those of a release.
  std::string_view type;      ///< CMake's build type, such as "Release".
  std::string_view compiler;  ///< "GNU 12.2.0".
  std::string_view system;    ///< "Linux x86_64".
};

/// Of this program; its definition is in the library `sarsim_build`, which only programs link.
[[nodiscard]] const Build& this_build();

}  // namespace sarsim::core

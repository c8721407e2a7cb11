#pragma once

#include <cstdlib>
#include <filesystem>

namespace sarsim::test {

/// The folder with the scripts and sample files of the original program: $SARSIM_REFERENCE, or "shared/reference"
/// beside the checkout. It may be absent; tests that need it skip.
inline std::filesystem::path reference_folder() {
  if (const char* given = std::getenv("SARSIM_REFERENCE"); given != nullptr && *given != '\0') return given;
  return (std::filesystem::path(__FILE__).parent_path() / "../../../shared/reference").lexically_normal();
}

inline bool have_reference_folder() { return std::filesystem::is_directory(reference_folder()); }

}  // namespace sarsim::test

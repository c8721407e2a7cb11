#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/build/build.hpp"

namespace sarsim::picture {

/// A library that a program uses.
struct UsedLibrary {
  std::string name;
  std::string version;
};

/// What a program prints for `--version`: on the first line "PROGRAM X.Y.Z" alone, for scripts; then where the sources
/// stand, how they were built, the instruction sets, the libraries with the versions that this process runs with, and
/// the licence. Loads the module for HDF5, which takes some milliseconds. No newline at the end.
/// @param more  libraries that only this program uses
[[nodiscard]] std::string version_text(std::string_view program, const core::Build& build,
                                       const std::vector<UsedLibrary>& more);

}  // namespace sarsim::picture

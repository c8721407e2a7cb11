#include "picture/facts/version_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/build/version.hpp"
#include "core/maths/fft_library.hpp"
#include "simulate/resolve/compiled_simd.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace sarsim::picture {

std::string version_text(std::string_view program, const core::Build& build, const std::vector<UsedLibrary>& more) {
  std::vector<UsedLibrary> libraries{
      {"FFTW", core::fft_library_version()},
      {"HDF5", core::hdf5_version},
      {"Highway", simulate::simd_library_version()},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)}};
  libraries.insert(libraries.end(), more.begin(), more.end());
  std::vector<std::string> names;
  names.reserve(libraries.size());
  for (const UsedLibrary& library : libraries) names.push_back(library.name + " " + library.version);
  return fmt::format(
      "{} {}\n"
      "Source: {}\n"
      "Build: {}, {}, {}\n"
      "SIMD: {} in use; compiled in: {}\n"
      "Libraries: {}\n"
      "Licence GPL-3.0-or-later: free software that comes without any warranty.",
      program, core::program_version, build.source.empty() ? "the release" : build.source, build.type, build.compiler,
      build.system, simulate::simd_level(), fmt::join(simulate::compiled_simd_levels(), ", "), fmt::join(names, ", "));
}

}  // namespace sarsim::picture

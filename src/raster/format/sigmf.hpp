#pragma once

#include <filesystem>
#include <vector>

namespace sarsim::raster {

/// Version of SigMF (https://sigmf.org) that is written.
inline constexpr const char* sigmf_version = "1.2.5";

/// The two files of a SigMF recording that either of their names means: NAME.sigmf-meta and NAME.sigmf-data.
[[nodiscard]] std::vector<std::filesystem::path> sigmf_files(const std::filesystem::path& path);

}  // namespace sarsim::raster

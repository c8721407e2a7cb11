#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/task/stop.hpp"
#include "scene/model/scene.hpp"
#include "workflow/image/in_memory_image.hpp"
#include "workflow/stepped/profile_series.hpp"

namespace sarsim::workflow {

/// What stands in the headers of files of profiles, besides the profiles.
struct ProfileOrigin {
  std::string source;
  std::string script;
  std::string settings;        ///< What stood in for values of the script.
  std::size_t simulation = 0;  ///< From 0.
  std::string set;             ///< "bursts", "scans" or "encounter".
  std::string velocity;        ///< As the command line says.
  std::string window;
  double light_speed_mps = 0.0;
  std::vector<double> aspects_rad{};  ///< Of the profiles, see `aspects_rad`.
  std::string radar;                  ///< This and what follows stand in HDF5 files alone.
  scene::RunOptions run;
};

/// What profiles are, as they stay in memory.
[[nodiscard]] InMemoryImage kept_profiles(const ProfileSeries& series, const ProfileOrigin& origin);

/// Files that profiles become under a name: data, and the header of ENVI.
[[nodiscard]] std::vector<std::filesystem::path> files_of_profiles(const std::filesystem::path& path);

/// Writes profiles in the format that the path's extension says (docs/formats/range-profiles.md): ENVI with a header,
/// CSV as magnitudes against range, the others as recordings of processing SRP. Throws Interrupted, and like the sinks.
void write_profiles(const ProfileSeries& series, const ProfileOrigin& origin, const std::filesystem::path& path,
                    bool replace, const core::StopFlag* stop);

}  // namespace sarsim::workflow

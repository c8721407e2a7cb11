#pragma once

#include <filesystem>
#include <string>

#include "core/report/problem.hpp"
#include "core/task/stop.hpp"
#include "raster/format/envi.hpp"
#include "workflow/image/image_fields.hpp"

namespace sarsim::workflow {

/// Adds to the header of an image the way back to its script: paths of source and script relative to the image ("source
/// from image", "script from image"), the checksum of the script as it is now ("script checksum") and, for a recording,
/// that of its samples ("source checksum"). Files that cannot be read have no checksum.
/// @param stop  asked now and then; a requested stop throws Interrupted
void add_way_back(raster::EnviHeader& header, const ImageOrigin& origin, const std::filesystem::path& image,
                  const core::StopFlag* stop = nullptr);

/// Where the source of an image and its script are now.
struct WayBack {
  std::string source;
  std::string script;       ///< Empty where the image was made without --script.
  core::Problems problems;  ///< Warning if the script has changed since the image was made; notes about other folders.
};

/// Finds the files of a header: relative to the image, relative to the current folder, beside the image. A file is
/// identified by its checksum, not by its name: of the files with the name in these folders, the one with the samples,
/// or the scene, that the image was made from. Throws core::InvalidRequest if the source is in none of these folders,
/// or if only another recording is there or, in another folder than the original, another scene. A scene that was
/// edited in its original place is used, with a warning; so is, with a note, the recording of an image of an earlier
/// version, which has no checksum.
/// @param script  the one to take instead of the header's, which it need not be like; empty: none
/// @param stop    asked now and then; a requested stop throws Interrupted
[[nodiscard]] WayBack way_back(const raster::EnviHeader& header, const ImageOrigin& origin,
                               const std::filesystem::path& image, const std::string& script,
                               const core::StopFlag* stop = nullptr);

}  // namespace sarsim::workflow

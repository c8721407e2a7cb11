#pragma once

#include <filesystem>
#include <string>

#include "core/report/problem.hpp"
#include "core/task/stop.hpp"
#include "raster/format/envi.hpp"
#include "workflow/image/image_fields.hpp"

namespace sarsim::workflow {

/// Adds to the header of an image what leads back to its script: where the source and the script are seen from the
/// image ("source from image", "script from image"), and the checksums of the script as it is now ("script checksum")
/// and, of a recording, of its samples ("source checksum"). What cannot be read has none.
/// @param stop  asked now and then; a requested stop throws Interrupted
void add_way_back(raster::EnviHeader& header, const ImageOrigin& origin, const std::filesystem::path& image,
                  const core::StopFlag* stop = nullptr);

/// Where the source of an image and its script are now.
struct WayBack {
  std::string source;
  std::string script;       ///< Empty where the image was made without --script.
  core::Problems problems;  ///< Where the script is another one than when the image was made, or the place is.
};

/// Follows a header back: as seen from the image, as seen from the current folder, beside the image. A file is known by
/// its checksum, not by its name: of the files of that name in these places the one with the samples, or the scene,
/// that the image was made from. Throws core::Refused where the source is in none of these places, or what is there is
/// another recording or, elsewhere than where the scene was, another scene. A scene that was edited at its place is
/// taken, with a warning; so is, with a note, the recording of an image of an earlier version, which has no checksum.
/// @param script  the one to take instead of the header's, which it need not be like; empty: none
/// @param stop    asked now and then; a requested stop throws Interrupted
[[nodiscard]] WayBack way_back(const raster::EnviHeader& header, const ImageOrigin& origin,
                               const std::filesystem::path& image, const std::string& script,
                               const core::StopFlag* stop = nullptr);

}  // namespace sarsim::workflow

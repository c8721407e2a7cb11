#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radar/earth/earth_frame.hpp"
#include "raster/format/envi.hpp"
#include "scene/model/run_options.hpp"
#include "signal/sar/focusing.hpp"
#include "signal/sar/sar_image.hpp"

namespace sarsim::raster {
class Raster;
}

namespace sarsim::workflow {

struct ImageCollection;

/// How an image came to be, as its header tells it.
struct ImageOrigin {
  std::string source;    ///< What was focused: a path.
  std::string script;    ///< What --script said.
  std::string settings;  ///< What stood in for values of the script (workflow/input/override_words.hpp).
  std::size_t simulation = 0;
  std::string algorithm;
  signal::FocusOptions options;
  std::string motion = "none";  ///< Order to which the flight's departures from a straight line were compensated.
  std::string radar;            ///< This and what follows stand in HDF5 files alone.
  scene::RunOptions run;
  std::optional<radar::EarthFrame> earth;  ///< Under the world; of ground grids it stands in headers (map_fields.hpp).
  std::shared_ptr<const ImageCollection> collection = nullptr;  ///< For SICD alone (sicd_image.hpp).
  /// Origin on the Earth of the frame's world, for images whose source has no scene: for CPHD files that of the scene
  /// that they were made from, or their reference point. Nothing: the world is that of the scene.
  std::optional<radar::Anchor> anchor = std::nullopt;
  std::shared_ptr<const raster::Raster> recording = nullptr;  ///< The source as it was opened, where it has samples.
};

/// Whether an image is one of a target that turns (sarsim isar): from line to line cross-range, not azimuth.
[[nodiscard]] bool is_of_turning_target(const ImageOrigin& origin);

/// Whether an image is a ground grid of which it is known where on the Earth it lies.
[[nodiscard]] bool is_on_the_earth(const signal::FocusedImage& image, const ImageOrigin& origin);

/// The header of a focused image (docs/formats/focused-images.md).
[[nodiscard]] raster::EnviHeader header_of(const signal::FocusedImage& image, const ImageOrigin& origin);

/// Reads a header back; throws core::InvalidRequest where it is not that of a focused image.
void read_header(const raster::EnviHeader& header, const std::string& file, signal::FocusedImage& image,
                 ImageOrigin& origin);

}  // namespace sarsim::workflow

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radar/earth/earth_frame.hpp"
#include "radar/earth/instant.hpp"
#include "raster/format/envi.hpp"
#include "raster/sicd/sicd.hpp"
#include "raster/table/raster.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "signal/sar/sar_image.hpp"
#include "workflow/image/image_fields.hpp"

namespace sarsim::workflow {

/// A place in an image and when it was seen.
struct SeenPlace {
  signal::ImagePlace place;
  double time_s = 0.0;  ///< Mean of the pulses that see it, weighted by the power of its echoes; of the scene.
};

/// How the echoes of an image were collected: what SICD says besides its axes.
struct ImageCollection {
  radar::EarthFrame earth;                ///< Under the world.
  radar::Instant epoch;                   ///< Of time 0 of the scene.
  std::vector<signal::TrackPoint> track;  ///< Where the antenna was, or was believed to be, at each pulse.
  signal::SarWaveform waveform;
  double lowest_hz = 0.0;  ///< Of all that is sent.
  double highest_hz = 0.0;
  double window_s = 0.0;  ///< Length of the reception of a pulse.
  core::Vec3 scene_m;     ///< World; a point of the ground: side and height of the scene.
  bool autofocused = false;
  std::vector<SeenPlace> seen;  ///< Rows of `seen_across` places along the track, by ranges.
  /// Of the spectrum of a point in the middle, cycles per metre of slant range: that of an even one that resolves as
  /// much along this axis.
  double range_bandwidth_per_m = 0.0;
  double azimuth_bandwidth_per_m = 0.0;  ///< The same along the track.
};

/// Places of `ImageCollection::seen` along the track, and ranges; odd, so that the middle is one of them.
inline constexpr std::size_t seen_along = 7;
inline constexpr std::size_t seen_across = 3;

/// The places of an image that `ImageCollection::seen` is about, ranges outside: at one range after the other all along
/// the track.
[[nodiscard]] std::vector<signal::ImagePlace> places_to_look_at(const signal::FocusedImage& image);

/// The point of the ground that an image shows at a place: of a ground grid that of its plane, of slant ranges the
/// point at the height of the scene over the ellipsoid, on its side of the flight. Nothing where the range does not
/// reach the ground.
[[nodiscard]] std::optional<core::Vec3> ground_point(const signal::FocusedImage& image, const radar::EarthFrame& earth,
                                                     const core::Vec3& scene_m, const signal::ImagePlace& place);

/// An image as SICD has it.
struct SicdImage {
  raster::Sicd description;
  bool backwards = false;  ///< The first row along the track is the last column: the radar looks to the left.
};

/// Describes a focused image (docs/formats/sicd.md). Throws core::InvalidRequest where it never reaches the ground or
/// turns (sarsim isar).
/// @param header  of the same image as ENVI: its fields become parameters of the collection
/// @param name    CoreName: that of the file without its ending
[[nodiscard]] SicdImage sicd_of(const signal::FocusedImage& image, const ImageOrigin& origin,
                                const ImageCollection& collection, const raster::EnviHeader& header,
                                const std::string& name);

/// A SICD file that `sarsim focus` wrote, as the image that it was made from.
struct SicdSource {
  raster::EnviHeader header;
  bool backwards = false;  ///< As of SicdImage.
};

/// What a SICD file says of its source; nothing of files of other programs.
[[nodiscard]] std::optional<SicdSource> sicd_source(const raster::Raster& file);

}  // namespace sarsim::workflow

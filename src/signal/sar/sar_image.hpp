#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "core/maths/vector.hpp"

namespace sarsim::signal {

/// What the two coordinates of a focused image mean.
enum class ImagePlane {
  slant_range,  ///< Along the reference track, and the distance of closest approach to it (zero Doppler).
  ground_grid,  ///< Along two perpendicular unit vectors of a plane in the world.
};

/// Where a focused image lies in the world: the place of a point p is
///
///     azimuth = (p - origin) . along,
///     range   = |p - origin - azimuth along|   (slant_range)   or   (p - origin) . across   (ground_grid).
struct ImageFrame {
  ImagePlane plane = ImagePlane::slant_range;
  core::Vec3 origin_m;         ///< World. slant_range: the antenna of the reference track at azimuth 0.
  core::Vec3 along{1, 0, 0};   ///< World, length 1. slant_range: the direction of the reference track.
  core::Vec3 across{0, 1, 0};  ///< World, length 1, perpendicular to `along`; slant_range has no use for it.
  double speed_mps = 0.0;      ///< Of the reference track.
};

/// Evenly spaced coordinates first, first + step ... of rows or columns. What lies between samples follows from the
/// band-limited function whose spectrum is the one period about `spectrum_centre_per_m`.
struct ImageAxis {
  double first_m = 0.0;
  double step_m = 1.0;
  std::size_t count = 0;
  double spectrum_centre_per_m = 0.0;  ///< Cycles per metre; not 0 where the beam squints.

  [[nodiscard]] double at(double index) const { return first_m + index * step_m; }
  [[nodiscard]] double index_of(double coordinate_m) const { return (coordinate_m - first_m) / step_m; }
};

/// Coordinates in an image.
struct ImagePlace {
  double azimuth_m = 0.0;
  double range_m = 0.0;
};

/// Centre of a spectrum, cycles per metre.
struct SpectrumCentre {
  double azimuth_per_m = 0.0;
  double range_per_m = 0.0;
};

/// A focused image, in baseband. The peak of a resting point target whose closest distance to the (straight) reference
/// track is R0 has the phase -4 pi carrier_hz R0/light_speed_mps plus that of its reflectivity, in a ground grid too
/// (what back projection sums to 0 is turned by that of the pixel), and the amplitude of its echoes: the weighted mean
/// over the pulses focused, not their sum (docs/theory/focusing.md).
struct FocusedImage {
  ImageFrame frame;
  ImageAxis azimuth;  ///< Of rows.
  ImageAxis range;    ///< Of columns.
  double carrier_hz = 0.0;
  double light_speed_mps = 0.0;
  std::vector<std::complex<float>> values;  ///< azimuth.count rows of range.count.
};

/// Where a point of the world lies in an image of this frame; its height above a ground grid does not count.
[[nodiscard]] inline ImagePlace place_of(const ImageFrame& frame, const core::Vec3& point_m) {
  const core::Vec3 from_origin = point_m - frame.origin_m;
  const double azimuth_m = core::dot(from_origin, frame.along);
  if (frame.plane == ImagePlane::ground_grid) return {azimuth_m, core::dot(from_origin, frame.across)};
  return {azimuth_m, core::norm(from_origin - azimuth_m * frame.along)};
}

}  // namespace sarsim::signal

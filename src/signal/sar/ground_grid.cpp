#include "signal/sar/ground_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/report/expect.hpp"
#include "signal/sar/ground_sight.hpp"

namespace sarsim::signal {

namespace {

ReferenceTrack line_of(const ImageFrame& slant) { return {0.0, slant.origin_m, slant.speed_mps * slant.along}; }

// The ground at the places of an image of slant range.
class SeenGround {
 public:
  SeenGround(const FocusedImage& slant, const core::Vec3& scene_m)
      : slant_(slant), sight_(line_of(slant.frame), scene_m, 0.0), ground_m_(scene_m.z) {}

  [[nodiscard]] core::Vec3 antenna_m(double azimuth_m) const {
    return slant_.frame.origin_m + azimuth_m * slant_.frame.along;
  }
  /// Distance from the line at an azimuth, across it: more than the height where the line climbs.
  [[nodiscard]] double nearest_m(double azimuth_m) const {
    return std::abs(antenna_m(azimuth_m).z - ground_m_) / std::hypot(slant_.frame.along.x, slant_.frame.along.y);
  }
  /// The point at a distance, or the nearest one where the ground is farther away.
  [[nodiscard]] core::Vec3 at(double azimuth_m, double range_m) const {
    return sight_.point_at(antenna_m(azimuth_m), std::max(range_m, nearest_m(azimuth_m)));
  }

 private:
  const FocusedImage& slant_;
  GroundSight sight_;
  double ground_m_;
};

// From one place to another, in steps as before.
void place_axis(ImageAxis& axis, double first_m, double last_m) {
  axis.first_m = first_m;
  axis.count = static_cast<std::size_t>(std::ceil(std::max((last_m - first_m) / axis.step_m, 0.0))) + 1;
}

// The wave vector of the beam's middle lacks, in the slant image as in this one, that of closest approach: what is left
// of it along the line and across it, in the middle of the swath, is turned into the axes of the ground.
void centre_spectra(FocusedImage& grid, const FocusedImage& slant, const SeenGround& ground) {
  const auto middle = [](const ImageAxis& axis) { return axis.at(0.5 * (static_cast<double>(axis.count) - 1.0)); };
  const double azimuth_m = middle(slant.azimuth);
  const core::Vec3 sight = ground.at(azimuth_m, middle(slant.range)) - ground.antenna_m(azimuth_m);
  const core::Vec3 centre_per_m = slant.azimuth.spectrum_centre_per_m * slant.frame.along +
                                  slant.range.spectrum_centre_per_m / core::norm(sight) * sight;
  grid.azimuth.spectrum_centre_per_m = core::dot(centre_per_m, grid.frame.along);
  grid.range.spectrum_centre_per_m = core::dot(centre_per_m, grid.frame.across);
}

}  // namespace

FocusedImage on_ground(const FocusedImage& slant, const core::Vec3& scene_m) {
  CORE_EXPECT(slant.frame.plane == ImagePlane::slant_range);
  FocusedImage grid = slant;
  grid.values.clear();
  ImageFrame& frame = grid.frame;
  frame.plane = ImagePlane::ground_grid;
  frame.origin_m.z = scene_m.z;
  frame.along.z = 0.0;
  if (!(core::norm(frame.along) > 1e-6)) throw std::invalid_argument("ground grid: the antenna's line is vertical");
  frame.along = (1.0 / core::norm(frame.along)) * frame.along;
  frame.across = core::cross(frame.along, {0.0, 0.0, 1.0});
  if (core::dot(frame.across, scene_m - slant.frame.origin_m) < 0.0) frame.across = -frame.across;
  const SeenGround ground(slant, scene_m);
  const double first_m = slant.azimuth.at(0.0);
  const double last_m = slant.azimuth.at(static_cast<double>(slant.azimuth.count) - 1.0);
  const double farthest_m = slant.range.at(static_cast<double>(slant.range.count) - 1.0);
  if (!(farthest_m > std::min(ground.nearest_m(first_m), ground.nearest_m(last_m))))
    throw std::invalid_argument("ground grid: the ground is farther away than all ranges of the image");
  const ImagePlace near_first = place_of(frame, ground.at(first_m, slant.range.first_m));
  const ImagePlace near_last = place_of(frame, ground.at(last_m, slant.range.first_m));
  const ImagePlace far_first = place_of(frame, ground.at(first_m, farthest_m));
  const ImagePlace far_last = place_of(frame, ground.at(last_m, farthest_m));
  place_axis(grid.azimuth, far_first.azimuth_m, far_last.azimuth_m);
  place_axis(grid.range, std::min(near_first.range_m, near_last.range_m),
             std::max(far_first.range_m, far_last.range_m));
  centre_spectra(grid, slant, ground);
  return grid;
}

ImagePlace place_on_ground(const ImageFrame& grid, const ImageFrame& slant, const ImagePlace& place) {
  CORE_EXPECT(grid.plane == ImagePlane::ground_grid);
  CORE_EXPECT(slant.plane == ImagePlane::slant_range);
  const GroundSight sight(line_of(slant), grid.origin_m + grid.across, 0.0);
  return place_of(grid, sight.point_at(slant.origin_m + place.azimuth_m * slant.along, place.range_m));
}

}  // namespace sarsim::signal

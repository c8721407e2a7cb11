#include "process/ground_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "process/ground_sight.hpp"

namespace sarsim {

namespace {

ReferenceTrack line_of(const ImageFrame& slant) { return {0.0, slant.origin_m, slant.speed_mps * slant.along}; }

}  // namespace

FocusedImage on_ground(const FocusedImage& slant, const Vec3& scene_m) {
  FocusedImage grid = slant;
  grid.values.clear();
  ImageFrame& frame = grid.frame;
  frame.plane = ImagePlane::ground_grid;
  frame.origin_m.z = scene_m.z;
  frame.along.z = 0.0;
  if (!(norm(frame.along) > 1e-6)) throw std::invalid_argument("ground grid: the antenna's line is vertical");
  frame.along = (1.0 / norm(frame.along)) * frame.along;
  frame.across = cross(frame.along, {0.0, 0.0, 1.0});
  const GroundSight sight(line_of(slant.frame), scene_m, 0.0);
  if (dot(frame.across, scene_m - slant.frame.origin_m) < 0.0) frame.across = -frame.across;
  const double last_m = slant.range.at(static_cast<double>(slant.range.count) - 1.0);
  const double height_m = slant.frame.origin_m.z - scene_m.z;
  if (!(last_m > std::abs(height_m)))
    throw std::invalid_argument("ground grid: the ground is farther away than all ranges of the image");
  const auto across_m = [&](double range_m) {
    return dot(sight.point_at(slant.frame.origin_m, std::max(range_m, std::abs(height_m))) - frame.origin_m,
               frame.across);
  };
  grid.range.first_m = across_m(slant.range.first_m);
  grid.range.spectrum_centre_per_m = 0.0;
  grid.range.count =
      static_cast<std::size_t>(std::ceil((across_m(last_m) - grid.range.first_m) / grid.range.step_m)) + 1;
  return grid;
}

ImagePlace place_on_ground(const ImageFrame& grid, const ImageFrame& slant, const ImagePlace& place) {
  const GroundSight sight(line_of(slant), grid.origin_m + grid.across, 0.0);
  return place_of(grid, sight.point_at(slant.origin_m + place.azimuth_m * slant.along, place.range_m));
}

}  // namespace sarsim

#include "workflow/exchange/image_area.hpp"

#include <algorithm>
#include <cmath>

#include "radar/motion/pose.hpp"

namespace sarsim::workflow {

namespace {

// A rectangle that grows.
class Rectangle {
 public:
  Rectangle(const core::Vec3& origin_m, const core::Vec3& x_axis, const core::Vec3& y_axis)
      : origin_m_(origin_m), x_axis_(x_axis), y_axis_(y_axis) {}

  void include(const core::Vec3& point_m) {
    const double x = core::dot(point_m - origin_m_, x_axis_);
    const double y = core::dot(point_m - origin_m_, y_axis_);
    if (empty_) area_ = {x, y, x, y};
    empty_ = false;
    area_ = {std::min(area_.x1, x), std::min(area_.y1, y), std::max(area_.x2, x), std::max(area_.y2, y)};
  }
  [[nodiscard]] bool empty() const { return empty_; }
  [[nodiscard]] const raster::AreaRectangle& area() const { return area_; }

 private:
  core::Vec3 origin_m_, x_axis_, y_axis_;
  raster::AreaRectangle area_;
  bool empty_ = true;
};

void include_scatterers(const simulate::Acquisition& acquisition, Rectangle& rectangle) {
  const std::int64_t middle = acquisition.timing.pulses.first + acquisition.timing.pulses.count() / 2;
  const double time_s = acquisition.link.repetition.send_time_s(middle);
  std::vector<radar::Pose> poses;
  for (const simulate::ResolvedPlatform& platform : acquisition.scene->platforms)
    poses.push_back(platform.track.at(time_s, middle));
  const auto include = [&](std::uint32_t platform, const core::Vec3& point_m) {
    rectangle.include(radar::world_position_m(poses[platform], point_m));
  };
  const simulate::ScattererList& all = acquisition.scene->scatterers;
  for (std::size_t i = 0; i < all.targets(); ++i) {
    const simulate::Scatterer target = all[i];
    include(target.platform, target.position_m);
  }
  for (const simulate::ScattererCloud& cloud : all.clouds())
    for (unsigned corner = 0; corner < 8; ++corner)
      include(cloud.common.platform,
              {(corner & 1U) != 0 ? cloud.min_m.x : cloud.max_m.x, (corner & 2U) != 0 ? cloud.min_m.y : cloud.max_m.y,
               (corner & 4U) != 0 ? cloud.min_m.z : cloud.max_m.z});
  for (const simulate::ScattererSheet& sheet : acquisition.scene->sheets)
    for (const core::Vec3& point_m : sheet.points_m) include(sheet.platform, point_m);
}

// Width of a cell along an axis, from the directions in which the pulses at both ends of the recording see a point that
// rests, and the band. The reference points of the pulses may fly along, and all of them be seen in one direction.
// @param point_m  ECF
double cell_m(const Collection& collection, const raster::PhaseVector& middle, const core::Vec3& point_m,
              const core::Vec3& axis) {
  CollectionGeometry geometry(collection);
  const double c = collection.acquisition->light_speed_mps();
  double least = INFINITY, most = -INFINITY;
  for (const std::size_t row :
       {std::size_t{0}, collection.acquisition->timing.rows / 2, collection.acquisition->timing.rows - 1}) {
    const raster::PhaseVector v = geometry.pulse_of(row).vector;
    const core::Vec3 out = v.tx_m - point_m, back = v.rcv_m - point_m;
    const double slope = core::dot(out, axis) / core::norm(out) + core::dot(back, axis) / core::norm(back);
    for (const double fx_hz : {middle.fx1_hz, middle.fx2_hz}) {
      least = std::min(least, slope * fx_hz / c);
      most = std::max(most, slope * fx_hz / c);
    }
  }
  return 1.0 / std::max(most - least, 1e-6);
}

// The edge of the cell, one of which has its middle at 0, that holds a place.
double before(double place_m, double step_m) { return (std::floor(place_m / step_m + 0.5) - 0.5) * step_m; }

}  // namespace

raster::SceneCoordinates image_area_of(const Collection& collection, const core::Vec3& reference_m,
                                       const raster::PhaseVector& middle) {
  constexpr double margin_share = 0.1;
  constexpr double margin_cells = 8.0;
  constexpr double step_cells = 0.75;
  const radar::EarthFrame& earth = collection.earth;
  core::Vec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0};
  if (!collection.flat) {
    const core::Mat3 enu = core::transposed(earth.world_from_enu(earth.geodetic_of(reference_m)));
    x = enu.row[0];
    y = enu.row[1];
  }
  raster::SceneCoordinates scene;
  scene.origin_m = earth.ecef_from_world(reference_m);
  scene.x_axis = earth.ecef_axes_from_world(x);
  scene.y_axis = earth.ecef_axes_from_world(y);
  const double x_cell_m = cell_m(collection, middle, scene.origin_m, scene.x_axis);
  const double y_cell_m = cell_m(collection, middle, scene.origin_m, scene.y_axis);
  Rectangle rectangle(reference_m, x, y);
  include_scatterers(*collection.acquisition, rectangle);
  if (rectangle.empty()) {
    const double half_m = 0.25 * collection.acquisition->light_speed_mps() * (middle.toa2_s - middle.toa1_s);
    rectangle.include(reference_m + half_m * x + half_m * y);
    rectangle.include(reference_m - half_m * x - half_m * y);
  }
  const raster::AreaRectangle& a = rectangle.area();
  scene.x_step_m = step_cells * x_cell_m;
  scene.y_step_m = step_cells * y_cell_m;
  const double x_margin_m = margin_share * (a.x2 - a.x1) + margin_cells * x_cell_m;
  const double y_margin_m = margin_share * (a.y2 - a.y1) + margin_cells * y_cell_m;
  scene.area = {before(a.x1 - x_margin_m, scene.x_step_m), before(a.y1 - y_margin_m, scene.y_step_m),
                -before(-a.x2 - x_margin_m, scene.x_step_m), -before(-a.y2 - y_margin_m, scene.y_step_m)};
  return scene;
}

}  // namespace sarsim::workflow

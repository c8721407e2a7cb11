#include "workflow/exchange/reference_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/earth/ellipsoid.hpp"

namespace sarsim::workflow {

namespace {

core::Vec3 unit(const core::Vec3& v) {
  const double length = core::norm(v);
  return length > 0.0 ? (1.0 / length) * v : core::Vec3{};
}

double safe_acos(double x) { return std::acos(std::clamp(x, -1.0, 1.0)); }
double safe_asin(double x) { return std::asin(std::clamp(x, -1.0, 1.0)); }

double turn_deg(double y, double x) {
  const double angle = core::deg_per_rad * std::atan2(y, x);
  return angle < 0.0 ? angle + 360.0 : angle;
}

// East, north and up at a point.
struct LocalAxes {
  core::Vec3 east, north, up;

  explicit LocalAxes(const core::Vec3& point_m) {
    const radar::Geodetic place = radar::geodetic_of(point_m);
    const double sin_lat = std::sin(place.latitude_rad), cos_lat = std::cos(place.latitude_rad);
    const double sin_lon = std::sin(place.longitude_rad), cos_lon = std::cos(place.longitude_rad);
    east = {-sin_lon, cos_lon, 0.0};
    north = {-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat};
    up = {cos_lat * cos_lon, cos_lat * sin_lon, sin_lat};
  }
  [[nodiscard]] double azimuth_deg(const core::Vec3& v) const {
    return turn_deg(core::dot(v, east), core::dot(v, north));
  }
};

// Twist, slope and layover of an image plane with that normal.
void put_image_plane(const core::Vec3& normal, const core::Vec3& ground_y, const LocalAxes& axes,
                     raster::ReferenceGeometry& g) {
  g.twist_deg = -core::deg_per_rad * safe_asin(core::dot(normal, ground_y));
  g.slope_deg = core::deg_per_rad * safe_acos(core::dot(axes.up, normal));
  g.layover_deg = axes.azimuth_deg(-normal);
}

void put_monostatic(const core::Vec3& position_m, const core::Vec3& velocity_mps, const LocalAxes& axes,
                    raster::ReferenceGeometry& g) {
  g.platform = platform_geometry(g.time_s, position_m, velocity_mps, g.srp_m);
  const core::Vec3 towards = unit(position_m - g.srp_m);
  const double look = g.platform.side == 'L' ? 1.0 : -1.0;
  put_image_plane(unit(look * core::cross(towards, unit(velocity_mps))), unit(core::cross(axes.up, towards)), axes, g);
}

// The direction from the reference point and how it turns.
struct Sight {
  core::Vec3 direction, rate;

  Sight(const core::Vec3& position_m, const core::Vec3& velocity_mps, const core::Vec3& srp_m)
      : direction(unit(position_m - srp_m)),
        rate((1.0 / core::norm(position_m - srp_m)) * (velocity_mps - core::dot(direction, velocity_mps) * direction)) {
  }
};

void put_bistatic(const raster::PhaseVector& v, const LocalAxes& axes, raster::ReferenceGeometry& g) {
  g.platform = platform_geometry(v.tx_time_s, v.tx_m, v.tx_mps, g.srp_m);
  g.receiver = platform_geometry(v.rcv_time_s, v.rcv_m, v.rcv_mps, g.srp_m);
  const Sight out(v.tx_m, v.tx_mps, g.srp_m), back(v.rcv_m, v.rcv_mps, g.srp_m);
  const core::Vec3 bisector = 0.5 * (out.direction + back.direction);
  const core::Vec3 rate = 0.5 * (out.rate + back.rate);
  const double length = core::norm(bisector);
  const double angle = 2.0 * safe_acos(length);
  g.bistatic_deg = core::deg_per_rad * angle;
  if (length > 0.0 && std::sin(angle) > 0.0)
    g.bistatic_rate_deg_per_s = -core::deg_per_rad * 4.0 * core::dot(bisector, rate) / std::sin(angle);
  const double above = core::dot(bisector, axes.up);
  const core::Vec3 level = bisector - above * axes.up;
  const double along = core::norm(level);
  if (along == 0.0) return;
  const core::Vec3 ground_y = core::cross(axes.up, unit(level));
  g.graze_deg = core::deg_per_rad * std::atan2(above, along);
  g.azimuth_deg = axes.azimuth_deg(level);
  const double turning = core::dot(rate, ground_y);
  g.azimuth_rate_deg_per_s = -core::deg_per_rad * turning / along;
  if (turning == 0.0) return;
  const core::Vec3 across = rate - (core::dot(rate, bisector) / (length * length)) * bisector;
  put_image_plane(unit((turning > 0.0 ? 1.0 : -1.0) * core::cross(bisector, across)), ground_y, axes, g);
}

}  // namespace

raster::PlatformGeometry platform_geometry(double time_s, const core::Vec3& position_m, const core::Vec3& velocity_mps,
                                           const core::Vec3& srp_m) {
  const LocalAxes axes(srp_m);
  const core::Vec3 towards = unit(position_m - srp_m);
  const core::Vec3 above = unit(position_m), ahead = unit(velocity_mps);
  raster::PlatformGeometry g{.time_s = time_s, .position_m = position_m, .velocity_mps = velocity_mps};
  g.slant_range_m = core::norm(position_m - srp_m);
  // As the standards have it, by an arc cosine: an arc tangent would be better by some micrometres, which checkers
  // find.
  const auto divided = [](const core::Vec3& v) {
    const double length = core::norm(v);
    return core::Vec3{v.x / length, v.y / length, v.z / length};
  };
  g.ground_range_m = core::norm(srp_m) * safe_acos(core::dot(divided(position_m), divided(srp_m)));
  if (core::norm(velocity_mps) > 0.0) {
    g.side = core::dot(core::cross(above, ahead), towards) < 0.0 ? 'L' : 'R';
    g.doppler_cone_deg = core::deg_per_rad * safe_acos(-core::dot(towards, ahead));
  }
  const core::Vec3 level = towards - core::dot(towards, axes.up) * axes.up;
  g.graze_deg = core::deg_per_rad * std::atan2(core::dot(towards, axes.up), core::norm(level));
  g.incidence_deg = 90.0 - g.graze_deg;
  if (core::norm(level) > 0.0) g.azimuth_deg = axes.azimuth_deg(level);
  return g;
}

double ground_squint_deg(const core::Vec3& position_m, const core::Vec3& velocity_mps, const core::Vec3& point_m) {
  const core::Vec3 above = unit(position_m);
  const core::Vec3 ahead = unit(velocity_mps - core::dot(velocity_mps, above) * above);
  const core::Vec3 way = point_m - core::norm(point_m) * above;
  return core::deg_per_rad * std::atan2(core::dot(ahead, way), std::abs(core::dot(core::cross(above, ahead), way)));
}

raster::ReferenceGeometry reference_geometry(const raster::PhaseVector& v, bool bistatic) {
  raster::ReferenceGeometry g;
  g.srp_m = v.srp_m;
  g.bistatic = bistatic;
  const double out_m = core::norm(v.tx_m - v.srp_m), back_m = core::norm(v.rcv_m - v.srp_m);
  g.time_s = v.tx_time_s + out_m / (out_m + back_m) * (v.rcv_time_s - v.tx_time_s);
  const LocalAxes axes(v.srp_m);
  if (bistatic)
    put_bistatic(v, axes, g);
  else
    put_monostatic(0.5 * (v.tx_m + v.rcv_m), 0.5 * (v.tx_mps + v.rcv_mps), axes, g);
  return g;
}

}  // namespace sarsim::workflow

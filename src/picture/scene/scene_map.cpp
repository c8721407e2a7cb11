#include "picture/scene/scene_map.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::picture {

SceneMap::SceneMap(const scene::World& world, const std::vector<core::Vec3>& points_m)
    : earth_(scene::earth_of(world)), epoch_(scene::epoch_of(world).instant) {
  double sum_m = 0.0;
  for (const core::Vec3& point_m : points_m) sum_m += place_of(point_m).height_m;
  if (!points_m.empty()) ground_height_m_ = sum_m / static_cast<double>(points_m.size());
}

MapPlace SceneMap::place_of(const core::Vec3& point_m) const {
  if (!earth_) return {point_m.x, point_m.y, point_m.z};
  const radar::Geodetic place = earth_->geodetic_of(point_m);
  const double middle_rad = earth_->anchor().origin.longitude_rad;
  const double longitude_rad = middle_rad + std::remainder(place.longitude_rad - middle_rad, 2.0 * core::pi);
  return {core::deg_per_rad * longitude_rad, core::deg_per_rad * place.latitude_rad, place.height_m};
}

std::optional<double> SceneMap::way_to_plane(const core::Vec3& from_m, const core::Vec3& direction) const {
  const double way_m = (ground_height_m_ - from_m.z) / direction.z;
  if (!(from_m.z > ground_height_m_) || !(direction.z < 0.0) || !std::isfinite(way_m)) return std::nullopt;
  return way_m;
}

// The nearer root of |(x, y)/A|^2 + (z/B)^2 = 1 with both axes longer by the height. That surface is at most h f above
// the true one; Newton's steps on the height along the ray lead there.
std::optional<double> SceneMap::way_to_ellipsoid(const core::Vec3& from_m, const core::Vec3& direction) const {
  if (earth_->geodetic_of(from_m).height_m <= ground_height_m_) return std::nullopt;
  const double across_m = radar::wgs84_semi_major_m + ground_height_m_;
  const double up_m = radar::wgs84_semi_major_m * (1.0 - radar::wgs84_flattening) + ground_height_m_;
  const auto round = [&](const core::Vec3& v) { return core::Vec3{v.x / across_m, v.y / across_m, v.z / up_m}; };
  const core::Vec3 p = round(earth_->ecef_from_world(from_m));
  const core::Vec3 d = round(earth_->ecef_axes_from_world(direction));
  const double b = core::dot(p, d);
  const double root = b * b - core::dot(d, d) * (core::dot(p, p) - 1.0);
  if (!(root >= 0.0) || !(b < 0.0)) return std::nullopt;
  double way_m = (-b - std::sqrt(root)) / core::dot(d, d);
  for (int step = 0; step < 3; ++step) {
    const radar::Geodetic place = earth_->geodetic_of(from_m + way_m * direction);
    const double fall = -core::dot(direction, core::transposed(earth_->world_from_enu(place)).row[2]);
    if (!(fall > 1e-3)) break;  // It touches the ground: the first point is good enough.
    way_m += (place.height_m - ground_height_m_) / fall;
  }
  return way_m;
}

std::optional<core::Vec3> SceneMap::met_by(const core::Vec3& from_m, const core::Vec3& direction) const {
  const core::Vec3 unit = (1.0 / core::norm(direction)) * direction;
  const auto way_m = earth_ ? way_to_ellipsoid(from_m, unit) : way_to_plane(from_m, unit);
  if (!way_m) return std::nullopt;
  return from_m + *way_m * unit;
}

void SceneMap::name_axes(FigurePanel& panel) const {
  if (!earth_) {
    panel.x = {"x", "m", 0.0, 1.0, {}};
    panel.y = {"y", "m", 0.0, 1.0, {}};
    panel.y_per_x = 1.0;
    return;
  }
  panel.x = {"Longitude", "deg", 0.0, 1.0, {}};
  panel.y = {"Latitude", "deg", 0.0, 1.0, {}};
  const double latitude_rad = earth_->anchor().origin.latitude_rad;
  const radar::CurvatureRadii radii = radar::curvature_radii(latitude_rad);
  panel.y_per_x = radii.prime_vertical_m * std::cos(latitude_rad) / radii.meridian_m;
}

FigureAxis SceneMap::time_axis(double first_s, double last_s) const {
  FigureAxis axis{"Time", "s", first_s, last_s, {}};
  if (!epoch_) return axis;
  const radar::CivilTime date = radar::civil_of(radar::later(*epoch_, first_s), radar::TimeScale::utc);
  const radar::DayTime day = radar::day_time_of(*epoch_, radar::TimeScale::utc);
  axis.label = fmt::format("UTC on {:04}-{:02}-{:02}", date.year, date.month, date.day);
  axis.clock_s = static_cast<double>(day.second) + day.fraction_s;
  return axis;
}

std::string SceneMap::ground_words() const {
  const std::string height = core::format_number(std::round(ground_height_m_ * 10.0) / 10.0 + 0.0);
  return (earth_ ? "the ellipsoid at " : "the plane z = ") + height + " m";
}

std::string SceneMap::time_words(double time_s) const {
  if (!epoch_) return fmt::format("{:.4g} s", time_s + 0.0);
  const std::string text = radar::format_instant(radar::later(*epoch_, time_s), radar::TimeScale::utc, 2);
  return text.substr(text.find('T') + 1);
}

}  // namespace sarsim::picture

#include "picture/scene/ruler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "picture/scene/drawing_pen.hpp"

namespace sarsim::picture {

namespace {

constexpr double ruler_end_px = 9.0;
constexpr double ruler_line_px = 15.0;  // from line to line of the words
constexpr double level_part = 1e-6;     // of the length: a smaller difference of height is none

// A point of the ellipsoid by its place.
core::Vec3 on_ellipsoid(const radar::EarthFrame& earth, radar::Geodetic place) {
  place.height_m = 0.0;
  return earth.world_of(place);
}

// Along the ellipsoid: the arc over a chord of the circle whose radius is that of its curvature there.
double arc_m(const radar::EarthFrame& earth, const radar::Geodetic& from, const radar::Geodetic& to,
             double azimuth_rad) {
  const double chord_m = core::norm(on_ellipsoid(earth, to) - on_ellipsoid(earth, from));
  const double flattening = radar::wgs84_flattening;
  const double e2 = flattening * (2.0 - flattening);
  const double s = std::sin(0.5 * (from.latitude_rad + to.latitude_rad));
  const double w2 = 1.0 - e2 * s * s;
  const double prime_m = radar::wgs84_semi_major_m / std::sqrt(w2);
  const double meridian_m = radar::wgs84_semi_major_m * (1.0 - e2) / (w2 * std::sqrt(w2));
  const double c = std::cos(azimuth_rad);
  const double radius_m = 1.0 / (c * c / meridian_m + (1.0 - c * c) / prime_m);  // Euler's
  return 2.0 * radius_m * std::asin(std::min(1.0, 0.5 * chord_m / radius_m));
}

std::string ruler_length(double m) { return core::with_minus_sign(core::with_prefix(m, "m", 5)); }

std::string ruler_angle(double rad) {
  const double deg = rad * core::deg_per_rad;
  return fmt::format("{}{:.2f}°", deg < -0.005 ? "−" : "", std::abs(deg));
}

}  // namespace

RulerReading measured(const Ruler& ruler, const std::optional<radar::EarthFrame>& earth) {
  const core::Vec3 way = ruler.to_world_m - ruler.from_world_m;
  RulerReading reading;
  reading.distance_m = core::norm(way);
  if (!earth) {
    reading.ground_m = std::hypot(way.x, way.y);
    reading.height_m = way.z;
    reading.azimuth_rad = core::azimuth_rad(way);
    reading.elevation_rad = core::elevation_rad(way);
    return reading;
  }
  const radar::Geodetic from = earth->geodetic_of(ruler.from_world_m);
  const radar::Geodetic to = earth->geodetic_of(ruler.to_world_m);
  const core::Vec3 enu = core::transposed(earth->world_from_enu(from)) * way;
  reading.height_m = to.height_m - from.height_m;
  reading.azimuth_rad = core::azimuth_rad(enu);
  reading.elevation_rad = core::elevation_rad(enu);
  reading.ground_m = arc_m(*earth, from, to, reading.azimuth_rad);
  return reading;
}

std::vector<std::string> ruler_words(const RulerReading& reading) {
  const double azimuth = reading.azimuth_rad < 0.0 ? reading.azimuth_rad + 2.0 * core::pi : reading.azimuth_rad;
  return {ruler_length(reading.distance_m),
          fmt::format("ground {}  height {}", ruler_length(reading.ground_m), ruler_length(reading.height_m)),
          fmt::format("azimuth {}  elevation {}", ruler_angle(azimuth), ruler_angle(reading.elevation_rad))};
}

std::optional<int> ruler_end_at(const Ruler& ruler, const Camera& camera, double x_px, double y_px, double reach_px) {
  std::optional<int> nearest;
  double least = reach_px;
  for (const int end : {1, 0}) {
    const auto at = camera.project(end == 0 ? ruler.from_world_m : ruler.to_world_m);
    if (!at || std::hypot(at->x - x_px, at->y - y_px) > least) continue;
    least = std::hypot(at->x - x_px, at->y - y_px);
    nearest = end;
  }
  return nearest;
}

void draw_ruler(Pen& pen, const Ruler& ruler, const std::vector<std::string>& words) {
  const core::Vec3& from = ruler.from_world_m;
  const core::Vec3& to = ruler.to_world_m;
  const core::Vec3 below{to.x, to.y, from.z};
  if (std::abs(to.z - from.z) > level_part * core::norm(to - from)) {
    pen.world_line(from, below, Role::text, 1.0, true);
    pen.world_line(below, to, Role::text, 1.0, true);
  }
  pen.world_line(from, to, Role::text, 2.0);
  for (const core::Vec3& end : {from, to})
    if (const auto at = pen.project(end)) pen.disc(*at, ruler_end_px, Role::warning, true);
  const auto middle = pen.project(0.5 * (from + to));
  if (!middle) return;
  for (std::size_t i = 0; i < words.size(); ++i)
    pen.text(middle->x + pen.px(12.0), middle->y + pen.px(ruler_line_px * (static_cast<double>(i) - 0.5)), words[i],
             Role::text, i == 0, false);
}

}  // namespace sarsim::picture

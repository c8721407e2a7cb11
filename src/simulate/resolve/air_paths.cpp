#include "simulate/resolve/air_paths.hpp"

#include <cmath>
#include <limits>

#include "radar/earth/ellipsoid_height.hpp"
#include "radar/path/path.hpp"

namespace sarsim::simulate {

namespace {

constexpr double mean_radius_m = 6371000.0;
constexpr double per_tec_unit = 1e16;
constexpr double kg_per_g = 1e-3;
constexpr double tesla_per_microtesla = 1e-6;

radar::Atmosphere radar_atmosphere(const scene::Atmosphere& atmosphere) {
  radar::Atmosphere made;
  made.refraction = static_cast<radar::Refraction>(atmosphere.refraction);
  made.surface_refractivity = atmosphere.refractivity;
  made.scale_height_m = atmosphere.scale_height_m;
  made.k_factor = atmosphere.k_factor;
  made.gases = atmosphere.gases;
  made.surface_vapour_kg_per_m3 = atmosphere.vapour_g_per_m3 * kg_per_g;
  made.rain_rate_mm_per_h = atmosphere.rain_mm_per_h;
  made.rain_top_m = atmosphere.rain_top_m;
  made.polarisation_tilt_rad = atmosphere.polarisation.rad();
  made.vertical_tec_per_m2 = atmosphere.tec_units * per_tec_unit;
  made.shell_height_m = atmosphere.shell_height_m;
  made.field_along_path_t = atmosphere.field_ut * tesla_per_microtesla;
  return made;
}

core::Vec3 axis_of(const radar::TurningAxes& turning) {
  const double rate = core::norm(turning.rotation_rad_per_s);
  return rate > 0.0 ? (1.0 / rate) * turning.rotation_rad_per_s : core::Vec3{};
}

}  // namespace

bool is_on(const scene::Atmosphere& atmosphere) {
  return atmosphere.refraction != scene::Atmosphere::Refraction::none || atmosphere.gases ||
         atmosphere.rain_mm_per_h > 0.0 || atmosphere.tec_units > 0.0;
}

AirPaths::AirPaths(const scene::Atmosphere& atmosphere, double carrier_hz, double light_speed_mps,
                   const radar::TurningAxes& turning, radar::HeightSpan scatterers, radar::HeightSpan radars)
    : table_(radar_atmosphere(atmosphere), carrier_hz,
             turning.rotation_rad_per_s == core::Vec3{} ? std::numeric_limits<double>::infinity() : mean_radius_m,
             scatterers, radars),
      carrier_hz_(carrier_hz),
      light_speed_mps_(light_speed_mps),
      centre_m_(turning.centre_m),
      axis_(axis_of(turning)) {}

double AirPaths::height_m(const core::Vec3& point_m) const {
  return axis_ == core::Vec3{} ? point_m.z : radar::height_over_ellipsoid_m(point_m - centre_m_, axis_);
}

radar::StraightPath AirPaths::path(const core::Vec3& radar_m, const core::Vec3& point_m) const {
  return table_.path(height_m(point_m), height_m(radar_m), core::norm(point_m - radar_m));
}

double AirPaths::bending_m(const core::Vec3& radar_m, const core::Vec3& point_m) const {
  const radar::Atmosphere& air = table_.model().atmosphere();
  if (air.refraction == radar::Refraction::none) return 0.0;
  const radar::StraightPath way = path(radar_m, point_m);
  return air.refraction == radar::Refraction::exponential
             ? radar::bending_gain_m(table_.model().exponential(), way)
             : radar::bending_gain_m(
                   radar::LinearRefractivity{air.surface_refractivity, radar::gradient_of_k_per_m(air.k_factor)}, way);
}

double AirPaths::elevation_rad(const core::Vec3& radar_m, const core::Vec3& point_m) const {
  return radar::low_elevation_rad(path(radar_m, point_m));
}

radar::PathEffect AirPaths::one_way(const core::Vec3& radar_m, const core::Vec3& point_m) const {
  return table_.at(height_m(point_m), height_m(radar_m), core::norm(point_m - radar_m));
}

AirEffect AirPaths::between(const core::Vec3& radar_m, const core::Vec3& point_m, double carrier_hz) const {
  const radar::PathEffect one = one_way(radar_m, point_m);
  const double of_table = carrier_hz_ / carrier_hz;
  const double by_square = of_table * of_table;
  const double air_m = 0.5 * (one.delay_m + one.phase_m);
  const double electrons_m = by_square * 0.5 * (one.delay_m - one.phase_m);
  constexpr double db_per_amplitude = 20.0;
  return {radar::delay_of(air_m + electrons_m, light_speed_mps_),
          radar::turns_of(2.0 * electrons_m, carrier_hz, light_speed_mps_),
          std::pow(10.0, -2.0 * one.loss_db / db_per_amplitude) * std::cos(2.0 * by_square * one.faraday_rad)};
}

}  // namespace sarsim::simulate

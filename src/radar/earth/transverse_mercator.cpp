#include "radar/earth/transverse_mercator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/earth/extended.hpp"

namespace sarsim::radar {

namespace {

// The series' own letters.
namespace krueger {

constexpr long double flattening = 1.0L / 298.257223563L;  // the decimal number that defines the ellipsoid
constexpr long double eccentricity2 = flattening * (2.0L - flattening);
constexpr long double n = flattening / (2.0L - flattening);  // third flattening
constexpr long double n2 = n * n;
constexpr long double n3 = n2 * n;
constexpr long double n4 = n2 * n2;
constexpr long double n5 = n4 * n;
constexpr long double n6 = n3 * n3;

// Circumference of the meridian over 2 pi (Karney 14).
constexpr long double rectifying_radius_m =
    wgs84_semi_major_m / (1.0L + n) * (1.0L + n2 / 4.0L + n4 / 64.0L + n6 / 256.0L);

// Coefficients of sin 2j zeta' (Karney 35).
constexpr std::array<long double, 6> alpha{
    n / 2.0L - 2.0L * n2 / 3.0L + 5.0L * n3 / 16.0L + 41.0L * n4 / 180.0L - 127.0L * n5 / 288.0L +
        7891.0L * n6 / 37800.0L,
    13.0L * n2 / 48.0L - 3.0L * n3 / 5.0L + 557.0L * n4 / 1440.0L + 281.0L * n5 / 630.0L - 1983433.0L * n6 / 1935360.0L,
    61.0L * n3 / 240.0L - 103.0L * n4 / 140.0L + 15061.0L * n5 / 26880.0L + 167603.0L * n6 / 181440.0L,
    49561.0L * n4 / 161280.0L - 179.0L * n5 / 168.0L + 6601661.0L * n6 / 7257600.0L,
    34729.0L * n5 / 80640.0L - 3418889.0L * n6 / 1995840.0L,
    212378941.0L * n6 / 319334400.0L};

}  // namespace krueger

constexpr long double middle_scale = 0.9996L;
constexpr long double false_easting_m = 500'000.0L;
constexpr long double false_northing_m = 10'000'000.0L;
constexpr int zones = 60;

// On the map of the sphere that the ellipsoid is laid on conformally, and what the series adds to it.
struct SphereMap {
  long double north = 0.0L;  // xi'
  long double east = 0.0L;   // eta'
  long double convergence_rad = 0.0L;
  long double scale = 1.0L;
};

SphereMap sphere_map(const ExtendedTurn& latitude, const ExtendedTurn& longitude) {
  const long double e = std::sqrt(krueger::eccentricity2);
  // A latitude of pi/2 as a double has a cosine above 0.
  const long double t = latitude.sine / latitude.cosine;
  const long double s = std::sinh(e * std::atanh(e * latitude.sine));
  const long double conformal = t * std::hypot(1.0L, s) - s * std::hypot(1.0L, t);  // tan of the conformal latitude
  const long double width = std::hypot(conformal, longitude.cosine);
  SphereMap map;
  map.north = std::atan2(conformal, longitude.cosine);
  map.east = std::asinh(longitude.sine / width);
  map.convergence_rad = std::atan2(conformal * longitude.sine, std::hypot(1.0L, conformal) * longitude.cosine);
  map.scale = std::sqrt(1.0L - krueger::eccentricity2 * latitude.sine * latitude.sine) * std::hypot(1.0L, t) / width;
  return map;
}

// Longitude from the middle of a zone, in [-pi, pi].
long double from_middle_rad(double longitude_rad, int zone) {
  const long double middle_deg = 6.0L * zone - 183.0L;
  const long double degrees = std::numbers::pi_v<long double> / 180.0L;
  return std::remainder(longitude_rad - middle_deg * degrees, 360.0L * degrees);
}

}  // namespace

std::optional<int> utm_zone(const Geodetic& place) {
  const double latitude_deg = core::deg_per_rad * place.latitude_rad;
  const double longitude_deg = std::remainder(core::deg_per_rad * place.longitude_rad, 360.0);
  if (!(latitude_deg >= -80.0 && latitude_deg <= 84.0) || !std::isfinite(longitude_deg)) return std::nullopt;
  if (latitude_deg >= 56.0 && latitude_deg < 64.0 && longitude_deg >= 3.0 && longitude_deg < 12.0) return 32;
  if (latitude_deg >= 72.0 && longitude_deg >= 0.0 && longitude_deg < 42.0)
    return longitude_deg < 9.0 ? 31 : longitude_deg < 21.0 ? 33 : longitude_deg < 33.0 ? 35 : 37;
  const int zone = static_cast<int>(std::floor((longitude_deg + 180.0) / 6.0));
  return std::clamp(zone % zones, 0, zones - 1) + 1;
}

UtmPlace utm_of(const Geodetic& place, int zone, bool north) {
  CORE_EXPECT(zone >= 1 && zone <= zones);
  const long double longitude_rad = from_middle_rad(place.longitude_rad, zone);
  const SphereMap map =
      sphere_map(extended_turn(place.latitude_rad), {std::sin(longitude_rad), std::cos(longitude_rad)});
  long double xi = map.north;
  long double eta = map.east;
  long double p = 1.0L;
  long double q = 0.0L;
  for (std::size_t j = 0; j < krueger::alpha.size(); ++j) {
    const long double alpha = krueger::alpha[j];
    const auto order = 2.0L * static_cast<long double>(j + 1);
    const long double sine = std::sin(order * map.north);
    const long double cosine = std::cos(order * map.north);
    xi += alpha * sine * std::cosh(order * map.east);
    eta += alpha * cosine * std::sinh(order * map.east);
    p += order * alpha * cosine * std::cosh(order * map.east);
    q += order * alpha * sine * std::sinh(order * map.east);
  }
  const long double radius_m = middle_scale * krueger::rectifying_radius_m;
  UtmPlace on_map{zone, north};
  on_map.easting_m = static_cast<double>(false_easting_m + radius_m * eta);
  on_map.northing_m = static_cast<double>((north ? 0.0L : false_northing_m) + radius_m * xi);
  on_map.convergence_rad = static_cast<double>(map.convergence_rad + std::atan2(q, p));
  on_map.scale = static_cast<double>(radius_m / wgs84_semi_major_m * std::hypot(p, q) * map.scale);
  return on_map;
}

}  // namespace sarsim::radar

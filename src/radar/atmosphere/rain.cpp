#include "radar/atmosphere/rain.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace sarsim::radar {

namespace {

// A term a exp(-((lg f - b)/c)^2).
struct Bell {
  double a = 0.0;
  double b = 0.0;
  double c = 1.0;
};

// Tables 1 to 4 of P.838-3: k of horizontal and vertical, then alpha.
constexpr Bell k_horizontal[] = {{-5.33980, -0.10008, 1.13098},
                                 {-0.35351, 1.26970, 0.45400},
                                 {-0.23789, 0.86036, 0.15354},
                                 {-0.94158, 0.64552, 0.16817}};
constexpr Bell k_vertical[] = {{-3.80595, 0.56934, 0.81061},
                               {-3.44965, -0.22911, 0.51059},
                               {-0.39902, 0.73042, 0.11899},
                               {0.50167, 1.07319, 0.27195}};
constexpr Bell alpha_horizontal[] = {{-0.14318, 1.82442, -0.55187},
                                     {0.29591, 0.77564, 0.19822},
                                     {0.32177, 0.63773, 0.13164},
                                     {-5.37610, -0.96230, 1.47828},
                                     {16.1721, -3.29980, 3.43990}};
constexpr Bell alpha_vertical[] = {{-0.07771, 2.33840, -0.76284},
                                   {0.56727, 0.95545, 0.54039},
                                   {-0.20238, 1.14520, 0.26809},
                                   {-48.2991, 0.791669, 0.116226},
                                   {48.5833, 0.791459, 0.116479}};

double curve(std::span<const Bell> bells, double slope, double offset, double lg) {
  double sum = slope * lg + offset;
  for (const auto& [a, b, c] : bells) sum += a * std::exp(-(lg - b) * (lg - b) / (c * c));
  return sum;
}

}  // namespace

RainLaws rain_laws(double carrier_hz) {
  const double lg = std::log10(std::clamp(carrier_hz, 1e9, 1e12) * 1e-9);
  return {{std::pow(10.0, curve(k_horizontal, -0.18961, 0.71147, lg)), curve(alpha_horizontal, 0.67849, -1.95537, lg)},
          {std::pow(10.0, curve(k_vertical, -0.16398, 0.63297, lg)), curve(alpha_vertical, -0.053739, 0.83433, lg)}};
}

RainLaw rain_law(const RainLaws& laws, double sine, double tilt_rad) {
  const auto& [h, v] = laws;
  const double share = (1.0 - sine * sine) * std::cos(2.0 * tilt_rad);
  const double k = 0.5 * (h.k + v.k + (h.k - v.k) * share);
  const double product = h.k * h.alpha + v.k * v.alpha + (h.k * h.alpha - v.k * v.alpha) * share;
  return {k, 0.5 * product / k};
}

double rain_loss_db_per_m(const RainLaw& law, double rate_mm_per_h) {
  return rate_mm_per_h > 0.0 ? 1e-3 * law.k * std::pow(rate_mm_per_h, law.alpha) : 0.0;
}

double rain_loss_db(const UniformRain& rain, const RainLaws& laws, const StraightPath& path) {
  const double length_m = length_below_m(path, rain.top_m);
  if (length_m <= 0.0) return 0.0;
  const RainLaw law = rain_law(laws, climb_of(path).sine(), rain.tilt_rad);
  return rain_loss_db_per_m(law, rain.rate_mm_per_h) * length_m;
}

}  // namespace sarsim::radar

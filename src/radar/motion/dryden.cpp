#include "radar/motion/dryden.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

constexpr double metres_of_foot = 0.3048;
constexpr double mps_of_knot = 1852.0 / 3600.0;
constexpr double low_ft = 1000.0;
constexpr double high_ft = 2000.0;

double line(double x0, double y0, double x1, double y1, double x) { return y0 + (y1 - y0) * (x - x0) / (x1 - x0); }

Turbulence low_turbulence(double h_ft, TurbulenceSeverity severity) {
  constexpr std::array<double, 3> wind_at_20_ft_kn{15.0, 30.0, 45.0};
  const double wind_mps = wind_at_20_ft_kn[static_cast<std::size_t>(severity)] * mps_of_knot;
  const double share = 0.177 + 0.000823 * h_ft;
  const double sigma_w = 0.1 * wind_mps;
  const double sigma_u = sigma_w * std::pow(share, -0.4);
  const double length_u = h_ft / std::pow(share, 1.2) * metres_of_foot;
  return {sigma_u, sigma_u, sigma_w, length_u, length_u, h_ft * metres_of_foot};
}

// Figure 7: ft/s over ft, for probabilities of 1e-2, 1e-3, 1e-5.
double high_sigma_mps(double h_ft, TurbulenceSeverity severity) {
  constexpr std::array<double, 8> height{500, 1750, 3750, 7500, 15000, 25000, 35000, 45000};
  constexpr std::array<std::array<double, 8>, 3> sigma{{{6.6, 6.9, 7.4, 6.7, 4.6, 2.7, 0.4, 0.0},
                                                        {8.6, 9.6, 10.6, 10.1, 8.0, 6.6, 5.0, 4.2},
                                                        {15.6, 17.6, 23.0, 23.6, 22.1, 20.0, 16.0, 15.1}}};
  const auto& row = sigma[static_cast<std::size_t>(severity)];
  if (h_ft >= height.back()) return row.back() * metres_of_foot;
  std::size_t k = 0;
  while (k + 2 < height.size() && h_ft >= height[k + 1]) ++k;
  return line(height[k], row[k], height[k + 1], row[k + 1], h_ft) * metres_of_foot;
}

Turbulence high_turbulence(double h_ft, TurbulenceSeverity severity) {
  const double sigma = high_sigma_mps(h_ft, severity);
  constexpr double length = 1750.0 * metres_of_foot;
  return {sigma, sigma, sigma, length, length, length};
}

Turbulence between(const Turbulence& a, const Turbulence& b, double share) {
  const auto mix = [share](double x, double y) { return x + (y - x) * share; };
  return {mix(a.sigma_u_mps, b.sigma_u_mps), mix(a.sigma_v_mps, b.sigma_v_mps), mix(a.sigma_w_mps, b.sigma_w_mps),
          mix(a.length_u_m, b.length_u_m),   mix(a.length_v_m, b.length_v_m),   mix(a.length_w_m, b.length_w_m)};
}

}  // namespace

Turbulence turbulence_at(double height_m, TurbulenceSeverity severity) {
  const double h_ft = std::max(10.0, height_m / metres_of_foot);
  if (h_ft <= low_ft) return low_turbulence(h_ft, severity);
  if (h_ft >= high_ft) return high_turbulence(h_ft, severity);
  const Turbulence low = low_turbulence(low_ft, severity);
  return between(low, high_turbulence(high_ft, severity), (h_ft - low_ft) / (high_ft - low_ft));
}

double gust_envelope(const Gusts& gusts, double lag_s) {
  if (lag_s < 0.0) return 0.0;
  const double rate = gusts.airspeed_mps / gusts.length_m;
  const double x = rate * lag_s;
  if (gusts.form == GustForm::along) return gusts.sigma_mps * std::sqrt(2.0 * rate) * std::exp(-x);
  const double root = std::sqrt(3.0);
  return gusts.sigma_mps * std::sqrt(rate) * (root + (1.0 - root) * x) * std::exp(-x);
}

core::Interpolator gust_function(const Gusts& gusts) {
  CORE_EXPECT(gusts.airspeed_mps > 0.0 && gusts.length_m > 0.0);
  constexpr int steps = 256;
  constexpr double last_x = 8.0;
  core::SampledFunction function{core::Interpolation::cubic, {}};
  for (int i = 0; i <= steps; ++i) {
    const double lag = last_x * i / steps * gusts.length_m / gusts.airspeed_mps;
    function.knots.push_back({lag, gust_envelope(gusts, lag)});
  }
  return core::Interpolator(function, {core::LowPassRule::first_knot, core::CubicEnds::not_a_knot});
}

double gust_correlation(const Gusts& gusts, double lag_s) {
  const double x = gusts.airspeed_mps / gusts.length_m * std::abs(lag_s);
  return (gusts.form == GustForm::along ? 1.0 : 1.0 - 0.5 * x) * std::exp(-x);
}

}  // namespace sarsim::radar

#include "radar/motion/sea.hpp"

#include <array>
#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

namespace {

double peak_frequency(const Sea& sea) { return 2.0 * core::pi / sea.peak_period_s; }

}  // namespace

std::optional<Sea> sea_of_state(int state) {
  constexpr std::array<Sea, 9> seas{{{0.05, 3.0},
                                     {0.05, 3.0},
                                     {0.3, 7.5},
                                     {0.88, 7.5},
                                     {1.88, 8.8},
                                     {3.25, 9.7},
                                     {5.0, 12.4},
                                     {7.5, 15.0},
                                     {11.5, 16.4}}};
  if (state < 0 || state >= static_cast<int>(seas.size())) return std::nullopt;
  return seas[static_cast<std::size_t>(state)];
}

double wave_spectrum(const Sea& sea, double frequency_rad_per_s) {
  if (frequency_rad_per_s <= 0.0) return 0.0;
  const double hs = sea.significant_height_m;
  const double ratio4 = std::pow(peak_frequency(sea) / frequency_rad_per_s, 4);
  return 5.0 / 16.0 * hs * hs * ratio4 / frequency_rad_per_s * std::exp(-1.25 * ratio4);
}

double wave_variance_m2(const Sea& sea) { return sea.significant_height_m * sea.significant_height_m / 16.0; }

double zero_crossing_period_s(const Sea& sea) { return sea.peak_period_s / std::pow(1.25 * core::pi, 0.25); }

double frequency_of_share_rad_per_s(const Sea& sea, double share) {
  return peak_frequency(sea) * std::pow(1.25 / -std::log(share), 0.25);
}

std::vector<Wave> waves_of(const Sea& sea, int count, const core::RandomStream& stream) {
  std::vector<Wave> waves;
  for (int i = 0; i < count; ++i) {
    const auto [phase, place] = stream.uniforms(i, 0);
    const double share = (i + 0.25 + 0.5 * place) / count;
    waves.push_back({frequency_of_share_rad_per_s(sea, share), 2.0 * core::pi * phase, static_cast<double>(i) / count,
                     static_cast<double>(i + 1) / count});
  }
  return waves;
}

}  // namespace sarsim::radar

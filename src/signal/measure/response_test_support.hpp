#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace sarsim::signal::test {

/// What a straight cut through a point's response shows. Sidelobes count up to ten null distances from the peak.
struct CutFigures {
  double peak = 0.0;     ///< Place, in samples of the cut.
  double width = 0.0;    ///< At half power, in samples.
  double pslr_db = 0.0;  ///< Highest sidelobe over the peak.
  double islr_db = 0.0;  ///< Energy outside the first nulls over that inside.
  double height = 0.0;   ///< Magnitude of the peak.
};

/// Measures a cut sampled finely (ten samples or more to a width) about its highest value.
/// @param null_distance  of the theoretical response, in samples
inline CutFigures measure_cut(const std::vector<std::complex<double>>& cut, double null_distance) {
  std::vector<double> power;
  for (const auto& value : cut) power.push_back(std::norm(value));
  std::size_t top = 0;
  for (std::size_t i = 1; i < power.size(); ++i)
    if (power[i] > power[top]) top = i;
  CutFigures f;
  if (top < 2 || top + 2 >= power.size()) return f;
  const double bend = power[top - 1] - 2.0 * power[top] + power[top + 1];
  const double slope = 0.5 * (power[top + 1] - power[top - 1]);
  f.peak = static_cast<double>(top) - slope / bend;
  const double peak_power = power[top] - 0.5 * slope * slope / bend;
  f.height = std::sqrt(peak_power);
  const auto crossing = [&](long step) {
    auto i = static_cast<long>(top);
    while (i > 0 && i + 1 < static_cast<long>(power.size()) && power[static_cast<std::size_t>(i)] > 0.5 * peak_power)
      i += step;
    const double outer = power[static_cast<std::size_t>(i)];
    const double inner = power[static_cast<std::size_t>(i - step)];
    return static_cast<double>(i) - static_cast<double>(step) * (0.5 * peak_power - outer) / (inner - outer);
  };
  f.width = crossing(1) - crossing(-1);
  std::size_t left = top, right = top;
  while (left > 0 && power[left - 1] < power[left]) --left;
  while (right + 1 < power.size() && power[right + 1] < power[right]) ++right;
  double highest = 0.0, inside = 0.0, outside = 0.0;
  for (std::size_t i = 0; i < power.size(); ++i) {
    if (std::abs(static_cast<double>(i) - f.peak) > 10.0 * null_distance) continue;
    if (i > left && i < right) {
      inside += power[i];
      continue;
    }
    outside += power[i];
    highest = std::max(highest, power[i]);
  }
  f.pslr_db = 10.0 * std::log10(highest / peak_power);
  f.islr_db = 10.0 * std::log10(outside / inside);
  return f;
}

}  // namespace sarsim::signal::test

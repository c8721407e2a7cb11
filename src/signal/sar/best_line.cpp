#include "signal/sar/best_line.hpp"

#include <cstddef>

#include "core/report/expect.hpp"

namespace sarsim::signal {

StraightLine best_line(std::span<const double> x, std::span<const double> y, std::span<const double> weights) {
  CORE_EXPECT(x.size() == y.size());
  CORE_EXPECT(x.size() == weights.size());
  double sum = 0.0, mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += weights[i];
    mean_x += weights[i] * x[i];
    mean_y += weights[i] * y[i];
  }
  if (!(sum > 0.0)) return {};
  mean_x /= sum;
  mean_y /= sum;
  double spread = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    spread += weights[i] * (x[i] - mean_x) * (x[i] - mean_x);
    moment += weights[i] * (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double slope = spread > 0.0 ? moment / spread : 0.0;
  return {mean_y - slope * mean_x, slope};
}

}  // namespace sarsim::signal

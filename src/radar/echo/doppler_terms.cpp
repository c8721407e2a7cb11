#include "radar/echo/doppler_terms.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

std::size_t terms_for(double z, double error) {
  CORE_EXPECT(error > 0.0);
  double bound = 2.0;
  for (std::size_t terms = 1;; ++terms) {
    bound *= 0.5 * z / static_cast<double>(terms);
    if (bound < error || terms > max_doppler_terms) return terms;
  }
}

double largest_doppler_rad(const PulseBody& body, double carrier_hz) {
  return 2.0 * core::pi * body.largest_doppler_turns(carrier_hz);
}

double largest_bend_rad(const PulseBody& body, double carrier_hz) {
  const double farthest_s =
      std::max(std::abs(body.from_middle_s(body.first())), std::abs(body.from_middle_s(body.last())));
  return core::pi * std::abs(carrier_hz) * farthest_s * farthest_s;
}

std::size_t bend_terms_for(const PulseBody& body, double carrier_hz, double half, double error) {
  CORE_EXPECT(error > 0.0);
  const double rad = largest_bend_rad(body, carrier_hz) * half;
  return rad / std::sqrt(5.0) < error ? 1 : terms_for(rad, error);
}

double stretch_room(const EchoPulse& pulse, double interval_s) {
  CORE_EXPECT(interval_s > 0.0);
  constexpr double max_doppler = 1.1e-4;
  return pulse.doppler_rule == DopplerRule::thesis ? 0.0
                                                   : max_doppler * (pulse.last_s() - pulse.first_s()) / interval_s;
}

DopplerSpan span_covering(double lowest, double highest) {
  CORE_EXPECT(lowest <= highest);
  if (lowest == highest) return {lowest, 0.0};
  // Half spans are powers of two; middles are multiples of a quarter of that.
  double half = std::exp2(std::ceil(std::log2(0.5 * (highest - lowest))));
  for (;; half *= 2.0) {
    const double step = 0.25 * half;
    const double middle = std::round(0.5 * (lowest + highest) / step) * step;
    if (middle - half <= lowest && middle + half >= highest) return {middle, half};
  }
}

std::optional<DopplerSpan> span_within(double lowest, double highest, double half) {
  CORE_EXPECT(lowest <= highest);
  for (double step = half; step >= half / 16.0; step *= 0.5) {
    const double middle = std::round(0.5 * (lowest + highest) / step) * step;
    if (middle - half <= lowest && middle + half >= highest) return DopplerSpan{middle, half};
  }
  return std::nullopt;
}

DopplerSpan bends_covering(double lowest, double highest, double rad_per_bend, double error) {
  if (std::max(std::abs(lowest), std::abs(highest)) * rad_per_bend <= 0.25 * error) return {};
  const double step = 0.25 * error / rad_per_bend;
  const double half = 0.5 * (highest - lowest);
  if (half <= step) return {std::round(0.5 * (lowest + highest) / step) * step, 0.0};
  return span_covering(lowest, highest);
}

double allowance_for(double shift) {
  constexpr double trifle = 1.0 / 4096.0;
  return shift <= trifle ? 0.0 : std::exp2(std::ceil(std::log2(shift)));
}

}  // namespace sarsim::radar

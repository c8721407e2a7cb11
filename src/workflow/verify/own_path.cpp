#include "workflow/verify/own_path.hpp"

#include "core/maths/constants.hpp"

namespace sarsim::workflow::verify {

namespace {

constexpr long double light_speed = core::exact_light_speed_mps;
constexpr int max_iterations = 40;  // Each reduces the error by speed over c; the loop ends earlier.

// Solves x = f(x) for an f that hardly depends on x.
template <class Function>
long double fixed_point(const Function& f, long double x) {
  for (int i = 0; i < max_iterations; ++i) {
    const long double next = f(x);
    if (next == x) break;
    x = next;
  }
  return x;
}

}  // namespace

long double two_way_s(const Motion& radar, const Motion& point, long double sent_s) {
  const Place begin = radar(sent_s);
  const long double out_s =
      fixed_point([&](long double s) { return length_of(point(sent_s + s) - begin) / light_speed; }, 0.0L);
  const Place met = point(sent_s + out_s);
  return fixed_point([&](long double s) { return out_s + length_of(radar(sent_s + s) - met) / light_speed; },
                     2.0L * out_s);
}

std::complex<double> echo_received(const Motion& radar, const Motion& point, double middle_s, double after_send_s,
                                   double carrier_hz, double rate_hz_per_s) {
  const long double sent_s =
      fixed_point([&](long double e) { return after_send_s - two_way_s(radar, point, middle_s + e); }, 0.0L);
  const long double cycles = carrier_hz * (sent_s - after_send_s) + 0.5L * rate_hz_per_s * sent_s * sent_s;
  return std::polar(1.0, 2.0 * core::pi * static_cast<double>(std::remainder(cycles, 1.0L)));
}

}  // namespace sarsim::workflow::verify

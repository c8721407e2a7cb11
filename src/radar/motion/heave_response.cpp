#include "radar/motion/heave_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "radar/motion/level_turn.hpp"

namespace sarsim::radar {

namespace {

// Two states make the gust from white noise; the lagged speed; the displacement and its integral.
enum HeaveState : std::size_t { gust_1, gust_2, lagged, displaced, held, state_count };

using StateVector = std::array<double, state_count>;
using StateMatrix = std::array<StateVector, state_count>;

StateMatrix product_of(const StateMatrix& a, const StateMatrix& b) {
  StateMatrix c{};
  for (std::size_t i = 0; i < state_count; ++i)
    for (std::size_t k = 0; k < state_count; ++k)
      for (std::size_t j = 0; j < state_count; ++j) c[i][j] += a[i][k] * b[k][j];
  return c;
}

StateVector product_of(const StateMatrix& a, const StateVector& b) {
  StateVector c{};
  for (std::size_t i = 0; i < state_count; ++i)
    for (std::size_t k = 0; k < state_count; ++k) c[i] += a[i][k] * b[k];
  return c;
}

double largest_row_sum(const StateMatrix& a) {
  double largest = 0.0;
  for (const StateVector& row : a) {
    double sum = 0.0;
    for (const double x : row) sum += std::abs(x);
    largest = std::max(largest, sum);
  }
  return largest;
}

StateMatrix scaled(StateMatrix a, double factor) {
  for (StateVector& row : a)
    for (double& x : row) x *= factor;
  return a;
}

// exp(a): Taylor's series of a/2^n, whose norm is below 1/2 (16 terms: 1e-19), squared n times.
StateMatrix exponential(const StateMatrix& a) {
  int halvings = 0;
  while (std::ldexp(largest_row_sum(a), -halvings) > 0.5) ++halvings;
  const StateMatrix small = scaled(a, std::ldexp(1.0, -halvings));
  StateMatrix term{};
  for (std::size_t i = 0; i < state_count; ++i) term[i][i] = 1.0;
  StateMatrix sum = term;
  for (int n = 1; n <= 16; ++n) {
    term = scaled(product_of(term, small), 1.0 / n);
    for (std::size_t i = 0; i < state_count; ++i)
      for (std::size_t j = 0; j < state_count; ++j) sum[i][j] += term[i][j];
  }
  for (; halvings > 0; --halvings) sum = product_of(sum, sum);
  return sum;
}

// The gust as a combination of its two states.
std::array<double, 2> gust_weights(const Gusts& gusts, double rate) {
  if (gusts.form == GustForm::along) return {gusts.sigma_mps * std::sqrt(2.0 * rate), 0.0};
  const double root = std::sqrt(3.0);
  return {gusts.sigma_mps * std::sqrt(rate) * root, gusts.sigma_mps * std::sqrt(rate) * (1.0 - root)};
}

// Rates of change of the states, for both parts in series.
StateMatrix series_matrix(const Gusts& gusts, const HeaveResponse& r) {
  const double rate = gusts.airspeed_mps / gusts.length_m;
  const auto [c1, c2] = gust_weights(gusts, rate);
  const double w0 = r.hold_frequency_rad_per_s;
  StateMatrix a{};
  a[gust_1][gust_1] = -rate;
  a[gust_2][gust_1] = rate;  // gust_2 is x exp(-x)
  a[gust_2][gust_2] = -rate;
  a[lagged][gust_1] = c1 / r.lag_s;
  a[lagged][gust_2] = c2 / r.lag_s;
  a[lagged][lagged] = -1.0 / r.lag_s;
  a[displaced][lagged] = 1.0;
  a[displaced][displaced] = -2.0 * r.hold_damping * w0;
  a[displaced][held] = -w0 * w0;
  a[held][displaced] = 1.0;
  return a;
}

double slowest_s(const Gusts& gusts, const HeaveResponse& r) {
  const double z = r.hold_damping;
  const double decay = r.hold_frequency_rad_per_s * (z < 1.0 ? z : 1.0 / (z + std::sqrt(z * z - 1.0)));
  return std::max({gusts.length_m / gusts.airspeed_mps, r.lag_s, 1.0 / decay});
}

std::string fault_of(const Gusts& gusts, const HeaveResponse& r) {
  const auto positive = [](double x) { return x > 0.0 && std::isfinite(x); };
  if (!positive(gusts.airspeed_mps)) return "the airspeed is not positive";
  if (!positive(gusts.length_m)) return "the scale length of the gusts is not positive";
  if (!(gusts.sigma_mps >= 0.0 && std::isfinite(gusts.sigma_mps)))
    return "the standard deviation of the gusts is negative";
  if (!positive(r.lag_s)) return "the lag is not positive";
  if (!positive(r.hold_frequency_rad_per_s)) return "the frequency of the holding loop is not positive";
  if (!positive(r.hold_damping)) return "the damping of the holding loop is not positive";
  return {};
}

core::Interpolator cubic_through(std::vector<core::Knot> knots) {
  return core::Interpolator({core::Interpolation::cubic, std::move(knots)},
                            {core::LowPassRule::first_knot, core::CubicEnds::not_a_knot});
}

}  // namespace

double heave_lag_s(double wing_loading_pa, double density_kg_per_m3, double airspeed_mps, double lift_slope_per_rad) {
  return 2.0 * wing_loading_pa / (density_kg_per_m3 * standard_gravity_mps2 * airspeed_mps * lift_slope_per_rad);
}

GustMotion gust_motion(const Gusts& gusts, const HeaveResponse& response) {
  GustMotion motion;
  motion.fault = fault_of(gusts, response);
  if (!motion.fault.empty()) return motion;
  constexpr int steps = 2048;
  const double step = 12.0 * slowest_s(gusts, response) / steps;
  const StateMatrix rates = series_matrix(gusts, response);
  const StateMatrix onwards = exponential(scaled(rates, step));
  StateVector state{};
  state[gust_1] = 1.0;
  std::vector<core::Knot> displacement, velocity;
  double displacement_2 = 0.0, velocity_2 = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double speed = product_of(rates, state)[displaced];
    displacement.push_back({i * step, state[displaced]});
    velocity.push_back({i * step, speed});
    displacement_2 += step * state[displaced] * state[displaced];
    velocity_2 += step * speed * speed;
    state = product_of(onwards, state);
  }
  motion.displacement = cubic_through(std::move(displacement));
  motion.velocity = cubic_through(std::move(velocity));
  motion.displacement_rms_m = std::sqrt(displacement_2);
  motion.velocity_rms_mps = std::sqrt(velocity_2);
  return motion;
}

}  // namespace sarsim::radar

#include "radar/motion/sines.hpp"

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

namespace {

core::Jet jet_of(const Sine& sine, double time_s) {
  const double turns = sine.frequency_hz * time_s;
  const double phase = 2.0 * core::pi * (turns - std::round(turns)) + sine.phase_rad;
  const double omega = 2.0 * core::pi * sine.frequency_hz;
  const double value = sine.amplitude * std::sin(phase);
  return {value, sine.amplitude * omega * std::cos(phase), -omega * omega * value};
}

}  // namespace

SineState sines_at(const std::vector<Sine>& sines, double time_s) {
  SineState state;
  for (const Sine& sine : sines) {
    const auto axis = static_cast<std::size_t>(sine.axis);
    core::Jet& sum = axis < 3 ? state.position_m[axis] : state.rotation_rad[axis - 3];
    const core::Jet one = jet_of(sine, time_s);
    sum = {sum.value + one.value, sum.slope + one.slope, sum.curvature + one.curvature};
  }
  return state;
}

double acceleration_bound_mps2(const std::vector<Sine>& sines) {
  std::array<double, 3> bound{};
  for (const Sine& sine : sines) {
    const auto axis = static_cast<std::size_t>(sine.axis);
    const double omega = 2.0 * core::pi * sine.frequency_hz;
    if (axis < 3) bound[axis] += std::abs(sine.amplitude) * omega * omega;
  }
  return std::hypot(bound[0], bound[1], bound[2]);
}

double variance(const std::vector<Sine>& sines, SineAxis axis) {
  double sum = 0.0;
  for (const Sine& sine : sines)
    if (sine.axis == axis) sum += 0.5 * sine.amplitude * sine.amplitude;
  return sum;
}

}  // namespace sarsim::radar

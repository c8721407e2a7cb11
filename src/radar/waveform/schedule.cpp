#include "radar/waveform/schedule.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

constexpr double window_tolerance = 1e-9;  // of an interval (decision 19)
constexpr double largest_pulse = 9e15;     // pulse numbers stay exact in double

std::int64_t to_pulse(double number) {
  return static_cast<std::int64_t>(std::clamp(number, -largest_pulse, largest_pulse));
}

}  // namespace

Repetition Repetition::constant(double prf_hz) {
  CORE_EXPECT(prf_hz > 0.0);
  Repetition repetition;
  repetition.prf_hz_ = prf_hz;
  repetition.shortest_s_ = 1.0 / prf_hz;
  repetition.cycle_s_ = 1.0 / prf_hz;
  return repetition;
}

Repetition Repetition::intervals(std::vector<double> pri_s) {
  CORE_EXPECT(!pri_s.empty());
  CORE_EXPECT(std::ranges::all_of(pri_s, [](double interval_s) { return interval_s > 0.0; }));
  Repetition repetition;
  repetition.shortest_s_ = pri_s.empty() ? 0.0 : std::ranges::min(pri_s);
  for (const double interval : pri_s) {
    repetition.start_in_cycle_s_.push_back(repetition.cycle_s_);
    repetition.cycle_s_ += interval;
  }
  return repetition;
}

double Repetition::send_time_s(std::int64_t pulse) const {
  if (start_in_cycle_s_.empty()) return static_cast<double>(pulse) / prf_hz_;
  const auto length = static_cast<std::int64_t>(start_in_cycle_s_.size());
  const std::int64_t cycle = floor_divide(pulse, length);
  return static_cast<double>(cycle) * cycle_s_ + start_in_cycle_s_[static_cast<std::size_t>(wrapped(pulse, length))];
}

std::int64_t Repetition::cycle_pulses() const {
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(start_in_cycle_s_.size()));
}

std::int64_t Repetition::first_at_or_after(double time_s) const {
  const auto length = static_cast<std::int64_t>(start_in_cycle_s_.size());
  std::int64_t low = to_pulse((std::floor(time_s / cycle_s_) - 1.0) * static_cast<double>(length));
  std::int64_t high = low + 3 * length;
  while (low < high) {
    const std::int64_t middle = low + (high - low) / 2;
    if (send_time_s(middle) < time_s)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

PulseRange Repetition::pulses_in(double start_s, double end_s) const {
  CORE_EXPECT(!std::isnan(start_s) && !std::isnan(end_s));
  if (start_in_cycle_s_.empty())
    return {to_pulse(std::ceil(start_s * prf_hz_ - window_tolerance)),
            to_pulse(std::floor(end_s * prf_hz_ + window_tolerance))};
  const double tolerance_s = window_tolerance * shortest_s_;
  const std::int64_t first = first_at_or_after(start_s - tolerance_s);
  std::int64_t beyond = first_at_or_after(end_s + tolerance_s);
  if (send_time_s(beyond) <= end_s + tolerance_s) ++beyond;
  return {first, beyond - 1};
}

double Repetition::shortest_interval_s() const { return shortest_s_; }

double Repetition::mean_interval_s() const {
  return start_in_cycle_s_.empty() ? cycle_s_ : cycle_s_ / static_cast<double>(start_in_cycle_s_.size());
}

CarrierPlan CarrierPlan::single(double carrier_hz) {
  CORE_EXPECT(carrier_hz > 0.0);
  CarrierPlan plan;
  plan.start_hz_ = carrier_hz;
  return plan;
}

CarrierPlan CarrierPlan::stepped(double start_hz, double step_hz, int steps, int pulses_per_step) {
  CORE_EXPECT(steps >= 1);
  CORE_EXPECT(pulses_per_step >= 1);
  CarrierPlan plan;
  plan.start_hz_ = start_hz;
  plan.step_hz_ = step_hz;
  plan.steps_ = steps;
  plan.pulses_per_step_ = pulses_per_step;
  return plan;
}

CarrierPlan CarrierPlan::list(std::vector<double> carrier_hz) {
  CORE_EXPECT(!carrier_hz.empty());
  CarrierPlan plan;
  plan.list_hz_ = std::move(carrier_hz);
  return plan;
}

double CarrierPlan::carrier_hz(std::int64_t pulse) const {
  if (!list_hz_.empty())
    return list_hz_[static_cast<std::size_t>(wrapped(pulse, static_cast<std::int64_t>(list_hz_.size())))];
  const std::int64_t step = wrapped(pulse, std::int64_t{steps_} * pulses_per_step_) / pulses_per_step_;
  return start_hz_ + step_hz_ * static_cast<double>(step);
}

double CarrierPlan::lowest_hz() const {
  if (!list_hz_.empty()) return std::ranges::min(list_hz_);
  return std::min(start_hz_, start_hz_ + step_hz_ * (steps_ - 1));
}

double CarrierPlan::highest_hz() const {
  if (!list_hz_.empty()) return std::ranges::max(list_hz_);
  return std::max(start_hz_, start_hz_ + step_hz_ * (steps_ - 1));
}

}  // namespace sarsim::radar

#pragma once

#include <cstdint>
#include <vector>

namespace sarsim::radar {

/// Pulses first ... last, both included; `count()` is 0 where last < first.
struct PulseRange {
  std::int64_t first = 0;
  std::int64_t last = -1;

  [[nodiscard]] std::int64_t count() const { return last < first ? 0 : last - first + 1; }
};

/// When pulses leave. Pulse 0 leaves at t = 0; numbers may be negative (thesis 6.2.1).
class Repetition {
 public:
  /// Constant repetition frequency [Hz]: t(n) = n/PRF exactly.
  static Repetition constant(double prf_hz);
  /// Intervals [s] after pulses 0, 1, ... in turn, wrapping around in both directions.
  static Repetition intervals(std::vector<double> pri_s);

  /// t(n).
  [[nodiscard]] double send_time_s(std::int64_t pulse) const;

  /// Pulses with start <= t(n) <= end, each end widened by 1e-9 of an interval (decision 19).
  [[nodiscard]] PulseRange pulses_in(double start_s, double end_s) const;

  /// After so many pulses the intervals begin anew: 1 where all are the same.
  [[nodiscard]] std::int64_t cycle_pulses() const;
  /// The shortest time between two pulses.
  [[nodiscard]] double shortest_interval_s() const;
  /// The mean time between pulses.
  [[nodiscard]] double mean_interval_s() const;

 private:
  [[nodiscard]] std::int64_t first_at_or_after(double time_s) const;

  double prf_hz_ = 0.0;                   // constant
  std::vector<double> start_in_cycle_s_;  // intervals: sum of the intervals before each
  double cycle_s_ = 0.0;
  double shortest_s_ = 0.0;
};

/// The carrier of each pulse (thesis 6.2.6).
class CarrierPlan {
 public:
  /// One carrier for all pulses.
  static CarrierPlan single(double carrier_hz);
  /// f(n) = start + step floor((n mod S p)/p): S steps with p pulses each, wrapping around in both directions.
  static CarrierPlan stepped(double start_hz, double step_hz, int steps, int pulses_per_step);
  /// Entries in turn, wrapping around in both directions.
  static CarrierPlan list(std::vector<double> carrier_hz);

  /// f(n).
  [[nodiscard]] double carrier_hz(std::int64_t pulse) const;
  /// The lowest carrier of all pulses.
  [[nodiscard]] double lowest_hz() const;
  /// The highest carrier of all pulses.
  [[nodiscard]] double highest_hz() const;
  /// Frequency steps of a burst; 1 where the carrier is not stepped.
  [[nodiscard]] int steps() const { return steps_; }
  [[nodiscard]] double step_hz() const { return step_hz_; }
  [[nodiscard]] int pulses_per_step() const { return pulses_per_step_; }

 private:
  std::vector<double> list_hz_;
  double start_hz_ = 0.0;
  double step_hz_ = 0.0;
  int steps_ = 1;
  int pulses_per_step_ = 1;
};

/// n mod m in [0, m), also for negative n.
[[nodiscard]] constexpr std::int64_t wrapped(std::int64_t n, std::int64_t m) { return ((n % m) + m) % m; }
/// floor(n/m) for m > 0, also for negative n.
[[nodiscard]] constexpr std::int64_t floor_divide(std::int64_t n, std::int64_t m) { return (n - wrapped(n, m)) / m; }

}  // namespace sarsim::radar

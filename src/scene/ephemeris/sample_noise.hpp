#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/maths/vector.hpp"
#include "radar/orbit/state_polynomial.hpp"

namespace sarsim::scene {

/// The noise of vectors that are samples of something smooth, judged from the samples alone.
///
/// A difference of order n of neighbouring samples, divided by the root of the sum of the squares of its weights, is as
/// large as the noise of one sample; what is smooth falls from order to order. Noise is where the root mean square of
/// 17 neighbouring differences, of orders 2, 4, ... 16, falls by less than a tenth. Samples that are off by turns, and
/// bends between two samples, count as noise. At 3.5 samples a period or more a vibration is none.
class SampleNoise {
 public:
  /// Keeps views.
  /// @param time_s  ascending
  SampleNoise(std::span<const double> time_s, std::span<const core::Vec3> values) : time_s_(time_s), values_(values) {}

  /// The order of differences that is noise around a sample; nothing where all of them fall: no noise is seen.
  [[nodiscard]] std::optional<std::size_t> order_around(std::size_t sample) const;

  /// Whether the samples around one are off by turns: their highest differences are alike, and point to either side.
  [[nodiscard]] bool is_by_turns(std::size_t sample) const;

  /// The size of the difference of an order around one sample: the noise of one sample, all directions together.
  [[nodiscard]] double size(std::size_t sample, std::size_t order) const;

 private:
  [[nodiscard]] core::Vec3 difference(std::size_t first, std::size_t order) const;
  [[nodiscard]] std::pair<std::size_t, std::size_t> neighbours(std::size_t sample, std::size_t order) const;
  [[nodiscard]] double mean_size(std::size_t sample, std::size_t order) const;

  std::span<const double> time_s_;
  std::span<const core::Vec3> values_;
};

/// What states of a motion are off, each by itself.
struct StateNoise {
  double position_m = 0.0;
  double velocity_mps = 0.0;
};

/// Estimates what states are off: noise of positions and of velocities, no more than polynomials through both differ by
/// where they go through more and more states (but for states that are off by turns), and what
/// `ephemeris::examine_states` calls odd, which is asked for up to 20 000 states.
class StateNoises {
 public:
  /// Keeps a view.
  explicit StateNoises(const radar::StateView& states);

  /// Of some states, which lie around an interval.
  /// @param left  the state where the interval begins
  [[nodiscard]] std::vector<StateNoise> around(std::size_t left, std::span<const std::size_t> states) const;

 private:
  struct Limits {
    double position_m = 0.0;
    double velocity_mps = 0.0;
  };
  [[nodiscard]] Limits limits(std::size_t sound) const;

  radar::StateView states_;
  std::vector<StateNoise> odd_;     // by state
  std::vector<std::size_t> sound_;  // by state: its number among those that are not odd
  std::vector<char> is_odd_;
  std::vector<double> time_s_;  // of those that are not odd
  std::vector<core::Vec3> position_m_;
  std::vector<core::Vec3> velocity_mps_;
};

}  // namespace sarsim::scene

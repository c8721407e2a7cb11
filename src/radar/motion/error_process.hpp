#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/maths/interpolator.hpp"
#include "core/maths/random.hpp"

namespace sarsim::radar {

/// A Gaussian random deviation in time with a given integration envelope (decision 16):
///
///     d(t) = integral of h(u) w(t - u) du,
///
/// w unit white noise, h the user's function of the lag u [s], 0 outside its points. Variance: integral of h^2;
/// autocorrelation at lag s: integral of h(u) h(u + s) du.
///
/// Realised on a grid that is anchored at t = 0 and has 512 steps over the support of h: white noise becomes one
/// normal number per step, h its mean over each step, and d(t) is linear between grid times. The autocorrelation is
/// then that of h to a relative 1/512 times the largest jump of h over its rms value, squared; smooth envelopes are
/// far closer. The same (seed, object, time) always gives the same deviation. Costs about 512 random numbers a call.
///
/// A smooth process is a cubic between grid times instead, with the derivative that h has there: that of the same
/// noise, constant over each step. Its velocity is continuous, and h must vanish at its ends.
///
/// The deviation has a derivative where h is continuous everywhere: where it vanishes at its first and last point. At a
/// jump of h the speed is white noise, without a variance of its own (the grid would give it one of jump^2
/// 512/support); it is left out, the slope of such a deviation is 0. A jump of at most 1/100 of the largest |h| counts
/// as none: it adds below 1/20 to the variance that a triangle's speed has.
class ErrorProcess {
 public:
  ErrorProcess() = default;
  /// @param envelope  h; fewer than two knots: no deviation at all.
  /// @param axis      0, 1 or 2: which of the object's independent noises drives it.
  /// @param smooth    whether the velocity is continuous.
  ErrorProcess(const core::Interpolator& envelope, const core::RandomStream& stream, int axis, bool smooth = false);

  /// The grid step of the last call and the deviations at its ends: calls within one step need no random numbers again.
  struct Step {
    double below = std::numeric_limits<double>::quiet_NaN();  ///< Number of the step's left end; NaN: none yet.
    double left = 0.0;
    double right = 0.0;
    double left_slope = 0.0;  ///< Of a smooth process.
    double right_slope = 0.0;
  };

  /// Deviation at time t and its slope (to the right at grid times; 0 where h jumps). Curvature 0: straight lines, but
  /// for a smooth process.
  [[nodiscard]] core::Jet at(double time_s) const;
  /// The same, and faster where `step` is that of a call near in time.
  [[nodiscard]] core::Jet at(double time_s, Step& step) const;
  [[nodiscard]] bool active() const { return !weights_.empty(); }

 private:
  [[nodiscard]] Step step_from(double below) const;
  [[nodiscard]] core::Jet on_cubic(const Step& step, double share) const;

  std::vector<double> weights_;        // mean of h over each lag step times sqrt(step)
  std::vector<double> slope_weights_;  // of a smooth process: difference of h over each lag step by sqrt(step)
  std::int64_t first_lag_ = 0;         // lag of weights_[0], in steps
  double step_s_ = 1.0;
  bool differentiable_ = false;
  core::RandomStream stream_{0, core::RandomKind::position_envelope, 0};
  int axis_ = 0;
};

}  // namespace sarsim::radar

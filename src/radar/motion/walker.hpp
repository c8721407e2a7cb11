#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/maths/sampled_function.hpp"
#include "core/maths/vector.hpp"
#include "radar/motion/gait_curve.hpp"

namespace sarsim::radar {

/// The points of a walking body, in the order of `WalkerBody`.
enum class BodyPart : std::size_t {
  head,
  neck,
  left_shoulder,
  right_shoulder,
  left_elbow,
  right_elbow,
  left_hand,
  right_hand,
  spine,
  left_hip,
  right_hip,
  left_knee,
  right_knee,
  left_ankle,
  right_ankle,
  left_toe,
  right_toe,
};

inline constexpr std::size_t body_part_count = 17;

/// The part's name: "left knee".
[[nodiscard]] const char* name_of(BodyPart part);

/// Positions of all parts, in m: x ahead, y to the left, z up from the ground. The walker goes along x.
using WalkerBody = std::array<core::Vec3, body_part_count>;

/// Who walks, and how fast.
struct Walker {
  double height_m = 1.8;        ///< 0.4 to 2.8.
  double relative_speed = 1.0;  ///< RV: speed over the length of the leg per second; above 0, at most 3.
};

/// Speed and times of a walk (Boulic, Thalmann, Thalmann: "A global human walking model with real-time kinematic
/// personification", The Visual Computer 6, 1990).
struct Gait {
  double leg_m = 0.0;      ///< From hip to ankle: (0.245 + 0.246) height.
  double speed_mps = 0.0;  ///< RV leg, per second.
  double cycle_s = 0.0;    ///< Of two steps: 1.346/sqrt(RV).
  double support_s = 0.0;  ///< Of each foot on the ground in a cycle: 0.752 cycle - 0.143.
};

/// The gait of a walker.
[[nodiscard]] Gait gait_of(const Walker& walker);

/// The walker of a height who walks at a speed.
[[nodiscard]] Walker walker_at(double height_m, double speed_mps);

/// What is wrong with a walker; empty where nothing is.
[[nodiscard]] std::string fault_of(const Walker& walker);

/// A body that walks after that model; a skeleton of rigid bones.
///
/// Six movements of the trunk and the angles of hips, knees, ankles, elbows, shoulders and thorax are the model's
/// curves, with its points joined by GaitCurve. The right heel strikes at time 0; the left side is half a cycle later.
/// The mean speed along x is that of the gait, exactly; the rest repeats with each cycle. Simplifications: legs and
/// arms swing in planes along x, trunk and head do not bend, and the feet are not held by the ground: they slide by
/// some centimetres while they support. The body stands so high that its lowest foot touches the ground at its lowest.
class WalkingBody {
 public:
  /// @param walker  without fault
  explicit WalkingBody(const Walker& walker);

  /// The parts at a time; at time 0 the spine is near x = 0.
  [[nodiscard]] WalkerBody at(double time_s) const;
  /// The same in a frame that moves ahead with the walker's mean speed: it repeats with each cycle.
  [[nodiscard]] WalkerBody cyclic(double time_s) const;
  [[nodiscard]] const Gait& gait() const { return gait_; }
  /// The largest speed of any part, over the ground; that of the toes.
  [[nodiscard]] double fastest_mps() const;

 private:
  [[nodiscard]] WalkerBody at_phase(double phase) const;
  void add_leg(WalkerBody& body, double phase, bool left) const;
  void add_arm(WalkerBody& body, double phase, bool left) const;

  Walker walker_;
  Gait gait_;
  GaitCurve hip_, knee_, ankle_, elbow_, thorax_;  // in degrees over the share of a cycle
  double floor_m_ = 0.0;                           // height of the spine without its movement
};

/// Of each part x, y and z in m over time.
using WalkerTracks = std::array<std::array<core::SampledFunction, 3>, body_part_count>;

/// Points of `cyclic` over one cycle for motion files, from time 0: `steps` + 1 of them, the last equal to the first.
/// Cubics through 200 steps are within 0.15 mm.
[[nodiscard]] WalkerTracks sampled_cycle(const WalkingBody& body, int steps);

}  // namespace sarsim::radar

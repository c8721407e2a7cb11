#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/maths/random.hpp"
#include "radar/motion/error_process.hpp"
#include "radar/motion/motion.hpp"
#include "radar/motion/pose.hpp"
#include "radar/motion/rotation.hpp"

namespace sarsim::radar {

/// A platform's motion, ready to be evaluated. Const members are safe to call from many threads.
class Track {
 public:
  /// @param name  of the platform: the key of its random deviations.
  Track(Motion motion, std::uint64_t seed, const std::string& name);

  /// The pose when pulse `pulse` is sent at `time_s`. The alignment follows the nominal path, without sines and errors.
  /// The velocity is the analytic derivative; where a path bends it is the one to the right (decision 4).
  ///
  /// With axes of an attitude law or with a parent the angles are those of the whole rotation, from its matrix: roll
  /// and yaw in [-pi, pi], pitch in [-pi/2, pi/2]; see `rotation_angles_rad` for gimbal lock.
  [[nodiscard]] Pose at(double time_s, std::int64_t pulse) const;

  /// Steps of the motion errors that were last in use: calls near in time share them. One for each thread and track.
  struct ErrorSteps {
    std::array<ErrorProcess::Step, 3> position;
    std::array<ErrorProcess::Step, 3> rotation;
    std::vector<ErrorSteps> of_parent;  ///< One, or none where none were needed yet.
  };
  /// The same, and faster where motion errors have envelopes.
  [[nodiscard]] Pose at(double time_s, std::int64_t pulse, ErrorSteps& steps) const;
  /// Position and velocity of `at` alone: much faster without a parent.
  [[nodiscard]] Travel travel_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const;

  /// How the pose of `at` changes its motion: its analytic second derivatives, to the right where a path bends. 0 from
  /// straight lines, motion errors among them. The jitter of pulse `pulse` turns the platform and so its derivatives.
  ///
  /// Exact where jerk and snap of the path are. What a StatePath lacks (1e-8 m/s^3 of jerk, all of the snap) reaches
  /// the turning alone: below 1e-11 1/s^2 for the attitude laws of a satellite.
  [[nodiscard]] PoseAcceleration acceleration_at(double time_s, std::int64_t pulse) const;
  /// The same where the pose of `at` with that time and pulse is known: faster.
  [[nodiscard]] PoseAcceleration acceleration_at(double time_s, std::int64_t pulse, const Pose& pose,
                                                 ErrorSteps& steps) const;

  /// No acceleration of the origin in `acceleration_at` exceeds this; infinity where it is not known beforehand.
  [[nodiscard]] double acceleration_bound_mps2() const { return acceleration_bound_mps2_; }
  /// True where the platform may turn as time passes.
  [[nodiscard]] bool turns() const { return turns_; }
  /// True where the pose is the same at every time and for every pulse.
  [[nodiscard]] bool fixed() const { return fixed_; }

 private:
  using PathJets = std::array<core::Jet, 3>;

  void note_own_turning();
  void note_carried();
  [[nodiscard]] double own_acceleration_bound_mps2() const;

  [[nodiscard]] Pose carried_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const;
  [[nodiscard]] Travel carried_travel_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const;

  // In the frame of the motion: without the parent.
  [[nodiscard]] Pose own_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const;
  [[nodiscard]] Pose rotated_at_0() const;
  [[nodiscard]] Travel travel_along(const PathJets& path, double time_s, std::int64_t pulse, ErrorSteps& steps) const;
  void add_sines_and_errors(Travel& travel, const PathJets& path, double time_s, ErrorSteps& steps) const;
  void add_rotation(Pose& pose, const PathJets& path, double time_s, std::int64_t pulse, ErrorSteps& steps) const;
  void add_angles(Pose& pose, const PathJets& path, double time_s, std::int64_t pulse, ErrorSteps& steps) const;
  void add_bank_and_sines(Pose& pose, double time_s) const;
  void turn_within_axes(Pose& pose, const PathJets& path, double time_s) const;
  [[nodiscard]] PoseAcceleration own_acceleration_at(double time_s, std::int64_t pulse, const Pose& pose,
                                                     ErrorSteps* steps) const;
  [[nodiscard]] core::Vec3 added_acceleration_mps2(const PathJets& path, double time_s, ErrorSteps* steps) const;
  void add_bank_and_sines_to(std::array<double, 3>& angle_accelerations, const PathJets& path, double time_s) const;
  [[nodiscard]] core::Mat3 acceleration_within_axes(const PathJets& path, double time_s, std::int64_t pulse,
                                                    const std::array<double, 3>& angle_accelerations,
                                                    ErrorSteps* steps) const;

  Motion motion_;
  core::RandomStream position_noise_;
  core::RandomStream rotation_noise_;
  std::array<ErrorProcess, 3> position_process_;
  std::array<ErrorProcess, 3> rotation_process_;
  double acceleration_bound_mps2_ = 0.0;
  bool turns_ = false;
  bool fixed_ = false;
  bool own_turns_ = false;
  bool own_shakes_ = false;     // its own rotation has jitter
  bool aligned_ = false;        // its own angles follow the velocity
  bool has_axes_ = false;       // its attitude law has axes, within which its own angles turn it
  bool errors_along_ = false;   // it has along_process_
  bool adds_travel_ = false;    // it has position_sines_ or along_process_
  bool adds_rotation_ = false;  // it has a bank or rotation_sines_
  Pose attitude_;               // of its own where it neither turns nor shakes; the whole pose where it is fixed
  std::vector<Sine> position_sines_;
  std::vector<Sine> rotation_sines_;
  std::array<ErrorProcess, 3> along_process_;  // instead of position_process_ where errors follow the path
};

}  // namespace sarsim::radar

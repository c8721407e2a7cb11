#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/task/parallel.hpp"
#include "signal/sar/focusing.hpp"
#include "signal/sar/sar_track.hpp"
#include "simulate/plan/acquisition.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "workflow/focus/matched_filter_coverage.hpp"

namespace sarsim::workflow {

/// Scenes of more targets are not examined target by target before they are focused.
inline constexpr std::size_t max_examined_targets = 4096;

/// One pulse's sight of one target, as focusing takes it: from where the antenna was, or, where its motion is
/// compensated, from the nearest point of the straight line.
struct TargetAspect {
  double time_s = 0.0;  ///< From the track's middle.
  double distance_m = 0.0;
  double doppler_hz = 0.0;
  double delay_s = 0.0;
  double amplitude = 0.0;  ///< Of the whole compressed echo, volts.
  double share = 0.0;      ///< Of it that is recorded, 0 to 1.
  /// What the atmosphere adds to distance and Doppler frequency, which hold it; and by how much the carrier is ahead of
  /// the delay.
  double late_m = 0.0;
  double air_doppler_hz = 0.0;
  double ahead_turns = 0.0;

  /// The same without atmosphere, as far as places are concerned.
  [[nodiscard]] TargetAspect in_vacuum() const;
};

/// The pulses of a plan as looks at each of its targets; of more than `max_looks` pulses, some that are evenly spaced,
/// of more than 4096 targets fewer still, but 65 at least. Of a cloud of more than 4096 points, as many that are evenly
/// chosen stand for all. They are computed when they are asked for, a few targets at
/// a time.
class TargetAspects {
 public:
  static constexpr std::size_t usual_looks = 2048;

  /// Keeps a reference to the acquisition.
  /// @param echoes  their track, their window, and whether they are compensated to the track's line; no rows are read
  /// @param weight  of the compressing filter over the pulse; even where there is none
  TargetAspects(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                const signal::WindowFunction& weight = {}, std::size_t max_looks = usual_looks);

  [[nodiscard]] std::size_t targets() const { return scene_->scatterers.size(); }
  /// Looks at each target.
  [[nodiscard]] std::size_t count() const { return (pulses_ + step_ - 1) / step_; }
  [[nodiscard]] const signal::StraightTrack& track() const { return track_; }
  /// Pulse of the echoes that look number i is at.
  [[nodiscard]] std::size_t pulse(std::size_t i) const { return i * step_; }

  /// Calls `body` with each target, counted from 0, or each `every`-th one, and `count()` looks at it, from many
  /// threads at once.
  /// @throw  Interrupted
  void each(const core::WorkControl& control,
            const std::function<void(std::size_t target, std::span<const TargetAspect> seen)>& body,
            std::size_t every = 1) const;

  /// Position of the antenna at each look, as the pulse left, world.
  [[nodiscard]] std::vector<core::Vec3> antennas() const;
  /// Position, world, of a target that does not move between the first and the last look; nothing for one that does.
  [[nodiscard]] std::optional<core::Vec3> resting_place(std::size_t target) const;

  /// Where echoes of this look are focused to when they are taken to have that Doppler frequency.
  [[nodiscard]] signal::ImagePlace place(const TargetAspect& look, double doppler_hz) const;

 private:
  [[nodiscard]] TargetAspect look_at(std::size_t target, std::size_t pulse, const simulate::PulseGeometry& geometry,
                                     const radar::Pointing& pointing) const;
  [[nodiscard]] TargetAspect from_line(TargetAspect look, const radar::Pose& radar, const radar::Pose& platform,
                                       const core::Vec3& point_m) const;
  [[nodiscard]] TargetAspect through(const simulate::AirPaths& air, TargetAspect look, const radar::Pose& radar,
                                     const radar::Pose& platform, const core::Vec3& point_m) const;

  const simulate::Acquisition& acquisition_;
  std::shared_ptr<const simulate::ResolvedScene> scene_;
  signal::StraightTrack track_;
  MatchedFilterCoverage gain_;
  double peak_gain_ = 1.0;
  double carrier_hz_ = 0.0;
  std::size_t pulses_ = 0;
  std::size_t step_ = 1;
  bool compensated_ = false;
  std::array<std::vector<radar::Pose>, 3> first_middle_last_;  // of platforms, at three looks
};

/// Mean Doppler frequency of the echoes as seen from the line that fits the track, weighted by their power, Hz: the
/// Doppler centroid after motion compensation. With sway it differs from the mean of the received echoes. Nothing if
/// there are no echoes.
/// @throw  Interrupted
[[nodiscard]] std::optional<double> line_doppler_centroid_hz(const simulate::Acquisition& acquisition,
                                                             signal::EchoRows echoes,
                                                             const core::WorkControl& control = {});

}  // namespace sarsim::workflow

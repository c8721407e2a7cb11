#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "radar/echo/echo_batch.hpp"
#include "radar/echo/view_geometry.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// One scatterer as one pulse of a radar sees it.
struct ScattererView {
  double distance_m = 0.0;        ///< One way, as the pulse leaves.
  double speed_mps = 0.0;         ///< At which a point recedes along the line of sight whose echo is stretched alike.
  double delay_s = 0.0;           ///< Two-way light time (docs/theory/echo-model.md), that of the group.
  radar::PulseClock clock;        ///< How the echo is stretched.
  double amplitude_sqrt_w = 0.0;  ///< Radar equation (thesis 2.2, 6.13-6.15), with antenna, cross-section and losses.
  double incidence_rad = 0.0;     ///< From its normal; only if the reflectivity depends on it.
  /// By how much the carrier is ahead of that delay: its phase is -(f delay - ahead) turns.
  double ahead_turns = 0.0;

  /// Two-way delay that the carrier's phase is that of, s.
  [[nodiscard]] double phase_delay_s(double carrier_hz) const { return delay_s - ahead_turns / carrier_hz; }
};

/// Where everything stands when each pulse of one radar leaves. Not shared between threads: each makes its own.
class PulseGeometry {
 public:
  /// Keeps references; both must outlive it.
  PulseGeometry(const ResolvedScene& scene, const Link& radar);

  /// Moves to a pulse: poses, pointing, carrier.
  void set_pulse(std::int64_t pulse);

  [[nodiscard]] std::int64_t pulse() const { return pulse_; }
  [[nodiscard]] double send_time_s() const { return time_s_; }
  [[nodiscard]] double carrier_hz() const { return carrier_hz_; }
  /// The atmosphere between radar and scatterers; null without one.
  [[nodiscard]] const AirPaths* air() const { return radar_->air.get(); }
  /// Whether the phase of any echo may be ahead of its delay, as an ionosphere makes it.
  [[nodiscard]] bool advances() const { return radar_->air != nullptr && radar_->air->advances(); }
  [[nodiscard]] const radar::Pose& radar_pose() const { return poses_[slot_of_[radar_->platform]]; }
  /// Where a platform with targets or surfaces stands as the pulse leaves.
  [[nodiscard]] const radar::Pose& pose(std::size_t platform) const { return poses_[slot_of_[platform]]; }
  /// How a platform with targets or surfaces moves while the current pulse is under way; without antenna.
  [[nodiscard]] const radar::ViewFrame& frame(std::size_t platform) const { return frames_[slot_of_[platform]]; }
  /// Whether the bend of any echo of the current pulse counts, against the scene's tolerance.
  [[nodiscard]] bool bends() const { return bends_; }
  /// Where the beam points at the current pulse.
  [[nodiscard]] radar::Pointing pointing() const;
  /// sqrt(P Gt Gr/L) lambda/(4 pi)^1.5 of the current pulse; what the amplitude is besides pattern, cross-section and
  /// range.
  [[nodiscard]] double amplitude_scale() const { return amplitude_scale_; }
  /// Whether amplitudes fall with the distance squared (not so with the classic STC).
  [[nodiscard]] bool has_range_loss() const { return range_loss_; }

  /// Target `index` of the scene at the current pulse.
  [[nodiscard]] ScattererView view(std::size_t index) const;
  /// Same, with the pointing at hand.
  [[nodiscard]] ScattererView view(std::size_t index, const radar::Pointing& pointing) const;

  /// Point `point` of surface `sheet` at the current pulse; nothing where it shows the radar its back or its edge.
  [[nodiscard]] std::optional<ScattererView> sheet_view(std::size_t sheet, std::size_t point,
                                                        const radar::Pointing& pointing) const;

  /// All echoes of the current pulse: targets in order, then the points of the surfaces. Replaces `echoes`.
  /// Throws ImpossibleEcho where a target stands at the radar's own position, outruns light or is too strong.
  void echoes(radar::EchoBatch& echoes) const;
  /// Throws the error that `echoes` throws where a view is none of a possible echo.
  /// @param kind  "target" or "surface", number `index` of its list
  void expect_possible(std::string_view kind, std::size_t index, const ScattererView& view) const;

 private:
  struct Sight;  // the way to a point and home
  void set_frame(std::size_t slot);
  void set_flight(std::size_t platform, radar::ViewFrame& frame);
  void set_bend(std::size_t platform, radar::ViewFrame& frame);
  void set_bend_at_rest(std::size_t platform, radar::ViewFrame& frame) const;
  [[nodiscard]] radar::Pose at_rest(const radar::Pose& pose, double elapsed_s) const;
  [[nodiscard]] bool bend_counts(std::size_t platform, const radar::ViewFrame& frame, double platform_mps2,
                                 double radar_mps2) const;
  [[nodiscard]] Sight sight_of(std::size_t platform, const core::Vec3& point_m, const core::Vec3& undisturbed_m) const;
  [[nodiscard]] ScattererView seen(const Sight& sight, double rcs_m2, const radar::Pointing& pointing) const;
  [[nodiscard]] core::Vec3 normal_at(const radar::ViewFrame& frame, const core::Vec3& normal_platform,
                                     const Sight& sight) const;
  void add(const ScattererView& view, radar::EchoBatch& echoes) const;
  [[nodiscard]] std::optional<ScattererView> point_view(const ScattererSheet& sheet, const core::Vec3& point_m,
                                                        const radar::Pointing& pointing) const;
  void add_sheet(std::size_t index, const radar::Pointing& pointing, radar::EchoBatch& echoes) const;

  const ResolvedScene* scene_;
  const Link* radar_;
  // Only platforms that are seen have a slot: a scene of many radars makes as many of these.
  std::vector<std::uint32_t> slot_of_;    // of each platform of the scene
  std::vector<std::uint32_t> platforms_;  // of each slot: those that reflect, then the radar's if it is none of them
  std::size_t reflecting_ = 0;            // slots of platforms that reflect
  std::vector<radar::Pose> poses_;        // by slot, as the two below
  std::vector<radar::ViewFrame> frames_;
  std::vector<radar::Track::ErrorSteps> error_steps_;
  bool bends_ = false;
  std::int64_t pulse_ = 0;
  double time_s_ = 0.0;
  double carrier_hz_ = 0.0;
  double amplitude_scale_ = 0.0;
  bool range_loss_ = true;
};

}  // namespace sarsim::simulate

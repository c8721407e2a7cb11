#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/task/parallel.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::simulate {

/// A target as seen by a pulse whose echo is within 6 dB of its strongest.
struct LitLook {
  radar::BeamOffset offset;    ///< From the beam's axis, rad.
  double incidence_rad = 0.0;  ///< From the normal, for targets with a directional reflectivity.
};

/// One target as the beam of a recording passes it. Of the undisturbed target: without its random parts.
struct TargetVisibility {
  std::size_t target = 0;  ///< Position in the scene's list.
  std::int64_t pulse = 0;  ///< Its best pulse: the strongest echo; without any echo that nearest to the beam's axis.
  double range_m = 0.0;    ///< c tau/2 at that pulse.
  double off_azimuth_rad = 0.0;  ///< Offset from the beam's axis at that pulse.
  double off_elevation_rad = 0.0;
  double pattern = 0.0;        ///< Two-way power gain at that pulse over that of the antennas' peaks, 0 to 1.
  double best_pattern = 0.0;   ///< The largest of any pulse that was looked at.
  double amplitude_v = 0.0;    ///< At that pulse.
  double snr = 0.0;            ///< P Tp/(k T) at that pulse, after a matched filter; 0 without noise.
  double processed_snr = 0.0;  ///< Sum of the SNRs of all pulses: what adding them in phase, each with its weight,
                               ///< gives. Of a turning beam, of one pass.
  double nearest_m = 0.0;      ///< Least range while its echo is within 6 dB of its strongest.
  double farthest_m = 0.0;     ///< Largest range meanwhile.
  std::vector<LitLook> lit;    ///< At most 64 looks meanwhile, if functions of the angle are given by points.
};

/// Looks at targets one by one, as closely in slow time as their passage through the beam needs. Costs some hundreds of
/// pulse geometries for each target, so it is for some targets of a scene, not for a million.
class VisibilitySurvey {
 public:
  /// Keeps a reference to the acquisition. @param targets  positions in the scene's list of targets
  VisibilitySurvey(const Acquisition& acquisition, const std::vector<std::size_t>& targets);

  /// In the order of the targets. A requested stop throws Interrupted.
  [[nodiscard]] std::vector<TargetVisibility> look(const core::WorkControl& control = {}) const {
    return look(radar_.beam, control);
  }
  /// As if the beam pointed elsewhere.
  [[nodiscard]] std::vector<TargetVisibility> look(const radar::Beam& beam,
                                                   const core::WorkControl& control = {}) const;

  /// Direction of the middle of the targets from the radar in the frame of its platform, at the middle pulse: azimuth
  /// from +y towards +x, as a FIXED beam has it.
  [[nodiscard]] radar::BeamOffset direction() const;

 private:
  const Acquisition* acquisition_;
  std::vector<std::size_t> targets_;
  ResolvedScene scene_;  // of these targets and their platforms alone
  Link radar_;
};

/// What a recording will hold, in a few numbers.
struct EchoSummary {
  std::size_t simulation = 0;  ///< Position in the scene's list.
  std::size_t targets = 0;     ///< Of the scene.
  std::size_t in_window = 0;   ///< Of them, those that the window meets.
  std::vector<TargetVisibility>
      sights;              ///< Of those, at most 64: all, or an even choice with the strongest and the weakest.
  bool directive = false;  ///< The radar has an antenna with a beam.
  bool noise = false;      ///< The receiver has noise; without it there is no SNR.

  /// The strongest of `sights`; expects at least one.
  [[nodiscard]] const TargetVisibility& strongest() const;
  /// The weakest of `sights`; expects at least one.
  [[nodiscard]] const TargetVisibility& weakest() const;
};

}  // namespace sarsim::simulate

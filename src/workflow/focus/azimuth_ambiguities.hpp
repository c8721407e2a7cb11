#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "signal/sar/focusing.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::workflow {

class TargetAspects;

/// The Doppler frequencies that focusing keeps.
struct DopplerBand {
  double centroid_hz = 0.0;
  double width_hz = 0.0;  ///< 0: all that the pulses sample.
};

/// A false image of a target: what of its echoes has Doppler frequencies beyond half the pulse repetition frequency
/// from the centroid is taken for another frequency, and focused elsewhere.
struct AzimuthAmbiguity {
  std::size_t target = 0;      ///< Position in the scene's list, from 0.
  int folds = 0;               ///< Whole pulse repetition frequencies that its Doppler frequencies lie too high.
  signal::ImagePlace place{};  ///< Its middle.
  double azimuth_m =
      0.0;  ///< Over which it is smeared, since neither its curve nor its Doppler rate is the one assumed.
  double range_m = 0.0;
  double share = 0.0;  ///< Of the target's echoes that it is made of: of the image's energy at the target.
};

/// Where a target's image is to be found and what it looks like.
struct SarTarget {
  std::size_t target = 0;
  signal::ImagePlace place;        ///< From distance and Doppler: a moving target R u/v beside where it is.
  double amplitude = 0.0;          ///< Mean of its whole echoes over all pulses, volts.
  double lowest_doppler_hz = 0.0;  ///< Among the pulses whose echo is within 20 dB of the strongest.
  double highest_doppler_hz = 0.0;
  double min_doppler_hz = 0.0;  ///< Among all pulses but those at either end that together hold a two-thousandth of
                                ///< the amplitude: sidelobes of the antenna count.
  double max_doppler_hz = 0.0;
  double kept = 1.0;      ///< Of the amplitude of its peak, what is recorded leaves, 0 to 1.
  bool in_swath = true;   ///< Inside the recorded ranges at every such pulse.
  bool recorded = false;  ///< Inside of them at one pulse at least.
  bool whole = true;      ///< And not so near to the end of a raw recording that the rest of its echo is missing.
};

/// All targets, as the geometry has them.
/// @param echoes     their waveform, track and window; no rows are read
/// @param max_looks  of more pulses, evenly spaced ones
/// @throw  Interrupted
[[nodiscard]] std::vector<SarTarget> sar_targets(const simulate::Acquisition& acquisition,
                                                 const signal::EchoRows& echoes, const core::WorkControl& control = {},
                                                 std::size_t max_looks = 2048);

/// The same from aspects at hand.
[[nodiscard]] std::vector<SarTarget> sar_targets(const TargetAspects& looks, const core::WorkControl& control = {});

/// The same from the line that fits the track, which the frequencies of an image are about.
[[nodiscard]] std::vector<SarTarget> targets_from_line(const simulate::Acquisition& acquisition,
                                                       signal::EchoRows echoes, const core::WorkControl& control = {},
                                                       std::size_t max_looks = 2048);

/// Ghosts of all targets in a Doppler band, by target and fold; those below a hundredth of their target left out. Where
/// less is kept than the pulses sample, only what folds into it is there.
/// @throw  Interrupted
[[nodiscard]] std::vector<AzimuthAmbiguity> sar_ghosts(const simulate::Acquisition& acquisition,
                                                       const signal::EchoRows& echoes, const DopplerBand& kept,
                                                       const core::WorkControl& control = {});

/// Numbers of targets as messages list them, from 1: "1, 2, 3 and 5 more".
[[nodiscard]] std::string target_list(const std::vector<std::size_t>& targets);

/// By what an image is made, which decides what ghosts do to it.
enum class AmbiguitiesIn {
  frequency,  ///< By Doppler frequencies: what folds away is missing from the peaks.
  time,       ///< By back-projection, which keeps the peaks: a note where ghosts have less than a tenth of the echoes.
  circle,     ///< By back-projection of a flight that goes around: Doppler frequencies from a line tell nothing.
};

/// A warning where echoes of targets wrap around, and where their ghosts appear.
/// @throw  Interrupted
[[nodiscard]] core::Problems diagnose_ghosts(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                             const DopplerBand& kept, AmbiguitiesIn image,
                                             const core::WorkControl& control = {});

/// What a user should know before focusing, without errors: targets whose echoes wrap around and where their ghosts
/// appear, targets outside the swath or at the end of a raw recording, a beam that holds more Doppler frequencies than
/// the pulses sample, ranges sampled more coarsely than the band allows. Nothing is said of more
/// than `max_examined_targets`.
/// @throw  Interrupted
[[nodiscard]] core::Problems diagnose_sar(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                          const DopplerBand& kept, AmbiguitiesIn image,
                                          const core::WorkControl& control = {});

}  // namespace sarsim::workflow

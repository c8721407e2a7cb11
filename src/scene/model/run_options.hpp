#pragma once

#include <cstdint>

#include "core/maths/sampled_function.hpp"

namespace sarsim::scene {

/// Which set of conventions a run follows (docs/decisions/0001-profiles.md).
enum class Profile { physical, classic };

/// What the pulse of a simulation is (decision 7): hard-edged, or confined to a band.
enum class PulseDefinition { ideal, band_limited };

/// Which echoes of pulses other than its own a row receives; never any by the conventions of 1998.
enum class AmbiguousEchoes {
  strong,  ///< Those that may exceed -60 dB relative to the strongest echo, antennas ignored.
  all,
  none,
};

/// What a receiver does while its radar sends.
enum class Eclipsing {
  none,     ///< It goes on receiving.
  blanked,  ///< It is off: samples are 0.
};

/// Choices that hold for every product of a scene (script `$OPTIONS`; the command line overrides).
struct RunOptions {
  Profile profile = Profile::physical;
  std::uint64_t seed = 1;
  PulseDefinition pulse = PulseDefinition::ideal;
  double tolerance = 1e-6;
  core::CubicEnds cubic_ends = core::CubicEnds::chords;  ///< Of every function given by points, CUBIC (decision 17).
  AmbiguousEchoes ambiguous_echoes = AmbiguousEchoes::strong;
  Eclipsing eclipsing = Eclipsing::none;

  friend bool operator==(const RunOptions&, const RunOptions&) = default;
};

}  // namespace sarsim::scene

#pragma once

#include "core/maths/interpolator.hpp"
#include "radar/antenna/beam.hpp"
#include "radar/antenna/pattern.hpp"
#include "radar/echo/pulse_clock.hpp"
#include "radar/path/light_time.hpp"
#include "scene/model/function_role.hpp"
#include "scene/model/run_options.hpp"

namespace sarsim::simulate {

/// What a profile means, one named convention at a time (docs/decisions/0001-profiles.md). Kernels take these as
/// arguments and never hear of a profile.
struct Conventions {
  enum class SampleSpacing { sampling_rate, window_fraction };  ///< c/(2 fs), or (end - start)/N for raw data.
  enum class Compression { keeps_peak, pulse_energy };          ///< Decision 12; docs/theory/compression.md.
  enum class Noise { per_sample, per_bandwidth };  ///< kT fs in all; sqrt(kTB) in I and in Q (thesis 4.1-4.3).
  enum class Stc { receiver_gain, no_spreading };  ///< Gain at the sample's range; 1/d^2 left out of the amplitude.

  enum class Reception { every_pulse, own_pulse };  ///< A row hears echoes of all pulses, or of its own alone.
  /// Functions beyond their points: by scene::FunctionEnds, or extrapolated by their interpolation, with antennas at
  /// the magnitude of the angle (1998).
  enum class FunctionEnds { by_role, by_method };

  double light_speed_mps = 0.0;
  double boltzmann_j_per_k = 0.0;
  /// What is kept of a pulse that is limited to its own band where a simulation does not say; 0: all (decision 7).
  double usual_kept_widths = 0.0;
  radar::PatternRule pattern = radar::PatternRule::amplitude;
  radar::PointingRule pointing = radar::PointingRule::boresight;
  core::LowPassRule low_pass = core::LowPassRule::first_knot;
  radar::LightTime light_time = radar::LightTime::exact;
  radar::DopplerRule doppler = radar::DopplerRule::stretch;
  SampleSpacing spacing = SampleSpacing::sampling_rate;
  Compression compression = Compression::keeps_peak;
  Noise noise = Noise::per_sample;
  Stc stc = Stc::receiver_gain;
  Reception reception = Reception::every_pulse;
  FunctionEnds function_ends = FunctionEnds::by_role;
};

/// What a profile stands for.
[[nodiscard]] Conventions conventions_of(scene::Profile profile);
/// Rules for functions given by points between their points, by profile and option.
[[nodiscard]] core::InterpolationRules interpolation_rules(const scene::RunOptions& options);
/// The same, with the rule beyond the points of a function with this role.
[[nodiscard]] core::InterpolationRules interpolation_rules(const scene::RunOptions& options, scene::FunctionRole role);

}  // namespace sarsim::simulate

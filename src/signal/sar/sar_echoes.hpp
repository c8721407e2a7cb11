#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/maths/vector.hpp"
#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "core/task/sample_rows.hpp"

namespace sarsim::signal {

/// Where the antenna was when one pulse left it.
struct TrackPoint {
  double time_s = 0.0;
  core::Vec3 position_m;    ///< World.
  core::Vec3 velocity_mps;  ///< World.
};

/// The waveform and the receiver, as far as focusing needs to know them.
struct SarWaveform {
  double carrier_hz = 0.0;
  double bandwidth_hz = 0.0;   ///< Of the pulse; negative for a chirp that sweeps down.
  double pulse_width_s = 0.0;  ///< Chirp rate: bandwidth_hz/pulse_width_s. 0: the pulse is no chirp.
  double sample_rate_hz = 0.0;
  double light_speed_mps = 0.0;
};

/// Range-compressed echoes of a train of pulses and the path the antenna took: what every focusing algorithm begins
/// with. Sample (p, n) is the compressed baseband echo of pulse p at the delay first_delay_s + n/sample_rate_hz; a
/// target has its peak at its light time tau with the phase -2 pi carrier_hz tau (docs/theory/echo-model.md); that of a
/// chirp of the rate K, whose Doppler frequency is fd, fd/K earlier, and turned by -pi fd^2/K more.
struct SarEchoes {
  SarWaveform waveform;
  std::vector<TrackPoint> track;  ///< One for each pulse.
  std::size_t samples = 0;        ///< Of each pulse.
  double first_delay_s = 0.0;
  std::vector<std::complex<float>> volts;  ///< track.size() rows of `samples`.
  std::vector<double> carriers_hz{};       ///< Of each pulse, where they differ; empty: all that of the waveform.
  /// By how much the first sample of each pulse is later than `first_delay_s`; empty: not at all. This and the next are
  /// for back projection alone.
  std::vector<double> later_s{};
  /// Where a receiver of its own is as each echo comes back, world; empty: it is the antenna that sent, flying on. The
  /// velocities of the track are then 0: the delay is the sum of both ways.
  std::vector<core::Vec3> receivers_m{};
};

/// Echoes that need not all be in memory: a row for each pulse.
struct EchoRows : core::SampleRows<float> {
  SarWaveform waveform;
  std::vector<TrackPoint> track;  ///< One for each row.
  double first_delay_s = 0.0;
  bool compensated = false;           ///< As if received on the straight line that fits the track.
  std::vector<double> carriers_hz{};  ///< As of SarEchoes. Back projection alone takes rows whose carriers differ.
  /// A point of the line from which images count their azimuth; nothing: where the line is at the middle pulse. Rows
  /// that were moved along the line keep that of the rows before, so that all algorithms count from one point.
  std::optional<core::Vec3> azimuth_zero_m{};
};

/// Keeps a reference to the echoes.
[[nodiscard]] EchoRows rows_of(const SarEchoes& echoes);

/// All rows in memory.
/// @throw  Interrupted
[[nodiscard]] SarEchoes sar_echoes(const EchoRows& rows, const core::WorkControl& control = {},
                                   const core::ProgressReport& progress = {});

}  // namespace sarsim::signal

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/task/sample_rows.hpp"
#include "scene/model/recording.hpp"
#include "signal/sar/focusing.hpp"
#include "simulate/plan/acquisition.hpp"

/// From simulations and their recordings to what focusing begins with.
namespace sarsim::workflow {

/// What keeps a simulation from being focused whatever the method, all at once: fewer than two pulses, a radar that
/// rests; of recordings also synthetic range profiles and samples that the classic profile places unevenly; of others
/// pulses of more than 2^31 samples.
/// @param recorded  a file holds the echoes; otherwise they are simulated as focusing wants them
[[nodiscard]] core::Problems problems_of_sar(const simulate::Acquisition& acquisition, bool recorded);

/// Where the radar's antenna was when each pulse of a plan left it.
[[nodiscard]] std::vector<signal::TrackPoint> track_of(const simulate::Acquisition& acquisition);
/// The track of an antenna that moves otherwise.
/// @param position_at  world position [m] at a time [s]
[[nodiscard]] std::vector<signal::TrackPoint> track_along(const simulate::Acquisition& acquisition,
                                                          const std::function<core::Vec3(double)>& position_at);

/// The simulation as focusing wants it recorded: raw, longer by a pulse, so that echoes at the window's end can be
/// compressed too, and for CENTRE half a pulse earlier, so that compressed samples begin where the script's window does
/// and the receiver's noise is that of a compressed recording. Its windows and its output format do not matter any
/// more.
[[nodiscard]] scene::Simulation recorded_for_sar(const scene::Simulation& simulation,
                                                 const simulate::Acquisition& acquisition);

/// Compressed echoes of a scene, computed when they are asked for. It is of a simulation made by
/// `recorded_for_sar`; its echoes are compressed by the matched filter of the physical profile, without a window
/// (docs/theory/compression.md).
/// @param samples  of a compressed row: those of the script's window, from its start on
[[nodiscard]] signal::EchoRows sar_rows_of_scene(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                                 std::size_t samples);

/// Compressed echoes of a recording: raw data are compressed as above, compressed ones taken as
/// they are.
/// @param recorded  rows like those that the acquisition makes
[[nodiscard]] signal::EchoRows sar_rows_of_recording(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                                     core::SampleRows<double> recorded);

/// A point in the middle of what is mapped, world: the mean of the targets at the middle of the recording; where there
/// are none, or they lie on the flight's line, the point of the beam's axis in the middle of the recorded ranges.
[[nodiscard]] core::Vec3 scene_middle_m(const simulate::Acquisition& acquisition);

/// Doppler centroid as geometry has it: that of the echoes' power, over targets, surfaces and some pulses of the
/// recording; where there are no echoes, that of the beam's axis at its middle, 0 for an antenna that has none.
[[nodiscard]] double geometric_doppler_centroid_hz(const simulate::Acquisition& acquisition);

}  // namespace sarsim::workflow

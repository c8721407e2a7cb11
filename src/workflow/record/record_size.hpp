#pragma once

#include "scene/model/scene.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/resolve/resolved.hpp"

/// What recordings and tables take of disk and time, known before their first pulse.
namespace sarsim::workflow {

/// Whether the LSB is not given and the file holds counts: only the whole recording gives it.
/// @param counts  counts are asked for in formats that hold volts otherwise
[[nodiscard]] bool seeks_lsb(const scene::Simulation& simulation, bool counts = false);

/// Times that every sample is computed: 2 where the LSB has to be found first, otherwise 1.
[[nodiscard]] double passes_of(const scene::Simulation& simulation, bool counts = false);

/// Estimated seconds of a recording on so many threads of this machine (`known_machine`), most of them within 25 %.
/// @param threads  at least 1
[[nodiscard]] double estimated_seconds(const simulate::Plan& plan, unsigned threads, double passes);

/// What one recording takes, from its plan alone.
struct RecordingSize {
  double bytes = 0.0;         ///< Of the file, without a script in it.
  double memory_bytes = 0.0;  ///< While it is made.
  double echoes = 0.0;
  double seconds = 0.0;  ///< As `estimated_seconds`.
};

/// @param threads  that compute, at least 1
/// @param counts   counts are asked for in formats that hold volts otherwise
[[nodiscard]] RecordingSize size_of(const simulate::Plan& plan, unsigned threads, bool counts = false);

/// Bytes that a geometry table has at least; 0 for an unknown radar. No line is shorter than its pulse number and end.
[[nodiscard]] double min_table_bytes(const scene::Scene& scene, const simulate::ResolvedScene& resolved,
                                     const scene::GeometryTable& table);

}  // namespace sarsim::workflow

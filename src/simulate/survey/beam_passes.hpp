#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulate/plan/acquisition.hpp"

namespace sarsim::simulate {

/// Whether the azimuth of a beam changes by itself (ROTATING, not at rest).
[[nodiscard]] bool is_scanning(const radar::Beam& beam);

/// Numbers of the pulses at which a beam that turns points nearest to the targets in azimuth: up to five passes of
/// each, at times spread over the recording. An even choice of pulses would pass a narrow beam by.
/// @param acquisition  of a radar whose beam turns
/// @param most  how many pulses at most: of all targets the first pass before the second of any
/// @return in no order, perhaps some more than once; none for targets that the beam does not meet in the recording
[[nodiscard]] std::vector<std::int64_t> pulses_on_targets(const Acquisition& acquisition, std::size_t most);

/// Number of the pulse at which a beam that turns points nearest to one target in azimuth, in the pass nearest to the
/// middle of the recording; nothing where the beam does not meet it.
[[nodiscard]] std::optional<std::int64_t> pulse_on_target(const ResolvedScene& scene, const Link& radar,
                                                          const radar::PulseRange& pulses, std::size_t target);

}  // namespace sarsim::simulate

#pragma once

#include "core/report/problem.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::workflow {

/// A warning where images of hard-edged pulses may lose more than 0.2 dB or show targets more than a tenth of a range
/// cell off, since the pulses are sampled too slowly for their edges (signal/compress/sampling_loss.hpp). Nothing for
/// pulses that are confined to a band.
[[nodiscard]] core::Problems diagnose_edges(const simulate::Acquisition& acquisition);

}  // namespace sarsim::workflow

#pragma once

#include <complex>
#include <cstdint>
#include <span>

#include "core/maths/random.hpp"

namespace sarsim::radar {

/// Adds white complex noise to a row: independent normal numbers with the given standard deviation in I and in Q, those
/// of `stream.normals(pulse, number of the sample)` to 2e-14 of it.
///
/// @param[in,out] row     samples in volts
/// @param stddev_v        per component; 0 adds nothing
/// @param stream          RandomKind::receiver_noise of the radar
/// @param pulse           absolute pulse number
/// @param first_sample    absolute index of row[0]: samples keep their noise when the window moves (decision 27)
void add_noise(std::span<std::complex<double>> row, double stddev_v, const core::RandomStream& stream,
               std::int64_t pulse, std::int64_t first_sample);

}  // namespace sarsim::radar

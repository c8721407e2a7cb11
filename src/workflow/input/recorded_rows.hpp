#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>

namespace sarsim::workflow {

/// Copies a row of a recording, in volts or in counts; called from many threads at once.
using RecordedRows = std::function<void(std::size_t row, std::span<std::complex<double>> out)>;

}  // namespace sarsim::workflow

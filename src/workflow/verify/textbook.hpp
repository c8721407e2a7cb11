#pragma once

#include <complex>
#include <span>

#include "radar/echo/echo_batch.hpp"
#include "radar/echo/reference_kernel.hpp"

namespace sarsim::workflow::verify {

/// Adds echoes as a textbook's listing does: for every echo and sample of an ideal pulse one sine and one cosine in
/// double precision. What engines are timed against.
void add_textbook_echoes(std::span<std::complex<double>> row, const radar::SampleGrid& grid,
                         const radar::EchoPulse& pulse, double carrier_hz, const radar::EchoBatch& echoes);

}  // namespace sarsim::workflow::verify

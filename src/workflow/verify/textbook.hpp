#pragma once

#include <complex>
#include <span>

#include "radar/echo/echo_batch.hpp"
#include "radar/echo/reference_kernel.hpp"

namespace sarsim::verify {

/// Adds echoes as a textbook's listing does: for every echo and sample of an ideal pulse one sine and one cosine in
/// double precision. What engines are timed against.
void add_textbook_echoes(std::span<std::complex<double>> row, const SampleGrid& grid, const EchoPulse& pulse,
                         double carrier_hz, const EchoBatch& echoes);

}  // namespace sarsim::verify

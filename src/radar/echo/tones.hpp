#pragma once

#include <complex>
#include <cstddef>
#include <span>

#include "radar/echo/tone.hpp"

namespace sarsim::radar {

/// Adds the sums of samples [begin, end) to those of a row, times a factor each where there are factors, and sets them
/// to 0.
/// @param factor  the first is that of sample `begin`; of no length: all are 1
void drain(SplitRow& sums, std::size_t begin, std::size_t end, const SplitSpan& factor,
           std::span<std::complex<double>> row);

/// Adds tones to a row in SIMD.
///
/// Each vector of samples is the product of one exact phasor and the powers of the tone's step, so errors do not grow
/// along the pulse. Single precision (sums of at most 64 tones in float, then double): each sample within 3e-7 of its
/// tone's amplitude. Double precision: within 1e-11, and 1e-14 where |gamma| (end - begin) is below 1e-5.
void add_tones(std::span<const Tone> tones, bool single_precision, SplitRow& row, ToneScratch& scratch);

}  // namespace sarsim::radar

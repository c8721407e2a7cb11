#pragma once

#include <cstddef>
#include <optional>

#include "radar/echo/pulse_body.hpp"
#include "radar/echo/strengths.hpp"

/// How the spectral kernel covers what motion does to the echoes of a row, by few terms and with few spectra.
namespace sarsim::radar {

/// Terms of an interpolation that make exp(-j z x), |x| <= 1, to `error`: the remainder of Chebyshev interpolation is
/// below 2 (z/2)^R/R! for R nodes. At most one more than `max_doppler_terms`.
[[nodiscard]] std::size_t terms_for(double z, double error);

/// Largest phase per unit of D over the pulse, rad.
[[nodiscard]] double largest_doppler_rad(const PulseBody& body, double carrier_hz);

/// Largest phase per unit of a over the pulse, rad s.
[[nodiscard]] double largest_bend_rad(const PulseBody& body, double carrier_hz);

/// Terms of an interpolation over a half span of a: as `terms_for`, but one term errs by the root mean square of its
/// phases over the pulse, 1/sqrt(5) of that at the ends.
[[nodiscard]] std::size_t bend_terms_for(const PulseBody& body, double carrier_hz, double half, double error);

/// How far motion may stretch an echo, samples: two-way Doppler of 16 km/s.
[[nodiscard]] double stretch_room(const EchoPulse& pulse, double interval_s);

/// A span of D on a fixed ladder of spans, so that neighbouring pulses share spectra.
[[nodiscard]] DopplerSpan span_covering(double lowest, double highest);

/// A span of this half around what `span_covering` takes, whose middle is a multiple of as much of the half as
/// possible, so that rows share it; nothing where that is less than a sixteenth.
[[nodiscard]] std::optional<DopplerSpan> span_within(double lowest, double highest, double half);

/// The span of a for bends that turn the ends of the pulse by up to `rad_per_bend` times them: none where that is less
/// than a quarter of `error`, and on multiples of that, so that pulse after pulse has the same spectra.
[[nodiscard]] DopplerSpan bends_covering(double lowest, double highest, double rad_per_bend, double error);

/// What a body's band is widened by for Doppler shifts of up to `shift` cycles per sample: nothing where it is too
/// small to move more than a trifle over the edge, otherwise a power of two, so that few widths occur. It depends on
/// the pulse's own echoes alone, so that a kernel gives the same samples whatever it did before.
[[nodiscard]] double allowance_for(double shift);

}  // namespace sarsim::radar

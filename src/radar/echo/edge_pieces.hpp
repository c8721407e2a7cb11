#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "radar/echo/gridding.hpp"
#include "radar/echo/pulse_body.hpp"

namespace sarsim::radar {

/// What the body of a pulse leaves out next to its edges; nothing where the pulse is too wild there for polynomials.
/// @param samples    of each edge region
/// @param tolerance  of the polynomials
template <class Real>
[[nodiscard]] std::optional<std::vector<EdgePiece<Real>>> edge_pieces(const PulseBody& body, std::size_t samples,
                                                                      double tolerance);

/// How much the pulse changes from sample to sample in its edge regions at most, beside its sweep; 0 for as good as
/// nothing.
[[nodiscard]] double steepest_edge(const EchoPulse& pulse, const PulseBody& body, std::size_t samples);

}  // namespace sarsim::radar

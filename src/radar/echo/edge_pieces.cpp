#include "radar/echo/edge_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

template <class Real>
std::optional<std::vector<EdgePiece<Real>>> edge_pieces(const PulseBody& body, std::size_t samples, double tolerance) {
  CORE_EXPECT(samples > 0);
  const auto width = static_cast<double>(samples);
  std::vector<EdgePiece<Real>> pieces;
  for (const PulseBody::Edge& edge : body.edges()) {
    // Kept off the border by a hair, so that a value there is the one inside the piece.
    const auto inside = [&](double t) { return std::clamp(t, edge.start + 1e-9, edge.start + width - 1e-9); };
    const auto left_out = [&](std::size_t lane, double fraction) {
      const double t = static_cast<double>(lane) + fraction;
      const double x = t / width;
      return body.value(inside(edge.start + t)) * (1.0 - body.step(edge.rising ? x : 1.0 - x));
    };
    auto fitted = fit_lanes<Real>(
        2 * samples,
        [&](std::size_t lane, double x) {
          const std::complex<double> e = left_out(lane / 2, x);
          return lane % 2 == 0 ? e.real() : e.imag();
        },
        tolerance);
    if (!fitted) return std::nullopt;
    EdgePiece<Real> piece;
    piece.start = edge.start;
    piece.hard = edge.rising ? edge.start : edge.start + width;
    piece.samples = std::move(*fitted);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

template std::optional<std::vector<EdgePiece<float>>> edge_pieces(const PulseBody&, std::size_t, double);
template std::optional<std::vector<EdgePiece<double>>> edge_pieces(const PulseBody&, std::size_t, double);

double steepest_edge(const EchoPulse& pulse, const PulseBody& body, std::size_t samples) {
  const double sweep = pulse.pulse.sweep_rate_hz_per_s();
  const auto at = [&](double t) {
    const double u_s = body.from_middle_s(t);
    return body.value(t) * std::polar(1.0, -core::pi * sweep * u_s * u_s);
  };
  constexpr double step = 0.25;
  double steepest = 0.0;
  for (const PulseBody::Edge& edge : body.edges())
    for (double t = edge.start + 1e-6; t + step < edge.start + static_cast<double>(samples); t += step)
      steepest = std::max(steepest, std::abs(at(t + step) - at(t)) / step);
  return steepest < 1e-9 ? 0.0 : steepest;
}

}  // namespace sarsim::radar

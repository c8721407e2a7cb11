#include "signal/row/smooth_row.hpp"

#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {

constexpr double per_piece = cubic_samples;

// The cubic through f(-1), f(0), f(1), f(2) = knots[0 ... 3], in samples from knots[1].
struct ExactCubic {
  double c0, c1, c2, c3;

  explicit ExactCubic(const double* knots)
      : c0(knots[1]),
        c1((-knots[0] / 3.0 - 0.5 * knots[1] + knots[2] - knots[3] / 6.0) / per_piece),
        c2(0.5 * (knots[0] - 2.0 * knots[1] + knots[2]) / (per_piece * per_piece)),
        c3((knots[3] - 3.0 * knots[2] + 3.0 * knots[1] - knots[0]) / 6.0 / (per_piece * per_piece * per_piece)) {}

  [[nodiscard]] Cubic in_float() const {
    return {static_cast<float>(c0), static_cast<float>(c1), static_cast<float>(c2), static_cast<float>(c3)};
  }
};

double fourth_difference(const double* knots) {
  return knots[0] - 4.0 * knots[1] + 6.0 * knots[2] - 4.0 * knots[3] + knots[4];
}

}  // namespace

SmoothPieces smooth_pieces(std::span<const double> knots, double tolerance, LeftOut left_out) {
  CORE_EXPECT(knots.size() >= knots_for(0));
  // Largest |(u + 1) u (u - 1) (u - 2)|/4! for u from 0 to 1.
  constexpr double of_fourth_difference = 9.0 / 384.0;
  // Beyond it the terms of a cubic are too large for floats.
  constexpr double max_bent = 16.0;
  const std::size_t count = knots.size() - knots_for(0);
  SmoothPieces pieces;
  pieces.cubics.reserve(count);
  if (left_out == LeftOut::bases) pieces.bases.reserve(count);
  for (std::size_t p = 0; p < count; ++p) {
    const double* const at = knots.data() + p;
    const double worst = std::max(std::abs(fourth_difference(at)), std::abs(fourth_difference(at + 1)));
    ExactCubic cubic(at + 1);
    const bool smooth =
        worst * of_fourth_difference <= tolerance && std::abs(cubic.c2) * per_piece * per_piece <= max_bent;
    if (!smooth) {
      pieces.rough.push_back(p);
      cubic.c0 = cubic.c1 = cubic.c2 = cubic.c3 = 0.0;
    }
    if (left_out == LeftOut::turns) {
      cubic.c0 -= std::round(cubic.c0);
      cubic.c1 -= std::round(cubic.c1);
    }
    if (left_out == LeftOut::bases) {
      const double base = std::floor(cubic.c0);
      pieces.bases.push_back(static_cast<std::int32_t>(base));
      cubic.c0 -= base;
    }
    pieces.cubics.push_back(cubic.in_float());
  }
  return pieces;
}

}  // namespace sarsim::signal

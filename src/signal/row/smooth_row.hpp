#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "signal/row/row_kernels.hpp"

/// Smooth functions of the number of a sample, evaluated in double precision at knots `cubic_samples` apart and by the
/// cubic through the nearest four of them between. Where the fourth differences of the knots say that a cubic is not
/// good enough, the function itself is evaluated for each sample.
namespace sarsim::signal {

/// Knots for `count` samples: from two steps before the first sample to two after the last.
constexpr std::size_t knots_for(std::size_t count) { return (count + cubic_samples - 1) / cubic_samples + 5; }

/// Number of the sample at a knot; before the first sample negative.
constexpr double sample_of_knot(std::size_t knot) {
  return static_cast<double>(cubic_samples) * (static_cast<double>(knot) - 2.0);
}

/// Cubics and the pieces that they do not suit.
struct SmoothPieces {
  std::vector<Cubic> cubics;
  std::vector<std::int32_t> bases;  ///< Whole numbers to be added; none of turns and values.
  std::vector<std::size_t> rough;
};

/// What cubics leave out: whole turns of the function and of its slope; nothing; whole numbers at each piece's
/// beginning.
enum class LeftOut { turns, nothing, bases };

/// @param knots      knots_for(count) values
/// @param tolerance  of a cubic
[[nodiscard]] SmoothPieces smooth_pieces(std::span<const double> knots, double tolerance, LeftOut left_out);

/// Calls exact(k) for each sample of the rough pieces.
template <class Exact>
void each_rough_sample(const SmoothPieces& pieces, std::size_t count, const Exact& exact) {
  for (const std::size_t piece : pieces.rough)
    for (std::size_t k = piece * cubic_samples; k < std::min(count, (piece + 1) * cubic_samples); ++k) exact(k);
}

/// value(sample) at all knots of `count` samples.
template <class Value>
std::vector<double> knots_of(std::size_t count, const Value& value) {
  std::vector<double> knots(knots_for(count));
  for (std::size_t i = 0; i < knots.size(); ++i) knots[i] = value(sample_of_knot(i));
  return knots;
}

/// turns[k] = value(k) but for whole turns, to 2e-6 of a turn.
/// @param knots  those of value
template <class Value>
void sample_turns(std::span<const double> knots, const Value& value, std::span<float> turns) {
  constexpr double tolerance = 2e-6;
  const SmoothPieces pieces = smooth_pieces(knots, tolerance, LeftOut::turns);
  evaluate_cubics(pieces.cubics, turns);
  each_rough_sample(pieces, turns.size(), [&](std::size_t k) {
    const double exact = value(static_cast<double>(k));
    turns[k] = static_cast<float>(exact - std::round(exact));
  });
}

/// out[k] = value(k), to a millionth.
/// @param value  within +-1 or so
template <class Value>
void sample_values(const Value& value, std::span<float> out) {
  constexpr double tolerance = 1e-6;
  const SmoothPieces pieces = smooth_pieces(knots_of(out.size(), value), tolerance, LeftOut::nothing);
  evaluate_cubics(pieces.cubics, out);
  each_rough_sample(pieces, out.size(),
                    [&](std::size_t k) { out[k] = static_cast<float>(value(static_cast<double>(k))); });
}

/// Splits value(k) into a whole number and the nearest of `steps` to the next, to 1e-5.
/// @param value  within +-2^30
template <class Value>
void sample_places(const Value& value, int steps, const SamplePlaces& places) {
  constexpr double tolerance = 1e-5;
  const std::size_t count = places.whole.size();
  const SmoothPieces pieces = smooth_pieces(knots_of(count, value), tolerance, LeftOut::bases);
  place_cubics(pieces.cubics, pieces.bases, steps, places);
  each_rough_sample(pieces, count, [&](std::size_t k) {
    const double exact = value(static_cast<double>(k));
    const double whole = std::floor(exact);
    places.whole[k] = static_cast<std::int32_t>(whole);
    places.step[k] = static_cast<std::int32_t>((exact - whole) * steps + 0.5);
  });
}

}  // namespace sarsim::signal

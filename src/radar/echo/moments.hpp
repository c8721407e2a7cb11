#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>

#include "core/os/aligned_vector.hpp"
#include "radar/echo/strengths.hpp"

namespace sarsim::radar {

/// Bins of range for rows with many echoes on each sample: the interval between two samples in a few pieces, so that
/// within a piece every sample of an echo is a polynomial in where the echo stands. The ends of the pulse are borders
/// of pieces: on either side of one, an echo has another number of samples.
///
/// An echo at x belongs to the first sample it reaches, n0, and stands before it by phi = n0 - begin - x - shift (D -
/// middle), from 0 to 1 but for what motion does. All in samples, times from the leading edge of the pulse.
struct RangeBins {
  /// Echoes with one number of samples.
  struct Run {
    double from = 0.0;       ///< Smallest phi.
    double per_piece = 1.0;  ///< Pieces for each sample of phi.
    double last_piece = 0.0;
    double first_bin = 0.0;
  };
  static constexpr std::size_t most_runs = 3;

  double begin = 0.0;       ///< When a pulse begins, by D = middle.
  double begin_hard = 0.0;  ///< When it begins at rest,
  double begin_late = 0.0;  ///< and what D/(1 - D) = 1 adds to that: these decide about n0.
  double end_hard = 0.0;    ///< The same for its end.
  double end_late = 0.0;
  double least_samples = 0.0;  ///< Of an echo of the first run; one more in each further one.
  double middle = 0.0;         ///< D at which echoes stand where they are.
  double shift = 0.0;
  double tilt = 0.0;  ///< Of the second sums: strengths times tilt (D - middle).
  std::array<Run, most_runs> runs{};
  std::size_t run_count = 1;
  std::size_t bins = 1;

  double first_sample = 0.0;  ///< The smallest n0.
  std::size_t samples = 0;    ///< So many n0 there are.
};

/// Sums of strengths times powers of where the echoes stand in their piece, y from -1 to 1.
struct Moments {
  static constexpr std::size_t powers = 8;
  core::AlignedVector<std::complex<float>> sums;  ///< [term][bin][n0][power].

  /// Makes room for so many sums; those that are new are 0, those that were there are as they were.
  void make_room(const RangeBins& bins, std::size_t terms);
};

/// Adds echoes to the moments in SIMD. The sum does not depend on the instruction set but for rounding.
/// @param terms  1, or 2 for those that `RangeBins::tilt` weighs, too
void add_moments(const RangeBins& bins, const Strengths<float>& echoes, std::size_t terms, Moments& out);

}  // namespace sarsim::radar

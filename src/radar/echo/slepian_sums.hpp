#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/os/aligned_vector.hpp"
#include "radar/echo/gridding.hpp"
#include "radar/echo/prolate_basis.hpp"
#include "radar/echo/strengths.hpp"

namespace sarsim::radar {

/// Where echoes of a chirp or a tone belong that are summed by the first sample they reach, n0, weighted by functions
/// of how they go on from there. All in samples and turns; times of the pulse from its leading edge, D as ever.
///
/// An echo at x reaches n0 when its pulse, by D = middle, is at begin + 1/2 + p, -1/2 <= p < 1/2 but for what motion
/// does. With s, which is n - n0 + begin + 1/2 less the middle of the pulse, it goes on like
///
///     exp(2 pi j (z s + dk (s^2 - square)/2 + t)),   z = k p - f (D - middle),   t = k p^2/2 - f D p + dk square/2
///
/// beside what all echoes have in common; k is the sweep as D and a change it, dk that change from their middles.
struct SlepianSums {
  double begin = 0.0;       ///< When a pulse begins, by D = middle.
  double begin_hard = 0.0;  ///< When it begins at rest,
  double begin_late = 0.0;  ///< what D/(1 - D) = 1 adds to that,
  double begin_bent = 0.0;  ///< and what a = 1/s does: these decide about n0.
  double end_hard = 0.0;    ///< The same for its end.
  double end_late = 0.0;
  double end_bent = 0.0;

  bool moves = false;         ///< Whether any echo does: what follows but for the sweep, its square and the largest z.
  double middle = 0.0;        ///< Of D.
  double carrier = 0.0;       ///< f, turns per sample.
  double sweep = 0.0;         ///< k by D = middle, turns per sample squared,
  double sweep_slope = 0.0;   ///< what a unit of D - middle adds,
  double sweep_square = 0.0;  ///< and what its square adds.
  bool bends = false;         ///< Whether a counts.
  double bend_middle = 0.0;   ///< Of a: the sweep is that by it, too,
  double bend_slope = 0.0;    ///< and what a unit of a - middle adds to the sweep.
  double square = 0.0;        ///< Mean of s^2.
  double max_z = 0.0;         ///< Largest |z|; may be 0.
  double max_change = 0.0;    ///< Largest |dk|; 0: there is none.

  /// Echoes differ in how many samples they have: a run for each number, from the least on.
  static constexpr std::size_t max_runs = 3;
  double min_samples = 0.0;  ///< Of the first run; one more in each further one.
  std::size_t run_count = 1;
  std::size_t main_run = 0;  ///< The one of most echoes.
  double apart = 0.0;  ///< By how much motion moves one end of a pulse against the other from their middles, most.

  double first_sample = 0.0;  ///< The smallest n0.
  std::size_t samples = 0;    ///< So many n0 there are.

  /// Samples of an echo of the main run.
  [[nodiscard]] std::size_t main_samples() const { return static_cast<std::size_t>(min_samples) + main_run; }
};

/// Sums of strengths times their weights.
struct BinSums {
  static constexpr std::size_t functions = ProlateBasis::count;
  core::AlignedVector<float> sums;   ///< [run][n0][real part, imaginary part][function].
  std::vector<std::uint64_t> marks;  ///< A bit for each [run][n0], lowest first: whether an echo may be there. May be
                                     ///< missing in the main run.

  /// Makes room; what is new is 0, what was there is as it was.
  void make_room(const SlepianSums& bins);
  /// Forgets all sums.
  void clear();
};

/// Adds echoes to the sums in SIMD. The sum does not depend on the instruction set but for rounding.
/// @param weights  of echoes by (y + 1)/2, where y = z/max_z is in [-1, 1], a lane for each function; second
///                 derivatives are those of these polynomials
void add_to_bins(const SlepianSums& bins, const LanePolynomials<float>& weights, const Strengths<float>& echoes,
                 BinSums& out);

/// A sample that echoes of a run have beyond those of the main run, or one that they lack (negative): the sum of the
/// sums of their bin times these factors.
struct BinTail {
  std::size_t run = 0;
  std::ptrdiff_t sample = 0;                         ///< After n0.
  std::array<float, BinSums::functions> re{}, im{};  ///< Factors of the sum of each function.

  /// What the sum of a function is multiplied by.
  void set(std::size_t function, std::complex<double> factor);
};

/// What is added to a single sample of a row, beside the sums.
struct LoneSample {
  std::size_t at = 0;         ///< After the row's first.
  std::complex<float> value;  ///< As strengths are, sqrt(W).
};

/// Moves the sums to a row for each function, around the circle of their length, n0 at first_sample at `first`; what
/// the main run does not tell of the others is put behind what is in `lone`, for a row of `count` samples. Leaves 0.
void leave_bins(const SlepianSums& bins, std::span<const BinTail> tails, BinSums& sums, std::size_t first,
                std::span<const std::span<std::complex<float>>, BinSums::functions> rows, std::size_t count,
                std::vector<LoneSample>& lone);

}  // namespace sarsim::radar

#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/os/aligned_vector.hpp"
#include "radar/echo/lane_polynomials.hpp"

namespace sarsim::radar {

/// Limits of the polynomials that `fit_lanes` looks for.
template <class Real>
struct LaneLimits {
  std::size_t grain = LanePolynomials<Real>::granularity;  ///< The number of lanes is padded to a multiple of it.
  std::size_t lowest_degree = 3;
  std::size_t bytes = sizeof(Real) == 4 ? 8'192 : 32'768;  ///< Most, of all pieces.
};

/// Fits f(lane, x) for lanes 0 ... count - 1 at Chebyshev points, with an error below `tolerance` at check points
/// between them: the lowest degree for which pieces within the limits suffice. Nothing where no degree up to 24 does.
template <class Real>
[[nodiscard]] std::optional<LanePolynomials<Real>> fit_lanes(std::size_t count,
                                                             const std::function<double(std::size_t, double)>& f,
                                                             double tolerance, const LaneLimits<Real>& limits = {});

/// Where a non-uniform transform puts its strengths: the exponential of a semicircle,
/// phi(z) = exp(beta (sqrt(1 - z^2) - 1)), |z| <= 1, over `width` grid cells, for a grid with twice as many points as
/// modes; error about 10^(1 - width) (Barnett, Magland, af Klinteberg, SIAM J. Sci. Comput. 41 (2019) C479).
struct GriddingKernel {
  std::size_t width = 8;
  double beta = 18.4;

  /// A kernel for a relative error of a transform, 1e-13 to 1e-3; for others that of the nearest.
  explicit GriddingKernel(double tolerance);
  /// phi(z); 0 beyond -1 and 1.
  [[nodiscard]] double value(double z) const;
  /// Integral of phi(2 g/width) exp(-2 pi j g nu) dg over the kernel, g in cells: what a mode at nu cycles per cell is
  /// multiplied by.
  [[nodiscard]] double transform(double nu) const;
  /// Same at nu = j/cells for j = 0 ... count - 1, to 1e-13 of the largest.
  [[nodiscard]] std::vector<double> transforms(std::size_t cells, std::size_t count) const;

 private:
  std::vector<double> cells_;    // nodes of the integral on the right half of the kernel, in cells,
  std::vector<double> weights_;  // and what the cosine there counts
};

/// A spreading kernel's taps as polynomials of the fraction, a lane for each.
template <class Real>
[[nodiscard]] LanePolynomials<Real> tap_polynomials(const GriddingKernel& kernel, double tolerance);

/// Grids that strengths are spread onto, one per Doppler term, each with `padding` cells before its first and after its
/// last, which `fold` adds around the circle.
template <class Real>
struct SpreadGrid {
  static constexpr std::size_t padding = 64;
  std::size_t cells = 0;
  std::vector<core::AlignedVector<std::complex<Real>>> term;

  /// Makes room for so many grids of so many cells, all 0.
  void resize(std::size_t cell_count, std::size_t terms);
  /// Sets all cells to 0, or all samples.
  void clear();
  /// Adds the padding to the cells it stands for and returns the cells of a term.
  std::span<std::complex<Real>> fold(std::size_t index);
};

/// What motion does to where echoes are spread, and to how much of them is spread onto the second of two grids.
struct SpreadMotion {
  std::span<const double> doppler;  ///< D of each echo; empty: none moves.
  double middle = 0.0;
  double shift = 0.0;  ///< Of the position, for each unit of D from the middle.
  double tilt = 0.0;   ///< Of the second strength, for each unit of D from the middle, in units of the first.
};

/// Spreads strengths onto the grids in SIMD: grid r cell g receives strength[r][k] phi(2 (g - x[k])/width), where x is
/// the position in cells, shifted by motion.
/// @param position  in units of which `period` make the circle, in [-period, period] when shifted
/// @param strength  terms x positions, term-major; or for two grids those of the first alone, where those of the second
///                  follow by `motion.tilt`
template <class Real>
void spread(const LanePolynomials<Real>& taps, std::size_t width, double period, std::span<const double> position,
            std::span<const std::complex<Real>> strength, const SpreadMotion& motion, SpreadGrid<Real>& grid);

/// The samples next to one hard edge of a pulse that its smooth body leaves out, for each fraction of a sample.
template <class Real>
struct EdgePiece {
  double start = 0.0;  ///< Samples after the pulse's leading edge where the piece begins.
  double hard = 0.0;   ///< Where its hard end is: at its start, or at its end.
  LanePolynomials<Real>
      samples;  ///< Real parts, then imaginary parts, of the samples from the first behind the start on.
  double doppler_offset = 0.0;  ///< Doppler phase at the start: turns per unit of D,
  double doppler_slope = 0.0;   ///< its change per sample,
  double doppler_bend = 0.0;    ///< and per sample squared.
  double late = 0.0;            ///< Samples by which the piece comes later per unit of D.
};

/// Sums of edge samples, with room for a piece that overhangs either end of the row.
template <class Real>
struct EdgeRow {
  static constexpr std::size_t padding = 64;
  std::size_t count = 0;
  core::AlignedVector<std::complex<Real>> samples;  ///< `count` samples between two paddings.

  /// Makes room for so many samples, all 0.
  void resize(std::size_t sample_count);
  void clear();
};

/// Adds one edge piece of many echoes to a row in SIMD.
/// @param position  of each pulse's leading edge, samples after the row's first
/// @param strength  complex amplitudes
/// @param doppler   D of each echo; empty: none moves
template <class Real>
void add_edges(const EdgePiece<Real>& piece, std::span<const double> position,
               std::span<const std::complex<Real>> strength, std::span<const double> doppler, EdgeRow<Real>& row);

}  // namespace sarsim::radar

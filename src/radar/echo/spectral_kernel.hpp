#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "radar/echo/echo_batch.hpp"
#include "radar/echo/reference_kernel.hpp"

namespace sarsim::radar {

/// What the spectral kernel would do for a pulse, for those who choose between kernels.
struct SpectralCost {
  std::size_t gridding_width = 0;  ///< Grid cells an echo touches, per Doppler term.
  std::size_t edge_samples = 0;    ///< Samples added directly per echo at the hard edges.
  std::size_t transform_size = 0;  ///< Points of the larger transform.
  std::size_t doppler_terms = 1;   ///< For the Doppler span asked about.
  std::size_t bin_transforms = 0;  ///< About how many take the place of it for many echoes (SlepianRow); 0: none do,
  std::size_t bin_points = 0;      ///< and the points of one.
};

/// A finite filter that a row passes: out[i] = sum over k of taps[k] row[output_index[i] + k], all of them inside the
/// row.
struct RowFilter {
  std::span<const std::complex<double>> taps;
  std::span<const std::size_t> output_index;
};

/// Adds the echoes of a pulse through a type-1 non-uniform Fourier transform: cost per echo independent of the pulse's
/// length (docs/theory/spectral-kernel.md). The same definition of a row as `add_echoes`, to the tolerance.
///
/// - Every strength A exp(-j 2 pi (f tau - phi)) is spread onto a grid of range; one FFT, a multiplication with the
/// spectrum of
///   the pulse's body over that of the spreading kernel, folding into the sampled band, one inverse FFT.
/// - Body: the pulse times a step that rises from 0 over the K samples next to each hard edge (end, chip border, kink),
///   the integral of a Kaiser window; its spectrum is negligible beyond the pulse's band plus a margin. What it leaves
///   out at the edges is added directly, as polynomials in the fraction of a sample.
/// - What motion does to an echo, by D and a, is interpolated between a few Chebyshev nodes, each with a spectrum of
///   its own; edges take the exact factor.
/// - Where many echoes fall on each sample, in single precision, chirps and tones of constant amplitude are summed in
///   bins of range instead (`SlepianRow`).
///
/// Relative error per pulse, ||s - s_ref|| / sqrt(sum |a|^2 ||p||^2), below the tolerance: single precision from 1e-6
/// upwards, double below, down to 1e-9. One object per thread: it keeps scratch space and the spectra of recent Doppler
/// spans.
class SpectralKernel {
 public:
  /// Keeps a reference to the pulse.
  /// @param filter  for `finish_filtered`; nothing of it is kept
  SpectralKernel(const EchoPulse& pulse, const SampleGrid& grid, double tolerance, const RowFilter& filter = {});
  ~SpectralKernel();
  SpectralKernel(SpectralKernel&&) noexcept;
  SpectralKernel& operator=(SpectralKernel&&) noexcept;

  /// As `add_echoes`.
  void add(std::span<std::complex<double>> row, double carrier_hz, const EchoBatch& echoes);

  /// The same for the echoes of a pulse that come in parts: begins a pulse and forgets what was taken of another.
  /// @param expected  about how many echoes of like motion will be taken: decides whether they are summed in bins
  void begin(double carrier_hz, std::size_t expected = 0);
  /// Takes some of the pulse's echoes.
  void take(const EchoBatch& echoes);
  /// Adds all that was taken to the row. One part gives what `add` gives, bit for bit; more give it to the tolerance.
  void finish(std::span<std::complex<double>> row);
  /// Instead of `finish`: adds it as the filter passes it, one factor more of the spectrum: what `finish` and then the
  /// filter would give, to the tolerance.
  /// @param[in,out] out  as many samples as the filter has outputs
  void finish_filtered(std::span<std::complex<double>> out);

  /// Estimate for choosing a kernel.
  /// @param lowest_doppler   smallest D among the echoes of a pulse
  /// @param highest_doppler  largest
  [[nodiscard]] static SpectralCost cost(const EchoPulse& pulse, const SampleGrid& grid, double tolerance,
                                         double carrier_hz, double lowest_doppler, double highest_doppler);

 private:
  struct Implementation;
  template <class Real>
  struct Typed;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace sarsim::radar

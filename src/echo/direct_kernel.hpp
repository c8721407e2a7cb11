#pragma once

#include <complex>
#include <span>
#include <vector>

#include "echo/echo_batch.hpp"
#include "echo/reference_kernel.hpp"
#include "echo/tones.hpp"

namespace sarsim {

/// Adds echoes sample by sample in SIMD: the fast form of `add_echoes`, for the same definition of a row.
///
/// A monochrome, chirped or coded pulse without envelope is a tone once the row's common quadratic phase
/// exp(j pi K (n - centre)^2 dt^2) is taken out: the exponent K u^2/2 of an echo differs from it by a term linear in n
/// only. So every echo costs one complex multiply-add per sample, and the chirp is put back once per row. Long rows are
/// taken in blocks with a centre each, lest these phases grow beyond what a double resolves. Pulses of other shapes
/// take the reference kernel. One object per thread.
///
/// Accuracy: 3e-7 of each echo's amplitude where `tolerance` is 1e-6 or more, otherwise that of double precision.
class DirectKernel {
 public:
  /// Keeps a reference to the pulse.
  DirectKernel(const EchoPulse& pulse, const SampleGrid& grid, double tolerance);

  /// As `add_echoes`.
  void add(std::span<std::complex<double>> row, double carrier_hz, const EchoBatch& echoes);

 private:
  void collect_tones(double carrier_hz, const EchoBatch& echoes);
  [[nodiscard]] Tone tone_at(const EchoBatch& echoes, std::size_t k, double carrier_hz, std::size_t block) const;
  void add_code_tones(const Tone& whole, double delay_s);

  const EchoPulse* pulse_;
  SampleGrid grid_;
  bool single_precision_;
  bool tonal_;
  std::size_t block_;                        // samples that share a centre
  std::vector<std::complex<double>> chirp_;  // common quadratic phase of a block; empty for pulses without sweep
  std::vector<Tone> tones_;
  SplitRow sum_;
  ToneScratch scratch_;
};

}  // namespace sarsim

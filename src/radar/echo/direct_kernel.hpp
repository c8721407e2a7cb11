#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "radar/echo/echo_batch.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "radar/echo/shaped_tones.hpp"

namespace sarsim::radar {

/// Adds echoes sample by sample in SIMD: the fast form of `add_echoes`, for the same definition of a row.
///
/// A monochrome, chirped or coded pulse is a tone once the row's common quadratic phase exp(j pi K (n - centre)^2 dt^2)
/// is taken out: the exponent K u^2/2 of an echo differs from it by a term linear in n only. So every echo costs one
/// complex multiply-add per sample, and the chirp is put back once per row. Long rows are taken in blocks with a centre
/// each, lest these phases grow beyond what a double resolves. An envelope, I and Q of a user-defined pulse or a
/// band-limited pulse multiply the tone; their values come from a table (radar/echo/shape_table.hpp), at the times at
/// which they were sent. Only where that table would be very large, for a band-limited pulse of 50 000 samples in
/// double precision, or a chirp bends beyond a tone, the reference kernel takes over. One object per thread.
///
/// Accuracy, relative to each echo's amplitude and the largest magnitude of an envelope or pulse: where `tolerance` is
/// 1e-6 or more, 3e-7, and 5e-7 with a table; otherwise 1e-11 and the rounding of phases.
class DirectKernel {
 public:
  /// Keeps a reference to the pulse.
  DirectKernel(const EchoPulse& pulse, const SampleGrid& grid, double tolerance);

  /// As `add_echoes`; costs nothing for samples that no echo reaches.
  /// @return the samples outside of which the row is left as it was
  SampleSpan add(std::span<std::complex<double>> row, double carrier_hz, const EchoBatch& echoes);

 private:
  // One echo.
  struct Source {
    double delay_s;
    double amplitude;
    double doppler;    // D
    PulseClock clock;  // of the shape
    double carrier_hz;
    double late_turns;  // of the carrier at the delay
  };
  [[nodiscard]] bool is_beyond_tones(const EchoBatch& echoes) const;
  SampleSpan collect(double carrier_hz, const EchoBatch& echoes);
  void append_shaped(const Source& source, const SampleSpan& on);
  void append_tones(const Source& source, const SampleSpan& on, std::vector<Tone>& tones) const;
  [[nodiscard]] Tone tone_at(const Source& source, std::size_t block) const;
  void append_code_tones(const Tone& whole, const Source& source, std::vector<Tone>& tones) const;
  [[nodiscard]] SampleSpan flat_samples(const Source& source, const SampleSpan& on) const;

  const EchoPulse* pulse_;
  SampleGrid grid_;
  double tolerance_;
  bool single_precision_;
  double sweep_rate_hz_per_s_;       // of the quadratic phase that echoes have in common
  std::size_t block_;                // samples that share a centre
  SplitRow chirp_;                   // common quadratic phase of a block; empty for pulses without sweep
  std::optional<ShapeTable> shape_;  // none: the tones are the echoes
  std::vector<Tone> tones_;
  std::vector<Tone> shaped_tones_;
  std::vector<ShapedEcho> shaped_;
  SplitRow sum_;  // 0 between calls
  ToneScratch scratch_;
  ShapeScratch shape_scratch_;
};

}  // namespace sarsim::radar

#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <list>
#include <span>
#include <vector>

#include "core/maths/fft.hpp"
#include "core/os/aligned_vector.hpp"
#include "radar/echo/moments.hpp"
#include "radar/echo/pulse_body.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "radar/echo/strengths.hpp"

namespace sarsim::radar {

/// What the echoes of a row have in common for `DenseRow`.
struct DenseMotion {
  double carrier_hz = 0.0;
  DopplerSpan span;
  double shift_s = 0.0;   ///< Per unit of D from the middle of the span: DopplerCoupling::shift_s.
  std::size_t terms = 1;  ///< In D; 1 or 2.

  /// Whether bins for the one serve the other.
  [[nodiscard]] bool is_same(const DenseMotion& other) const {
    const bool at_rest = span == DopplerSpan{} && other.span == DopplerSpan{};
    return span == other.span && (carrier_hz == other.carrier_hz || at_rest);
  }
};

/// Sums the echoes of a row on which many fall on each sample (docs/theory/spectral-kernel.md): each costs eight powers
/// of its place in a bin, whatever its pulse. The powers of a bin, sample by sample, are rows of numbers, which one
/// transform each and a multiplication turn into echoes. Ends of the pulse are exact, not smoothed.
class DenseRow {
 public:
  /// Whether the pulse is one that would go on smoothly beyond its ends: a chirp or a tone of constant amplitude.
  [[nodiscard]] static bool suits(const EchoPulse& pulse, const PulseBody& body);

  /// About how many transforms a row takes.
  /// @param doppler_terms  1 or 2
  [[nodiscard]] static std::size_t transforms_about(const PulseBody& body, std::size_t doppler_terms);
  /// Whether bins are faster than echoes one by one, for so many echoes and transforms of so many points.
  [[nodiscard]] static bool is_worth(double echoes, std::size_t transforms, std::size_t points);

  /// Keeps references to the body and the transform.
  /// @param share    error allowed, as for a row
  /// @param room     samples by which echoes may be stretched at either end
  /// @param row_fft  of the row's period
  DenseRow(const PulseBody& body, const SampleGrid& grid, double share, double room,
           const core::BasicFft<float>& row_fft);

  /// Makes bins for this motion ready; false where none keep the share.
  [[nodiscard]] bool prepare(const DenseMotion& motion);
  /// Adds echoes of a motion that is prepared.
  void take(const Strengths<float>& echoes);
  [[nodiscard]] bool is_empty() const { return !has_sums_; }
  /// Whether what was taken is for this motion.
  [[nodiscard]] bool is_for(const DenseMotion& motion) const {
    return has_sums_ && kept_.front().motion.is_same(motion);
  }
  /// Adds the spectrum of what was taken, over the length of the period, and forgets it.
  void leave(std::span<std::complex<float>> spectrum);
  /// Forgets it without that.
  void forget();

 private:
  using Spectrum = core::AlignedVector<std::complex<float>>;
  // Bins, and what each of their moments is multiplied by: [term][bin][power], empty where nothing would be seen.
  struct Kept {
    DenseMotion motion;
    bool usable = true;
    RangeBins bins;
    std::vector<Spectrum> factor;
  };

  struct BinSamples;

  [[nodiscard]] Kept make(const DenseMotion& motion) const;
  [[nodiscard]] bool make_bins(Kept& kept, double pieces_per_sample) const;
  [[nodiscard]] bool make_factors(Kept& kept) const;
  [[nodiscard]] BinSamples samples_of(const Kept& kept, std::size_t run_index, double piece) const;
  static void tilt(BinSamples& samples);
  void keep_factors(BinSamples& samples, std::size_t bin, Kept& kept) const;
  void limit_kept();
  void take_powers(const RangeBins& bins, std::size_t bin);

  const PulseBody* body_;
  SampleGrid grid_;
  double share_;
  double room_;
  const core::BasicFft<float>* row_fft_;
  std::list<Kept> kept_;  // the last used first
  Moments moments_;
  bool has_sums_ = false;
  std::array<Spectrum, Moments::powers> power_row_;
};

}  // namespace sarsim::radar

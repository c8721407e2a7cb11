#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <list>
#include <span>
#include <vector>

#include "core/maths/fft.hpp"
#include "core/os/aligned_vector.hpp"
#include "radar/echo/pulse_body.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "radar/echo/slepian_sums.hpp"
#include "radar/echo/strengths.hpp"

namespace sarsim::radar {

/// What the echoes of a row have in common for `SlepianRow`.
struct DenseMotion {
  double carrier_hz = 0.0;
  DopplerSpan span;   ///< Of D.
  DopplerSpan bends;  ///< Of a; none: it counts for nothing.

  [[nodiscard]] bool is_at_rest() const { return span == DopplerSpan{} && bends == DopplerSpan{}; }
  /// Whether bins for the one serve the other.
  [[nodiscard]] bool is_same(const DenseMotion& other) const {
    return span == other.span && bends == other.bends && (carrier_hz == other.carrier_hz || is_at_rest());
  }
};

/// Sums the echoes of a row by the first sample each reaches, weighted by eight functions of where it stands before
/// that sample (docs/theory/spectral-kernel.md): an echo costs eight additions in one cache line, whatever its pulse
/// and its motion. The sums for a function, sample by sample, are a row of numbers, which one transform and a
/// multiplication turn into echoes. Ends of the pulse are exact, not smoothed.
class SlepianRow {
 public:
  /// Whether the pulse is one that would go on smoothly beyond its ends: a chirp or a tone of constant amplitude.
  [[nodiscard]] static bool suits(const EchoPulse& pulse, const PulseBody& body);

  /// About how many transforms a row takes; more than there are functions where these will not keep the error.
  /// @param half_doppler  half of the span of D
  /// @param error         relative, allowed
  [[nodiscard]] static std::size_t transforms_about(const EchoPulse& pulse, double interval_s, double carrier_hz,
                                                    double half_doppler, double error);
  /// A span around `span`, up to eight times as wide, which more pulses have in common, as far as the functions follow
  /// its motion as well; otherwise `span`.
  [[nodiscard]] static DopplerSpan shared_span(const EchoPulse& pulse, double interval_s, double carrier_hz,
                                               const DopplerSpan& span, double error);
  /// Whether they are faster than echoes one by one.
  /// @param doppler_terms  that echoes one by one would take
  [[nodiscard]] static bool is_worth(double echoes, std::size_t transforms, std::size_t points,
                                     std::size_t doppler_terms);

  /// Keeps references to pulse, body and transform.
  /// @param body     of the pulse
  /// @param share    error allowed, as for a row
  /// @param room     samples by which echoes may be stretched at either end
  /// @param row_fft  of the row's period
  SlepianRow(const EchoPulse& pulse, const PulseBody& body, const SampleGrid& grid, double share, double room,
             const core::BasicFft<float>& row_fft);

  /// Makes bins for this motion ready; false where none keep the share.
  [[nodiscard]] bool prepare(const DenseMotion& motion);
  /// Whether `prepare` has failed for this motion.
  [[nodiscard]] bool is_refused(const DenseMotion& motion) const;
  /// Adds echoes of a motion that is prepared.
  void take(const Strengths<float>& echoes);
  [[nodiscard]] bool is_empty() const { return !has_sums_; }
  /// Whether what was taken is for this motion.
  [[nodiscard]] bool is_for(const DenseMotion& motion) const {
    return has_sums_ && kept_.front().motion.is_same(motion);
  }
  /// Adds the spectrum of what was taken, over the length of the period, and lone samples of the row, and forgets it.
  void leave(std::span<std::complex<float>> spectrum, std::vector<LoneSample>& lone);
  /// Forgets it without that.
  void forget();

 private:
  using Spectrum = core::AlignedVector<std::complex<float>>;
  static constexpr std::size_t functions = ProlateBasis::count;
  struct Kept {
    DenseMotion motion;
    bool usable = true;
    SlepianSums bins;
    LanePolynomials<float> weights;
    std::vector<BinTail> tails;
    std::array<double, functions> size{};    // of the samples of each function, root mean square; 0: left out
    std::array<Spectrum, functions> factor;  // of the transform of each row; empty where nothing would be seen
  };

  using Parts = std::array<std::complex<double>, functions>;  // what a sample has of each function
  class Fit;

  [[nodiscard]] Kept make(const DenseMotion& motion) const;
  [[nodiscard]] bool make_bins(Kept& kept) const;
  [[nodiscard]] bool is_exact(const Kept& kept, const Fit& fit, std::span<const Parts> parts) const;
  void make_factors(Kept& kept, const Fit& fit, std::span<const Parts> parts) const;
  [[nodiscard]] static double bend_error(const Kept& kept, const Fit& fit);
  [[nodiscard]] static bool make_weights(Kept& kept, const Fit& fit, double share);
  static void make_tails(Kept& kept, const Fit& fit);
  void limit_kept();
  [[nodiscard]] std::span<const std::complex<float>> transformed(Spectrum& row);

  const EchoPulse* pulse_;
  const PulseBody* body_;
  SampleGrid grid_;
  double share_;
  double room_;
  const core::BasicFft<float>* row_fft_;
  std::list<Kept> kept_;  // the last used first
  BinSums sums_;
  bool has_sums_ = false;
  std::array<Spectrum, functions> row_;
  Spectrum transform_;  // of one of them
};

}  // namespace sarsim::radar

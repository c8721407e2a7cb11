#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace sarsim::radar {

/// A piece of a row that one echo fills with an almost pure tone: sample n in [begin, end) receives
///
///     amplitude exp(2 pi j (alpha + beta m + gamma m^2)),   m = n - centre.
struct Tone {
  std::size_t begin = 0;
  std::size_t end = 0;
  double centre = 0.0;  ///< Best a sample near the tone: alpha + beta m + gamma m^2 is rounded to a double.
  double alpha = 0.0;   ///< Turns.
  double beta = 0.0;    ///< Turns per sample.
  double gamma = 0.0;   ///< Turns per sample squared; small: above 1e-4/(end - begin), a Doppler of 2v/c = 2e-4, slow.
  double amplitude = 0.0;
};

/// Real and imaginary parts of a row that tones are added to; `padding` more samples than the row for whole vectors.
struct SplitRow {
  static constexpr std::size_t padding = 64;
  std::vector<double> re;
  std::vector<double> im;
};

/// Real and imaginary parts of some complex numbers.
struct SplitSpan {
  std::span<const double> re;
  std::span<const double> im;
};

/// Room that `add_tones` works in; one per thread.
struct ToneScratch {
  /// Makes room for rows of `samples` numbers, padding included, and changes nothing that is in use.
  void make_room(std::size_t samples, bool single_precision);

  static constexpr std::size_t group = 64;  ///< Tones that are summed in single precision.

  std::vector<float> re_single;  // sums of a group of tones; 0 between calls
  std::vector<float> im_single;
  std::vector<float> turn_re;  // phasor of each vector of samples
  std::vector<float> turn_im;
  std::vector<double> turn_re_double;
  std::vector<double> turn_im_double;
};

/// Adds the sums of samples [begin, end) to those of a row, times a factor each where there are factors, and sets them
/// to 0.
/// @param factor  the first is that of sample `begin`; of no length: all are 1
void drain(SplitRow& sums, std::size_t begin, std::size_t end, const SplitSpan& factor,
           std::span<std::complex<double>> row);

/// Adds tones to a row in SIMD.
///
/// Each vector of samples is the product of one exact phasor and the powers of the tone's step, so errors do not grow
/// along the pulse. Single precision (sums of at most 64 tones in float, then double): each sample within 3e-7 of its
/// tone's amplitude. Double precision: within 1e-11, and 1e-14 where |gamma| (end - begin) is below 1e-5.
void add_tones(std::span<const Tone> tones, bool single_precision, SplitRow& row, ToneScratch& scratch);

}  // namespace sarsim::radar

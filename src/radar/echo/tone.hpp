#pragma once

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

}  // namespace sarsim::radar

#pragma once

#include <string>

#include "simulate/plan/plan.hpp"

namespace sarsim::workflow {

/// What saving a window will take, known before it begins (thesis 4.5.2).
struct SaveEstimate {
  double rows = 0.0;  ///< Pulses, or bursts.
  double columns = 0.0;
  double bytes = 0.0;  ///< Of the file.
  double seconds = 0.0;
  double memory_bytes = 0.0;
  double lsb_v = 0.0;  ///< Estimated, or the one given; 0 where nothing is known of the largest magnitude.
  bool lsb_estimated = true;
};

/// LSB that holds a largest magnitude with 3 % to spare: 1.03 v/(2^(bits-1) - 1), for 1 bit 1.03 v/2; the picture's
/// sampling may have missed the highest sample. 0 for no magnitude.
[[nodiscard]] double estimated_lsb_v(double largest_v, int bits);

/// @param plan        of the recording as it will be saved
/// @param file_bytes  of its format
/// @param largest_v   largest magnitude in the picture; 0: unknown
/// @param threads     that will compute, at least 1
/// @param counts      counts are asked for in formats that hold volts otherwise
[[nodiscard]] SaveEstimate save_estimate(const simulate::Plan& plan, double file_bytes, double largest_v,
                                         unsigned threads, bool counts = false);

/// "512 x 1024 samples, 1.0 MB, about 3 s, 40 MB of memory; LSB 5.0344e-07 mV (estimated)".
[[nodiscard]] std::string text_of(const SaveEstimate& estimate);

}  // namespace sarsim::workflow

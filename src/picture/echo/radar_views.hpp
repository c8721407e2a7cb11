#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "core/task/parallel.hpp"
#include "simulate/run/sampled_rows.hpp"

/// What radar engineers look at besides the echo matrix, from the samples of the same recording.
namespace sarsim::picture {

/// All samples of consecutive rows of a recording.
struct EchoBlock {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<std::complex<double>> samples;  ///< Rows one after the other, in volts.
  std::vector<double> time_s;                 ///< Of each row.
  std::vector<double> carrier_hz;             ///< Of each row.
  std::vector<double> range_m;                ///< Of each column.
  double sample_rate_hz = 0.0;
  double light_speed_mps = 0.0;

  [[nodiscard]] std::complex<double> at(std::size_t row, std::size_t column) const {
    return samples[row * columns + column];
  }
};

/// Computes a block: the samples that a run saves, bit for bit.
/// @param rows  of the plan's product; cut off at its end
/// @throws Interrupted when stopped
[[nodiscard]] EchoBlock echo_block(const simulate::Plan& plan, simulate::IndexSpan rows,
                                   const core::WorkControl& control = {});
/// Same for some of the columns, cut off at the last one.
[[nodiscard]] EchoBlock echo_block(const simulate::Plan& plan, simulate::IndexSpan rows, simulate::IndexSpan columns,
                                   const core::WorkControl& control);

/// Weights over a spectrum's input.
enum class SpectrumWindow { rectangular, hann, hamming };

/// Mean over the rows of a block against range.
struct RangeProfile {
  std::vector<double> range_m;
  std::vector<double> magnitude_v;
};
enum class ProfileMean {
  power,     ///< Root of the mean power.
  coherent,  ///< Magnitude of the mean: what keeps its phase from pulse to pulse.
};
/// The profile of a block of at least one row.
[[nodiscard]] RangeProfile range_profile(const EchoBlock& block, ProfileMean mean);

/// Range against Doppler frequency of a coherent interval.
struct RangeDoppler {
  std::vector<double> doppler_hz;  ///< Ascending from -PRF/2; positive approaching.
  std::vector<double> speed_mps;   ///< -f c/(2 carrier), positive receding.
  std::vector<double> range_m;
  std::vector<std::complex<double>> samples;  ///< [doppler][range]
  std::string remark;                         ///< What is not as the map supposes; empty where all is.

  [[nodiscard]] std::complex<double> at(std::size_t doppler, std::size_t range) const {
    return samples[doppler * range_m.size() + range];
  }
};
/// Y[k] = (1/sum w) sum over n of w[n] x[n] exp(-2 pi j k n/M) over the pulses n at each range, M the least good length
/// of a transform that is at least `bins` and the number of pulses: a scatterer of constant speed at a bin keeps its
/// amplitude. Times are taken as evenly spaced and carriers as equal; the remark says where they are not.
[[nodiscard]] RangeDoppler range_doppler(const EchoBlock& block, SpectrumWindow window, std::size_t bins = 0);

/// Doppler frequency against time of one range cell: what turns, swings or walks shows how its speeds come and go.
struct DopplerTime {
  std::vector<double> time_s;                 ///< Middles of the intervals.
  std::vector<double> doppler_hz;             ///< Ascending from -PRF/2; positive approaching.
  std::vector<std::complex<double>> samples;  ///< [doppler][time]
  std::vector<double> mean_hz;                ///< Of the power of each spectrum; 0 where there is none.
  std::vector<double> width_hz;               ///< Standard deviation of its frequencies about that mean.
  std::string remark;                         ///< What is not as the map supposes; empty where all is.
};
/// The spectra of `range_doppler` of one column, of intervals that overlap by seven eighths, or less where that makes
/// more than 2000 of them.
/// @param interval  pulses of a spectrum, cut off at those that there are
/// @param padding   bins for each of them, at least 1
[[nodiscard]] DopplerTime doppler_time(const EchoBlock& block, std::size_t column, SpectrumWindow window,
                                       std::size_t interval, std::size_t padding = 1);

/// Power density of one row against frequency from the carrier.
struct PowerSpectrum {
  std::vector<double> frequency_hz;      ///< Ascending from -fs/2.
  std::vector<double> density_w_per_hz;  ///< Sum times the spacing is the row's mean power (weighted).
};
[[nodiscard]] PowerSpectrum power_spectrum(const EchoBlock& block, std::size_t row, SpectrumWindow window);

/// The phase of one range cell from pulse to pulse.
struct PhaseHistory {
  std::vector<double> time_s;
  std::vector<double> phase_rad;      ///< In (-pi, pi].
  std::vector<double> unwrapped_rad;  ///< Steps of more than half a turn are taken as the rest of a whole one.
  std::vector<double> path_m;         ///< What the unwrapped phase means as change of range: -phase c/(4 pi carrier).
};
[[nodiscard]] PhaseHistory phase_history(const EchoBlock& block, std::size_t column);

}  // namespace sarsim::picture

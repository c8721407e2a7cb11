#include "core/maths/upsample.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"

namespace sarsim::core {

std::vector<std::complex<double>> upsample(std::span<const std::complex<double>> samples, double centre_cycles,
                                           std::size_t factor) {
  const std::size_t count = samples.size();
  if (count == 0) return {};
  // The band moves to about zero in whole bins, so that the samples keep repeating.
  const double turn = 2.0 * pi * std::round(centre_cycles * static_cast<double>(count)) / static_cast<double>(count);
  std::vector<std::complex<double>> line(count);
  for (std::size_t i = 0; i < count; ++i) line[i] = samples[i] * std::polar(1.0, -turn * static_cast<double>(i));
  Fft(count).forward(line);
  std::vector<std::complex<double>> fine(count * factor);
  const std::size_t positive = (count + 1) / 2;
  for (std::size_t k = 0; k < count; ++k) fine[k < positive ? k : fine.size() - count + k] = line[k];
  // The bin at half the sampling rate belongs to both ends.
  if (count % 2 == 0 && factor > 1) {
    fine[count / 2] = 0.5 * line[count / 2];
    fine[fine.size() - count / 2] = 0.5 * line[count / 2];
  }
  Fft(fine.size()).inverse(fine);
  const double step = turn / static_cast<double>(factor);
  for (std::size_t i = 0; i < fine.size(); ++i)
    fine[i] *= std::polar(1.0 / static_cast<double>(count), step * static_cast<double>(i));
  return fine;
}

}  // namespace sarsim::core

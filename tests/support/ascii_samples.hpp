#pragma once

#include <complex>
#include <filesystem>
#include <fstream>
#include <vector>

namespace sarsim::test {

/// All "I Q" pairs of a text file, whatever separates them.
inline std::vector<std::complex<double>> ascii_samples(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::complex<double>> samples;
  double in_phase = 0.0;
  double quadrature = 0.0;
  while (file >> in_phase >> quadrature) samples.emplace_back(in_phase, quadrature);
  return samples;
}

}  // namespace sarsim::test

#include "signal/stepped/profile_sets.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

std::vector<ProfileSet> scans_of(std::span<const double> gain, double min_share) {
  CORE_EXPECT(min_share >= 0.0 && min_share <= 1.0);
  std::vector<ProfileSet> scans;
  const double largest = gain.empty() ? 0.0 : *std::ranges::max_element(gain);
  if (!(largest > 0.0)) return scans;
  for (std::size_t i = 0; i < gain.size(); ++i) {
    if (gain[i] < min_share * largest) continue;
    if (!scans.empty() && scans.back().last + 1 == i)
      scans.back().last = i;
    else
      scans.push_back({i, i});
  }
  return scans;
}

std::vector<std::complex<double>> mean_profile(std::span<const std::complex<double>> profiles, std::size_t bins) {
  CORE_EXPECT(bins > 0);
  CORE_EXPECT(profiles.size() % bins == 0);
  std::vector<std::complex<double>> mean(bins);
  const std::size_t rows = bins > 0 ? profiles.size() / bins : 0;
  for (std::size_t k = 0; k < bins && rows > 0; ++k) {
    double power = 0.0;
    for (std::size_t r = 0; r < rows; ++r) power += std::norm(profiles[r * bins + k]);
    mean[k] = std::sqrt(power / static_cast<double>(rows));
  }
  return mean;
}

std::ptrdiff_t shift_onto(std::span<const std::complex<double>> profile, std::span<const std::complex<double>> other) {
  if (profile.size() != other.size()) throw std::invalid_argument("profiles of different lengths cannot be aligned");
  if (profile.empty()) return 0;
  const core::Fft fft(core::good_fft_size(2 * profile.size()));
  std::vector<std::complex<double>> a(fft.size());
  std::vector<std::complex<double>> b(fft.size());
  for (std::size_t k = 0; k < profile.size(); ++k) a[k] = std::norm(profile[k]);
  for (std::size_t k = 0; k < other.size(); ++k) b[k] = std::norm(other[k]);
  fft.forward(a);
  fft.forward(b);
  for (std::size_t k = 0; k < a.size(); ++k) a[k] = std::conj(a[k]) * b[k];
  fft.inverse(a);
  const auto largest = std::ranges::max_element(a, {}, [](const std::complex<double>& v) { return v.real(); });
  const std::ptrdiff_t shift = largest - a.begin();
  const auto size = static_cast<std::ptrdiff_t>(fft.size());
  return 2 * shift > size ? shift - size : shift;
}

}  // namespace sarsim::signal

#include "signal/stepped/profile_maker.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/maths/turns.hpp"
#include "core/maths/window.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

namespace {

ProfileAxis axis_of(const SteppedBand& band, double from_m, double to_m, std::size_t transform) {
  if (!(to_m >= from_m)) throw std::invalid_argument("range profile: the stretch of ranges is empty");
  const double c = band.waveform().light_speed_mps;
  ProfileAxis axis;
  axis.first_m = from_m;
  axis.step_m = radar::range_of_cycle(band.cell_hz() * static_cast<double>(transform), c);
  axis.count = static_cast<std::size_t>(std::floor((to_m - from_m) / axis.step_m + 1e-9)) + 1;
  return axis;
}

std::size_t transform_size(const SteppedBand& band, std::size_t oversampling) {
  if (oversampling < 1) throw std::invalid_argument("range profile: no bins");
  return core::good_fft_size(band.cells() * oversampling);
}

// Where the parabola through three values, the middle one not below the others, has its top: -1/2 to 1/2.
double top_of(double left, double middle, double right) {
  const double bend = left - 2.0 * middle + right;
  return bend < 0.0 ? std::clamp(0.5 * (left - right) / bend, -0.5, 0.5) : 0.0;
}

// Bins from the peak, outwards, to half its power.
double half_power(std::span<const std::complex<double>> profile, std::size_t peak, std::ptrdiff_t step, double power) {
  auto i = static_cast<std::ptrdiff_t>(peak);
  const auto count = static_cast<std::ptrdiff_t>(profile.size());
  double inner = std::norm(profile[peak]);
  for (i += step; i >= 0 && i < count; i += step) {
    const double here = std::norm(profile[static_cast<std::size_t>(i)]);
    if (here <= 0.5 * power) {
      const double share = (inner - 0.5 * power) / (inner - here);
      return std::abs(static_cast<double>(i - step) - static_cast<double>(peak)) + share;
    }
    inner = here;
  }
  return -1.0;
}

ProfilePeak peak_at(std::span<const std::complex<double>> profile, const ProfileAxis& axis, std::size_t i) {
  const double left = std::norm(profile[i - 1]);
  const double middle = std::norm(profile[i]);
  const double right = std::norm(profile[i + 1]);
  const double beside = top_of(left, middle, right);
  const double power = middle - 0.25 * (left - right) * beside;
  ProfilePeak peak;
  peak.range_m = axis.at(static_cast<double>(i) + beside);
  peak.amplitude = std::sqrt(power);
  peak.phase_rad = std::arg(profile[i]);
  const double below = half_power(profile, i, -1, power);
  const double above = half_power(profile, i, 1, power);
  if (below >= 0.0 && above >= 0.0) peak.width_m = (below + above) * axis.step_m;
  return peak;
}

bool tops(std::span<const std::complex<double>> profile, std::size_t i) {
  const double here = std::norm(profile[i]);
  return here > 0.0 && here >= std::norm(profile[i - 1]) && here > std::norm(profile[i + 1]);
}

}  // namespace

ProfileMaker::ProfileMaker(const SteppedBand& band, const WindowFunction& window, double from_m, double to_m,
                           std::size_t oversampling)
    : band_(band), weights_(band.cells()), fft_(transform_size(band, oversampling)) {
  axis_ = axis_of(band, from_m, to_m, fft_.size());
  const auto last = static_cast<double>(band.cells() - 1);
  double sum = 0.0;
  double magnitudes = 0.0;
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    weights_[k] = !band.filled(k) ? 0.0 : window && last > 0.0 ? window(static_cast<double>(k) / last) : 1.0;
    sum += weights_[k];
    magnitudes += std::abs(weights_[k]);
  }
  if (!core::weights_cancel(sum, magnitudes))
    for (double& w : weights_) w /= sum;
  gate_.resize(axis_.count);
  for (std::size_t i = 0; i < gate_.size(); ++i)
    gate_[i] = band.gate_of(radar::delay_of(axis_.at(static_cast<double>(i)), band.waveform().light_speed_mps));
}

void ProfileMaker::make(std::span<const std::complex<double>> values, std::span<const PulseMotion> motion,
                        std::span<std::complex<double>> out) const {
  CORE_EXPECT(values.size() == band_.values_per_burst());
  CORE_EXPECT(motion.empty() || motion.size() == band_.waveform().burst_pulses());
  CORE_EXPECT(out.size() == axis_.count);
  std::vector<std::complex<double>> joined(band_.gates() * band_.cells());
  band_.join(values, motion, joined);
  transform(joined, out);
}

void ProfileMaker::add_power(std::span<const std::complex<double>> values, std::span<const PulseMotion> motion,
                             std::span<double> power) const {
  CORE_EXPECT(values.size() == band_.values_per_burst());
  CORE_EXPECT(motion.empty() || motion.size() == band_.waveform().burst_pulses());
  CORE_EXPECT(power.size() == period());
  std::vector<std::complex<double>> joined(band_.gates() * band_.cells());
  band_.join(values, motion, joined);
  std::vector<std::complex<double>> work;
  for (const std::size_t gate : strong_gates(values)) {
    transform_gate(joined, gate, work);
    for (std::size_t k = 0; k < work.size(); ++k) power[k] += std::norm(work[k]);
  }
}

// Of the gates in use, those with a tenth of the strongest one's energy: the same whatever the speed.
std::vector<std::size_t> ProfileMaker::strong_gates(std::span<const std::complex<double>> values) const {
  std::vector<double> energy(band_.gates());
  const std::size_t cells = band_.pulse_cells();
  for (std::size_t i = 0; i < values.size(); ++i) energy[i / cells % band_.gates()] += std::norm(values[i]);
  std::vector<std::size_t> gates;
  double strongest = 0.0;
  for (const std::size_t gate : gate_) {
    if (gate == band_.gates() || (!gates.empty() && gates.back() == gate)) continue;
    gates.push_back(gate);
    strongest = std::max(strongest, energy[gate]);
  }
  std::erase_if(gates, [&](std::size_t gate) { return energy[gate] < 0.1 * strongest; });
  return gates;
}

// Bin i is the range axis_.at(i), but for the turn by the band's centre; beyond the period it repeats.
void ProfileMaker::transform_gate(std::span<const std::complex<double>> joined, std::size_t gate,
                                  std::vector<std::complex<double>>& work) const {
  const double first_s = radar::delay_of(axis_.first_m, band_.waveform().light_speed_mps);
  work.assign(fft_.size(), {});
  for (std::size_t k = 0; k < band_.cells(); ++k)
    work[k] = weights_[k] * joined[gate * band_.cells() + k] *
              core::turned_exactly(static_cast<double>(k) * band_.cell_hz() * first_s);
  fft_.inverse(work);
}

void ProfileMaker::transform(std::span<const std::complex<double>> joined, std::span<std::complex<double>> out) const {
  CORE_EXPECT(out.size() == axis_.count);
  const double first_s = radar::delay_of(axis_.first_m, band_.waveform().light_speed_mps);
  const double step_s = radar::delay_of(axis_.step_m, band_.waveform().light_speed_mps);
  const double from_centre_hz = band_.frequency_hz(0) - band_.centre_hz();
  std::vector<std::complex<double>> work;
  std::size_t held = band_.gates();  // The gate whose bins `work` holds.
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = 0.0;
    if (gate_[i] == band_.gates()) continue;
    if (gate_[i] != held) {
      held = gate_[i];
      transform_gate(joined, held, work);
    }
    out[i] = work[i % fft_.size()] * core::turned_exactly(from_centre_hz * (first_s + static_cast<double>(i) * step_s));
  }
}

std::optional<ProfilePeak> peak_near(std::span<const std::complex<double>> profile, const ProfileAxis& axis,
                                     double range_m, double search_m) {
  CORE_EXPECT(profile.size() <= axis.count);
  CORE_EXPECT(axis.step_m > 0.0);
  CORE_EXPECT(search_m >= 0.0);
  // Places far outside are brought to the ends before they become indices.
  const auto last = static_cast<double>(profile.size()) - 2.0;
  if (last < 1.0) return std::nullopt;
  const auto from = static_cast<std::size_t>(std::clamp(std::ceil(axis.index_of(range_m - search_m)), 1.0, last + 1.0));
  const auto to = static_cast<std::size_t>(std::clamp(std::floor(axis.index_of(range_m + search_m)), 0.0, last));
  std::size_t best = 0;
  for (std::size_t i = from; i <= to; ++i)
    if (tops(profile, i) && (best == 0 || std::norm(profile[i]) > std::norm(profile[best]))) best = i;
  if (best == 0) return std::nullopt;
  return peak_at(profile, axis, best);
}

std::vector<ProfilePeak> highest_peaks(std::span<const std::complex<double>> profile, const ProfileAxis& axis,
                                       std::size_t most, double apart_m, double least) {
  CORE_EXPECT(profile.size() <= axis.count);
  CORE_EXPECT(apart_m >= 0.0);
  CORE_EXPECT(axis.step_m > 0.0);
  std::vector<ProfilePeak> all;
  for (std::size_t i = 1; i + 1 < profile.size(); ++i)
    if (tops(profile, i)) all.push_back(peak_at(profile, axis, i));
  std::ranges::stable_sort(all, [](const auto& a, const auto& b) { return a.amplitude > b.amplitude; });
  std::vector<ProfilePeak> peaks;
  for (const ProfilePeak& peak : all) {
    if (peaks.size() == most || peak.amplitude < least * all.front().amplitude) break;
    const bool near =
        std::ranges::any_of(peaks, [&](const ProfilePeak& p) { return std::abs(p.range_m - peak.range_m) < apart_m; });
    if (!near) peaks.push_back(peak);
  }
  return peaks;
}

double entropy_of(std::span<const double> power) {
  double energy = 0.0;
  double squares = 0.0;
  for (const double p : power) {
    energy += p;
    squares += p * p;
  }
  return squares > 0.0 ? 2.0 * std::log(energy) - std::log(squares) : 0.0;
}

}  // namespace sarsim::signal

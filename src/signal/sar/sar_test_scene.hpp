#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include "core/maths/constants.hpp"
#include "signal/sar/sar_echoes.hpp"

/// Compressed echoes in closed form, for tests: nothing of the simulator in them.
namespace sarsim::signal::sar_test {

struct PointTarget {
  core::Vec3 position_m;
  double amplitude = 1.0;
  core::Vec3 velocity_mps;
};

/// The setting of thesis 7.1: 200 m/s along y at 2000 m, the scene 10 km away along x.
struct Setting {
  double speed_mps = 200.0;
  double height_m = 2000.0;
  double ground_m = 10000.0;  ///< Horizontal distance of the swath's middle.
  double prf_hz = 600.0;
  std::size_t pulses = 1200;
  double squint_rad = 0.0;  ///< The track is moved back so that the beam's middle meets the scene's.
  double swath_m = 400.0;   ///< Slant range, about that of the scene's middle.
  SarWaveform waveform{.carrier_hz = 5.3e9,
                       .bandwidth_hz = 100e6,
                       .pulse_width_s = 800e-9,
                       .sample_rate_hz = 150e6,
                       .light_speed_mps = 299792458.0};

  [[nodiscard]] double closest_m() const { return std::hypot(height_m, ground_m); }
  [[nodiscard]] double wavelength_m() const { return waveform.light_speed_mps / waveform.carrier_hz; }
};

/// Autocorrelation of a chirp with a rectangular envelope, 1 at its peak, `delay_s` from it.
inline double compressed_chirp(double delay_s, const SarWaveform& waveform) {
  const double fraction = std::abs(delay_s) / waveform.pulse_width_s;
  if (fraction >= 1.0) return 0.0;
  const double x = core::pi * std::abs(waveform.bandwidth_hz) * delay_s * (1.0 - fraction);
  return (1.0 - fraction) * (std::abs(x) < 1e-9 ? 1.0 : std::sin(x) / x);
}

inline void add_echo(std::complex<float>* row, const SarEchoes& echoes, const TrackPoint& antenna,
                     const PointTarget& target) {
  const SarWaveform& waveform = echoes.waveform;
  const core::Vec3 sight = target.position_m + antenna.time_s * target.velocity_mps - antenna.position_m;
  const double distance = core::norm(sight);
  const double recession = core::dot(sight, target.velocity_mps - antenna.velocity_mps) / distance;
  const double delay_s = 2.0 * distance / (waveform.light_speed_mps - recession);
  // Doppler inside the pulse moves a compressed chirp.
  const double doppler_hz = -2.0 * recession * waveform.carrier_hz / waveform.light_speed_mps;
  const double early_s = doppler_hz * waveform.pulse_width_s / waveform.bandwidth_hz;
  const double turns = -waveform.carrier_hz * delay_s - 0.5 * doppler_hz * early_s;
  const std::complex<double> turn = std::polar(target.amplitude, 2.0 * core::pi * turns);
  for (std::size_t n = 0; n < echoes.samples; ++n) {
    const double time_s = echoes.first_delay_s + static_cast<double>(n) / waveform.sample_rate_hz;
    row[n] += std::complex<float>(turn * compressed_chirp(time_s - delay_s + early_s, waveform));
  }
}

inline SarEchoes make_echoes(const Setting& setting, const std::vector<PointTarget>& targets) {
  SarEchoes echoes;
  echoes.waveform = setting.waveform;
  const double c = setting.waveform.light_speed_mps;
  const double back_m = setting.closest_m() * std::tan(setting.squint_rad);
  const double middle_m = setting.closest_m() / std::cos(setting.squint_rad);
  echoes.first_delay_s = 2.0 * (middle_m - 0.5 * setting.swath_m) / c;
  echoes.samples = static_cast<std::size_t>(2.0 * setting.swath_m / c * setting.waveform.sample_rate_hz);
  for (std::size_t p = 0; p < setting.pulses; ++p) {
    const double time_s = (static_cast<double>(p) - static_cast<double>(setting.pulses / 2)) / setting.prf_hz;
    echoes.track.push_back(
        {time_s, {0.0, setting.speed_mps * time_s - back_m, setting.height_m}, {0.0, setting.speed_mps, 0.0}});
  }
  echoes.volts.resize(setting.pulses * echoes.samples);
  for (std::size_t p = 0; p < setting.pulses; ++p)
    for (const PointTarget& target : targets)
      add_echo(echoes.volts.data() + p * echoes.samples, echoes, echoes.track[p], target);
  return echoes;
}

/// A point at a closest distance from the track, on the ground.
inline core::Vec3 point_at(const Setting& setting, double along_m, double closest_m) {
  return {std::sqrt(closest_m * closest_m - setting.height_m * setting.height_m), along_m, 0.0};
}

}  // namespace sarsim::signal::sar_test

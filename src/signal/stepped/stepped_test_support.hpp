#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/maths/constants.hpp"
#include "radar/waveform/pulse.hpp"
#include "signal/compress/range_compression.hpp"
#include "signal/stepped/stepped_band.hpp"
#include "signal/stepped/velocity_search.hpp"

/// Bursts of stepped frequencies of moving points, made by formula.
namespace sarsim::signal::test {

inline constexpr double stepped_c = core::exact_light_speed_mps;

/// A point that reflects with an amplitude.
struct SteppedPoint {
  std::function<double(double)> range_m;    ///< Of the time of sending, s.
  std::function<double(double)> speed_mps;  ///< Its derivative.
  double amplitude = 1.0;
};

inline SteppedPoint moving_point(double range_m, double speed_mps, double amplitude = 1.0) {
  return {[=](double t) { return range_m + speed_mps * t; }, [=](double) { return speed_mps; }, amplitude};
}

/// 64 steps of 5 MHz from 9 GHz, one sample of 200 ns (30 m) for each pulse, gates 15 m apart from `first_m` on.
inline SteppedWaveform sampled_waveform(double first_m, std::size_t gates, std::size_t pulses_per_step = 1) {
  SteppedWaveform w;
  w.first_carrier_hz = 9e9;
  w.carrier_step_hz = 5e6;
  w.steps = 64;
  w.pulses_per_step = pulses_per_step;
  w.pulse_width_s = 200e-9;
  w.sample_rate_hz = 10e6;
  w.first_sample_s = 2.0 * first_m / stepped_c;
  w.samples = gates;
  w.seen_from_s = -100e-9;
  w.seen_to_s = 100e-9;
  w.light_speed_mps = stepped_c;
  return w;
}

inline radar::Pulse chirp_of(double bandwidth_hz, double width_s) {
  radar::Pulse pulse;
  pulse.kind = radar::Pulse::Kind::chirp;
  pulse.width_s = width_s;
  pulse.sweep_hz = bandwidth_hz;
  return pulse;
}

inline CompressionFilter filter_of(const radar::Pulse& pulse, double sample_rate_hz) {
  return matched_filter(
      pulse, nullptr, [](double) { return 1.0; }, sample_rate_hz);
}

/// Steps of chirps; `response` is their autocorrelation. Rows reach over `ranges` samples and a pulse more.
inline SteppedWaveform chirped_waveform(const radar::Pulse& pulse, double first_hz, double step_hz, std::size_t steps,
                                        double sample_rate_hz, double first_m, std::size_t ranges) {
  SteppedWaveform w;
  w.first_carrier_hz = first_hz;
  w.carrier_step_hz = step_hz;
  w.steps = steps;
  w.pulse_width_s = pulse.width_s;
  w.sweep_rate_hz_per_s = pulse.sweep_rate_hz_per_s();
  w.subband_hz = std::abs(pulse.sweep_hz);
  w.sample_rate_hz = sample_rate_hz;
  w.first_sample_s = 2.0 * first_m / stepped_c;
  w.light_speed_mps = stepped_c;
  const auto taps = filter_of(pulse, sample_rate_hz).taps;
  w.samples = ranges + taps.size() + 1;
  w.filter = taps;
  const auto count = static_cast<std::ptrdiff_t>(taps.size());
  double squares = 0.0;
  for (const auto& tap : taps) squares += std::norm(tap);
  for (std::ptrdiff_t lag = 1 - count; lag < count; ++lag) {
    std::complex<double> sum;
    for (std::ptrdiff_t k = 0; k < count; ++k)
      if (k + lag >= 0 && k + lag < count)
        sum += taps[static_cast<std::size_t>(k)] * std::conj(taps[static_cast<std::size_t>(k + lag)]);
    w.response.push_back(sum / squares);
  }
  w.response_zero = taps.size() - 1;
  return w;
}

inline std::complex<double> carrier_turn(double cycles) {
  return std::polar(1.0, -2.0 * core::pi * std::remainder(cycles, 1.0));
}

/// Rows of a burst whose pulses leave `interval_s` apart from `start_s` on, placed in the band; as the signal model
/// says (docs/theory/echo-model.md, 3): delay 2 d/(c - v), Doppler within the pulse counted from its middle.
/// @param pulse  of chirps, else null
inline BurstEchoes burst_echoes(const SteppedBand& band, const radar::Pulse* pulse,
                                const std::vector<SteppedPoint>& points, double start_s, double interval_s,
                                std::size_t bursts = 1) {
  const SteppedWaveform& w = band.waveform();
  BurstEchoes echoes;
  for (std::size_t p = 0; p < bursts * w.burst_pulses(); ++p) {
    const double time_s = start_s + static_cast<double>(p) * interval_s;
    const std::size_t in_burst = p % w.burst_pulses();
    const double carrier_hz = w.carrier_hz(in_burst / w.pulses_per_step);
    std::vector<std::complex<double>> raw(w.samples);
    for (const SteppedPoint& point : points) {
      const double v = point.speed_mps(time_s);
      const double delay_s = 2.0 * point.range_m(time_s) / (stepped_c - v);
      const std::complex<double> turn = point.amplitude * carrier_turn(carrier_hz * delay_s);
      for (std::size_t i = 0; i < raw.size(); ++i) {
        const double t = w.first_sample_s + static_cast<double>(i) / w.sample_rate_hz - delay_s;
        if (pulse == nullptr) {
          if (t >= w.seen_from_s && t < w.seen_to_s) raw[i] += turn;
        } else if (t >= 0.0 && t < pulse->width_s) {
          const double u = t - 0.5 * pulse->width_s;
          raw[i] += turn * pulse->value(t) * carrier_turn(2.0 * v * carrier_hz / stepped_c * u);
        }
      }
    }
    echoes.time_s.push_back(time_s);
    std::vector<std::complex<double>> placed(band.values_per_pulse());
    band.place(in_burst, raw, placed);
    echoes.values.insert(echoes.values.end(), placed.begin(), placed.end());
  }
  return echoes;
}

}  // namespace sarsim::signal::test

#pragma once

#include <hwy/targets.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/maths/sinc.hpp"
#include "core/maths/turns.hpp"
#include "signal/sar/back_projection.hpp"
#include "signal/sar/sar_echoes.hpp"

namespace sarsim::signal::test {

using sarsim::core::sinc;

struct PointTarget {
  core::Vec3 position_m;
  std::complex<double> strength{1.0, 0.0};
};

/// Compressed pulse of unit strength, `lag_s` after its delay, with the Doppler shift `doppler_hz`: the correlation of
/// exp(j pi K u^2 + 2 pi j fd u) with exp(j pi K u^2) over a pulse of width Tp (Cook and Bernfeld 1967, 4.2),
///
///     exp(j pi fd x) (1 - |x|/Tp) sinc((K x + fd)(Tp - |x|));        without a width sinc(B x).
inline std::complex<double> compressed_pulse(const SarWaveform& wave, double lag_s, double doppler_hz) {
  if (wave.pulse_width_s == 0.0) return core::sinc(wave.bandwidth_hz * lag_s);
  const double overlap_s = wave.pulse_width_s - std::abs(lag_s);
  if (overlap_s <= 0.0) return 0.0;
  const double rate = wave.bandwidth_hz / wave.pulse_width_s;
  return overlap_s / wave.pulse_width_s * core::sinc((rate * lag_s + doppler_hz) * overlap_s) *
         std::polar(1.0, core::pi * doppler_hz * lag_s);
}

/// Writes the echoes of points as the echo model has them (docs/theory/echo-model.md), ideally compressed.
/// @param where  the true track; the one that the echoes tell stays as it is
inline void write_echoes(SarEchoes& echoes, const std::vector<PointTarget>& targets,
                         const std::vector<TrackPoint>& where, bool start_stop = false) {
  const SarWaveform& wave = echoes.waveform;
  std::vector<std::complex<double>> row(echoes.samples);
  echoes.volts.assign(where.size() * echoes.samples, {});
  for (std::size_t p = 0; p < where.size(); ++p) {
    row.assign(echoes.samples, {});
    for (const PointTarget& target : targets) {
      const core::Vec3 r = target.position_m - where[p].position_m;
      const double d = core::norm(r);
      const double v = start_stop ? 0.0 : -core::dot(r, where[p].velocity_mps) / d;
      const double delay_s = 2.0 * d / (wave.light_speed_mps - v);
      const double doppler_hz = -2.0 * v * wave.carrier_hz / wave.light_speed_mps;
      const double turns = wave.carrier_hz * delay_s;
      const std::complex<double> echo = target.strength * core::turned_exactly(-turns);
      for (std::size_t n = 0; n < echoes.samples; ++n) {
        const double t = echoes.first_delay_s + static_cast<double>(n) / wave.sample_rate_hz;
        row[n] += echo * compressed_pulse(wave, t - delay_s, doppler_hz);
      }
    }
    for (std::size_t n = 0; n < echoes.samples; ++n) echoes.volts[p * echoes.samples + n] = std::complex<float>(row[n]);
  }
}

/// A straight flight: pulse p at time (p - (pulses - 1)/2)/prf.
inline std::vector<TrackPoint> straight_flight(const core::Vec3& middle_m, const core::Vec3& velocity_mps,
                                               double prf_hz, std::size_t pulses) {
  std::vector<TrackPoint> track;
  for (std::size_t p = 0; p < pulses; ++p) {
    const double t = (static_cast<double>(p) - 0.5 * static_cast<double>(pulses - 1)) / prf_hz;
    track.push_back({t, middle_m + t * velocity_mps, velocity_mps});
  }
  return track;
}

/// The radar of thesis chapter 7: 5.3 GHz, 50 MHz, 1.6 us, an aircraft 2000 m high at 200 m/s towards +x that looks
/// along +y at the origin, 10.198 km away; with a repetition frequency that takes in the Doppler of its surroundings.
inline SarEchoes thesis_echoes(std::size_t pulses, double prf_hz, double squint_rad = 0.0) {
  SarEchoes echoes;
  echoes.waveform = {5.3e9, 50e6, 1.6e-6, 60e6, core::exact_light_speed_mps};
  const double range_m = std::hypot(10e3, 2e3);
  echoes.track = straight_flight({-range_m * std::tan(squint_rad), -10e3, 2e3}, {200.0, 0.0, 0.0}, prf_hz, pulses);
  echoes.samples = 256;
  echoes.first_delay_s =
      2.0 * range_m / std::cos(squint_rad) / core::exact_light_speed_mps - 128.0 / echoes.waveform.sample_rate_hz;
  return echoes;
}

/// Back-projection point by point in double precision, echoes between samples as the trigonometric polynomial through
/// them: the sum over all pulses that `back_project` defines, over their number.
/// @param weight  of a pulse for a point; pulses without one count as 1
inline std::vector<std::complex<double>> reference_back_projection(
    const SarEchoes& echoes, const PointGrid& grid, bool start_stop = false,
    const std::function<double(const core::Vec3&, const TrackPoint&)>& weight = {}) {
  const SarWaveform& wave = echoes.waveform;
  const std::size_t size = core::good_fft_size(echoes.samples + 32);
  const core::Fft fft(size);
  const long half = static_cast<long>(size / 2);
  std::vector<std::complex<double>> sums(grid.rows * grid.columns), row(size);
  std::vector<double> weights(sums.size());
  for (std::size_t p = 0; p < echoes.track.size(); ++p) {
    row.assign(size, {});
    for (std::size_t n = 0; n < echoes.samples; ++n)
      row[n] = std::complex<double>(echoes.volts[p * echoes.samples + n]);
    fft.forward(row);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const core::Vec3 point = grid.origin_m + static_cast<double>(i / grid.columns) * grid.row_step_m +
                               static_cast<double>(i % grid.columns) * grid.column_step_m;
      const double w = weight ? weight(point, echoes.track[p]) : 1.0;
      weights[i] += w;
      const core::Vec3 r = point - echoes.track[p].position_m;
      const double d = core::norm(r);
      const double v = start_stop ? 0.0 : -core::dot(r, echoes.track[p].velocity_mps) / d;
      const double delay_s = 2.0 * d / (wave.light_speed_mps - v);
      const double fd = -2.0 * v * wave.carrier_hz / wave.light_speed_mps;
      const double early_s = fd * wave.pulse_width_s / wave.bandwidth_hz;
      const double place = (delay_s - early_s - echoes.first_delay_s) * wave.sample_rate_hz;
      if (w == 0.0 || place < 0.0 || place > static_cast<double>(echoes.samples - 1)) continue;
      std::complex<double> value;
      const std::complex<double> step = std::polar(1.0, 2.0 * core::pi * place / static_cast<double>(size));
      std::complex<double> turn = std::pow(std::conj(step), static_cast<double>(half));
      for (long k = -half; k < static_cast<long>(size) - half; ++k, turn *= step)
        value += row[static_cast<std::size_t>(k < 0 ? k + static_cast<long>(size) : k)] * turn;
      const double turns = wave.carrier_hz * delay_s + 0.5 * fd * early_s;
      sums[i] += w / static_cast<double>(size) * value * core::turned_exactly(turns);
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = weights[i] != 0.0 ? sums[i] / weights[i] : 0.0;
  return sums;
}

/// Calls `body` with every instruction set that this processor has, the name of its bit for messages.
inline void on_every_instruction_set(const std::function<void(std::int64_t)>& body) {
  const std::int64_t targets = hwy::SupportedTargets() & HWY_TARGETS;
  for (std::int64_t rest = targets; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    hwy::SetSupportedTargetsForTest(target);
    body(target);
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace sarsim::signal::test

#include "signal/sar/motion_compensation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/maths/fft.hpp"
#include "core/maths/sinc.hpp"
#include "core/maths/turns.hpp"
#include "core/maths/window.hpp"
#include "core/report/expect.hpp"
#include "radar/path/light_time.hpp"
#include "signal/sar/ground_sight.hpp"
#include "signal/sar/sar_track.hpp"

namespace sarsim::signal {

namespace {

constexpr std::size_t shift_guard_samples =
    32;  // zeros beyond the largest shift, between the end of a pulse and its beginning

// The light time to a point at rest and back to the antenna as it flies on.
double delay_of(const core::Vec3& point_m, const core::Vec3& antenna_m, const core::Vec3& velocity_mps,
                double light_speed_mps) {
  return radar::flight_to_resting(point_m - antenna_m, velocity_mps, velocity_mps, light_speed_mps).delay_s;
}

// One pulse's way from its antenna to the reference track.
class PulseShift {
 public:
  PulseShift(const GroundSight& sight, const TrackPoint& from, const ReferenceTrack& reference, double light_speed_mps)
      : sight_(&sight),
        from_(&from),
        foot_m_(sight.foot_of(from.position_m)),
        velocity_mps_(reference.velocity_mps),
        light_speed_mps_(light_speed_mps) {}

  [[nodiscard]] const core::Vec3& foot_m() const { return foot_m_; }
  /// By how much the echo from the ground at a distance from the foot comes later than it would there.
  [[nodiscard]] double late_s(double range_m) const {
    const core::Vec3 point = sight_->point_at(foot_m_, range_m);
    return delay_of(point, from_->position_m, from_->velocity_mps, light_speed_mps_) -
           delay_of(point, foot_m_, velocity_mps_, light_speed_mps_);
  }

 private:
  const GroundSight* sight_;
  const TrackPoint* from_;
  core::Vec3 foot_m_;
  core::Vec3 velocity_mps_;
  double light_speed_mps_;
};

// Moves a pulse towards earlier times: y(t) = x(t + late), by the shift theorem; a circular one, but the zeros beyond
// the pulse are at least as many as the shift.
void advance(std::span<std::complex<double>> row, const core::Fft& fft, double late_samples) {
  const auto size = static_cast<double>(row.size());
  fft.forward(row);
  for (std::size_t k = 0; k < row.size(); ++k) {
    const double cycles = static_cast<double>(k) - (2 * k > row.size() ? size : 0.0);
    const std::complex<double> turn = core::turned_exactly(cycles / size * late_samples);
    // The highest frequency of an even length stands for both of its signs.
    row[k] *= (2 * k == row.size() ? std::complex<double>(turn.real()) : turn) / size;
  }
  fft.inverse(row);
}

void expect_complete(const SarEchoes& echoes) {
  core::expect(echoes.volts.size() == echoes.track.size() * echoes.samples,
               "motion compensation: the number of samples is not pulses times samples of a pulse");
}

void expect_sound(const EchoRows& echoes) {
  core::expect(echoes.waveform.sample_rate_hz > 0.0 && echoes.waveform.light_speed_mps > 0.0,
               "motion compensation: sampling rate and speed of light must be above 0");
}

// Turns samples by what is computed at every so many of them, by parabolas between. Near the antenna, where as many
// samples are a large part of the range, halves are taken until the parabola is right at a quarter of its span.
class RangeTurns {
 public:
  RangeTurns(const PulseShift& shift, const EchoRows& echoes, double common_s)
      : shift_(shift),
        carrier_hz_(echoes.waveform.carrier_hz),
        common_s_(common_s),
        first_m_(radar::range_of(echoes.first_delay_s, echoes.waveform.light_speed_mps)),
        spacing_m_(radar::range_of_cycle(echoes.waveform.sample_rate_hz, echoes.waveform.light_speed_mps)) {}

  void turn(std::span<std::complex<double>> row) const {
    constexpr std::size_t knot_spacing = 16;
    double left = at(0.0);
    for (std::size_t first = 0; first < row.size(); first += knot_spacing) {
      const double right = at(static_cast<double>(first + knot_spacing));
      turn_between(row, first, knot_spacing, left, right);
      left = right;
    }
  }

 private:
  [[nodiscard]] double at(double sample) const {
    const double range_m = std::max(first_m_ + sample * spacing_m_, spacing_m_);
    return carrier_hz_ * (shift_.late_s(range_m) - common_s_);
  }

  // @param left, right  at the first sample and at that behind the last; a power of two of them
  void turn_between(std::span<std::complex<double>> row, std::size_t first, std::size_t count, double left,
                    double right) const {
    constexpr double max_turns = 1e-5;
    if (first >= row.size()) return;
    const auto begin = static_cast<double>(first);
    const auto span = static_cast<double>(count);
    const double middle = at(begin + 0.5 * span);
    if (count > 2 && !(std::abs(at(begin + 0.25 * span) - 0.125 * (3.0 * left + 6.0 * middle - right)) < max_turns)) {
      turn_between(row, first, count / 2, left, middle);
      turn_between(row, first + count / 2, count / 2, middle, right);
      return;
    }
    for (std::size_t i = first; i < std::min(first + count, row.size()); ++i) {
      const double x = (static_cast<double>(i) - begin) / span;
      row[i] *= core::turned_exactly(
          left + x * (4.0 * middle - 3.0 * left - right + x * (2.0 * left - 4.0 * middle + 2.0 * right)));
    }
  }

  const PulseShift& shift_;
  double carrier_hz_;
  double common_s_;
  double first_m_;
  double spacing_m_;
};

// Where pulses are along a reference track, from its `position_m`.
std::vector<double> places_along_m(const std::vector<TrackPoint>& track, const ReferenceTrack& reference) {
  const core::Vec3 ahead = (1.0 / core::norm(reference.velocity_mps)) * reference.velocity_mps;
  std::vector<double> places_m;
  for (const TrackPoint& point : track) places_m.push_back(core::dot(point.position_m - reference.position_m, ahead));
  return places_m;
}

// The pulse, in between too, that stands at a place. By straight lines: the acceleration a of an aircraft makes them
// wrong by a T^2/8 between pulses T apart, some thousandths of a millimetre.
double pulse_at(const std::vector<double>& places_m, double place_m) {
  const auto after = static_cast<std::size_t>(std::ranges::upper_bound(places_m, place_m) - places_m.begin());
  const std::size_t left = std::clamp<std::size_t>(after, 1, places_m.size() - 1) - 1;
  return static_cast<double>(left) + (place_m - places_m[left]) / (places_m[left + 1] - places_m[left]);
}

constexpr long taps = 16;

// Weights of the pulses first ... first + taps - 1 for the value at `pulse`.
std::array<double, taps> sinc_weights(double pulse, long first) {
  std::array<double, taps> weights{};
  for (long k = 0; k < taps; ++k) {
    const double x = pulse - static_cast<double>(first + k);
    weights[static_cast<std::size_t>(k)] = core::sinc(x) * core::kaiser_window(x / (0.5 * taps), 4.7);
  }
  return weights;
}

// Compensates the pulses of some echoes, one at a time.
class Compensator {
 public:
  Compensator(const EchoRows& echoes, const MotionCompensation& how)
      : echoes_(echoes),
        how_(how),
        sight_(how.reference, how.scene_m, how.squint_rad),
        fft_(core::good_fft_size(echoes.columns + largest_shift() + shift_guard_samples)) {}

  /// In place.
  void compensate(std::size_t pulse, std::span<std::complex<float>> samples) const {
    const SarWaveform& wave = echoes_.waveform;
    const PulseShift shift = shift_of(pulse);
    const double common_s = shift.late_s(sight_.range_m());
    std::vector<std::complex<double>> row(fft_.size());
    // Beyond its own length a pulse is moved out of its window.
    if (std::abs(common_s) * wave.sample_rate_hz < static_cast<double>(samples.size() + shift_guard_samples)) {
      std::ranges::copy(samples, row.begin());
      advance(row, fft_, common_s * wave.sample_rate_hz);
    }
    const std::complex<double> turn = core::turned_exactly(wave.carrier_hz * common_s);
    for (std::size_t i = 0; i < samples.size(); ++i) row[i] *= turn;
    if (how_.second_order) RangeTurns(shift, echoes_, common_s).turn(std::span(row).first(samples.size()));
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::complex<float>(row[i]);
  }

  /// Where the reference antenna is when it takes the place of the true one.
  [[nodiscard]] TrackPoint place_of(std::size_t pulse) const {
    const ReferenceTrack& reference = how_.reference;
    const core::Vec3 foot_m = shift_of(pulse).foot_m();
    const double speed2 = core::dot(reference.velocity_mps, reference.velocity_mps);
    const double after_s = core::dot(foot_m - reference.position_m, reference.velocity_mps) / speed2;
    return {reference.time_s + after_s, foot_m, reference.velocity_mps};
  }

 private:
  // Of all pulses, in samples, at most to where a pulse leaves its window.
  [[nodiscard]] std::size_t largest_shift() const {
    double most = 0.0;
    for (std::size_t p = 0; p < echoes_.track.size(); ++p)
      most = std::max(most, std::abs(shift_of(p).late_s(sight_.range_m())));
    const double samples = std::ceil(most * echoes_.waveform.sample_rate_hz);
    return static_cast<std::size_t>(std::min(samples, static_cast<double>(echoes_.columns + shift_guard_samples)));
  }
  [[nodiscard]] PulseShift shift_of(std::size_t pulse) const {
    return {sight_, echoes_.track[pulse], how_.reference, echoes_.waveform.light_speed_mps};
  }

  const EchoRows& echoes_;
  const MotionCompensation& how_;
  GroundSight sight_;
  core::Fft fft_;
};

}  // namespace

EchoRows compensate_motion(const EchoRows& echoes, const MotionCompensation& how, const WorkSpace& space,
                           const core::WorkControl& control, const core::ProgressReport& progress) {
  CORE_EXPECT(echoes.rows == echoes.track.size());
  expect_sound(echoes);
  const Compensator compensator(echoes, how);
  const std::size_t pulses = echoes.track.size();
  EchoRows out{{pulses, echoes.columns, {}}, echoes.waveform, {}, echoes.first_delay_s, true};
  if (pulses >= 2) out.azimuth_zero_m = fit_straight(echoes.track).origin_m;
  for (std::size_t p = 0; p < pulses; ++p) out.track.push_back(compensator.place_of(p));
  const auto matrix = std::make_shared<WorkMatrix>(pulses, echoes.columns, space.memory_bytes, space.folder);
  WorkCounter counter(progress, pulses * echoes.columns, echoes.columns);
  matrix->each_row(0, pulses, control, counter, [&](std::size_t p, std::span<std::complex<float>> row) {
    echoes.read(p, row);
    compensator.compensate(p, row);
  });
  out.copy = [matrix](std::size_t pulse, std::span<std::complex<float>> row) { matrix->read_row(pulse, 0, row); };
  return how.resample ? resample_azimuth(out, how.reference, how.squint_rad) : out;
}

SarEchoes compensate_motion(const SarEchoes& echoes, const MotionCompensation& how, const core::WorkControl& control) {
  expect_complete(echoes);
  return sar_echoes(compensate_motion(rows_of(echoes), how, {}, control), control);
}

EchoRows resample_azimuth(const EchoRows& echoes, const ReferenceTrack& reference, double squint_rad) {
  CORE_EXPECT(echoes.rows == echoes.track.size());
  CORE_EXPECT(std::isfinite(squint_rad));
  CORE_EXPECT(echoes.waveform.light_speed_mps > 0.0);
  expect_sound(echoes);
  const double speed = core::norm(reference.velocity_mps);
  core::expect(speed > 0.0, "azimuth resampling: the reference track is at rest");
  const std::size_t pulses = echoes.track.size();
  if (pulses < 2) return echoes;
  std::vector<double> places_m = places_along_m(echoes.track, reference);
  for (std::size_t p = 1; p < pulses; ++p)
    core::expect(places_m[p] > places_m[p - 1], "azimuth resampling: the pulses do not ascend along the track");
  const double first_m = places_m.front();
  const double step_m = (places_m.back() - first_m) / static_cast<double>(pulses - 1);
  const double turns_per_m =
      radar::turns_of(std::sin(squint_rad), echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps);
  EchoRows out = echoes;
  for (std::size_t p = 0; p < pulses; ++p) {
    const double after_s = (first_m + static_cast<double>(p) * step_m) / speed;
    out.track[p] = {reference.time_s + after_s, reference.position_m + after_s * reference.velocity_mps,
                    reference.velocity_mps};
  }
  out.copy = [source_rows = core::SampleRows<float>(echoes), places_m = std::move(places_m), first_m, step_m,
              turns_per_m](std::size_t p, std::span<std::complex<float>> row) {
    std::vector<std::complex<double>> sum(row.size());
    std::vector<std::complex<float>> source(row.size());
    const double place_m = first_m + static_cast<double>(p) * step_m;
    const double pulse = pulse_at(places_m, place_m);
    const long first = static_cast<long>(std::floor(pulse)) - taps / 2 + 1;
    const auto weights = sinc_weights(pulse, first);
    for (long k = 0; k < taps; ++k) {
      const long from = first + k;
      if (from < 0 || from >= static_cast<long>(places_m.size())) continue;
      // The spectrum is interpolated about its middle: turned back there, and forth at the new place.
      const std::complex<double> weight =
          weights[static_cast<std::size_t>(k)] *
          core::turned_exactly(turns_per_m * (place_m - places_m[static_cast<std::size_t>(from)]));
      source_rows.read(static_cast<std::size_t>(from), source);
      for (std::size_t i = 0; i < row.size(); ++i) sum[i] += weight * std::complex<double>(source[i]);
    }
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = std::complex<float>(sum[i]);
  };
  return out;
}

SarEchoes resample_azimuth(const SarEchoes& echoes, const ReferenceTrack& reference, double squint_rad,
                           const core::WorkControl& control) {
  expect_complete(echoes);
  return sar_echoes(resample_azimuth(rows_of(echoes), reference, squint_rad), control);
}

double unevenness(const std::vector<TrackPoint>& track, const ReferenceTrack& reference) {
  const std::vector<double> places_m = places_along_m(track, reference);
  if (places_m.size() < 3) return 0.0;
  const double mean_m = (places_m.back() - places_m.front()) / static_cast<double>(places_m.size() - 1);
  double worst_m = 0.0;
  for (std::size_t p = 1; p < places_m.size(); ++p) {
    const double step_m = places_m[p] - places_m[p - 1];
    if (!(step_m > 0.0)) return std::numeric_limits<double>::infinity();
    if (p > 1) worst_m = std::max(worst_m, std::abs(step_m - (places_m[p - 1] - places_m[p - 2])));
  }
  return worst_m / mean_m;
}

}  // namespace sarsim::signal

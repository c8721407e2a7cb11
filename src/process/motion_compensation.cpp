#include "process/motion_compensation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/constants.hpp"
#include "math/fft.hpp"
#include "math/window.hpp"

namespace sarsim {

namespace {

constexpr std::size_t guard_samples = 32;  // zeros between the end of a pulse and its beginning, of its transform

void expect(bool right, const char* what) {
  if (!right) throw std::invalid_argument(what);
}

std::complex<double> turn_by(double turns) { return std::polar(1.0, 2.0 * pi * (turns - std::round(turns))); }

// 2 d/(c - v), v the speed at which the point recedes.
double delay_of(const Vec3& point_m, const Vec3& antenna_m, const Vec3& velocity_mps, double light_speed_mps) {
  const Vec3 r = point_m - antenna_m;
  const double d = norm(r);
  return 2.0 * d * d / (light_speed_mps * d + dot(r, velocity_mps));
}

// Directions of the reference track, and the points of the ground that the middle of the beam meets.
class Sight {
 public:
  Sight(const MotionCompensation& how)
      : squint_sine_(std::sin(how.squint_rad)),
        squint_cosine_(std::cos(how.squint_rad)),
        ground_m_(how.scene_m.z),
        reference_(how.reference) {
    const double speed = norm(how.reference.velocity_mps);
    expect(speed > 0.0, "motion compensation: the reference track is at rest");
    expect(std::abs(how.squint_rad) < 0.5 * pi, "motion compensation: the squint is a right angle or more");
    ahead_ = (1.0 / speed) * how.reference.velocity_mps;
    const Vec3 from_line = foot_to(how.scene_m);
    const double distance_m = norm(from_line);
    expect(distance_m > 0.0, "motion compensation: the scene lies on the reference track");
    range_m_ = distance_m / squint_cosine_;
    side_ = cross(ahead_, {0.0, 0.0, 1.0});
    // A vertical track has no level side: its plane is that of the scene.
    if (norm(side_) < 1e-9) side_ = from_line;
    side_ = (1.0 / norm(side_)) * side_;
    if (dot(side_, from_line) < 0.0) side_ = -side_;
    down_ = Vec3{0.0, 0.0, -1.0} - dot(Vec3{0.0, 0.0, -1.0}, ahead_) * ahead_;
    if (norm(down_) > 1e-9) down_ = (1.0 / norm(down_)) * down_;
  }

  [[nodiscard]] const Vec3& ahead() const { return ahead_; }
  [[nodiscard]] double range_m() const { return range_m_; }
  [[nodiscard]] Vec3 foot_of(const Vec3& antenna_m) const { return antenna_m - foot_to(antenna_m); }

  /// The point at a distance from a point of the track; straight below where the ground is farther away than that.
  [[nodiscard]] Vec3 ground_point(const Vec3& from_m, double range_m) const {
    const double along_m = range_m * squint_sine_;
    const double across_m = range_m * squint_cosine_;
    double sine = 0.0;
    if (down_.z < 0.0) {
      const double drop_m = from_m.z + along_m * ahead_.z - ground_m_;
      sine = std::clamp(drop_m / (-down_.z * across_m), -1.0, 1.0);
    }
    return from_m + along_m * ahead_ + across_m * (std::sqrt(1.0 - sine * sine) * side_ + sine * down_);
  }

 private:
  [[nodiscard]] Vec3 foot_to(const Vec3& point_m) const {
    const Vec3 r = point_m - reference_.position_m;
    return r - dot(r, ahead_) * ahead_;
  }

  double squint_sine_;
  double squint_cosine_;
  double ground_m_;
  ReferenceTrack reference_;
  Vec3 ahead_, side_, down_;
  double range_m_ = 0.0;
};

// One pulse's way from its antenna to the reference track.
class PulseShift {
 public:
  PulseShift(const Sight& sight, const TrackPoint& from, const ReferenceTrack& reference, double light_speed_mps)
      : sight_(&sight),
        from_(&from),
        foot_m_(sight.foot_of(from.position_m)),
        velocity_mps_(reference.velocity_mps),
        light_speed_mps_(light_speed_mps) {}

  [[nodiscard]] const Vec3& foot_m() const { return foot_m_; }
  /// By how much the echo from the ground at a distance from the foot comes later than it would there.
  [[nodiscard]] double late_s(double range_m) const {
    const Vec3 point = sight_->ground_point(foot_m_, range_m);
    return delay_of(point, from_->position_m, from_->velocity_mps, light_speed_mps_) -
           delay_of(point, foot_m_, velocity_mps_, light_speed_mps_);
  }

 private:
  const Sight* sight_;
  const TrackPoint* from_;
  Vec3 foot_m_;
  Vec3 velocity_mps_;
  double light_speed_mps_;
};

// Moves a pulse towards earlier times: y(t) = x(t + late), by the shift theorem.
void advance(std::span<std::complex<double>> row, const Fft& fft, double late_samples) {
  const auto size = static_cast<double>(row.size());
  fft.forward(row);
  for (std::size_t k = 0; k < row.size(); ++k) {
    const double cycles = static_cast<double>(k) - (2 * k > row.size() ? size : 0.0);
    const std::complex<double> turn = turn_by(cycles / size * late_samples);
    // The highest frequency of an even length stands for both of its signs.
    row[k] *= (2 * k == row.size() ? std::complex<double>(turn.real()) : turn) / size;
  }
  fft.inverse(row);
}

void expect_sound(const SarEchoes& echoes) {
  expect(echoes.volts.size() == echoes.track.size() * echoes.samples,
         "motion compensation: the number of samples is not pulses times samples of a pulse");
  expect(echoes.waveform.sample_rate_hz > 0.0 && echoes.waveform.light_speed_mps > 0.0,
         "motion compensation: sampling rate and speed of light must be above 0");
}

// The range-dependent turn is smooth: it is computed at every so many samples, and by parabolas between.
constexpr std::size_t knot_spacing = 16;

void turn_by_range(std::span<std::complex<double>> row, const PulseShift& shift, const SarEchoes& echoes,
                   double common_s) {
  const SarWaveform& wave = echoes.waveform;
  const double spacing_m = 0.5 * wave.light_speed_mps / wave.sample_rate_hz;
  const double first_m = 0.5 * wave.light_speed_mps * echoes.first_delay_s;
  const auto turns_at = [&](double sample) {
    const double range_m = std::max(first_m + sample * spacing_m, spacing_m);
    return wave.carrier_hz * (shift.late_s(range_m) - common_s);
  };
  for (std::size_t first = 0; first < echoes.samples; first += knot_spacing) {
    constexpr auto span = static_cast<double>(knot_spacing);
    const auto begin = static_cast<double>(first);
    const double a = turns_at(begin);
    const double b = turns_at(begin + 0.5 * span);
    const double c = turns_at(begin + span);
    for (std::size_t i = first; i < std::min(first + knot_spacing, echoes.samples); ++i) {
      const double x = (static_cast<double>(i) - begin) / span;
      row[i] *= turn_by(a + x * (4.0 * b - 3.0 * a - c + x * (2.0 * a - 4.0 * b + 2.0 * c)));
    }
  }
}

// Places of pulses along a track, and the pulse, in between too, that stands at a given one.
class PlacesAlong {
 public:
  PlacesAlong(const std::vector<TrackPoint>& track, const ReferenceTrack& reference) {
    const double speed = norm(reference.velocity_mps);
    const Vec3 ahead = (1.0 / speed) * reference.velocity_mps;
    for (const TrackPoint& point : track) places_m_.push_back(dot(point.position_m - reference.position_m, ahead));
    for (std::size_t p = 1; p < places_m_.size(); ++p)
      expect(places_m_[p] > places_m_[p - 1], "azimuth resampling: the pulses do not ascend along the track");
  }

  [[nodiscard]] const std::vector<double>& places_m() const { return places_m_; }

  /// By the cubic through the four nearest pulses, whose slope ascends, and Newton's method.
  [[nodiscard]] double pulse_at(double place_m) const {
    const auto count = static_cast<long>(places_m_.size());
    const auto after = std::ranges::upper_bound(places_m_, place_m) - places_m_.begin();
    const long left = std::clamp<long>(static_cast<long>(after) - 1, 0, count - 2);
    const long first = std::clamp<long>(left - 1, 0, std::max<long>(count - 4, 0));
    const long points = std::min<long>(4, count);
    double x = static_cast<double>(left) + (place_m - at(left)) / (at(left + 1) - at(left));
    for (int round = 0; round < 3; ++round) {
      double value = 0.0, slope = 0.0;
      for (long k = first; k < first + points; ++k) add_lagrange(k, first, points, x, value, slope);
      x -= (value - place_m) / slope;
    }
    return x;
  }

 private:
  [[nodiscard]] double at(long p) const { return places_m_[static_cast<std::size_t>(p)]; }

  void add_lagrange(long k, long first, long points, double x, double& value, double& slope) const {
    double product = 1.0, derivative = 0.0;
    for (long m = first; m < first + points; ++m) {
      if (m == k) continue;
      const double factor = (x - static_cast<double>(m)) / static_cast<double>(k - m);
      derivative = derivative * factor + product / static_cast<double>(k - m);
      product *= factor;
    }
    value += at(k) * product;
    slope += at(k) * derivative;
  }

  std::vector<double> places_m_;
};

constexpr long taps = 16;

// Weights of the pulses first ... first + taps - 1 for the value at `pulse`.
std::array<double, taps> sinc_weights(double pulse, long first) {
  std::array<double, taps> weights{};
  for (long k = 0; k < taps; ++k) {
    const double x = pulse - static_cast<double>(first + k);
    const double sinc = x == 0.0 ? 1.0 : std::sin(pi * x) / (pi * x);
    weights[static_cast<std::size_t>(k)] = sinc * kaiser_window(x / (0.5 * taps), 4.7);
  }
  return weights;
}

}  // namespace

SarEchoes compensate_motion(const SarEchoes& echoes, const MotionCompensation& how, const WorkControl& control) {
  expect_sound(echoes);
  const Sight sight(how);
  const SarWaveform& wave = echoes.waveform;
  const double speed2 = dot(how.reference.velocity_mps, how.reference.velocity_mps);
  SarEchoes out = echoes;
  const Fft fft(good_fft_size(echoes.samples + guard_samples));
  parallel_ranges(echoes.track.size(), 16, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::complex<double>> row(fft.size());
    for (std::size_t p = begin; p < end; ++p) {
      const PulseShift shift(sight, echoes.track[p], how.reference, wave.light_speed_mps);
      const double common_s = shift.late_s(sight.range_m());
      const auto samples = std::span(echoes.volts).subspan(p * echoes.samples, echoes.samples);
      std::ranges::fill(row, 0.0);
      std::ranges::copy(samples, row.begin());
      advance(row, fft, common_s * wave.sample_rate_hz);
      const std::complex<double> turn = turn_by(wave.carrier_hz * common_s);
      for (std::size_t i = 0; i < echoes.samples; ++i) row[i] *= turn;
      if (how.second_order) turn_by_range(row, shift, echoes, common_s);
      for (std::size_t i = 0; i < echoes.samples; ++i) out.volts[p * echoes.samples + i] = std::complex<float>(row[i]);
      const Vec3 from_reference = shift.foot_m() - how.reference.position_m;
      out.track[p] = {how.reference.time_s + dot(from_reference, how.reference.velocity_mps) / speed2, shift.foot_m(),
                      how.reference.velocity_mps};
    }
  });
  return how.resample ? resample_azimuth(out, how.reference, how.squint_rad, control) : out;
}

SarEchoes resample_azimuth(const SarEchoes& echoes, const ReferenceTrack& reference, double squint_rad,
                           const WorkControl& control) {
  expect_sound(echoes);
  const double speed = norm(reference.velocity_mps);
  expect(speed > 0.0, "azimuth resampling: the reference track is at rest");
  const std::size_t pulses = echoes.track.size();
  if (pulses < 2) return echoes;
  const PlacesAlong places(echoes.track, reference);
  const double first_m = places.places_m().front();
  const double step_m = (places.places_m().back() - first_m) / static_cast<double>(pulses - 1);
  const double turns_per_m = 2.0 * std::sin(squint_rad) * echoes.waveform.carrier_hz / echoes.waveform.light_speed_mps;
  SarEchoes out = echoes;
  parallel_ranges(pulses, 16, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::complex<double>> sum(echoes.samples);
    for (std::size_t p = begin; p < end; ++p) {
      const double place_m = first_m + static_cast<double>(p) * step_m;
      const double pulse = places.pulse_at(place_m);
      const long first = static_cast<long>(std::floor(pulse)) - taps / 2 + 1;
      const auto weights = sinc_weights(pulse, first);
      std::ranges::fill(sum, 0.0);
      for (long k = 0; k < taps; ++k) {
        const long from = first + k;
        if (from < 0 || from >= static_cast<long>(pulses)) continue;
        const auto source = static_cast<std::size_t>(from);
        // The spectrum is interpolated about its middle: turned back there, and forth at the new place.
        const std::complex<double> weight =
            weights[static_cast<std::size_t>(k)] * turn_by(turns_per_m * (place_m - places.places_m()[source]));
        for (std::size_t i = 0; i < echoes.samples; ++i)
          sum[i] += weight * std::complex<double>(echoes.volts[source * echoes.samples + i]);
      }
      for (std::size_t i = 0; i < echoes.samples; ++i) out.volts[p * echoes.samples + i] = std::complex<float>(sum[i]);
      const double from_reference_s = place_m / speed;
      out.track[p] = {reference.time_s + from_reference_s,
                      reference.position_m + from_reference_s * reference.velocity_mps, reference.velocity_mps};
    }
  });
  return out;
}

}  // namespace sarsim

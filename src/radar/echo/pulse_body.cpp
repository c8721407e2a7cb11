#include "radar/echo/pulse_body.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

// A band-limited pulse is confined to -120 dB, not for ever: bodies with steps of a larger beta, for promises below
// 3e-8, take the skirts of its filter with them, half as much again on either side.
constexpr double beta_of_skirts = 20.8;

constexpr std::size_t step_points = 4096;  // cubic interpolation between them: error below 1e-12

// Integral of Kaiser's window from -1 to 2x - 1, normalised to 1, tabulated for x in [0, 1]: Simpson's rule on the
// rising half, the other is its mirror image.
std::vector<double> kaiser_step(double beta) {
  constexpr std::size_t panels = 1;
  std::vector<double> table(step_points + 1, 0.0);
  const auto window = [&](std::size_t node) {
    const double x = static_cast<double>(node) / (2.0 * panels * step_points);
    return core::bessel_i0(beta * 2.0 * std::sqrt(x * (1.0 - x)));
  };
  double before = window(0);
  for (std::size_t i = 0; i < step_points / 2; ++i) {
    double sum = before;
    for (std::size_t k = 1; k < 2 * panels; ++k) sum += (k % 2 == 1 ? 4.0 : 2.0) * window(2 * panels * i + k);
    before = window(2 * panels * (i + 1));
    table[i + 1] = table[i] + sum + before;
  }
  const double whole = 2.0 * table[step_points / 2];
  for (std::size_t i = 0; i <= step_points / 2; ++i) {
    table[i] /= whole;
    table[step_points - i] = 1.0 - table[i];
  }
  return table;
}

}  // namespace

PulseBody::PulseBody(const EchoPulse& pulse, double interval_s, std::size_t edge_samples, double beta)
    : pulse_(&pulse),
      interval_s_(interval_s),
      first_((pulse.first_s() + pulse.lead_s) / interval_s),
      last_((pulse.last_s() + pulse.lead_s) / interval_s),
      width_(static_cast<double>(edge_samples)),
      step_table_(kaiser_step(beta)) {
  CORE_EXPECT(interval_s > 0.0);
  CORE_EXPECT(edge_samples > 0);
  CORE_EXPECT(beta > 0.0);
  const double margin = std::sqrt(1.0 + (beta / core::pi) * (beta / core::pi)) / width_;
  // The sampled band as a rule; more where a pulse keeps its own band and is sampled more slowly than that.
  if (pulse.band_limited)
    half_band_ = std::max(0.5, pulse.band_limited->half_band_hz() * interval_s) * (beta > beta_of_skirts ? 1.5 : 1.0);
  else
    half_band_ =
        0.5 * bandwidth_hz(pulse.pulse) * interval_s * (pulse.pulse.kind == Pulse::Kind::user ? 2.0 : 1.0) + margin;
  find_edges(edge_samples);
  if (pulse.band_limited && !edges_.empty()) half_band_ += margin;
}

void PulseBody::find_edges(std::size_t edge_samples) {
  std::vector<double> borders;
  if (pulse_->band_limited) {
    // The filtered pulse ends smoothly unless it was cut to a kept width.
    const BandLimitedPulse& p = *pulse_->band_limited;
    const double largest = std::abs(p.value(0.5 * pulse_->pulse.width_s));
    const bool cut = std::abs(p.value(p.first_s())) > 1e-7 * largest ||
                     std::abs(p.value(p.last_s() - 1e-6 * interval_s_)) > 1e-7 * largest;
    if (!cut) return;
    borders = {first_, last_};
  } else {
    borders = {0.0};
    for (const double t : pulse_->pulse.breaks_s()) borders.push_back(t / interval_s_);
    borders.push_back(pulse_->pulse.width_s / interval_s_);
  }
  const auto room = static_cast<double>(edge_samples);
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    if (borders[i + 1] - borders[i] < 2.0 * room) {
      has_body_ = false;
      return;
    }
    edges_.push_back({borders[i], true});
    edges_.push_back({borders[i + 1] - room, false});
  }
}

std::complex<double> PulseBody::value(double t) const {
  const double t_s = t * interval_s_;
  return pulse_->band_limited ? pulse_->band_limited->value(t_s) : pulse_->pulse.value(t_s);
}

double PulseBody::step(double x) const {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  const double position = x * step_points;
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(position), step_points - 1);
  const double u = position - static_cast<double>(i);
  const auto at = [&](std::ptrdiff_t k) {
    if (k < 0) return 0.0;
    return step_table_[std::min<std::size_t>(static_cast<std::size_t>(k), step_points)];
  };
  const auto k = static_cast<std::ptrdiff_t>(i);
  // Cubic through four neighbours (Lagrange).
  return at(k - 1) * (-u * (u - 1.0) * (u - 2.0) / 6.0) + at(k) * ((u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0) +
         at(k + 1) * (-(u + 1.0) * u * (u - 2.0) / 2.0) + at(k + 2) * ((u + 1.0) * u * (u - 1.0) / 6.0);
}

double PulseBody::body_share(double t) const {
  if (t < first_ || t > last_) return 0.0;
  for (const Edge& edge : edges_) {
    const double x = (t - edge.start) / width_;
    if (x >= 0.0 && x < 1.0) return step(edge.rising ? x : 1.0 - x);
  }
  return t >= last_ && !edges_.empty() ? 0.0 : 1.0;
}

double PulseBody::from_middle_s(double t) const { return t * interval_s_ - 0.5 * pulse_->pulse.width_s; }

double PulseBody::received(double t, const PulseClock& clock) const {
  if (pulse_->doppler_rule == DopplerRule::thesis) return t;
  return t + clock.late_of(from_middle_s(t)) / interval_s_;
}

// As `body_share`, each edge region as long as ever and fast to its hard edge as that comes back.
double PulseBody::share_of_echo(double t, const PulseClock& clock) const {
  if (t < received(first_, clock) || t > received(last_, clock)) return 0.0;
  for (const Edge& edge : edges_) {
    const double hard = received(edge.rising ? edge.start : edge.start + width_, clock);
    const double x = (edge.rising ? t - hard : hard - t) / width_;
    if (x >= 0.0 && x < 1.0) return step(x);
  }
  return 1.0;
}

std::complex<double> PulseBody::echo(double t, const PulseClock& clock, double carrier_hz) const {
  const bool even = pulse_->doppler_rule == DopplerRule::thesis || clock.ticks_evenly();
  const double share = even ? body_share(t) : share_of_echo(t, clock);
  return share == 0.0 ? 0.0 : part_of_echo(share, t, clock, carrier_hz);
}

std::complex<double> PulseBody::endless_echo(double t, const PulseClock& clock, double carrier_hz) const {
  return part_of_echo(1.0, t, clock, carrier_hz);
}

std::complex<double> PulseBody::part_of_echo(double share, double t, const PulseClock& clock, double carrier_hz) const {
  const auto turned = [](double turns) { return std::polar(1.0, -2.0 * core::pi * (turns - std::round(turns))); };
  if (pulse_->doppler_rule == DopplerRule::thesis || clock.ticks_evenly())
    return share * value(t) * turned(clock.doppler * doppler_turns(t, carrier_hz));
  const double late_s = clock.late(from_middle_s(t));
  return share * value(t - late_s / interval_s_) * turned(carrier_hz * late_s);
}

double PulseBody::largest_doppler_turns(double carrier_hz) const {
  if (pulse_->doppler_rule == DopplerRule::stretch) {
    const double farthest_s = std::max(std::abs(from_middle_s(first_)), std::abs(from_middle_s(last_)));
    return (std::abs(carrier_hz) + half_band_ / interval_s_) * farthest_s;
  }
  double largest = 0.0;
  for (int i = 0; i <= 16; ++i)
    largest = std::max(largest, std::abs(doppler_turns(first_ + (last_ - first_) * i / 16.0, carrier_hz)));
  return largest;
}

double PulseBody::doppler_turns(double t, double carrier_hz) const {
  const double u = from_middle_s(t);
  return (carrier_hz + 0.5 * pulse_->pulse.sweep_rate_hz_per_s() * u) * u;
}

double PulseBody::largest_frequency_hz(double carrier_hz) const {
  const double middle = 0.5 * pulse_->pulse.width_s / interval_s_;
  const double farthest_s = std::max(std::abs(first_ - middle), std::abs(last_ - middle)) * interval_s_;
  return carrier_hz + std::abs(pulse_->pulse.sweep_rate_hz_per_s()) * farthest_s;
}

}  // namespace sarsim::radar

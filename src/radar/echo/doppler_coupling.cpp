#include "radar/echo/doppler_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/echo/doppler_terms.hpp"

namespace sarsim::radar {

namespace {

// Places on a body, close together where it may change fast: at its ends and beside its edges.
class Places {
 public:
  explicit Places(const PulseBody& body) : last_(body.last() + 1.0), coarse_((body.last() - body.first()) / 2000.0) {
    coarse_ = std::max(coarse_, fine);
    steep_ = {body.first(), body.last()};
    for (const PulseBody::Edge& edge : body.edges()) steep_.push_back(edge.start);
    std::ranges::sort(steep_);
    at_ = body.first() - 1.0;
  }

  [[nodiscard]] bool is_over() const { return at_ > last_; }
  [[nodiscard]] double at() const { return at_; }
  // To the next place; returns how far that is.
  double go_on() {
    while (next_ < steep_.size() && steep_[next_] + reach < at_) ++next_;
    const bool near = next_ < steep_.size() && steep_[next_] - reach < at_ + coarse_;
    const double step = near ? fine : coarse_;
    at_ += step;
    return step;
  }

 private:
  static constexpr double fine = 0.25;
  static constexpr double reach = 24.0;
  double last_;
  double coarse_;
  std::vector<double> steep_;
  std::size_t next_ = 0;
  double at_ = 0.0;
};

}  // namespace

double DopplerCoupling::remainder(std::size_t terms, double half) const {
  CORE_EXPECT(terms > 0);
  if (terms == 1) return (change + 0.5 * curvature * half) * half;
  double bound = 0.25 * curvature * half * half;
  for (std::size_t r = 3; r <= terms; ++r) bound *= 0.5 * half * fastest_rad / static_cast<double>(r);
  return bound;
}

std::size_t DopplerCoupling::terms_for(double half, double error) const {
  CORE_EXPECT(error > 0.0);
  std::size_t terms = 1;
  while (terms <= max_doppler_terms && !(remainder(terms, half) < error)) ++terms;
  return terms;
}

double DopplerCoupling::widest(std::size_t terms, double interval_s, double error) const {
  CORE_EXPECT(terms > 0);
  CORE_EXPECT(error > 0.0);
  const double by_shift = interval_s / std::abs(shift_s);  // infinite without one
  if (terms == 1)
    return std::min(by_shift, 2.0 * error / (change + std::sqrt(change * change + 2.0 * curvature * error)));
  double power = error / (0.25 * curvature);
  for (std::size_t r = 3; r <= terms; ++r) power *= 2.0 * static_cast<double>(r) / fastest_rad;
  return std::min(by_shift, std::pow(power, 1.0 / static_cast<double>(terms)));
}

DopplerCoupling no_coupling(const PulseBody& body, double carrier_hz) {
  const double rad = largest_doppler_rad(body, carrier_hz);
  return {0.0, rad, rad * rad, rad};
}

DopplerCoupling coupling_of(const EchoPulse& pulse, const PulseBody& body, double interval_s, double carrier_hz) {
  CORE_EXPECT(interval_s > 0.0);
  const DopplerCoupling plain = no_coupling(body, carrier_hz);
  const double sweep = pulse.pulse.sweep_rate_hz_per_s();
  constexpr double longest = 0x1p28;  // Samples of a pulse: longer ones are asked about, but hardly simulated.
  if (pulse.pulse.kind != Pulse::Kind::chirp || sweep == 0.0 || !(plain.change > 0.0)) return plain;
  if (!(body.last() - body.first() <= longest)) return plain;
  // Far enough for differences of doubles, near enough for derivatives.
  const double half = 0.01 / plain.change;
  DopplerCoupling coupled;
  coupled.shift_s = carrier_hz / sweep;
  double power = 0.0;
  double change = 0.0;
  double curvature = 0.0;
  for (Places places(body); !places.is_over();) {
    const double t = places.at();
    const double weight = places.go_on();
    const double moved = coupled.shift_s * half / interval_s;
    const std::complex<double> here = body.echo(t, {}, carrier_hz);
    const std::complex<double> above = body.echo(t + moved, {half, 0.0}, carrier_hz);
    const std::complex<double> below = body.echo(t - moved, {-half, 0.0}, carrier_hz);
    power += weight * std::norm(here);
    change += weight * std::norm(above - below);
    curvature += weight * std::norm(above - 2.0 * here + below);
  }
  if (!(power > 0.0)) return plain;
  coupled.change = std::sqrt(change / power) / (2.0 * half);
  coupled.curvature = std::sqrt(curvature / power) / (half * half);
  // The ends move against the pulse by the shift, at frequencies of the body's band.
  coupled.fastest_rad = plain.fastest_rad + 2.0 * core::pi * std::abs(coupled.shift_s) * body.half_band() / interval_s;
  return coupled.change < plain.change ? coupled : plain;
}

DopplerCoupling best_coupling(const DopplerCoupling& coupled, const PulseBody& body, double carrier_hz, double half,
                              double interval_s, double error) {
  CORE_EXPECT(interval_s > 0.0);
  const DopplerCoupling plain = no_coupling(body, carrier_hz);
  if (std::abs(coupled.shift_s) * half > interval_s) return plain;
  return coupled.terms_for(half, error) < plain.terms_for(half, error) ? coupled : plain;
}

}  // namespace sarsim::radar

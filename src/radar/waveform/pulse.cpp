#include "radar/waveform/pulse.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/waveform/pulse_shape.hpp"

namespace sarsim::radar {

const std::vector<int>& barker_code(int index) {
  static const std::array<std::vector<int>, 7> codes{{{1, -1},
                                                      {1, 1, -1},
                                                      {1, 1, -1, 1},
                                                      {1, 1, 1, -1, 1},
                                                      {1, 1, 1, -1, -1, 1, -1},
                                                      {1, 1, 1, -1, -1, -1, 1, -1, -1, 1, -1},
                                                      {1, 1, 1, 1, 1, -1, -1, 1, 1, -1, 1, -1, 1}}};
  return codes.at(static_cast<std::size_t>(index));
}

std::complex<double> Pulse::value(double t_s, double tolerance_s) const {
  const double gain = envelope_value(t_s);
  switch (kind) {
    case Kind::mono: return gain;
    case Kind::chirp: {
      const double u = t_s - 0.5 * width_s;
      return std::polar(1.0, core::pi * sweep_rate_hz_per_s() * u * u) * gain;
    }
    case Kind::code: {
      const auto length = static_cast<double>(code.size());
      const double chip = std::clamp(std::floor((t_s + tolerance_s) * length / width_s), 0.0, length - 1.0);
      return gain * code[static_cast<std::size_t>(chip)];
    }
    case Kind::user: return gain * std::complex(in_phase.value(t_s / width_s), quadrature.value(t_s / width_s));
  }
  return 0.0;
}

double Pulse::envelope_value(double t_s) const {
  switch (envelope) {
    case Envelope::rectangular: return 1.0;
    case Envelope::linear: {
      const double rising = t_s < rise_s ? t_s / rise_s : 1.0;
      const double falling = t_s > width_s - fall_s ? (width_s - t_s) / fall_s : 1.0;
      return std::max(0.0, std::min(rising, falling));
    }
    case Envelope::user: return envelope_gain.value(t_s / width_s);
  }
  return 1.0;
}

std::vector<double> Pulse::breaks_s() const {
  std::vector<double> breaks;
  const auto add = [&](double t) {
    if (t > 0.0 && t < width_s) breaks.push_back(t);
  };
  if (kind == Kind::code)
    for (std::size_t i = 1; i < code.size(); ++i)
      add(width_s * static_cast<double>(i) / static_cast<double>(code.size()));
  if (kind == Kind::user)
    for (const core::Interpolator* part : {&in_phase, &quadrature})
      for (const core::Knot& knot : part->knots()) add(knot.x * width_s);
  if (envelope == Envelope::linear) {
    // A rise that meets the fall goes no further.
    const bool meet = rise_s + fall_s > width_s;
    const double meeting_s = meet ? width_s * (rise_s / (rise_s + fall_s)) : 0.0;
    add(meet ? meeting_s : rise_s);
    add(meet ? meeting_s : width_s - fall_s);
  }
  if (envelope == Envelope::user)
    for (const core::Knot& knot : envelope_gain.knots()) add(knot.x * width_s);
  std::ranges::sort(breaks);
  const auto same = std::ranges::unique(breaks);
  breaks.erase(same.begin(), same.end());
  return breaks;
}

double bandwidth_hz(const Pulse& pulse) {
  switch (pulse.kind) {
    case Pulse::Kind::mono: return 1.0 / pulse.width_s;
    case Pulse::Kind::chirp: return std::abs(pulse.sweep_hz);
    case Pulse::Kind::code: return static_cast<double>(pulse.code.size()) / pulse.width_s;
    case Pulse::Kind::user: return energy_band_hz(pulse, 0.99);
  }
  return 0.0;
}

}  // namespace sarsim::radar

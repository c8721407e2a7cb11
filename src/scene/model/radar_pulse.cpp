#include "scene/model/radar_pulse.hpp"

namespace sarsim {

Pulse pulse_of(const Radar& radar, LowPassRule rule) {
  Pulse pulse;
  pulse.width_s = radar.pulse_width_s;
  switch (radar.pulse) {
    case Radar::Pulse::mono: pulse.kind = Pulse::Kind::mono; break;
    case Radar::Pulse::chirp:
      pulse.kind = Pulse::Kind::chirp;
      pulse.sweep_hz = radar.bandwidth_hz;
      break;
    case Radar::Pulse::barker:
      pulse.kind = Pulse::Kind::code;
      pulse.code = barker_code(radar.barker_code);
      break;
    case Radar::Pulse::user:
      pulse.kind = Pulse::Kind::user;
      pulse.in_phase = Interpolator(radar.pulse_iq.part[0], rule);
      pulse.quadrature = Interpolator(radar.pulse_iq.part[1], rule);
      break;
  }
  switch (radar.envelope) {
    case Radar::Envelope::rectangular: break;
    case Radar::Envelope::linear:
      pulse.envelope = Pulse::Envelope::linear;
      pulse.rise_s = radar.rise_s;
      pulse.fall_s = radar.fall_s;
      break;
    case Radar::Envelope::user:
      pulse.envelope = Pulse::Envelope::user;
      pulse.envelope_gain = Interpolator(radar.envelope_gain.part[0], rule);
      break;
  }
  return pulse;
}

}  // namespace sarsim

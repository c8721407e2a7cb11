#include "scene/model/radar_pulse.hpp"

#include "scene/model/function_role.hpp"

namespace sarsim::scene {

radar::Pulse pulse_of(const Radar& radar) { return pulse_of(radar, rules_for(FunctionRole::pulse, {})); }

radar::Pulse pulse_of(const Radar& radar, core::InterpolationRules rules) {
  radar::Pulse pulse;
  pulse.width_s = radar.pulse_width_s;
  switch (radar.pulse) {
    case Radar::Pulse::mono: pulse.kind = radar::Pulse::Kind::mono; break;
    case Radar::Pulse::chirp:
      pulse.kind = radar::Pulse::Kind::chirp;
      pulse.sweep_hz = radar.bandwidth_hz;
      break;
    case Radar::Pulse::barker:
      pulse.kind = radar::Pulse::Kind::code;
      pulse.code = radar::barker_code(radar.barker_code);
      break;
    case Radar::Pulse::user:
      pulse.kind = radar::Pulse::Kind::user;
      pulse.in_phase = core::Interpolator(radar.pulse_iq.part[0], rules);
      pulse.quadrature = core::Interpolator(radar.pulse_iq.part[1], rules);
      break;
  }
  switch (radar.envelope) {
    case Radar::Envelope::rectangular: break;
    case Radar::Envelope::linear:
      pulse.envelope = radar::Pulse::Envelope::linear;
      pulse.rise_s = radar.rise_s;
      pulse.fall_s = radar.fall_s;
      break;
    case Radar::Envelope::user:
      pulse.envelope = radar::Pulse::Envelope::user;
      pulse.envelope_gain = core::Interpolator(radar.envelope_gain.part[0], rules);
      break;
  }
  return pulse;
}

}  // namespace sarsim::scene

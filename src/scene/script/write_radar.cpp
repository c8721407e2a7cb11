#include "scene/schema/radar_grammar.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::script {

namespace {

namespace grammar = radar_grammar;

void write_pulse(ScriptLines& lines, const Radar& radar) {
  lines.choice(grammar::pulses, radar.pulse);
  switch (radar.pulse) {
    case Radar::Pulse::mono: break;
    case Radar::Pulse::chirp: lines.number(grammar::bandwidth, radar.bandwidth_hz); break;
    case Radar::Pulse::user: lines.function(function_blocks::pulse_iq, radar.pulse_iq); break;
    case Radar::Pulse::barker: lines.integer(grammar::barker_code, radar.barker_code); break;
  }
  lines.number(grammar::pulse_width, radar.pulse_width_s);
  lines.choice(grammar::envelopes, radar.envelope);
  if (radar.envelope == Radar::Envelope::linear) {
    lines.number(grammar::rise, radar.rise_s);
    lines.number(grammar::fall, radar.fall_s);
  } else if (radar.envelope == Radar::Envelope::user) {
    lines.function(function_blocks::envelope_gain, radar.envelope_gain);
  }
}

void write_schedule(ScriptLines& lines, const Radar& radar) {
  lines.choice(grammar::repetitions, radar.repetition);
  if (radar.repetition == Radar::Repetition::constant)
    lines.number(grammar::prf, radar.prf_hz);
  else
    lines.function(function_blocks::pri, radar.pri_s);
  lines.choice(grammar::carriers, radar.carrier);
  switch (radar.carrier) {
    case Radar::Carrier::single: lines.number(grammar::carrier_single, radar.carrier_hz); break;
    case Radar::Carrier::stepped:
      lines.number(grammar::carrier_start, radar.carrier_hz);
      lines.number(grammar::carrier_step, radar.carrier_step_hz);
      lines.integer(grammar::carrier_steps, radar.carrier_steps);
      lines.integer(grammar::pulses_per_step, radar.pulses_per_step);
      break;
    case Radar::Carrier::user: lines.function(function_blocks::carrier_list, radar.carrier_list_hz); break;
  }
}

void write_power(ScriptLines& lines, const Radar& radar) {
  lines.number(grammar::power, radar.power_w);
  // Programs before 2015 know no gains; a radar without any stays readable for them.
  if (radar.transmit_gain.db() != 0.0 || radar.receive_gain.db() != 0.0) {
    lines.number(grammar::transmit_gain, radar.transmit_gain.db());
    lines.number(grammar::receive_gain, radar.receive_gain.db());
  }
  lines.number(grammar::losses, radar.losses.db());
  lines.number(grammar::noise_temperature, radar.noise_temperature_k);
}

grammar::ReceivePattern receive_pattern(const Radar& radar) {
  if (radar.same_antenna) return grammar::ReceivePattern::same;
  switch (radar.receive_antenna.pattern) {
    case Antenna::Pattern::isotropic: return grammar::ReceivePattern::isotropic;
    case Antenna::Pattern::sinx: return grammar::ReceivePattern::sinx;
    case Antenna::Pattern::user: return grammar::ReceivePattern::user;
  }
  return grammar::ReceivePattern::same;
}

void write_antennas(ScriptLines& lines, const Radar& radar) {
  const Antenna& transmit = radar.transmit_antenna;
  lines.choice(grammar::transmit_patterns, transmit.pattern);
  if (transmit.pattern == Antenna::Pattern::sinx) {
    lines.number(grammar::transmit_elevation, transmit.elevation_beamwidth.deg());
    lines.number(grammar::transmit_azimuth, transmit.azimuth_beamwidth.deg());
  } else if (transmit.pattern == Antenna::Pattern::user) {
    lines.function(function_blocks::transmit_gain, transmit.gain_db);
  }
  const Antenna& receive = radar.receive_antenna;
  const grammar::ReceivePattern pattern = receive_pattern(radar);
  lines.choice(grammar::receive_patterns, pattern);
  if (pattern == grammar::ReceivePattern::sinx) {
    lines.number(grammar::receive_elevation, receive.elevation_beamwidth.deg());
    lines.number(grammar::receive_azimuth, receive.azimuth_beamwidth.deg());
  } else if (pattern == grammar::ReceivePattern::user) {
    lines.function(function_blocks::receive_gain, receive.gain_db);
  }
}

void write_beam(ScriptLines& lines, const Radar& radar) {
  lines.choice(grammar::beams, radar.beam);
  switch (radar.beam) {
    case Radar::Beam::fixed:
      lines.number(grammar::beam_elevation, radar.beam_elevation.deg());
      lines.number(grammar::beam_azimuth, radar.beam_azimuth.deg());
      break;
    case Radar::Beam::rotating:
      lines.number(grammar::beam_elevation, radar.beam_elevation.deg());
      lines.number(grammar::beam_rate, radar.beam_rate.deg());
      break;
    case Radar::Beam::spot: lines.vector(grammar::spot, radar.spot_world_m); break;
    case Radar::Beam::user: lines.function(function_blocks::beam_target, radar.beam_target_world_m); break;
  }
}

void write_receiver(ScriptLines& lines, const Radar& radar) {
  lines.choice(grammar::windows, radar.window);
  if (radar.window == Radar::Window::hanning)
    lines.number(grammar::hanning_pedestal, radar.hanning_pedestal);
  else if (radar.window == Radar::Window::user)
    lines.function(function_blocks::window_gain, radar.window_gain);
  lines.choice(grammar::stc_switches, radar.stc != Radar::Stc::none);
  if (radar.stc == Radar::Stc::none) return;
  lines.choice(grammar::stc_laws, radar.stc);
  if (radar.stc == Radar::Stc::user) lines.function(function_blocks::stc_gain, radar.stc_gain);
}

}  // namespace

void write_radar(ScriptLines& lines, const Radar& radar) {
  lines.plain("$RADAR");
  lines.name(grammar::name, radar.name);
  lines.name(grammar::platform, radar.platform);
  write_pulse(lines, radar);
  write_schedule(lines, radar);
  write_power(lines, radar);
  write_antennas(lines, radar);
  write_beam(lines, radar);
  write_receiver(lines, radar);
  lines.blank(2);
}

}  // namespace sarsim::script

#include "scene/schema/radar_grammar.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

namespace {

void write_pulse(ScriptLines& lines, const Radar& radar) {
  lines.choice(radar_grammar::pulses, radar.pulse);
  switch (radar.pulse) {
    case Radar::Pulse::mono: break;
    case Radar::Pulse::chirp: lines.number(radar_grammar::bandwidth, radar.bandwidth_hz); break;
    case Radar::Pulse::user: lines.function(function_blocks::pulse_iq, radar.pulse_iq); break;
    case Radar::Pulse::barker: lines.integer(radar_grammar::barker_code, radar.barker_code); break;
  }
  lines.number(radar_grammar::pulse_width, radar.pulse_width_s);
  lines.choice(radar_grammar::envelopes, radar.envelope);
  if (radar.envelope == Radar::Envelope::linear) {
    lines.number(radar_grammar::rise, radar.rise_s);
    lines.number(radar_grammar::fall, radar.fall_s);
  } else if (radar.envelope == Radar::Envelope::user) {
    lines.function(function_blocks::envelope_gain, radar.envelope_gain);
  }
}

void write_schedule(ScriptLines& lines, const Radar& radar) {
  lines.choice(radar_grammar::repetitions, radar.repetition);
  if (radar.repetition == Radar::Repetition::constant)
    lines.number(radar_grammar::prf, radar.prf_hz);
  else
    lines.function(function_blocks::pri, radar.pri_s);
  lines.choice(radar_grammar::carriers, radar.carrier);
  switch (radar.carrier) {
    case Radar::Carrier::single: lines.number(radar_grammar::carrier_single, radar.carrier_hz); break;
    case Radar::Carrier::stepped:
      lines.number(radar_grammar::carrier_start, radar.carrier_hz);
      lines.number(radar_grammar::carrier_step, radar.carrier_step_hz);
      lines.integer(radar_grammar::carrier_steps, radar.carrier_steps);
      lines.integer(radar_grammar::pulses_per_step, radar.pulses_per_step);
      break;
    case Radar::Carrier::user: lines.function(function_blocks::carrier_list, radar.carrier_list_hz); break;
  }
}

void write_power(ScriptLines& lines, const Radar& radar) {
  lines.number(radar_grammar::power, radar.power_w);
  // Programs before 2015 know no gains; a radar without any stays readable for them.
  if (radar.transmit_gain.db() != 0.0 || radar.receive_gain.db() != 0.0) {
    lines.number(radar_grammar::transmit_gain, radar.transmit_gain.db());
    lines.number(radar_grammar::receive_gain, radar.receive_gain.db());
  }
  lines.number(radar_grammar::losses, radar.losses.db());
  lines.number(radar_grammar::noise_temperature, radar.noise_temperature_k);
}

radar_grammar::ReceivePattern receive_pattern(const Radar& radar) {
  if (radar.same_antenna) return radar_grammar::ReceivePattern::same;
  switch (radar.receive_antenna.pattern) {
    case Antenna::Pattern::isotropic: return radar_grammar::ReceivePattern::isotropic;
    case Antenna::Pattern::sinx: return radar_grammar::ReceivePattern::sinx;
    case Antenna::Pattern::user: return radar_grammar::ReceivePattern::user;
  }
  return radar_grammar::ReceivePattern::same;
}

void write_antennas(ScriptLines& lines, const Radar& radar) {
  const Antenna& transmit = radar.transmit_antenna;
  lines.choice(radar_grammar::transmit_patterns, transmit.pattern);
  if (transmit.pattern == Antenna::Pattern::sinx) {
    lines.number(radar_grammar::transmit_elevation, transmit.elevation_beamwidth.deg());
    lines.number(radar_grammar::transmit_azimuth, transmit.azimuth_beamwidth.deg());
  } else if (transmit.pattern == Antenna::Pattern::user) {
    lines.function(function_blocks::transmit_gain, transmit.gain_db);
  }
  const Antenna& receive = radar.receive_antenna;
  const radar_grammar::ReceivePattern pattern = receive_pattern(radar);
  lines.choice(radar_grammar::receive_patterns, pattern);
  if (pattern == radar_grammar::ReceivePattern::sinx) {
    lines.number(radar_grammar::receive_elevation, receive.elevation_beamwidth.deg());
    lines.number(radar_grammar::receive_azimuth, receive.azimuth_beamwidth.deg());
  } else if (pattern == radar_grammar::ReceivePattern::user) {
    lines.function(function_blocks::receive_gain, receive.gain_db);
  }
}

void write_beam(ScriptLines& lines, const Radar& radar) {
  lines.choice(radar_grammar::beams, radar.beam);
  switch (radar.beam) {
    case Radar::Beam::fixed:
      lines.number(radar_grammar::beam_elevation, radar.beam_elevation.deg());
      lines.number(radar_grammar::beam_azimuth, radar.beam_azimuth.deg());
      break;
    case Radar::Beam::rotating:
      lines.number(radar_grammar::beam_elevation, radar.beam_elevation.deg());
      lines.number(radar_grammar::beam_rate, radar.beam_rate.deg());
      break;
    case Radar::Beam::spot: lines.vector(radar_grammar::spot, radar.spot_world_m); break;
    case Radar::Beam::user: lines.function(function_blocks::beam_target, radar.beam_target_world_m); break;
  }
}

void write_receiver(ScriptLines& lines, const Radar& radar) {
  lines.choice(radar_grammar::windows, radar.window);
  if (radar.window == Radar::Window::hanning)
    lines.number(radar_grammar::hanning_pedestal, radar.hanning_pedestal);
  else if (radar.window == Radar::Window::user)
    lines.function(function_blocks::window_gain, radar.window_gain);
  lines.choice(radar_grammar::stc_switches, radar.stc != Radar::Stc::none);
  if (radar.stc == Radar::Stc::none) return;
  lines.choice(radar_grammar::stc_laws, radar.stc);
  if (radar.stc == Radar::Stc::user) lines.function(function_blocks::stc_gain, radar.stc_gain);
}

}  // namespace

void write_radar(ScriptLines& lines, const Radar& radar) {
  lines.plain("$RADAR");
  lines.name(radar_grammar::name, radar.name);
  lines.name(radar_grammar::platform, radar.platform);
  write_pulse(lines, radar);
  write_schedule(lines, radar);
  write_power(lines, radar);
  write_antennas(lines, radar);
  write_beam(lines, radar);
  write_receiver(lines, radar);
  lines.blank(2);
}

}  // namespace sarsim::scene::script

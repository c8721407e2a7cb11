#include <fmt/format.h>

#include "scene/schema/radar_grammar.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

namespace {

void read_pulse(FieldReader& reader, Radar& radar) {
  reader.choice(radar_grammar::pulse, radar_grammar::pulses, radar.pulse);
  switch (radar.pulse) {
    case Radar::Pulse::mono: break;
    case Radar::Pulse::chirp: reader.number(radar_grammar::bandwidth, radar.bandwidth_hz); break;
    case Radar::Pulse::user: reader.function(radar_grammar::pulse_iq, function_blocks::pulse_iq, radar.pulse_iq); break;
    case Radar::Pulse::barker: reader.integer(radar_grammar::barker_code, radar.barker_code); break;
  }
  reader.number(radar_grammar::pulse_width, radar.pulse_width_s);
  reader.choice(radar_grammar::envelope, radar_grammar::envelopes, radar.envelope);
  if (radar.envelope == Radar::Envelope::linear) {
    reader.number(radar_grammar::rise, radar.rise_s);
    reader.number(radar_grammar::fall, radar.fall_s);
  } else if (radar.envelope == Radar::Envelope::user) {
    reader.function(radar_grammar::envelope_gain, function_blocks::envelope_gain, radar.envelope_gain);
  }
}

void read_schedule(FieldReader& reader, Radar& radar) {
  reader.choice(radar_grammar::repetition, radar_grammar::repetitions, radar.repetition);
  if (radar.repetition == Radar::Repetition::constant)
    reader.number(radar_grammar::prf, radar.prf_hz);
  else
    reader.function(radar_grammar::pri, function_blocks::pri, radar.pri_s);
  reader.choice(radar_grammar::carrier, radar_grammar::carriers, radar.carrier);
  switch (radar.carrier) {
    case Radar::Carrier::single: reader.number(radar_grammar::carrier_single, radar.carrier_hz); break;
    case Radar::Carrier::stepped:
      reader.number(radar_grammar::carrier_start, radar.carrier_hz);
      reader.number(radar_grammar::carrier_step, radar.carrier_step_hz);
      reader.integer(radar_grammar::carrier_steps, radar.carrier_steps);
      reader.integer(radar_grammar::pulses_per_step, radar.pulses_per_step);
      break;
    case Radar::Carrier::user:
      reader.function(radar_grammar::carrier_list, function_blocks::carrier_list, radar.carrier_list_hz);
      break;
  }
}

bool is_antenna(std::string_view word) {
  for (const auto& pattern : radar_grammar::transmit_patterns)
    if (keyword_matches(word, pattern.word)) return true;
  return false;
}

// How many values stand before the transmit antenna: two (losses, noise), or four with the gains that the 2015 program
// added. Where no antenna follows soon, only what looks like a number counts.
std::size_t values_before_antenna(const FieldReader& reader) {
  constexpr std::size_t far_enough = 8;
  Tokens ahead = reader.tokens();
  std::size_t numbers = 0;
  bool only_numbers = true;
  for (std::size_t values = 0; values < far_enough && ahead.peek().is_value(); ++values) {
    const Token token = ahead.take();
    if (is_antenna(token.text)) return values;
    only_numbers = only_numbers && begins_like_number(token.text);
    if (only_numbers) ++numbers;
  }
  return numbers >= 4 ? 4 : 2;
}

void read_power(FieldReader& reader, Radar& radar) {
  reader.number(radar_grammar::power, radar.power_w);
  const std::size_t values = reader.more() ? values_before_antenna(reader) : 2;
  if (values == 3 || values > 4) {
    reader.pass_over(
        radar_grammar::losses, values,
        {fmt::format("{} values between the power and the transmit antenna", values), shown(reader.peek().text),
         "2 (losses in dB, noise temperature in K), or 4 (gains of transmitter and receiver in dB first)"});
    return;
  }
  if (values == 4) {
    reader.decibels(radar_grammar::transmit_gain, radar.transmit_gain);
    reader.decibels(radar_grammar::receive_gain, radar.receive_gain);
  }
  reader.decibels(radar_grammar::losses, radar.losses);
  reader.number(radar_grammar::noise_temperature, radar.noise_temperature_k);
}

void read_antennas(FieldReader& reader, Radar& radar) {
  Antenna& transmit = radar.transmit_antenna;
  reader.choice(radar_grammar::transmit_antenna, radar_grammar::transmit_patterns, transmit.pattern);
  if (transmit.pattern == Antenna::Pattern::sinx) {
    reader.angle(radar_grammar::transmit_elevation, transmit.elevation_beamwidth);
    reader.angle(radar_grammar::transmit_azimuth, transmit.azimuth_beamwidth);
  } else if (transmit.pattern == Antenna::Pattern::user) {
    reader.function(radar_grammar::transmit_user, function_blocks::transmit_gain, transmit.gain_db);
  }
  Antenna& receive = radar.receive_antenna;
  auto pattern = radar_grammar::ReceivePattern::same;
  reader.choice(radar_grammar::receive_antenna, radar_grammar::receive_patterns, pattern);
  radar.same_antenna = pattern == radar_grammar::ReceivePattern::same;
  if (pattern == radar_grammar::ReceivePattern::sinx) {
    receive.pattern = Antenna::Pattern::sinx;
    reader.angle(radar_grammar::receive_elevation, receive.elevation_beamwidth);
    reader.angle(radar_grammar::receive_azimuth, receive.azimuth_beamwidth);
  } else if (pattern == radar_grammar::ReceivePattern::user) {
    receive.pattern = Antenna::Pattern::user;
    reader.function(radar_grammar::receive_user, function_blocks::receive_gain, receive.gain_db);
  }
}

void read_beam(FieldReader& reader, Radar& radar) {
  reader.choice(radar_grammar::beam, radar_grammar::beams, radar.beam);
  switch (radar.beam) {
    case Radar::Beam::fixed:
      reader.angle(radar_grammar::beam_elevation, radar.beam_elevation);
      reader.angle(radar_grammar::beam_azimuth, radar.beam_azimuth);
      break;
    case Radar::Beam::rotating:
      reader.angle(radar_grammar::beam_elevation, radar.beam_elevation);
      reader.angle(radar_grammar::beam_rate, radar.beam_rate);
      break;
    case Radar::Beam::spot: reader.vector(radar_grammar::spot, radar.spot_world_m); break;
    case Radar::Beam::user:
      reader.function(radar_grammar::beam_target, function_blocks::beam_target, radar.beam_target_world_m);
      break;
  }
}

void read_receiver(FieldReader& reader, Radar& radar) {
  reader.choice(radar_grammar::window, radar_grammar::windows, radar.window);
  if (radar.window == Radar::Window::hanning)
    reader.number(radar_grammar::hanning_pedestal, radar.hanning_pedestal);
  else if (radar.window == Radar::Window::user)
    reader.function(radar_grammar::window_gain, function_blocks::window_gain, radar.window_gain);
  bool stc = false;
  reader.choice(radar_grammar::stc, radar_grammar::stc_switches, stc);
  if (!stc) return;
  radar.stc = Radar::Stc::range_law;
  reader.choice(radar_grammar::stc_law, radar_grammar::stc_laws, radar.stc);
  if (radar.stc == Radar::Stc::user)
    reader.function(radar_grammar::stc_gain, function_blocks::stc_gain, radar.stc_gain);
}

}  // namespace

void read_radar(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "radar", scene.radars.size());
  Radar radar;
  if (reader.leading_name(radar_grammar::name, radar.name)) {
    reader.text(radar_grammar::platform, radar.platform);
    read_pulse(reader, radar);
    read_schedule(reader, radar);
    read_power(reader, radar);
    read_antennas(reader, radar);
    read_beam(reader, radar);
    read_receiver(reader, radar);
    scene.radars.push_back(std::move(radar));
  }
  reader.finish();
}

}  // namespace sarsim::scene::script

#include <fmt/format.h>

#include "scene/schema/radar_grammar.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::script {

namespace {

namespace grammar = radar_grammar;

void read_pulse(FieldReader& reader, Radar& radar) {
  reader.choice(grammar::pulse, grammar::pulses, radar.pulse);
  switch (radar.pulse) {
    case Radar::Pulse::mono: break;
    case Radar::Pulse::chirp: reader.number(grammar::bandwidth, radar.bandwidth_hz); break;
    case Radar::Pulse::user: reader.function(grammar::pulse_iq, function_blocks::pulse_iq, radar.pulse_iq); break;
    case Radar::Pulse::barker: reader.integer(grammar::barker_code, radar.barker_code); break;
  }
  reader.number(grammar::pulse_width, radar.pulse_width_s);
  reader.choice(grammar::envelope, grammar::envelopes, radar.envelope);
  if (radar.envelope == Radar::Envelope::linear) {
    reader.number(grammar::rise, radar.rise_s);
    reader.number(grammar::fall, radar.fall_s);
  } else if (radar.envelope == Radar::Envelope::user) {
    reader.function(grammar::envelope_gain, function_blocks::envelope_gain, radar.envelope_gain);
  }
}

void read_schedule(FieldReader& reader, Radar& radar) {
  reader.choice(grammar::repetition, grammar::repetitions, radar.repetition);
  if (radar.repetition == Radar::Repetition::constant)
    reader.number(grammar::prf, radar.prf_hz);
  else
    reader.function(grammar::pri, function_blocks::pri, radar.pri_s);
  reader.choice(grammar::carrier, grammar::carriers, radar.carrier);
  switch (radar.carrier) {
    case Radar::Carrier::single: reader.number(grammar::carrier_single, radar.carrier_hz); break;
    case Radar::Carrier::stepped:
      reader.number(grammar::carrier_start, radar.carrier_hz);
      reader.number(grammar::carrier_step, radar.carrier_step_hz);
      reader.integer(grammar::carrier_steps, radar.carrier_steps);
      reader.integer(grammar::pulses_per_step, radar.pulses_per_step);
      break;
    case Radar::Carrier::user:
      reader.function(grammar::carrier_list, function_blocks::carrier_list, radar.carrier_list_hz);
      break;
  }
}

bool is_antenna(std::string_view word) {
  for (const auto& pattern : grammar::transmit_patterns)
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
  reader.number(grammar::power, radar.power_w);
  const std::size_t values = reader.more() ? values_before_antenna(reader) : 2;
  if (values == 3 || values > 4) {
    reader.pass_over(
        grammar::losses, values,
        {fmt::format("{} values between the power and the transmit antenna", values), shown(reader.peek().text),
         "2 (losses in dB, noise temperature in K), or 4 (gains of transmitter and receiver in dB first)"});
    return;
  }
  if (values == 4) {
    reader.decibels(grammar::transmit_gain, radar.transmit_gain);
    reader.decibels(grammar::receive_gain, radar.receive_gain);
  }
  reader.decibels(grammar::losses, radar.losses);
  reader.number(grammar::noise_temperature, radar.noise_temperature_k);
}

void read_antennas(FieldReader& reader, Radar& radar) {
  Antenna& transmit = radar.transmit_antenna;
  reader.choice(grammar::transmit_antenna, grammar::transmit_patterns, transmit.pattern);
  if (transmit.pattern == Antenna::Pattern::sinx) {
    reader.angle(grammar::transmit_elevation, transmit.elevation_beamwidth);
    reader.angle(grammar::transmit_azimuth, transmit.azimuth_beamwidth);
  } else if (transmit.pattern == Antenna::Pattern::user) {
    reader.function(grammar::transmit_user, function_blocks::transmit_gain, transmit.gain_db);
  }
  Antenna& receive = radar.receive_antenna;
  auto pattern = grammar::ReceivePattern::same;
  reader.choice(grammar::receive_antenna, grammar::receive_patterns, pattern);
  radar.same_antenna = pattern == grammar::ReceivePattern::same;
  if (pattern == grammar::ReceivePattern::sinx) {
    receive.pattern = Antenna::Pattern::sinx;
    reader.angle(grammar::receive_elevation, receive.elevation_beamwidth);
    reader.angle(grammar::receive_azimuth, receive.azimuth_beamwidth);
  } else if (pattern == grammar::ReceivePattern::user) {
    receive.pattern = Antenna::Pattern::user;
    reader.function(grammar::receive_user, function_blocks::receive_gain, receive.gain_db);
  }
}

void read_beam(FieldReader& reader, Radar& radar) {
  reader.choice(grammar::beam, grammar::beams, radar.beam);
  switch (radar.beam) {
    case Radar::Beam::fixed:
      reader.angle(grammar::beam_elevation, radar.beam_elevation);
      reader.angle(grammar::beam_azimuth, radar.beam_azimuth);
      break;
    case Radar::Beam::rotating:
      reader.angle(grammar::beam_elevation, radar.beam_elevation);
      reader.angle(grammar::beam_rate, radar.beam_rate);
      break;
    case Radar::Beam::spot: reader.vector(grammar::spot, radar.spot_world_m); break;
    case Radar::Beam::user:
      reader.function(grammar::beam_target, function_blocks::beam_target, radar.beam_target_world_m);
      break;
  }
}

void read_receiver(FieldReader& reader, Radar& radar) {
  reader.choice(grammar::window, grammar::windows, radar.window);
  if (radar.window == Radar::Window::hanning)
    reader.number(grammar::hanning_pedestal, radar.hanning_pedestal);
  else if (radar.window == Radar::Window::user)
    reader.function(grammar::window_gain, function_blocks::window_gain, radar.window_gain);
  bool stc = false;
  reader.choice(grammar::stc, grammar::stc_switches, stc);
  if (!stc) return;
  radar.stc = Radar::Stc::range_law;
  reader.choice(grammar::stc_law, grammar::stc_laws, radar.stc);
  if (radar.stc == Radar::Stc::user) reader.function(grammar::stc_gain, function_blocks::stc_gain, radar.stc_gain);
}

}  // namespace

void read_radar(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "radar", scene.radars.size());
  Radar radar;
  if (reader.leading_name(grammar::name, radar.name)) {
    reader.text(grammar::platform, radar.platform);
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

}  // namespace sarsim::script

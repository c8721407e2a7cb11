#include "scene/schema/field_table.hpp"
#include "scene/schema/radar_grammar.hpp"

namespace sarsim::scene::field_tables {

namespace {

const std::vector<std::string> barker_lengths{"2", "3", "4", "5", "7", "11", "13"};

template <auto Member, auto... Values>
bool is(const Radar& radar) {
  return ((radar.*Member == Values) || ...);
}

void add_pulse(FieldTable<Radar>& table) {
  table.group("Pulse");
  table.choice("pulse", "Pulse type", &Radar::pulse, {"Monochrome", "Chirp", "User-defined", "Barker"},
               "Modulation within the pulse: none, a linear sweep, given I and Q, or a Barker phase code.");
  table.where(is<&Radar::pulse, Radar::Pulse::chirp>);
  table.number(script::radar_grammar::bandwidth, "Chirp bandwidth", Quantity::frequency, &Radar::bandwidth_hz,
               "Swept over the pulse width; negative sweeps down. Range resolution is c/(2 B).");
  table.where(is<&Radar::pulse, Radar::Pulse::user>);
  table.function("pulse_iq", "Pulse definition", &Radar::pulse_iq,
                 "I and Q against the fraction of the pulse width, 0 to 1.");
  table.where(is<&Radar::pulse, Radar::Pulse::barker>);
  table.choice("barker_code", "Barker code length", &Radar::barker_code, barker_lengths,
               "Chips of the phase code; the range resolution is that of one chip.");
  table.always();
  table.number(script::radar_grammar::pulse_width, "Pulse width", Quantity::time, &Radar::pulse_width_s,
               "From edge to edge, Tp. It is c Tp/2 long on the range axis.");
}

void add_envelope(FieldTable<Radar>& table) {
  table.group("Envelope").rare();
  table.choice("envelope", "Envelope", &Radar::envelope, {"Rectangular", "Linear", "User-defined"},
               "Amplitude over the pulse: constant, with straight rise and fall, or given.");
  table.where(is<&Radar::envelope, Radar::Envelope::linear>);
  table.number(script::radar_grammar::rise, "Rise time", Quantity::time, &Radar::rise_s,
               "From nothing to the full amplitude.");
  table.number(script::radar_grammar::fall, "Fall time", Quantity::time, &Radar::fall_s,
               "From the full amplitude to nothing.");
  table.where(is<&Radar::envelope, Radar::Envelope::user>);
  table.function("envelope_gain", "Envelope definition", &Radar::envelope_gain,
                 "Amplitude against the fraction of the pulse width, 0 to 1.");
  table.always().rare(false);
}

void add_repetition(FieldTable<Radar>& table) {
  table.group("PRF");
  table.choice("repetition", "Pulse repetition", &Radar::repetition, {"Constant", "User-defined"},
               "Evenly spaced pulses, or a list of intervals that begins again at its end. Pulse 0 leaves at time 0.");
  table.where(is<&Radar::repetition, Radar::Repetition::constant>);
  table.number(script::radar_grammar::prf, "Pulse repetition frequency", Quantity::frequency, &Radar::prf_hz,
               "Unambiguous range is c/(2 PRF), unambiguous speed lambda PRF/4 either way.");
  table.where(is<&Radar::repetition, Radar::Repetition::user>);
  table.function("pri_s", "Repetition intervals", &Radar::pri_s, "Time from each pulse to the next, in turn.");
  table.always();
}

void add_carrier(FieldTable<Radar>& table) {
  constexpr auto stepped = is<&Radar::carrier, Radar::Carrier::stepped>;
  table.group("Frequency");
  table.choice("carrier", "Centre frequency", &Radar::carrier, {"Single", "Stepped", "User-defined"},
               "One carrier, steps from pulse to pulse, or a list that begins again at its end.");
  table.where(is<&Radar::carrier, Radar::Carrier::single, Radar::Carrier::stepped>);
  table.number(script::radar_grammar::carrier_single, "Frequency", Quantity::frequency, &Radar::carrier_hz,
               "Carrier; the first one of stepped carriers. Wavelength is c/f.");
  table.where(stepped);
  table.number(script::radar_grammar::carrier_step, "Frequency step", Quantity::frequency, &Radar::carrier_step_hz,
               "From one frequency to the next. N steps resolve c/(2 N step) in range.");
  table.number(script::radar_grammar::carrier_steps, "Number of steps", Quantity::count, &Radar::carrier_steps,
               "Frequencies of a burst.");
  table.number(script::radar_grammar::pulses_per_step, "Pulses per frequency", Quantity::count, &Radar::pulses_per_step,
               "Pulses sent at each frequency before the next step.");
  table.where(is<&Radar::carrier, Radar::Carrier::user>);
  table.function("carrier_list_hz", "Frequency list", &Radar::carrier_list_hz, "Carrier of each pulse, in turn.");
  table.always();
}

void add_power(FieldTable<Radar>& table) {
  table.group("Power");
  table.number(script::radar_grammar::power, "Power output", Quantity::power, &Radar::power_w,
               "Transmitted peak power.");
  table.number(script::radar_grammar::losses, "System losses", Quantity::ratio_db, &Radar::losses,
               "Total of the losses; received power is divided by it.");
  table.number(script::radar_grammar::noise_temperature, "Noise temperature", Quantity::temperature,
               &Radar::noise_temperature_k, "Of the receiver: noise power is k T B. 0 for no noise.");
  table.rare();
  table.number(script::radar_grammar::transmit_gain, "Transmitter gain", Quantity::ratio_db, &Radar::transmit_gain,
               "Gain at the middle of the transmitted beam, on top of the antenna's pattern.");
  table.number(script::radar_grammar::receive_gain, "Receiver gain", Quantity::ratio_db, &Radar::receive_gain,
               "Gain at the middle of the received beam, on top of the antenna's pattern.");
  table.rare(false);
}

// A single carrier or repetition frequency lives on as the first entry of a list, and the other way round.
void begin_lists(const Radar& before, Radar& after) {
  const auto& intervals = before.pri_s.part[0].knots;
  if (after.repetition == Radar::Repetition::user)
    begin_constant(after.pri_s.part[0], before.prf_hz > 0.0 ? 1.0 / before.prf_hz : 1e-3);
  else if (before.repetition == Radar::Repetition::user && !intervals.empty() && intervals.front().y > 0.0)
    after.prf_hz = 1.0 / intervals.front().y;
  const auto& carriers = before.carrier_list_hz.part[0].knots;
  if (after.carrier == Radar::Carrier::user)
    begin_constant(after.carrier_list_hz.part[0], before.carrier_hz > 0.0 ? before.carrier_hz : 1e9);
  else if (before.carrier == Radar::Carrier::user && !carriers.empty() && carriers.front().y > 0.0)
    after.carrier_hz = carriers.front().y;
}

void begin_antenna(Antenna& antenna) {
  if (antenna.pattern != Antenna::Pattern::user) return;
  for (core::SampledFunction& cut : antenna.gain_db.part) begin_constant(cut, 0.0);
}

void begin_radar(const Radar& before, Radar& after) {
  begin_lists(before, after);
  if (after.pulse == Radar::Pulse::user && after.pulse_iq.part[0].knots.empty()) {
    begin_constant(after.pulse_iq.part[0], 1.0);
    begin_constant(after.pulse_iq.part[1], 0.0);
  }
  if (after.envelope == Radar::Envelope::user) begin_constant(after.envelope_gain.part[0], 1.0);
  begin_antenna(after.transmit_antenna);
  if (!after.same_antenna) begin_antenna(after.receive_antenna);
  if (after.beam == Radar::Beam::user) {
    begin_constant(after.beam_target_world_m.part[0], before.spot_world_m.x);
    begin_constant(after.beam_target_world_m.part[1], before.spot_world_m.y);
    begin_constant(after.beam_target_world_m.part[2], before.spot_world_m.z);
  }
  if (after.window == Radar::Window::user) begin_constant(after.window_gain.part[0], 1.0);
  if (after.stc == Radar::Stc::user) begin_constant(after.stc_gain.part[0], 1.0);
}

}  // namespace

const FieldTable<Radar>& radar_table() {
  static const FieldTable<Radar> made = [] {
    FieldTable<Radar> table;
    table.group("Radar");
    table.name(
        script::radar_grammar::name, FieldKind::text, "Radar name", &Radar::name,
        "Simulations and geometry tables refer to the radar by this name; capital and small letters are the same.");
    table.name(script::radar_grammar::platform, FieldKind::platform, "Platform name", &Radar::platform,
               "The radar stands at the origin of this platform.");
    add_pulse(table);
    add_envelope(table);
    add_repetition(table);
    add_carrier(table);
    add_power(table);
    add_antenna_fields(table);
    table.on_switch(begin_radar);
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene::field_tables

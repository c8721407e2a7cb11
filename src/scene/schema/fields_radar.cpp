#include "scene/schema/fields_radar.hpp"

#include "scene/model/limits.hpp"

namespace sarsim::scene {

namespace {

void add_pulse(FieldTable<Radar>& table) {
  using Pulse = Radar::Pulse;
  table.group("Pulse");
  table.add<&Radar::pulse>(
      {.id = "pulse",
       .key = "pulse",
       .label = "Pulse type",
       .words = "kind of pulse",
       .choices = {{"MONO", Pulse::mono, "Monochrome", "pulse of a single frequency"},
                   {"CHIRP", Pulse::chirp, "Chirp", "pulse of linearly swept frequency"},
                   {"OTHER_PULSE", Pulse::user, "User-defined", "pulse given by its I and Q", "points"},
                   {"BARKER", Pulse::barker, "Barker", "pulse with a Barker phase code"}},
       .tip = "Modulation within the pulse: none, a linear sweep, given I and Q, or a Barker phase code."});
  table.when<&Radar::pulse>(Pulse::chirp);
  table.add<&Radar::bandwidth_hz>(
      {.id = "bandwidth_hz",
       .key = "pulse.bandwidth",
       .label = "Chirp bandwidth",
       .words = "chirp bandwidth",
       .quantity = Quantity::frequency,
       .script_unit = "GHz",
       .likely = {-1e11, 1e11},
       .tip = "Swept over the pulse width; negative sweeps down. Range resolution is c/(2 B).",
       .detail = "negative sweeps down"});
  table.when<&Radar::pulse>(Pulse::user);
  table.add<&Radar::pulse_iq>({.id = "pulse_iq",
                               .key = "pulse",
                               .label = "Pulse definition",
                               .words = "pulse",
                               .block = &function_blocks::pulse_iq,
                               .tip = "I and Q against the fraction of the pulse width, 0 to 1."});
  table.when<&Radar::pulse>(Pulse::barker);
  table.add<&Radar::barker_code>({.id = "barker_code",
                                  .key = "pulse.length",
                                  .label = "Barker code length",
                                  .words = "Barker code",
                                  .range = {0.0, 6.0},
                                  .choices = {{"", 0, "2", ""},
                                              {"", 1, "3", ""},
                                              {"", 2, "4", ""},
                                              {"", 3, "5", ""},
                                              {"", 4, "7", ""},
                                              {"", 5, "11", ""},
                                              {"", 6, "13", ""}},
                                  .tip = "Chips of the phase code; the range resolution is that of one chip.",
                                  .detail = "0 to 6 stand for lengths 2, 3, 4, 5, 7, 11, 13"});
  table.always();
  table.add<&Radar::pulse_width_s>({.id = "pulse_width_s",
                                    .key = "pulse.width",
                                    .label = "Pulse width",
                                    .words = "pulse width",
                                    .quantity = Quantity::time,
                                    .script_unit = "ns",
                                    .range = zero_or_more,
                                    .usable = above_zero,
                                    .likely = {1e-10, 1.0},
                                    .tip = "From edge to edge, Tp. It is c Tp/2 long on the range axis.",
                                    .detail = "from edge to edge"});
}

void add_envelope(FieldTable<Radar>& table) {
  using Envelope = Radar::Envelope;
  table.group("Envelope");
  table.add<&Radar::envelope>(
      {.id = "envelope",
       .key = "envelope",
       .label = "Envelope",
       .words = "pulse envelope",
       .choices = {{"RECT", Envelope::rectangular, "Rectangular", "constant amplitude within the pulse", "rectangular"},
                   {"LINEAR", Envelope::linear, "Linear", "straight rise and fall"},
                   {"OTHER", Envelope::user, "User-defined", "envelope given by points", "points"}},
       .tip = "Amplitude over the pulse: constant, with straight rise and fall, or given.",
       .rare = true});
  table.when<&Radar::envelope>(Envelope::linear);
  table.add<&Radar::rise_s>({.id = "rise_s",
                             .key = "envelope.rise",
                             .label = "Rise time",
                             .words = "rise time",
                             .quantity = Quantity::time,
                             .script_unit = "ns",
                             .range = zero_or_more,
                             .likely = {0.0, 1.0},
                             .tip = "From zero to full amplitude.",
                             .rare = true});
  table.add<&Radar::fall_s>({.id = "fall_s",
                             .key = "envelope.fall",
                             .label = "Fall time",
                             .words = "fall time",
                             .quantity = Quantity::time,
                             .script_unit = "ns",
                             .range = zero_or_more,
                             .likely = {0.0, 1.0},
                             .tip = "From full amplitude to zero.",
                             .rare = true});
  table.when<&Radar::envelope>(Envelope::user);
  table.add<&Radar::envelope_gain>({.id = "envelope_gain",
                                    .key = "envelope",
                                    .label = "Envelope definition",
                                    .words = "pulse envelope",
                                    .block = &function_blocks::envelope_gain,
                                    .tip = "Amplitude against the fraction of the pulse width, 0 to 1.",
                                    .rare = true});
}

void add_repetition(FieldTable<Radar>& table) {
  table.group("PRF");
  table.add<&Radar::repetition>(
      {.id = "repetition",
       .key = "repetition",
       .label = "Pulse repetition",
       .words = "kind of pulse repetition",
       .choices = {{"CONSTANT", Radar::Repetition::constant, "Constant", "evenly spaced pulses"},
                   {"OTHER", Radar::Repetition::user, "User-defined", "list of intervals between pulses", "list"}},
       .tip = "Evenly spaced pulses, or a list of intervals that begins again at its end. Pulse 0 leaves at time 0."});
  table.when<&Radar::repetition>(Radar::Repetition::constant);
  table.add<&Radar::prf_hz>({.id = "prf_hz",
                             .key = "repetition.frequency",
                             .label = "Pulse repetition frequency",
                             .words = "pulse repetition frequency",
                             .quantity = Quantity::frequency,
                             .range = {1e-5},
                             .likely = {1.0, 1e6},
                             .tip = "Unambiguous range is c/(2 PRF), unambiguous speed lambda PRF/4 either way."});
  table.when<&Radar::repetition>(Radar::Repetition::user);
  table.add<&Radar::pri_s>({.id = "pri_s",
                            .key = "repetition",
                            .label = "Repetition intervals",
                            .words = "pulse repetition intervals",
                            .block = &function_blocks::pri,
                            .tip = "Time from each pulse to the next, in turn."});
}

void add_carrier(FieldTable<Radar>& table) {
  using Carrier = Radar::Carrier;
  table.group("Frequency");
  table.add<&Radar::carrier>(
      {.id = "carrier",
       .key = "carrier",
       .label = "Centre frequency",
       .words = "kind of carrier",
       .choices = {{"SINGLE", Carrier::single, "Single", "one carrier"},
                   {"STEPPED", Carrier::stepped, "Stepped", "carrier stepped from pulse to pulse"},
                   {"OTHER", Carrier::user, "User-defined", "list of carriers", "list"}},
       .tip = "One carrier, steps from pulse to pulse, or a list that begins again at its end."});
  table.when<&Radar::carrier>(Carrier::single, Carrier::stepped);
  table.add<&Radar::carrier_hz>({.id = "carrier_hz",
                                 .key = "carrier.frequency",
                                 .other_key = {static_cast<int>(Carrier::stepped), "carrier.first"},
                                 .label = "Frequency",
                                 .words = "carrier frequency",
                                 .noun = "carrier",
                                 .quantity = Quantity::frequency,
                                 .script_unit = "GHz",
                                 .range = zero_or_more,
                                 .usable = above_zero,
                                 .likely = {1e6, 1e12},
                                 .tip = "Carrier; the first one of stepped carriers. Wavelength is c/f."});
  table.when<&Radar::carrier>(Carrier::stepped);
  table.add<&Radar::carrier_step_hz>({.id = "carrier_step_hz",
                                      .key = "carrier.step",
                                      .label = "Frequency step",
                                      .words = "frequency step",
                                      .quantity = Quantity::frequency,
                                      .script_unit = "GHz",
                                      .range = zero_or_more,
                                      .usable = any_value,
                                      .likely = {1e3, 1e10},
                                      .tip = "From one frequency to the next. N steps resolve c/(2 N step) in range."});
  table.add<&Radar::carrier_steps>({.id = "carrier_steps",
                                    .key = "carrier.count",
                                    .label = "Number of steps",
                                    .words = "number of frequencies",
                                    .noun = "number of frequency steps",
                                    .quantity = Quantity::count,
                                    .range = {1.0, 1000.0},
                                    .usable = Range{1.0},
                                    .tip = "Frequencies of a burst."});
  table.add<&Radar::pulses_per_step>({.id = "pulses_per_step",
                                      .key = "carrier.pulses",
                                      .label = "Pulses per frequency",
                                      .words = "pulses at each frequency",
                                      .noun = "number of pulses per frequency",
                                      .quantity = Quantity::count,
                                      .range = {1.0, 100.0},
                                      .usable = Range{1.0},
                                      .tip = "Pulses sent at each frequency before the next step."});
  table.when<&Radar::carrier>(Carrier::user);
  table.add<&Radar::carrier_list_hz>({.id = "carrier_list_hz",
                                      .key = "carrier",
                                      .label = "Frequency list",
                                      .words = "carrier frequencies",
                                      .block = &function_blocks::carrier_list,
                                      .tip = "Carrier of each pulse, in turn."});
}

void add_power(FieldTable<Radar>& table) {
  constexpr Range gains{0.0, largest_gain_db};
  constexpr Range usable_gains{-largest_value, largest_gain_db};
  table.group("Power");
  table.add<&Radar::power_w>({.id = "power_w",
                              .key = "power",
                              .label = "Power output",
                              .words = "transmitted power",
                              .noun = "output power",
                              .quantity = Quantity::power,
                              .script_unit = "kW",
                              .range = zero_or_more,
                              .likely = {1e-6, 1e10},
                              .tip = "Transmitted peak power."});
  table.add<&Radar::losses>({.id = "losses",
                             .key = "losses",
                             .label = "System losses",
                             .words = "losses of the system",
                             .noun = "total of the losses",
                             .quantity = Quantity::ratio_db,
                             .range = zero_or_more,
                             .likely = {0.0, 100.0},
                             .tip = "Total of the losses; received power is divided by it."});
  table.add<&Radar::noise_temperature_k>({.id = "noise_temperature_k",
                                          .key = "noise_temperature",
                                          .label = "Noise temperature",
                                          .words = "noise temperature",
                                          .quantity = Quantity::temperature,
                                          .range = zero_or_more,
                                          .likely = {0.0, 1e5},
                                          .tip = "Receiver noise temperature: noise power is k T B. 0 for no noise."});
  table.add<&Radar::transmit_gain>(
      {.id = "transmit_gain",
       .key = "transmit_gain",
       .label = "Transmitter gain",
       .words = "gain of the transmitter",
       .noun = "transmit gain",
       .quantity = Quantity::ratio_db,
       .range = gains,
       .usable = usable_gains,
       .likely = {0.0, 100.0},
       .tip = "Gain at the middle of the transmitted beam, on top of the antenna's pattern.",
       .rare = true});
  table.add<&Radar::receive_gain>({.id = "receive_gain",
                                   .key = "receive_gain",
                                   .label = "Receiver gain",
                                   .words = "gain of the receiver",
                                   .noun = "receive gain",
                                   .quantity = Quantity::ratio_db,
                                   .range = gains,
                                   .usable = usable_gains,
                                   .likely = {0.0, 100.0},
                                   .tip = "Gain at the middle of the received beam, on top of the antenna's pattern.",
                                   .rare = true});
}

}  // namespace

template <>
const FieldTable<Radar>& table_of<Radar>() {
  static const FieldTable<Radar> made = [] {
    FieldTable<Radar> table;
    table.group("Radar");
    table.add<&Radar::name>({.id = "name",
                             .key = "name",
                             .label = "Radar name",
                             .words = "name of the radar",
                             .tip = "Recordings and geometry tables refer to the radar by this name."});
    table.add<&Radar::platform>({.id = "platform",
                                 .key = "platform",
                                 .label = "Platform name",
                                 .words = "name of its platform",
                                 .refers = "platform",
                                 .tip = "The radar is at the origin of this platform."});
    add_pulse(table);
    add_envelope(table);
    add_repetition(table);
    add_carrier(table);
    add_power(table);
    radar_fields::add_antennas(table);
    radar_fields::add_direction(table);
    radar_fields::add_receiver(table);
    return table.on_switch(radar_fields::begin_radar);
  }();
  return made;
}

}  // namespace sarsim::scene

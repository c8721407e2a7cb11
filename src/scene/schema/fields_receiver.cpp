#include "core/maths/window_labels.hpp"
#include "scene/schema/fields_radar.hpp"

namespace sarsim::scene::radar_fields {

namespace {

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

}  // namespace

void add_receiver(FieldTable<Radar>& table) {
  table.group("Matched filter window");
  table.add<&Radar::window>(
      {.id = "window",
       .key = "window",
       .spelling = core::window_word,
       .label = "Window",
       .words = "matched-filter window",
       .choices = {{"RECT", Radar::Window::rectangular, "Rectangular", "matched filter without weighting",
                    "rectangular"},
                   {"HANNING", Radar::Window::hanning, "Hann", "matched filter with a Hann window", "hann"},
                   {"BARTLETT", Radar::Window::bartlett, "Bartlett", "matched filter with a triangular window"},
                   {"HAMMING", Radar::Window::hamming, "Hamming", "matched filter with a Hamming window"},
                   {"", Radar::Window::blackman, "Blackman", "matched filter with a Blackman window", "blackman"},
                   {"", Radar::Window::kaiser, "Kaiser", "matched filter with a Kaiser window", "kaiser"},
                   {"", Radar::Window::taylor, "Taylor", "matched filter with a Taylor window", "taylor"},
                   {"OTHER", Radar::Window::user, "User-defined", "matched filter with a window given by points",
                    "points"}},
       .tip = "Weights the matched filter: lower range side lobes for a wider main lobe.",
       .rare = true});
  table.when<&Radar::window>(Radar::Window::hanning);
  table.add<&Radar::hanning_pedestal>(
      {.id = "hanning_pedestal",
       .key = "window.pedestal",
       .label = "Hanning constant",
       .words = "Hanning constant",
       .range = {0.0, 1.0},
       .usable = Range{0.0, 1.0},
       .example = "0.1",
       .tip = "Window k + (1 - k) sin^2(pi x) for x from 0 to 1: 1 is no weighting, 0 falls to zero at the ends.",
       .detail = "1 is no weighting, 0 falls to zero at the ends",
       .rare = true});
  table.when<&Radar::window>(Radar::Window::kaiser);
  table.add<&Radar::kaiser_beta>({.id = "kaiser_beta",
                                  .key = "window.beta",
                                  .label = "Kaiser's beta",
                                  .words = "beta of Kaiser's window",
                                  .range = {0.0, 20.0},
                                  .since_2 = true,
                                  .tip = "I0(beta sqrt(1 - (2x - 1)^2))/I0(beta) for x from 0 to 1; 0 is no weighting.",
                                  .rare = true});
  table.when<&Radar::window>(Radar::Window::taylor);
  table.add<&Radar::taylor_sidelobes_db>({.id = "taylor_sidelobes_db",
                                          .key = "window.sidelobes",
                                          .label = "Taylor sidelobes",
                                          .words = "sidelobes of Taylor's window",
                                          .quantity = Quantity::ratio_db,
                                          .range = {10.0, 100.0},
                                          .since_2 = true,
                                          .tip = "Level of the first sidelobes below the peak.",
                                          .rare = true});
  table.add<&Radar::taylor_equal_sidelobes>({.id = "taylor_equal_sidelobes",
                                             .key = "window.nbar",
                                             .label = "Taylor's nbar",
                                             .words = "nbar of Taylor's window",
                                             .quantity = Quantity::count,
                                             .range = {1.0, 30.0},
                                             .since_2 = true,
                                             .tip = "Number of sidelobes of nearly equal height on either side.",
                                             .rare = true});
  table.when<&Radar::window>(Radar::Window::user);
  table.add<&Radar::window_gain>({.id = "window_gain",
                                  .key = "window",
                                  .label = "Window definition",
                                  .words = "matched-filter window",
                                  .block = &function_blocks::window_gain,
                                  .tip = "Weight against the fraction of the pulse width, 0 to 1.",
                                  .rare = true});
  table.group("Sensitivity time control");
  table.add<&Radar::stc>(
      {.id = "stc",
       .key = "stc",
       .label = "STC",
       .words = "sensitivity-time control",
       .choices = {{"NO_STC", Radar::Stc::none, "None", "no sensitivity-time control", "none"},
                   {"1OVERR4", Radar::Stc::range_law, "1/R^4", "takes the loss with range out of the echoes",
                    "range-law"},
                   {"OTHER", Radar::Stc::user, "User-defined", "gain given by points", "points"}},
       .tip = "Gain against range before the A/D converter: none, compensating the range loss, or given.",
       .rare = true});
  table.when<&Radar::stc>(Radar::Stc::user);
  table.add<&Radar::stc_gain>({.id = "stc_gain",
                               .key = "stc",
                               .label = "STC definition",
                               .words = "sensitivity-time control",
                               .block = &function_blocks::stc_gain,
                               .tip = "Voltage gain against range.",
                               .rare = true});
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

}  // namespace sarsim::scene::radar_fields

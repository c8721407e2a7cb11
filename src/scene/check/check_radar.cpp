#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "radar/waveform/pulse.hpp"
#include "scene/check/check_objects.hpp"
#include "scene/check/check_values.hpp"
#include "scene/model/limits.hpp"
#include "scene/model/radar_pulse.hpp"

namespace sarsim::scene {

namespace {

constexpr std::string_view quadrature_parts[] = {"I", "Q"};
constexpr std::string_view cut_parts[] = {"azimuth cut", "elevation cut"};

bool all_zero(const core::SampledFunction& function) {
  return std::ranges::all_of(function.knots, [](const core::Knot& knot) { return knot.y == 0.0; });
}

void check_user_pulse(Findings& findings, const Radar& radar) {
  const bool used = radar.pulse == Radar::Pulse::user;
  const bool none =
      std::ranges::all_of(radar.pulse_iq.part, [](const core::SampledFunction& f) { return f.knots.empty(); });
  const bool sound = check_function(findings,
                                    {.field = "pulse_iq",
                                     .what = "user-defined pulse",
                                     .parts = quadrature_parts,
                                     .used = used,
                                     .empty = none ? FunctionRule::Empty::error : FunctionRule::Empty::constant_zero},
                                    radar.pulse_iq.part);
  if (used && sound && std::ranges::all_of(radar.pulse_iq.part, all_zero))
    findings.error("pulse_iq", {.id = "pulse.zero",
                                .message = "the user-defined pulse is zero throughout",
                                .found = "only zeros",
                                .expected = "a pulse that is not zero everywhere"});
}

void check_modulation(Findings& findings, const Radar& radar) {
  if (radar.pulse == Radar::Pulse::chirp && radar.bandwidth_hz == 0.0)
    findings.warning(Consequence::surprise, "bandwidth_hz",
                     {.id = "chirp.no-bandwidth",
                      .message = "a chirp without bandwidth is an unmodulated pulse",
                      .found = value_text(radar.bandwidth_hz, "Hz"),
                      .expected = "a bandwidth other than 0",
                      .hint = "Write MONO for an unmodulated pulse."});
  if (radar.pulse == Radar::Pulse::barker && (radar.barker_code < 0 || radar.barker_code > 6))
    findings.error("barker_code", {.id = "barker.unknown-code",
                                   .message = "there is no Barker code with this number",
                                   .found = std::to_string(radar.barker_code),
                                   .expected = "0 to 6, for lengths 2, 3, 4, 5, 7, 11 and 13"});
  check_user_pulse(findings, radar);
}

void check_pulse_envelope(Findings& findings, const Radar& radar) {
  const bool ramps = radar.envelope == Radar::Envelope::linear && radar.pulse_width_s > 0.0;
  if (ramps && radar.rise_s + radar.fall_s > radar.pulse_width_s)
    findings.warning(Consequence::surprise, "rise_s",
                     {.id = "pulse.edges-too-long",
                      .message = "the pulse's rise and fall together are longer than the pulse",
                      .found = fmt::format("{} and {} in a pulse of {}", value_text(radar.rise_s, "s"),
                                           value_text(radar.fall_s, "s"), value_text(radar.pulse_width_s, "s")),
                      .expected = "rise + fall up to the pulse width",
                      .hint = "The pulse never reaches its full amplitude."});
  const bool used = radar.envelope == Radar::Envelope::user;
  const bool sound =
      check_function(findings, {.field = "envelope_gain", .what = "pulse envelope", .parts = single_part, .used = used},
                     radar.envelope_gain.part);
  if (used && sound && all_zero(radar.envelope_gain.part[0]))
    findings.error("envelope_gain", {.id = "pulse.zero-envelope",
                                     .message = "the pulse envelope is zero throughout",
                                     .found = "only zeros",
                                     .expected = "an envelope that is not zero everywhere"});
}

// Entries of a list whose x is ignored: every one has to be above zero.
void check_list(Findings& findings, std::string_view field, std::string_view what, std::string_view unit, bool used,
                const UserFunction<1>& list) {
  const FunctionRule rule{.field = field, .what = what, .parts = single_part, .used = used, .x_matters = false};
  if (!check_function(findings, rule, list.part) || !used) return;
  const auto& knots = list.part[0].knots;
  const auto bad = std::ranges::find_if(knots, [](const core::Knot& knot) { return !(knot.y > 0.0); });
  if (bad != knots.end())
    findings.error(field, {.id = "list.not-above-zero",
                           .message = fmt::format("an entry of the {} is not above zero", what),
                           .found = fmt::format("entry {}: {}", bad - knots.begin() + 1, value_text(bad->y, unit)),
                           .expected = "numbers above 0"});
}

void check_repetition(Findings& findings, const Radar& radar) {
  check_list(findings, "pri_s", "list of pulse repetition intervals", "s", radar.repetition == Radar::Repetition::user,
             radar.pri_s);
  const auto repetition = repetition_of(radar);
  if (!repetition || !std::isfinite(radar.pulse_width_s)) return;
  if (radar.pulse_width_s <= repetition->shortest_interval_s()) return;
  findings.warning(Consequence::false_signal, "pulse_width_s",
                   {.id = "pulse.longer-than-interval",
                    .message = "the pulse is longer than the interval to the next one",
                    .found = fmt::format("{} in an interval of {}", value_text(radar.pulse_width_s, "s"),
                                         value_text(repetition->shortest_interval_s(), "s")),
                    .expected = "a pulse that ends before the next begins",
                    .hint = "Echoes of successive pulses overlap. Shorten the pulse or lower the PRF."});
}

void check_steps(Findings& findings, const Radar& radar) {
  if (!computable(radar.carrier_step_hz) || radar.carrier_steps < 1 || radar.pulses_per_step < 1) return;
  const double last_hz = radar.carrier_hz + radar.carrier_step_hz * (radar.carrier_steps - 1);
  if (radar.carrier_hz > 0.0 && !(last_hz > 0.0))
    findings.error("carrier_step_hz", {.id = "carrier.steps-below-zero",
                                       .message = "the frequency steps lead to a carrier that is not above zero",
                                       .found = value_text(last_hz, "Hz"),
                                       .expected = "carriers above 0"});
}

void check_carrier(Findings& findings, const Radar& radar) {
  if (radar.carrier == Radar::Carrier::stepped) check_steps(findings, radar);
  check_list(findings, "carrier_list_hz", "list of carriers", "Hz", radar.carrier == Radar::Carrier::user,
             radar.carrier_list_hz);
}

void check_antenna(Findings& findings, std::string_view field, std::string_view what, bool used,
                   const Antenna& antenna) {
  const bool by_points = used && antenna.pattern == Antenna::Pattern::user;
  const std::string name = fmt::format("{} antenna's", what);
  if (!check_function(findings, {.field = field, .what = name, .parts = cut_parts, .used = by_points},
                      antenna.gain_db.part) ||
      !by_points)
    return;
  for (std::size_t i = 0; i < antenna.gain_db.part.size(); ++i) {
    const std::vector<core::Knot>& knots = antenna.gain_db.part[i].knots;
    constexpr double turn_deg = 360.0 + 1e-9;
    if (knots.size() < 2 || knots.back().x - knots.front().x <= turn_deg) continue;
    findings.warning(
        Consequence::surprise, field,
        {.id = "antenna-cut.more-than-a-turn",
         .message = fmt::format("the points of the {} {} cover more than 360 deg: some angles have two gains", name,
                                cut_parts[i]),
         .found = fmt::format("{:g} to {:g} deg", knots.front().x, knots.back().x),
         .expected = "angles of 360 deg together, as -180 to 180",
         .hint = "Of two gains, the one between -180 and 180 deg is used."});
  }
}

void check_beam(Findings& findings, const Radar& radar) {
  check_antenna(findings, "transmit_antenna", "transmit", true, radar.transmit_antenna);
  check_antenna(findings, "receive_antenna", "receive", !radar.same_antenna, radar.receive_antenna);
  check_function(findings,
                 {.field = "beam_target_world_m",
                  .what = "beam direction",
                  .parts = coordinate_parts,
                  .used = radar.beam == Radar::Beam::user,
                  .empty = FunctionRule::Empty::constant_zero},
                 radar.beam_target_world_m.part);
}

void check_receiver(Findings& findings, const Radar& radar) {
  const bool windowed = radar.window == Radar::Window::user;
  const bool sound = check_function(
      findings, {.field = "window_gain", .what = "matched-filter window", .parts = single_part, .used = windowed},
      radar.window_gain.part);
  if (windowed && sound && all_zero(radar.window_gain.part[0]))
    findings.error("window_gain", {.id = "window.zero",
                                   .message = "the matched-filter window is zero throughout",
                                   .found = "only zeros",
                                   .expected = "a window that is not zero everywhere"});
  const bool controlled = radar.stc == Radar::Stc::user;
  const bool sound_control = check_function(
      findings, {.field = "stc_gain", .what = "sensitivity-time control", .parts = single_part, .used = controlled},
      radar.stc_gain.part);
  if (controlled && sound_control && all_zero(radar.stc_gain.part[0]))
    findings.error("stc_gain", {.id = "stc.zero",
                                .message = "the sensitivity-time control is zero throughout",
                                .found = "only zeros",
                                .expected = "a gain that is not zero everywhere"});
}

}  // namespace

void check_radar(Findings& findings, NameCheck& platforms, const Radar& radar) {
  platforms.resolve(findings, "platform", radar.platform);
  check_values(findings, radar);
  check_modulation(findings, radar);
  check_pulse_envelope(findings, radar);
  check_repetition(findings, radar);
  check_carrier(findings, radar);
  check_beam(findings, radar);
  check_receiver(findings, radar);
  check_plausible_radar(findings, radar);
}

std::optional<radar::Repetition> repetition_of(const Radar& radar) {
  const auto usable = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (radar.repetition == Radar::Repetition::constant) {
    if (!usable(radar.prf_hz)) return std::nullopt;
    return radar::Repetition::constant(radar.prf_hz);
  }
  std::vector<double> intervals;
  for (const core::Knot& knot : radar.pri_s.part[0].knots) {
    if (!usable(knot.y)) return std::nullopt;
    intervals.push_back(knot.y);
  }
  if (intervals.empty()) return std::nullopt;
  return radar::Repetition::intervals(std::move(intervals));
}

namespace {

// Whether the functions of a user-defined pulse can be evaluated; what is wrong with them is said elsewhere.
bool user_pulse_is_sound(const Radar& radar) {
  const auto numbers = [](const core::SampledFunction& function) {
    return std::ranges::all_of(function.knots,
                               [](const core::Knot& k) { return std::isfinite(k.x) && std::isfinite(k.y); });
  };
  const auto ascends = [](const core::SampledFunction& function) {
    return std::ranges::adjacent_find(function.knots, std::ranges::greater_equal{}, &core::Knot::x) ==
           function.knots.end();
  };
  const auto sound = [&](const core::SampledFunction& function) { return numbers(function) && ascends(function); };
  if (!std::ranges::all_of(radar.pulse_iq.part, sound) || std::ranges::all_of(radar.pulse_iq.part, all_zero))
    return false;
  switch (radar.envelope) {
    case Radar::Envelope::rectangular: return true;
    case Radar::Envelope::linear:
      return std::isfinite(radar.rise_s) && std::isfinite(radar.fall_s) && radar.rise_s >= 0.0 && radar.fall_s >= 0.0;
    case Radar::Envelope::user: break;
  }
  return sound(radar.envelope_gain.part[0]) && !all_zero(radar.envelope_gain.part[0]);
}

}  // namespace

std::optional<double> nominal_bandwidth_hz(const Radar& radar) {
  if (!std::isfinite(radar.pulse_width_s) || !(radar.pulse_width_s > 0.0)) return std::nullopt;
  switch (radar.pulse) {
    case Radar::Pulse::mono: break;
    case Radar::Pulse::user:
      if (!user_pulse_is_sound(radar)) return std::nullopt;
      return radar::bandwidth_hz(pulse_of(radar));
    case Radar::Pulse::chirp:
      if (!std::isfinite(radar.bandwidth_hz)) return std::nullopt;
      if (radar.bandwidth_hz != 0.0) return std::abs(radar.bandwidth_hz);
      break;
    case Radar::Pulse::barker:
      if (radar.barker_code < 0 || radar.barker_code > 6) return std::nullopt;
      return static_cast<double>(radar::barker_code(radar.barker_code).size()) / radar.pulse_width_s;
  }
  return 1.0 / radar.pulse_width_s;
}

}  // namespace sarsim::scene

#include "scene/schema/field_table.hpp"
#include "scene/schema/radar_grammar.hpp"

namespace sarsim::scene::field_tables {

namespace {

// One of a radar's two antennas, and when it is used.
struct AntennaFields {
  std::string id;
  Antenna Radar::*member;
  bool (*used)(const Radar&);
  const script::Field& elevation;
  const script::Field& azimuth;
};

void add_antenna(FieldTable<Radar>& table, const AntennaFields& fields) {
  const auto member = fields.member;
  const auto used = fields.used;
  const auto has = [member, used](Antenna::Pattern pattern) {
    return [=](const Radar& radar) { return used(radar) && (radar.*member).pattern == pattern; };
  };
  table.where(used);
  table.choice(
      fields.id + ".pattern", "Antenna gain", [member](auto& radar) -> auto& { return (radar.*member).pattern; },
      {"Isotropic", "Simple sin(x)/x", "User-defined"},
      "The same in all directions, sin(x)/x in either plane, or given cuts through the pattern.");
  table.where(has(Antenna::Pattern::sinx));
  table.number(
      fields.elevation, "Elevation beam width",
      Quantity::angle, [member](auto& radar) -> auto& { return (radar.*member).elevation_beamwidth; },
      "Between the half-power points; sin(x)/x with x = 0.88 pi sin(offset)/width. Above 0 and up to 360 deg.");
  table.number(
      fields.azimuth, "Azimuth beam width",
      Quantity::angle, [member](auto& radar) -> auto& { return (radar.*member).azimuth_beamwidth; },
      "Between the half-power points; sin(x)/x with x = 0.88 pi sin(offset)/width. Above 0 and up to 360 deg.");
  table.where(has(Antenna::Pattern::user));
  table.function(
      fields.id + ".gain_db", "Gain definition", [member](auto& radar) -> auto& { return (radar.*member).gain_db; },
      "Azimuth and elevation cut: one-way power gain in dB against the angle off the beam; the two are added.");
}

void add_direction(FieldTable<Radar>& table) {
  const auto is = [](Radar::Beam beam) { return [beam](const Radar& radar) { return radar.beam == beam; }; };
  table.always().group("Direction");
  table.choice("beam", "Antenna direction", &Radar::beam, {"Fixed", "Constant rotation", "Spot mode", "User-defined"},
               "Fixed to the platform, turning about its vertical, held on a point of the world, or on a moving one.");
  table.where([](const Radar& r) { return r.beam == Radar::Beam::fixed || r.beam == Radar::Beam::rotating; });
  table.number(script::radar_grammar::beam_elevation, "Beam elevation", Quantity::angle, &Radar::beam_elevation,
               "Above the platform's x-y plane.");
  table.where(is(Radar::Beam::fixed));
  table.number(script::radar_grammar::beam_azimuth, "Beam azimuth", Quantity::angle, &Radar::beam_azimuth,
               "From the platform's +y axis clockwise towards +x.");
  table.where(is(Radar::Beam::rotating));
  table.number(script::radar_grammar::beam_rate, "Rotation speed", Quantity::angle_rate, &Radar::beam_rate,
               "The azimuth is speed times time.");
  table.where(is(Radar::Beam::spot));
  table.vector(script::radar_grammar::spot, "coordinate of the spot", Quantity::length, &Radar::spot_world_m,
               "World point at which the beam is held.");
  table.where(is(Radar::Beam::user));
  table.function("beam_target_world_m", "Point looked at", &Radar::beam_target_world_m,
                 "World x, y and z of the point at which the beam looks, against time.");
}

void add_receiver(FieldTable<Radar>& table) {
  table.always().group("Matched filter window").rare();
  table.choice("window", "Window", &Radar::window, {"Rectangular", "Hanning", "Bartlett", "Hamming", "User-defined"},
               "Weights the matched filter: lower range side lobes for a wider main lobe.");
  table.where([](const Radar& r) { return r.window == Radar::Window::hanning; });
  table.number(script::radar_grammar::hanning_pedestal, "Hanning constant", Quantity::number, &Radar::hanning_pedestal,
               "Window k + (1 - k) sin^2(pi x) for x from 0 to 1: 1 is no weighting, 0 falls to zero at the ends.");
  table.where([](const Radar& r) { return r.window == Radar::Window::user; });
  table.function("window_gain", "Window definition", &Radar::window_gain,
                 "Weight against the fraction of the pulse width, 0 to 1.");
  table.always().group("Sensitivity time control");
  table.choice(
      "stc", "STC", &Radar::stc, {"None", "1/R^4", "User-defined"},
      "Gain against range before the A/D converter: none, one that takes the loss with range out of the echoes, or "
      "given.");
  table.where([](const Radar& r) { return r.stc == Radar::Stc::user; });
  table.function("stc_gain", "STC definition", &Radar::stc_gain, "Voltage gain against range.");
  table.always().rare(false);
}

}  // namespace

void add_antenna_fields(FieldTable<Radar>& table) {
  table.group("Transmitter antenna");
  add_antenna(table, {"transmit_antenna", &Radar::transmit_antenna, [](const Radar&) { return true; },
                      script::radar_grammar::transmit_elevation, script::radar_grammar::transmit_azimuth});
  table.always().group("Receiver antenna");
  table.check("same_antenna", "Same as transmitter", &Radar::same_antenna, "Receive with the transmit antenna.");
  add_antenna(table, {"receive_antenna", &Radar::receive_antenna, [](const Radar& r) { return !r.same_antenna; },
                      script::radar_grammar::receive_elevation, script::radar_grammar::receive_azimuth});
  add_direction(table);
  add_receiver(table);
}

}  // namespace sarsim::scene::field_tables

#include "scene/schema/fields_radar.hpp"

namespace sarsim::scene::radar_fields {

namespace {

using Pattern = Antenna::Pattern;

constexpr Range beam_widths{0.0, 360.0, true};
constexpr std::string_view width_tip =
    "Between the half-power points; sin(x)/x with x = 0.88 pi sin(offset)/width. Above 0 and up to 360 deg.";
constexpr std::string_view pattern_tip =
    "The same in all directions, sin(x)/x in either plane, or given cuts through the pattern.";
constexpr std::string_view cuts_tip =
    "Azimuth and elevation cut: one-way power gain in dB against the angle off the beam; the two are added. Azimuth is "
    "positive to the right of the beam, clockwise seen from above, elevation above it. A table without negative angles "
    "that ends at 180 deg or before is the same to either side.";

// What is called differently in the two antennas of a radar; what it means is the same.
struct AntennaWords {
  std::string_view key;
  std::string_view elevation_key;
  std::string_view azimuth_key;
  std::string_view pattern_id;
  std::string_view elevation_id;
  std::string_view azimuth_id;
  std::string_view gain_id;
  std::string_view antenna;
  std::array<std::string_view, 3> patterns;
  std::string_view elevation;
  std::string_view azimuth;
  std::string_view gain;
  const FunctionBlock& block;
};

template <auto Which>
void add_antenna(FieldTable<Radar>& table, const AntennaWords& words) {
  table.add<Which, &Antenna::pattern>(
      {.id = words.pattern_id,
       .key = words.key,
       .label = "Antenna gain",
       .words = words.antenna,
       .place = words.pattern_id.substr(0, words.pattern_id.find('.')),
       .choices = {{"ISOTROPIC", Pattern::isotropic, "Isotropic", words.patterns[0]},
                   {"SINX", Pattern::sinx, "Simple sin(x)/x", words.patterns[1]},
                   {"SIMPLE", Pattern::sinx, "Simple sin(x)/x", words.patterns[1]},
                   {"OTHER", Pattern::user, "User-defined", words.patterns[2], "points"}},
       .tip = pattern_tip});
  table.when<Which, &Antenna::pattern>(Pattern::sinx);
  table.add<Which, &Antenna::elevation_beamwidth>({.id = words.elevation_id,
                                                   .key = words.elevation_key,
                                                   .label = "Elevation beam width",
                                                   .words = "beam width in elevation",
                                                   .noun = words.elevation,
                                                   .quantity = Quantity::angle,
                                                   .usable = beam_widths,
                                                   .likely = {0.01, 360.0},
                                                   .tip = width_tip});
  table.add<Which, &Antenna::azimuth_beamwidth>({.id = words.azimuth_id,
                                                 .key = words.azimuth_key,
                                                 .label = "Azimuth beam width",
                                                 .words = "beam width in azimuth",
                                                 .noun = words.azimuth,
                                                 .quantity = Quantity::angle,
                                                 .usable = beam_widths,
                                                 .likely = {0.01, 360.0},
                                                 .tip = width_tip});
  table.when<Which, &Antenna::pattern>(Pattern::user);
  table.add<Which, &Antenna::gain_db>({.id = words.gain_id,
                                       .key = words.key,
                                       .label = "Gain definition",
                                       .words = words.gain,
                                       .block = &words.block,
                                       .tip = cuts_tip});
}

constexpr AntennaWords transmit_words{"antenna",
                                      "antenna.elevation_width",
                                      "antenna.azimuth_width",
                                      "transmit_antenna.pattern",
                                      "transmit_antenna.elevation_beamwidth",
                                      "transmit_antenna.azimuth_beamwidth",
                                      "transmit_antenna.gain_db",
                                      "transmit antenna",
                                      {"transmit antenna: the same in all directions", "transmit antenna: sin(x)/x",
                                       "transmit antenna: gain given by points"},
                                      "elevation beam width of the transmit antenna",
                                      "azimuth beam width of the transmit antenna",
                                      "gain of the transmit antenna",
                                      function_blocks::transmit_gain};
constexpr AntennaWords receive_words{"receive_antenna",
                                     "receive_antenna.elevation_width",
                                     "receive_antenna.azimuth_width",
                                     "receive_antenna.pattern",
                                     "receive_antenna.elevation_beamwidth",
                                     "receive_antenna.azimuth_beamwidth",
                                     "receive_antenna.gain_db",
                                     "receive antenna",
                                     {"receive antenna: the same in all directions", "receive antenna: sin(x)/x",
                                      "receive antenna: gain given by points"},
                                     "elevation beam width of the receive antenna",
                                     "azimuth beam width of the receive antenna",
                                     "gain of the receive antenna",
                                     function_blocks::receive_gain};

}  // namespace

void add_antennas(FieldTable<Radar>& table) {
  table.group("Transmitter antenna");
  add_antenna<&Radar::transmit_antenna>(table, transmit_words);
  table.group("Receiver antenna");
  table.add<&Radar::same_antenna>({.id = "same_antenna",
                                   .key = "receive_antenna",
                                   .label = "Same as transmitter",
                                   .words = "receive antenna",
                                   .place = "receive_antenna",
                                   .choices = {{"SAME", true, "yes", "receive antenna: the transmit antenna"}},
                                   .tip = "Receive with the transmit antenna."});
  table.when<&Radar::same_antenna>(false);
  add_antenna<&Radar::receive_antenna>(table, receive_words);
}

void add_direction(FieldTable<Radar>& table) {
  using Beam = Radar::Beam;
  table.group("Direction");
  table.add<&Radar::beam>(
      {.id = "beam",
       .key = "beam",
       .label = "Antenna direction",
       .words = "direction of the beam",
       .choices = {{"FIXED", Beam::fixed, "Fixed", "beam fixed to the platform"},
                   {"ROTATING", Beam::rotating, "Constant rotation", "beam turning about the vertical"},
                   {"SPOT", Beam::spot, "Spot mode", "beam held on a point of the world"},
                   {"OTHER", Beam::user, "User-defined", "beam held on a moving point of the world", "points"}},
       .tip = "Fixed to the platform, turning about its vertical, held on a point of the world, or on a moving one."});
  table.when<&Radar::beam>(Beam::fixed, Beam::rotating);
  table.add<&Radar::beam_elevation>({.id = "beam_elevation",
                                     .key = "beam.elevation",
                                     .label = "Beam elevation",
                                     .words = "elevation of the beam",
                                     .noun = "beam elevation",
                                     .quantity = Quantity::angle,
                                     .likely = {-90.0, 90.0},
                                     .tip = "Above the platform's x-y plane."});
  table.when<&Radar::beam>(Beam::fixed);
  table.add<&Radar::beam_azimuth>({.id = "beam_azimuth",
                                   .key = "beam.azimuth",
                                   .label = "Beam azimuth",
                                   .words = "azimuth of the beam",
                                   .noun = "beam azimuth",
                                   .quantity = Quantity::angle,
                                   .likely = {-360.0, 360.0},
                                   .tip = "From the platform's +y axis clockwise towards +x."});
  table.when<&Radar::beam>(Beam::rotating);
  table.add<&Radar::beam_rate>({.id = "beam_rate",
                                .key = "beam.rate",
                                .label = "Rotation speed",
                                .words = "rotation rate of the beam",
                                .quantity = Quantity::angle_rate,
                                .range = zero_or_more,
                                .usable = any_value,
                                .tip = "The azimuth is speed times time."});
  table.when<&Radar::beam>(Beam::spot);
  table.add<&Radar::spot_world_m>({.id = "spot_world_m",
                                   .key = "beam.point",
                                   .label = "coordinate of the spot",
                                   .words = "spot",
                                   .quantity = Quantity::length,
                                   .on_earth = true,
                                   .tip = "World point at which the beam is held."});
  table.when<&Radar::beam>(Beam::user);
  table.add<&Radar::beam_target_world_m>({.id = "beam_target_world_m",
                                          .key = "beam",
                                          .label = "Look-at point",
                                          .words = "point the beam looks at",
                                          .block = &function_blocks::beam_target,
                                          .tip = "World x, y and z of the beam's look-at point against time."});
}

}  // namespace sarsim::scene::radar_fields

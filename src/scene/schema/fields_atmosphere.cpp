#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

namespace {

void add_air(FieldTable<Atmosphere>& table) {
  using Refraction = Atmosphere::Refraction;
  table.group("Air");
  table.add<&Atmosphere::refraction>(
      {.id = "refraction",
       .key = "refraction",
       .label = "Refraction",
       .words = "refraction",
       .choices = {{"", Refraction::none, "None", "the air is as quick as vacuum", "none"},
                   {"", Refraction::exponential, "Exponential", "refractivity falls with exp(-h/H)", "exponential"},
                   {"", Refraction::linear, "Linear", "refractivity falls evenly, by the factor k", "linear"}},
       .tip = "Delay of echoes by the air: 2.3 m one way at the zenith. Rays stay straight."});
  table.when<&Atmosphere::refraction>(Refraction::exponential, Refraction::linear);
  table.add<&Atmosphere::refractivity>({.id = "refractivity",
                                        .key = "refraction.refractivity",
                                        .label = "Refractivity",
                                        .words = "refractivity at height 0",
                                        .range = {1.0, 1000.0},
                                        .tip = "N = (n - 1) 1e6 at height 0; 315 is the global mean."});
  table.when<&Atmosphere::refraction>(Refraction::exponential);
  table.add<&Atmosphere::scale_height_m>({.id = "scale_height_m",
                                          .key = "refraction.scale_height",
                                          .label = "Scale height",
                                          .words = "scale height of the refractivity",
                                          .quantity = Quantity::length,
                                          .range = {100.0, 50e3},
                                          .tip = "H in N = N0 exp(-h/H)."});
  table.when<&Atmosphere::refraction>(Refraction::linear);
  table.add<&Atmosphere::k_factor>({.id = "k_factor",
                                    .key = "refraction.k",
                                    .label = "Factor k",
                                    .words = "factor k of the Earth's radius",
                                    .range = {1.001, 100.0},
                                    .tip = "4/3 is a gradient of -39.24 N per km."});
  table.always();
  table.add<&Atmosphere::gases>({.id = "gases",
                                 .key = "gases",
                                 .label = "Gases",
                                 .words = "loss by gases",
                                 .choices = {{"", false, "no", "no loss by gases", "no"},
                                             {"", true, "yes", "oxygen and water vapour absorb", "yes"}},
                                 .tip = "Absorption by oxygen and water vapour, ITU-R P.676-13, in the reference "
                                        "atmosphere of P.835."});
  table.add<&Atmosphere::vapour_g_per_m3>({.id = "vapour_g_per_m3",
                                           .key = "vapour",
                                           .label = "Water vapour",
                                           .words = "water vapour at height 0",
                                           .range = {0.0, 50.0},
                                           .tip = "In g/m3; 7.5 is the global mean."});
}

void add_rain(FieldTable<Atmosphere>& table) {
  table.always();
  table.group("Rain");
  table.add<&Atmosphere::rain_mm_per_h>({.id = "rain_mm_per_h",
                                         .key = "rain.rate",
                                         .label = "Rain rate",
                                         .words = "rain rate",
                                         .range = {0.0, 500.0},
                                         .tip = "In mm/h, the same everywhere below the rain height; loss by ITU-R "
                                                "P.838-3, 1 to 1000 GHz."});
  table.add<&Atmosphere::rain_top_m>({.id = "rain_top_m",
                                      .key = "rain.height",
                                      .label = "Rain height",
                                      .words = "height of the rain",
                                      .quantity = Quantity::length,
                                      .range = {0.0, 20e3},
                                      .tip = "Height up to which it rains."});
  table.add<&Atmosphere::polarisation>({.id = "polarisation",
                                        .key = "rain.polarisation",
                                        .label = "Polarisation",
                                        .words = "tilt of the polarisation",
                                        .quantity = Quantity::angle,
                                        .range = {-90.0, 90.0},
                                        .tip = "From the horizontal: 0 for H, 90 deg for V, 45 deg for circular."});
}

void add_ionosphere(FieldTable<Atmosphere>& table) {
  table.group("Ionosphere");
  table.add<&Atmosphere::tec_units>({.id = "tec_units",
                                     .key = "ionosphere.tec",
                                     .label = "Electron content",
                                     .words = "vertical electron content",
                                     .range = {0.0, 1000.0},
                                     .tip =
                                         "In TEC units of 1e16 electrons per m2: 5 to 20 at night, up to 100 by day. "
                                         "Delays by 40.3 TEC/f^2, and advances the phase as much."});
  table.add<&Atmosphere::shell_height_m>(
      {.id = "shell_height_m",
       .key = "ionosphere.height",
       .label = "Shell height",
       .words = "height of the ionosphere",
       .quantity = Quantity::length,
       .range = {100e3, 1000e3},
       .tip = "Height of the thin shell that contains all electrons; a radar below it sees none."});
  table.add<&Atmosphere::field_ut>({.id = "field_ut",
                                    .key = "ionosphere.field",
                                    .label = "Magnetic field",
                                    .words = "magnetic field along the path",
                                    .range = {-100.0, 100.0},
                                    .tip = "In uT; rotates a linear polarisation (Faraday), which costs amplitude."});
}

}  // namespace

template <>
const FieldTable<Atmosphere>& table_of<Atmosphere>() {
  static const FieldTable<Atmosphere> made = [] {
    FieldTable<Atmosphere> table;
    add_air(table);
    add_rain(table);
    add_ionosphere(table);
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene

#pragma once

#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

/// What scripts call the two ends of a range window.
struct WindowLabels {
  std::string_view range_start;
  std::string_view range_end;
};

/// Adds the fields of the window that a recording and a geometry table look through.
template <class Product>
void add_window(FieldTable<Product>& table, const WindowLabels& words) {
  constexpr std::string_view range_tip =
      "One-way slant range: c/2 times the delay. A pulse of length Tp covers c Tp/2 of it.";
  constexpr std::string_view time_tip =
      "Azimuth (slow time): pulses sent from the start to the end are taken, both included.";
  table.group("Window");
  table.template add<&Product::range_start_m>({.id = "range_start_m",
                                               .key = "range[0]",
                                               .label = "Slant range from",
                                               .words = words.range_start,
                                               .noun = "slant range start",
                                               .quantity = Quantity::length,
                                               .likely = {-1e5, 1e9},  // Half a centred pulse before the radar.
                                               .tip = range_tip});
  table.template add<&Product::range_end_m>({.id = "range_end_m",
                                             .key = "range[1]",
                                             .label = "Slant range to",
                                             .words = words.range_end,
                                             .noun = "slant range end",
                                             .quantity = Quantity::length,
                                             .likely = {0.0, 1e9},
                                             .tip = range_tip});
  table.template add<&Product::time_start_s>({.id = "time_start_s",
                                              .key = "time[0]",
                                              .label = "Azimuth range from",
                                              .words = "slow time of the start",
                                              .noun = "azimuth start",
                                              .quantity = Quantity::time,
                                              .likely = {-1e5, 1e5},
                                              .tip = time_tip});
  table.template add<&Product::time_end_s>({.id = "time_end_s",
                                            .key = "time[1]",
                                            .label = "Azimuth range to",
                                            .words = "slow time of the end",
                                            .noun = "azimuth end",
                                            .quantity = Quantity::time,
                                            .likely = {-1e5, 1e5},
                                            .tip = time_tip});
}

}  // namespace sarsim::scene

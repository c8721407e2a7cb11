#include "scene/ephemeris/element_choice.hpp"

#include <array>
#include <numbers>
#include <string>

#include <fmt/format.h>

namespace sarsim::scene {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct ElementWords {
  const char* name;
  double radar::MeanElements::*number;
  double unit;
  const char* unit_text;
};

constexpr std::array<ElementWords, 7> element_words{{
    {"mean anomaly", &radar::MeanElements::mean_anomaly_rad, degree, " deg"},
    {"mean motion", &radar::MeanElements::mean_motion_rad_per_s, 2.0 * std::numbers::pi / 86400.0, " rev/day"},
    {"ascending node", &radar::MeanElements::ascending_node_rad, degree, " deg"},
    {"inclination", &radar::MeanElements::inclination_rad, degree, " deg"},
    {"perigee", &radar::MeanElements::perigee_rad, degree, " deg"},
    {"eccentricity", &radar::MeanElements::eccentricity, 1.0, ""},
    {"drag (B*)", &radar::MeanElements::drag_per_earth_radius, 1.0, ""},
}};

}  // namespace

std::optional<core::Problem> problem_of_other_sets(std::span<const ElementSet> sets, const ElementSet& chosen) {
  std::size_t others = 0;
  std::string found;
  for (const ElementSet& set : sets) {
    if (set.epoch != chosen.epoch) continue;
    bool same = true;
    for (const ElementWords& words : element_words) {
      const double a = chosen.elements.*words.number, b = set.elements.*words.number;
      if (a == b) continue;
      if (found.empty())
        found = fmt::format("{} {:.8g} and {:.8g}{}", words.name, a / words.unit, b / words.unit, words.unit_text);
      same = false;
    }
    if (!same) ++others;
  }
  if (others == 0) return std::nullopt;
  return core::warning(fmt::format("{} sets of the epoch {} differ in their elements; the first of them counts",
                                   others + 1, radar::format_civil(chosen.epoch)))
      .found(found)
      .expected("one set of an epoch")
      .hint("remove those that were replaced");
}

}  // namespace sarsim::scene

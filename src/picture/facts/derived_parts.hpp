#pragma once

#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "picture/facts/derived_figures.hpp"
#include "scene/schema/fields.hpp"

/// The parts of `derived_figures`. Internal to the derived_*.cpp files.
namespace sarsim::picture::derived {

/// Collects figures; those that are no finite numbers are left out.
class Figures {
 public:
  /// A text, said with these numbers.
  void text(std::string label, std::string text, std::string formula, std::initializer_list<double> numbers = {});
  /// A number with the unit that suits it, four digits.
  void number(std::string label, double value, scene::Quantity quantity, std::string formula);
  /// A number with a fixed unit, four digits.
  void plain(std::string label, double value, std::string_view unit, std::string formula);
  [[nodiscard]] std::vector<DerivedFigure> take() { return std::move(figures_); }

 private:
  std::vector<DerivedFigure> figures_;
};

/// Four digits with the unit that suits the size.
[[nodiscard]] std::string rounded_text(double value, scene::Quantity quantity);

/// Fields of one object with an error, as `check` names them, in a scene of a few objects.
[[nodiscard]] std::set<std::string> faulty_fields(const scene::Scene& scene, std::string_view kind,
                                                  std::size_t index = 0);

/// What of a radar can be computed with. A faulty part is replaced by the initial one, and what depends on it is not to
/// be shown.
struct SoundRadar {
  scene::Radar radar;  ///< Stands on "Earth".
  bool pulse = true;
  bool repetition = true;
  bool carrier = true;
  bool power = true;
  bool noise = true;
  bool antenna = true;  ///< Antennas and direction.
};
[[nodiscard]] SoundRadar sound_radar(const scene::Scene& scene, std::size_t index);

/// A platform without its random errors; nothing where it has an error of another kind.
[[nodiscard]] std::optional<scene::Platform> nominal_platform(scene::Platform platform, const scene::World& world);

/// The figures of one object each, those of what moves at a time; faulty parts are left out.
void platform_figures(Figures& figures, const scene::Scene& scene, std::size_t index, double time_s);
void target_figures(Figures& figures, const scene::Scene& scene, std::size_t index, double time_s);
void cloud_figures(Figures& figures, const scene::Scene& scene, std::size_t index);
void surface_figures(Figures& figures, const scene::Scene& scene, std::size_t index);
void radar_figures_of(Figures& figures, const scene::Scene& scene, std::size_t index);
void simulation_figures_of(Figures& figures, const scene::Scene& scene, std::size_t index);
void geometry_figures(Figures& figures, const scene::Scene& scene, std::size_t index);

}  // namespace sarsim::picture::derived

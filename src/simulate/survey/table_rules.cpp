#include "simulate/survey/table_rules.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "scene/model/scene_index.hpp"
#include "simulate/survey/table_reach.hpp"

namespace sarsim::simulate {

namespace {

using scene::FunctionRole;

constexpr double noticed_db = 0.1;

// One cut of an antenna, with the words of the scene for it.
struct Cut {
  const char* field;         ///< "transmit_antenna"
  std::string_view antenna;  ///< "transmit"
  std::string_view plane;    ///< "azimuth"
  FunctionRole role;
  const core::SampledFunction* points;
  double radar::BeamOffset::*angle;
};

std::vector<Cut> cuts_of(const scene::Radar& radar) {
  std::vector<Cut> cuts;
  const auto add = [&](const char* field, std::string_view antenna, const scene::Antenna& from) {
    if (from.pattern != scene::Antenna::Pattern::user) return;
    cuts.push_back({field, antenna, "azimuth", FunctionRole::azimuth_cut, from.gain_db.part.data(),
                    &radar::BeamOffset::azimuth_rad});
    cuts.push_back({field, antenna, "elevation", FunctionRole::elevation_cut, &from.gain_db.part[1],
                    &radar::BeamOffset::elevation_rad});
  };
  add("transmit_antenna", radar.same_antenna ? "" : "transmit ", radar.transmit_antenna);
  if (!radar.same_antenna) add("receive_antenna", "receive ", radar.receive_antenna);
  return cuts;
}

// How far an angle is from the nearer end of a table, on the way round that is not in it.
double beyond_deg(const std::vector<core::Knot>& knots, double angle_deg) {
  const auto apart = [&](double end_deg) { return std::abs(std::remainder(angle_deg - end_deg, 360.0)); };
  return std::min(apart(knots.front().x), apart(knots.back().x));
}

std::string sentence_of(std::size_t some, std::size_t all) {
  return some == all ? fmt::format("{} of {} target{}", some, all, all == 1 ? "" : "s")
                     : fmt::format("{} of {} targets", some, all);
}

// The target that is farthest outside of a table, and how many are.
struct Farthest {
  std::size_t targets = 0;
  std::size_t target = 0;
  double angle_deg = 0.0;
  double by_deg = -1.0;

  void take(std::size_t number, double at_deg, double far_deg) {
    if (far_deg <= by_deg) return;
    target = number;
    angle_deg = at_deg;
    by_deg = far_deg;
  }
};

class TableRules {
 public:
  TableRules(const VisibilityCase& sighted, core::Problems& problems)
      : sighted_(sighted), sights_(sighted.summary.sights), problems_(problems) {
    by_role_ = sighted.acquisition.scene->conventions.function_ends == Conventions::FunctionEnds::by_role;
  }

  void check(const EchoSurvey& survey) {
    const std::size_t radar = scene::find_radar(sighted_.scene, sighted_.acquisition.simulation.radar);
    if (radar == scene::not_found) return;
    const std::vector<Cut> cuts = cuts_of(sighted_.scene.radars[radar]);
    look_farther(cuts, survey);
    for (const Cut& cut : cuts) {
      check_cut(cut, radar);
      check_cut_of_surfaces(cut, radar);
    }
    check_reflectivities();
  }

 private:
  [[nodiscard]] core::InterpolationRules usual() const {
    return interpolation_rules(sighted_.acquisition.scene->options);
  }
  [[nodiscard]] core::AngleFunction function_of(const Cut& cut) const {
    return scene::angle_function(cut.role, *cut.points, usual(), by_role_);
  }

  // Adds what reaches beyond the tables among what the survey of sights left out.
  void look_farther(const std::vector<Cut>& cuts, const EchoSurvey& survey) {
    const std::vector<core::Interpolator>& curves = sighted_.acquisition.scene->gain_curves;
    const bool has_surfaces = !sighted_.acquisition.scene->sheets.empty();
    const bool knows_targets = survey.totals.in_window <= sights_.size();
    if ((cuts.empty() && curves.empty()) || (knows_targets && (cuts.empty() || !has_surfaces))) return;
    std::vector<std::size_t> examined;
    for (const TargetVisibility& sight : sights_) examined.push_back(sight.target);
    std::vector<core::AngleFunction> functions;
    for (const Cut& cut : cuts) functions.push_back(function_of(cut));
    AngleTables tables;
    tables.count = cuts.size() + 1;
    tables.beyond = [&](const radar::BeamOffset& offset, std::optional<double> incidence_rad, std::uint32_t curve,
                        std::span<double> by_deg) {
      for (std::size_t i = 0; i < cuts.size(); ++i) by_deg[i] = beyond_cut_deg(cuts[i], functions[i], offset);
      by_deg.back() = incidence_rad ? beyond_curve_deg(curves[curve], *incidence_rad * core::deg_per_rad) : 0.0;
    };
    TableReach reach = reach_beyond_tables(sighted_.acquisition, survey, examined, tables, sighted_.control);
    std::ranges::move(reach.targets, std::back_inserter(sights_));
    surfaces_ = std::move(reach.surfaces);
  }

  static double beyond_cut_deg(const Cut& cut, const core::AngleFunction& function, const radar::BeamOffset& offset) {
    const std::vector<core::Knot>& knots = cut.points->knots;
    const double angle_deg = offset.*cut.angle * core::deg_per_rad;
    if (knots.size() < 2 || function.covers(angle_deg)) return 0.0;
    return beyond_deg(knots, function.is_even() ? std::abs(angle_deg) : angle_deg);
  }
  static double beyond_curve_deg(const core::Interpolator& curve, double angle_deg) {
    if (curve.knots().size() < 2) return 0.0;
    const double by_deg = std::max(curve.knots().front().x - angle_deg, angle_deg - curve.knots().back().x);
    return by_deg <= 1e-9 ? 0.0 : by_deg;
  }

  // Points of clouds have numbers behind those of the targets.
  [[nodiscard]] std::string name_of(std::size_t target) const {
    const ScattererList& list = sighted_.acquisition.scene->scatterers;
    if (target < list.targets()) return fmt::format("target {}", target + 1);
    std::size_t cloud = 0;
    while (cloud + 1 < list.clouds().size() && list.clouds()[cloud + 1].first <= target) ++cloud;
    return fmt::format("a point of cloud {}", cloud + 1);
  }

  [[nodiscard]] std::string words_of(FunctionRole role) const {
    return std::string(by_role_ ? scene::function_ends(role).words : "goes on as its interpolation does");
  }

  void add(core::ProblemBuilder problem) {
    problems_.push_back(std::move(problem).expected("points as far as targets are seen"));
  }

  void check_cut(const Cut& cut, std::size_t radar) {
    const std::vector<core::Knot>& knots = cut.points->knots;
    if (knots.size() < 2) return;
    const core::AngleFunction function = function_of(cut);
    Farthest farthest;
    for (const TargetVisibility& sight : sights_)
      if (take_cut(cut, function, sight, sight.target, farthest)) ++farthest.targets;
    if (farthest.targets == 0) return;
    report_cut(cut, radar, function, sentence_of(farthest.targets, sights_.size()), name_of(farthest.target), farthest);
  }

  // Whether it is seen beyond the cut.
  static bool take_cut(const Cut& cut, const core::AngleFunction& function, const TargetVisibility& sight,
                       std::size_t number, Farthest& farthest) {
    bool outside = false;
    for (const LitLook& look : sight.lit) {
      const double by_deg = beyond_cut_deg(cut, function, look.offset);
      if (by_deg <= 0.0) continue;
      outside = true;
      farthest.take(number, look.offset.*cut.angle * core::deg_per_rad, by_deg);
    }
    return outside;
  }

  void check_cut_of_surfaces(const Cut& cut, std::size_t radar) {
    const core::AngleFunction function = function_of(cut);
    Farthest farthest;
    std::size_t last = scene::not_found;
    for (const SurfaceSight& one : surfaces_) {
      if (!take_cut(cut, function, one.sight, one.surface, farthest) || one.surface == last) continue;
      ++farthest.targets;
      last = one.surface;
    }
    if (farthest.targets == 0) return;
    const std::size_t all = sighted_.acquisition.scene->sheets.size();
    report_cut(cut, radar, function, fmt::format("{} of {} surface{}", farthest.targets, all, all == 1 ? "" : "s"),
               fmt::format("surface {}", farthest.target + 1), farthest);
  }

  void report_cut(const Cut& cut, std::size_t radar, const core::AngleFunction& function, const std::string& who,
                  const std::string& worst, const Farthest& farthest) {
    const std::vector<core::Knot>& knots = cut.points->knots;
    add(core::warning("antenna-cut.beyond-points",
                      fmt::format("{} are seen beyond the points of the {}antenna's cut in {}, where it {}", who,
                                  cut.antenna, cut.plane, words_of(FunctionRole::elevation_cut)))
            .found(fmt::format("{} at {:.4g} deg, points from {:g} to {:g} deg{}; {:.4g} dB is taken", worst,
                               farthest.angle_deg, knots.front().x, knots.back().x,
                               function.is_even() ? " to either side" : "", function.value(farthest.angle_deg)))
            .hint(cut.role == FunctionRole::azimuth_cut
                      ? "Azimuth is positive to the right of the beam, clockwise seen from above."
                      : "Elevation is positive above the beam.")
            .at("radar", radar, cut.field));
  }

  void check_reflectivities() {
    Farthest farthest;
    std::size_t some = 0;
    const core::Interpolator* of = nullptr;
    for (const TargetVisibility& sight : sights_) {
      const core::Interpolator* const curve = curve_of(sight.target);
      if (curve == nullptr || curve->knots().size() < 2) continue;
      ++some;
      bool outside = false;
      for (const LitLook& look : sight.lit) {
        const double angle_deg = look.incidence_rad * core::deg_per_rad;
        const double by_deg = beyond_curve_deg(*curve, angle_deg);
        if (by_deg <= 0.0) continue;
        outside = true;
        if (by_deg > farthest.by_deg) of = curve;
        farthest.take(sight.target, angle_deg, by_deg);
      }
      if (outside) ++farthest.targets;
    }
    if (of == nullptr) return;
    add(core::warning(
            "reflectivity.beyond-points",
            fmt::format("{} with a reflectivity by points are seen at incidence angles beyond these, where it {}",
                        sentence_of(farthest.targets, some), words_of(FunctionRole::reflectivity)))
            .found(fmt::format("{} at {:.4g} deg, points from {:g} to {:g} deg; {:.4g} dB is taken",
                               name_of(farthest.target), farthest.angle_deg, of->knots().front().x,
                               of->knots().back().x, of->value(farthest.angle_deg)))
            .hint("The angle counts from the normal, 0 to 180 deg.")
            .at("target", farthest.target, "gain_db"));
  }

  [[nodiscard]] const core::Interpolator* curve_of(std::size_t target) const {
    const ResolvedScene& scene = *sighted_.acquisition.scene;
    const Scatterer s = scene.scatterers[target];
    return s.law == radar::ReflectivityLaw::user ? &scene.gain_curves[s.gain_curve] : nullptr;
  }

  const VisibilityCase& sighted_;
  std::vector<TargetVisibility> sights_;
  std::vector<SurfaceSight> surfaces_;  // of one surface one after the other
  core::Problems& problems_;
  bool by_role_ = true;
};

// A function as both profiles read it.
struct BothWays {
  std::function<double(double)> classic;
  std::function<double(double)> physical;

  BothWays(FunctionRole role, const core::SampledFunction& function, core::InterpolationRules usual)
      : classic(scene::evaluated(role, function, usual, false)),
        physical(scene::evaluated(role, function, usual, true)) {}
};

// One simulation as both profiles read it.
class ProfileComparison {
 public:
  ProfileComparison(const scene::Scene& scene, const EchoSummary& summary, core::Problems& problems)
      : scene_(scene),
        summary_(summary),
        simulation_(scene.simulations.at(summary.simulation)),
        is_classic_(scene.options.profile == scene::Profile::classic),
        problems_(problems) {}

  void compare() {
    const std::size_t radar = scene::find_radar(scene_, simulation_.radar);
    if (radar == scene::not_found) return;
    compare_antennas(scene_.radars[radar], radar);
    compare_reflectivities();
    compare_stc(scene_.radars[radar], radar);
  }

 private:
  [[nodiscard]] core::InterpolationRules usual() const { return interpolation_rules(scene_.options); }

  void add(core::ProblemBuilder problem) {
    problems_.push_back(
        std::move(problem).hint("The profile physical takes signs of angles and holds the ends of gains; classic takes "
                                "magnitudes and goes on, as the programs of 1998."));
  }

  void compare_antennas(const scene::Radar& radar, std::size_t index) {
    const std::vector<Cut> cuts = cuts_of(radar);
    if (cuts.empty()) return;
    std::vector<BothWays> both;
    bool half_is_left_out = false;
    for (const Cut& cut : cuts) {
      both.emplace_back(cut.role, *cut.points, usual());
      half_is_left_out = half_is_left_out || (cut.points->knots.size() > 1 && cut.points->knots.front().x < 0.0);
    }
    // Offsets of the profile classic are those of the axis from the target.
    const double sign = is_classic_ ? -1.0 : 1.0;
    const double ways = radar.same_antenna ? 2.0 : 1.0;
    std::size_t targets = 0;
    double worst_db = noticed_db, classic_db = 0.0, physical_db = 0.0;
    std::size_t worst_target = 0;
    radar::BeamOffset at;
    for (const TargetVisibility& sight : summary_.sights) {
      bool differs = false;
      for (const LitLook& look : sight.lit) {
        double one_db = 0.0, other_db = 0.0;
        for (std::size_t i = 0; i < cuts.size(); ++i) {
          const double angle_deg = sign * (look.offset.*cuts[i].angle) * core::deg_per_rad;
          one_db += ways * both[i].classic(angle_deg);
          other_db += ways * both[i].physical(angle_deg);
        }
        const double off_db = std::abs(one_db - other_db);
        differs = differs || off_db > noticed_db;
        if (off_db <= worst_db) continue;
        worst_db = off_db;
        classic_db = one_db;
        physical_db = other_db;
        worst_target = sight.target;
        at = {sign * look.offset.azimuth_rad + 0.0, sign * look.offset.elevation_rad + 0.0};  // no -0
      }
      if (differs) ++targets;
    }
    if (targets == 0) return;
    add(core::ProblemBuilder(is_classic_ && half_is_left_out ? core::Severity::warning : core::Severity::note,
                             "profiles.antenna-cuts-differ",
                             fmt::format("the profiles classic and physical read the antenna's cuts differently: {}",
                                         sentence_of(targets, summary_.sights.size())))
            .found(fmt::format(
                "target {} at azimuth {:.4g} deg, elevation {:.4g} deg off the beam: {:.4g} dB two-way by classic, "
                "{:.4g} dB by physical",
                worst_target + 1, at.azimuth_rad * core::deg_per_rad, at.elevation_rad * core::deg_per_rad, classic_db,
                physical_db))
            .at("radar", index, "transmit_antenna"));
  }

  void compare_reflectivities() {
    std::size_t targets = 0, worst_target = 0;
    double worst_db = noticed_db, classic_db = 0.0, physical_db = 0.0, at_deg = 0.0;
    for (const TargetVisibility& sight : summary_.sights) {
      if (sight.target >= scene_.targets.size()) continue;
      const scene::TargetTraits& traits = *scene_.targets[sight.target].traits;
      if (traits.reflectivity != scene::TargetTraits::Reflectivity::directional ||
          traits.gain != scene::TargetTraits::Gain::user)
        continue;
      const BothWays both(FunctionRole::reflectivity, traits.gain_db.part[0], usual());
      bool differs = false;
      for (const LitLook& look : sight.lit) {
        const double angle_deg = look.incidence_rad * core::deg_per_rad;
        const double one_db = both.classic(angle_deg), other_db = both.physical(angle_deg);
        differs = differs || std::abs(one_db - other_db) > noticed_db;
        if (std::abs(one_db - other_db) <= worst_db) continue;
        worst_db = std::abs(one_db - other_db);
        classic_db = one_db;
        physical_db = other_db;
        worst_target = sight.target;
        at_deg = angle_deg;
      }
      if (differs) ++targets;
    }
    if (targets == 0) return;
    add(core::note("profiles.reflectivities-differ",
                   fmt::format("the profiles classic and physical read reflectivities differently: {}",
                               sentence_of(targets, summary_.sights.size())))
            .found(fmt::format(
                "target {} at an incidence angle of {:.4g} deg: {:.4g} dB by classic, {:.4g} dB by physical",
                worst_target + 1, at_deg, classic_db, physical_db))
            .at("target", worst_target, "gain_db"));
  }

  void compare_stc(const scene::Radar& radar, std::size_t index) {
    if (radar.stc != scene::Radar::Stc::user) return;
    const BothWays both(FunctionRole::stc, radar.stc_gain.part[0], usual());
    for (const double range_m : {simulation_.range_end_m, simulation_.range_start_m}) {
      const double one = both.classic(range_m), other = both.physical(range_m);
      if (std::abs(20.0 * std::log10(std::abs(one / other))) <= noticed_db) continue;
      add(core::note("profiles.stc-differs",
                     "the profiles classic and physical continue the sensitivity-time control differently")
              .found(fmt::format("at {:.6g} m: {:.4g} by classic, {:.4g} by physical", range_m, one, other))
              .at("radar", index, "stc_gain"));
      return;
    }
  }

  const scene::Scene& scene_;
  const EchoSummary& summary_;
  const scene::Simulation& simulation_;
  bool is_classic_;
  core::Problems& problems_;
};

}  // namespace

core::Problems differences_of_profiles(const scene::Scene& scene, std::span<const EchoSummary> summaries) {
  core::Problems problems;
  for (const EchoSummary& summary : summaries) ProfileComparison(scene, summary, problems).compare();
  return problems;
}

void check_tables(const VisibilityCase& sighted, const EchoSurvey& survey, core::Problems& problems) {
  TableRules(sighted, problems).check(survey);
}

}  // namespace sarsim::simulate

#include "simulate/survey/table_reach.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "core/maths/constants.hpp"
#include "radar/path/path.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::int64_t pulses_compared = 9;
constexpr std::int64_t pulses_of_targets = 3;
constexpr std::size_t max_targets = 20'000;
constexpr std::size_t max_surfaces = 2'000;
constexpr std::size_t max_surface_points = 4'000;  // of all surfaces together
constexpr std::size_t max_looks = 64;

// Of one surface, or of all targets: the points that are farthest beyond a table at some pulse, and by how much.
class ReachingPoints {
 public:
  // Begins a pulse: points are compared with each other at one pulse.
  void begin() { best_.clear(); }
  void take(std::size_t point, std::span<const double> beyond_deg) {
    best_.resize(std::max(best_.size(), beyond_deg.size()));
    for (std::size_t i = 0; i < beyond_deg.size(); ++i)
      if (beyond_deg[i] > best_[i].by_deg) best_[i] = {point, beyond_deg[i]};
  }
  void end() {
    for (const Best& best : best_) {
      if (!(best.by_deg > 0.0)) continue;
      const auto known = std::ranges::find(all_, best.point, &Best::point);
      if (known == all_.end())
        all_.push_back(best);
      else
        known->by_deg = std::max(known->by_deg, best.by_deg);
    }
  }
  [[nodiscard]] bool empty() const { return all_.empty(); }

  // At most so many: from the farthest to the nearest, evenly.
  [[nodiscard]] std::vector<std::size_t> points(std::size_t most) {
    std::ranges::sort(all_, std::ranges::greater{}, &Best::by_deg);
    std::vector<std::size_t> chosen;
    const std::size_t count = std::min(most, all_.size());
    for (std::size_t i = 0; i < count; ++i)
      chosen.push_back(all_[count > 1 ? i * (all_.size() - 1) / (count - 1) : 0].point);
    return chosen;
  }

 private:
  struct Best {
    std::size_t point = 0;
    double by_deg = 0.0;
  };
  std::vector<Best> best_;  // by table
  std::vector<Best> all_;
};

std::size_t step_of(std::size_t points, std::size_t most) { return 1 + (points > 0 ? (points - 1) / most : 0); }

class ReachComparison {
 public:
  ReachComparison(const Acquisition& acquisition, const AngleTables& tables, const core::WorkControl& control)
      : acquisition_(acquisition),
        scene_(*acquisition.scene),
        tables_(tables),
        control_(control),
        sheets_(scene_.sheets.size()),
        beyond_deg_(tables.count) {}

  void compare(const EchoSurvey& survey, const std::vector<std::size_t>& examined) {
    choose_targets(survey, examined);
    const std::size_t step = step_of(scene_.sheets.size(), max_surfaces);
    const std::size_t each = max_surface_points / std::max<std::size_t>(1, scene_.sheets.size() / step);
    std::vector<std::pair<std::size_t, std::vector<std::size_t>>> surfaces;
    for (std::size_t i = 0; i < scene_.sheets.size(); i += step)
      surfaces.emplace_back(i, outermost(scene_.sheets[i], std::clamp<std::size_t>(each / 2, 4, 16)));
    PulseGeometry geometry(scene_, acquisition_.link);
    const std::int64_t count = std::min(pulses_compared, acquisition_.timing.pulses.count());
    for (std::int64_t i = 0; i < count; ++i) {
      const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.5;
      geometry.set_pulse(acquisition_.timing.pulses.first +
                         std::llround(share * static_cast<double>(acquisition_.timing.pulses.count() - 1)));
      if (i % ((pulses_compared - 1) / (pulses_of_targets - 1)) == 0) compare_targets(geometry);
      for (const auto& [sheet, points] : surfaces) compare_sheet(geometry, sheet, points);
      if (control_.stop != nullptr && control_.stop->requested()) throw core::Interrupted();
    }
  }

  [[nodiscard]] std::vector<TargetVisibility> target_sights() {
    if (targets_.empty()) return {};
    std::vector<std::size_t> chosen = targets_.points(max_looks / 2);
    std::ranges::sort(chosen);
    return VisibilitySurvey(acquisition_, chosen).look(control_);
  }

  [[nodiscard]] std::vector<SurfaceSight> surface_sights() {
    const auto reaching = static_cast<std::size_t>(
        std::ranges::count_if(sheets_, [](const ReachingPoints& farthest) { return !farthest.empty(); }));
    if (reaching == 0) return {};
    const std::size_t each = std::max<std::size_t>(1, max_looks / 2 / reaching);
    auto points = std::make_shared<ResolvedScene>();
    points->conventions = scene_.conventions;
    points->options = scene_.options;
    points->turning = scene_.turning;
    points->platforms = scene_.platforms;
    std::vector<SurfaceSight> sights;
    std::vector<std::size_t> numbers;
    for (std::size_t sheet = 0; sheet < sheets_.size() && sights.size() < max_looks; ++sheet)
      for (const std::size_t point : sheets_[sheet].points(each)) {
        points->scatterers.push_back(scatterer_of(scene_.sheets[sheet], point));
        numbers.push_back(sights.size());
        sights.push_back({sheet, {}});
      }
    Acquisition acquisition = acquisition_;
    acquisition.scene = points;
    std::vector<TargetVisibility> seen = VisibilitySurvey(acquisition, numbers).look(control_);
    for (std::size_t i = 0; i < sights.size(); ++i) sights[i].sight = std::move(seen[i]);
    return sights;
  }

 private:
  static Scatterer scatterer_of(const ScattererSheet& sheet, std::size_t point) {
    Scatterer s;
    s.platform = sheet.platform;
    s.law = radar::ReflectivityLaw::cosine;
    s.position_m = sheet.points_m[point];
    s.rcs_m2 = sheet.point_rcs_m2;
    s.azimuth_rad = core::azimuth_rad(sheet.normal_platform);
    s.elevation_rad = core::elevation_rad(sheet.normal_platform);
    return s;
  }

  void choose_targets(const EchoSurvey& survey, const std::vector<std::size_t>& examined) {
    for (std::size_t i = 0; i < survey.targets.size(); ++i)
      if (survey.targets[i].in_window && !std::ranges::binary_search(examined, i)) chosen_.push_back(i);
    const std::size_t step = step_of(chosen_.size(), max_targets);
    for (std::size_t i = 0; i * step < chosen_.size(); ++i) chosen_[i] = chosen_[i * step];
    chosen_.resize((chosen_.size() + step - 1) / step);
  }

  [[nodiscard]] static radar::BeamOffset offset_of(const radar::Pointing& pointing, const core::Vec3& look_world_m) {
    const radar::BeamOffset offset = pointing.offset(look_world_m);
    return {radar::wrapped_angle(offset.azimuth_rad), radar::wrapped_angle(offset.elevation_rad)};
  }

  [[nodiscard]] static core::Vec3 line_of_sight_m(const PulseGeometry& geometry, std::uint32_t platform,
                                                  const core::Vec3& position_m) {
    return radar::world_position_m(geometry.pose(platform), position_m) - geometry.radar_pose().position_world_m;
  }

  void compare_targets(const PulseGeometry& geometry) {
    const radar::Pointing pointing = geometry.pointing();
    targets_.begin();
    for (const std::size_t i : chosen_) {
      const Scatterer s = scene_.scatterers[i];
      std::optional<double> incidence_rad;
      if (s.law == radar::ReflectivityLaw::user) incidence_rad = geometry.view(i, pointing).incidence_rad;
      const radar::BeamOffset offset = offset_of(pointing, line_of_sight_m(geometry, s.platform, s.position_m));
      tables_.beyond(offset, incidence_rad, s.gain_curve, beyond_deg_);
      targets_.take(i, beyond_deg_);
    }
    targets_.end();
  }

  // The points that are outermost in some directions within the plane, and as many of the others.
  static std::vector<std::size_t> outermost(const ScattererSheet& sheet, std::size_t directions) {
    const std::vector<core::Vec3>& points = sheet.points_m;
    if (points.empty()) return {};
    const core::Vec3& normal = sheet.normal_platform;
    const core::Vec3 any = std::abs(normal.z) < 0.7 ? core::Vec3{0.0, 0.0, 1.0} : core::Vec3{1.0, 0.0, 0.0};
    const core::Vec3 across = core::cross(normal, any);
    const core::Vec3 along = core::cross(normal, across);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < directions; ++i) {
      const double angle = 2.0 * core::pi * static_cast<double>(i) / static_cast<double>(directions);
      const core::Vec3 out = std::cos(angle) * across + std::sin(angle) * along;
      const auto far = std::ranges::max_element(points, {}, [&](const core::Vec3& p) { return core::dot(p, out); });
      chosen.push_back(static_cast<std::size_t>(far - points.begin()));
    }
    const std::size_t step = step_of(points.size(), directions);
    for (std::size_t i = 0; i < points.size(); i += step) chosen.push_back(i);
    std::ranges::sort(chosen);
    const auto doubles = std::ranges::unique(chosen);
    chosen.erase(doubles.begin(), doubles.end());
    return chosen;
  }

  // Points whose echo touches the window, from the front.
  void compare_sheet(const PulseGeometry& geometry, std::size_t number, const std::vector<std::size_t>& points) {
    const radar::Pointing pointing = geometry.pointing();
    const ScattererSheet& sheet = scene_.sheets[number];
    const radar::SampleGrid& grid = acquisition_.reception.raw_grid;
    sheets_[number].begin();
    for (const std::size_t point : points) {
      const auto view = geometry.sheet_view(number, point, pointing);
      if (!view || view->delay_s + acquisition_.reception.pulse.last_s() < grid.first_s ||
          view->delay_s + acquisition_.reception.pulse.first_s() > grid.time_s(grid.count))
        continue;
      const core::Vec3 look = line_of_sight_m(geometry, sheet.platform, sheet.points_m[point]);
      tables_.beyond(offset_of(pointing, look), std::nullopt, 0, beyond_deg_);
      sheets_[number].take(point, beyond_deg_);
    }
    sheets_[number].end();
  }

  const Acquisition& acquisition_;
  const ResolvedScene& scene_;
  const AngleTables& tables_;
  const core::WorkControl& control_;
  std::vector<std::size_t> chosen_;
  ReachingPoints targets_;
  std::vector<ReachingPoints> sheets_;
  std::vector<double> beyond_deg_;
};

}  // namespace

TableReach reach_beyond_tables(const Acquisition& acquisition, const EchoSurvey& survey,
                               const std::vector<std::size_t>& examined, const AngleTables& tables,
                               const core::WorkControl& control) {
  ReachComparison reach(acquisition, tables, control);
  reach.compare(survey, examined);
  return {reach.target_sights(), reach.surface_sights()};
}

}  // namespace sarsim::simulate

#include "workflow/focus/navigation_check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::workflow {

namespace {

// How two tracks go, in parts.
struct Ways {
  double recorded_m = 0.0;
  double believed_m = 0.0;
  double cosine = 1.0;  ///< Mean of the cosines between their parts, weighted by both lengths.
};

Ways ways_of(std::span<const signal::TrackPoint> recorded, std::span<const signal::TrackPoint> believed) {
  constexpr std::size_t parts = 64;
  const std::size_t last = recorded.size() - 1;
  const std::size_t count = std::min(parts, last);
  Ways ways;
  double products = 0.0, lengths = 0.0;
  for (std::size_t part = 0; part < count; ++part) {
    const std::size_t from = last * part / count;
    const std::size_t to = last * (part + 1) / count;
    const core::Vec3 a = recorded[to].position_m - recorded[from].position_m;
    const core::Vec3 b = believed[to].position_m - believed[from].position_m;
    ways.recorded_m += core::norm(a);
    ways.believed_m += core::norm(b);
    products += core::dot(a, b);
    lengths += core::norm(a) * core::norm(b);
  }
  if (lengths > 0.0) ways.cosine = products / lengths;
  return ways;
}

struct Farthest {
  double distance_m = 0.0;
  double time_s = 0.0;
};

Farthest farthest_of(std::span<const signal::TrackPoint> recorded, std::span<const signal::TrackPoint> believed) {
  Farthest farthest;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const double distance_m = core::norm(believed[i].position_m - recorded[i].position_m);
    if (!(distance_m <= farthest.distance_m)) farthest = {distance_m, recorded[i].time_s};
  }
  return farthest;
}

core::ProblemBuilder navigation_problem(bool error, const std::string& name, const char* what) {
  return core::ProblemBuilder(error ? core::Severity::error : core::Severity::warning, "navigation.not-of-recording",
                              fmt::format("{}: {}", name, what))
      .hint("is it of this recording, in the axes of its world, with its time 0, in metres?");
}

}  // namespace

core::Problems problems_of_navigation(const std::string& name, std::span<const signal::TrackPoint> recorded,
                                      std::span<const signal::TrackPoint> believed, double farthest_m) {
  CORE_EXPECT(recorded.size() == believed.size() && !recorded.empty());
  constexpr double tolerated = 0.01;
  constexpr double tolerated_rad = core::rad_per_deg;
  constexpr double min_way_m = 1.0;
  core::Problems problems;
  const Farthest far = farthest_of(recorded, believed);
  if (!(far.distance_m <= tolerated * farthest_m))
    problems.push_back(
        navigation_problem(!(far.distance_m <= farthest_m), name,
                           "the navigation is far from the track of the recording")
            .found(fmt::format("{:.6g} m away at {:.6g} s", far.distance_m, far.time_s))
            .expected(fmt::format("up to {:.4g} m, a hundredth of the farthest range", tolerated * farthest_m)));
  const Ways ways = ways_of(recorded, believed);
  if (core::has_errors(problems) || !(ways.recorded_m > min_way_m)) return problems;
  const double ratio = ways.believed_m / ways.recorded_m;
  if (!(std::abs(ratio - 1.0) <= tolerated))
    problems.push_back(navigation_problem(!(ratio > 0.5 && ratio < 2.0), name,
                                          "the navigation track has another length than that of the recording")
                           .found(fmt::format("{:.6g} m long", ways.believed_m))
                           .expected(fmt::format("{:.6g} m within 1 %", ways.recorded_m)));
  const double angle_rad = std::acos(std::clamp(ways.cosine, -1.0, 1.0));
  if (angle_rad > tolerated_rad && ways.believed_m > 0.0)
    problems.push_back(
        navigation_problem(ways.cosine < 0.0, name, "the navigation flies in another direction than the recording")
            .found(fmt::format("{:.3g} deg off on the average", angle_rad * core::deg_per_rad))
            .expected("within 1 deg"));
  return problems;
}

}  // namespace sarsim::workflow

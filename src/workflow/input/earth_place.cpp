#include "workflow/input/earth_place.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/separated.hpp"
#include "radar/earth/earth_depth.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::workflow {

namespace {

[[noreturn]] void refuse_place(std::string message, std::string found) {
  throw core::InvalidRequest(
      {core::error(std::move(message))
           .found(std::move(found))
           .expected(fmt::format("at most {:g} m below the ellipsoid, up to {:g} m from the centre",
                                 -radar::deepest_place_m, radar::farthest_place_m))
           .hint("heights count in m, positive upwards")});
}

[[noreturn]] void refuse_deep(const std::string& what, double depth_m) {
  refuse_place(what + " lies inside the Earth", fmt::format("{:.6g} m below the ellipsoid", depth_m));
}

// A place from a command line or from a file of ours.
radar::Anchor possible(const radar::Anchor& anchor, const std::string& what) {
  // Beyond the centre the depth of the position would be that from the other side.
  if (anchor.origin.height_m < radar::deepest_place_m) refuse_deep(what, -anchor.origin.height_m);
  expect_possible_place(radar::ecef_of(anchor.origin), what);
  return anchor;
}

}  // namespace

radar::Anchor anchor_from_text(const std::string& text, const std::string& option) {
  const std::vector<double> numbers = core::numbers_between_commas(text).value_or(std::vector<double>());
  if (numbers.size() < 3 || numbers.size() > 4 || std::abs(numbers[0]) > 90.0 || std::abs(numbers[1]) > 360.0)
    throw core::InvalidRequest(fmt::format("{}: '{}' is not a place", option, text),
                               "give LATITUDE,LONGITUDE,HEIGHT[,HEADING] in degrees and metres, as -33.9,18.4,120");
  return possible({{core::rad_per_deg * numbers[0], core::rad_per_deg * numbers[1], numbers[2]},
                   numbers.size() == 4 ? core::rad_per_deg * numbers[3] : 0.0},
                  fmt::format("{} {}", option, text));
}

void expect_possible_place(const core::Vec3& ecef_m, const std::string& what) {
  if (const auto depth_m = radar::impossible_depth_m(ecef_m)) refuse_deep(what, *depth_m);
  if (const double distance_m = core::norm(ecef_m); !(distance_m <= radar::farthest_place_m))
    refuse_place(what + " is far from the Earth", fmt::format("{:.6g} m from its centre", distance_m));
}

std::string anchor_text(const radar::Anchor& anchor) {
  return fmt::format("{},{},{},{}", core::deg_per_rad * anchor.origin.latitude_rad,
                     core::deg_per_rad * anchor.origin.longitude_rad, anchor.origin.height_m,
                     core::deg_per_rad * anchor.heading_rad);
}

EarthPlace earth_place(const scene::World& world, const std::optional<radar::Anchor>& anchor,
                       const std::string& format) {
  auto earth = scene::earth_of(world);
  if (earth && anchor)
    throw core::InvalidRequest("--anchor: the scene says itself where on the Earth it is", "leave out --anchor");
  if (!earth && !anchor)
    throw core::InvalidRequest(
        fmt::format("{} has places on the Earth, but the world of the scene is flat", format),
        "give --anchor LATITUDE,LONGITUDE,HEIGHT[,HEADING] of its origin, or make its world the Earth "
        "([world] frame = \"earth\")");
  if (!earth) earth.emplace(*anchor);
  const radar::InstantReading epoch = scene::epoch_of(world);
  if (epoch.instant) return {*earth, *epoch.instant, {}};
  return {*earth,
          *radar::parse_instant(assumed_epoch, radar::TimeScale::utc).instant,
          {core::note("epoch.assumed",
                      fmt::format("the scene has no epoch: {} is dated {} at time 0", format, assumed_epoch))
               .hint("say it in the scene, as [world] epoch = \"2024-04-01T22:59:42Z\"")}};
}

}  // namespace sarsim::workflow

#include "workflow/input/earth_place.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/report/refused.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::workflow {

radar::Anchor anchor_from_text(const std::string& text, const std::string& option) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = core::parse_number(core::trimmed(std::string_view(text).substr(begin, end - begin)));
    if (!number) break;
    numbers.push_back(*number);
    begin = end + 1;
    if (end == text.size()) {
      if (numbers.size() < 3 || numbers.size() > 4) break;
      if (std::abs(numbers[0]) > 90.0 || std::abs(numbers[1]) > 360.0) break;
      return {{core::rad_per_deg * numbers[0], core::rad_per_deg * numbers[1], numbers[2]},
              numbers.size() == 4 ? core::rad_per_deg * numbers[3] : 0.0};
    }
  }
  throw core::Refused(fmt::format("{}: '{}' is not a place", option, text),
                      "give LATITUDE,LONGITUDE,HEIGHT[,HEADING] in degrees and metres, as -33.9,18.4,120");
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
    throw core::Refused("--anchor: the scene says itself where on the Earth it is", "leave out --anchor");
  if (!earth && !anchor)
    throw core::Refused(fmt::format("{} has places on the Earth, but the world of the scene is flat", format),
                        "give --anchor LATITUDE,LONGITUDE,HEIGHT[,HEADING] of its origin, or make its world the Earth "
                        "([world] frame = \"earth\")");
  if (!earth) earth.emplace(*anchor);
  const radar::InstantReading epoch = scene::epoch_of(world);
  if (epoch.instant) return {*earth, *epoch.instant, {}};
  return {*earth,
          *radar::parse_instant(assumed_epoch, radar::TimeScale::utc).instant,
          {core::problem_of(core::Severity::note,
                            fmt::format("the scene has no epoch: {} is dated {} at time 0", format, assumed_epoch), {},
                            {}, "say it in the scene, as [world] epoch = \"2024-04-01T22:59:42Z\"")}};
}

}  // namespace sarsim::workflow

#include "workflow/focus/air_remarks.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "workflow/focus/sar_rows.hpp"

namespace sarsim::workflow {

core::Problems diagnose_air(const simulate::Acquisition& acquisition) {
  if (acquisition.link.air == nullptr) return {};
  simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
  geometry.set_pulse(acquisition.timing.pulses.first + acquisition.timing.pulses.count() / 2);
  const core::Vec3 radar_m = geometry.radar_pose().position_world_m;
  const core::Vec3 middle_m = scene_middle_m(acquisition);
  const radar::PathEffect one_way = acquisition.link.air->one_way(radar_m, middle_m);
  if (one_way.delay_m == 0.0 && one_way.phase_m == 0.0) return {};
  const double range_m = core::norm(middle_m - radar_m);
  std::string found = fmt::format("{:.3g} m of excess path, one way, at a range of {}", one_way.delay_m,
                                  core::with_prefix(range_m, "m", 6));
  if (one_way.phase_m != one_way.delay_m) found += fmt::format("; {:.3g} m for the phase", one_way.phase_m);
  return {core::note("focus.air-not-corrected", "focusing does not correct the atmospheric delay")
              .found(std::move(found))
              .hint(fmt::format("the range error of targets is about {:.3g} m", one_way.delay_m))};
}

}  // namespace sarsim::workflow

#include "workflow/verify/groups.hpp"

#include "workflow/verify/thesis_numbers.hpp"

namespace sarsim::workflow::verify {

Record verify_all(const Rules& rules) {
  Record record(rules);
  record.group("Closed forms", measure_closed_forms);
  record.group("Geometry", measure_geometry);
  record.group("Light time", measure_light_time);
  record.group("Beams and targets", measure_beams_and_targets);
  record.group("Band-limited pulses", measure_band_limit);
  record.group("Numbers of the thesis", measure_thesis);
  record.group("Engines", measure_engines);
  record.group("Statistics", measure_statistics);
  record.group("Focusing", measure_focusing);
  record.group("Detection and profiles", [](Record& part) {
    measure_detection(part);
    measure_stepped(part);
  });
  if (!rules.quick) record.group("Speed", measure_speed);
  return record;
}

void measure_thesis(Record& record) {
  for (const ThesisNumber& number : thesis_numbers())
    for (const scene::Profile profile : {scene::Profile::classic, scene::Profile::physical}) {
      const bool classic = profile == scene::Profile::classic;
      record.near(number.what + (classic ? ", classic" : ", physical"), number.unit,
                  classic ? number.classic : number.physical, number.value(profile), number.tolerance,
                  "docs/theory/thesis-numbers.md");
    }
}

}  // namespace sarsim::workflow::verify

#include "workflow/focus/measure_options.hpp"

#include <limits>

#include "core/report/invalid_request.hpp"
#include "workflow/input/recording_options.hpp"

namespace sarsim::workflow {

OptionTable<MeasureRequest> measure_option_table() {
  OptionTable<MeasureRequest> table;
  table.include(script_options(), &MeasureRequest::input);
  table.number(
      "--search", "M",
      "search radius around a target's expected position (default: 3 cells, or half the distance to the next target)",
      &MeasureRequest::search_m);
  table.number("--pfa", "P", "false-alarm probability that sets the detection threshold (default: 1e-3)",
               &MeasureRequest::false_alarm);
  table.whole("--target", 1, std::numeric_limits<std::int64_t>::max(), "one target only, by its number in the script",
              [](MeasureRequest& request, std::uint64_t n) { request.target = static_cast<std::size_t>(n); });
  table.whole("--threads", 0, 4096, "threads; 0 for one per core (default)", &MeasureRequest::threads);
  return table;
}

MeasureRequest measure_request(const std::string& image, const GivenWords& given) {
  MeasureRequest request;
  request.image = image;
  const TakenProblems problems = measure_option_table().take_words(given, request);
  if (!problems.empty()) throw core::InvalidRequest(core::Problems{problems.early.front()});
  return request;
}

}  // namespace sarsim::workflow

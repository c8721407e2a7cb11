#include "workflow/search/pulse_request.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::int64_t max_cells = 100000;
constexpr double usual_false_alarm = 1e-6;
constexpr double usual_rank = 0.75;

// A target fills the samples of its range cell: those must not count as noise.
std::size_t usual_guard(const simulate::Acquisition& acquisition) {
  const double samples =
      1.0 / (radar::bandwidth_hz(acquisition.link.pulse) * acquisition.reception.raw_grid.interval_s);
  return std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(2.0 * samples - 1e-9)));
}

// What says how to detect means nothing where nothing is detected.
void expect_detector(const PulseRequest& request, core::Problems& problems) {
  if (request.detect) return;
  const std::pair<const char*, bool> given[] = {{"--guard", request.guard.has_value()},
                                                {"--train", request.train.has_value()},
                                                {"--pfa", request.false_alarm.has_value()},
                                                {"--all-cells", request.all_cells},
                                                {"--detections", !request.table.empty()}};
  for (const auto& [option, there] : given)
    if (there)
      problems.push_back(
          core::error(fmt::format("{} means nothing with --cfar none", option)).expected("--cfar ca or os"));
}

signal::CfarOptions detector_asked_for(const PulseRequest& request, const simulate::Acquisition& acquisition) {
  signal::CfarOptions cfar;
  cfar.kind = request.detector;
  cfar.false_alarm = request.false_alarm.value_or(usual_false_alarm);
  cfar.rank_share = request.rank.value_or(usual_rank);
  const CellReach guard = request.guard.value_or(CellReach{usual_guard(acquisition), 0});
  // By default 16 cells to either side beyond the guard.
  const CellReach train = request.train.value_or(CellReach{16, 0});
  cfar.guard_columns = guard.columns;
  cfar.guard_rows = guard.rows;
  cfar.reference_columns = guard.columns + train.columns;
  cfar.reference_rows = train.rows > 0 ? guard.rows + train.rows : 0;
  return cfar;
}

}  // namespace

std::optional<CellReach> cells_from_text(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto columns = core::parse_integer(text.substr(0, colon));
  const auto rows =
      colon == std::string::npos ? std::optional<std::int64_t>(0) : core::parse_integer(text.substr(colon + 1));
  const auto good = [](std::optional<std::int64_t> n) { return n && *n >= 0 && *n <= max_cells; };
  if (!good(columns) || !good(rows)) return std::nullopt;
  return CellReach{static_cast<std::size_t>(*columns), static_cast<std::size_t>(*rows)};
}

core::Problems problems_of_request(const PulseRequest& request) {
  core::Problems problems;
  // The command line lets neither through.
  if (request.pulses == std::size_t{0})
    problems.push_back(core::error("--interval: a coherent interval has no pulses").found("0").expected("1 or more"));
  if (request.canceller > 2)
    problems.push_back(core::error("--canceller: there is none of that order")
                           .found(fmt::format("{}", request.canceller))
                           .expected("0, 1 or 2"));
  const double false_alarm = request.false_alarm.value_or(usual_false_alarm);
  if (!(false_alarm >= 1e-15 && false_alarm <= 0.5))
    problems.push_back(core::error("--pfa: no probability of false alarm for a cell")
                           .found(core::format_number(false_alarm))
                           .expected("1e-15 to 0.5"));
  const double rank = request.rank.value_or(usual_rank);
  if (!(rank > 0.0 && rank <= 1.0))
    problems.push_back(core::error("--rank: not a share of the reference cells")
                           .found(core::format_number(rank))
                           .expected("above 0, at most 1"));
  const bool ordered = request.detect && request.detector == signal::CfarOptions::Kind::ordered_statistic;
  if (request.rank && !ordered)
    problems.push_back(core::error("--rank is for the ordered statistic").expected("--cfar os"));
  expect_detector(request, problems);
  return problems;
}

SearchOptions search_options(const PulseRequest& request, const simulate::Acquisition& acquisition,
                             std::size_t usual_pulses) {
  if (core::Problems problems = problems_of_request(request); !problems.empty())
    throw core::InvalidRequest(std::move(problems));
  SearchOptions options;
  options.pulses = request.pulses.value_or(usual_pulses);
  options.step = request.step;
  options.frequencies = request.frequencies;
  options.canceller = request.canceller;
  options.window = request.window;
  options.detect = request.detect;
  options.cfar = detector_asked_for(request, acquisition);
  options.all_cells = request.all_cells;
  return options;
}

}  // namespace sarsim::workflow

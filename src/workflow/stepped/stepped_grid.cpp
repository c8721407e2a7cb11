#include "workflow/stepped/stepped_grid.hpp"

#include <algorithm>
#include <cmath>

namespace sarsim::workflow {

namespace {

constexpr std::int64_t longest_list = 1 << 15;

// After how many pulses the carriers come back, by the borders of Knuth, Morris and Pratt; 0 for longer lists.
std::size_t period_of(const std::vector<double>& carriers) {
  std::vector<std::size_t> border(carriers.size(), 0);
  for (std::size_t i = 1; i < carriers.size(); ++i) {
    std::size_t length = border[i - 1];
    while (length > 0 && carriers[i] != carriers[length]) length = border[length - 1];
    border[i] = carriers[i] == carriers[length] ? length + 1 : 0;
  }
  const std::size_t period = carriers.size() - border.back();
  return 2 * period <= carriers.size() ? period : 0;
}

// The length of the first run of equal carriers where all runs of a burst are that long; 0 where they differ.
std::size_t run_of(const std::vector<double>& burst) {
  std::size_t run = 1;
  while (run < burst.size() && burst[run] == burst[0]) ++run;
  if (burst.size() % run != 0) return 0;
  for (std::size_t i = 0; i < burst.size(); ++i)
    if (burst[i] != burst[i - i % run]) return 0;
  return run;
}

// Carriers that are all different and evenly spaced, as a grid with one pulse a step.
std::optional<SteppedGrid> grid_of(const std::vector<double>& carriers) {
  std::vector<double> sorted = carriers;
  std::ranges::sort(sorted);
  const auto last = static_cast<double>(sorted.size() - 1);
  const double step_hz = (sorted.back() - sorted.front()) / last;
  const double tolerance_hz = 1e-12 * sorted.back();
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (std::abs(sorted[i] - sorted.front() - static_cast<double>(i) * step_hz) > tolerance_hz) return std::nullopt;
  if (!(step_hz > 2.0 * tolerance_hz)) return std::nullopt;
  SteppedGrid grid{sorted.front(), step_hz, sorted.size(), 1, {}};
  for (const double hz : carriers)
    grid.order.push_back(static_cast<std::size_t>(std::llround((hz - sorted.front()) / step_hz)));
  if (std::ranges::is_sorted(grid.order)) {
    grid.order.clear();
  } else if (std::ranges::is_sorted(grid.order, std::ranges::greater{})) {
    grid.order.clear();
    grid.first_hz = sorted.back();
    grid.step_hz = -step_hz;
  }
  return grid;
}

}  // namespace

std::optional<SteppedGrid> stepped_grid(const radar::CarrierPlan& carrier, std::int64_t pulse) {
  if (carrier.steps() > 1)
    return SteppedGrid{carrier.carrier_hz(0),
                       carrier.step_hz(),
                       static_cast<std::size_t>(carrier.steps()),
                       static_cast<std::size_t>(carrier.pulses_per_step()),
                       {}};
  if (carrier.lowest_hz() == carrier.highest_hz())
    return SteppedGrid{carrier.carrier_hz(pulse), 0.0, 1, static_cast<std::size_t>(carrier.pulses_per_step()), {}};
  std::vector<double> carriers;
  for (std::int64_t n = 0; n < 2 * longest_list; ++n) carriers.push_back(carrier.carrier_hz(n));
  carriers.resize(period_of(carriers));
  const std::size_t run = carriers.empty() ? 0 : run_of(carriers);
  if (run == 0) return std::nullopt;
  std::vector<double> places;
  for (std::size_t i = 0; i < carriers.size(); i += run) places.push_back(carriers[i]);
  auto grid = grid_of(places);
  if (grid) grid->pulses_per_step = run;
  return grid;
}

}  // namespace sarsim::workflow

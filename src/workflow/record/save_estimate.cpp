#include "workflow/record/save_estimate.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "workflow/record/known_machine.hpp"
#include "workflow/record/record_size.hpp"

namespace sarsim::workflow {

double estimated_lsb_v(double largest_v, int bits) {
  constexpr double spare = 1.03;
  if (!(largest_v > 0.0) || !std::isfinite(largest_v)) return 0.0;
  const double steps = bits <= 1 ? 2.0 : std::ldexp(1.0, bits - 1) - 1.0;
  return spare * largest_v / steps;
}

SaveEstimate save_estimate(const simulate::Plan& plan, double file_bytes, double largest_v, unsigned threads,
                           bool counts) {
  const simulate::Cost cost = simulate::estimated_cost(plan, std::max(threads, 1U), known_machine());
  SaveEstimate estimate;
  estimate.rows = static_cast<double>(plan.acquisition.timing.rows);
  estimate.columns = static_cast<double>(plan.acquisition.reception.columns);
  estimate.bytes = file_bytes;
  estimate.memory_bytes = cost.memory_bytes;
  estimate.lsb_estimated = !(plan.acquisition.simulation.lsb_v > 0.0);
  // Counts need the largest magnitude before the first of them is written.
  const double passes = passes_of(plan.acquisition.simulation, counts);
  estimate.seconds = passes * cost.seconds;
  estimate.lsb_v = estimate.lsb_estimated ? estimated_lsb_v(largest_v, plan.acquisition.simulation.bits)
                                          : plan.acquisition.simulation.lsb_v;
  return estimate;
}

std::string text_of(const SaveEstimate& e) {
  std::string lsb = "LSB unknown until it has run";
  if (e.lsb_v > 0.0) lsb = fmt::format("LSB {:.5g} mV{}", 1e3 * e.lsb_v, e.lsb_estimated ? " (estimated)" : "");
  return fmt::format("{} x {} samples, {}, {}, {} of memory; {}", core::format_number(e.rows),
                     core::format_number(e.columns), core::bytes_text(e.bytes), core::about_duration_text(e.seconds),
                     core::bytes_text(e.memory_bytes), lsb);
}

}  // namespace sarsim::workflow

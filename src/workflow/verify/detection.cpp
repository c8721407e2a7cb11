#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "signal/search/cfar.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/moments.hpp"

namespace sarsim::workflow::verify {

namespace {

signal::CfarOptions detector(signal::CfarOptions::Kind kind, double false_alarm) {
  signal::CfarOptions options;
  options.kind = kind;
  options.false_alarm = false_alarm;
  options.reference_columns = 9;
  options.guard_columns = 1;
  return options;  // 16 reference cells, or fewer at the edges.
}

// Threshold over noise where all reference cells hold 1.
double factor_of(const signal::CfarOptions& options, const core::WorkControl& control) {
  std::vector<float> power(41, 1.0F);
  power[20] = 1e9F;
  for (const auto& found : signal::detect_cfar(power, power.size(), options, control))
    if (found.column == 20) return found.threshold;
  return 0.0;
}

// A draw from the exponential distribution of mean 1, by Marsaglia's xorshift.
float exponential(std::uint64_t& state) {
  state ^= state << 13U;
  state ^= state >> 7U;
  state ^= state << 17U;
  return static_cast<float>(-std::log((static_cast<double>(state >> 11U) + 0.5) / 9007199254740992.0));
}

// False alarms in rows of independent noise over those asked for, with five standard deviations of the rows' mean.
void measure_false_alarms(Record& record, const signal::CfarOptions& options, const std::string& name,
                          const core::WorkControl& control) {
  constexpr std::size_t columns = 500;
  const std::size_t rows = record.quick() ? 100 : 1000;
  std::uint64_t state = 88172645463325252ULL;
  std::vector<float> power(rows * columns);
  for (float& p : power) p = exponential(state);
  std::vector<double> alarms(rows, 0.0);
  for (const auto& found : signal::detect_cfar(power, columns, options, control)) alarms[found.row] += 1.0;
  const double asked = options.false_alarm * static_cast<double>(columns);
  const double average = mean(alarms);
  record.near(name + ": false alarms over those asked for", "", 1.0, average / asked,
              mean_gate(std::sqrt(mean_square(alarms, average)), rows) / asked,
              "independent cells; five standard deviations");
}

}  // namespace

void measure_detection(Record& record) {
  using Kind = signal::CfarOptions::Kind;
  const core::WorkControl control{1, record.rules().stop};
  constexpr double cells = 16.0;
  constexpr double false_alarm = 1e-4;
  const auto averaging = detector(Kind::cell_averaging, false_alarm);
  const double factor = cells * (std::pow(false_alarm, -1.0 / cells) - 1.0);
  record.near("Factor of a cell-averaging detector, 16 cells, 1e-4", "", factor, factor_of(averaging, control),
              1e-6 * factor, "N (P^(-1/N) - 1), Finn and Johnson 1968");
  const auto ordered = detector(Kind::ordered_statistic, false_alarm);
  const double ordered_factor = factor_of(ordered, control);
  double probability = 1.0;
  for (int i = 0; i < 12; ++i) probability *= (cells - i) / (cells - i + ordered_factor);
  record.near("False alarms at the factor of an ordered-statistic detector over 1e-4", "", 1.0,
              probability / false_alarm, 1e-4, "product of (N - i)/(N - i + factor), Rohling 1983");
  measure_false_alarms(record, detector(Kind::cell_averaging, 0.01), "Cell averaging", control);
  measure_false_alarms(record, detector(Kind::ordered_statistic, 0.01), "Ordered statistic", control);
}

}  // namespace sarsim::workflow::verify

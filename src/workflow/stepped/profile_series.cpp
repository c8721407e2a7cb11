#include "workflow/stepped/profile_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radar/path/path.hpp"
#include "signal/sar/work_matrix.hpp"

namespace sarsim::workflow {

namespace {

// The whole scan is not needed for its speed: so many of its middle bursts are.
constexpr std::size_t max_searched = 64;

std::vector<double> times_of(const SteppedRows& rows, std::size_t burst) {
  const std::size_t pulses = rows.band->waveform().burst_pulses();
  std::vector<double> times;
  times.reserve(pulses);
  for (std::size_t p = 0; p < pulses; ++p) times.push_back(rows.pulse_time_s(burst * pulses + p));
  return times;
}

double middle_of_scan(const ScanRecord& scan) { return 0.5 * (scan.from_s + scan.to_s); }

ScanRecord record_of(const SteppedRows& rows, const signal::ProfileSet& bursts) {
  ScanRecord scan;
  scan.bursts = bursts;
  scan.from_s = times_of(rows, bursts.first).front();
  scan.to_s = times_of(rows, bursts.last).back();
  return scan;
}

signal::VelocityEstimate search_speed(const SteppedRows& rows, const signal::ProfileMaker& maker,
                                      const signal::ProfileSet& bursts, double fastest_mps,
                                      const core::WorkControl& control) {
  const std::size_t count = std::min(bursts.count(), max_searched);
  const std::size_t first = bursts.first + (bursts.count() - count) / 2;
  return signal::estimate_velocity(maker, read_bursts(rows, first, count, control), -fastest_mps, fastest_mps, control);
}

void find_speed(ScanRecord& scan, const SteppedRows& rows, const signal::ProfileMaker& maker,
                const SeriesOptions& options, const core::WorkControl& control) {
  switch (options.velocity) {
    case SeriesOptions::Velocity::none: return;
    case SeriesOptions::Velocity::given: scan.speed_mps = options.speed_mps; return;
    case SeriesOptions::Velocity::scene:
      scan.speed_mps = mean_speed_mps(rows, scan.bursts.first, scan.bursts.count());
      return;
    case SeriesOptions::Velocity::estimated:
      scan.estimate = search_speed(rows, maker, scan.bursts, options.fastest_mps, control);
      scan.speed_mps = scan.estimate->speed_mps;
      return;
  }
}

std::vector<signal::PulseMotion> motion_of(const SteppedRows& rows, const ScanRecord& scan,
                                           const SeriesOptions& options, std::size_t burst) {
  if (options.velocity == SeriesOptions::Velocity::none) return {};
  const std::vector<double> times = times_of(rows, burst);
  const double at_s = options.align ? middle_of_scan(scan) : signal::middle_of(times);
  return signal::motion_of_speed(times, at_s, scan.speed_mps, rows.band->waveform().light_speed_mps);
}

void add_rows(ProfileSeries& series, const SteppedRows& rows) {
  for (std::size_t s = 0; s < series.scans.size(); ++s)
    for (std::size_t b = series.scans[s].bursts.first; b <= series.scans[s].bursts.last; ++b)
      series.rows.push_back({b, s, signal::middle_of(times_of(rows, b))});
}

// One row, its profile alone: of the rows first ... last of a series.
void append_mean(ProfileSeries& means, const ProfileSeries& series, std::size_t first, std::size_t last,
                 std::size_t scan) {
  const std::size_t bins = series.axis.count;
  const auto profile =
      signal::mean_profile(std::span(series.values).subspan(first * bins, (last - first + 1) * bins), bins);
  means.values.insert(means.values.end(), profile.begin(), profile.end());
  means.rows.push_back({series.rows[first].burst, scan, 0.5 * (series.rows[first].time_s + series.rows[last].time_s)});
}

ProfileSeries without_rows(const ProfileSeries& series) {
  ProfileSeries empty;
  empty.axis = series.axis;
  empty.limits = series.limits;
  empty.centre_hz = series.centre_hz;
  empty.band_hz = series.band_hz;
  empty.scans = series.scans;
  return empty;
}

double energy_of(std::span<const std::complex<double>> profile) {
  double energy = 0.0;
  for (const auto& value : profile) energy += std::norm(value);
  return energy;
}

double distance_to_next(const std::vector<HeldTarget>& targets, std::size_t index) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (i != index) nearest_m = std::min(nearest_m, std::abs(targets[i].expected_m - targets[index].expected_m));
  return nearest_m;
}

// Half way to the nearest other target, from 3/4 of a cell to two cells and what the peak may be smeared over.
double search_around(const HeldTarget& target, double cell_m) {
  const double nearest_m = std::min(target.nearest_m, 2.0 * cell_m * (2.0 + target.smear_cells));
  return std::max(0.75 * cell_m, 0.5 * nearest_m);
}

}  // namespace

RangeResampling shown_ranges(const SteppedRows& rows) {
  const signal::SeenDelays seen = rows.band->seen_delays();
  const signal::SteppedWaveform& w = rows.band->waveform();
  const double c = w.light_speed_mps;
  const double rounding_m = radar::range_of_cycle(w.sample_rate_hz, 1e-6 * c);
  RangeResampling shown{radar::range_of(seen.first_s, c), radar::range_of(seen.last_s, c)};
  if (shown.from_m < rows.from_m + rounding_m) shown.from_m = rows.from_m;
  if (shown.to_m > rows.to_m - rounding_m) shown.to_m = rows.to_m;
  return shown;
}

ProfileSeries make_profiles(const SteppedRows& rows, const SeriesOptions& options, const core::WorkControl& control,
                            const core::ProgressReport& progress) {
  const RangeResampling shown = shown_ranges(rows);
  const signal::ProfileMaker maker(*rows.band, options.window, options.from_m.value_or(shown.from_m),
                                   options.to_m.value_or(shown.to_m), options.oversampling);
  ProfileSeries series;
  series.axis = maker.axis();
  series.limits = signal::limits_of(*rows.band, rows.acquisition->link.repetition.mean_interval_s());
  series.centre_hz = rows.band->centre_hz();
  series.band_hz = rows.band->band_hz();
  for (const signal::ProfileSet& bursts : signal::scans_of(illumination_of(rows, control), options.illuminated_share)) {
    series.scans.push_back(record_of(rows, bursts));
    find_speed(series.scans.back(), rows, maker, options, control);
  }
  add_rows(series, rows);
  series.values.resize(series.rows.size() * series.axis.count);
  signal::WorkCounter counter(progress, series.values.size(), series.axis.count);
  core::parallel_ranges(series.rows.size(), 1, control, [&](std::size_t i, std::size_t) {
    const ProfileRow& row = series.rows[i];
    const signal::BurstEchoes echoes = read_bursts(rows, row.burst, 1, {1, control.stop});
    maker.make(echoes.values, motion_of(rows, series.scans[row.scan], options, row.burst),
               std::span(series.values).subspan(i * series.axis.count, series.axis.count));
    counter.add(series.axis.count);
  });
  return series;
}

ProfileSeries mean_of_scans(const ProfileSeries& series) {
  ProfileSeries means = without_rows(series);
  for (std::size_t first = 0; first < series.rows.size();) {
    std::size_t last = first;
    while (last + 1 < series.rows.size() && series.rows[last + 1].scan == series.rows[first].scan) ++last;
    append_mean(means, series, first, last, series.rows[first].scan);
    first = last + 1;
  }
  return means;
}

ProfileSeries mean_of_encounter(const ProfileSeries& series) {
  const ProfileSeries scans = mean_of_scans(series);
  ProfileSeries mean = without_rows(series);
  if (scans.rows.empty()) return mean;
  std::size_t strongest = 0;
  for (std::size_t i = 1; i < scans.rows.size(); ++i)
    if (energy_of(scans.row(i)) > energy_of(scans.row(strongest))) strongest = i;
  const auto bins = static_cast<std::ptrdiff_t>(series.axis.count);
  std::vector<double> power(series.axis.count);
  for (std::size_t i = 0; i < scans.rows.size(); ++i) {
    const std::ptrdiff_t shift = signal::shift_onto(scans.row(i), scans.row(strongest));
    const auto bursts = static_cast<double>(series.scans[scans.rows[i].scan].bursts.count());
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, -shift); k < bins - std::max<std::ptrdiff_t>(0, shift); ++k)
      power[static_cast<std::size_t>(k + shift)] += bursts * std::norm(scans.row(i)[static_cast<std::size_t>(k)]);
  }
  for (const double p : power) mean.values.emplace_back(std::sqrt(p / static_cast<double>(series.rows.size())));
  mean.rows.push_back(scans.rows[strongest]);
  return mean;
}

std::vector<HeldTarget> hold_against_scene(const SteppedRows& rows, const ProfileSeries& series,
                                           const SeriesOptions& options, std::size_t row) {
  const ProfileRow& profile = series.rows[row];
  const ScanRecord& scan = series.scans[profile.scan];
  const double moved_m = options.align ? scan.speed_mps * (middle_of_scan(scan) - profile.time_s) : 0.0;
  std::vector<HeldTarget> targets;
  for (const BurstTruth& truth : truth_of_burst(rows, profile.burst)) {
    if (!(truth.amplitude > 0.0)) continue;
    if (targets.size() == max_held_targets) break;
    HeldTarget target;
    target.truth = truth;
    const double left_mps = truth.speed_mps - scan.speed_mps;
    target.expected_m = truth.range_m + moved_m + series.limits.shift_m(left_mps);
    target.expected_bin = series.axis.index_of(target.expected_m);
    target.outside =
        !(target.expected_bin >= -0.5 && target.expected_bin < static_cast<double>(series.axis.count) - 0.5);
    target.smear_cells = series.limits.smear_cells(left_mps);
    targets.push_back(target);
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets[i].nearest_m = distance_to_next(targets, i);
    // Beside the profile there are only the sidelobes of others.
    if (targets[i].outside) continue;
    targets[i].found = signal::peak_near(series.row(row), series.axis, targets[i].expected_m,
                                         search_around(targets[i], series.limits.resolution_m));
  }
  return targets;
}

std::size_t typical_row(const ProfileSeries& series) {
  double strongest = -1.0;
  std::size_t typical = 0;
  for (std::size_t s = 0; s < series.scans.size(); ++s) {
    const signal::ProfileSet& bursts = series.scans[s].bursts;
    for (std::size_t i = 0; i < series.rows.size(); ++i) {
      if (series.rows[i].scan != s || series.rows[i].burst != bursts.first + bursts.count() / 2) continue;
      if (!(energy_of(series.row(i)) > strongest)) continue;
      strongest = energy_of(series.row(i));
      typical = i;
    }
  }
  return typical;
}

}  // namespace sarsim::workflow

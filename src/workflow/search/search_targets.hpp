#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "simulate/plan/pulse_geometry.hpp"
#include "workflow/focus/matched_filter_coverage.hpp"
#include "workflow/search/search_intervals.hpp"

namespace sarsim::workflow {

/// A target as an interval should see it.
struct TargetVisibility {
  std::size_t interval = 0;
  double time_s = 0.0;
  double azimuth_rad = 0.0;      ///< Of the target, seen from the radar: from +y clockwise.
  double range_m = 0.0;          ///< Where its compressed echo lies, range-Doppler coupling included.
  double doppler_hz = 0.0;       ///< True one, positive approaching.
  double seen_doppler_hz = 0.0;  ///< Within half the PRF.
  std::size_t row = 0;           ///< Cell of the map, the strongest no more than PRF/pulses away.
  std::size_t column = 0;
  bool in_window = false;  ///< Its cell is among those recorded.
  /// In the map, at the middle of a range cell; Doppler between the cells taken off. Of the pulses one by one: what a
  /// turning beam changes from pulse to pulse passes a canceller. With the receiver's gain over time (STC); of echoes
  /// that the end of a raw recording cuts, what there is of them.
  double amplitude_v = 0.0;
  double snr = 0.0;  ///< Power over that of the receiver's noise there; infinite without noise.
};

/// What became of a target.
struct TargetFinding {
  std::size_t target = 0;             ///< Position in the scene's list, from 0.
  TargetVisibility sight{};           ///< Of the interval that sees it strongest.
  std::optional<double> probability;  ///< Of detection there, of a steady target; nothing without noise or detector.
  std::size_t expected = 0;           ///< Intervals in which that is at least 1/2.
  std::size_t found = 0;              ///< Intervals with a detection at its cell.
  std::optional<SearchDetection> best{};  ///< The strongest of them.
  double best_range_error_m = 0.0;        ///< Of it, from where the target was in its interval.
};

/// Holds detections against the targets of the script, interval by interval. Of many targets the first 1000 are looked
/// at.
class SearchTargets {
 public:
  static constexpr std::size_t most = 1000;

  /// Keeps references.
  SearchTargets(const PulseRows& rows, const SearchOptions& options);

  /// @return  for each detection of the interval the target it is of: the nearest of those whose cell is no farther
  ///          than 1.5 cells away, a cell being what the waveform resolves or, where that is more, a sample; or
  ///          nothing. Only illuminated targets are taken: in azimuth off the middle direction of the beam by at most
  ///          middle direction than half the sector that it sweeps and half its width; and only where the detection
  ///          is as strong as their echoes, in that direction and at that time, can be: not the antenna's side lobe of
  ///          a stronger one
  std::vector<std::optional<std::size_t>> take(const SearchInterval& interval);

  /// What became of the targets in the intervals that were taken, in the order of the script.
  [[nodiscard]] std::vector<TargetFinding> findings() const;

 private:
  [[nodiscard]] std::vector<TargetVisibility> sights(const SearchInterval& interval);
  void look(const SearchInterval& interval, std::size_t first, std::span<TargetVisibility> sights);
  void place(const SearchInterval& interval, std::span<const double> amplitudes_v, TargetVisibility& sight);
  void take_pulses(std::span<const double> amplitudes_v, double doppler_hz);
  void take_strongest_row(const SearchInterval& interval, TargetVisibility& sight) const;
  [[nodiscard]] double response(double doppler_hz, double cell_hz) const;
  [[nodiscard]] bool beside_beam(const SearchInterval& interval, const TargetVisibility& sight) const;
  // Amplitudes of the targets near a detection.
  struct Strengths {
    double sum_v = 0.0;
    double largest_v = 0.0;
  };
  [[nodiscard]] Strengths strengths_at(const SearchDetection& detection,
                                       const std::vector<TargetVisibility>& seen) const;
  [[nodiscard]] bool fits(const SearchDetection& detection, const TargetVisibility& sight,
                          const Strengths& there) const;
  [[nodiscard]] double distance(const SearchDetection& detection, const TargetVisibility& sight) const;

  const PulseRows& rows_;
  const SearchOptions& options_;
  simulate::PulseGeometry geometry_;
  MatchedFilterCoverage gain_;
  std::vector<double> weights_;
  std::vector<double> differences_;             // of the canceller
  std::vector<double> amplitudes_v_;            // of some targets, each in all looks
  std::vector<std::complex<double>> pulses_v_;  // of one target, cancelled, its Doppler frequency taken off
  std::size_t look_pulses_;                     // the same for as many pulses
  std::size_t looks_;                           // of an interval
  std::vector<double> noise_w_;                 // of each row of a map
  double prf_hz_;
  double cell_m_;
  std::optional<double> half_beam_rad_;  // nothing: the beam sees all directions
  double certain_snr_ = 0.0;  // Ratio at which a target is as often found as not; 0 where that means nothing.
  std::vector<TargetFinding> targets_;
};

/// Probability of detecting a steady target of that ratio in a cell in the middle of a map; correlated reference cells
/// count as the number of independent ones that gives the same factor, interpolated between whole numbers, and of the
/// ordered statistic no more than 4096, whose probability is that of more to 0.003.
[[nodiscard]] double steady_probability(const signal::CfarOptions& cfar, std::size_t rows, std::size_t columns,
                                        double snr);

/// Power of white noise of power 1 in each row of a map of so many Doppler frequencies, 0 in the middle: the sum of the
/// squares of what every pulse is multiplied with, by the canceller's differences d and the weights w, turned:
/// sum over k and l of d[k] d[l] cos(2 pi f (l - k)) sum over n of w[n] w[n + |l - k|], f in cycles per pulse.
/// @param canceller  pulses that the canceller takes besides the newest, 0 ... 2
[[nodiscard]] std::vector<double> noise_gains(const std::vector<double>& weights, std::size_t canceller,
                                              std::size_t rows);

}  // namespace sarsim::workflow

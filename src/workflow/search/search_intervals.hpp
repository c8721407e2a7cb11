#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/maths/vector.hpp"
#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "signal/sar/sar_window.hpp"
#include "signal/search/cfar.hpp"
#include "signal/search/range_doppler_map.hpp"
#include "workflow/search/pulse_rows.hpp"

/// Pulses to range-Doppler maps and detections, one coherent interval after the other
/// (docs/theory/search-and-doppler.md).
namespace sarsim::workflow {

/// How pulses are worked on. An interval of one pulse is a line of ranges without Doppler.
struct SearchOptions {
  std::size_t canceller = 0;    ///< Order: 1 for two pulses, 2 for three; 0 for none.
  std::size_t pulses = 1;       ///< Of an interval, after the canceller, which takes `canceller` more.
  std::size_t step = 0;         ///< From one interval to the next; 0: the length of one.
  std::size_t frequencies = 0;  ///< Doppler rows of a map; 0: as many as pulses.
  signal::SarWindow window{};   ///< Over the pulses.
  bool detect = true;
  signal::CfarOptions cfar{};
  bool detector_known = false;  ///< `cfar` is what `detector_of` made of it.
  bool all_cells = false;       ///< Report every cell above its threshold, not only the largest of its neighbours.

  [[nodiscard]] std::size_t step_pulses() const { return step > 0 ? step : pulses; }
  [[nodiscard]] std::size_t rows() const { return frequencies > 0 ? frequencies : pulses; }
  [[nodiscard]] std::size_t recorded_pulses() const { return pulses + canceller; }
};

/// Speed at which a Doppler frequency, positive approaching, is left behind: -wavelength/2 times it.
/// @param pulse  number in the radar's schedule, whose carrier counts
[[nodiscard]] double receding_speed_mps(const simulate::Acquisition& acquisition, std::int64_t pulse,
                                        double doppler_hz);

/// Whole intervals in a train of so many pulses.
[[nodiscard]] std::size_t interval_count(const SearchOptions& options, std::size_t pulses);

/// The interval as range_doppler_maps takes it.
[[nodiscard]] signal::CoherentInterval coherent_interval(const SearchOptions& options);

/// The detector for maps of those pulses: `options.cfar` with the independence of its reference cells and the
/// calibration of its factors. Samples of range are correlated by the matched filter, Doppler rows, where the reference
/// has more than one, by window and zeros.
[[nodiscard]] signal::CfarOptions detector_of(const PulseRows& rows, const SearchOptions& options);

/// Something that stands out of the noise.
struct SearchDetection {
  std::size_t interval = 0;
  std::size_t row = 0;  ///< Cell of the map.
  std::size_t column = 0;
  double time_s = 0.0;       ///< Middle of the interval.
  double azimuth_rad = 0.0;  ///< Of the beam then, in the world: from +y clockwise.
  double range_m = 0.0;      ///< One way, between the cells.
  double doppler_hz = 0.0;   ///< Between the cells, positive approaching, within half the PRF; 0 of single pulses.
  double speed_mps = 0.0;    ///< Receding speed that means.
  double magnitude_v = 0.0;  ///< Of the cell.
  double snr = 0.0;          ///< Power of the cell over that of the noise around it; infinite where there is none.
  double threshold_v = 0.0;  ///< Magnitude that the cell had to exceed.
};

/// One interval, worked out.
struct SearchInterval {
  std::size_t number = 0;
  std::size_t first_pulse = 0;   ///< Of the recording, from 0.
  double time_s = 0.0;           ///< Middle of the first and the last pulse, those of the canceller included.
  core::Vec3 radar_world_m;      ///< In the middle.
  core::Vec3 beam_world;         ///< Direction of the beam's axis in the middle.
  double half_sector_rad = 0.0;  ///< Largest azimuth of the axis from there between first and last pulse.
  signal::RangeDopplerMap map;   ///< Of cancelled pulses where there is a canceller.
  std::vector<SearchDetection> detections;
};

/// Works out all whole intervals and hands them over in order, on the calling thread. Holds in memory the pulses and
/// maps of one interval, or, of short ones, of as many as 256 pulses make; never more, however long the recording. The
/// same numbers for any number of threads.
/// @throw  std::invalid_argument where options make no sense; Interrupted; what reading throws
void each_interval(const PulseRows& rows, const SearchOptions& options, const core::WorkControl& control,
                   const core::ProgressReport& progress, const std::function<void(const SearchInterval&)>& consume);

/// Bytes that `each_interval` holds.
[[nodiscard]] double interval_bytes(const SearchOptions& options, std::size_t pulses, std::size_t samples);

}  // namespace sarsim::workflow

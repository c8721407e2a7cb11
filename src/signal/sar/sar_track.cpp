#include "signal/sar/sar_track.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "signal/sar/reference_track.hpp"

namespace sarsim::signal {

StraightTrack fit_straight(std::span<const TrackPoint> track) {
  if (track.size() < 2) throw std::invalid_argument("a track of fewer than two pulses has no direction");
  for (std::size_t i = 1; i < track.size(); ++i)
    if (!(track[i].time_s > track[i - 1].time_s)) throw std::invalid_argument("the times of a track do not ascend");
  const ReferenceTrack line = fitted_track(track);
  StraightTrack fit;
  fit.speed_mps = core::norm(line.velocity_mps);
  if (fit.speed_mps > 0.0) fit.along = (1.0 / fit.speed_mps) * line.velocity_mps;
  fit.interval_s = (track.back().time_s - track.front().time_s) / static_cast<double>(track.size() - 1);
  fit.middle_pulse = track.size() / 2;
  const double middle_s = track.front().time_s + static_cast<double>(fit.middle_pulse) * fit.interval_s;
  fit.origin_m = line.at(middle_s);
  for (std::size_t i = 0; i < track.size(); ++i) {
    fit.worst_position_m = std::max(fit.worst_position_m, core::norm(track[i].position_m - line.at(track[i].time_s)));
    const double even_s = middle_s + fit.time_s(static_cast<double>(i));
    fit.worst_interval_s = std::max(fit.worst_interval_s, std::abs(track[i].time_s - even_s));
  }
  return fit;
}

}  // namespace sarsim::signal

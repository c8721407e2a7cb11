#include "process/sar_track.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sarsim {

namespace {

struct Line {
  double mean_time_s = 0.0;
  Vec3 mean_position_m;
  Vec3 velocity_mps;
};

// Least squares of position against time.
Line fitted_line(std::span<const TrackPoint> track) {
  Line line;
  const double share = 1.0 / static_cast<double>(track.size());
  for (const TrackPoint& point : track) {
    line.mean_time_s += share * (point.time_s - track.front().time_s);
    line.mean_position_m = line.mean_position_m + share * (point.position_m - track.front().position_m);
  }
  line.mean_time_s += track.front().time_s;
  line.mean_position_m = line.mean_position_m + track.front().position_m;
  Vec3 covariance;
  double variance = 0.0;
  for (const TrackPoint& point : track) {
    const double time_s = point.time_s - line.mean_time_s;
    covariance = covariance + time_s * (point.position_m - line.mean_position_m);
    variance += time_s * time_s;
  }
  line.velocity_mps = (1.0 / variance) * covariance;
  return line;
}

}  // namespace

StraightTrack fit_straight(std::span<const TrackPoint> track) {
  if (track.size() < 2) throw std::invalid_argument("a track of fewer than two pulses has no direction");
  for (std::size_t i = 1; i < track.size(); ++i)
    if (!(track[i].time_s > track[i - 1].time_s)) throw std::invalid_argument("the times of a track do not ascend");
  const Line line = fitted_line(track);
  const auto position_at = [&](double time_s) {
    return line.mean_position_m + (time_s - line.mean_time_s) * line.velocity_mps;
  };
  StraightTrack fit;
  fit.speed_mps = norm(line.velocity_mps);
  if (fit.speed_mps > 0.0) fit.along = (1.0 / fit.speed_mps) * line.velocity_mps;
  fit.interval_s = (track.back().time_s - track.front().time_s) / static_cast<double>(track.size() - 1);
  fit.middle_pulse = track.size() / 2;
  const double middle_s = track.front().time_s + static_cast<double>(fit.middle_pulse) * fit.interval_s;
  fit.origin_m = position_at(middle_s);
  for (std::size_t i = 0; i < track.size(); ++i) {
    fit.worst_position_m = std::max(fit.worst_position_m, norm(track[i].position_m - position_at(track[i].time_s)));
    const double even_s = middle_s + fit.time_s(static_cast<double>(i));
    fit.worst_interval_s = std::max(fit.worst_interval_s, std::abs(track[i].time_s - even_s));
  }
  return fit;
}

}  // namespace sarsim

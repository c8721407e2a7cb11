#include "signal/sar/reference_track.hpp"

namespace sarsim::signal {

ReferenceTrack fitted_track(std::span<const TrackPoint> track) {
  ReferenceTrack line;
  if (track.empty()) return line;
  const double share = 1.0 / static_cast<double>(track.size());
  // Against the first pulse: sums of small numbers keep their digits.
  const TrackPoint& first = track.front();
  double time = 0.0;
  core::Vec3 place;
  for (const TrackPoint& point : track) {
    time += share * (point.time_s - first.time_s);
    place = place + share * (point.position_m - first.position_m);
  }
  double spread = 0.0;
  core::Vec3 moment;
  for (const TrackPoint& point : track) {
    const double t = point.time_s - first.time_s - time;
    spread += t * t;
    moment = moment + t * (point.position_m - first.position_m - place);
  }
  line.time_s = first.time_s + time;
  line.position_m = first.position_m + place;
  line.velocity_mps = spread > 0.0 ? (1.0 / spread) * moment : first.velocity_mps;
  return line;
}

double straightness(std::span<const TrackPoint> track) {
  constexpr std::size_t pieces = 8;
  if (track.size() < 2) return 0.0;
  double flown_m = 0.0;
  const core::Vec3* from_m = &track.front().position_m;
  for (std::size_t piece = 1; piece <= pieces; ++piece) {
    const core::Vec3& to_m = track[piece * (track.size() - 1) / pieces].position_m;
    flown_m += core::norm(to_m - *from_m);
    from_m = &to_m;
  }
  return flown_m > 0.0 ? core::norm(track.back().position_m - track.front().position_m) / flown_m : 0.0;
}

double distance_from(const ReferenceTrack& track, const core::Vec3& point_m) {
  const core::Vec3 r = point_m - track.position_m;
  const double speed2 = core::dot(track.velocity_mps, track.velocity_mps);
  if (speed2 == 0.0) return core::norm(r);
  return core::norm(r - (core::dot(r, track.velocity_mps) / speed2) * track.velocity_mps);
}

}  // namespace sarsim::signal

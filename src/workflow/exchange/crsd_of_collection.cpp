#include "workflow/exchange/crsd_of_collection.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "radar/earth/ellipsoid.hpp"
#include "radar/waveform/pulse.hpp"
#include "workflow/exchange/reference_geometry.hpp"

namespace sarsim::workflow {

namespace {

// When the first sample of a row is taken, after the middle of its pulse has left.
double first_sample_s(const simulate::Acquisition& acquisition) {
  return acquisition.reception.pulse.from_middle_s(acquisition.reception.raw_grid.first_s);
}

core::Vec3 direction_of(const core::Vec3& v) { return (1.0 / core::norm(v)) * v; }

// Axes of an antenna that looks at a point, for which vertical is along the second: the first is level.
std::pair<core::Vec3, core::Vec3> axes_towards(const core::Vec3& point_m, const core::Vec3& antenna_m) {
  const radar::Geodetic place = radar::geodetic_of(point_m);
  const core::Vec3 up{std::cos(place.latitude_rad) * std::cos(place.longitude_rad),
                      std::cos(place.latitude_rad) * std::sin(place.longitude_rad), std::sin(place.latitude_rad)};
  const core::Vec3 sight = direction_of(point_m - antenna_m);
  const core::Vec3 level = direction_of(core::cross(up, sight));
  return {level, core::cross(sight, level)};
}

core::Vec3 divided(const core::Vec3& v, double by) { return {v.x / by, v.y / by, v.z / by}; }

// Where an antenna in the middle between transmitter and receiver would be, and how it would move: along their
// bisector, at their mean distance. Step by step as the standard has it, because a ground range by an arc cosine shows
// the last bit of a place.
raster::PlatformGeometry middle_of(const raster::PhaseVector& v, double time_s) {
  struct Sight {
    double range_m, rate_mps;
    core::Vec3 unit, turn;
  };
  const auto sight = [&](const core::Vec3& at_m, const core::Vec3& mps) {
    const double range_m = core::norm(at_m - v.srp_m);
    const core::Vec3 unit = divided(at_m - v.srp_m, range_m);
    const double rate_mps = core::dot(mps, unit);
    return Sight{range_m, rate_mps, unit, divided(mps - rate_mps * unit, range_m)};
  };
  const Sight out = sight(v.tx_m, v.tx_mps), back = sight(v.rcv_m, v.rcv_mps);
  const core::Vec3 bisector = divided(out.unit + back.unit, 2.0);
  const core::Vec3 rate = divided(out.turn + back.turn, 2.0);
  const double length = core::norm(bisector);
  const core::Vec3 unit = divided(bisector, length);
  const core::Vec3 turn = divided(rate - core::dot(rate, unit) * unit, length);
  const double range_m = (out.range_m + back.range_m) / 2.0;
  const double rate_mps = (out.rate_mps + back.rate_mps) / 2.0;
  return platform_geometry(time_s, v.srp_m + range_m * unit, rate_mps * unit + range_m * turn, v.srp_m);
}

}  // namespace

void expect_receivable(const simulate::Acquisition& acquisition) {
  constexpr double off_samples = 1e-3;
  constexpr double min_oversampling = 1.1;
  core::Problems problems;
  const double rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s;
  const double band_hz = std::abs(radar::bandwidth_hz(acquisition.link.pulse));
  const bool chirp = acquisition.link.pulse.kind == radar::Pulse::Kind::chirp;
  if (!chirp && acquisition.link.pulse.kind != radar::Pulse::Kind::mono)
    problems.push_back(
        core::error("CRSD describes pulses of one frequency and chirps, but this one is coded or given by points")
            .expected("a chirp")
            .hint("NPY and HDF5 take any pulse"));
  if (!(rate_hz >= min_oversampling * band_hz))
    problems.push_back(
        core::error("the sampling rate is too low for CRSD")
            .found(fmt::format("{:.6g} MHz", 1e-6 * rate_hz))
            .expected(fmt::format("at least {:.6g} MHz, 1.1 times the bandwidth", 1e-6 * min_oversampling * band_hz))
            .hint("raise sample_rate"));
  const radar::Repetition& repetition = acquisition.link.repetition;
  double shortest_s = INFINITY;
  double worst = 0.0;
  double at_s = 0.0;
  const double first_s = repetition.send_time_s(acquisition.timing.pulses.first);
  for (std::int64_t pulse = acquisition.timing.pulses.first + 1; pulse <= acquisition.timing.pulses.last; ++pulse) {
    const double sent_s = repetition.send_time_s(pulse);
    shortest_s = std::min(shortest_s, sent_s - repetition.send_time_s(pulse - 1));
    const double samples = (sent_s - first_s) * rate_hz;
    if (const double off = std::abs(samples - std::round(samples)); off > worst)
      std::tie(worst, at_s) = std::pair(off, sent_s);
  }
  if (worst > off_samples) {
    const double per_pulse = repetition.mean_interval_s() * rate_hz;
    problems.push_back(
        core::error(
            "the pulses do not leave a whole number of sample periods after one another, on the clock of the converter")
            .found(fmt::format("{:.6g} sample periods from pulse to pulse; off by {:.3g} at {:.6g} s", per_pulse, worst,
                               at_s))
            .expected("whole numbers, within 0.001")
            .hint(fmt::format("a repetition of {:.9g} Hz is {:.0f} sample periods at this sample_rate",
                              rate_hz / std::round(per_pulse), std::round(per_pulse))));
  }
  const double window_s =
      static_cast<double>(acquisition.reception.raw_grid.count) * acquisition.reception.raw_grid.interval_s;
  if (window_s > shortest_s * (1.0 + 1e-9))
    problems.push_back(core::error("the recorded windows overlap")
                           .found(fmt::format("{:.6g} us", 1e6 * window_s))
                           .expected(fmt::format("at most {:.6g} us, the shortest pulse interval", 1e6 * shortest_s))
                           .hint("shorten the range, or lower the repetition"));
  if (!problems.empty()) throw core::InvalidRequest(core::ranked(std::move(problems)));
}

ReceivedPulses::ReceivedPulses(const Collection& collection) : collection_(&collection), geometry_(collection) {}

raster::ReceivedPulse ReceivedPulses::pulse_of(std::size_t row) {
  const simulate::Acquisition& acquisition = *collection_->acquisition;
  const CollectedPulse sent = geometry_.pulse_of(row);
  const raster::PhaseVector& v = sent.vector;
  const double window_s = first_sample_s(acquisition);
  const std::int64_t number = acquisition.timing.first_pulse_of_row(row);
  const radar::Pose received = acquisition.scene->platforms[acquisition.link.platform].track.at(
      acquisition.link.repetition.send_time_s(number) + window_s, number);
  raster::ReceivedPulse pulse;
  pulse.tx_time_s = v.tx_time_s;
  pulse.tx_m = v.tx_m;
  pulse.tx_mps = v.tx_mps;
  std::tie(pulse.tx_x, pulse.tx_y) = axes_towards(v.srp_m, v.tx_m);
  pulse.carrier_hz = sent.carrier_hz;
  pulse.rate_hz_per_s = acquisition.link.pulse.sweep_rate_hz_per_s();
  pulse.rcv_start_s = v.tx_time_s + window_s;
  pulse.phase_cycles = sent.carrier_hz * window_s;
  pulse.rcv_m = collection_->earth.ecef_from_world(received.position_world_m);
  pulse.rcv_mps = collection_->earth.ecef_axes_from_world(received.velocity_world_mps);
  std::tie(pulse.rcv_x, pulse.rcv_y) = axes_towards(v.srp_m, pulse.rcv_m);
  return pulse;
}

raster::CrsdDescription crsd_of(const Collection& collection, const CollectionExtent& extent,
                                const raster::CphdDescription& cphd) {
  const simulate::Acquisition& acquisition = *collection.acquisition;
  const std::size_t reference = acquisition.timing.rows / 2;
  const raster::ReceivedPulse pulse = ReceivedPulses(collection).pulse_of(reference);
  raster::PhaseVector v = CollectionGeometry(collection).pulse_of(reference).vector;
  v.rcv_time_s = pulse.rcv_start_s;
  v.rcv_m = pulse.rcv_m;
  v.rcv_mps = pulse.rcv_mps;
  raster::CrsdDescription d;
  d.name = collection.name;
  d.sensor = cphd.collector;
  d.mode = cphd.mode;
  d.parameters = cphd.parameters;
  d.start = cphd.start;
  d.scene = cphd.scene;
  d.encoding = cphd.encoding;
  d.pulses = acquisition.timing.rows;
  d.samples = acquisition.reception.columns;
  d.reference = reference;
  d.tx_time1_s = extent.first_tx_s;
  d.tx_time2_s = extent.last_tx_s;
  d.rcv_start1_s = extent.first_tx_s + first_sample_s(acquisition);
  d.rcv_start2_s = extent.last_tx_s + first_sample_s(acquisition);
  d.min_carrier_hz = extent.min_carrier_hz;
  d.max_carrier_hz = extent.max_carrier_hz;
  d.band_hz = std::abs(radar::bandwidth_hz(acquisition.link.pulse));
  d.width_s = acquisition.link.pulse.width_s;
  d.sample_rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s;
  d.reference_carrier_hz = pulse.carrier_hz;
  d.noise_w = 2.0 * acquisition.reception.noise_stddev_v * acquisition.reception.noise_stddev_v;
  d.centre_time_s = cphd.centre_time_s;
  d.dwell_s = cphd.dwell_s;
  d.geometry = reference_geometry(v, true);
  d.geometry.srp_in_area_m = cphd.geometry->srp_in_area_m;
  d.geometry.centre_time_s = cphd.geometry->centre_time_s;
  d.geometry.dwell_s = cphd.geometry->dwell_s;
  d.middle = middle_of(v, d.geometry.time_s);
  const auto squint = [&](const raster::PlatformGeometry& g) {
    return ground_squint_deg(g.position_m, g.velocity_mps, v.srp_m);
  };
  d.tx_squint_deg = squint(d.geometry.platform);
  d.rcv_squint_deg = squint(d.geometry.receiver);
  d.middle_squint_deg = squint(d.middle);
  return d;
}

}  // namespace sarsim::workflow

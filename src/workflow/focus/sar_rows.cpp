#include "workflow/focus/sar_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/task/worker_pool.hpp"
#include "radar/path/path.hpp"
#include "signal/compress/float_compression.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/plan/row_space.hpp"
#include "simulate/run/computed_rows.hpp"
#include "simulate/run/sampled_views.hpp"

namespace sarsim::workflow {

namespace {

// Room to compress rows in; one for each thread, used again.
struct FloatSpace {
  std::vector<std::complex<double>> raw;
  std::vector<std::complex<float>> scratch;

  void compress(const signal::FloatCompressor& compressor, std::span<std::complex<float>> out) {
    scratch.resize(compressor.scratch_size());
    compressor.compress(raw, out, scratch);
  }
};

// The filter without a window: focusing has its own.
std::shared_ptr<const signal::FloatCompressor> plain_compressor(const simulate::Acquisition& acquisition,
                                                                std::size_t samples) {
  const signal::WindowFunction even = [](double) { return 1.0; };
  const radar::BandLimitedPulse* band_limited =
      acquisition.reception.pulse.band_limited ? &*acquisition.reception.pulse.band_limited : nullptr;
  const signal::CompressionFilter filter = signal::matched_filter(acquisition.link.pulse, band_limited, even,
                                                                  1.0 / acquisition.reception.raw_grid.interval_s);
  return std::make_shared<const signal::FloatCompressor>(filter, acquisition.reception.columns, samples);
}

// Made with the first row: what only looks at the geometry of a scene has no need of it.
class CompressorAtNeed {
 public:
  const signal::FloatCompressor& of(const simulate::Acquisition& acquisition, std::size_t samples) {
    std::call_once(once_, [&] { compressor_ = plain_compressor(acquisition, samples); });
    return *compressor_;
  }

 private:
  std::once_flag once_;
  std::shared_ptr<const signal::FloatCompressor> compressor_;
};

// All but `read`. The echoes of a target at the delay t begin, and so are compressed to a peak, `lead` before t.
signal::EchoRows rows_without_reader(const simulate::Acquisition& acquisition, std::size_t samples) {
  signal::EchoRows rows;
  const bool chirp = acquisition.link.pulse.kind == radar::Pulse::Kind::chirp;
  rows.waveform = {
      .carrier_hz = acquisition.carrier_hz(),
      .bandwidth_hz = chirp ? acquisition.link.pulse.sweep_hz : radar::bandwidth_hz(acquisition.link.pulse),
      .pulse_width_s = chirp ? acquisition.link.pulse.width_s : 0.0,
      .sample_rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s,
      .light_speed_mps = acquisition.light_speed_mps()};
  rows.track = track_of(acquisition);
  rows.rows = rows.track.size();
  rows.columns = samples;
  rows.first_delay_s = acquisition.reception.raw_grid.first_s + acquisition.reception.pulse.lead_s;
  const double lowest_hz = acquisition.link.carrier.lowest_hz();
  const double highest_hz = acquisition.link.carrier.highest_hz();
  if (lowest_hz == highest_hz) return rows;
  rows.waveform.carrier_hz = 0.5 * (lowest_hz + highest_hz);
  for (std::int64_t pulse = acquisition.timing.pulses.first; pulse <= acquisition.timing.pulses.last; ++pulse)
    rows.carriers_hz.push_back(acquisition.link.carrier.carrier_hz(pulse));
  return rows;
}

// Raw rows compressed, compressed ones as they are.
signal::EchoRows rows_reading(const std::shared_ptr<const simulate::Acquisition>& acquisition, std::size_t samples,
                              core::SampleRows<double> recorded, bool raw) {
  signal::EchoRows rows = rows_without_reader(*acquisition, samples);
  const auto compressor = std::make_shared<CompressorAtNeed>();
  const auto pool = std::make_shared<core::WorkerPool<FloatSpace>>([] { return std::make_unique<FloatSpace>(); });
  rows.copy = [acquisition, samples, raw, compressor, pool, recorded = std::move(recorded)](
                  std::size_t pulse, std::span<std::complex<float>> out) {
    pool->lend([&](FloatSpace& space) {
      space.raw.resize(acquisition->reception.columns);
      recorded.read(pulse, space.raw);
      raw ? space.compress(compressor->of(*acquisition, samples), out) : simulate::to_float(space.raw, out);
    });
  };
  return rows;
}

}  // namespace

core::Problems problems_of_sar(const simulate::Acquisition& acquisition, bool recorded) {
  core::Problems problems;
  if (recorded && acquisition.reception.is_profile())
    problems.push_back(core::error("synthetic range profiles cannot be focused")
                           .found("processing \"srp\"")
                           .expected("processing \"raw\" or \"matched-filter\"")
                           .hint("focus a recording of chirps"));
  if (acquisition.timing.pulses.count() < 2)
    problems.push_back(core::error("too few pulses to focus")
                           .found(fmt::format("{}", acquisition.timing.pulses.count()))
                           .expected("at least 2")
                           .hint("record for longer"));
  // A row anew holds all of the last echo.
  constexpr double max_samples = 0x1p31;
  const double samples = acquisition.reception.sample_rate_hz * acquisition.link.pulse.width_s;
  if (!recorded && !(samples <= max_samples))
    problems.push_back(
        core::error("the pulse is too long to be focused: a row has to contain a complete echo")
            .found(fmt::format("pulse_width {:g} s, {:.3g} samples", acquisition.link.pulse.width_s, samples))
            .expected(fmt::format("at most {:.3g} s", max_samples / acquisition.reception.sample_rate_hz))
            .hint("shorten the pulse"));
  const bool compressed = recorded && acquisition.reception.is_compressed();
  const bool even =
      !compressed || acquisition.reception.compressor->output_index().back() + 1 == acquisition.reception.columns;
  if (!even)
    problems.push_back(core::error("the classic profile repeats or leaves out samples of this compressed recording")
                           .hint("focus raw data, or use the physical profile"));
  if (acquisition.scene->platforms[acquisition.link.platform].track.fixed())
    problems.push_back(core::error("the antenna does not move")
                           .found(acquisition.scene->platforms[acquisition.link.platform].name)
                           .expected("a platform that follows a trajectory")
                           .hint("put the radar on one"));
  return problems;
}

// Over a turning Earth the way out and home differs from that over an Earth at rest by 2 d (w x P).V/c^2: as much as a
// small velocity away from the scene makes.
core::Vec3 for_turning(const core::Vec3& velocity_mps, const core::Vec3& antenna_m, const core::Vec3& scene_m,
                       const simulate::ResolvedScene& scene) {
  const core::Vec3 line_of_sight_m = scene_m - antenna_m;
  const double carried =
      core::dot(radar::carried_mps(scene.turning, scene_m), velocity_mps) / scene.conventions.light_speed_mps;
  return velocity_mps - (carried / core::norm(line_of_sight_m)) * line_of_sight_m;
}

// The antenna's mean velocity while an echo is under way: that with which its light time is that of an even flight.
core::Vec3 velocity_until_back(const simulate::PulseGeometry& geometry, const simulate::Acquisition& acquisition,
                               const core::Vec3& scene_m) {
  if (acquisition.scene->conventions.light_time == radar::LightTime::thesis)
    return geometry.radar_pose().velocity_world_mps;
  if (!acquisition.scene->turns())
    return acquisition.scene->scatterers.empty()
               ? geometry.radar_pose().velocity_world_mps
               : geometry.frame(acquisition.scene->scatterers.front().platform).radar_mps;
  const radar::Pose& pose = geometry.radar_pose();
  const double back_s = radar::delay_of(core::norm(scene_m - pose.position_world_m), acquisition.light_speed_mps());
  const radar::Track& track = acquisition.scene->platforms[acquisition.link.platform].track;
  const core::Vec3 back_m = track.at(geometry.send_time_s() + back_s, geometry.pulse()).position_world_m;
  return for_turning((1.0 / back_s) * (back_m - pose.position_world_m), pose.position_world_m, scene_m,
                     *acquisition.scene);
}

std::vector<signal::TrackPoint> track_along(const simulate::Acquisition& acquisition,
                                            const std::function<core::Vec3(double)>& position_at) {
  const double light_mps = acquisition.light_speed_mps();
  const core::Vec3 scene_m = scene_middle_m(acquisition);
  std::vector<signal::TrackPoint> track;
  for (std::int64_t pulse = acquisition.timing.pulses.first; pulse <= acquisition.timing.pulses.last; ++pulse) {
    const double time_s = acquisition.link.repetition.send_time_s(pulse);
    const core::Vec3 at_m = position_at(time_s);
    const double back_s = radar::delay_of(core::norm(scene_m - at_m), light_mps);
    core::Vec3 velocity_mps = (1.0 / back_s) * (position_at(time_s + back_s) - at_m);
    if (acquisition.scene->turns()) velocity_mps = for_turning(velocity_mps, at_m, scene_m, *acquisition.scene);
    track.push_back({time_s, at_m, velocity_mps});
  }
  return track;
}

std::vector<signal::TrackPoint> track_of(const simulate::Acquisition& acquisition) {
  simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
  std::vector<signal::TrackPoint> track;
  track.reserve(static_cast<std::size_t>(acquisition.timing.pulses.count()));
  const core::Vec3 scene_m = acquisition.scene->turns() ? scene_middle_m(acquisition) : core::Vec3{};
  for (std::int64_t pulse = acquisition.timing.pulses.first; pulse <= acquisition.timing.pulses.last; ++pulse) {
    geometry.set_pulse(pulse);
    const radar::Pose& pose = geometry.radar_pose();
    track.push_back(
        {geometry.send_time_s(), pose.position_world_m, velocity_until_back(geometry, acquisition, scene_m)});
  }
  return track;
}

scene::Simulation recorded_for_sar(const scene::Simulation& simulation, const simulate::Acquisition& acquisition) {
  scene::Simulation recorded = simulation;
  recorded.processing = scene::Processing::raw;
  const double interval_s = 1.0 / simulation.sample_rate_hz;
  const double last_s = acquisition.reception.pulse.band_limited ? acquisition.reception.pulse.band_limited->last_s()
                                                                 : acquisition.link.pulse.width_s;
  const double more = std::ceil(last_s / interval_s) + 1.0;
  const double c = acquisition.light_speed_mps();
  // As the matched filter does: the echo of a target at CENTRE begins half a pulse before its range.
  recorded.range_start_m -= radar::range_of(acquisition.reception.pulse.lead_s, c);
  recorded.range_end_m += radar::range_of(more * interval_s - acquisition.reception.pulse.lead_s, c);
  return recorded;
}

signal::EchoRows sar_rows_of_scene(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                   std::size_t samples) {
  return rows_reading(acquisition, samples, simulate::computed_rows(acquisition), true);
}

signal::EchoRows sar_rows_of_recording(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                       core::SampleRows<double> recorded) {
  return rows_reading(acquisition, acquisition->reception.columns, std::move(recorded),
                      acquisition->reception.is_raw());
}

core::Vec3 scene_middle_m(const simulate::Acquisition& acquisition) {
  simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
  geometry.set_pulse(acquisition.timing.pulses.first + acquisition.timing.pulses.count() / 2);
  const radar::Pose& radar = geometry.radar_pose();
  core::Vec3 sum;
  for (const simulate::Scatterer& target : acquisition.scene->scatterers)
    sum = sum + radar::world_position_m(geometry.pose(target.platform), target.position_m);
  const auto count = static_cast<double>(acquisition.scene->scatterers.size());
  const core::Vec3 to_targets = count > 0.0 ? (1.0 / count) * sum - radar.position_world_m : core::Vec3{};
  if (core::norm(core::cross(to_targets, radar.velocity_world_mps)) > 1e-6 * core::norm(radar.velocity_world_mps))
    return radar.position_world_m + to_targets;
  const double range_m =
      0.5 * (acquisition.reception.column_range_m.front() + acquisition.reception.column_range_m.back());
  return radar.position_world_m + range_m * geometry.pointing().axis_world();
}

double geometric_doppler_centroid_hz(const simulate::Acquisition& acquisition) {
  constexpr std::int64_t looks = 65;
  constexpr std::size_t max_echoes = 4096;
  simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
  const std::int64_t pulses = acquisition.timing.pulses.count();
  double power = 0.0;
  double sum = 0.0;
  for (std::int64_t look = 0; look < std::min(looks, pulses); ++look) {
    geometry.set_pulse(acquisition.timing.pulses.first +
                       look * (pulses - 1) / std::max<std::int64_t>(std::min(looks, pulses) - 1, 1));
    simulate::each_sampled_view(*acquisition.scene, geometry, max_echoes, [&](const simulate::ScattererView& view) {
      const double weight = view.amplitude_sqrt_w * view.amplitude_sqrt_w;
      power += weight;
      sum -= weight * view.speed_mps;
    });
  }
  const double per_speed = radar::turns_per_m(acquisition.carrier_hz(), acquisition.light_speed_mps());
  if (power > 0.0) return per_speed * sum / power;
  const bool isotropic = acquisition.link.transmit.kind == radar::AntennaPattern::Kind::isotropic &&
                         acquisition.link.receive.kind == radar::AntennaPattern::Kind::isotropic;
  if (isotropic) return 0.0;
  geometry.set_pulse(acquisition.timing.pulses.first + pulses / 2);
  return per_speed * core::dot(geometry.radar_pose().velocity_world_mps, geometry.pointing().axis_world());
}

}  // namespace sarsim::workflow

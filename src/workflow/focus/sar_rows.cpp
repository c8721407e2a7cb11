#include "workflow/focus/sar_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/task/worker_pool.hpp"
#include "radar/path/path.hpp"
#include "signal/compress/float_compression.hpp"
#include "simulate/plan/row_maker.hpp"
#include "simulate/plan/row_space.hpp"
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

// What makes the rows of a scene; one for each thread.
struct SceneWorker {
  explicit SceneWorker(const simulate::Plan& plan) : maker(plan) {}
  simulate::RowMaker maker;
  FloatSpace space;
};

// The filter without a window: focusing has its own.
std::shared_ptr<const signal::FloatCompressor> plain_compressor(const simulate::Plan& plan, std::size_t samples) {
  const signal::WindowFunction even = [](double) { return 1.0; };
  const radar::BandLimitedPulse* band_limited = plan.pulse.band_limited ? &*plan.pulse.band_limited : nullptr;
  const signal::CompressionFilter filter =
      signal::matched_filter(plan.radar.pulse, band_limited, even, 1.0 / plan.raw_grid.interval_s);
  return std::make_shared<const signal::FloatCompressor>(filter, plan.columns, samples);
}

// Made with the first row: what only looks at the geometry of a scene has no need of it.
class CompressorAtNeed {
 public:
  const signal::FloatCompressor& of(const simulate::Plan& plan, std::size_t samples) {
    std::call_once(once_, [&] { compressor_ = plain_compressor(plan, samples); });
    return *compressor_;
  }

 private:
  std::once_flag once_;
  std::shared_ptr<const signal::FloatCompressor> compressor_;
};

// All but `read`. The echoes of a target at the delay t begin, and so are compressed to a peak, `lead` before t.
signal::EchoRows rows_without_reader(const simulate::Plan& plan, std::size_t samples) {
  signal::EchoRows rows;
  const bool chirp = plan.radar.pulse.kind == radar::Pulse::Kind::chirp;
  rows.waveform = {.carrier_hz = plan.radar.carrier.carrier_hz(plan.pulses.first),
                   .bandwidth_hz = chirp ? plan.radar.pulse.sweep_hz : radar::bandwidth_hz(plan.radar.pulse),
                   .pulse_width_s = chirp ? plan.radar.pulse.width_s : 0.0,
                   .sample_rate_hz = 1.0 / plan.raw_grid.interval_s,
                   .light_speed_mps = plan.scene->conventions.light_speed_mps};
  rows.track = track_of(plan);
  rows.rows = rows.track.size();
  rows.columns = samples;
  rows.first_delay_s = plan.raw_grid.first_s + plan.pulse.lead_s;
  const double lowest_hz = plan.radar.carrier.lowest_hz();
  const double highest_hz = plan.radar.carrier.highest_hz();
  if (lowest_hz == highest_hz) return rows;
  rows.waveform.carrier_hz = 0.5 * (lowest_hz + highest_hz);
  for (std::int64_t pulse = plan.pulses.first; pulse <= plan.pulses.last; ++pulse)
    rows.carriers_hz.push_back(plan.radar.carrier.carrier_hz(pulse));
  return rows;
}

}  // namespace

core::Problems problems_of_sar(const simulate::Plan& plan, bool recorded) {
  core::Problems problems;
  if (recorded && plan.simulation.processing == scene::Processing::srp)
    problems.push_back(core::problem_of(core::Severity::error, "synthetic range profiles cannot be focused",
                                        "processing \"srp\"", "processing \"raw\" or \"matched-filter\"",
                                        "focus a recording of chirps"));
  if (plan.pulses.count() < 2)
    problems.push_back(core::problem_of(core::Severity::error, "too few pulses to focus",
                                        fmt::format("{}", plan.pulses.count()), "at least 2", "record for longer"));
  // A row anew holds all of the last echo.
  constexpr double max_samples = 0x1p31;
  const double samples = plan.simulation.sample_rate_hz * plan.radar.pulse.width_s;
  if (!recorded && !(samples <= max_samples))
    problems.push_back(core::problem_of(
        core::Severity::error, "the pulse is too long to be focused: a row has to hold a whole echo",
        fmt::format("pulse_width {:g} s, {:.3g} samples", plan.radar.pulse.width_s, samples),
        fmt::format("at most {:.3g} s", max_samples / plan.simulation.sample_rate_hz), "shorten the pulse"));
  const bool compressed = recorded && plan.simulation.processing == scene::Processing::matched_filter;
  const bool even = !compressed || plan.compressor->output_index().back() + 1 == plan.columns;
  if (!even)
    problems.push_back(core::problem_of(
        core::Severity::error, "the classic profile repeats or leaves out samples of this compressed recording", "", "",
        "focus raw data, or use the physical profile"));
  if (plan.scene->platforms[plan.radar.platform].track.fixed())
    problems.push_back(core::problem_of(core::Severity::error, "the antenna does not move",
                                        plan.scene->platforms[plan.radar.platform].name,
                                        "a platform that follows a trajectory", "put the radar on one"));
  return problems;
}

// Over a turning Earth the way out and home differs from that over an Earth at rest by 2 d (w x P).V/c^2: as much as a
// small velocity away from the scene makes.
core::Vec3 for_turning(const core::Vec3& velocity_mps, const core::Vec3& antenna_m, const core::Vec3& scene_m,
                       const simulate::ResolvedScene& scene) {
  const core::Vec3 look_m = scene_m - antenna_m;
  const double carried =
      core::dot(radar::carried_mps(scene.turning, scene_m), velocity_mps) / scene.conventions.light_speed_mps;
  return velocity_mps - (carried / core::norm(look_m)) * look_m;
}

// The antenna's mean velocity while an echo is under way: that with which its light time is that of an even flight.
core::Vec3 velocity_until_back(const simulate::PulseGeometry& geometry, const simulate::Plan& plan,
                               const core::Vec3& scene_m) {
  if (plan.scene->conventions.light_time == radar::LightTime::thesis) return geometry.radar_pose().velocity_world_mps;
  if (!plan.scene->turns())
    return plan.scene->scatterers.empty() ? geometry.radar_pose().velocity_world_mps
                                          : geometry.frame(plan.scene->scatterers.front().platform).radar_mps;
  const radar::Pose& pose = geometry.radar_pose();
  const double back_s =
      radar::delay_of(core::norm(scene_m - pose.position_world_m), plan.scene->conventions.light_speed_mps);
  const radar::Track& track = plan.scene->platforms[plan.radar.platform].track;
  const core::Vec3 back_m = track.at(geometry.send_time_s() + back_s, geometry.pulse()).position_world_m;
  return for_turning((1.0 / back_s) * (back_m - pose.position_world_m), pose.position_world_m, scene_m, *plan.scene);
}

std::vector<signal::TrackPoint> track_along(const simulate::Plan& plan,
                                            const std::function<core::Vec3(double)>& position_at) {
  const double light_mps = plan.scene->conventions.light_speed_mps;
  const core::Vec3 scene_m = scene_middle_m(plan);
  std::vector<signal::TrackPoint> track;
  for (std::int64_t pulse = plan.pulses.first; pulse <= plan.pulses.last; ++pulse) {
    const double time_s = plan.radar.repetition.send_time_s(pulse);
    const core::Vec3 at_m = position_at(time_s);
    const double back_s = radar::delay_of(core::norm(scene_m - at_m), light_mps);
    core::Vec3 velocity_mps = (1.0 / back_s) * (position_at(time_s + back_s) - at_m);
    if (plan.scene->turns()) velocity_mps = for_turning(velocity_mps, at_m, scene_m, *plan.scene);
    track.push_back({time_s, at_m, velocity_mps});
  }
  return track;
}

std::vector<signal::TrackPoint> track_of(const simulate::Plan& plan) {
  simulate::PulseGeometry geometry(*plan.scene, plan.radar);
  std::vector<signal::TrackPoint> track;
  track.reserve(static_cast<std::size_t>(plan.pulses.count()));
  const core::Vec3 scene_m = plan.scene->turns() ? scene_middle_m(plan) : core::Vec3{};
  for (std::int64_t pulse = plan.pulses.first; pulse <= plan.pulses.last; ++pulse) {
    geometry.set_pulse(pulse);
    const radar::Pose& pose = geometry.radar_pose();
    track.push_back({geometry.send_time_s(), pose.position_world_m, velocity_until_back(geometry, plan, scene_m)});
  }
  return track;
}

scene::Simulation recorded_for_sar(const scene::Simulation& simulation, const simulate::Plan& plan) {
  scene::Simulation recorded = simulation;
  recorded.processing = scene::Processing::raw;
  const double interval_s = 1.0 / simulation.sample_rate_hz;
  const double last_s = plan.pulse.band_limited ? plan.pulse.band_limited->last_s() : plan.radar.pulse.width_s;
  const double more = std::ceil(last_s / interval_s) + 1.0;
  const double c = plan.scene->conventions.light_speed_mps;
  // As the matched filter does: the echo of a target at CENTRE begins half a pulse before its range.
  recorded.range_start_m -= radar::range_of(plan.pulse.lead_s, c);
  recorded.range_end_m += radar::range_of(more * interval_s - plan.pulse.lead_s, c);
  return recorded;
}

signal::EchoRows sar_rows_of_scene(std::shared_ptr<const simulate::Plan> plan, std::size_t samples) {
  signal::EchoRows rows = rows_without_reader(*plan, samples);
  const auto compressor = std::make_shared<CompressorAtNeed>();
  const auto pool =
      std::make_shared<core::WorkerPool<SceneWorker>>([plan] { return std::make_unique<SceneWorker>(*plan); });
  rows.copy = [plan, samples, compressor, pool](std::size_t pulse, std::span<std::complex<float>> out) {
    pool->lend([&](SceneWorker& worker) {
      worker.space.raw.resize(plan->columns);
      worker.maker.make_row(pulse, worker.space.raw);
      worker.space.compress(compressor->of(*plan, samples), out);
    });
  };
  return rows;
}

signal::EchoRows sar_rows_of_recording(std::shared_ptr<const simulate::Plan> plan, core::SampleRows<double> recorded) {
  signal::EchoRows rows = rows_without_reader(*plan, plan->columns);
  const bool raw = plan->simulation.processing == scene::Processing::raw;
  const auto compressor = raw ? plain_compressor(*plan, plan->columns) : nullptr;
  const auto pool = std::make_shared<core::WorkerPool<FloatSpace>>([] { return std::make_unique<FloatSpace>(); });
  rows.copy = [plan, compressor, pool, recorded = std::move(recorded)](std::size_t pulse,
                                                                       std::span<std::complex<float>> out) {
    pool->lend([&](FloatSpace& space) {
      space.raw.resize(plan->columns);
      recorded.read(pulse, space.raw);
      compressor ? space.compress(*compressor, out) : simulate::to_float(space.raw, out);
    });
  };
  return rows;
}

core::Vec3 scene_middle_m(const simulate::Plan& plan) {
  simulate::PulseGeometry geometry(*plan.scene, plan.radar);
  geometry.set_pulse(plan.pulses.first + plan.pulses.count() / 2);
  const radar::Pose& radar = geometry.radar_pose();
  core::Vec3 sum;
  for (const simulate::Scatterer& target : plan.scene->scatterers)
    sum = sum + radar::world_position_m(geometry.pose(target.platform), target.position_m);
  const auto count = static_cast<double>(plan.scene->scatterers.size());
  const core::Vec3 to_targets = count > 0.0 ? (1.0 / count) * sum - radar.position_world_m : core::Vec3{};
  if (core::norm(core::cross(to_targets, radar.velocity_world_mps)) > 1e-6 * core::norm(radar.velocity_world_mps))
    return radar.position_world_m + to_targets;
  const double range_m = 0.5 * (plan.column_range_m.front() + plan.column_range_m.back());
  return radar.position_world_m + range_m * geometry.pointing().axis_world();
}

double geometric_doppler_centroid_hz(const simulate::Plan& plan) {
  constexpr std::int64_t looks = 65;
  constexpr std::size_t max_echoes = 4096;
  simulate::PulseGeometry geometry(*plan.scene, plan.radar);
  const std::int64_t pulses = plan.pulses.count();
  double power = 0.0;
  double sum = 0.0;
  for (std::int64_t look = 0; look < std::min(looks, pulses); ++look) {
    geometry.set_pulse(plan.pulses.first +
                       look * (pulses - 1) / std::max<std::int64_t>(std::min(looks, pulses) - 1, 1));
    simulate::each_sampled_view(*plan.scene, geometry, max_echoes, [&](const simulate::ScattererView& view) {
      const double weight = view.amplitude_sqrt_w * view.amplitude_sqrt_w;
      power += weight;
      sum -= weight * view.speed_mps;
    });
  }
  const double per_speed =
      radar::turns_per_m(plan.radar.carrier.carrier_hz(plan.pulses.first), plan.scene->conventions.light_speed_mps);
  if (power > 0.0) return per_speed * sum / power;
  const bool isotropic = plan.radar.transmit.kind == radar::AntennaPattern::Kind::isotropic &&
                         plan.radar.receive.kind == radar::AntennaPattern::Kind::isotropic;
  if (isotropic) return 0.0;
  geometry.set_pulse(plan.pulses.first + pulses / 2);
  return per_speed * core::dot(geometry.radar_pose().velocity_world_mps, geometry.pointing().axis_world());
}

}  // namespace sarsim::workflow

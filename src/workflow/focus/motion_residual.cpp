#include "workflow/focus/motion_residual.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/maths/sinc.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/ground_sight.hpp"

namespace sarsim::workflow {

namespace {

// Of one pulse.
struct ResidualEcho {
  double weight = 0.0;
  double phase_rad = 0.0;
  double cycles_per_m = 0.0;  // of azimuth: its place in the spectrum
};

class Residuals {
 public:
  Residuals(const simulate::Plan& plan, const signal::EchoRows& echoes, const signal::MotionCompensation& how)
      : plan_(plan), echoes_(echoes), how_(how), sight_(how.reference, how.scene_m, how.squint_rad) {}

  void set_pulse(simulate::PulseGeometry& geometry, std::size_t pulse) {
    geometry.set_pulse(plan_.pulses.first + static_cast<std::int64_t>(pulse));
    antenna_m_ = echoes_.track[pulse].position_m;
    foot_m_ = sight_.foot_of(antenna_m_);
    scene_difference_m_ = difference_m(sight_.range_m());
  }

  [[nodiscard]] ResidualEcho echo_of(const simulate::PulseGeometry& geometry, const radar::Pointing& pointing,
                                     std::size_t target) const {
    const simulate::Scatterer& scatterer = plan_.scene->scatterers[target];
    const core::Vec3 point_m = radar::world_position_m(geometry.pose(scatterer.platform), scatterer.position_m);
    const core::Vec3 from_foot_m = point_m - foot_m_;
    const double distance_m = core::norm(from_foot_m);
    const double true_m = core::norm(point_m - antenna_m_) - distance_m;
    const double taken_m = how_.second_order ? difference_m(distance_m) : scene_difference_m_;
    const signal::SarWaveform& wave = echoes_.waveform;
    const double per_m = radar::turns_per_m(wave.carrier_hz, wave.light_speed_mps);
    // The pulse itself was moved by what the scene needs.
    const double lag_s = radar::delay_of(true_m - scene_difference_m_, wave.light_speed_mps);
    const double amplitude = std::abs(geometry.view(target, pointing).amplitude_sqrt_w);
    return {amplitude * std::max(0.0, core::sinc(wave.bandwidth_hz * lag_s)),
            -2.0 * core::pi * per_m * (true_m - taken_m), per_m * core::dot(from_foot_m, sight_.ahead()) / distance_m};
  }

 private:
  // |P - X| - |Q - X| of the ground at a distance from Q.
  [[nodiscard]] double difference_m(double range_m) const {
    const core::Vec3 ground_m = sight_.point_at(foot_m_, range_m);
    return core::norm(antenna_m_ - ground_m) - core::norm(foot_m_ - ground_m);
  }

  const simulate::Plan& plan_;
  const signal::EchoRows& echoes_;
  const signal::MotionCompensation& how_;
  signal::GroundSight sight_;
  core::Vec3 antenna_m_, foot_m_;
  double scene_difference_m_ = 0.0;
};

// A straight line of the phase over the spectrum moves the peak; the rest lowers and turns it.
std::optional<MotionResidual> residual_of(std::size_t target, const std::vector<ResidualEcho>& seen) {
  double strongest = 0.0;
  for (const ResidualEcho& echo : seen) strongest = std::max(strongest, echo.weight);
  double sum = 0.0, phase = 0.0, square = 0.0, place = 0.0, place_square = 0.0, product = 0.0;
  for (const ResidualEcho& echo : seen) {
    if (!(echo.weight >= 0.1 * strongest)) continue;
    sum += echo.weight;
    phase += echo.weight * echo.phase_rad;
    square += echo.weight * echo.phase_rad * echo.phase_rad;
    place += echo.weight * echo.cycles_per_m;
    place_square += echo.weight * echo.cycles_per_m * echo.cycles_per_m;
    product += echo.weight * echo.phase_rad * echo.cycles_per_m;
  }
  if (!(sum > 0.0)) return std::nullopt;
  const double spread = place_square - place * place / sum;
  const double slope = spread > 0.0 ? (product - phase * place / sum) / spread : 0.0;
  std::complex<double> peak;
  for (const ResidualEcho& echo : seen)
    if (echo.weight >= 0.1 * strongest) peak += std::polar(echo.weight, echo.phase_rad - slope * echo.cycles_per_m);
  return MotionResidual{.target = target,
                        .rms_rad = std::sqrt(square / sum),
                        .amplitude = std::abs(peak) / sum,
                        .phase_rad = std::arg(peak),
                        .azimuth_m = -slope / (2.0 * core::pi)};
}

}  // namespace

std::optional<MotionResidual> worst_motion_residual(const simulate::Plan& plan, const signal::EchoRows& echoes,
                                                    const signal::MotionCompensation& how,
                                                    const core::WorkControl& control) {
  constexpr std::size_t most_targets = 512;
  constexpr std::size_t most_pulses = 512;
  const std::size_t every = (plan.scene->scatterers.size() + most_targets - 1) / most_targets;
  const std::size_t step = (echoes.track.size() + most_pulses - 1) / most_pulses;
  if (every == 0 || step == 0) return std::nullopt;
  std::vector<std::vector<ResidualEcho>> seen((plan.scene->scatterers.size() + every - 1) / every);
  Residuals residuals(plan, echoes, how);
  simulate::PulseGeometry geometry(*plan.scene, plan.radar);
  for (std::size_t pulse = 0; pulse < echoes.track.size(); pulse += step) {
    if (control.stop != nullptr && control.stop->requested()) throw core::Interrupted();
    residuals.set_pulse(geometry, pulse);
    const radar::Pointing pointing = geometry.pointing();
    for (std::size_t t = 0; t < seen.size(); ++t) seen[t].push_back(residuals.echo_of(geometry, pointing, t * every));
  }
  std::optional<MotionResidual> worst;
  for (std::size_t t = 0; t < seen.size(); ++t)
    if (const auto residual = residual_of(t * every, seen[t]);
        residual && (!worst || residual->rms_rad > worst->rms_rad))
      worst = residual;
  return worst;
}

core::Problems remarks_on_residual(const std::optional<MotionResidual>& residual) {
  if (!residual || !(residual->rms_rad > most_residual_rad)) return {};
  return {core::problem_of(
      core::Severity::warning,
      fmt::format("motion compensation, made for level ground in the middle of the beam, leaves {:.2g} rad rms in the "
                  "echoes of target {}: its peak loses {:.2g} dB, its phase is wrong by {:.2g} rad, and it is "
                  "displaced by {:.2g} m along the track",
                  residual->rms_rad, residual->target + 1, -core::amplitude_db(residual->amplitude),
                  residual->phase_rad, std::abs(residual->azimuth_m)),
      {}, fmt::format("up to {:.1f} rad", most_residual_rad),
      "use --algorithm back-projection, which follows the flown track")};
}

}  // namespace sarsim::workflow

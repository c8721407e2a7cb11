#include "simulate/survey/derived.hpp"
#include "scene/model/scene.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "simulate/run/memory_sink.hpp"
#include "simulate/run/run.hpp"

namespace sarsim::simulate {
namespace derived_test {

constexpr double c = core::exact_light_speed_mps;

scene::Scene chirp_scene() {
  scene::Radar radar;
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = -100e6;
  radar.pulse_width_s = 2.5e-6;
  radar.prf_hz = 1000.0;
  radar.carrier_hz = 0.5e9;
  radar.power_w = 1000.0;
  radar.noise_temperature_k = 290.0;
  scene::Simulation simulation;
  simulation.radar = radar.name;
  simulation.range_start_m = 900.0;
  simulation.range_end_m = 1600.0;
  simulation.time_end_s = 0.0035;
  simulation.sample_rate_hz = 200e6;
  simulation.bits = 8;
  scene::Target target;
  target.position_m = {0.0, 1000.0, 0.0};
  scene::Scene scene;
  scene.platforms = {scene::Platform{}};
  scene.targets = {target};
  scene.radars = {radar};
  scene.simulations = {simulation};
  return scene;
}

RadarFigures figures_of(const scene::Scene& scene) {
  const ResolvedScene resolved = resolve(scene);
  return radar_figures(resolve_radar(scene, resolved, 0), scene.radars[0].power_w, resolved.conventions);
}

SimulationFigures simulation_figures_of(const scene::Scene& scene) {
  const Acquisition acquisition = acquisition_of(scene, 0);
  return simulation_figures(acquisition, survey_echoes(acquisition));
}

// It is an unmodulated pulse.
TEST(Derived, AChirpWithoutBandwidthHasTheFiguresOfItsLength) {
  scene::Scene scene = chirp_scene();
  scene.radars[0].bandwidth_hz = 0.0;
  const RadarFigures f = figures_of(scene);
  EXPECT_DOUBLE_EQ(f.bandwidth_hz, 1.0 / 2.5e-6);
  EXPECT_DOUBLE_EQ(f.range_resolution_m, 0.5 * c * 2.5e-6);
  EXPECT_DOUBLE_EQ(f.time_bandwidth, 1.0);
  EXPECT_DOUBLE_EQ(simulation_figures_of(scene).sampling_ratio, 200e6 * 2.5e-6);
}

TEST(Derived, ChirpRadarHasTheTextbookFigures) {
  const RadarFigures f = figures_of(chirp_scene());
  EXPECT_DOUBLE_EQ(f.shortest_wavelength_m, c / 0.5e9);
  EXPECT_DOUBLE_EQ(f.longest_wavelength_m, c / 0.5e9);
  EXPECT_DOUBLE_EQ(f.range_resolution_m, c / 200e6);  // Also for a down chirp.
  EXPECT_DOUBLE_EQ(f.pulse_length_m, c * 2.5e-6);
  EXPECT_DOUBLE_EQ(f.time_bandwidth, 250.0);
  EXPECT_DOUBLE_EQ(f.unambiguous_range_m, c * 0.5e-3);
  EXPECT_DOUBLE_EQ(f.unambiguous_speed_mps, 0.25 * c / 0.5e9 * 1000.0);
  EXPECT_DOUBLE_EQ(f.duty_cycle, 2.5e-3);
  EXPECT_NEAR(f.mean_power_w, 2.5, 1e-12);
  EXPECT_DOUBLE_EQ(f.noise_power_w, core::boltzmann_j_per_k * 290.0 * 100e6);
  EXPECT_EQ(f.synthetic_range_resolution_m, 0.0);
}

TEST(Derived, SteppedCarriersGiveTheResolutionOfTheWholeBand) {
  scene::Scene scene = chirp_scene();
  scene::Radar& radar = scene.radars[0];
  radar.carrier = scene::Radar::Carrier::stepped;
  radar.carrier_step_hz = 10e6;
  radar.carrier_steps = 32;
  const RadarFigures f = figures_of(scene);
  EXPECT_DOUBLE_EQ(f.synthetic_range_resolution_m, c / (2.0 * 320e6));
  EXPECT_DOUBLE_EQ(f.highest_carrier_hz, 0.5e9 + 31 * 10e6);
  EXPECT_DOUBLE_EQ(f.shortest_wavelength_m, c / f.highest_carrier_hz);
  EXPECT_GT(f.longest_wavelength_m, f.shortest_wavelength_m);
}

TEST(Derived, UnequalIntervalsLimitRangeByTheShortestAndPowerByTheMean) {
  scene::Scene scene = chirp_scene();
  scene::Radar& radar = scene.radars[0];
  radar.repetition = scene::Radar::Repetition::user;
  radar.pri_s.part[0].knots = {{0.0, 1e-3}, {1.0, 3e-3}};
  const RadarFigures f = figures_of(scene);
  EXPECT_DOUBLE_EQ(f.unambiguous_range_m, 0.5 * c * 1e-3);
  EXPECT_DOUBLE_EQ(f.mean_prf_hz, 500.0);
  EXPECT_DOUBLE_EQ(f.duty_cycle, 2.5e-6 * 500.0);
}

TEST(Derived, MeanPowerCountsTheEnvelope) {
  scene::Scene scene = chirp_scene();
  scene::Radar& radar = scene.radars[0];
  radar.envelope = scene::Radar::Envelope::linear;
  radar.rise_s = radar.pulse_width_s;  // A ramp over the whole pulse: the mean of its square is 1/3.
  const RadarFigures f = figures_of(scene);
  // Midpoint rule on x^2: error of the mean h^2/12 = 5e-9.
  EXPECT_NEAR(f.mean_power_w, 2.5 / 3.0, 2.5 * 1e-8);
}

TEST(Derived, ClassicProfileUsesItsOwnConstants) {
  scene::Scene scene = chirp_scene();
  scene.options.profile = scene::Profile::classic;
  const RadarFigures f = figures_of(scene);
  EXPECT_DOUBLE_EQ(f.shortest_wavelength_m, core::classic_light_speed_mps / 0.5e9);
  EXPECT_DOUBLE_EQ(f.noise_density_w_per_hz, core::classic_boltzmann_j_per_k * 290.0);
}

TEST(Derived, WindowAndSamplingOfASimulation) {
  const SimulationFigures f = simulation_figures_of(chirp_scene());
  const double columns = std::floor(2.0 * 200e6 * 700.0 / c + 0.5);
  EXPECT_DOUBLE_EQ(f.first_delay_s, 1800.0 / c);
  EXPECT_NEAR(f.last_delay_s, 1800.0 / c + (columns - 1.0) / 200e6, 1e-18);
  EXPECT_NEAR(f.column_spacing_m, 0.5 * c / 200e6, 1e-10);
  EXPECT_DOUBLE_EQ(f.sampling_ratio, 2.0);
  EXPECT_NEAR(f.noise_power_w, core::boltzmann_j_per_k * 290.0 * 200e6, 1e-12 * f.noise_power_w);
}

TEST(Derived, SuggestedLsbFillsTheConverterWithTheLargestSum) {
  scene::Scene scene = chirp_scene();
  scene.radars[0].noise_temperature_k = 0.0;
  const SimulationFigures f = simulation_figures_of(scene);
  const double wavelength_m = c / 0.5e9;
  const double echo_v = std::sqrt(1000.0 / std::pow(4.0 * core::pi, 3.0)) * wavelength_m / 1e6;
  EXPECT_NEAR(f.largest_echo_v, echo_v, 1e-12 * echo_v);
  EXPECT_NEAR(f.largest_sum_v, echo_v, 1e-12 * echo_v);
  EXPECT_NEAR(f.suggested_lsb_v, echo_v / 127.0, 1e-12 * echo_v);
}

// The figure must be what a run really finds, whatever the profile's compression does to the amplitude.
TEST(Derived, LargestEchoIsWhatACompressedRunFinds) {
  for (const scene::Profile profile : {scene::Profile::physical, scene::Profile::classic}) {
    scene::Scene scene = chirp_scene();
    scene.options.profile = profile;
    scene.radars[0].noise_temperature_k = 0.0;
    scene.radars[0].window = scene::Radar::Window::hamming;
    scene::Simulation& simulation = scene.simulations[0];
    simulation.processing = scene::Processing::matched_filter;
    // A target on the grid of samples, where the compressed peak is met.
    const double light_speed =
        profile == scene::Profile::physical ? core::exact_light_speed_mps : core::classic_light_speed_mps;
    scene.targets[0].position_m = {0.0, 900.0 + 100.0 * 0.5 * light_speed / 200e6, 0.0};
    const Plan plan = make_plan(scene, 0);
    const Acquisition& acquisition = plan.acquisition;
    Recording recording;
    MemorySink sink(recording);
    const raster::RunReport report = run(plan, 0.0, sink, {.threads = 1, .stop = nullptr, .progress = {}});
    const SimulationFigures f = simulation_figures(acquisition, survey_echoes(acquisition));
    // Edge samples of the pulse may differ by one of 500.
    EXPECT_NEAR(f.largest_echo_v, report.maximum_v, report.maximum_v / 400.0) << static_cast<int>(profile);
  }
}

TEST(Derived, RangeLawStcScalesTheEstimate) {
  scene::Scene scene = chirp_scene();
  scene.radars[0].noise_temperature_k = 0.0;
  const double plain_v = simulation_figures_of(scene).largest_sum_v;
  scene.radars[0].stc = scene::Radar::Stc::range_law;
  const SimulationFigures f = simulation_figures_of(scene);
  const double last_m = 0.5 * c * f.last_delay_s;
  EXPECT_NEAR(f.largest_sum_v, plain_v * last_m * last_m, 1e-9 * f.largest_sum_v);
}

}  // namespace derived_test
}  // namespace sarsim::simulate

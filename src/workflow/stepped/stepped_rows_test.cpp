#include "workflow/stepped/stepped_rows.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "simulate/run/run.hpp"
#include "workflow/stepped/profile_series.hpp"
#include "workflow/stepped/stepped_test_scene.hpp"

namespace sarsim::workflow {
namespace stepped_rows_test {

using testing::HasSubstr;

constexpr double c = core::exact_light_speed_mps;
const core::WorkControl one{1, nullptr};

void make_chirped(scene::Scene& scene) {
  scene::Radar& radar = scene.radars[0];
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 6e6;
  radar.pulse_width_s = 10e-6;
}

SteppedRows rows_of(scene::Scene scene) {
  const simulate::Acquisition window = simulate::acquisition_of(scene, 0);
  EXPECT_FALSE(core::has_errors(problems_of_stepped(window, SteppedUse::profiles, false)));
  scene.simulations[0] = recorded_for_stepped(scene.simulations[0], window);
  return stepped_rows_of_scene(std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0)),
                               window);
}

std::string text_of(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
  return text;
}

double cell_of(const SteppedRows& rows) { return c / (2.0 * rows.band->band_hz()); }

TEST(SteppedRows, AreWholeBurstsOnly) {
  scene::Scene scene = stepped_scene();
  scene.simulations[0].time_start_s = 5.0 / 4000.0;
  scene.simulations[0].time_end_s = 140.0 / 4000.0;
  scene.targets.push_back(simulate::target_on("Earth", {3000.0, 0.0, 0.0}));
  const SteppedRows rows = rows_of(scene);
  EXPECT_EQ(rows.first_pulse, 32);
  EXPECT_EQ(rows.bursts, 3u);
  EXPECT_EQ(rows.dropped_pulses, 136 - 96);
  EXPECT_NEAR(rows.pulse_time_s(2), 34.0 / 4000.0, 1e-12);
}

// For both positions of the pulse and all kinds of pulses: the peak stands at the target, with its amplitude.
TEST(ProfileSeries, ShowsTargetsWhereTheyAreForEveryKindOfPulse) {
  for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre})
    for (const auto kind : {scene::Radar::Pulse::mono, scene::Radar::Pulse::chirp, scene::Radar::Pulse::barker}) {
      scene::Scene scene = stepped_scene(0.02);
      if (kind != scene::Radar::Pulse::mono) make_chirped(scene);
      scene.radars[0].pulse = kind;
      if (kind == scene::Radar::Pulse::barker) scene.radars[0].pulse_width_s = 2e-6;  // 13 chips: 6.5 MHz
      scene.simulations[0].pulse_position = position;
      scene.targets.push_back(simulate::target_on("Earth", {3003.3, 0.0, 0.0}));
      scene.targets.push_back(simulate::target_on("Earth", {3041.0, 0.0, 0.0}));
      const SteppedRows rows = rows_of(scene);
      SeriesOptions options;
      options.window = rows.acquisition->link.window;
      const ProfileSeries series = make_profiles(rows, options, one);
      ASSERT_EQ(series.rows.size(), 2u);
      EXPECT_EQ(series.scans.size(), 1u);
      for (const HeldTarget& target : hold_against_scene(rows, series, options, 1)) {
        ASSERT_TRUE(target.found) << target.truth.target;
        EXPECT_NEAR(target.expected_m, target.truth.range_m, 1e-9);
        EXPECT_NEAR(target.found->range_m, target.expected_m, 0.05 * cell_of(rows));
        // Chips of 154 ns, sampled every 100 ns, are not the same at every delay.
        EXPECT_NEAR(target.found->amplitude / target.truth.amplitude, 1.0,
                    kind == scene::Radar::Pulse::barker ? 0.1 : 0.05)
            << static_cast<int>(kind) << static_cast<int>(position) << target.truth.target;
      }
    }
}

TEST(ProfileSeries, IsTheSameOfARecordingRawOrCompressed) {
  for (const auto processing : {scene::Processing::raw, scene::Processing::matched_filter}) {
    scene::Scene scene = stepped_scene(0.02);
    make_chirped(scene);
    scene.radars[0].window = scene::Radar::Window::hamming;
    scene.simulations[0].range_end_m += 1600.0;  // Room for whole echoes.
    scene.simulations[0].processing = processing;
    scene.targets.push_back(simulate::target_on("Earth", {3003.3, 0.0, 0.0}));
    const auto acquisition = std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0));
    const simulate::Recording recording =
        simulate::record(simulate::plan_of(*acquisition, simulate::Engine::automatic));
    const SteppedRows rows = stepped_rows_of_recording(
        acquisition,
        core::rows_in_memory(std::span(recording.samples), acquisition->timing.rows, acquisition->reception.columns));
    SeriesOptions options;
    options.to_m = 3080.0;
    const ProfileSeries series = make_profiles(rows, options, one);
    const auto targets = hold_against_scene(rows, series, options, 0);
    ASSERT_TRUE(targets.at(0).found);
    EXPECT_NEAR(targets[0].found->range_m, 3003.3, 0.05 * cell_of(rows));
    EXPECT_NEAR(targets[0].found->amplitude / targets[0].truth.amplitude, 1.0, 0.05);
    EXPECT_NEAR(targets[0].found->width_m, 0.886 * cell_of(rows), 0.05 * cell_of(rows));
  }
}

TEST(ProfileSeries, ShowsTargetsWithTheReceiversGainOverTime) {
  for (const auto kind : {scene::Radar::Pulse::mono, scene::Radar::Pulse::chirp}) {
    scene::Scene scene = stepped_scene(0.02);
    if (kind == scene::Radar::Pulse::chirp) make_chirped(scene);
    scene.radars[0].stc = scene::Radar::Stc::range_law;
    scene.targets.push_back(simulate::target_on("Earth", {3003.3, 0.0, 0.0}));
    const SteppedRows rows = rows_of(scene);
    SeriesOptions options;
    options.window = rows.acquisition->link.window;
    const ProfileSeries series = make_profiles(rows, options, one);
    const std::vector<HeldTarget> held = hold_against_scene(rows, series, options, 1);
    ASSERT_EQ(held.size(), 1u);
    ASSERT_TRUE(held[0].found);
    EXPECT_NEAR(held[0].found->amplitude / held[0].truth.amplitude, 1.0, 0.05) << static_cast<int>(kind);
    // R^2 at the middle of an echo of 30 m undoes the spreading of R^2.
    if (kind == scene::Radar::Pulse::chirp) continue;
    const double wavelength_m = c / (9e9 + 15.5 * 5e6);
    EXPECT_NEAR(held[0].truth.amplitude / simulate::equation_amplitude(1.0, 1.0, wavelength_m), 1.01, 0.01);
  }
}

// Sidelobes at the end of a profile are no target behind it.
TEST(ProfileSeries, TargetsBesideItAreNotLookedFor) {
  scene::Scene scene = stepped_scene(0.02);
  for (const double x_m : {3000.0, 3100.0, 2900.0})
    scene.targets.push_back(simulate::target_on("Earth", {x_m, 0.0, 0.0}));
  const SteppedRows rows = rows_of(scene);
  const std::vector<HeldTarget> held = hold_against_scene(rows, make_profiles(rows, {}, one), {}, 0);
  ASSERT_EQ(held.size(), 3U);
  for (const HeldTarget& target : held) {
    EXPECT_EQ(target.outside, target.truth.target > 0) << target.truth.target;
    EXPECT_EQ(target.found.has_value(), target.truth.target == 0) << target.truth.target;
  }
}

TEST(ProfileSeries, IsHeldAgainstTheFirstThousandTargets) {
  scene::Scene scene = stepped_scene(0.02);
  for (int i = 0; i < 1100; ++i) scene.targets.push_back(simulate::target_on("Earth", {3000.0 + 0.01 * i, 0.0, 0.0}));
  const SteppedRows rows = rows_of(scene);
  const ProfileSeries series = make_profiles(rows, {}, one);
  const std::vector<HeldTarget> held = hold_against_scene(rows, series, {}, 0);
  ASSERT_EQ(held.size(), max_held_targets);
  EXPECT_EQ(held.back().truth.target, max_held_targets - 1);
}

TEST(FastestSearchedSpeed, IsTenThousandStepsOfAQuarterOfACellInABurst) {
  const SteppedRows rows = rows_of(stepped_scene());
  EXPECT_NEAR(fastest_searched_mps(rows), 10000.0 * 0.25 * cell_of(rows) / (31.0 / 4000.0), 1e-6);
}

TEST(MeanSpeed, IsThatOfSurfacesToo) {
  scene::Scene scene = stepped_scene();
  scene.platforms.push_back(simulate::moving("Ship", {3000.0, 0.0, 0.0}, {-7.0, 0.0, 0.0}));
  // Towards the radar and away from it: one of them shows it its back.
  scene.surfaces.push_back(
      {"Ship", {core::Vec3{0.0, -2.0, 0.0}, core::Vec3{0.0, 2.0, 0.0}, core::Vec3{0.0, 0.0, 4.0}}});
  scene.surfaces.push_back(
      {"Ship", {core::Vec3{0.0, 2.0, 0.0}, core::Vec3{0.0, -2.0, 0.0}, core::Vec3{0.0, 0.0, 4.0}}});
  const SteppedRows rows = rows_of(scene);
  EXPECT_NEAR(mean_speed_mps(rows, 0, rows.bursts), -7.0, 1e-3);
}

TEST(ProfileSeries, ShiftsAndSmearsMovingTargetsAndCompensatesThem) {
  scene::Scene scene = stepped_scene(0.1);
  scene.platforms.push_back(simulate::moving("Jet", {3010.0, 0.0, 0.0}, {4.0, 0.0, 0.0}));
  scene.targets.push_back(simulate::target_on("Jet", {0.0, 0.0, 0.0}));
  const SteppedRows rows = rows_of(scene);
  SeriesOptions options;
  const ProfileSeries plain = make_profiles(rows, options, one);
  const HeldTarget shifted = hold_against_scene(rows, plain, options, 3).at(0);
  EXPECT_NEAR(shifted.expected_m - shifted.truth.range_m, plain.centre_hz / 5e6 * 250e-6 * 4.0, 1e-6);
  EXPECT_NEAR(shifted.found.value().range_m, shifted.expected_m, 0.05 * cell_of(rows));
  for (const auto velocity :
       {SeriesOptions::Velocity::scene, SeriesOptions::Velocity::given, SeriesOptions::Velocity::estimated}) {
    options.velocity = velocity;
    options.speed_mps = 4.0;
    options.fastest_mps = 50.0;
    const ProfileSeries series = make_profiles(rows, options, one);
    EXPECT_NEAR(series.scans.at(0).speed_mps, 4.0, 0.5);
    EXPECT_EQ(series.scans[0].estimate.has_value(), velocity == SeriesOptions::Velocity::estimated);
    const HeldTarget target = hold_against_scene(rows, series, options, 3).at(0);
    EXPECT_NEAR(target.found.value().range_m, target.expected_m, 0.05 * cell_of(rows));
    EXPECT_NEAR(target.found->width_m, 0.886 * cell_of(rows), 0.02 * cell_of(rows));
  }
  // Aligned: where it is in the middle of the scan, in every profile.
  options.velocity = SeriesOptions::Velocity::given;
  options.align = true;
  const ProfileSeries aligned = make_profiles(rows, options, one);
  const double middle_s = 0.5 * (aligned.scans[0].from_s + aligned.scans[0].to_s);
  for (const std::size_t row : {std::size_t{0}, aligned.rows.size() - 1}) {
    const HeldTarget target = hold_against_scene(rows, aligned, options, row).at(0);
    EXPECT_NEAR(target.expected_m, 3010.0 + 4.0 * middle_s, 1e-3);
    EXPECT_NEAR(target.found.value().range_m, target.expected_m, 0.02 * cell_of(rows));
  }
}

TEST(ProfileSeries, HasAScanForEachSweepOfTheBeam) {
  scene::Scene scene = stepped_scene(2.0);
  scene::Radar& radar = scene.radars[0];
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(12.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(30.0);
  radar.beam = scene::Radar::Beam::rotating;
  radar.beam_rate = core::Angle::from_deg(360.0);
  scene.targets.push_back(simulate::target_on("Earth", {3000.0, 0.0, 0.0}));  // Azimuth 90 degrees: at 0.25 and 1.25 s.
  const SteppedRows rows = rows_of(scene);
  const ProfileSeries series = make_profiles(rows, {}, one);
  ASSERT_EQ(series.scans.size(), 2u);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_NEAR(0.5 * (series.scans[s].from_s + series.scans[s].to_s), 0.25 + static_cast<double>(s), 0.005);
    // 12 degrees at 360 degrees a second: 33 ms, four bursts of 8 ms.
    EXPECT_NEAR(series.scans[s].to_s - series.scans[s].from_s, 12.0 / 360.0, 0.009);
  }
  EXPECT_EQ(series.rows[typical_row(series)].scan, series.rows[typical_row(series)].burst > 125 ? 1u : 0u);
  const ProfileSeries scans = mean_of_scans(series);
  ASSERT_EQ(scans.rows.size(), 2u);
  const ProfileSeries encounter = mean_of_encounter(series);
  ASSERT_EQ(encounter.rows.size(), 1u);
  double power = 0.0;
  const auto bin = static_cast<std::size_t>(series.axis.index_of(3000.0));
  for (std::size_t i = 0; i < series.rows.size(); ++i) power += std::norm(series.row(i)[bin]);
  EXPECT_NEAR(std::norm(encounter.row(0)[bin]), power / static_cast<double>(series.rows.size()), 1e-9 * power);
}

// 0.8 m from burst to burst, and 100 m between the scans: aligned, neither widens the mean.
TEST(ProfileSeries, OfAnEncounterLaysItsScansUponEachOther) {
  scene::Scene scene = stepped_scene(2.0);
  scene::Radar& radar = scene.radars[0];
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(12.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(30.0);
  radar.beam = scene::Radar::Beam::rotating;
  radar.beam_rate = core::Angle::from_deg(360.0);
  scene.simulations[0].range_start_m = 2900.0;
  scene.simulations[0].range_end_m = 3200.0;
  scene.platforms.push_back(simulate::moving("Jet", {3150.0, 0.0, 0.0}, {-100.0, 0.0, 0.0}));
  scene.targets.push_back(simulate::target_on("Jet", {0.0, 0.0, 0.0}));
  scene.targets.push_back(simulate::target_on("Jet", {8.0, 0.0, 0.0}));
  const SteppedRows rows = rows_of(scene);
  SeriesOptions options;
  options.velocity = SeriesOptions::Velocity::scene;
  options.align = true;
  const ProfileSeries series = make_profiles(rows, options, one);
  ASSERT_EQ(series.scans.size(), 2u);
  const ProfileSeries mean = mean_of_encounter(series);
  const auto peaks = signal::highest_peaks(mean.row(0), mean.axis, 10, 2.0, 0.4);
  ASSERT_EQ(peaks.size(), 2u);
  EXPECT_NEAR(std::abs(peaks[0].range_m - peaks[1].range_m), 8.0, 0.1);
  for (const signal::ProfilePeak& peak : peaks) EXPECT_NEAR(peak.width_m, 0.886 * cell_of(rows), 0.15 * cell_of(rows));
}

TEST(ProfileSeries, DoesNotDependOnTheNumberOfThreads) {
  scene::Scene scene = stepped_scene(0.05);
  make_chirped(scene);
  scene.radars[0].noise_temperature_k = 300.0;
  scene.targets.push_back(simulate::target_on("Earth", {3003.3, 0.0, 0.0}));
  const SteppedRows rows = rows_of(scene);
  SeriesOptions options;
  options.velocity = SeriesOptions::Velocity::estimated;
  options.fastest_mps = 30.0;
  const ProfileSeries first = make_profiles(rows, options, one);
  const ProfileSeries second = make_profiles(rows, options, {3, nullptr});
  EXPECT_EQ(first.values, second.values);
}

TEST(ProfileSeries, IsEmptyWithoutTargetsThatEcho) {
  scene::Scene scene = stepped_scene();
  scene.targets.push_back(simulate::target_on("Earth", {3000.0, 0.0, 0.0}));
  scene.targets.back().rcs_m2 = 0.0;
  EXPECT_TRUE(make_profiles(rows_of(scene), {}, one).rows.empty());
}

TEST(ProblemsOfStepped, SayWhatKeepsARecordingFromBeingUsed) {
  const auto problems = [](scene::Scene scene, SteppedUse use = SteppedUse::profiles, bool recorded = false) {
    return text_of(problems_of_stepped(simulate::acquisition_of(scene, 0), use, recorded));
  };
  scene::Scene scene = stepped_scene();
  EXPECT_EQ(problems(scene), "");
  scene.radars[0].carrier = scene::Radar::Carrier::single;
  EXPECT_THAT(problems(scene), HasSubstr("at least two frequency steps"));
  EXPECT_THAT(problems(scene, SteppedUse::isar), HasSubstr("no range resolution"));
  make_chirped(scene);
  EXPECT_EQ(problems(scene, SteppedUse::isar), "");
  scene.radars[0].carrier = scene::Radar::Carrier::user;
  scene.radars[0].carrier_list_hz.part[0].knots = {{0.0, 9e9}, {1.0, 9.1e9}, {2.0, 9.25e9}};
  EXPECT_THAT(problems(scene, SteppedUse::isar), HasSubstr("evenly"));
  scene = stepped_scene(0.007);
  EXPECT_THAT(problems(scene), HasSubstr("no whole burst"));
  scene = stepped_scene();
  scene.simulations[0].processing = scene::Processing::srp;
  EXPECT_THAT(problems(scene, SteppedUse::profiles, true), HasSubstr("range profiles already"));
  scene = stepped_scene();
  make_chirped(scene);
  scene.options.profile = scene::Profile::classic;
  scene.simulations[0].processing = scene::Processing::matched_filter;
  EXPECT_THAT(problems(scene, SteppedUse::profiles, true), HasSubstr("classic profile"));
  EXPECT_EQ(problems(scene, SteppedUse::profiles, false), "");
}

TEST(RemarksOnStepped, SayWhatMakesProfilesAmbiguousOrBlurred) {
  const auto remarks = [](const scene::Scene& scene, std::optional<double> speed = {}) {
    return text_of(diagnose_stepped(rows_of(scene), SteppedUse::profiles, speed));
  };
  scene::Scene scene = stepped_scene(0.064 - 1.0 / 4000.0);
  scene.targets.push_back(simulate::target_on("Earth", {3000.0, 0.0, 0.0}));
  EXPECT_EQ(remarks(scene), "");
  scene::Scene gaps = scene;
  make_chirped(gaps);
  gaps.radars[0].bandwidth_hz = 4e6;
  EXPECT_THAT(remarks(gaps), HasSubstr("the joined band has gaps"));
  scene::Scene folds = scene;
  folds.radars[0].pulse_width_s = 300e-9;
  EXPECT_THAT(remarks(folds), HasSubstr("targets may alias"));
  EXPECT_THAT(remarks(folds), testing::Not(HasSubstr("extend farther")));
  folds.targets.push_back(simulate::target_on("Earth", {3040.0, 0.0, 0.0}));
  EXPECT_THAT(remarks(folds), HasSubstr("the targets extend farther than the unambiguous length of a profile"));
  scene::Scene sparse = scene;
  sparse.simulations[0].sample_rate_hz = 4e6;
  EXPECT_THAT(remarks(sparse), HasSubstr("targets between them are lost"));
  scene::Scene fast = scene;
  fast.platforms.push_back(simulate::moving("Jet", {3010.0, 0.0, 0.0}, {-100.0, 0.0, 0.0}));
  fast.targets[0].platform = "Jet";
  fast.targets[0].position_m = {};
  EXPECT_THAT(remarks(fast), HasSubstr("targets move during a burst"));
  EXPECT_THAT(remarks(fast), HasSubstr("they are lost"));
  EXPECT_EQ(remarks(fast, -100.0), "");
  EXPECT_THAT(remarks(fast, 50.0), HasSubstr("beyond the speed that is compensated"));
  scene.simulations[0].time_end_s = 0.06;
  EXPECT_THAT(remarks(scene), HasSubstr("incomplete bursts"));
}

TEST(SeenFromPlatform, HasVelocitiesThatAreTheDerivativesOfItsPositions) {
  scene::Scene scene = stepped_scene(0.03);
  scene.platforms.push_back(simulate::moving("Ship", {3000.0, 50.0, 20.0}, {30.0, -8.0, 2.0}));
  scene.platforms.back().rotation_rate = {core::Angle::from_deg(2.0), core::Angle::from_deg(-3.0),
                                          core::Angle::from_deg(5.0)};
  scene.targets.push_back(simulate::target_on("Ship", {}));
  const SteppedRows rows = rows_of(scene);
  const auto seen = seen_from_platform(rows, 1, 0, 3);
  ASSERT_EQ(seen.size(), 96u);
  const double interval_s = seen[41].time_s - seen[39].time_s;
  const core::Vec3 slope = (1.0 / interval_s) * (seen[41].position_m - seen[39].position_m);
  EXPECT_LT(core::norm(slope - seen[40].velocity_mps), 1e-3);
  EXPECT_GT(core::norm(seen[40].velocity_mps), 200.0);  // 5 degrees a second, 3 km away.
}

TEST(PlatformOfTargets, CarriesTheStrongestAndIsNotTheRadars) {
  scene::Scene scene = stepped_scene();
  scene.platforms.push_back(simulate::resting("Ship", {3000.0, 0.0, 0.0}));
  scene.platforms.push_back(simulate::resting("Buoy", {3020.0, 0.0, 0.0}));
  EXPECT_FALSE(platform_of_targets(*rows_of(scene).acquisition));
  scene.targets.push_back(simulate::target_on("Earth", {3000.0, 0.0, 0.0}));
  EXPECT_FALSE(platform_of_targets(*rows_of(scene).acquisition));
  scene.targets.push_back(simulate::target_on("Buoy", {}));
  scene.targets.push_back(simulate::target_on("Ship", {}));
  scene.targets.back().rcs_m2 = 3.0;
  EXPECT_EQ(platform_of_targets(*rows_of(scene).acquisition), 1u);
}

}  // namespace stepped_rows_test
}  // namespace sarsim::workflow

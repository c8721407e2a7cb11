#include <cmath>
#include <functional>

#include "scene/check/check_test_scene.hpp"

namespace sarsim::scene {
namespace check_recording_test {

using testing::HasSubstr;

Scene with_simulation(const std::function<void(Simulation&)>& change) {
  Scene scene = sound_scene();
  change(scene.simulations[0]);
  return scene;
}

core::Subject simulation_field(const char* field) { return {"simulation", 0, field}; }

Scene with_times(double start_s, double end_s) {
  return with_simulation([=](Simulation& s) { s.time_start_s = start_s, s.time_end_s = end_s; });
}

TEST(CheckRecording, RefusesAnEmptyRangeWindow) {
  for (const double end_m : {10010.0, 10000.0})
    expect_error(with_simulation([&](Simulation& s) { s.range_end_m = end_m; }), simulation_field("range_end_m"));
  Scene scene = sound_scene();
  scene.geometries[0].range_start_m = scene.geometries[0].range_end_m;
  expect_error(scene, {"geometry", 0, "range_end_m"});
}

TEST(CheckRecording, RefusesAWindowThatEndsBeforeItStarts) {
  expect_error(with_times(0.5, 0.4), simulation_field("time_end_s"));
  Scene scene = sound_scene();
  scene.geometries[0].time_end_s = -0.1;
  expect_error(scene, {"geometry", 0, "time_end_s"});
}

TEST(CheckRecording, AcceptsAWindowOfOneInstantThatHoldsAPulse) {
  EXPECT_TRUE(check(with_times(0.0, 0.0)).empty());
  EXPECT_TRUE(check(with_times(0.01, 0.01)).empty()) << "pulse 3 of 300 Hz";
}

// Pulse 1 leaves at 3.333 ms, pulse 2 at 6.667 ms.
TEST(CheckRecording, RefusesAWindowBetweenTwoPulsesAndNamesThem) {
  const core::Problem problem = expect_error(with_times(4e-3, 6e-3), simulation_field("time_end_s"));
  EXPECT_THAT(problem.message, HasSubstr("no pulse"));
  EXPECT_THAT(problem.expected, HasSubstr("3.33333 ms or 6.66667 ms"));
  Scene scene = sound_scene();
  scene.geometries[0].time_start_s = 4e-3;
  scene.geometries[0].time_end_s = 6e-3;
  expect_error(scene, {"geometry", 0, "time_end_s"});
}

// T(n) = 0, 1, 3, 6, 7, 9, 12 ms ... for intervals of 1, 2, 3 ms; also T(-1) = -3 ms.
TEST(CheckRecording, CountsThePulsesOfUserIntervals) {
  const auto scene_of = [](double start_s, double end_s) {
    Scene scene = with_times(start_s, end_s);
    scene.radars[0].repetition = Radar::Repetition::user;
    scene.radars[0].pri_s.part[0] = points({{0.0, 1e-3}, {1.0, 2e-3}, {2.0, 3e-3}});
    return scene;
  };
  for (const double at_s : {-3e-3, 0.0, 1e-3, 3e-3, 6e-3, 7e-3, 60e-3})
    EXPECT_TRUE(check(scene_of(at_s, at_s)).empty()) << at_s;
  for (const double from_s : {-3e-3, 1e-3, 3e-3, 7e-3})
    expect_error(scene_of(from_s + 0.1e-3, from_s + 1.9e-3), simulation_field("time_end_s"));
  expect_error(scene_of(6e6 + 3.1e-3, 6e6 + 5.9e-3), simulation_field("time_end_s"));
}

TEST(CheckRecording, RefusesAWindowTooFarFromZeroToNumberItsPulses) {
  EXPECT_THAT(expect_error(with_times(1e17, 2e17), simulation_field("time_end_s")).message,
              HasSubstr("number its pulses"));
  EXPECT_THAT(expect_error(with_times(-1e17, 0.0), simulation_field("time_end_s")).message,
              HasSubstr("number its pulses"));
}

TEST(CheckRecording, RefusesARecordingOfMoreSamplesThanCanBeCounted) {
  const core::Problem problem = expect_error(with_times(0.0, 1e13), simulation_field("time_end_s"));
  EXPECT_THAT(problem.message, HasSubstr("1.5e+18 samples cannot be made"));
  EXPECT_FALSE(core::has_errors(check(with_times(0.0, 1e10)))) << "3e12 pulses of 500 samples are many, but countable";
}

TEST(CheckRecording, RefusesARowThatNoMemoryHolds) {
  const auto rows_of = [](double samples) {
    return with_simulation([=](Simulation& s) {
      s.time_end_s = s.time_start_s;
      s.range_end_m = s.range_start_m + samples * 299792458.0 / (2.0 * s.sample_rate_hz);
    });
  };
  EXPECT_FALSE(core::has_errors(check(rows_of(9.9e6))));
  EXPECT_THAT(expect_error(rows_of(1.1e7), simulation_field("range_end_m")).message, HasSubstr("too long"));
}

TEST(CheckRecording, RefusesAPulseThatNoMemoryHoldsWhereItIsKept) {
  Scene scene = with_simulation([](Simulation& s) { s.time_end_s = s.time_start_s; });
  scene.radars[0].pulse_width_s = 1.1e7 / scene.simulations[0].sample_rate_hz;
  EXPECT_FALSE(core::has_errors(check(scene)));
  scene.simulations[0].processing = Processing::matched_filter;
  EXPECT_THAT(check(scene)[0].message, HasSubstr("a pulse of 1.1e+07 samples is too long"));
}

// The filter that keeps the band of a long pulse is a hundred times as long as the pulse.
TEST(CheckRecording, RefusesABandLimitedPulseWhoseFilterNoMemoryHolds) {
  Scene scene = with_simulation([](Simulation& s) { s.time_end_s = s.time_start_s; });
  scene.options.pulse = PulseDefinition::band_limited;
  scene.radars[0].pulse = Radar::Pulse::mono;
  scene.radars[0].pulse_width_s = 2e5 / scene.simulations[0].sample_rate_hz;
  EXPECT_FALSE(core::has_errors(check(scene)));
  scene.simulations[0].oversampling = 2.0;
  EXPECT_THAT(check(scene)[0].message, HasSubstr("is too long"));
}

TEST(CheckRecording, RefusesARangeWindowWithoutSample) {
  // floor(2 fs length/c + 1/2) is 0 below c/(4 fs) = 0.49965 m and 1 from there on.
  const auto length = [](double m) {
    return with_simulation([=](Simulation& s) { s.range_end_m = s.range_start_m + m; });
  };
  EXPECT_THAT(expect_error(length(0.499), simulation_field("sample_rate_hz")).expected, HasSubstr("0.4997 m"));
  EXPECT_TRUE(check(length(0.5)).empty());
}

TEST(CheckRecording, RefusesASamplingFrequencyThatIsNotAboveZero) {
  for (const double rate_hz : {0.0, -1.0})
    expect_error(with_simulation([&](Simulation& s) { s.sample_rate_hz = rate_hz; }),
                 simulation_field("sample_rate_hz"));
}

TEST(CheckRecording, HoldsTheBitsBetween1And64AndWarnsAbove53) {
  for (const int bits : {1, 8, 53})
    EXPECT_TRUE(check(with_simulation([&](Simulation& s) { s.bits = bits; })).empty()) << bits;
  for (const int bits : {54, 64})
    expect_warning(with_simulation([&](Simulation& s) { s.bits = bits; }), simulation_field("bits"));
  for (const int bits : {0, 65, -8})
    expect_error(with_simulation([&](Simulation& s) { s.bits = bits; }), simulation_field("bits"));
}

TEST(CheckRecording, RefusesANegativeLsbAndFactorsOutOfRange) {
  expect_error(with_simulation([](Simulation& s) { s.lsb_v = -1e-9; }), simulation_field("lsb_v"));
  for (const double factor : {0.99, 1e-300, 101.0}) {
    expect_error(with_simulation([&](Simulation& s) { s.oversampling = factor; }), simulation_field("oversampling"));
    expect_error(with_simulation([&](Simulation& s) { s.width_factor = factor; }), simulation_field("width_factor"));
  }
  EXPECT_FALSE(core::has_errors(check(with_simulation([](Simulation& s) { s.oversampling = 100.0; }))));
}

TEST(CheckRecording, NotesFactorsThatDoNothingToAnIdealPulse) {
  Scene scene = with_simulation([](Simulation& s) { s.oversampling = 5.0, s.width_factor = 2.0; });
  const core::Problem both = expect_single(scene, core::Severity::note, simulation_field("oversampling"));
  EXPECT_EQ(both.found, "5 and 2");
  EXPECT_THAT(both.hint, HasSubstr("PULSE BAND_LIMITED"));
  scene.options.profile = Profile::classic;
  expect_single(scene, core::Severity::note, simulation_field("oversampling"));
  scene.simulations[0].oversampling = 1.0;
  const core::Problem length = expect_single(scene, core::Severity::note, simulation_field("width_factor"));
  EXPECT_THAT(length.hint, HasSubstr("a factor above 1"));
}

TEST(CheckRecording, SaysNothingOfFactorsThatShapeTheirPulseOrAreOne) {
  Scene scene = with_simulation([](Simulation& s) { s.oversampling = 5.0, s.width_factor = 2.4; });
  scene.options.pulse = PulseDefinition::band_limited;
  EXPECT_TRUE(check(scene).empty());
  EXPECT_TRUE(check(with_simulation([](Simulation& s) { s.oversampling = 1.0, s.width_factor = 1.0; })).empty());
}

TEST(CheckRecording, RefusesOutputWithoutAFileName) {
  for (const char* file : {"", ".", "..", "out/", "c:\\data\\", "out/."}) {
    expect_error(with_simulation([&](Simulation& s) { s.file = file; }), simulation_field("file"));
    Scene scene = sound_scene();
    scene.geometries[0].file = file;
    expect_error(scene, {"geometry", 0, "file"});
  }
}

TEST(CheckRecording, WarnsOfAFileNameThatIsUsedTwiceWhateverTheFolder) {
  Scene scene = sound_scene();
  scene.simulations[0].file = "out/same.dat";
  scene.simulations.push_back(scene.simulations[0]);
  scene.simulations[1].file = "d:\\old\\same.dat";
  EXPECT_THAT(expect_warning(scene, {"simulation", 1, "file"}).hint, HasSubstr("same-2.dat"));
  scene.simulations.pop_back();
  scene.geometries[0].file = "same.dat";
  expect_warning(scene, {"geometry", 0, "file"});
}

TEST(CheckRecording, NumbersEveryRepetitionOfAFileName) {
  Scene scene = sound_scene();
  scene.simulations.resize(3, scene.simulations[0]);
  for (Simulation& simulation : scene.simulations) simulation.file = "plain";
  const core::Problems problems = check(scene);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_THAT(problems[0].hint, HasSubstr("plain-2."));
  EXPECT_THAT(problems[1].hint, HasSubstr("plain-3."));
}

TEST(CheckRecording, HoldsTheChoiceOfColumnsInAByte) {
  for (const int columns : {-1, 256}) {
    Scene scene = sound_scene();
    scene.geometries[0].columns = columns;
    expect_error(scene, {"geometry", 0, "columns"});
  }
}

// 32 chips of 62.5 ns, by turns 1 and -1: lines at 8 MHz, of which little is left at a sampling of 10 MHz.
TEST(CheckRecording, WarnsOfSamplingFarBelowTheBandOfAUserPulse) {
  Scene scene = sound_scene();
  Radar& radar = scene.radars[0];
  radar.pulse = Radar::Pulse::user;
  radar.pulse_width_s = 2e-6;
  radar.pulse_iq.part[0].method = core::Interpolation::linear;
  for (int chip = 0; chip < 32; ++chip)
    for (const double edge : {0.001, 0.999})
      radar.pulse_iq.part[0].knots.push_back({(chip + edge) / 32.0, chip % 2 == 0 ? 1.0 : -1.0});
  radar.pulse_iq.part[1].knots = {{0.0, 0.0}};
  scene.simulations[0].sample_rate_hz = 10e6;
  const core::Problem problem = expect_warning(scene, simulation_field("sample_rate_hz"));
  EXPECT_THAT(problem.message, HasSubstr("below the bandwidth of the pulse"));
  EXPECT_THAT(problem.expected, HasSubstr("which contains 90 % of its energy"));
  scene.simulations[0].sample_rate_hz = 100e6;
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckRecording, WarnsOfSamplingBelowTheBandwidthAndSaysWhatFolds) {
  const core::Problem problem = expect_warning(with_simulation([](Simulation& s) { s.sample_rate_hz = 80e6; }),
                                               simulation_field("sample_rate_hz"));
  EXPECT_EQ(problem.found, "80 MHz");
  EXPECT_EQ(problem.expected, "at least 100 MHz");
  EXPECT_THAT(problem.hint, HasSubstr("outer 20 MHz"));
  EXPECT_THAT(problem.hint, HasSubstr("alias back"));
  expect_single(with_simulation([](Simulation& s) { s.sample_rate_hz = 100e6; }), core::Severity::note,
                simulation_field("sample_rate_hz"));
}

TEST(CheckRecording, SaysThatABandLimitedPulseLosesWhatAnIdealOneFolds) {
  Scene scene = with_simulation([](Simulation& s) { s.sample_rate_hz = 80e6; });
  scene.options.pulse = PulseDefinition::band_limited;
  EXPECT_THAT(expect_warning(scene, simulation_field("sample_rate_hz")).hint, HasSubstr("cut off"));
}

// 5 us: 1/Tp rounds to just above 200 kHz or below; sampling at exactly that rate is not a mistake.
TEST(CheckRecording, TakesRoundingForNoAliasing) {
  for (const double width_us : {3.0, 5.0, 7.0, 9.0}) {
    Scene scene = with_simulation([&](Simulation& s) { s.sample_rate_hz = std::nextafter(1e6 / width_us, 0.0); });
    scene.simulations[0].range_end_m = 20e3;
    scene.radars[0].pulse = Radar::Pulse::mono;
    scene.radars[0].pulse_width_s = width_us * 1e-6;
    EXPECT_TRUE(check(scene).empty()) << width_us;
  }
}

TEST(CheckRecording, WarnsOfAWindowBeyondTheUnambiguousRange) {
  // c/(2 300 Hz) = 499654.1 m.
  const auto until = [](double end_m) {
    return with_simulation([=](Simulation& s) { s.range_start_m = 499e3, s.range_end_m = end_m; });
  };
  EXPECT_TRUE(check(until(499654.0)).empty());
  const core::Problem problem = expect_warning(until(499655.0), simulation_field("range_end_m"));
  EXPECT_THAT(problem.expected, HasSubstr("499654 m"));
  EXPECT_THAT(problem.hint, HasSubstr("after the next pulse is sent"));
}

TEST(CheckRecording, WarnsOfAWindowThatStartsBehindTheRadar) {
  expect_warning(with_simulation([](Simulation& s) { s.range_start_m = -10.0, s.range_end_m = 100.0; }),
                 simulation_field("range_start_m"));
}

Scene profile_scene() {
  Scene scene = with_simulation([](Simulation& s) {
    s.processing = Processing::srp;
    s.sample_rate_hz = 20e6;
    s.time_start_s = 0.0;
    s.time_end_s = 0.5;
  });
  Radar& radar = scene.radars[0];
  radar.pulse = Radar::Pulse::mono;
  radar.pulse_width_s = 100e-9;
  radar.carrier = Radar::Carrier::stepped;
  radar.carrier_step_hz = 10e6;
  radar.carrier_steps = 16;
  radar.pulses_per_step = 2;
  return scene;
}

TEST(CheckProfile, FindsNothingInASoundProfile) { EXPECT_TRUE(check(profile_scene()).empty()); }

TEST(CheckProfile, NeedsASteppedCarrier) {
  Scene scene = profile_scene();
  scene.radars[0].carrier = Radar::Carrier::single;
  EXPECT_THAT(expect_error(scene, simulation_field("processing")).found, HasSubstr("does not step"));
}

TEST(CheckProfile, NeedsTwoStepsThatDiffer) {
  Scene scene = profile_scene();
  scene.radars[0].carrier_steps = 1;
  expect_error(scene, simulation_field("processing"));
  scene = profile_scene();
  scene.radars[0].carrier_step_hz = 0.0;
  expect_error(scene, simulation_field("processing"));
}

// A burst takes 32 pulses: pulses 0 to 31, or 32 to 63.
TEST(CheckProfile, NeedsACompleteBurst) {
  const auto pulses = [](double first, double last) {
    Scene scene = profile_scene();
    scene.simulations[0].time_start_s = first / 300.0;
    scene.simulations[0].time_end_s = last / 300.0;
    return scene;
  };
  EXPECT_TRUE(check(pulses(0.0, 31.0)).empty());
  EXPECT_TRUE(check(pulses(-32.0, -1.0)).empty());
  EXPECT_TRUE(check(pulses(5.0, 63.0)).empty());
  EXPECT_THAT(expect_error(pulses(0.0, 30.0), simulation_field("time_end_s")).expected, HasSubstr("all 32 pulses"));
  expect_error(pulses(1.0, 62.0), simulation_field("time_end_s"));
  expect_error(pulses(-32.0, -2.0), simulation_field("time_end_s"));
}

TEST(CheckProfile, WarnsOfAModulatedPulse) {
  Scene scene = profile_scene();
  scene.radars[0].pulse = Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 10e6;
  EXPECT_EQ(expect_warning(scene, simulation_field("processing")).found, "a chirp");
  scene.radars[0].pulse = Radar::Pulse::barker;
  scene.radars[0].barker_code = 0;
  EXPECT_EQ(expect_warning(scene, simulation_field("processing")).found, "a Barker code");
}

TEST(CheckProfile, WarnsOfStepsTooWideForThePulse) {
  Scene scene = profile_scene();
  scene.radars[0].carrier_step_hz = 12.5e6;
  const core::Problem problem = expect_warning(scene, simulation_field("processing"));
  EXPECT_EQ(problem.found, "profile of 11.99 m, pulse of 14.99 m");
  EXPECT_EQ(problem.expected, "steps up to 10 MHz or a pulse up to 80 ns");
  scene.radars[0].carrier_step_hz = -12.5e6;
  expect_warning(scene, simulation_field("processing"));
}

TEST(CheckProfile, SaysNothingMoreAboutAFaultyCarrier) {
  Scene scene = profile_scene();
  scene.radars[0].pulses_per_step = 0;
  expect_error(scene, {"radar", 0, "pulses_per_step"});
}

}  // namespace check_recording_test
}  // namespace sarsim::scene

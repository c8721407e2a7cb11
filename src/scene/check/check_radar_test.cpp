#include <functional>
#include <limits>

#include "scene/check/check_objects.hpp"
#include "scene/check/check_test_scene.hpp"
#include "scene/model/radar_pulse.hpp"

namespace sarsim::scene {
namespace check_radar_test {

using testing::HasSubstr;

Scene with_radar(const std::function<void(Radar&)>& change) {
  Scene scene = sound_scene();
  change(scene.radars[0]);
  return scene;
}

core::Subject radar_field(const char* field) { return {"radar", 0, field}; }

TEST(CheckRadar, RefusesAPulseWidthThatIsNotAboveZero) {
  for (const double width_s : {0.0, -1e-6})
    expect_error(with_radar([&](Radar& r) { r.pulse_width_s = width_s; }), radar_field("pulse_width_s"));
}

TEST(CheckRadar, SaysTheOffendingValueWithItsUnit) {
  EXPECT_EQ(expect_error(with_radar([](Radar& r) { r.pulse_width_s = -800e-9; }), radar_field("pulse_width_s")).found,
            "-800 ns");
  EXPECT_EQ(
      expect_error(with_radar([](Radar& r) { r.losses = core::PowerRatio::from_db(-3.0); }), radar_field("losses"))
          .found,
      "-3 dB");
}

TEST(CheckRadar, RefusesNegativePowerLossesTemperatureAndRamps) {
  expect_error(with_radar([](Radar& r) { r.power_w = -1.0; }), radar_field("power_w"));
  expect_error(with_radar([](Radar& r) { r.noise_temperature_k = -290.0; }), radar_field("noise_temperature_k"));
  expect_error(with_radar([](Radar& r) { r.rise_s = -1e-9; }), radar_field("rise_s"));
  expect_error(with_radar([](Radar& r) { r.fall_s = -1e-9; }), radar_field("fall_s"));
}

TEST(CheckRadar, AcceptsADownChirpAndGainsOfEitherSign) {
  const Scene scene = with_radar([](Radar& r) {
    r.bandwidth_hz = -100e6;
    r.transmit_gain = core::PowerRatio::from_db(-3.0);
    r.receive_gain = core::PowerRatio::from_db(30.0);
    r.beam_rate = core::Angle::from_deg(-24.0);
  });
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckRadar, WarnsOfAChirpWithoutBandwidth) {
  expect_warning(with_radar([](Radar& r) { r.bandwidth_hz = 0.0; }), radar_field("bandwidth_hz"));
}

TEST(CheckRadar, KnowsTheBarkerCodes) {
  for (const int code : {0, 6})
    EXPECT_TRUE(check(with_radar([&](Radar& r) { r.pulse = Radar::Pulse::barker, r.barker_code = code; })).empty());
  for (const int code : {-1, 7})
    expect_error(with_radar([&](Radar& r) { r.pulse = Radar::Pulse::barker, r.barker_code = code; }),
                 radar_field("barker_code"));
}

TEST(CheckRadar, NeedsAUserPulseThatTransmitsSomething) {
  Scene scene = with_radar([](Radar& r) { r.pulse = Radar::Pulse::user; });
  EXPECT_EQ(check(scene).size(), 2U) << "I and Q";
  EXPECT_TRUE(core::has_errors(check(scene)));
  scene.radars[0].pulse_iq.part[0] = points({{0.0, 1.0}, {1.0, 1.0}});
  EXPECT_THAT(expect_warning(scene, radar_field("pulse_iq")).message, HasSubstr("pulse Q"));
  scene.radars[0].pulse_iq.part[1] = points({{0.0, 0.0}});
  EXPECT_TRUE(check(scene).empty());
  scene.radars[0].pulse_iq.part[0] = points({{0.0, 0.0}, {1.0, 0.0}});
  EXPECT_THAT(expect_error(scene, radar_field("pulse_iq")).message, HasSubstr("zero throughout"));
}

TEST(CheckRadar, NeedsAUserEnvelopeThatLetsSomethingPass) {
  Scene scene = with_radar([](Radar& r) { r.envelope = Radar::Envelope::user; });
  expect_error(scene, radar_field("envelope_gain"));
  scene.radars[0].envelope_gain.part[0] = points({{0.0, 0.0}, {1.0, 0.0}});
  EXPECT_THAT(expect_error(scene, radar_field("envelope_gain")).message, HasSubstr("zero throughout"));
  scene.radars[0].envelope_gain.part[0] = points({{0.0, 0.0}, {1.0, 1.0}});
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckRadar, WarnsOfRampsThatDoNotFitThePulse) {
  const auto ramps = [](double rise_s, double fall_s) {
    return with_radar([=](Radar& r) { r.envelope = Radar::Envelope::linear, r.rise_s = rise_s, r.fall_s = fall_s; });
  };
  EXPECT_TRUE(check(ramps(300e-9, 500e-9)).empty());
  EXPECT_THAT(expect_warning(ramps(300e-9, 600e-9), radar_field("rise_s")).found, HasSubstr("300 ns and 600 ns"));
}

TEST(CheckRadar, RefusesARepetitionFrequencyThatIsNotAboveZero) {
  for (const double prf_hz : {0.0, -300.0})
    expect_error(with_radar([&](Radar& r) { r.prf_hz = prf_hz; }), radar_field("prf_hz"));
}

// A script cannot say it either (FieldSpec::range).
TEST(CheckRadar, RefusesARepetitionFrequencyThatIsTooSmallForAScript) {
  const core::Problem problem = expect_error(with_radar([](Radar& r) { r.prf_hz = 1e-6; }), radar_field("prf_hz"));
  EXPECT_EQ(problem.message, "the pulse repetition frequency is too small");
  EXPECT_EQ(problem.found, "1 uHz");
  EXPECT_EQ(problem.expected, "at least 10 uHz");
}

TEST(CheckRadar, NeedsAListOfIntervalsAboveZeroInAnyOrderOfX) {
  Scene scene = with_radar([](Radar& r) { r.repetition = Radar::Repetition::user; });
  EXPECT_THAT(expect_error(scene, radar_field("pri_s")).message, HasSubstr("has no points"));
  scene.radars[0].pri_s.part[0] = points({{5.0, 3e-3}, {0.0, 2e-3}, {0.0, 4e-3}});
  EXPECT_TRUE(check(scene).empty());
  for (const double interval_s : {0.0, -1e-3}) {
    scene.radars[0].pri_s.part[0].knots[1].y = interval_s;
    EXPECT_THAT(expect_error(scene, radar_field("pri_s")).found, HasSubstr("entry 2"));
  }
}

TEST(CheckRadar, WarnsOfAPulseLongerThanTheShortestInterval) {
  Scene scene = with_radar([](Radar& r) {
    r.repetition = Radar::Repetition::user;
    r.pri_s.part[0] = points({{0.0, 3e-3}, {1.0, 1e-3}});
    r.pulse_width_s = 1.5e-3;
  });
  EXPECT_THAT(expect_warning(scene, radar_field("pulse_width_s")).found, HasSubstr("1.5 ms in an interval of 1 ms"));
  scene.radars[0].pulse_width_s = 1e-3;
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckRadar, RefusesCarriersThatAreNotAboveZero) {
  using Carrier = Radar::Carrier;
  for (const Carrier carrier : {Carrier::single, Carrier::stepped})
    expect_error(with_radar([&](Radar& r) { r.carrier = carrier, r.carrier_hz = 0.0; }), radar_field("carrier_hz"));
  Scene scene = with_radar([](Radar& r) { r.carrier = Carrier::user; });
  EXPECT_THAT(expect_error(scene, radar_field("carrier_list_hz")).message, HasSubstr("has no points"));
  scene.radars[0].carrier_list_hz.part[0] = points({{0.0, 1e9}, {0.0, 0.0}});
  EXPECT_THAT(expect_error(scene, radar_field("carrier_list_hz")).found, HasSubstr("entry 2: 0 Hz"));
}

TEST(CheckRadar, RefusesStepsThatLeadBelowZero) {
  Scene scene = with_radar([](Radar& r) {
    r.carrier = Radar::Carrier::stepped;
    r.carrier_hz = 1e9;
    r.carrier_step_hz = -0.1e9;
    r.carrier_steps = 10;
  });
  EXPECT_TRUE(check(scene).empty()) << "the last carrier is 0.1 GHz";
  scene.radars[0].carrier_steps = 11;
  expect_error(scene, radar_field("carrier_step_hz"));
}

TEST(CheckRadar, RefusesFewerThanOneStepOrPulse) {
  expect_error(with_radar([](Radar& r) { r.carrier = Radar::Carrier::stepped, r.carrier_steps = 0; }),
               radar_field("carrier_steps"));
  expect_error(with_radar([](Radar& r) { r.carrier = Radar::Carrier::stepped, r.pulses_per_step = 0; }),
               radar_field("pulses_per_step"));
}

TEST(CheckRadar, HoldsBeamWidthsBetweenZeroAndAFullCircle) {
  for (const double width_deg : {0.0, -1.0, 361.0}) {
    const core::Angle width = core::Angle::from_deg(width_deg);
    expect_error(with_radar([&](Radar& r) { r.transmit_antenna.azimuth_beamwidth = width; }),
                 radar_field("transmit_antenna.azimuth_beamwidth"));
    EXPECT_TRUE(check(with_radar([&](Radar& r) { r.receive_antenna.azimuth_beamwidth = width; })).empty())
        << "an antenna that is not used";
    const Scene scene = with_radar([&](Radar& r) {
      r.same_antenna = false;
      r.receive_antenna.pattern = Antenna::Pattern::sinx;
      r.receive_antenna.elevation_beamwidth = width;
    });
    EXPECT_THAT(expect_error(scene, radar_field("receive_antenna.elevation_beamwidth")).message,
                HasSubstr("elevation beam width"));
  }
}

TEST(CheckRadar, NeedsBothCutsOfAUserAntenna) {
  Scene scene = with_radar([](Radar& r) {
    r.transmit_antenna.pattern = Antenna::Pattern::user;
    r.transmit_antenna.gain_db.part[0] = points({{0.0, 0.0}, {180.0, -40.0}});
  });
  EXPECT_THAT(expect_error(scene, radar_field("transmit_antenna")).message, HasSubstr("elevation cut"));
  scene.radars[0].transmit_antenna.gain_db.part[1] = points({{180.0, 0.0}, {0.0, -40.0}});
  EXPECT_THAT(expect_error(scene, radar_field("transmit_antenna")).message, HasSubstr("do not ascend"));
  scene.radars[0].transmit_antenna.gain_db.part[1] = points({{0.0, 0.0}});
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckRadar, WarnsOfABeamDirectionWithoutPoints) {
  Scene scene = with_radar([](Radar& r) {
    r.beam = Radar::Beam::user;
    r.beam_target_world_m.part = {points({{0.0, 1.0}}), points({{0.0, 1.0}}), points({})};
  });
  EXPECT_THAT(expect_warning(scene, radar_field("beam_target_world_m")).message, HasSubstr("beam direction Z"));
}

TEST(CheckRadar, HoldsTheHanningConstantBetweenZeroAndOne) {
  for (const double pedestal : {-0.1, 1.1})
    expect_error(with_radar([&](Radar& r) { r.window = Radar::Window::hanning, r.hanning_pedestal = pedestal; }),
                 radar_field("hanning_pedestal"));
  EXPECT_TRUE(check(with_radar([](Radar& r) { r.hanning_pedestal = 5.0; })).empty()) << "not in use";
}

TEST(CheckRadar, NeedsAUserWindowThatLetsSomethingPass) {
  Scene scene = with_radar([](Radar& r) { r.window = Radar::Window::user; });
  expect_error(scene, radar_field("window_gain"));
  scene.radars[0].window_gain.part[0] = points({{0.0, 0.0}, {1.0, 0.0}});
  expect_error(scene, radar_field("window_gain"));
  scene.radars[0].window_gain.part[0] = points({{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}});
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckRadar, NeedsPointsForAUserSensitivityControl) {
  Scene scene = with_radar([](Radar& r) { r.stc = Radar::Stc::user; });
  expect_error(scene, radar_field("stc_gain"));
  scene.radars[0].stc_gain.part[0] = points({{0.0, 0.0}, {11e3, 0.0}});
  EXPECT_THAT(expect_error(scene, radar_field("stc_gain")).message, HasSubstr("zero throughout"));
  scene.radars[0].stc_gain.part[0] = points({{0.0, 0.0}, {11e3, 1.0}});
  EXPECT_TRUE(check(scene).empty());
}

TEST(NominalBandwidth, IsThatOfTheModulation) {
  Radar radar;
  radar.pulse_width_s = 2e-6;
  EXPECT_DOUBLE_EQ(nominal_bandwidth_hz(radar).value(), 0.5e6);
  radar.pulse = Radar::Pulse::chirp;
  radar.bandwidth_hz = -20e6;
  EXPECT_DOUBLE_EQ(nominal_bandwidth_hz(radar).value(), 20e6);
  radar.pulse = Radar::Pulse::barker;
  EXPECT_DOUBLE_EQ(nominal_bandwidth_hz(radar).value(), 13.0 / 2e-6);
  radar.barker_code = 7;
  EXPECT_FALSE(nominal_bandwidth_hz(radar));
  radar.pulse = Radar::Pulse::user;
  EXPECT_FALSE(nominal_bandwidth_hz(radar));
  radar.pulse_iq.part[0] = points({{0.0, 1.0}, {0.5, -1.0}, {1.0, 1.0}});
  EXPECT_EQ(nominal_bandwidth_hz(radar).value(), radar::bandwidth_hz(pulse_of(radar)));
  EXPECT_GT(nominal_bandwidth_hz(radar).value(), 0.5e6);
  for (const core::Knot& fault : {core::Knot{0.5, 1.0}, core::Knot{2.0, std::numeric_limits<double>::quiet_NaN()}}) {
    radar.pulse_iq.part[1] = points({{0.0, 1.0}, {1.0, 1.0}, fault});
    EXPECT_FALSE(nominal_bandwidth_hz(radar));
  }
  radar.pulse_iq.part[1] = {};
  radar.envelope = Radar::Envelope::user;
  EXPECT_FALSE(nominal_bandwidth_hz(radar));
  radar.pulse_width_s = 0.0;
  EXPECT_FALSE(nominal_bandwidth_hz(radar));
}

// The x of a list of intervals is not looked at, so it cannot be uneven.
TEST(CheckRadar, TakesListsWhoseNumbersAreNotEven) {
  Scene scene = sound_scene();
  scene.radars[0].repetition = Radar::Repetition::user;
  scene.radars[0].pri_s.part[0] = {.method = core::Interpolation::low_pass,
                                   .knots = {{0.0, 4e-3}, {5.0, 4e-3}, {6.0, 4e-3}}};
  EXPECT_TRUE(check(scene).empty());
}

}  // namespace check_radar_test
}  // namespace sarsim::scene

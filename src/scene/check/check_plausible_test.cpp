#include <functional>

#include "scene/check/check_test_scene.hpp"

namespace sarsim::scene {
namespace check_plausible_test {

using testing::HasSubstr;

Scene with(const std::function<void(Radar&, Simulation&)>& change) {
  Scene scene = sound_scene();
  change(scene.radars[0], scene.simulations[0]);
  return scene;
}

core::Subject radar_field(const char* field) { return {"radar", 0, field}; }
core::Subject simulation_field(const char* field) { return {"simulation", 0, field}; }

TEST(CheckPlausible, WarnsOfAChirpOfFewCyclesAndGuessesTheUnit) {
  const core::Problem unit =
      expect_warning(with([](Radar& r, Simulation&) { r.pulse_width_s = 2e-9; }), radar_field("pulse_width_s"));
  EXPECT_THAT(unit.found, HasSubstr("0.2: 100 MHz in 2 ns"));
  EXPECT_THAT(unit.hint, HasSubstr("write 2000 for 2 us"));
  EXPECT_TRUE(check(with([](Radar& r, Simulation&) { r.pulse_width_s = 100e-9; })).empty());
}

TEST(CheckPlausible, WarnsOfCarriersThatNoRadarHasAndOfBandsBelowZero) {
  EXPECT_THAT(expect_warning(with([](Radar& r, Simulation&) { r.carrier_hz = 3e12; }), radar_field("carrier_hz")).hint,
              HasSubstr("GHz: write 3 for 3 GHz"));
  EXPECT_TRUE(check(with([](Radar& r, Simulation&) { r.carrier_hz = 50e6; })).empty());
  EXPECT_THAT(
      expect_warning(with([](Radar& r, Simulation&) { r.carrier_hz = 49e6; }), radar_field("bandwidth_hz")).expected,
      HasSubstr("98 MHz"));
}

// sin(theta) = 0.4430 pi/(0.88 pi) of the beamwidth: 104.5 degrees of 90; of 120 there is none.
TEST(CheckPlausible, SaysHowWideAWideBeamIs) {
  const auto beam = [](double width_deg) {
    return with(
        [=](Radar& r, Simulation&) { r.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(width_deg); });
  };
  EXPECT_TRUE(check(beam(40.0)).empty());
  EXPECT_THAT(expect_warning(beam(90.0), radar_field("transmit_antenna")).hint, HasSubstr("104.5 degrees"));
  EXPECT_THAT(expect_warning(beam(60.0), radar_field("transmit_antenna")).hint, HasSubstr("63.6 degrees"));
  EXPECT_THAT(expect_warning(beam(120.0), radar_field("transmit_antenna")).hint, HasSubstr("2.7 dB below"));
}

// 0.886 x 3.1228 cm over 0.01 deg = 158.5 m; millimetre waves have such beams from 17 m.
TEST(CheckPlausible, WarnsOfABeamThatNeedsAnAntennaOfAHundredMetres) {
  const auto beam = [](double width_deg, double carrier_hz) {
    return with([=](Radar& r, Simulation& s) {
      r.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(width_deg);
      r.carrier_hz = carrier_hz;
      if (carrier_hz > 50e6) return;
      r.bandwidth_hz = 5e6;
      r.pulse_width_s = 8e-6;
      s.sample_rate_hz = 6.25e6;
    });
  };
  const core::Problem problem = expect_warning(beam(0.01, 9.6e9), radar_field("transmit_antenna"));
  EXPECT_THAT(problem.message, HasSubstr("azimuth beamwidth needs an antenna 159 m long"));
  EXPECT_THAT(problem.expected, HasSubstr("0.0159 deg"));
  EXPECT_TRUE(check(beam(0.01, 94e9)).empty());
  EXPECT_TRUE(check(beam(0.1, 5e9)).empty());
  // The length alone decides: 0.886 lambda/width is 100 m for 1.0145 deg at 150 MHz.
  EXPECT_THAT(expect_warning(beam(0.2, 150e6), radar_field("transmit_antenna")).message, HasSubstr("507 m long"));
  EXPECT_THAT(expect_warning(beam(1.01, 150e6), radar_field("transmit_antenna")).message, HasSubstr("100 m long"));
  EXPECT_TRUE(check(beam(1.02, 150e6)).empty());
  EXPECT_TRUE(check(beam(0.6, 10e6)).empty());  // 2.5 km of masts
  EXPECT_THAT(expect_warning(beam(0.4, 10e6), radar_field("transmit_antenna")).message, HasSubstr("m long"));
}

// 4 pi 0.886^2/(4 deg x 2 deg) = 36.1 dB; it counts where there is noise.
TEST(CheckPlausible, NotesANarrowBeamWithoutGain) {
  Scene scene = with([](Radar& r, Simulation&) {
    r.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(4.0);
    r.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(2.0);
    r.transmit_gain = {};
  });
  EXPECT_TRUE(check(scene).empty());
  scene.radars[0].noise_temperature_k = 290.0;
  const core::Problems problems = check(scene);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].severity, core::Severity::note);
  EXPECT_THAT(problems[0].expected, HasSubstr("36 dB"));
  scene.radars[0].transmit_gain = core::PowerRatio::from_db(34.0);
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckPlausible, WarnsOfAHanningWindowWithoutEffect) {
  expect_warning(with([](Radar& r, Simulation&) {
                   r.window = Radar::Window::hanning;
                   r.hanning_pedestal = 1.0;
                 }),
                 radar_field("hanning_pedestal"));
  EXPECT_TRUE(check(with([](Radar& r, Simulation&) { r.window = Radar::Window::hanning; })).empty()) << "Hann's";
  EXPECT_TRUE(check(with([](Radar& r, Simulation&) {
                r.window = Radar::Window::hanning;
                r.hanning_pedestal = 0.5;
              })).empty());
}

TEST(CheckPlausible, WarnsOfASamplingFrequencyFarAboveTheBand) {
  EXPECT_THAT(
      expect_warning(with([](Radar&, Simulation& s) { s.sample_rate_hz = 2.1e9; }), simulation_field("sample_rate_hz"))
          .found,
      HasSubstr("21 times the bandwidth"));
  EXPECT_TRUE(check(with([](Radar&, Simulation& s) { s.sample_rate_hz = 1.9e9; })).empty());
  EXPECT_TRUE(check(with([](Radar&, Simulation& s) { s.sample_rate_hz = 106e6; })).empty());
  EXPECT_TRUE(check(with([](Radar& r, Simulation& s) {
                r.pulse = Radar::Pulse::mono;
                s.sample_rate_hz = 1e9;
              })).empty());
}

TEST(CheckPlausible, WarnsOfASinglePulseUnlessOneIsAskedFor) {
  expect_warning(with([](Radar& r, Simulation&) { r.prf_hz = 0.6; }), simulation_field("time_end_s"));
  EXPECT_TRUE(check(with([](Radar&, Simulation& s) { s.time_start_s = s.time_end_s = 0.0; })).empty());
}

TEST(CheckPlausible, WarnsOfAWindowMuchLongerThanTheTrajectory) {
  const auto lasting = [](double end_s) {
    return with([=](Radar& r, Simulation& s) {
      r.platform = "Plane";
      s.time_end_s = end_s;
    });
  };
  EXPECT_TRUE(check(lasting(190.0)).empty());
  EXPECT_THAT(expect_warning(lasting(210.0), simulation_field("time_end_s")).hint, HasSubstr("Times are in seconds"));
}

TEST(CheckPlausible, WarnsOfAFileNameOfAnotherFormat) {
  const auto file = [](const char* name, FileFormat format) {
    return with([=](Radar&, Simulation& s) {
      s.file = name;
      s.format = format;
    });
  };
  expect_warning(file("base.npy", FileFormat::hdf5), simulation_field("file"));
  expect_warning(file("base.H5", FileFormat::npy), simulation_field("file"));
  EXPECT_TRUE(check(file("base.h5", FileFormat::hdf5)).empty());
  EXPECT_TRUE(check(file("base.dat", FileFormat::hdf5)).empty());
}

// 112/(B Tp) of its width is what the filter adds: 1 + 112/80 = 2.4.
TEST(CheckPlausible, WarnsOfABandLimitedPulseThatIsCut) {
  Scene scene = with([](Radar&, Simulation& s) { s.oversampling = 1.5, s.width_factor = 1.0; });
  scene.options.pulse = PulseDefinition::band_limited;
  EXPECT_THAT(expect_warning(scene, simulation_field("width_factor")).expected, HasSubstr("0 or 2.4, which keep all"));
  for (const double whole : {2.4, 0.0}) {
    scene.simulations[0].width_factor = whole;
    EXPECT_TRUE(check(scene).empty()) << whole;
  }
  // The classic profile keeps one width where nothing is said.
  scene.options.profile = Profile::classic;
  expect_warning(scene, simulation_field("width_factor"));
}

TEST(CheckPlausible, NotesWhatVoltsInSinglePrecisionCannotHold) {
  Scene scene = with([](Radar&, Simulation& s) {
    s.format = FileFormat::hdf5;
    s.file = "a.h5";
  });
  EXPECT_TRUE(check(scene).empty());
  scene.options.tolerance = 1e-9;
  expect_single(scene, core::Severity::note, simulation_field("format"));
  scene.options.tolerance = 1e-6;
  scene.simulations[0].bits = 3;
  EXPECT_THAT(expect_single(scene, core::Severity::note, simulation_field("bits")).hint, HasSubstr("--quantise"));
}

}  // namespace check_plausible_test
}  // namespace sarsim::scene

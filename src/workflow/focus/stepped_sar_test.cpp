#include <gmock/gmock.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"
#include "signal/sar/image_test_value.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/focus_test_script.hpp"
#include "workflow/focus/sar_test_scene.hpp"
#include "workflow/focus/seen_spectrum.hpp"

namespace sarsim::workflow {
namespace stepped_sar_test {

// Chirps of 50 MHz on eight carriers 40 MHz apart, one after the other: 330 MHz in all.
scene::Scene stepped_scene() {
  scene::Scene scene = sar_scene(1600.0, {{0.0, 0.0, 0.0}, {30.0, 7.0, 0.0}}, 0.5);
  scene::Radar& radar = scene.radars[0];
  radar.bandwidth_hz = 50e6;
  radar.pulse_width_s = 4e-6;
  radar.carrier = scene::Radar::Carrier::stepped;
  radar.carrier_hz = 5.3e9 - 140e6;
  radar.carrier_step_hz = 40e6;
  radar.carrier_steps = 8;
  scene.simulations[0].sample_rate_hz = 75e6;
  return scene;
}

class SteppedSar : public FocusOfScript {
 protected:
  SteppedSar() : FocusOfScript(stepped_scene()) {}
};

TEST_F(SteppedSar, FocusesToTheBandOfAllCarriers) {
  const FocusReport report = focus(request_, {});
  EXPECT_EQ(report.algorithm, FocusAlgorithm::back_projection);
  const signal::FocusedImage image = signal::in_memory(report.image);
  EXPECT_DOUBLE_EQ(image.carrier_hz, 5.3e9);
  const auto [acquisition, rows] = sar_recording(stepped_scene());
  const std::vector<SarTarget> targets = sar_targets(*acquisition, rows);
  for (const std::size_t t : {0U, 1U}) {
    const core::Vec3 point = t == 0 ? core::Vec3{} : core::Vec3{30.0, 7.0, 0.0};
    const signal::ImagePlace place = signal::place_of(image.frame, point);
    const std::complex<double> value = signal::test::value_at(image, place);
    EXPECT_NEAR(20.0 * std::log10(std::abs(value) / targets.at(t).amplitude), 0.0, 0.1) << t;
    const double turns = 2.0 * place.range_m * 5.3e9 / core::exact_light_speed_mps;
    EXPECT_NEAR(std::remainder(std::arg(value) + 2.0 * core::pi * turns, 2.0 * core::pi), 0.0, 0.01) << t;
    // Half the power within 0.886 c/(2 n df), n df = 320 MHz, but for the flanks.
    const double half_m = 0.5 * 0.886 * core::exact_light_speed_mps / (2.0 * 325e6);
    const double beside = std::abs(signal::test::value_at(image, {place.azimuth_m, place.range_m + half_m}));
    EXPECT_NEAR(20.0 * std::log10(beside / std::abs(value)), -3.0, 0.3) << t;
  }
}

TEST_F(SteppedSar, SaysWhatTheCarriersLeaveAmbiguous) {
  scene::Scene scene = stepped_scene();
  scene.radars[0].bandwidth_hz = 30e6;
  scene.radars[0].prf_hz = 800.0;  // 100 Hz for each carrier; 100 m of flight from 10.2 km are 70 Hz
  const auto [acquisition, rows] = sar_recording(scene);
  const signal::ImageSpectrum narrow{{-0.1, 0.1}, {}};
  const core::Problems ranges = diagnose_carriers(rows, narrow);
  ASSERT_EQ(ranges.size(), 1U);
  EXPECT_THAT(ranges[0].message,
              testing::HasSubstr("up to 40 MHz apart, more than the pulse's band: responses repeat every 3.747 m"));
  const signal::ImageSpectrum wide{{-0.3, 0.3}, {}};  // 120 Hz at 200 m/s
  const core::Problems both = diagnose_carriers(rows, wide);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_THAT(
      both[1].message,
      testing::HasSubstr(
          "each of 8 carriers is sent 100 times a second, but the targets' Doppler frequencies are 120 Hz wide"));
}

TEST_F(SteppedSar, IsRefusedByMethodsOfOneCarrierWithTheWayOut) {
  request_.algorithm = FocusAlgorithm::omega_k;
  try {
    static_cast<void>(focus(request_, {}));
    ADD_FAILURE() << "omega-k took it";
  } catch (const core::InvalidRequest& refused) {
    EXPECT_THAT(core::to_string(refused.problems.front()),
                testing::HasSubstr("the carrier changes from pulse to pulse"));
    EXPECT_THAT(refused.problems.front().hint, testing::HasSubstr("use back-projection"));
  }
}

}  // namespace stepped_sar_test
}  // namespace sarsim::workflow

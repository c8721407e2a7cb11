// Values that follow from the rules of the script language (docs/formats/script.md), through the whole path from text
// to plan.

#include <gtest/gtest.h>

#include <string>

#include "core/maths/interpolator.hpp"
#include "scene/script/reader.hpp"
#include "simulate/run/run.hpp"
#include "support/count_fit.hpp"
#include "support/scenes.hpp"

namespace sarsim {
namespace vectors_test {

// A side-looking radar that passes the origin at 100 m/s; the radar's schedule and the simulation's fields are free.
std::string script(const std::string& repetition, const std::string& carrier, const std::string& simulation) {
  return "$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
         "$platform Craft TRAJ lin LIN LINEAR INLINE 2 -1,-100 1,100  1 0 -4500  1 0,3500 NOT_ALIGNED\n"
         "  CONST 0 0 0 0 0 0 STD 0 0 0 STD 0 0 0\n"
         "$TARG Earth 0 0 0, 0 0 0, 1 0 ISO\n"
         "$RADAR R1 Craft CHIRP 0.1 1000 RECT " +
         repetition + " " + carrier + " 1 0 0 SINX 60 6 SAME FIXED -40 0 HAMM NO_STC\n$SIM R1 " + simulation;
}

simulate::Plan planned(const std::string& text) {
  const scene::ScriptReading reading = scene::read_script(text, "vector.scr", {});
  for (const core::Problem& problem : reading.problems)
    EXPECT_NE(problem.severity, core::Severity::error) << core::to_string(problem);
  return simulate::make_plan(reading.scene, 0);
}

const std::string constant_400 = "CONST 400";
const std::string single = "SINGLE 5.3";
const std::string window = "5550 5870 -0.64 0.6399 8 0.12 1E-7 BIN RAW out.bin CEN 1 1";

TEST(ScriptVectors, MinimalScriptHas512PulsesOf256Samples) {
  const simulate::Plan plan = planned(script(constant_400, single, window));
  EXPECT_EQ(plan.acquisition.timing.pulses.first, -256);
  EXPECT_EQ(plan.acquisition.timing.pulses.last, 255);
  EXPECT_EQ(plan.acquisition.timing.rows, 512u);
  EXPECT_EQ(plan.acquisition.reception.columns, 256u);
}

TEST(ScriptVectors, IntervalsOf1And2And3MillisecondsWrapInBothDirections) {
  const simulate::Plan plan = planned(script("OTHER LIN INLINE 3 0 1e-3 1 2e-3 2 3e-3", single, window));
  const auto time_ms = [&](int pulse) { return 1e3 * plan.acquisition.link.repetition.send_time_s(pulse); };
  EXPECT_DOUBLE_EQ(time_ms(0), 0.0);
  EXPECT_DOUBLE_EQ(time_ms(1), 1.0);
  EXPECT_DOUBLE_EQ(time_ms(2), 3.0);
  EXPECT_DOUBLE_EQ(time_ms(3), 6.0);
  EXPECT_DOUBLE_EQ(time_ms(-1), -3.0);
}

TEST(ScriptVectors, SteppedCarrierRepeatsEachStepAndWraps) {
  const simulate::Plan plan = planned(script(constant_400, "STEPPED 1 0.1 3 2", window));
  const double expected_ghz[] = {1.2, 1.0, 1.0, 1.1, 1.1, 1.2, 1.2, 1.0};
  for (int pulse = -1; pulse <= 6; ++pulse)
    EXPECT_DOUBLE_EQ(plan.acquisition.link.carrier.carrier_hz(pulse), 1e9 * expected_ghz[pulse + 1]) << pulse;
}

TEST(ScriptVectors, ListedCarrierWrapsInBothDirections) {
  const simulate::Plan plan = planned(script(constant_400, "OTHER LIN INLINE 3 0 1 1 2 2 3", window));
  EXPECT_DOUBLE_EQ(plan.acquisition.link.carrier.carrier_hz(-1), 3e9);
  EXPECT_DOUBLE_EQ(plan.acquisition.link.carrier.carrier_hz(3), 1e9);
}

TEST(ScriptVectors, BothEndsOfATimeWindowBelongToIt) {
  const auto pulses = [](const std::string& repetition, const std::string& times) {
    return planned(script(repetition, single, "5550 5870 " + times + " 8 0.12 1E-7 BIN RAW out.bin CEN 1 1"))
        .acquisition.timing.rows;
  };
  EXPECT_EQ(pulses("CONST 400", "0 0.01"), 5u);                                 // 0, 2.5, 5, 7.5, 10 ms
  EXPECT_EQ(pulses("CONST 1000", "0 0.02"), 21u);                               // 0.02 * 1000 need not round to 20
  EXPECT_EQ(pulses("OTHER LIN INLINE 3 0 1e-3 1 2e-3 2 3e-3", "0 0.006"), 4u);  // 0, 1, 3, 6 ms
}

TEST(ScriptVectors, LowPassThroughThreeKnotsIsOneAtTheMiddleInBothProfiles) {
  const core::SampledFunction triangle{core::Interpolation::low_pass, {{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}}};
  const core::Interpolator classic(triangle, core::LowPassRule::origin);
  EXPECT_DOUBLE_EQ(classic.value(1.0), 1.0);
  EXPECT_NEAR(classic.value(0.5), 2.0 / core::pi, 1e-12);  // sinc(1/2)
  const core::Interpolator physical(triangle, core::LowPassRule::first_knot);
  EXPECT_NEAR(physical.value(1.0), 1.0, 1e-12);
}

TEST(ScriptVectors, EightBitsConvert200LsbTo128AndTheOppositeToMinus127) {
  const std::vector<std::complex<double>> volts{{200.4, -200.0}, {-0.3, 127.5}, {128.4, -127.5}};
  const auto counts = test::converted(volts, 8, 1.0);
  EXPECT_EQ(counts[0], std::complex(128.0, -127.0));
  EXPECT_EQ(counts[1], std::complex(0.0, 128.0));
  EXPECT_EQ(counts[2], std::complex(128.0, -127.0));
}

}  // namespace vectors_test
}  // namespace sarsim

#include "picture/echo/echo_window.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::picture {
namespace echo_window_test {

constexpr EchoView view{1000.0, 3000.0, -1.0, 1.0};
constexpr PlotSize size{200, 101};

simulate::Conventions physical() { return simulate::conventions_of(scene::Profile::physical); }

TEST(EchoWindow, OfANewRawSimulationIsSampledAsTheScreenNeeds) {
  const EchoWindow window = new_echo_window("Radar1", scene::Processing::raw);
  EXPECT_EQ(window.recording.radar, "Radar1");
  EXPECT_EQ(window.sampling.kind, Sampling::Kind::screen);
  EXPECT_EQ(window.quantity, DisplayQuantity::real);
  EXPECT_EQ(window.draw_as, DrawAs::automatic);
  EXPECT_EQ(window.recording.time_end_s, 0.01);
}

TEST(EchoWindow, OfANewCompressedSimulationIsSampledAtTheBandwidth) {
  const EchoWindow window = new_echo_window("Radar1", scene::Processing::matched_filter);
  EXPECT_EQ(window.sampling.kind, Sampling::Kind::multiple);
  // The bandwidth of a pulse of 10 us, as arithmetic leaves it.
  EXPECT_EQ(simulation_of(window, 99999.99999999999).sample_rate_hz, 100e3);
  EXPECT_EQ(simulation_of(window, 50e6).sample_rate_hz, 50e6);
}

TEST(EchoWindow, OfAStoredSimulationIsThatSimulationAgain) {
  scene::Simulation s;
  s.radar = "X";
  s.range_start_m = 10010.0;
  s.range_end_m = 10510.5;
  s.time_start_s = -0.5;
  s.time_end_s = -0.5;
  s.bits = 12;
  s.sample_rate_hz = 123.456e6;
  s.lsb_v = 1e-9;
  s.format = scene::FileFormat::npy;
  s.processing = scene::Processing::srp;
  s.file = "a.npy";
  s.pulse_position = scene::Simulation::PulsePosition::centre;
  s.oversampling = 5.0;
  s.width_factor = 2.0;
  EXPECT_EQ(simulation_of(window_of(s), 50e6), s);
  EXPECT_EQ(window_of(s), window_of(s));
  EXPECT_EQ(shown_simulation(window_of(s), 50e6, 400, physical()), s);
}

TEST(EchoWindow, TakesTheBandwidthWhereTheScreenSampledTheWindow) {
  EchoWindow window = new_echo_window("Radar1", scene::Processing::raw);
  EXPECT_EQ(simulation_of(window, 50e6).sample_rate_hz, 50e6);
  window.sampling = {Sampling::Kind::multiple, 0.0, 2.5};
  EXPECT_EQ(simulation_of(window, 50e6).sample_rate_hz, 125e6);
}

TEST(ShownSimulation, HasASampleForEveryPixelWhereTheScreenSetsTheSampling) {
  EchoWindow window = new_echo_window("Radar1", scene::Processing::raw);
  set_view(window, {1234.5, 4321.9, 0.0, 1.0});
  for (const std::size_t width : {1U, 799U, 1600U})
    EXPECT_EQ(simulate::sample_count(shown_simulation(window, 50e6, width, physical()), core::exact_light_speed_mps),
              static_cast<double>(width));
}

TEST(ShownSimulation, IsTheRecordingWhereItHasEnoughSamples) {
  EchoWindow window = new_echo_window("Radar1", scene::Processing::raw);
  set_view(window, {0.0, 3000.0, 0.0, 1.0});
  window.sampling = {Sampling::Kind::rate, 100e6, 1.0};  // 2001 samples
  EXPECT_EQ(shown_simulation(window, 50e6, 2001, physical()).sample_rate_hz, 100e6);
  EXPECT_EQ(shown_simulation(window, 50e6, 2002, physical()).sample_rate_hz, 200e6);
  EXPECT_EQ(shown_simulation(window, 50e6, 9000, physical()).sample_rate_hz, 500e6);
}

TEST(ShownSimulation, BeyondTheClassicGridStillHoldsTheRecordingsSamples) {
  EchoWindow window = new_echo_window("Radar1", scene::Processing::raw);
  set_view(window, {0.0, 100.0, 0.0, 1.0});
  window.sampling = {Sampling::Kind::rate, 51e6, 1.0};  // 34 samples in the window
  const simulate::Conventions classic = simulate::conventions_of(scene::Profile::classic);
  const scene::Simulation shown = shown_simulation(window, 50e6, 400, classic);
  EXPECT_EQ(simulate::sample_count(shown, classic.light_speed_mps), 12.0 * 34.0);
}

TEST(ShownSimulation, KeepsTheSamplingOfCompressedData) {
  EchoWindow window = new_echo_window("Radar1", scene::Processing::matched_filter);
  set_view(window, {0.0, 30.0, 0.0, 1.0});
  EXPECT_EQ(shown_simulation(window, 50e6, 1600, physical()).sample_rate_hz, 50e6);
}

TEST(EchoWindow, IsComputedAnewOnlyWhereItsSamplesChange) {
  const EchoWindow before = new_echo_window("Radar1", scene::Processing::raw);
  EchoWindow after = before;
  after.quantity = DisplayQuantity::phase;
  after.map = ColourMap::cycle;
  after.draw_as = DrawAs::pixels;
  after.placing = RowPlacing::own_row;
  after.decibels.range_db = 30.0;
  after.sliders.contrast = 3.0;
  EXPECT_FALSE(needs_computing(before, after));
  EXPECT_NE(before, after);
  after = before;
  after.recording.pulse_position = scene::Simulation::PulsePosition::centre;
  EXPECT_TRUE(needs_computing(before, after));
  after = before;
  after.sampling.kind = Sampling::Kind::rate;
  EXPECT_TRUE(needs_computing(before, after));
  after = before;
  after.pixel_rule = PixelRule::peak;
  EXPECT_TRUE(needs_computing(before, after));
}

TEST(SamplingWarning, ConcernsCompressedDataBelowThreeTimesTheBandwidth) {
  const EchoWindow raw = new_echo_window("Radar1", scene::Processing::raw);
  const EchoWindow compressed = new_echo_window("Radar1", scene::Processing::matched_filter);
  EXPECT_EQ(sampling_warning(raw, 50e6, 50e6), "");
  EXPECT_NE(sampling_warning(compressed, 50e6, 50e6), "");
  EXPECT_NE(sampling_warning(compressed, 149e6, 50e6).find("149 MHz"), std::string::npos);
  EXPECT_EQ(sampling_warning(compressed, 150e6, 50e6), "");
}

TEST(EchoView, TypedLimitsAreMended) {
  EXPECT_EQ(mended({3000.0, 1000.0, 2.0, 1.0}), (EchoView{1000.0, 3000.0, 1.0, 2.0}));
  EXPECT_EQ(mended({-5.0, 1000.0, -2.0, -1.0}), (EchoView{0.0, 1000.0, -2.0, -1.0}));
  EXPECT_EQ(mended({7.0, 7.0, 3.0, 3.0}), (EchoView{7.0, 8.0, 3.0, 4.0}));
  EXPECT_EQ(mended({-7.0, -9.0, 0.0, 1.0}), (EchoView{0.0, 1.0, 0.0, 1.0}));
  EXPECT_EQ(mended({0.0, std::nan(""), 0.0, std::numeric_limits<double>::infinity()}), (EchoView{0.0, 1.0, 0.0, 1.0}));
}

TEST(EchoView, PixelsAndRangesAndTimesBelongTogether) {
  EXPECT_EQ(range_at(view, size, 0.0), 1000.0);
  EXPECT_EQ(range_at(view, size, 200.0), 3000.0);
  EXPECT_EQ(time_at(view, size, 100.0), -1.0);  // start at the bottom
  EXPECT_EQ(time_at(view, size, 0.0), 1.0);
  for (const double p : {0.0, 17.25, 100.0}) {
    EXPECT_NEAR(x_of_range(view, size, range_at(view, size, p)), p, 1e-9);
    EXPECT_NEAR(y_of_time(view, size, time_at(view, size, p)), p, 1e-9);
  }
  const EchoView instant{0.0, 1.0, 5.0, 5.0};
  EXPECT_EQ(time_at(instant, size, 30.0), 5.0);
  EXPECT_TRUE(std::isfinite(y_of_time(instant, size, 5.0)));
  EXPECT_EQ(time_at(view, {10, 1}, 0.0), -1.0);
}

TEST(EchoView, ZoomsToARectangleCutOffAtThePlot) {
  const auto zoomed = zoomed_to(view, size, 150.0, 25.0, 50.0, 75.0);
  ASSERT_TRUE(zoomed);
  EXPECT_EQ(*zoomed, (EchoView{1500.0, 2500.0, -0.5, 0.5}));
  EXPECT_EQ(zoomed_to(view, size, -50.0, -10.0, 999.0, 999.0), view);
  EXPECT_FALSE(zoomed_to(view, size, 20.0, 20.0, 20.5, 60.0));
  EXPECT_FALSE(zoomed_to(view, size, 20.0, 20.0, 60.0, 20.0));
  EXPECT_FALSE(zoomed_to(view, size, 500.0, 20.0, 600.0, 60.0));
}

TEST(EchoView, ScalesAboutThePointUnderTheCursor) {
  const EchoView zoomed = scaled_about(view, size, 50.0, 25.0, 0.5, 0.25);
  EXPECT_NEAR(range_at(zoomed, size, 50.0), range_at(view, size, 50.0), 1e-9);
  EXPECT_NEAR(time_at(zoomed, size, 25.0), time_at(view, size, 25.0), 1e-12);
  EXPECT_NEAR(zoomed.range_end_m - zoomed.range_start_m, 1000.0, 1e-9);
  EXPECT_NEAR(zoomed.time_end_s - zoomed.time_start_s, 0.5, 1e-12);
}

TEST(EchoView, ZoomsOutByTwoWithTheClickInTheMiddle) {
  const EchoView wider = zoomed_out(view, size, 150.0, 50.0);
  EXPECT_EQ(wider, (EchoView{500.0, 4500.0, -2.0, 2.0}));
  // Below 0 it is moved and keeps its span.
  EXPECT_EQ(zoomed_out(view, size, 0.0, 50.0), (EchoView{0.0, 4000.0, -2.0, 2.0}));
}

TEST(EchoView, PansWithTheMouse) {
  const EchoView moved = panned(view, size, 20.0, 10.0);
  EXPECT_NEAR(moved.range_start_m, 800.0, 1e-9);
  EXPECT_NEAR(moved.range_end_m, 2800.0, 1e-9);
  EXPECT_NEAR(moved.time_start_s, -0.8, 1e-12);
  // What was under the cursor still is.
  EXPECT_NEAR(range_at(moved, size, 70.0), range_at(view, size, 50.0), 1e-9);
  EXPECT_NEAR(time_at(moved, size, 60.0), time_at(view, size, 50.0), 1e-12);
  EXPECT_EQ(panned(view, size, 500.0, 0.0).range_start_m, 0.0);
}

TEST(EchoView, ShowsAllTargetsWithTwoPulsesOnEitherSide) {
  const EchoView all = showing_targets(view, 3000.0, 4000.0, 5e-6, 3e8);
  EXPECT_NEAR(all.range_start_m, 1500.0, 1e-9);
  EXPECT_NEAR(all.range_end_m, 5500.0, 1e-9);
  EXPECT_EQ(all.time_start_s, -1.0);
  EXPECT_EQ(showing_targets(view, 100.0, 100.0, 5e-6, 3e8).range_start_m, 0.0);
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_EQ(showing_targets(view, none, -none, 5e-6, 3e8), (EchoView{0.0, 10000.0, -1.0, 1.0}));
}

TEST(EchoView, FollowsAnotherWindowInTheLinkedAxesOnly) {
  const EchoView leader{1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(linked(view, leader, {true, false}), (EchoView{1.0, 2.0, -1.0, 1.0}));
  EXPECT_EQ(linked(view, leader, {false, true}), (EchoView{1000.0, 3000.0, 3.0, 4.0}));
  EXPECT_EQ(linked(view, leader, {}), view);
}

}  // namespace echo_window_test
}  // namespace sarsim::picture

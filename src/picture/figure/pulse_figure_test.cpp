#include "picture/figure/pulse_figure.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "radar/waveform/pulse.hpp"

namespace sarsim::picture {
namespace pulse_figure_test {

double value_at(const FigureCurve& curve, double x) {
  const auto nearest =
      std::ranges::min_element(curve.x, {}, [x](double place) { return std::abs(place - x); }) - curve.x.begin();
  return curve.y[static_cast<std::size_t>(nearest)];
}

radar::Pulse mono() {
  radar::Pulse pulse;
  pulse.width_s = 1e-6;
  return pulse;
}

TEST(SentPulse, OfOneFrequencyHasTheSpectrumOfARectangle) {
  const Figure figure = sent_pulse_figure(mono());
  ASSERT_EQ(figure.panels.size(), 2U);
  const FigureCurve& spectrum = figure.panels[1].curves.at(0);
  EXPECT_DOUBLE_EQ(value_at(spectrum, 0.0), 0.0);
  EXPECT_NEAR(value_at(spectrum, 0.5e6), 20.0 * std::log10(2.0 / core::pi), 0.01);
  EXPECT_NEAR(value_at(spectrum, 1.5e6), 20.0 * std::log10(2.0 / (3.0 * core::pi)), 0.02);
  EXPECT_LT(value_at(spectrum, 1e6), -55.0);
}

TEST(SentPulse, ShowsInPhaseAndQuadratureFromEdgeToEdge) {
  const FigurePanel panel = sent_pulse_figure(mono()).panels[0];
  ASSERT_EQ(panel.curves.size(), 2U);
  EXPECT_EQ(panel.curves[0].name, "I");
  EXPECT_EQ(panel.x.first, 0.0);
  EXPECT_EQ(panel.x.last, 1e-6);
  for (const double i : panel.curves[0].y) EXPECT_EQ(i, 1.0);
  for (const double q : panel.curves[1].y) EXPECT_EQ(q, 0.0);
}

TEST(SentPulse, OfAChirpFillsItsBand) {
  radar::Pulse chirp = mono();
  chirp.kind = radar::Pulse::Kind::chirp;
  chirp.width_s = 10e-6;
  chirp.sweep_hz = -50e6;
  const Figure figure = sent_pulse_figure(chirp);
  const FigureCurve& spectrum = figure.panels[1].curves[0];
  EXPECT_GT(value_at(spectrum, 20e6), -3.0);
  EXPECT_GT(value_at(spectrum, -20e6), -3.0);
  EXPECT_LT(value_at(spectrum, 35e6), -20.0);
  EXPECT_NE(figure.note.find("Down chirp"), std::string::npos);
  EXPECT_NE(figure.note.find("time-bandwidth product 500"), std::string::npos) << figure.note;
}

TEST(SentPulse, OfAnyLengthTakesLimitedMemory) {
  radar::Pulse chirp = mono();
  chirp.kind = radar::Pulse::Kind::chirp;
  chirp.width_s = 1.0;
  chirp.sweep_hz = 1e9;
  EXPECT_LT(sent_pulse_figure(chirp).panels[0].curves[0].x.size(), 200'000U);
}

TEST(SentPulse, OfNothingIsFinite) {
  radar::Pulse silent = mono();
  silent.kind = radar::Pulse::Kind::user;
  const Figure figure = sent_pulse_figure(silent);
  for (const double level : figure.panels[1].curves[0].y) ASSERT_TRUE(std::isfinite(level));
}

}  // namespace pulse_figure_test
}  // namespace sarsim::picture

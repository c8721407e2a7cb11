// Pulses confined to a band (decision: docs/decisions/0005-band-limited-pulse.md).

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/maths/fft.hpp"
#include "support/scenes.hpp"

namespace sarsim {
namespace band_test {

// Share of the energy of samples at `rate_hz` beyond +-half_band_hz, in dB.
double energy_outside_db(std::vector<std::complex<double>> samples, double rate_hz, double half_band_hz) {
  samples.resize(core::good_fft_size(2 * samples.size()));
  const core::Fft fft(samples.size());
  fft.forward(samples);
  double total = 0.0;
  double outside = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double turns = static_cast<double>(k) / static_cast<double>(samples.size());
    const double frequency_hz = rate_hz * (turns < 0.5 ? turns : turns - 1.0);
    total += std::norm(samples[k]);
    if (std::abs(frequency_hz) > half_band_hz) outside += std::norm(samples[k]);
  }
  return 10.0 * std::log10(outside / total);
}

// One echo, fully inside the window.
scene::Scene one_echo(scene::Radar::Pulse pulse, scene::PulseDefinition definition) {
  scene::Scene scene = test::radar_at_origin();
  scene.options.pulse = definition;
  scene.radars[0].pulse = pulse;
  scene.radars[0].bandwidth_hz = 50e6;
  scene.radars[0].pulse_width_s = 2e-6;
  test::add_target(scene, {2001.3, 0.0, 0.0});
  test::set_window(scene, 1000.0, 3500.0, 400e6);
  scene.simulations[0].oversampling = 8.0;
  return scene;
}

TEST(BandLimitedEcho, HasLessThanAMillionthOfItsEnergyOutsideItsBand) {
  struct Case {
    scene::Radar::Pulse pulse;
    double half_band_hz;
    double hard_db;  // more than this leaks where the edges are hard
  };
  for (const Case& c :
       {Case{scene::Radar::Pulse::chirp, 25e6, -20.0}, Case{scene::Radar::Pulse::barker, 0.5 * 13.0 / 2e-6, -12.0},
        Case{scene::Radar::Pulse::mono, 0.25e6, -8.0}}) {
    const double hard_db = energy_outside_db(test::recorded(one_echo(c.pulse, scene::PulseDefinition::ideal)).samples,
                                             400e6, c.half_band_hz);
    scene::Scene scene = one_echo(c.pulse, scene::PulseDefinition::band_limited);
    // 28/F before and after the pulse must be inside: 112 us of monochrome pulse are 17 km.
    const double reach_m = 0.5 * core::exact_light_speed_mps * 28.0 / c.half_band_hz;
    scene.targets[0].position_m.x = 1100.0 + reach_m;
    scene.simulations[0].range_end_m = 1600.0 + 2.0 * reach_m;
    if (c.pulse == scene::Radar::Pulse::mono) scene.simulations[0].sample_rate_hz = 20e6;
    const double soft_db =
        energy_outside_db(test::recorded(scene).samples, scene.simulations[0].sample_rate_hz, c.half_band_hz);
    std::printf("energy outside the band: hard edges %.1f dB, band-limited %.1f dB\n", hard_db, soft_db);
    EXPECT_GT(hard_db, c.hard_db);
    EXPECT_LT(soft_db, -100.0);
  }
}

// The kept length that nobody chose keeps what the name promises; the classic profile cuts as the programs of 1998 did.
TEST(BandLimitedEcho, IsCutWhereAScriptOrTheClassicProfileSaysSo) {
  scene::Scene scene = one_echo(scene::Radar::Pulse::chirp, scene::PulseDefinition::band_limited);
  EXPECT_LT(energy_outside_db(test::recorded(scene).samples, 400e6, 25e6), -100.0);
  scene.simulations[0].width_factor = 1.0;
  const double cut_db = energy_outside_db(test::recorded(scene).samples, 400e6, 25e6);
  EXPECT_GT(cut_db, -35.0);
  EXPECT_LT(cut_db, -20.0);
  scene.options.profile = scene::Profile::classic;
  const auto said = test::recorded(scene).samples;
  scene.simulations[0].width_factor = 0.0;
  EXPECT_EQ(test::recorded(scene).samples, said);
}

TEST(BandLimitedEcho, BetweenSamplesIsWhatTheSamplesSay) {
  // Over-sampling 1: the band is that of the sampling itself. Samples taken half an interval later must be those that
  // the first ones determine: a shift of half a sample in the frequency domain.
  scene::Scene scene = one_echo(scene::Radar::Pulse::chirp, scene::PulseDefinition::band_limited);
  scene.simulations[0].oversampling = 1.0;
  test::set_window(scene, 1700.0, 2700.0, 60e6);
  auto even = test::recorded(scene).samples;
  const double half_m = 0.25 * core::exact_light_speed_mps / 60e6;
  scene.simulations[0].range_start_m += half_m;
  scene.simulations[0].range_end_m += half_m;
  const auto odd = test::recorded(scene).samples;
  ASSERT_EQ(odd.size(), even.size());
  const auto size = static_cast<double>(even.size());
  const core::Fft fft(even.size());
  fft.forward(even);
  for (std::size_t k = 0; k < even.size(); ++k) {
    const double turns = static_cast<double>(k) / size;
    even[k] *= std::polar(1.0 / size, core::pi * (turns < 0.5 ? turns : turns - 1.0));
  }
  fft.inverse(even);
  double largest = 0.0;
  double worst = 0.0;
  for (std::size_t i = 0; i < odd.size(); ++i) {
    largest = std::max(largest, std::abs(odd[i]));
    worst = std::max(worst, std::abs(odd[i] - even[i]));
  }
  // The filter's stop band is at 1e-6, reached on both sides of fs/2.
  EXPECT_LT(worst / largest, 2e-6);
}

TEST(BandLimitedEcho, IsTheHardEdgedOneInTheMiddleOfThePassBand) {
  // The response at zero frequency is 1 to 1e-6: a long monochrome pulse keeps its amplitude.
  scene::Scene scene = test::radar_at_origin();
  scene.radars[0].pulse_width_s = 20e-6;
  test::add_target(scene, {2000.0, 0.0, 0.0});
  test::set_window(scene, 3490.0, 3510.0, 10e6);
  const auto hard = test::recorded(scene).samples;
  scene.options.pulse = scene::PulseDefinition::band_limited;
  const auto soft = test::recorded(scene).samples;
  for (std::size_t i = 0; i < hard.size(); ++i) EXPECT_LT(std::abs(soft[i] - hard[i]), 2e-6 * std::abs(hard[i]));
}

}  // namespace band_test
}  // namespace sarsim

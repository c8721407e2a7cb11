#include "workflow/focus/edge_remark.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include <fmt/format.h>

#include "signal/compress/sampling_loss.hpp"
#include "workflow/focus/sar_test_scene.hpp"
#include "workflow/focus/sar_theory.hpp"

namespace sarsim::workflow {
namespace edge_remark_test {

using testing::HasSubstr;
using Pulse = scene::Radar::Pulse;

scene::Scene scene_of(Pulse pulse, double width_s, double sample_rate_hz, const core::Vec3& target_m = {}) {
  scene::Scene scene = sar_scene(700.0, {target_m}, 0.5);
  scene.radars[0].pulse = pulse;
  scene.radars[0].pulse_width_s = width_s;
  scene.radars[0].barker_code = 6;
  scene.simulations[0].sample_rate_hz = sample_rate_hz;
  return scene;
}

double found_loss_db(const scene::Scene& scene) {
  const auto [acquisition, rows] = sar_recording(scene);
  const TargetTheory theory = theory_of_targets(*acquisition, rows, {}).at(0);
  return -20.0 * std::log10(focused_point(rows, theory.place).amplitude / theory.amplitude);
}

// Echoes of a short flight begin nearly alike between samples: each range has its own loss.
TEST(EdgeRemark, HasTheLossThatImagesHave) {
  std::mt19937 random(54);
  std::uniform_real_distribution<double> samples(1.2, 1.8);

  constexpr int places = 12;
  for (const int more : {0, 1, 2, 0, 1, 2}) {
    const bool coded = random() % 2 == 0;
    const double rate_hz = (samples(random) + more) / 50e-9;
    const double width_s = coded ? 13.0 * 50e-9 : 50e-9;
    SCOPED_TRACE(fmt::format("{} {} Hz", coded ? "coded" : "mono", rate_hz));
    // Evenly over a sampling interval: the golden ratio's multiples.
    const double interval_m = 0.5 * 299792458.0 / rate_hz;
    const auto scene = [&](int place) {
      const double across_m = std::fmod(0.618034 * place, 1.0) * interval_m;
      return scene_of(coded ? Pulse::barker : Pulse::mono, width_s, rate_hz, {across_m, 0.0, 0.0});
    };
    const simulate::Acquisition acquisition = simulate::acquisition_of(scene(0), 0);
    const signal::SamplingLoss loss = signal::sampling_loss(acquisition.link.pulse, rate_hz);
    double sum = 0.0;
    for (int place = 0; place < places; ++place) {
      const double found_db = found_loss_db(scene(place));
      EXPECT_LT(found_db, loss.max_db + 0.1);
      sum += std::pow(10.0, -found_db / 20.0);
    }
    EXPECT_NEAR(-20.0 * std::log10(sum / places), loss.mean_db, 0.1 + 0.2 * loss.mean_db);
    EXPECT_EQ(diagnose_edges(acquisition).size(), 1U);
  }
}

TEST(EdgeRemark, SaysHowMuchIsLostAndWhatHelps) {
  const core::Problems problems = diagnose_edges(simulate::acquisition_of(scene_of(Pulse::mono, 50e-9, 41e6), 0));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].severity, core::Severity::warning);
  EXPECT_THAT(problems[0].found,
              HasSubstr("2.05 samples a pulse at 41 MHz, a loss of 2.8 dB on average and up to 3 dB"));
  EXPECT_THAT(problems[0].hint, HasSubstr("band-limited"));
}

TEST(EdgeRemark, IsNotMadeOfSoundPulses) {
  EXPECT_TRUE(diagnose_edges(simulate::acquisition_of(sar_scene(700.0, {{}}), 0)).empty());
  EXPECT_TRUE(diagnose_edges(simulate::acquisition_of(scene_of(Pulse::mono, 500e-9, 50e6), 0)).empty());
  scene::Scene limited = scene_of(Pulse::mono, 50e-9, 41e6);
  limited.options.pulse = scene::PulseDefinition::band_limited;
  EXPECT_TRUE(diagnose_edges(simulate::acquisition_of(limited, 0)).empty());
}

}  // namespace edge_remark_test
}  // namespace sarsim::workflow

// Whichever engine computes a scene, the samples are the same to the promise.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scene/script/reader.hpp"
#include "simulate/plan/row_maker.hpp"
#include "simulate/run/run.hpp"
#include "support/ascii_samples.hpp"
#include "support/folders.hpp"

namespace sarsim {
namespace engines_test {

scene::Scene scene_of(const std::string& script) {
  const scene::ScriptReading reading = scene::read_script(script, "test.scr", {});
  EXPECT_FALSE(core::has_errors(reading.problems))
      << (reading.problems.empty() ? "" : core::to_string(reading.problems.front()));
  return reading.scene;
}

std::vector<std::complex<double>> samples_with(const scene::Scene& scene, simulate::Engine engine,
                                               unsigned threads = 0) {
  raster::RunControl control;
  control.threads = threads;
  return simulate::record(simulate::make_plan(scene, 0, nullptr, engine), control).samples;
}

// Largest deviation of two recordings over the largest magnitude. The promise is for the error's energy in a pulse; a
// single sample may be a few times worse, which `factor` allows for.
double deviation(const std::vector<std::complex<double>>& got, const std::vector<std::complex<double>>& expected) {
  double worst = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    worst = std::max(worst, std::abs(got.at(i) - expected[i]));
    largest = std::max(largest, std::abs(expected[i]));
  }
  return worst / largest;
}

const std::string earth = "$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n";

// A turning platform with plain, directional, jittered and user-curve targets, a surface, a moving radar with a beam.
std::string busy_scene(const std::string& antenna, const std::string& stc, const std::string& processing,
                       const std::string& options) {
  std::string script =
      earth +
      "$PLATFORM Ship TRAJECTORY CUBIC CUBIC CUBIC INLINE 3 0 0 1 12 2 30 2 0 3000 2 3020 1 0 0 ALIGNED "
      "CONST 0 0 0 2 -3 9 STDDEV 0.01 0 0 STDDEV 0 0 0.1\n"
      "$PLATFORM Plane TRAJECTORY LINEAR LINEAR LINEAR INLINE 2 0 -40 2 40 1 0 0 2 0 500 2 530 NOT_ALIGNED "
      "OTHER LINEAR LINEAR LINEAR INLINE 2 0 -1 2 1 1 0 0.5 2 0 0 2 3 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
      "$SURFACE Earth 30 3010 0 30 3016 0 24 3010 3\n";
  for (int i = 0; i < 60; ++i) {
    const std::string x = std::to_string(-30 + i);
    script += "$TARGET Ship " + x + " " + std::to_string(i % 7 - 3) + " " + std::to_string(i % 5) +
              (i % 9 == 0 ? " 0.02 0 0.01 1 0.3" : " 0 0 0 1 0");
    if (i % 4 == 1)
      script += " DIRECTIONAL 180 5 0 0 COS_GAIN";
    else if (i % 4 == 2)
      script += " DIRECTIONAL 170 0 1 1 OTHER_GAIN LINEAR INLINE 3 0 0 90 -10 180 -30";
    else
      script += " ISOTROPIC";
    script += "\n";
  }
  script += "$RADAR R Plane CHIRP 0.05 2000 RECT CONSTANT 100 SINGLE 9.4 10 1 2 3 0 " + antenna + " " + stc + "\n";
  script += "$SIMULATION R 2850 3500 0 0.35 12 0.07 1E-6 NPY " + processing + " a.npy CENTRE 1 1\n" + options + "\n";
  return script;
}

TEST(Engines, AgreeOnScenesWithEverything) {
  // 1e-6 of the energy of a pulse of 140 samples; a single sample stays within five times that here.
  constexpr double bound = 5e-6;
  for (const char* antenna : {"ISOTROPIC SAME FIXED -9 0 RECT", "SINX 30 12 SIN 20 9 FIXED -9 3 HAMMING",
                              "SINX 30 12 ISOTROPIC SPOT 5 3000 0 RECT",
                              "OTHER LINEAR LINEAR INLINE 3 0 0 20 -6 180 -40 2 0 0 180 -20 SAME ROTATING -9 20 RECT",
                              "OTHER CUBIC MFILTER INLINE 4 0 0 10 -3 40 -20 180 -30 3 0 0 20 -4 40 -9 "
                              "OTHER MFILTER CUBIC INLINE 4 0 0 30 -9 60 -3 90 -9 2 0 0 90 -20 SPOT 5 3000 0 RECT"})
    for (const char* stc : {"NO_STC", "APPLY_STC 1OVERR4"})
      for (const char* processing : {"RAW", "MATCHED_FILTER"})
        for (const char* options : {"", "$OPTIONS PROFILE CLASSIC", "$OPTIONS PULSE BAND_LIMITED"}) {
          const scene::Scene scene = scene_of(busy_scene(antenna, stc, processing, options));
          const auto expected = samples_with(scene, simulate::Engine::reference);
          EXPECT_LT(deviation(samples_with(scene, simulate::Engine::direct), expected), bound)
              << antenna << stc << processing << options;
          EXPECT_LT(deviation(samples_with(scene, simulate::Engine::spectral), expected), bound)
              << antenna << stc << processing << options;
        }
}

// The spectral engine compresses echoes in its spectra and noise by itself: their sum is what other engines compress.
TEST(Engines, AgreeOnCompressedEchoesInNoise) {
  for (const char* options : {"", "$OPTIONS PROFILE CLASSIC", "$OPTIONS PULSE BAND_LIMITED"}) {
    scene::Scene scene = scene_of(busy_scene("ISOTROPIC SAME FIXED -9 0 RECT", "NO_STC", "MATCHED_FILTER", options));
    const auto quiet = samples_with(scene, simulate::Engine::spectral);
    scene.radars[0].noise_temperature_k = 3e4;
    const auto expected = samples_with(scene, simulate::Engine::reference);
    EXPECT_GT(deviation(quiet, expected), 0.01) << "the noise is to be seen";
    EXPECT_LT(deviation(samples_with(scene, simulate::Engine::spectral), expected), 5e-6) << options;
  }
}

TEST(Engines, MakeARowWhateverStoodInItsPlace) {
  for (const char* processing : {"RAW", "MATCHED_FILTER"})
    for (const simulate::Engine engine : {simulate::Engine::direct, simulate::Engine::spectral}) {
      const simulate::Plan plan = simulate::make_plan(
          scene_of(busy_scene("ISOTROPIC SAME FIXED -9 0 RECT", "NO_STC", processing, "")), 0, nullptr, engine);
      simulate::RowMaker maker(plan);
      std::vector<std::complex<double>> clean(plan.acquisition.reception.columns),
          used(plan.acquisition.reception.columns, {7.0, -3.0});
      maker.make_row(1, clean);
      maker.make_row(1, used);
      EXPECT_EQ(clean, used) << simulate::name_of(engine) << processing;
    }
}

TEST(Engines, SameBytesForAnyNumberOfThreads) {
  struct Case {
    const char* antenna;
    const char* processing;
    const char* options;
  };
  const char* user = "OTHER CUBIC MFILTER INLINE 3 0 0 20 -6 180 -40 2 0 0 180 -20 SAME FIXED -9 0 RECT";
  const char* sinx = "SINX 30 12 SAME FIXED -9 0 RECT";
  for (const Case& c : {Case{sinx, "RAW", ""}, Case{sinx, "MATCHED_FILTER", "$OPTIONS PROFILE CLASSIC"},
                        Case{user, "MATCHED_FILTER", ""}, Case{user, "RAW", "$OPTIONS PROFILE CLASSIC"}}) {
    scene::Scene scene = scene_of(busy_scene(c.antenna, "NO_STC", c.processing, c.options));
    scene.simulations[0].time_end_s = 1.5;
    scene.radars[0].noise_temperature_k = 300.0;
    for (const simulate::Engine engine : {simulate::Engine::direct, simulate::Engine::spectral}) {
      const auto one = samples_with(scene, engine, 1);
      for (const unsigned threads : {2U, 3U, 8U})
        EXPECT_EQ(samples_with(scene, engine, threads), one)
            << simulate::name_of(engine) << threads << c.antenna << c.processing;
    }
  }
}

TEST(Engines, ReproduceTheDirectReferenceCases) {
  std::size_t cases = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::direct_reference_folder())) {
    if (entry.path().extension() != ".scr") continue;
    ++cases;
    scene::ScriptReading reading = scene::read_script_file(entry.path());
    reading.scene.options.profile = scene::Profile::classic;
    reading.scene.options.tolerance = 1e-7;
    auto path = entry.path();
    const auto counts = test::ascii_samples(path.replace_extension(".asc"));
    std::vector<std::complex<double>> expected;
    for (const auto& count : counts) expected.push_back(count * reading.scene.simulations[0].lsb_v);
    for (const simulate::Engine engine :
         {simulate::Engine::direct, simulate::Engine::spectral, simulate::Engine::automatic})
      EXPECT_LT(deviation(samples_with(reading.scene, engine), expected), 1e-6)
          << entry.path() << simulate::name_of(engine);
  }
  EXPECT_EQ(cases, 34U);
}

TEST(Engines, AutomaticTakesDirectForFewEchoesAndSpectralForMany) {
  std::string script =
      earth +
      "$RADAR R Earth CHIRP 0.1 8000 RECT CONSTANT 100 SINGLE 1 1 0 0 ISOTROPIC SAME FIXED 0 0 RECT NO_STC\n"
      "$SIMULATION R 1000 3000 0 0.02 8 0.12 0 NPY RAW a.npy BEGIN 1 1\n";
  const std::string one = "$TARGET Earth 0 1500 0 0 0 0 1 0 ISOTROPIC\n";
  const simulate::Plan few = simulate::make_plan(scene_of(script + one), 0, nullptr, simulate::Engine::automatic);
  EXPECT_EQ(few.engine.engine, simulate::Engine::direct) << few.engine.reason;
  std::string many;
  for (int i = 0; i < 3000; ++i)
    many += "$TARGET Earth 0 " + std::to_string(1200 + i % 800) + " 0 0 0 0 1 0 ISOTROPIC\n";
  const simulate::Plan lots = simulate::make_plan(scene_of(script + many), 0, nullptr, simulate::Engine::automatic);
  EXPECT_EQ(lots.engine.engine, simulate::Engine::spectral) << lots.engine.reason;
  EXPECT_EQ(simulate::product_of(lots, "").engine, "spectral");
}

TEST(Engines, RefuseATargetAtTheRadar) {
  const scene::Scene scene =
      scene_of(earth +
               "$TARGET Earth 0 0 0 0 0 0 1 0 ISOTROPIC\n"
               "$RADAR R Earth MONO 1000 RECT CONSTANT 100 SINGLE 1 1 0 0 ISOTROPIC SAME FIXED 0 0 RECT NO_STC\n"
               "$SIMULATION R 0 300 0 0.02 8 0.01 0 NPY RAW a.npy BEGIN 1 1\n");
  for (const simulate::Engine engine :
       {simulate::Engine::reference, simulate::Engine::direct, simulate::Engine::spectral})
    EXPECT_THROW(samples_with(scene, engine), std::runtime_error) << simulate::name_of(engine);
}

}  // namespace engines_test
}  // namespace sarsim

// The sample files that the original program's authors left, written by versions of 1997 to 2015.

#include <gtest/gtest.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "raster/format/open_raster.hpp"
#include "scene/script/reader.hpp"
#include "simulate/run/run.hpp"
#include "support/ascii_samples.hpp"
#include "support/count_fit.hpp"
#include "support/folders.hpp"

namespace sarsim {
namespace original_test {

using Samples = std::vector<std::complex<double>>;
using test::reference_folder;

// Sample files have names of their own; the script that made one stands beside it.
std::filesystem::path sample_file(const std::string& name) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(reference_folder() / "original"))
    if (entry.path().filename() == name) return entry.path();
  throw std::runtime_error("no file " + name + " below " + reference_folder().string());
}

scene::Scene classic_scene(const std::string& samples, const std::string& script) {
  scene::Scene scene = scene::read_script_file(sample_file(samples).replace_filename(script)).scene;
  scene.options.profile = scene::Profile::classic;
  return scene;
}

// The program of 1997 took the wavelength of 1 GHz for every carrier; at 0.5 GHz that halves the amplitude.
Samples halved(Samples volts) {
  for (auto& v : volts) v *= 0.5;
  return volts;
}

class OriginalSamples : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::have_reference_folder()) GTEST_SKIP() << "no reference folder at " << reference_folder();
  }
};

// Compares at a given LSB and says how far the worst count is off.
void expect_within_counts(const char* name, const Samples& volts, const Samples& counts, double lsb_v, double allowed) {
  ASSERT_EQ(volts.size(), counts.size()) << name;
  const double worst = test::largest_component_difference(test::converted(volts, 8, lsb_v), counts);
  std::printf("%-34s %5zu samples, LSB %.6g mV, largest deviation %g counts\n", name, counts.size(), 1e3 * lsb_v,
              worst);
  EXPECT_LE(worst, allowed) << name;
}

TEST_F(OriginalSamples, Of1997AgreeWithinOneCountOnceTheirWavelengthIsMended) {
  struct Case {
    const char* samples;
    const char* script;
    std::size_t simulation;
    std::size_t rows;
    std::size_t columns;
  };
  for (const Case& c : {Case{"sim1.asc", "exam2.scr", 0, 19, 146}, Case{"sims2.asc", "exam2.scr", 3, 5, 200}}) {
    const scene::Scene scene = classic_scene(c.samples, c.script);
    const simulate::Recording recording = simulate::record(simulate::make_plan(scene, c.simulation));
    EXPECT_EQ(recording.report.rows, c.rows) << c.samples;
    EXPECT_EQ(recording.report.columns, c.columns) << c.samples;
    expect_within_counts(c.samples, halved(recording.samples), test::ascii_samples(sample_file(c.samples)),
                         scene.simulations[c.simulation].lsb_v, 1.0);
  }
}

TEST_F(OriginalSamples, OfAnUnknownLsbAgreeWithinOneCountAtTheBestOne) {
  scene::Scene scene = classic_scene("sims1.asc", "exam2.scr");
  scene.simulations[0].time_start_s = 0.0;
  scene.simulations[0].time_end_s = 0.0;
  const simulate::Recording recording = simulate::record(simulate::make_plan(scene, 0));
  EXPECT_EQ(recording.report.rows, 1u);
  EXPECT_EQ(recording.report.columns, 160u);
  const Samples volts = halved(recording.samples);
  const Samples counts = test::ascii_samples(sample_file("sims1.asc"));
  ASSERT_EQ(volts.size(), counts.size());
  const double lsb_v = test::fitted_lsb_v(volts, counts);
  EXPECT_NEAR(lsb_v, 2.3627e-14, 0.005e-14);
  expect_within_counts("sims1.asc", volts, counts, lsb_v, 1.0);
}

TEST_F(OriginalSamples, OfTheSixPulsesAreExactForSomeLsb) {
  scene::Scene scene = classic_scene("exam1_sim2_first6pulses.asc", "exam1.scr");
  scene.simulations[1].time_start_s = 0.0;
  scene.simulations[1].time_end_s = 5e-3;
  const simulate::Recording recording = simulate::record(simulate::make_plan(scene, 1));
  EXPECT_EQ(recording.report.rows, 6u);
  EXPECT_EQ(recording.report.columns, 53u);
  const Samples counts = test::ascii_samples(sample_file("exam1_sim2_first6pulses.asc"));
  ASSERT_EQ(recording.samples.size(), counts.size());
  const double lsb_v = test::fitted_lsb_v(recording.samples, counts);
  EXPECT_NEAR(lsb_v, 1.66947e-9, 0.01e-9);
  expect_within_counts("exam1_sim2_first6pulses.asc", recording.samples, counts, lsb_v, 0.0);
}

// The later programs put every echo on the nearest whole sample: the shapes agree, the samples do not.
TEST_F(OriginalSamples, OfTheRoundingProgramCorrelate) {
  const scene::Scene scene = classic_scene("final.h5", "exam2.scr");
  const simulate::Recording recording = simulate::record(simulate::make_plan(scene, 0));
  EXPECT_EQ(recording.report.rows, 19u);
  EXPECT_EQ(recording.report.columns, 146u);
  const Samples ours = test::converted(recording.samples, 8, scene.simulations[0].lsb_v);
  const Samples theirs = test::ascii_samples(sample_file("exam2.asc"));
  ASSERT_EQ(ours.size(), theirs.size());
  const double agreement = test::correlation(ours, theirs);
  std::printf("%-34s %5zu samples, correlation %.5f\n", "exam2.asc", theirs.size(), agreement);
  EXPECT_GT(agreement, 0.9975);
}

TEST_F(OriginalSamples, OfTheOldHdf5LayoutAreTheSameAsTheTextFile) {
  const raster::OpenedRaster opened = raster::open_raster(raster::Integrity::whole, sample_file("final.h5"));
  ASSERT_TRUE(opened.raster != nullptr) << core::to_string(opened.problems.front());
  EXPECT_EQ(opened.raster->rows(), 19u);
  EXPECT_EQ(opened.raster->info().columns, 146u);
  EXPECT_TRUE(opened.raster->info().counts);
  Samples samples(19 * 146);
  opened.raster->read_rows(0, 19, samples);
  const Samples text = test::ascii_samples(sample_file("exam2.asc"));
  ASSERT_EQ(samples.size(), text.size());
  const double worst = test::largest_component_difference(samples, text);
  std::printf("%-34s %5zu samples, largest deviation %g counts from the text file\n", "final.h5", text.size(), worst);
  EXPECT_EQ(worst, 0.0);
}

TEST_F(OriginalSamples, WithStcAgreeInMagnitude) {
  const scene::Scene scene = classic_scene("sim3_third.asc", "sim3.scr");
  const simulate::Recording recording = simulate::record(simulate::make_plan(scene, 2));
  EXPECT_EQ(recording.report.rows, 1u);
  EXPECT_EQ(recording.report.columns, 5003u);
  Samples ours = test::converted(recording.samples, 8, scene.simulations[2].lsb_v);
  Samples theirs = test::ascii_samples(sample_file("sim3_third.asc"));
  ASSERT_EQ(ours.size(), theirs.size());
  for (auto* list : {&ours, &theirs})
    for (auto& sample : *list) sample = std::abs(sample);
  const double agreement = test::correlation(ours, theirs);
  std::printf("%-34s %5zu samples, correlation of magnitudes %.5f\n", "sim3_third.asc", theirs.size(), agreement);
  EXPECT_GT(agreement, 0.9955);
}

}  // namespace original_test
}  // namespace sarsim

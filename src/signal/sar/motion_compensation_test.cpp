#include "signal/sar/motion_compensation.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "signal/measure/response_test_support.hpp"
#include "signal/sar/sar_test_support.hpp"

namespace sarsim::signal {
namespace motion_compensation_test {

using test::CutFigures;
using Values = std::vector<std::complex<double>>;

const core::WorkControl one{1, nullptr};
constexpr double prf_hz = 600.0;

// How an aircraft strays from its line: across, up and along, metres, and the speeds that go with it.
struct Wandering {
  double across_m = 0.0, up_m = 0.0, along_m = 0.0;
};

std::vector<TrackPoint> wandering(std::vector<TrackPoint> track, const Wandering& w) {
  for (TrackPoint& t : track) {
    const double x = t.time_s;
    t.position_m = t.position_m + core::Vec3{w.along_m * std::sin(2.0 * x), w.across_m * std::sin(4.0 * x + 0.4),
                                             w.up_m * std::cos(3.0 * x)};
    t.velocity_mps =
        t.velocity_mps + core::Vec3{2.0 * w.along_m * std::cos(2.0 * x), 4.0 * w.across_m * std::cos(4.0 * x + 0.4),
                                    -3.0 * w.up_m * std::sin(3.0 * x)};
  }
  return track;
}

struct Pass {
  SarEchoes ideal;    // by an antenna on the line
  SarEchoes strayed;  // by one that strays, its true track told
  MotionCompensation how;
};

Pass make_pass(const std::vector<test::PointTarget>& targets, const Wandering& w, double squint_rad = 0.0) {
  Pass pass;
  pass.ideal = test::thesis_echoes(600, prf_hz, squint_rad);
  pass.ideal.waveform.pulse_width_s = 0.0;
  pass.ideal.samples = 512;
  pass.ideal.first_delay_s -= 128.0 / 60e6;
  pass.strayed = pass.ideal;
  pass.strayed.track = wandering(pass.ideal.track, w);
  test::write_echoes(pass.ideal, targets, pass.ideal.track);
  test::write_echoes(pass.strayed, targets, pass.strayed.track);
  pass.how.reference = fitted_track(pass.ideal.track);
  pass.how.squint_rad = squint_rad;
  return pass;
}

// Compression of one range gate in azimuth: correlation with the phases of a point at each place along x.
Values azimuth_compressed(const SarEchoes& echoes, const core::Vec3& point_m, double step_m, std::size_t half) {
  Values cut;
  const double spacing_m = 0.5 * echoes.waveform.light_speed_mps / echoes.waveform.sample_rate_hz;
  const ReferenceTrack line = fitted_track(echoes.track);
  const double range_m = core::norm(point_m - line.position_m);
  const auto gate = static_cast<std::size_t>(
      std::lround((range_m - 0.5 * echoes.waveform.light_speed_mps * echoes.first_delay_s) / spacing_m));
  for (std::size_t i = 0; i <= 2 * half; ++i) {
    const core::Vec3 x = point_m + core::Vec3{(static_cast<double>(i) - static_cast<double>(half)) * step_m, 0.0, 0.0};
    std::complex<double> sum;
    for (std::size_t p = 0; p < echoes.track.size(); ++p) {
      const core::Vec3 r = x - echoes.track[p].position_m;
      const double v = -core::dot(r, echoes.track[p].velocity_mps) / core::norm(r);
      const double turns = echoes.waveform.carrier_hz * 2.0 * core::norm(r) / (echoes.waveform.light_speed_mps - v);
      sum += std::complex<double>(echoes.volts[p * echoes.samples + gate]) *
             std::polar(1.0, 2.0 * core::pi * (turns - std::round(turns)));
    }
    cut.push_back(sum / static_cast<double>(echoes.track.size()));
  }
  return cut;
}

constexpr double azimuth_null_m = 0.05657 * 10198.0 / (2.0 * 200.0);  // one second of flight

CutFigures figures(const SarEchoes& echoes, const core::Vec3& point_m = {}) {
  return test::measure_cut(azimuth_compressed(echoes, point_m, azimuth_null_m / 50.0, 520), 50.0);
}

void expect_restored(const CutFigures& got, const CutFigures& want) {
  EXPECT_NEAR(got.peak, want.peak, 0.02 * 50.0);
  EXPECT_NEAR(got.width, want.width, 0.01 * want.width);
  EXPECT_NEAR(got.pslr_db, want.pslr_db, 0.2);
  EXPECT_NEAR(got.islr_db, want.islr_db, 0.3);
  EXPECT_NEAR(got.height, want.height, 0.005 * want.height);
}

TEST(CompensateMotion, RestoresTheResponseOfThePointItIsMadeFor) {
  const Pass pass = make_pass({{{}}}, {1.0, 0.7, 0.0});
  const CutFigures want = figures(pass.ideal);
  SarEchoes untold = pass.strayed;
  untold.track = pass.ideal.track;
  EXPECT_LT(figures(untold).height, 0.5 * want.height);
  MotionCompensation how = pass.how;
  for (const bool second_order : {false, true}) {
    how.second_order = second_order;
    expect_restored(figures(compensate_motion(pass.strayed, how, one)), want);
  }
}

// Shifts of up to 78 samples: what is moved beyond the end of a pulse is not to be found at its beginning.
TEST(CompensateMotion, LosesWhatIsMovedOutOfTheWindow) {
  Pass pass = make_pass({}, {200.0, 0.0, 0.0});
  for (std::size_t p = 0; p < 600; ++p)
    for (std::size_t n = 490; n < 512; ++n)
      pass.strayed.volts[p * 512 + n] =
          static_cast<float>(std::exp(-0.1 * std::pow(static_cast<double>(n) - 501.0, 2)));
  pass.how.resample = false;
  const SarEchoes moved = compensate_motion(pass.strayed, pass.how, one);
  float begin = 0.0F;
  float end = 0.0F;
  for (std::size_t p = 0; p < 600; ++p)
    for (std::size_t n = 0; n < 512; ++n)
      (n < 300 ? begin : end) = std::max(n < 300 ? begin : end, std::abs(moved.volts[p * 512 + n]));
  EXPECT_GT(end, 0.9F);
  EXPECT_LT(begin, 0.01F);
}

TEST(CompensateMotion, RestoresEverySampleOfAPointInTheMiddleOfTheBeam) {
  const Pass pass = make_pass({{{}}}, {1.0, 0.7, 0.0});
  // Side lobes lie at other ranges than their point: second order would turn them.
  MotionCompensation how = pass.how;
  how.second_order = false;
  const SarEchoes got = compensate_motion(pass.strayed, how, one);
  // The pulse in the middle of the flight sees the point in the middle of its beam.
  // Not at the ends, where a moved row lacks what was not recorded.
  for (std::size_t i = 20; i < 492; ++i)
    ASSERT_LT(std::abs(got.volts[300 * 512 + i] - pass.ideal.volts[300 * 512 + i]), 5e-4F) << i;
}

// 500 m farther away the line of sight is half a degree flatter: 4 m up count 4 cm less, 8 rad.
TEST(CompensateMotion, OfSecondOrderRestoresOtherRanges) {
  const double range_m = std::hypot(10e3, 2e3) + 200.0 * 0.5 * core::exact_light_speed_mps / 60e6;
  const core::Vec3 far{0.0, std::sqrt(range_m * range_m - 4e6) - 10e3, 0.0};  // in the middle of a range gate
  const Pass pass = make_pass({{far}}, {0.0, 4.0, 0.0});
  const CutFigures want = figures(pass.ideal, far);
  MotionCompensation how = pass.how;
  expect_restored(figures(compensate_motion(pass.strayed, how, one), far), want);
  how.second_order = false;
  EXPECT_LT(figures(compensate_motion(pass.strayed, how, one), far).height, 0.9 * want.height);
}

// A small plane over level ground, seen from straight below to ten times its height, in samples of half that height:
// the turn of each of them is that of the geometry, also where it changes by radians from one to the next.
TEST(CompensateMotion, TurnsEachSampleByItsOwnRangeNearTheAntenna) {
  constexpr double height_m = 25.0;
  SarEchoes echoes = test::thesis_echoes(2, 100.0, 0.0);
  SarWaveform& wave = echoes.waveform;
  wave.carrier_hz = 15e9;
  wave.sample_rate_hz = 0.5 * wave.light_speed_mps / (0.5 * height_m);
  echoes.samples = 64;
  echoes.first_delay_s = 2.0 * 30.0 / wave.light_speed_mps;
  echoes.volts.assign(2 * 64, {1.0F, 0.0F});
  const core::Vec3 strays_m{0.0, 0.08, 0.06};
  MotionCompensation how;
  how.resample = false;
  how.reference = {.time_s = 0.0, .position_m = {0.0, 0.0, height_m}, .velocity_mps = {10.0, 0.0, 0.0}};
  how.scene_m = {0.0, 200.0, 0.0};
  for (std::size_t p = 0; p < 2; ++p)
    echoes.track[p] = {0.01 * static_cast<double>(p),
                       how.reference.position_m + core::Vec3{0.1 * static_cast<double>(p), 0.0, 0.0} + strays_m,
                       how.reference.velocity_mps};
  const SarEchoes got = compensate_motion(echoes, how, one);
  for (std::size_t i = 0; i < 40; ++i) {
    const double range_m = 30.0 + 0.5 * height_m * static_cast<double>(i);
    const core::Vec3 ground_m{0.0, std::sqrt(range_m * range_m - height_m * height_m), -height_m};
    const double turns = 2.0 * wave.carrier_hz * (core::norm(ground_m - strays_m) - range_m) / wave.light_speed_mps;
    const std::complex<double> left =
        std::complex<double>(got.volts[i]) * std::polar(1.0, -2.0 * core::pi * (turns - std::round(turns)));
    EXPECT_NEAR(std::arg(left), 0.0, 2e-3) << i;
  }
}

TEST(CompensateMotion, ResamplesPulsesToEvenSpacing) {
  const Pass pass = make_pass({{{}}}, {0.5, 0.3, 3.0});
  const CutFigures want = figures(pass.ideal);
  const SarEchoes got = compensate_motion(pass.strayed, pass.how, one);
  const double step_m = (got.track.back().position_m.x - got.track.front().position_m.x) / 599.0;
  for (std::size_t p = 0; p < 600; ++p) {
    ASSERT_NEAR(got.track[p].position_m.x, got.track[0].position_m.x + static_cast<double>(p) * step_m, 1e-6);
    ASSERT_NEAR(got.track[p].position_m.y, -10e3, 1e-6);
    ASSERT_NEAR(got.track[p].position_m.z, 2e3, 1e-6);
    ASSERT_NEAR(got.track[p].time_s, pass.how.reference.time_s + got.track[p].position_m.x / 200.0, 1e-9);
    ASSERT_EQ(got.track[p].velocity_mps, pass.how.reference.velocity_mps);
  }
  // The flight is 5 m longer or shorter: compared is the place and the loss, not the width.
  const CutFigures restored = figures(got);
  EXPECT_NEAR(restored.peak, want.peak, 0.02 * 50.0);
  EXPECT_NEAR(restored.height, want.height, 0.01 * want.height);
  EXPECT_NEAR(restored.pslr_db, want.pslr_db, 0.2);
}

TEST(CompensateMotion, WorksUnderASquint) {
  const double squint_rad = 20.0 * core::pi / 180.0;
  const Pass pass = make_pass({{{}}}, {0.2, 0.1, 1.0}, squint_rad);
  const SarEchoes got = compensate_motion(pass.strayed, pass.how, one);
  const PointGrid grid{{-520.0 * 0.03, 0.0, 0.0}, {}, {0.03, 0.0, 0.0}, 1, 1041};
  const auto cut = [&](const SarEchoes& echoes) {
    const auto values = back_project(echoes, grid, {}, one);
    return test::measure_cut({values.begin(), values.end()}, 51.0);
  };
  const CutFigures want = cut(pass.ideal);
  const CutFigures restored = cut(got);
  EXPECT_NEAR(restored.peak, want.peak, 1.0);
  EXPECT_NEAR(restored.height, want.height, 0.01 * want.height);
  EXPECT_NEAR(restored.pslr_db, want.pslr_db, 0.5);
  SarEchoes untold = pass.strayed;
  untold.track = pass.ideal.track;
  EXPECT_LT(cut(untold).height, 0.6 * want.height);
}

TEST(CompensateMotion, OfAStraightFlightChangesNothing) {
  const Pass pass = make_pass({{{}}, {{50.0, 40.0, 0.0}}}, {});
  const SarEchoes got = compensate_motion(pass.ideal, pass.how, one);
  float largest = 0.0F;
  for (std::size_t i = 0; i < got.volts.size(); ++i)
    largest = std::max(largest, std::abs(got.volts[i] - pass.ideal.volts[i]));
  EXPECT_LT(largest, 2e-6F);
}

TEST(CompensateMotion, GivesTheSameBytesForAnyNumberOfThreads) {
  const Pass pass = make_pass({{{}}}, {0.5, 0.3, 3.0});
  const SarEchoes expected = compensate_motion(pass.strayed, pass.how, one);
  for (const unsigned threads : {2u, 3u, 8u}) {
    const SarEchoes got = compensate_motion(pass.strayed, pass.how, {threads, nullptr});
    EXPECT_EQ(std::memcmp(got.volts.data(), expected.volts.data(), got.volts.size() * sizeof(got.volts[0])), 0);
  }
}

TEST(CompensateMotion, RefusesWhatContradictsItself) {
  const Pass pass = make_pass({}, {});
  const auto refuses = [&](const auto& spoil) {
    SarEchoes echoes = pass.ideal;
    MotionCompensation how = pass.how;
    spoil(echoes, how);
    EXPECT_THROW((void)compensate_motion(echoes, how, one), std::invalid_argument);
  };
  refuses([](SarEchoes& e, MotionCompensation&) { e.volts.pop_back(); });
  refuses([](SarEchoes& e, MotionCompensation&) { e.waveform.sample_rate_hz = 0.0; });
  refuses([](SarEchoes&, MotionCompensation& h) { h.reference.velocity_mps = {}; });
  refuses([](SarEchoes&, MotionCompensation& h) { h.scene_m = h.reference.at(3.0); });
  refuses([](SarEchoes&, MotionCompensation& h) { h.squint_rad = 0.5 * core::pi; });
  refuses([](SarEchoes& e, MotionCompensation&) { std::swap(e.track[3], e.track[4]); });
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)compensate_motion(pass.ideal, pass.how, {1, &stop}), core::Interrupted);
}

TEST(ResampleAzimuth, LeavesASinglePulseAlone) {
  SarEchoes echoes = test::thesis_echoes(1, prf_hz);
  test::write_echoes(echoes, {{{}}}, echoes.track);
  const SarEchoes got = resample_azimuth(echoes, {0.0, {}, {1.0, 0.0, 0.0}}, 0.0, one);
  EXPECT_EQ(got.volts, echoes.volts);
  EXPECT_EQ(got.track[0].position_m, echoes.track[0].position_m);
}

TEST(FittedTrack, IsTheLineOfAStraightFlight) {
  const auto track = test::straight_flight({1e6, 2e5, 3e4}, {200.0, -10.0, 3.0}, 600.0, 101);
  const ReferenceTrack line = fitted_track(track);
  for (const TrackPoint& t : track) EXPECT_LT(core::norm(line.at(t.time_s) - t.position_m), 1e-8);
  EXPECT_LT(core::norm(line.velocity_mps - core::Vec3{200.0, -10.0, 3.0}), 1e-8);
}

TEST(FittedTrack, IsTheLeastSquaresLineOfThreePoints) {
  // By hand: places 0, 0, 3 at times 0, 1, 2 fit to -0.5 + 1.5 t.
  const ReferenceTrack line =
      fitted_track(std::vector<TrackPoint>{{0.0, {}, {}}, {1.0, {}, {}}, {2.0, {0.0, 3.0, 0.0}, {}}});
  EXPECT_NEAR(line.at(0.0).y, -0.5, 1e-12);
  EXPECT_NEAR(line.velocity_mps.y, 1.5, 1e-12);
  EXPECT_NEAR(line.time_s, 1.0, 1e-12);
}

TEST(FittedTrack, OfOnePulseFliesAsThePulseDoes) {
  const ReferenceTrack line = fitted_track(std::vector<TrackPoint>{{4.0, {1.0, 2.0, 3.0}, {5.0, 6.0, 7.0}}});
  EXPECT_EQ(line.velocity_mps, (core::Vec3{5.0, 6.0, 7.0}));
  EXPECT_EQ(line.position_m, (core::Vec3{1.0, 2.0, 3.0}));
  EXPECT_EQ(fitted_track({}).velocity_mps, core::Vec3{});
}

TEST(DistanceFrom, IsThatOfTheWholeLine) {
  EXPECT_NEAR(distance_from({0.0, {1.0, 0.0, 0.0}, {0.0, 0.0, 5.0}}, {4.0, 4.0, 77.0}), 5.0, 1e-12);
  EXPECT_NEAR(distance_from({0.0, {1.0, 0.0, 0.0}, {}}, {1.0, 3.0, 4.0}), 5.0, 1e-12);
}

}  // namespace motion_compensation_test
}  // namespace sarsim::signal

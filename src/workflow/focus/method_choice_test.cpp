#include "workflow/focus/method_choice.hpp"
#include "workflow/focus/focus.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/maths/constants.hpp"
#include "core/maths/turns.hpp"
#include "scene/language/scene_writer.hpp"
#include "signal/sar/image_test_value.hpp"
#include "signal/sar/reference_track.hpp"
#include "workflow/focus/focus_test_script.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/focus/motion_residual.hpp"
#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace method_choice_test {

using testing::HasSubstr;

constexpr double height_m = 1500.0;

// C band from 3 km, 100 m/s along y; the antenna strays sideways and up by what `stray` says at a time.
struct Stray {
  double aside_m = 0.0, up_m = 0.0;
  double period_s = 1.0, phase = 0.0;
  double climb = 0.0;
};

scene::Scene stray_scene(const Stray& stray, const std::vector<core::Vec3>& targets_m) {
  scene::Scene scene = sar_scene(500.0, targets_m, 0.8);
  const double ground_m = std::sqrt(3000.0 * 3000.0 - height_m * height_m);
  scene.platforms[1] = simulate::moving("Plane", {-ground_m, 0.0, height_m}, {0.0, 100.0, 0.0});
  std::vector<core::Knot> aside, up;
  for (double t = -1.2; t < 1.2; t += 0.002) {
    const double turn = 2.0 * core::pi * t / stray.period_s + stray.phase;
    aside.push_back({t, -ground_m + stray.aside_m * std::sin(turn)});
    up.push_back({t, height_m + 100.0 * stray.climb * t + stray.up_m * std::cos(1.3 * turn)});
  }
  scene.platforms[1].trajectory_m.part[0] = simulate::lines(aside);
  scene.platforms[1].trajectory_m.part[2] = simulate::lines(up);
  scene.radars[0].pulse_width_s = 500e-9;
  scene.simulations[0].range_start_m = 2850.0;
  scene.simulations[0].range_end_m = 3250.0;
  return scene;
}

class MethodChoice : public FocusOfScript {
 protected:
  MethodChoice() : FocusOfScript(stray_scene({}, {{}})) {
    request_.ground_m = 0.0;
    request_.output = folder_ / "a.img";
    request_.force = true;
  }

  [[nodiscard]] MeasureReport measured() const {
    MeasureRequest request;
    request.image = request_.output;
    request.threads = 2;
    return measure(request, {});
  }
  [[nodiscard]] static core::Problem one_that_says(const core::Problems& problems, const std::string& what) {
    for (const core::Problem& problem : problems)
      if (problem.message.find(what) != std::string::npos) return problem;
    return {};
  }
};

// What an image shows of a point, against the place, the phase and the mean amplitude that it should have.
struct Found {
  double phase_rad = 0.0, lost_db = 0.0, azimuth_m = 0.0;
};

Found found_in(const FocusReport& report, const FocusRequest& request, const core::Vec3& point_m) {
  const FocusInput input = open_focus_input(request.input, {});
  const signal::FocusedImage image = signal::in_memory(report.image);
  const signal::ImagePlace place = signal::place_of(image.frame, point_m);
  const auto peak = signal::measure_point(image, signal::reader_of(image), place, 3.0).value();
  const double moved_m = peak.place.azimuth_m - place.azimuth_m;
  const double turns = 2.0 * place.range_m * image.carrier_hz / image.light_speed_mps -
                       image.azimuth.spectrum_centre_per_m * moved_m -
                       image.range.spectrum_centre_per_m * (peak.place.range_m - place.range_m);
  return {std::remainder(peak.phase_rad + 2.0 * core::pi * turns, 2.0 * core::pi),
          -20.0 * std::log10(peak.amplitude / sar_targets(*input.acquisition, input.echoes).at(0).amplitude), moved_m};
}

// 20 % or 0.02 rad are promised. The grid leaves out up to 0.4 % of the echoes of each axis, and the sampled
// band the skirts of the chirp.
void expect_predicted(const MotionResidual& predicted, const Found& found, const std::string& what) {
  EXPECT_NEAR(predicted.phase_rad, found.phase_rad, std::max(0.02, 0.2 * std::abs(predicted.phase_rad))) << what;
  EXPECT_NEAR(predicted.lost_db(), found.lost_db, std::max(0.09, 0.2 * predicted.lost_db())) << what;
  EXPECT_NEAR(predicted.azimuth_m, found.azimuth_m, 0.03 * predicted.cell_m) << what;
}

std::optional<MotionResidual> predicted_for(const FocusRequest& request, const FocusReport& report,
                                            TakenFlight::Kind kind) {
  const FocusInput input = open_focus_input(request.input, {});
  TakenFlight flight{.kind = kind, .how = compensation_of(input, MotionOrder::second, 0.0, report.options)};
  const double speed_mps = core::norm(flight.how.reference.velocity_mps);
  flight.carrier_per_m = report.options.doppler_centroid_hz / speed_mps;
  const double half_per_m = 0.5 * 500.0 / speed_mps;
  if (kind != TakenFlight::Kind::flown)
    flight.kept = {flight.carrier_per_m - half_per_m, flight.carrier_per_m + half_per_m};
  return worst_motion_residual(*input.acquisition, input.echoes, flight);
}

TEST_F(MethodChoice, PredictsWhatTheImageOfEachMethodShows) {
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int number = 0; number < 8; ++number) {
    const int method = number % 3;
    const double max_m = method == 0 ? 0.003 : 0.8;
    const Stray stray{between(-max_m, max_m), between(-max_m, max_m), between(0.4, 3.0), between(0.0, 6.0),
                      method == 0 ? 0.0 : between(-0.1, 0.1)};
    const double above_m = method == 1 ? 0.0 : between(-12.0, 12.0);
    const core::Vec3 point_m{between(-60.0, 60.0), between(-20.0, 20.0), method == 0 ? 0.0 : above_m};
    write(stray_scene(stray, {point_m}));
    request_.algorithm = method == 2 ? FocusAlgorithm::back_projection : FocusAlgorithm::omega_k;
    request_.motion.reset();
    if (method != 2) request_.motion = method == 0 ? MotionOrder::none : MotionOrder::second;
    const FocusReport report = focus(request_, {});
    const auto kind = method == 0   ? TakenFlight::Kind::even
                      : method == 1 ? TakenFlight::Kind::compensated
                                    : TakenFlight::Kind::flown;
    const auto predicted = predicted_for(request_, report, kind);
    ASSERT_TRUE(predicted) << number;
    expect_predicted(*predicted, found_in(report, request_, point_m), fmt::format("{} by method {}", number, method));
  }
}

// By the finding's flight: climbing a little, in wind, with points away from the middle of the swath.
TEST_F(MethodChoice, MakesImagesOfLevelGroundRightWhateverTheFlight) {
  std::mt19937 random(8);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int number = 0; number < 4; ++number) {
    const Stray stray{between(-2.0, 2.0), between(-1.5, 1.5), between(0.7, 3.0), between(0.0, 6.0),
                      std::tan(between(-10.0, 10.0) / core::deg_per_rad)};
    write(stray_scene(stray, {{-90.0, 12.0, 0.0}, {10.0, -20.0, 0.0}, {85.0, 5.0, 0.0}}));
    const FocusReport report = focus(request_, {});
    for (const MeasuredTarget& target : measured().targets) {
      ASSERT_TRUE(target.found) << number;
      EXPECT_NEAR(target.amplitude_error_db(), 0.0, 0.1) << number;
      EXPECT_NEAR(target.phase_error_rad(), 0.0, 0.02) << number;
    }
    for (const core::Problem& problem : report.problems)
      EXPECT_THAT(problem.message, testing::Not(HasSubstr("rad rms"))) << number;
  }
}

TEST_F(MethodChoice, SaysWhatBothMethodsLeave) {
  write(stray_scene({.aside_m = 3.0, .up_m = 2.0, .period_s = 1.1}, {{-90.0, 60.0, 0.0}, {85.0, -60.0, 0.0}}));
  const FocusReport report = focus(request_, {});
  EXPECT_EQ(report.algorithm, FocusAlgorithm::back_projection);
  const core::Problem note = one_that_says(report.problems, "back-projection instead of omega-k");
  EXPECT_EQ(note.severity, core::Severity::note);
  EXPECT_THAT(note.message, HasSubstr("motion compensation would leave"));
  EXPECT_THAT(note.message, HasSubstr("back-projection on its grid leaves 0.000 rad and 0.00 dB"));
  // What check says is the same.
  const core::Problems early = diagnose_focus(open_focus_input(request_.input, {}));
  EXPECT_EQ(one_that_says(early, "back-projection instead of omega-k").message, note.message);
}

// 211 pulses a second tell all Doppler frequencies at the carrier, not those at the upper end of its half octave.
TEST_F(MethodChoice, LeavesABandWhoseUpperEndThePulsesAliasToBackProjection) {
  scene::Scene scene = sar_scene(600.0, {{0.0, 0.0, 0.0}}, 3.0);
  scene.platforms[1] = simulate::moving("Plane", {-500.0, 0.0, 0.0}, {0.0, 100.0, 0.0});
  scene.radars[0].carrier_hz = 300e6;
  scene.radars[0].bandwidth_hz = 150e6;
  scene.simulations[0].sample_rate_hz = 225e6;
  scene.simulations[0].range_start_m = 400.0;
  scene.simulations[0].range_end_m = 800.0;
  for (const double prf_hz : {211.0, 400.0}) {
    scene.radars[0].prf_hz = prf_hz;
    write(scene);
    const FocusReport report = focus(request_, {});
    const bool aliased = prf_hz == 211.0;
    EXPECT_EQ(report.algorithm, aliased ? FocusAlgorithm::back_projection : FocusAlgorithm::omega_k);
    const core::Problem note = one_that_says(report.problems, "back-projection instead of omega-k: omega-k would lose");
    EXPECT_THAT(note.message, HasSubstr(aliased ? "back-projection on its grid leaves nothing" : ""));
    EXPECT_EQ(note.message.empty(), !aliased);
    const MeasuredTarget found = measured().targets.front();
    ASSERT_TRUE(found.found) << prf_hz;
    EXPECT_NEAR(found.amplitude_error_db(), 0.0, 0.1) << prf_hz;
    EXPECT_NEAR(found.phase_error_rad(), 0.0, 0.02) << prf_hz;
  }
}

// A straight flight, whose 120 pulses a second alias most of what an isotropic antenna sees.
TEST_F(MethodChoice, LeavesEchoesThatThePulsesAliasToBackProjection) {
  scene::Scene scene = stray_scene({}, {{}});
  scene.radars[0].prf_hz = 120.0;
  write(scene);
  const FocusReport report = focus(request_, {});
  EXPECT_EQ(report.algorithm, FocusAlgorithm::back_projection);
  const core::Problem note = one_that_says(report.problems, "back-projection instead of omega-k: omega-k would lose");
  EXPECT_THAT(note.message, HasSubstr("dB of target 1, whose Doppler frequencies are aliased; back-projection"));
  const MeasuredTarget found = measured().targets.front();
  ASSERT_TRUE(found.found);
  EXPECT_NEAR(found.amplitude_error_db(), 0.0, 0.1);
  EXPECT_NEAR(found.phase_error_rad(), 0.0, 0.02);
}

TEST_F(MethodChoice, KeepsOmegaKWhereItIsRightAndCompensatesWhatWouldShow) {
  // 2 mm of sway: a twenty-eighth of the wavelength, below a sixteenth, but 0.4 rad.
  write(stray_scene({.aside_m = 0.002, .up_m = 0.002, .period_s = 0.9}, {{}}));
  const FocusReport report = focus(request_, {});
  EXPECT_EQ(report.algorithm, FocusAlgorithm::omega_k);
  EXPECT_EQ(report.motion, MotionOrder::second);
  EXPECT_NEAR(measured().targets.front().phase_error_rad(), 0.0, 0.02);
  write(stray_scene({}, {{}}));
  const FocusReport straight = focus(request_, {});
  EXPECT_EQ(straight.motion, MotionOrder::none);
  EXPECT_EQ(one_that_says(straight.problems, "omega-k").message, "");
}

TEST_F(MethodChoice, WarnsOfATargetOffTheGroundThatNoMethodGetsRight) {
  write(stray_scene({.aside_m = 1.5, .up_m = 1.0, .period_s = 1.1}, {{0.0, 0.0, 8.0}}));
  const FocusReport report = focus(request_, {});
  const core::Problem warning = one_that_says(report.problems, "rad rms residual phase at target 1");
  EXPECT_EQ(warning.severity, core::Severity::warning);
  const MeasuredTarget found = measured().targets.front();
  ASSERT_TRUE(found.found);
  EXPECT_GT(std::max(std::abs(found.phase_error_rad()) / 0.02, -found.amplitude_error_db() / 0.1), 1.0);
}

// From a straight line the image of a point is the same for any height of the ground; so is what is measured in it.
TEST_F(MethodChoice, MeasuresByBackProjectionPointsOffTheGround) {
  std::mt19937 random(21);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  request_.algorithm = FocusAlgorithm::back_projection;
  for (int number = 0; number < 5; ++number) {
    const double above_m = between(-150.0, 250.0);
    write(stray_scene({.climb = number % 2 == 0 ? 0.0 : between(-0.1, 0.1)}, {{between(-60.0, 20.0), 8.0, above_m}}));
    for (const double ground_m : {0.0, 0.5 * above_m, 2.0 * above_m}) {
      request_.ground_m = ground_m;
      static_cast<void>(focus(request_, {}));
      const MeasuredTarget found = measured().targets.front();
      ASSERT_TRUE(found.found) << number << ' ' << ground_m;
      EXPECT_NEAR(found.amplitude_error_db(), 0.0, 0.1) << number << ' ' << ground_m;
      EXPECT_NEAR(found.phase_error_rad(), 0.0, 0.02) << number << ' ' << ground_m;
    }
  }
}

// Where the ground lies straight below, a metre of range is many of the ground.
TEST_F(MethodChoice, MeasuresByBackProjectionPointsBelowTheLine) {
  request_.algorithm = FocusAlgorithm::back_projection;
  request_.ground_m.reset();
  for (const double aside_m : {0.0, 0.5, 2.0, 5.0, 15.0}) {
    scene::Scene scene = sar_scene(200.0, {{aside_m, 0.0, 0.0}}, 1.0);
    scene.platforms[1] = simulate::moving("Plane", {0.0, 0.0, 100.0}, {0.0, 10.0, 0.0});
    scene.radars[0].carrier_hz = 5e9;
    scene.radars[0].bandwidth_hz = 300e6;
    scene.radars[0].pulse_width_s = 250e-9;
    scene.simulations[0].sample_rate_hz = 420e6;
    scene.simulations[0].range_start_m = 90.0;
    scene.simulations[0].range_end_m = 150.0;
    write(scene);
    static_cast<void>(focus(request_, {}));
    const MeasuredTarget found = measured().targets.front();
    ASSERT_TRUE(found.found) << aside_m;
    EXPECT_NEAR(found.amplitude_error_db(), 0.0, 0.1) << aside_m;
    EXPECT_NEAR(found.phase_error_rad(), 0.0, 0.02) << aside_m;
  }
}

// A spotlight around the scene.
std::string turn_text(double angle_rad, double radius_m, double prf_hz,
                      const std::string& targets = "[[0, 0, 0], [1.2, 0.7, 0], [-0.8, 1.4, 0]]") {
  constexpr double speed_mps = 100.0;
  const double half_s = 0.5 * radius_m * angle_rad / speed_mps;
  const double range_m = std::hypot(radius_m, 300.0);
  return fmt::format(R"(format = "sarsim 2"
[[platform]]
name = "P"
path = {{ type = "legs", start = [{:.9f}, {:.9f}, 300.0], heading = "{:.9f} deg", speed = "{} m/s", start_time = "{:.9f} s", legs = [{{ leg = "turn", angle = "{:.9f} deg", radius = "{} m" }}] }}
rotation = {{ type = "look-at", point = [0, 0, 0] }}
[[target]]
positions = {}
[[radar]]
name = "R"
platform = "P"
pulse = {{ type = "chirp", bandwidth = "150 MHz", width = "100 ns" }}
repetition = "{} Hz"
carrier = "9.6 GHz"
power = "1 kW"
[[recording]]
radar = "R"
file = "x.h5"
format = "hdf5"
sample_rate = "200 MHz"
range = ["{} m", "{} m"]
time = ["{} s", "{} s"]
)",
                     -radius_m * std::cos(0.5 * angle_rad), -radius_m * std::sin(0.5 * angle_rad),
                     -0.5 * angle_rad * core::deg_per_rad, speed_mps, -half_s, angle_rad * core::deg_per_rad, radius_m,
                     targets, prf_hz, range_m - 40.0, range_m + 40.0, -0.999 * half_s, 0.999 * half_s);
}

TEST_F(MethodChoice, OfAFlightAroundTheSceneIsAGridOfGroundThatHoldsItsTargets) {
  for (const double degrees : {120.0, 360.0}) {
    test::put(folder_ / "turn.toml", turn_text(degrees / core::deg_per_rad, 500.0, 60.0));
    request_.input.path = (folder_ / "turn.toml").string();
    const FocusReport report = focus(request_, {});
    EXPECT_EQ(report.algorithm, FocusAlgorithm::back_projection);
    EXPECT_EQ(report.grid, FocusGrid::ground);
    EXPECT_THAT(one_that_says(report.problems, "flies around").message, HasSubstr("instead of omega-k"));
    // The directions flown: of the full circle 4/lambda cos b along both axes, b the grazing angle.
    const signal::FocusedImage& image = report.image.image;
    const double per_m = 4.0 * 9.6e9 / core::exact_light_speed_mps * 500.0 / std::hypot(500.0, 300.0);
    const double along = degrees > 300.0 ? 1.0 : std::sin(0.5 * degrees / core::deg_per_rad);
    EXPECT_LT(image.azimuth.step_m, 1.0 / (per_m * along));
    EXPECT_GT(image.azimuth.step_m, 0.8 / (per_m * along));
    const FocusInput input = open_focus_input(request_.input, {});
    const signal::ReferenceTrack line = signal::fitted_track(input.echoes.track);
    const std::vector<SarTarget> targets = sar_targets(*input.acquisition, input.echoes);
    const signal::FocusedImage values = signal::in_memory(report.image);
    const std::vector<core::Vec3> places_m{{0, 0, 0}, {1.2, 0.7, 0}, {-0.8, 1.4, 0}};
    for (std::size_t t = 0; t < places_m.size(); ++t) {
      const signal::ImagePlace place = signal::place_of(image.frame, places_m[t]);
      const std::complex<double> value =
          signal::test::value_at(values, place) / targets.at(t).amplitude *
          core::turned_exactly(2.0 * signal::distance_from(line, places_m[t]) * 9.6e9 / core::exact_light_speed_mps);
      // Two others at 1.4 m, of whose responses J0(2 pi k x), k = 55 per metre, 0.036 each is left at most.
      EXPECT_NEAR(std::abs(value), 1.0, 0.075) << degrees << " " << t;
      EXPECT_NEAR(std::arg(value), 0.0, 0.075) << degrees << " " << t;
    }
  }
}

// A point above the plane of the grid is laid towards the antenna, by its height times that of the antenna over the
// distance on the ground: from the middle of the arc 0.6 m for each metre.
TEST_F(MethodChoice, OfAFlightAroundTheSceneLaysWhatIsAboveThePlaneTowardsTheAntenna) {
  test::put(folder_ / "turn.toml",
            turn_text(60.0 / core::deg_per_rad, 500.0, 60.0, "[[0, 0, 0], [1.2, 0.7, 0.2], [-0.8, 1.4, -0.15]]"));
  request_.input.path = (folder_ / "turn.toml").string();
  request_.output = folder_ / "turn.img";
  request_.ground_m = 0.0;
  request_.algorithm = FocusAlgorithm::back_projection;
  request_.grid = FocusGrid::ground;
  const FocusReport report = focus(request_, {});
  ASSERT_EQ(report.grid, FocusGrid::ground);
  const FocusInput input = open_focus_input(request_.input, {});
  const signal::FocusedImage image = signal::in_memory(report.image);
  const auto theories =
      theory_on_image({*input.acquisition, input.echoes, report.options, true, false}, report.image.image, {});
  const std::vector<core::Vec3> points_m{{0, 0, 0}, {1.2, 0.7, 0.2}, {-0.8, 1.4, -0.15}};
  ASSERT_EQ(theories.size(), points_m.size());
  for (std::size_t t = 0; t < points_m.size(); ++t) {
    const signal::ImagePlace below = signal::place_of(report.image.image.frame, points_m[t]);
    const double laid_m =
        std::hypot(theories[t].place.azimuth_m - below.azimuth_m, theories[t].place.range_m - below.range_m);
    EXPECT_NEAR(laid_m, std::abs(points_m[t].z) * 300.0 / 500.0, 0.02) << t;
    // The peak that back-projection makes: from so many directions it stays above the point by up to what it is laid,
    // as long as that is a part of the range cell.
    const auto found = signal::measure_point(image, signal::reader_of(image), theories[t].place, 0.15);
    ASSERT_TRUE(found) << t;
    EXPECT_NEAR(found->place.azimuth_m, theories[t].place.azimuth_m, 0.15) << t;
    EXPECT_NEAR(found->place.range_m, theories[t].place.range_m, 0.15) << t;
  }
}

TEST_F(MethodChoice, TakesBackProjectionAtOnceWhereTheAntennaTurnsBack) {
  scene::Scene scene = stray_scene({}, {{}});
  std::vector<core::Knot> along;
  for (double t = -1.2; t < 1.2; t += 0.002) along.push_back({t, 20.0 * t + 0.4 * std::sin(2.0 * core::pi * t / 0.05)});
  scene.platforms[1].trajectory_m.part[1] = simulate::lines(along);
  write(scene);
  const FocusReport report = focus(request_, {});
  EXPECT_EQ(report.algorithm, FocusAlgorithm::back_projection);
  EXPECT_THAT(one_that_says(report.problems, "reverses along its track").message, HasSubstr("instead of omega-k"));
}

}  // namespace method_choice_test
}  // namespace sarsim::workflow

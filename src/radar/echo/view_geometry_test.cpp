#include "radar/echo/view_geometry.hpp"

#include <limits>

#include "radar/echo/echo_test_support.hpp"
#include "radar/path/light_time.hpp"

namespace sarsim::radar {
namespace sight_test {

constexpr double c = core::exact_light_speed_mps;

core::Mat3 random_matrix(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> unit(-size, size);
  core::Mat3 m;
  for (core::Vec3& row : m.row) row = {unit(random), unit(random), unit(random)};
  return m;
}

core::Mat3 yaw(double angle) {
  return {{core::Vec3{std::cos(angle), std::sin(angle), 0}, core::Vec3{-std::sin(angle), std::cos(angle), 0},
           core::Vec3{0, 0, 1}}};
}
core::Mat3 pitch(double angle) {
  return {{core::Vec3{1, 0, 0}, core::Vec3{0, std::cos(angle), std::sin(angle)},
           core::Vec3{0, -std::sin(angle), std::cos(angle)}}};
}

EchoBatch batch_of(std::size_t count, bool bends = true) {
  EchoBatch echoes;
  for (std::size_t i = 0; i < count; ++i)
    bends ? echoes.add(-1.0, -2.0, PulseClock{-3.0, -4.0}) : echoes.add(-1.0, -2.0, -3.0);
  return echoes;
}

struct Written {
  EchoBatch echoes;
  bool possible = false;
};

Written written(const PointArrays& points, const ViewFrame& frame, const AntennaView& antenna = {},
                const CurveTables& curves = {}) {
  Written result{batch_of(points.size()), false};
  result.possible = write_echoes(points, {0, points.size()}, frame, antenna, curves, result.echoes, 0);
  return result;
}

PointArrays random_points(std::mt19937& random, std::size_t count, bool cosine) {
  std::uniform_real_distribution<double> place(-300.0, 300.0), size(0.1, 4.0), angle(-core::pi, core::pi);
  PointArrays points;
  if (cosine) points.law = PointArrays::Law::cosine;
  for (std::size_t i = 0; i < count; ++i) {
    points.x_m.push_back(place(random));
    points.y_m.push_back(place(random));
    points.z_m.push_back(place(random));
    points.root_rcs_m.push_back(size(random));
    if (!cosine) continue;
    const core::Vec3 n = core::direction(angle(random), 0.5 * angle(random));
    points.normal_x.push_back(n.x);
    points.normal_y.push_back(n.y);
    points.normal_z.push_back(n.z);
  }
  return points;
}

ViewFrame random_frame(std::mt19937& random) {
  ViewFrame frame;
  frame.world_from_platform = yaw(0.7) * pitch(-0.3);
  frame.world_from_platform_rate = random_matrix(random, 0.2);
  frame.origin_m = {900.0, 2500.0, -400.0};
  frame.velocity_mps = {-120.0, 300.0, 15.0};
  frame.light_speed_mps = c;
  frame.amplitude_scale = 0.0123;
  return frame;
}

// sin(x)/x of an offset, thesis A.17: x = 0.88 pi sin(offset)/beamwidth, nothing from 90 degrees on.
double sinx(double offset, double beamwidth) {
  if (std::abs(offset) >= 0.5 * core::pi) return 0.0;
  const double x = 0.88 * core::pi * std::sin(offset) / beamwidth;
  return x == 0.0 ? 1.0 : std::sin(x) / x;
}

struct ScalarEcho {
  double delay_s, amplitude, doppler, dilation_rate;
};

// Plainly written: the flight, radar equation.
ScalarEcho plain_echo(const PointArrays& points, std::size_t i, const ViewFrame& frame) {
  const core::Vec3 point{points.x_m[i], points.y_m[i], points.z_m[i]};
  const core::Vec3 look = frame.origin_m + frame.world_from_platform * point;
  const core::Vec3 velocity = frame.velocity_mps + frame.world_from_platform_rate * point;
  const bool thesis = frame.light_time == LightTime::thesis;
  const Flight flight =
      thesis ? thesis_flight_of(look, velocity, c)
             : flight_of(look, {velocity, frame.anchor_s, frame.radar_mps, frame.radar_slope_mps, {}, {}, 0.0}, c);
  double amplitude = frame.amplitude_scale * points.root_rcs_m[i];
  if (!points.normal_x.empty()) {
    const core::Vec3 of_platform{points.normal_x[i], points.normal_y[i], points.normal_z[i]};
    const double early_s = frame.moves ? flight.path.out_m / c - frame.anchor_s : 0.0;
    const core::Vec3 normal =
        frame.world_from_platform * of_platform + early_s * (frame.world_from_platform_rate * of_platform);
    amplitude *=
        std::sqrt(std::max(0.0, -core::dot(normal, flight.line_of_sight_m) / core::norm(flight.line_of_sight_m)));
  }
  if (frame.spreading) amplitude /= flight.path.out_m * flight.path.back_m;
  if (!frame.bends) return {flight.delay_s, amplitude, flight.doppler, 0.0};
  const FlightMotion motion{velocity,
                            frame.anchor_s,
                            frame.radar_mps,
                            frame.radar_slope_mps,
                            frame.acceleration_mps2 + frame.world_from_platform_acceleration * point,
                            frame.radar_mps2,
                            frame.back_s};
  Flight bent = flight;
  bend(bent, motion, c);
  return {bent.delay_s, amplitude, bent.doppler, bend_of(flight.line_of_sight_m, motion, c)};
}

// What moves, and by which rule.
std::vector<ViewFrame> frames_of_all_kinds(std::mt19937& random) {
  ViewFrame thesis = random_frame(random);
  thesis.light_time = LightTime::thesis;
  ViewFrame moving = random_frame(random);
  moving.moves = true;
  moving.anchor_s = 9e-6;
  ViewFrame both = moving;
  both.radar_mps = {7600.0, -50.0, 20.0};
  both.radar_slope_mps = {7601.0, -52.0, 23.0};
  both.bends = true;
  both.acceleration_mps2 = {30.0, -9.0, 4.0};
  both.radar_mps2 = {1.0, -8.0, 2.0};
  both.back_s = 3e-3;
  both.world_from_platform_acceleration = random_matrix(random, 0.05);
  ViewFrame still = random_frame(random);
  still.velocity_mps = {};
  still.world_from_platform_rate = {{core::Vec3{}, core::Vec3{}, core::Vec3{}}};
  still.world_from_platform_acceleration = still.world_from_platform_rate;
  ViewFrame from_moving = still;
  from_moving.radar_mps = {-200.0, 100.0, 30.0};
  from_moving.radar_slope_mps = {-205.0, 103.0, 31.0};
  from_moving.bends = true;
  ViewFrame upright = from_moving;
  upright.world_from_platform = ViewFrame().world_from_platform;
  upright.bends = false;
  ViewFrame even = upright;
  even.radar_slope_mps = even.radar_mps;
  return {thesis, moving, both, still, from_moving, upright, even};
}

// Bends go where there is room for them; without, points at rest take a shorter way.
void expect_scalar_formulas(const PointArrays& points, const ViewFrame& frame, bool room_for_bends) {
  const std::size_t count = points.size();
  EchoBatch echoes = batch_of(count + 2, room_for_bends);
  ASSERT_EQ(echoes.dilation_rate.empty(), !room_for_bends);
  EXPECT_TRUE(write_echoes(points, {0, points.size()}, frame, {}, {}, echoes, 1));
  for (const std::size_t neighbour : {std::size_t{0}, count + 1}) {
    EXPECT_EQ(echoes.delay_s[neighbour], -1.0);
    EXPECT_EQ(echoes.amplitude_sqrt_w[neighbour], -2.0);
    EXPECT_EQ(echoes.doppler[neighbour], -3.0);
    if (room_for_bends) {
      EXPECT_EQ(echoes.dilation_rate[neighbour], -4.0);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const ScalarEcho expected = plain_echo(points, i, frame);
    EXPECT_NEAR(echoes.delay_s[i + 1], expected.delay_s, 1e-12 * expected.delay_s);
    // Near the edge of the back side a root multiplies the rounding of the cosine.
    EXPECT_NEAR(echoes.amplitude_sqrt_w[i + 1], expected.amplitude,
                1e-12 * frame.amplitude_scale * 4.0 * (frame.spreading ? 1e-6 : 1.0));
    EXPECT_NEAR(echoes.doppler[i + 1], expected.doppler, 2e-15);
    if (room_for_bends) {
      EXPECT_NEAR(echoes.dilation_rate[i + 1], expected.dilation_rate, 1e-12 * std::abs(expected.dilation_rate));
    }
  }
}

TEST(WriteEchoes, AreTheScalarFormulasForAnyNumberOfPoints) {
  std::mt19937 random(2);
  at_every_simd_level([&] {
    for (const bool cosine : {false, true})
      for (const bool spreading : {true, false})
        for (std::size_t count = 1; count <= 20; ++count)
          for (ViewFrame& frame : frames_of_all_kinds(random)) {
            frame.spreading = spreading;
            const PointArrays points = random_points(random, count, cosine);
            expect_scalar_formulas(points, frame, true);
            if (!frame.bends) expect_scalar_formulas(points, frame, false);
          }
  });
}

TEST(WriteEchoes, OfPointsThatShowTheirBacksAreZero) {
  at_every_simd_level([] {
    ViewFrame frame;
    frame.origin_m = {0.0, 1000.0, 0.0};
    frame.light_speed_mps = c;
    frame.amplitude_scale = 1.0;
    PointArrays points;
    points.law = PointArrays::Law::cosine;
    for (int i = 0; i < 9; ++i) {  // normals turn from facing the radar, -y, to its opposite
      const core::Vec3 n = core::direction(core::pi + core::pi * i / 8.0, 0.0);
      points.x_m.push_back(0.0), points.y_m.push_back(0.0), points.z_m.push_back(0.0);
      points.root_rcs_m.push_back(2.0);
      points.normal_x.push_back(n.x), points.normal_y.push_back(n.y), points.normal_z.push_back(n.z);
    }
    const EchoBatch echoes = written(points, frame).echoes;
    for (int i = 0; i < 9; ++i) {
      const double cosine = std::cos(core::pi * i / 8.0);
      const auto k = static_cast<std::size_t>(i);
      if (i > 4)
        EXPECT_EQ(echoes.amplitude_sqrt_w[k], 0.0) << i;
      else if (i < 4)
        EXPECT_NEAR(echoes.amplitude_sqrt_w[k], 2e-6 * std::sqrt(cosine), 1e-18) << i;
      else
        EXPECT_NEAR(echoes.amplitude_sqrt_w[k], 0.0, 2e-6 * 3e-8) << i;  // the root of a rounding
    }
  });
}

// The same gain from the offset's angles: azimuth atan2(x, y), elevation asin(z) in the antenna's frame.
void expect_beam(const AntennaView& beam, const double (&beamwidth)[4], const ViewFrame& frame,
                 const PointArrays& points) {
  const EchoBatch plain = written(points, frame).echoes;
  const EchoBatch seen = written(points, frame, beam).echoes;
  std::size_t lit = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const core::Vec3 look =
        frame.origin_m + frame.world_from_platform * core::Vec3{points.x_m[i], points.y_m[i], points.z_m[i]};
    const core::Vec3 a = frame.antenna_from_world * look;
    const double azimuth = std::atan2(a.x, a.y), elevation = std::asin(a.z / core::norm(a));
    double gain = std::abs(azimuth) < 0.5 * core::pi ? 1.0 : 0.0;
    for (const int cut : {0, 1, 2, 3})
      if (beamwidth[cut] > 0.0) gain *= sinx(cut % 2 == 0 ? azimuth : elevation, beamwidth[cut]);
    lit += gain != 0.0 ? 1 : 0;
    EXPECT_NEAR(seen.amplitude_sqrt_w[i], plain.amplitude_sqrt_w[i] * gain, 1e-12 * plain.amplitude_sqrt_w[i]);
  }
  EXPECT_GT(lit, points.size() / 4);
  EXPECT_LT(lit, points.size());
}

TEST(WriteEchoes, WithABeamAreMultipliedBySinXOverXOfEveryCut) {
  std::mt19937 random(4);
  const double widths[][4] = {
      {0.3, 0.2, 0.3, 0.2}, {0.3, 0.2, 0.5, 0.9}, {0.0, 0.0, 0.4, 0.3}, {0.1, 0.2, 0.0, 0.0}, {0.3, 0.2, 0.3, 0.7}};
  at_every_simd_level([&] {
    for (const auto& beamwidth : widths) {
      ViewFrame frame = random_frame(random);
      frame.origin_m = {30.0, 20.0, 5.0};  // points all around
      frame.antenna_from_world = yaw(0.2) * pitch(0.1);
      AntennaView beam;
      for (const std::size_t cut : {0U, 1U, 2U, 3U})
        beam.cut[cut] = beamwidth[cut] > 0.0 ? 0.88 / (2.0 * beamwidth[cut]) : 0.0;
      expect_beam(beam, beamwidth, frame, random_points(random, 203, false));
    }
  });
}

// Vectors whose points are all in the main lobe, some, and none.
TEST(WriteEchoes, WithABeamAreTheSameWhateverTheirNeighboursAre) {
  std::mt19937 random(5);
  at_every_simd_level([&] {
    ViewFrame frame = random_frame(random);
    frame.world_from_platform_rate = {{core::Vec3{}, core::Vec3{}, core::Vec3{}}};
    frame.origin_m = {0.0, 2500.0, 0.0};
    frame.antenna_from_world = yaw(0.0);
    AntennaView beam;
    beam.cut = {20.0, 10.0, 20.0, 10.0};
    PointArrays points = random_points(random, 96, false);
    for (std::size_t i = 0; i < 32; ++i) {
      points.x_m[i] *= 0.1, points.y_m[i] *= 0.1, points.z_m[i] *= 0.1;
      if (i >= 16) points.x_m[i + 16] += 1000.0;
    }
    const EchoBatch all = written(points, frame, beam).echoes;
    for (std::size_t i = 0; i < points.size(); ++i) {
      PointArrays one;
      one.x_m = {points.x_m[i]}, one.y_m = {points.y_m[i]}, one.z_m = {points.z_m[i]};
      one.root_rcs_m = {points.root_rcs_m[i]};
      const EchoBatch alone = written(one, frame, beam).echoes;
      EXPECT_EQ(alone.amplitude_sqrt_w[0], all.amplitude_sqrt_w[i]) << i;
      EXPECT_EQ(alone.delay_s[0], all.delay_s[i]) << i;
      const core::Vec3 look =
          frame.origin_m + frame.world_from_platform * core::Vec3{one.x_m[0], one.y_m[0], one.z_m[0]};
      const double azimuth = std::atan2(look.x, look.y), elevation = std::asin(look.z / core::norm(look));
      const double gain = std::pow(sinx(azimuth, 0.022) * sinx(elevation, 0.044), 2.0);
      const double plain = written(one, frame).echoes.amplitude_sqrt_w[0];
      EXPECT_NEAR(all.amplitude_sqrt_w[i], plain * gain, 1e-13 * plain) << i;
    }
  });
}

TEST(WriteEchoes, OnTheAxisOfABeamHaveGainOneAndRightAboveItNone) {
  at_every_simd_level([] {
    ViewFrame frame;
    frame.light_speed_mps = c;
    frame.amplitude_scale = 1.0;
    AntennaView beam;
    for (double& cut : beam.cut) cut = 4.4;
    PointArrays points;
    points.x_m = {0.0, 0.0, 0.0};
    points.y_m = {100.0, 0.0, -100.0};
    points.z_m = {0.0, 100.0, 0.0};
    points.root_rcs_m = {1.0, 1.0, 1.0};
    const EchoBatch echoes = written(points, frame, beam).echoes;
    EXPECT_NEAR(echoes.amplitude_sqrt_w[0], 1e-4, 1e-19);
    EXPECT_EQ(echoes.amplitude_sqrt_w[1], 0.0);
    EXPECT_EQ(echoes.amplitude_sqrt_w[2], 0.0);
  });
}

// Its azimuth is 0 by definition: what a classic beam that looks up sees of it depends on that.
TEST(WriteEchoes, RightAboveAreOnTheAxisOfAClassicBeamThatLooksUp) {
  at_every_simd_level([] {
    ViewFrame frame;
    frame.light_speed_mps = c;
    frame.amplitude_scale = 1.0;
    frame.axis_elevation_rad = core::pi / 2;
    AntennaView beam;
    beam.offsets = AntennaView::Offsets::world_angles;
    for (double& cut : beam.cut) cut = 4.4;
    PointArrays points;
    points.x_m = points.y_m = {0.0};
    points.z_m = {100.0};
    points.root_rcs_m = {1.0};
    EXPECT_NEAR(written(points, frame, beam).echoes.amplitude_sqrt_w[0], 1e-4, 1e-18);
  });
}

// Each of them alone, where points at rest could take the shorter way.
TEST(WriteEchoes, DeviateInOneColumnAlone) {
  const auto echo = [](const PointJitter& jitter) {
    ViewFrame frame;
    frame.origin_m = {300.0, 400.0, 500.0};
    frame.light_speed_mps = c;
    frame.amplitude_scale = 1.0;
    frame.pulse = 3;
    PointArrays points;
    points.x_m = points.y_m = points.z_m = points.root_rcs_m = std::vector<double>(16, 2.0);
    points.jitter = jitter;
    EchoBatch echoes = batch_of(16, false);
    EXPECT_TRUE(write_echoes(points, {0, 16}, frame, {}, {}, echoes, 0));
    return std::pair(echoes.delay_s[5], echoes.amplitude_sqrt_w[5]);
  };
  at_every_simd_level([&] {
    const std::vector<double> ones(16, 1.0);
    const std::vector<std::uint64_t> keys(16, 77);
    PointJitter level, height, size;
    level.x_stddev_m = level.y_stddev_m = height.z_stddev_m = ones;
    level.position_key = height.position_key = keys;
    size.rcs_m2 = std::vector<double>(16, 4.0);
    size.rcs_stddev_m2 = ones;
    size.rcs_key = keys;
    const auto plain = echo({});
    EXPECT_NE(echo(level).first, plain.first);
    EXPECT_NE(echo(height).first, plain.first);
    EXPECT_EQ(echo(size).first, plain.first);
    EXPECT_NE(echo(size).second, plain.second);
  });
}

// A beam along +x with no elevation: its axis has y = 6e-17, which must not light up what stands at a right angle.
TEST(WriteEchoes, AtARightAngleToABeamOrBeyondAreNothingHoweverTheAxisIsRounded) {
  at_every_simd_level([] {
    for (const auto offsets : {AntennaView::Offsets::antenna_frame, AntennaView::Offsets::world_angles}) {
      ViewFrame frame;
      frame.light_speed_mps = c;
      frame.amplitude_scale = 1.0;
      frame.antenna_from_world = {
          {core::Vec3{std::cos(core::pi / 2), -1, 0}, core::Vec3{1, std::cos(core::pi / 2), 0}, core::Vec3{0, 0, 1}}};
      frame.axis_azimuth_rad = core::pi / 2;
      AntennaView beam;
      beam.offsets = offsets;
      for (double& cut : beam.cut) cut = 4.4;
      PointArrays points;
      points.x_m = {100.0, 0.0, 0.0, -100.0, 0.0, 0.0, 100.0};
      points.y_m = {0.0, 100.0, -100.0, 0.0, 0.0, 0.0, 1.0};
      points.z_m = {0.0, 0.0, 0.0, 0.0, 100.0, -100.0, 0.0};
      points.root_rcs_m = std::vector<double>(7, 1.0);
      const EchoBatch echoes = written(points, frame, beam).echoes;
      EXPECT_NEAR(echoes.amplitude_sqrt_w[0], 1e-4, 1e-18);
      for (std::size_t i = 1; i < 6; ++i) EXPECT_EQ(echoes.amplitude_sqrt_w[i], 0.0) << i;
      EXPECT_GT(echoes.amplitude_sqrt_w[6], 1e-6);
    }
  });
}

TEST(WriteEchoes, OfAPointAtTheRadarAreInfiniteAndDoubtful) {
  at_every_simd_level([] {
    ViewFrame frame;
    frame.origin_m = {1.0, 2.0, 3.0};
    frame.light_speed_mps = c;
    frame.amplitude_scale = 1.0;
    PointArrays points;
    points.x_m = {-1.0, 5.0};
    points.y_m = {-2.0, 5.0};
    points.z_m = {-3.0, 5.0};
    points.root_rcs_m = {1.0, 1.0};
    const Written at = written(points, frame);
    EXPECT_FALSE(at.possible);
    EXPECT_EQ(at.echoes.amplitude_sqrt_w[0], std::numeric_limits<double>::infinity());
    EXPECT_GT(at.echoes.delay_s[1], 0.0);
    EXPECT_TRUE(std::isfinite(at.echoes.amplitude_sqrt_w[1]));
  });
}

TEST(WriteEchoes, TellWhetherAnyOfThemMayBeImpossible) {
  const auto possible = [](std::size_t culprit, const core::Vec3& at, double root_rcs, const core::Vec3& velocity) {
    ViewFrame frame;
    frame.light_speed_mps = c;
    frame.amplitude_scale = 1.0;
    frame.velocity_mps = velocity;
    frame.moves = true;
    PointArrays points;
    points.x_m = points.y_m = points.z_m = points.root_rcs_m = std::vector<double>(11, 10.0);
    points.x_m[culprit] = at.x;
    points.y_m[culprit] = at.y;
    points.z_m[culprit] = at.z;
    points.root_rcs_m[culprit] = root_rcs;
    return written(points, frame).possible;
  };
  at_every_simd_level([&] {
    for (std::size_t i = 0; i < 11; ++i) {
      EXPECT_TRUE(possible(i, {1e-3, 0, 0}, 1.0, {}));
      EXPECT_FALSE(possible(i, {1e-7, 0, 0}, 1.0, {}));
      EXPECT_FALSE(possible(i, {10, 0, 0}, 1e33, {}));
      EXPECT_FALSE(possible(i, {10, 0, 0}, std::numeric_limits<double>::quiet_NaN(), {}));
      EXPECT_FALSE(possible(i, {10, 0, 0}, 1.0, {1.001 * c, 0, 0}));
      EXPECT_FALSE(possible(i, {10, 0, 0}, 1.0, {-1.001 * c, 0, 0}));
    }
    EXPECT_TRUE(possible(0, {10, 0, 0}, 1.0, {0.9 * c, 0, 0}));
  });
}

TEST(WriteEchoes, MayBeImpossibleForARadarNearTheSpeedOfLight) {
  std::mt19937 random(4);
  const PointArrays points = random_points(random, 11, false);
  at_every_simd_level([&] {
    for (ViewFrame frame : frames_of_all_kinds(random)) {
      if (frame.light_time == LightTime::thesis) continue;  // it knows no speed of the radar alone
      for (const double speed : {0.9 * c, 1.001 * c}) {
        frame.radar_mps = frame.radar_slope_mps = {0, speed, 0};
        EXPECT_EQ(written(points, frame).possible, speed < c);
      }
    }
  });
}

}  // namespace sight_test
}  // namespace sarsim::radar

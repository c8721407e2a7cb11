#include "signal/sar/back_projection_kernel.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <vector>

#include "signal/sar/echo_records.hpp"
#include "signal/sar/projection_point.hpp"
#include "signal/sar/sar_test_support.hpp"

namespace sarsim::signal {
namespace back_projection_kernel_test {

constexpr double carrier_hz = 5.3e9;
constexpr double wavelength_m = core::exact_light_speed_mps / carrier_hz;

// Records that change slowly, so that only phases matter: one broad echo with a slope, all pulses the same.
struct Setting {
  SarEchoes echoes;
  std::unique_ptr<EchoRecords> records;
  ProjectionConstants constants;
  std::vector<ProjectionPulse> pulses;
};

Setting setting_at(double distance_m) {
  Setting s;
  s.echoes = test::thesis_echoes(7, 100.0);
  s.echoes.waveform.pulse_width_s = 1e-4;
  s.echoes.samples = 200;
  s.echoes.first_delay_s = 2.0 * distance_m / core::exact_light_speed_mps - 100.0 / 60e6;
  const core::Vec3 antenna{-0.6 * distance_m, -0.7 * distance_m, std::sqrt(0.15) * distance_m};
  s.echoes.track = test::straight_flight(antenna, {150.0, -90.0, 5.0}, 100.0, 7);
  for (std::size_t p = 0; p < 7; ++p)
    for (std::size_t n = 0; n < 200; ++n) {
      const double x = (static_cast<double>(n) - 100.0) / 60.0;
      s.echoes.volts.emplace_back(static_cast<float>(std::exp(-x * x)),
                                  static_cast<float>(0.3 * std::exp(-2.0 * x * x)));
    }
  s.records = std::make_unique<EchoRecords>(s.echoes, WindowFunction{}, 7);
  s.records->fill(0, 7, {});
  s.constants = {carrier_hz, core::exact_light_speed_mps, s.echoes.first_delay_s, 8.0 * 60e6, 1e-4 / 50e6,
                 true,       s.records->count()};
  for (std::size_t p = 0; p < 7; ++p)
    s.pulses.push_back({s.echoes.track[p].position_m, s.echoes.track[p].velocity_mps, s.records->at(p)});
  return s;
}

ProjectionTile tile_with(double spacing_m) {
  ProjectionTile tile;
  tile.corner_m = {-32.0 * spacing_m, -16.0 * spacing_m, 0.0};
  tile.column_step_m = {0.8 * spacing_m, 0.6 * spacing_m, 0.0};
  tile.row_step_m = {-0.6 * spacing_m, 0.8 * spacing_m, 0.0};
  return tile;
}

// Each point and each pulse in double precision.
void project_by_definition(std::span<const ProjectionPulse> pulses, const ProjectionConstants& constants,
                           const ProjectionAperture& aperture, ProjectionTile& tile) {
  for (const ProjectionPulse& pulse : pulses)
    for (std::size_t row = 0; row < tile.used_rows; ++row)
      for (std::size_t column = 0; column < tile.used_columns; ++column) {
        const std::size_t at = row * ProjectionTile::columns + column;
        project_point(pulse, constants, aperture, tile.point_m(row, column), tile.re[at], tile.im[at], tile.weight[at]);
      }
}

double largest_difference(const ProjectionTile& a, const ProjectionTile& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.re.size(); ++i)
    largest = std::max(largest, std::hypot(static_cast<double>(a.re[i]) - static_cast<double>(b.re[i]),
                                           static_cast<double>(a.im[i]) - static_cast<double>(b.im[i])));
  return largest;
}

// The same records point by point in double precision.
TEST(Project, OfEveryStretchIsThatOfSinglePointsOnEveryInstructionSet) {
  for (const double distance_m : {60.0, 150.0, 400.0, 1000.0, 10e3, 1e6}) {
    const Setting s = setting_at(distance_m);
    for (const double spacing_m : {0.03, 0.25, 1.0}) {
      const Stretch longest = stretch_for(0.97 * distance_m - 36.0 * spacing_m, spacing_m, wavelength_m);
      ProjectionTile expected = tile_with(spacing_m);
      project_by_definition(s.pulses, s.constants, {}, expected);
      for (const Stretch stretch : {Stretch::of_16, Stretch::of_32, Stretch::of_64}) {
        if (stretch > longest) continue;
        test::on_every_instruction_set([&](std::int64_t target) {
          ProjectionTile got = tile_with(spacing_m);
          project(s.pulses, s.constants, {}, stretch, got);
          // 1e-5 cycles of the series, 3e-6 of the floats, at 7 pulses of height 1; records are 1e-3 steep.
          EXPECT_LT(largest_difference(got, expected), 7.0 * 1.5e-4)
              << distance_m << " " << spacing_m << " " << static_cast<int>(stretch) << " " << target;
        });
      }
    }
  }
}

// Level ground below a line that climbs by 6 degrees, at even slant ranges: rows and columns bend, and each row bends
// its columns otherwise.
std::vector<StretchSurface> climbing_surface(double distance_m, std::size_t stretch) {
  std::vector<StretchSurface> surface(ProjectionTile::columns / stretch);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    auto& t = surface[i].terms;
    const double x = 0.25 / distance_m;
    t[0][0] = {-8.0 + 0.2 * static_cast<double>(stretch * i), -4.0 + 0.1 * static_cast<double>(i), 0.0};
    t[0][1] = {0.2, 0.15, 0.01};
    t[0][2] = {-0.4 * x * 0.25, 0.3 * x * 0.25, -0.2 * x * 0.25};
    t[0][3] = {0.4 * x * x * 0.25, 0.0, 0.1 * x * x * 0.25};
    t[1][0] = {-0.15, 0.2, 0.026};
    t[1][1] = {1.1 * x, -0.7 * x, 0.3 * x};
    t[1][2] = {0.9 * x * x, 0.0, -0.4 * x * x};
    t[2][0] = {0.3 * x * 0.25, -0.2 * x * 0.25, 0.1 * x * 0.25};
    t[2][1] = {0.0, 0.8 * x * x, 0.2 * x * x};
    t[3][0] = {0.2 * x * x * 0.25, 0.1 * x * x * 0.25, 0.0};
  }
  return surface;
}

TEST(Project, OfACurvedSurfaceIsThatOfSinglePointsOnEveryInstructionSet) {
  for (const double distance_m : {400.0, 3000.0}) {
    const Setting s = setting_at(distance_m);
    for (const Stretch stretch : {Stretch::of_16, Stretch::of_32, Stretch::of_64}) {
      if (stretch > stretch_for(0.9 * distance_m, 0.3, wavelength_m)) continue;
      const auto surface = climbing_surface(distance_m, static_cast<std::size_t>(stretch));
      ProjectionTile expected;
      expected.surface = surface;
      project_by_definition(s.pulses, s.constants, {}, expected);
      test::on_every_instruction_set([&](std::int64_t target) {
        ProjectionTile got;
        got.surface = surface;
        project(s.pulses, s.constants, {}, stretch, got);
        EXPECT_LT(largest_difference(got, expected), 7.0 * 1.5e-4)
            << distance_m << " " << static_cast<int>(stretch) << " " << target;
      });
    }
  }
}

// Points anywhere, of which none follows from its neighbours, with and without weights.
TEST(Project, PointByPointIsTheDefinitionOnEveryInstructionSet) {
  const Setting s = setting_at(400.0);
  std::vector<core::Vec3> points_m;
  for (std::size_t i = 0; i < ProjectionTile::rows * ProjectionTile::columns; ++i) {
    const auto x = static_cast<double>(i);
    points_m.push_back({30.0 * std::sin(1.3 * x), 25.0 * std::sin(2.1 * x), 9.0 * std::sin(0.7 * x)});
  }
  ProjectionAperture beam;
  beam.kind = ProjectionAperture::Kind::angle;
  const core::Vec3& v = s.pulses[3].velocity_mps;
  const core::Vec3 sight = -s.pulses[3].position_m;
  beam.squint_rad = std::asin(core::dot(sight, v) / (core::norm(sight) * core::norm(v)));
  beam.extent = 0.05;
  beam.uniform = false;
  for (std::size_t i = 0; i <= ProjectionAperture::pieces + 1; ++i)
    beam.weights.push_back(0.4F + 0.001F * static_cast<float>(i));
  for (const ProjectionAperture& aperture : {ProjectionAperture{}, beam}) {
    ProjectionTile expected;
    expected.points_m = points_m;
    project_by_definition(s.pulses, s.constants, aperture, expected);
    test::on_every_instruction_set([&](std::int64_t target) {
      ProjectionTile got;
      got.points_m = points_m;
      project(s.pulses, s.constants, aperture, Stretch::by_point, got);
      EXPECT_LT(largest_difference(got, expected), 7.0 * 1e-5) << target;
      for (std::size_t i = 0; i < got.weight.size(); ++i) ASSERT_NEAR(got.weight[i], expected.weight[i], 1e-5) << i;
    });
  }
}

// Echoes that alternate from sample to sample: points of a vector that share records and points that load their own, in
// lines along the line of sight and across it, inside the recorded delays and across their ends.
TEST(Project, FindsRecordsInEveryDirectionAndAtBothEnds) {
  Setting s = setting_at(3000.0);
  for (std::size_t i = 0; i < s.echoes.volts.size(); ++i)
    s.echoes.volts[i] = {i % 2 == 0 ? 0.2F : -0.1F, i % 3 == 0 ? 0.3F : 0.0F};
  s.records->fill(0, 7, {});
  const core::Vec3 sight = (1.0 / core::norm(s.pulses[3].position_m)) * s.pulses[3].position_m;
  for (const double off_m : {-240.0, 0.0, 230.0})
    for (const double slant : {0.0, 0.02, 0.2, 1.0}) {
      const auto tile_at = [&] {
        ProjectionTile tile;
        const core::Vec3 across = core::cross(sight, {0.0, 0.0, 1.0});
        tile.column_step_m = 0.25 * (slant * sight + std::sqrt(1.0 - slant * slant) * across);
        tile.row_step_m = 0.6 * sight;
        tile.corner_m = off_m * sight - 32.0 * tile.column_step_m - 16.0 * tile.row_step_m;
        return tile;
      };
      ProjectionTile expected = tile_at();
      project_by_definition(s.pulses, s.constants, {}, expected);
      test::on_every_instruction_set([&](std::int64_t target) {
        ProjectionTile got = tile_at();
        project(s.pulses, s.constants, {}, Stretch::of_64, got);
        std::size_t far = 0;
        for (std::size_t i = 0; i < got.re.size(); ++i)
          if (std::abs(got.re[i] - expected.re[i]) > 2e-3F || std::abs(got.im[i] - expected.im[i]) > 2e-3F) ++far;
        // A point within a thousandth of a record of the ends may fall to either side.
        EXPECT_LE(far, 4u) << off_m << " " << slant << " " << target;
      });
    }
}

TEST(Project, WeighsByTheTableAsSinglePointsDoOnEveryInstructionSet) {
  const Setting s = setting_at(10e3);
  for (const auto kind : {ProjectionAperture::Kind::angle, ProjectionAperture::Kind::time}) {
    ProjectionAperture aperture;
    aperture.kind = kind;
    const core::Vec3& v = s.pulses[3].velocity_mps;
    const core::Vec3 sight = -s.pulses[3].position_m;
    aperture.squint_rad = std::asin(core::dot(sight, v) / (core::norm(sight) * core::norm(v)));
    // The points see the aperture from end to end, and beyond.
    aperture.extent = kind == ProjectionAperture::Kind::angle ? 0.006 : 0.3;
    aperture.uniform = false;
    for (std::size_t i = 0; i <= ProjectionAperture::pieces + 1; ++i)
      aperture.weights.push_back(i % 2 == 0 ? 0.5F : 1.5F);
    ProjectionTile expected = tile_with(1.0);
    project_by_definition(s.pulses, s.constants, aperture, expected);
    test::on_every_instruction_set([&](std::int64_t target) {
      ProjectionTile got = tile_with(1.0);
      project(s.pulses, s.constants, aperture, Stretch::of_64, got);
      std::size_t far = 0, reached = 0;
      for (std::size_t i = 0; i < got.weight.size(); ++i) {
        // The zigzag rises by 1 in 1/512 of the aperture: places are to be right to a hundredth of that. A point at the
        // edge of the aperture may fall to either side.
        if (std::abs(got.weight[i] - expected.weight[i]) > 0.02F) ++far;
        if (expected.weight[i] > 0.0F) ++reached;
      }
      EXPECT_LE(far, 4u) << target;
      EXPECT_GT(reached, 500u);
      EXPECT_LT(reached, got.weight.size());
    });
  }
}

TEST(Project, ComputesNoMoreThanIsUsed) {
  const Setting s = setting_at(10e3);
  ProjectionTile all = tile_with(1.0), part = tile_with(1.0);
  project(s.pulses, s.constants, {}, Stretch::of_32, all);
  part.used_rows = 5;
  part.used_columns = 35;
  project(s.pulses, s.constants, {}, Stretch::of_32, part);
  for (std::size_t row = 0; row < 32; ++row)
    for (std::size_t column = 0; column < 35; ++column) {
      const std::size_t i = row * ProjectionTile::columns + column;
      ASSERT_EQ(part.re[i], row < 5 ? all.re[i] : 0.0F);
    }
}

TEST(StretchFor, IsTheLongestWhoseNeglectedTermIsSmall) {
  const auto neglected_cycles = [](double nearest_m, double step_m, double half) {
    return 2.0 / wavelength_m * std::pow(half * step_m, 4.0) / (8.0 * std::pow(nearest_m, 3.0));
  };
  int seen[4] = {0, 0, 0, 0};
  for (double nearest_m = 1.0; nearest_m < 1e5; nearest_m *= 1.07)
    for (const double step_m : {0.02, 0.3, 1.5}) {
      const auto length = static_cast<std::size_t>(stretch_for(nearest_m, step_m, wavelength_m));
      if (length > 0) {
        EXPECT_LT(neglected_cycles(nearest_m, step_m, 0.5 * static_cast<double>(length)), 1e-5);
        EXPECT_LE(0.5 * static_cast<double>(length) * step_m, 0.1 * nearest_m);
      }
      if (length < 64) {
        const double longer = length == 0 ? 8.0 : static_cast<double>(length);
        EXPECT_TRUE(neglected_cycles(nearest_m, step_m, longer) >= 1e-5 || longer * step_m > 0.1 * nearest_m);
      }
      ++seen[length == 0 ? 0 : length == 16 ? 1 : length == 32 ? 2 : 3];
    }
  for (const int times : seen) EXPECT_GT(times, 0);
  EXPECT_EQ(stretch_for(-5.0, 1.0, wavelength_m), Stretch::by_point);
}

}  // namespace back_projection_kernel_test
}  // namespace sarsim::signal

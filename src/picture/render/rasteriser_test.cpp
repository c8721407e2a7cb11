#include "picture/render/rasteriser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "picture/render/cut_triangle.hpp"
#include "picture/scene/camera.hpp"
#include "support/processor_time.hpp"

namespace sarsim::picture {
namespace {

constexpr raster::Rgb red{200, 0, 0};
constexpr raster::Rgb green{0, 200, 0};

// Looks straight down, north up, one pixel a metre; the focus is in the middle.
Viewpoint from_above(double width, double height) {
  Viewpoint view;
  view.width_px = width;
  view.height_px = height;
  return view;
}

std::shared_ptr<Mesh> mesh_of(std::vector<core::Vec3> points, std::vector<std::array<std::uint32_t, 3>> triangles,
                              raster::Rgb colour, std::uint8_t opacity = 255) {
  return std::make_shared<Mesh>(Mesh{std::move(points), std::move(triangles), {colour}, opacity, {}});
}

// A square about the middle at a height.
std::shared_ptr<Mesh> square(double half_m, double z_m, raster::Rgb colour, std::uint8_t opacity = 255) {
  return mesh_of({{-half_m, -half_m, z_m}, {half_m, -half_m, z_m}, {half_m, half_m, z_m}, {-half_m, half_m, z_m}},
                 {{0, 1, 2}, {0, 2, 3}}, colour, opacity);
}

Rendering rendered(const MeshList& meshes, const Viewpoint& view, const RenderControl& control = {}) {
  Rasteriser rasteriser;
  Rendering out;
  rasteriser.render(meshes, view, control, out);
  return out;
}

// The colour at a pixel of the picture, of which a part was rendered.
std::uint32_t pixel(const Rendering& r, int x, int y) {
  if (x < r.left || y < r.top || x >= r.left + r.width || y >= r.top + r.height) return 0;
  return r.argb[static_cast<std::size_t>(y - r.top) * static_cast<std::size_t>(r.width) +
                static_cast<std::size_t>(x - r.left)];
}

std::shared_ptr<Mesh> random_triangles(unsigned seed, std::uint32_t count, double reach_m) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-reach_m, reach_m);
  auto mesh = std::make_shared<Mesh>();
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) mesh->points_world_m.push_back({place(random), place(random), place(random)});
    mesh->triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    mesh->colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8U), 77});
  }
  return mesh;
}

Viewpoint aslant(double width, double height, bool perspective) {
  Camera camera = Camera::start(width, height);
  camera.pixels_per_m = 1.0;
  camera.perspective = perspective;
  return camera.viewpoint();
}

// --- Points ---------------------------------------------------------------------------------------------------------

TEST(ProjectPoints, SeesThemWhereTheCameraDoes) {
  for (const bool perspective : {false, true}) {
    Camera camera = Camera::start(640.0, 480.0);
    camera.perspective = perspective;
    camera.pixels_per_m = 0.7;
    camera.focus_world_m = {30.0, -20.0, 5.0};
    const auto mesh = random_triangles(1, 11, 200.0);
    std::vector<Corner> corners(mesh->points_world_m.size());
    project_points(camera.viewpoint(), mesh->points_world_m, corners);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto seen = camera.project(mesh->points_world_m[i]);
      ASSERT_TRUE(seen);
      EXPECT_NEAR(static_cast<double>(corners[i].x), seen->x, 1e-4);
      EXPECT_NEAR(static_cast<double>(corners[i].y), seen->y, 1e-4);
      EXPECT_NEAR(static_cast<double>(corners[i].nearness), -seen->depth_m * camera.scale_at(seen->depth_m), 1e-3);
    }
  }
}

TEST(ProjectPoints, MarksThoseBehindTheViewer) {
  Camera camera = Camera::start(640.0, 480.0);
  camera.perspective = true;
  camera.pixels_per_m = 1.0;
  const core::Vec3 towards = camera.picture_from_world().row[2];
  const std::vector<core::Vec3> points{0.9 * camera.viewer_distance_m() * towards,
                                       1.1 * camera.viewer_distance_m() * towards};
  std::vector<Corner> corners(2);
  project_points(camera.viewpoint(), points, corners);
  EXPECT_FALSE(std::isnan(corners[0].x));
  EXPECT_TRUE(std::isnan(corners[1].x));
}

// --- Triangles ------------------------------------------------------------------------------------------------------

TEST(Rasteriser, CoversEachPixelOfAFanOnce) {
  // Triangles about a point, whose rim is outside of the picture.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0.0, 6.283185307179586);
  std::set<double> angles{0.0, 1.5707963267948966, 3.141592653589793, 4.71238898038469};
  while (angles.size() < 60) angles.insert(angle(random));
  Mesh fan;
  fan.points_world_m.push_back({3.25, -1.5, 0.0});
  for (const double a : angles) fan.points_world_m.push_back({200.0 * std::cos(a), 200.0 * std::sin(a), 0.0});
  const auto rim = static_cast<std::uint32_t>(angles.size());
  for (std::uint32_t i = 0; i < rim; ++i) fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % rim});
  const Viewpoint view = from_above(90, 70);
  std::vector<int> covered(90U * 70U, 0);
  for (const auto& triangle : fan.triangles) {
    const Rendering one = rendered({mesh_of(fan.points_world_m, {triangle}, red)}, view);
    for (std::size_t i = 0; i < covered.size(); ++i)
      covered[i] += pixel(one, static_cast<int>(i % 90), static_cast<int>(i / 90)) != 0 ? 1 : 0;
  }
  EXPECT_EQ(std::ranges::count(covered, 1), 90 * 70);
}

// What a ray through a pixel's middle meets first, by brute force; nothing where it passes an edge too closely to say.
struct Met {
  double nearness = -HUGE_VAL;
  std::size_t triangle = 0;
  bool any = false;
  bool sure = true;
};
Met met_at(const Mesh& mesh, const std::vector<std::array<double, 3>>& seen, double x, double y) {
  Met met;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& a = seen[mesh.triangles[t][0]];
    const auto& b = seen[mesh.triangles[t][1]];
    const auto& c = seen[mesh.triangles[t][2]];
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    const double u = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;
    const double v = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
    const double least = std::min({u, v, 1.0 - u - v});
    const double nearness = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]);
    if (std::abs(least) < 1e-3 && nearness > met.nearness - 0.1) met.sure = false;
    if (least < 0.0) continue;
    if (std::abs(nearness - met.nearness) < 0.05) met.sure = false;
    if (nearness > met.nearness) met = {nearness, t, true, met.sure};
  }
  return met;
}

TEST(Rasteriser, SeesWhatRaysMeetFirst) {
  for (const bool perspective : {false, true}) {
    Camera camera = Camera::start(160.0, 120.0);
    camera.perspective = perspective;
    camera.pixels_per_m = 1.0;
    const auto mesh = random_triangles(7, 40, 60.0);
    std::vector<std::array<double, 3>> seen;
    for (const core::Vec3& point : mesh->points_world_m) {
      const auto at = camera.project(point);
      ASSERT_TRUE(at);
      seen.push_back({at->x, at->y, -at->depth_m * camera.scale_at(at->depth_m)});
    }
    const Rendering picture = rendered({mesh}, camera.viewpoint());
    int sure = 0;
    int covered = 0;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) {
        const Met met = met_at(*mesh, seen, x + 0.5, y + 0.5);
        if (!met.sure) continue;
        ++sure;
        const std::uint32_t argb = pixel(picture, x, y);
        ASSERT_EQ(argb != 0, met.any) << x << " " << y;
        if (!met.any) continue;
        ++covered;
        EXPECT_EQ((argb >> 16U) & 255U, met.triangle) << x << " " << y;
      }
    EXPECT_GT(sure, 15000);
    EXPECT_GT(covered, 5000);
  }
}

TEST(Rasteriser, ShowsTheNearerOfTwoAndTheOneThatCameFirstOfEqualOnes) {
  const Viewpoint view = from_above(8, 8);
  for (const MeshList& meshes :
       {MeshList{square(3, 0, red), square(3, 1, green)}, {square(3, 1, green), square(3, 0, red)}})
    EXPECT_EQ(pixel(rendered(meshes, view), 4, 4), 0xFF00C800U);
  EXPECT_EQ(pixel(rendered({square(3, 0, red), square(3, 0, green)}, view), 4, 4), 0xFFC80000U);
  const Rendering one = rendered({square(3, 0, red)}, view);
  EXPECT_EQ(pixel(one, 0, 0), 0U);
  EXPECT_EQ(pixel(one, 1, 1), 0xFFC80000U);
  EXPECT_EQ(pixel(one, 6, 6), 0xFFC80000U);
  EXPECT_EQ(pixel(one, 7, 7), 0U);
}

TEST(Rasteriser, LaysAVeilOnceOverWhatIsNotInFrontOfIt) {
  const Viewpoint view = from_above(8, 8);
  auto veil = square(3, 10, green, 51);
  veil->triangles.push_back({0, 1, 3});  // lies upon the others
  const Rendering above = rendered({square(2, 0, red), veil}, view);
  EXPECT_EQ(pixel(above, 4, 4), 0xFFA02800U);  // four fifths of one, one fifth of the other
  EXPECT_EQ(pixel(above, 1, 1), 0x33002800U);
  const Rendering below = rendered({square(2, 20, red), veil}, view);
  EXPECT_EQ(pixel(below, 4, 4), 0xFFC80000U);
  // A veil on a surface lies over it.
  EXPECT_EQ(pixel(rendered({square(2, 10, red), veil}, view), 4, 4), 0xFFA02800U);
}

// A veil costs what it covers: beams of a hundred radars are drawn for each picture of a film.
TEST(Rasteriser, LaysManySmallVeilsQuickly) {
  MeshList veils;
  for (int i = 0; i < 2000; ++i) {
    auto veil = square(3, 0, green, 51);
    for (core::Vec3& point : veil->points_world_m)
      point = point +
              core::Vec3{static_cast<double>(i % 50) * 20.0 - 500.0, static_cast<double>(i / 50) * 10.0 - 200.0, 0.0};
    veils.push_back(veil);
  }
  const sarsim::test::ProcessorTime time;
  const Rendering picture = rendered(veils, from_above(1200, 800), {1, 2});
  EXPECT_LT(time.seconds(), 2.0);
  EXPECT_EQ(std::ranges::count(picture.argb, 0x33002800U), 2000 * 36);
}

TEST(Rasteriser, SeesAPlaneUpToItsHorizon) {
  // The eye is 1000 m high and looks 10 degrees down; the plane goes on for 10 000 km and behind the viewer.
  Camera camera = Camera::start(400.0, 400.0);
  camera.perspective = true;
  camera.azimuth_rad = 0.0;
  camera.elevation_rad = 10.0 * 3.141592653589793 / 180.0;
  camera.pixels_per_m = 800.0 / (1000.0 / std::sin(camera.elevation_rad));
  const Rendering plane = rendered({square(1e7, 0, red)}, camera.viewpoint());
  const double horizon_px = 200.0 - 800.0 * std::tan(camera.elevation_rad);
  for (int y = 0; y < 400; ++y) {
    if (std::abs(y + 0.5 - horizon_px) < 1.5) continue;
    for (const int x : {0, 137, 399}) EXPECT_EQ(pixel(plane, x, y) != 0, y > horizon_px) << x << " " << y;
  }
}

TEST(Rasteriser, DrawsWhatReachesFarBeyondThePicture) {
  // One triangle of 1000 km at 1 mm a pixel: its edge runs through the middle of the picture, 3 in 4 upwards.
  Viewpoint view = from_above(300, 200);
  view.pixels_per_m = 1000.0;
  const double far = 1e6;
  const Rendering picture = rendered(
      {mesh_of({{-far, -0.75 * far, 0}, {far, 0.75 * far, 0}, {0.6 * far, -0.8 * far, 0}}, {{0, 1, 2}}, red)}, view);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      const double below = 0.75 * (x + 0.5 - 150.0) - (100.0 - (y + 0.5));
      if (std::abs(below) < 0.05) continue;
      ASSERT_EQ(pixel(picture, x, y) != 0, below > 0.0) << x << " " << y;
    }
}

TEST(Rasteriser, LeavesOutWhatCannotBeDrawn) {
  const Viewpoint view = from_above(8, 8);
  const double nan = std::nan("");
  const auto beyond = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}, red);
  auto colourless = square(3, 0, red);
  colourless->colours.clear();
  const auto nowhere = mesh_of({{nan, 0, 0}, {3, 3, 0}, {-3, 3, 0}, {HUGE_VAL, 0, 0}}, {{0, 1, 2}, {1, 2, 3}}, red);
  const auto line = mesh_of({{-3, 0, 0}, {0, 0, 0}, {3, 0, 0}}, {{0, 1, 2}}, red);
  for (const auto& mesh : {beyond, colourless, nowhere, line, mesh_of({}, {}, red)}) {
    const Rendering picture = rendered({mesh, square(1, 0, green)}, view);
    EXPECT_EQ(std::ranges::count(picture.argb, 0xFF00C800U), 4);
    EXPECT_EQ(std::ranges::count_if(picture.argb, [](std::uint32_t argb) { return argb != 0; }), 4);
  }
}

TEST(Rasteriser, SmoothsEdgesByFourSamples) {
  Viewpoint view = from_above(4, 4);
  view.focus_world_m = {-0.5, 0.0, 0.0};  // edges run through the middle of pixels
  const Rendering picture = rendered({square(1, 0, red)}, view, {1, 2});
  EXPECT_EQ(pixel(picture, 1, 1), 0x80640000U);
  EXPECT_EQ(pixel(picture, 2, 1), 0xFFC80000U);
  EXPECT_EQ(pixel(picture, 3, 1), 0x80640000U);
  EXPECT_EQ(pixel(picture, 0, 1), 0U);
}

TEST(Rasteriser, TakesOneSampleAPixelWhereFourWouldNeedTooMuchMemory) {
  Viewpoint view = from_above(3000, 2000);
  view.focus_world_m = {-0.5, 0.0, 0.0};
  const auto wide = square(1450.0, 0, red);
  const Rendering large = rendered({wide}, view, {2, 2});
  const Rendering plain = rendered({wide}, view, {1, 1});
  EXPECT_EQ(large.argb, plain.argb);
  view.width_px = view.height_px = 1000;
  EXPECT_NE(rendered({square(100, 0, red)}, view, {2, 2}).argb, rendered({square(100, 0, red)}, view, {1, 1}).argb);
}

TEST(Rasteriser, SaysWhichMeshIsSeenAndWhatIsBehindIt) {
  const Viewpoint view = from_above(8, 8);
  const Rendering picture = rendered({square(3, 0, red), square(1, 10, green)}, view);
  EXPECT_EQ(triangle_at(picture, 1.5, 1.5)->mesh, 0U);
  EXPECT_EQ(triangle_at(picture, 4.5, 4.5)->mesh, 1U);
  EXPECT_EQ(triangle_at(picture, 3.5, 1.5)->triangle, 1U);  // above the diagonal
  EXPECT_EQ(triangle_at(picture, 6.5, 3.5)->triangle, 0U);
  EXPECT_FALSE(triangle_at(picture, 0.5, 0.5));
  EXPECT_FALSE(triangle_at(picture, -1.0, 3.0));
  EXPECT_TRUE(is_hidden(picture, view, 4.5, 4.5, 0.0));
  EXPECT_FALSE(is_hidden(picture, view, 4.5, 4.5, 9.0));
  EXPECT_FALSE(is_hidden(picture, view, 1.5, 1.5, 0.0));
  EXPECT_FALSE(is_hidden(picture, view, 0.5, 0.5, -100.0));
  EXPECT_FALSE(is_hidden(picture, view, 9.0, 0.5, -100.0));
}

TEST(Rasteriser, RendersThePartWhereSomethingIs) {
  Viewpoint view = from_above(400, 300);
  view.focus_world_m = {50.0, 30.0, 0.0};
  const Rendering picture = rendered({square(3, 0, red)}, view);
  EXPECT_EQ(picture.left, 147);
  EXPECT_EQ(picture.top, 177);
  EXPECT_LE(picture.width, 7);
  EXPECT_LE(picture.height, 7);
  EXPECT_EQ(pixel(picture, 147, 177), 0xFFC80000U);
  EXPECT_EQ(pixel(picture, 152, 182), 0xFFC80000U);
  EXPECT_TRUE(triangle_at(picture, 150.0, 180.0));
  view.focus_world_m = {5000.0, 30.0, 0.0};
  EXPECT_TRUE(rendered({square(3, 0, red)}, view).empty());
  EXPECT_TRUE(rendered({}, view).empty());
}

TEST(Rasteriser, UsesItsRoomAgainForAnotherPicture) {
  Rasteriser rasteriser;
  Rendering out;
  rasteriser.render({random_triangles(5, 100, 300.0)}, aslant(300, 200, true), {2, 2}, out);
  rasteriser.render({square(3, 0, red)}, from_above(8, 8), {}, out);
  EXPECT_EQ(out.argb, rendered({square(3, 0, red)}, from_above(8, 8)).argb);
}

}  // namespace
}  // namespace sarsim::picture

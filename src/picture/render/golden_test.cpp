// Pictures that are kept beside this test: the same for any number of threads and on any instruction set.
// SARSIM_WRITE_GOLDEN=1 writes them anew; look at them before they are committed.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "picture/render/rasteriser.hpp"
#include "picture/render/shapes.hpp"
#include "simulate/resolve/simd_level.hpp"
#include "support/folders.hpp"

namespace sarsim::picture {
namespace {

// Of sums, products, quotients and roots alone, which every machine rounds alike.
Mesh hills() {
  constexpr std::size_t side = 150;
  std::vector<float> heights;
  for (std::size_t i = 0; i < side * side; ++i) {
    const float x = static_cast<float>(i % side) / 50.0F - 1.5F;
    const float y = static_cast<float>(i / side) / 50.0F - 1.5F;
    heights.push_back(30.0F / (1.0F + 4.0F * (x * x + y * y)) +
                      12.0F * (x * x * x - 2.0F * x * y) / (1.0F + x * x + y * y));
  }
  return height_field_mesh({{-75.0, -75.0, 0.0}, 1.0, 1.0, side, heights}, {150, 190, 120});
}

Mesh lake() {
  return {
      {{-75, -75, -2}, {75, -75, -2}, {75, 75, -2}, {-75, 75, -2}}, {{0, 1, 2}, {0, 2, 3}}, {{40, 90, 160}}, 120, {}};
}

MeshList scenery() {
  const core::Mat3 north_east{{core::Vec3{0.6, -0.8, 0.0}, {0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}}};
  MeshList meshes;
  meshes.push_back(std::make_shared<const Mesh>(hills()));
  meshes.push_back(
      std::make_shared<const Mesh>(symbol_mesh(Symbol::aircraft, {0, -30, 45}, north_east, 40.0, {210, 60, 50})));
  meshes.push_back(
      std::make_shared<const Mesh>(symbol_mesh(Symbol::satellite, {-30, 20, 60}, north_east, 30.0, {220, 200, 60})));
  meshes.push_back(
      std::make_shared<const Mesh>(symbol_mesh(Symbol::vehicle, {-40, -45, 12}, north_east, 25.0, {80, 80, 200})));
  meshes.push_back(std::make_shared<const Mesh>(lake()));
  return meshes;
}

// From the south-west, 37 degrees above the ground.
Viewpoint view(double inverse_viewer_m) {
  constexpr double h = 0.70710678118654752;
  Viewpoint view;
  view.picture_from_world = {{core::Vec3{h, -h, 0.0}, {0.6 * h, 0.6 * h, 0.8}, {-0.8 * h, -0.8 * h, 0.6}}};
  view.focus_world_m = {0.0, 0.0, 10.0};
  view.pixels_per_m = 0.7;
  view.inverse_viewer_m = inverse_viewer_m;
  view.width_px = 144.0;
  view.height_px = 96.0;
  return view;
}

struct Golden {
  const char* name;
  double inverse_viewer_m;
  int samples;
};
constexpr Golden goldens[] = {{"parallel", 0.0, 1}, {"perspective", 1.0 / 160.0, 1}, {"smooth", 1.0 / 160.0, 2}};

// A portable pixmap of colours on white.
std::string pixmap(const Rendering& part, const Viewpoint& view) {
  const auto width = static_cast<std::size_t>(view.width_px);
  const auto height = static_cast<std::size_t>(view.height_px);
  std::string colours(3 * width * height, '\xFF');
  for (std::size_t i = 0; i < part.argb.size(); ++i) {
    const std::size_t x = static_cast<std::size_t>(part.left) + i % static_cast<std::size_t>(part.width);
    const std::size_t y = static_cast<std::size_t>(part.top) + i / static_cast<std::size_t>(part.width);
    for (unsigned c = 0; c < 3; ++c) {
      const unsigned value = ((part.argb[i] >> (16U - 8U * c)) & 255U) + 255U - (part.argb[i] >> 24U);
      colours[3 * (y * width + x) + c] = static_cast<char>(static_cast<unsigned char>(value));
    }
  }
  return "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + colours;
}

std::string kept(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class GoldenPictures : public testing::TestWithParam<Golden> {};

TEST_P(GoldenPictures, AreTheSameForAnyThreadsAndInstructions) {
  const Golden& golden = GetParam();
  const std::filesystem::path path =
      test::source_folder() / "src/picture/render/golden" / (std::string(golden.name) + ".ppm");
  const MeshList meshes = scenery();
  Rasteriser rasteriser;
  Rendering out;
  const auto picture = [&](unsigned threads) {
    rasteriser.render(meshes, view(golden.inverse_viewer_m), {threads, golden.samples}, out);
    return pixmap(out, view(golden.inverse_viewer_m));
  };
  if (std::getenv("SARSIM_WRITE_GOLDEN") != nullptr) std::ofstream(path, std::ios::binary) << picture(1);
  const std::string expected = kept(path);
  ASSERT_FALSE(expected.empty()) << path;
  for (const std::string& level : simulate::simd_levels()) {
    const simulate::SimdLevelScope scope(level);
    for (const unsigned threads : {1U, 2U, 7U}) EXPECT_TRUE(picture(threads) == expected) << level << " " << threads;
  }
}

INSTANTIATE_TEST_SUITE_P(All, GoldenPictures, testing::ValuesIn(goldens),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

// Nearness and meshes, which are not seen, as well.
TEST(Rasteriser, HasTheSameNearnessForAnyThreadsAndInstructions) {
  const MeshList meshes = scenery();
  Rasteriser rasteriser;
  Rendering first;
  rasteriser.render(meshes, view(1.0 / 160.0), {1, 1}, first);
  for (const std::string& level : simulate::simd_levels()) {
    const simulate::SimdLevelScope scope(level);
    Rendering other;
    rasteriser.render(meshes, view(1.0 / 160.0), {7, 1}, other);
    EXPECT_EQ(other.nearness, first.nearness) << level;
    EXPECT_EQ(other.triangle, first.triangle) << level;
  }
  std::vector<int> pixels(meshes.size());
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 144; ++x)
      if (const auto seen = triangle_at(first, x, y)) pixels[seen->mesh] += 1;
  for (std::size_t mesh = 0; mesh < 4; ++mesh) EXPECT_GT(pixels[mesh], 10) << mesh;
  EXPECT_EQ(pixels[4], 0) << "a veil is not picked";
}

}  // namespace
}  // namespace sarsim::picture

// How long the rasteriser takes for a picture of hills: median and worst of 30, wall clock, each from another side.
//
//     raster_picture [TRIANGLES [THREADS [WIDTH HEIGHT]]]
//
// Prints one line: triangles, threads, pixels, milliseconds of the median and of the worst, and instruction set.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "picture/render/rasteriser.hpp"
#include "picture/render/shapes.hpp"
#include "picture/scene/camera.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace {

using namespace sarsim::picture;

MeshList hills(std::size_t triangles) {
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(0.5 * static_cast<double>(triangles)))) + 1;
  std::vector<float> heights;
  heights.reserve(side * side);
  for (std::size_t i = 0; i < side * side; ++i) {
    const double x = static_cast<double>(i % side) / static_cast<double>(side);
    const double y = static_cast<double>(i / side) / static_cast<double>(side);
    heights.push_back(
        static_cast<float>(60.0 * std::sin(23.0 * x) * std::cos(17.0 * y) + 9.0 * std::sin(141.0 * x * y)));
  }
  const double step = 1000.0 / static_cast<double>(side - 1);
  const HeightField field{{-500.0, -500.0, 0.0}, step, step, side, heights};
  return {std::make_shared<const Mesh>(height_field_mesh(field, {190, 180, 150}))};
}

}  // namespace

int main(int count, char** words) {
  const auto number = [&](int i, double otherwise) { return count > i ? std::stod(words[i]) : otherwise; };
  const auto triangles = static_cast<std::size_t>(number(1, 1e6));
  const auto threads = static_cast<unsigned>(number(2, 2));
  Camera camera = Camera::start(number(3, 1280.0), number(4, 800.0));
  camera.pixels_per_m = 0.9 * camera.width_px / 1400.0;
  const MeshList meshes = hills(triangles);
  Rasteriser rasteriser;
  Rendering out;
  std::vector<double> times_ms;
  for (int i = 0; i < 31; ++i) {
    camera.azimuth_rad = 0.2 * i;
    const auto begin = std::chrono::steady_clock::now();
    rasteriser.render(meshes, camera.viewpoint(), {threads, 1}, out);
    times_ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  times_ms.erase(times_ms.begin());  // the first takes its memory
  std::ranges::sort(times_ms);
  std::printf("%zu triangles, %u threads, %d x %d: median %.1f ms, worst %.1f ms (%s)\n",
              meshes.front()->triangles.size(), threads, static_cast<int>(camera.width_px),
              static_cast<int>(camera.height_px), times_ms[times_ms.size() / 2], times_ms.back(),
              sarsim::simulate::simd_level().c_str());
  return 0;
}

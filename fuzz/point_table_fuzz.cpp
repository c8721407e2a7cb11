// Tables of points: NPY, HDF5 and text, told by their content.

#include "raster_probe.hpp"
#include "scene/model/cloud_points.hpp"
#include "scene/model/limits.hpp"
#include "workflow/input/cloud_input.hpp"

namespace {

std::shared_ptr<const sarsim::scene::CloudPoints> points_of(const std::string& path, unsigned threads) {
  sarsim::scene::Scene scene;
  scene.clouds.emplace_back().file = path;
  const sarsim::core::Problems problems = sarsim::workflow::read_clouds(scene, {}, {threads});
  if (static_cast<bool>(scene.clouds[0].points) == sarsim::core::has_errors(problems))
    throw std::logic_error("points without errors or errors without points are promised");
  return scene.clouds[0].points;
}

void expect_sound(const sarsim::scene::CloudPoints& points) {
  const sarsim::radar::PointArrays& arrays = points.arrays;
  if (arrays.size() == 0) throw std::logic_error("a table without points was taken");
  for (const auto* column : {&arrays.x_m, &arrays.y_m, &arrays.z_m, &arrays.root_rcs_m}) {
    if (column->size() != arrays.size()) throw std::logic_error("columns of different lengths");
    if (!std::ranges::all_of(*column, sarsim::scene::computable)) throw std::logic_error("a value that is none");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const sarsim::raster::MemoryFile memory(data, size);
  const auto one = points_of(memory.path(), 1);
  const auto two = points_of(memory.path(), 2);
  if ((one != nullptr) != (two != nullptr)) throw std::logic_error("the number of threads decides");
  if (!one) return 0;
  expect_sound(*one);
  if (one->sum != two->sum || one->arrays.size() != two->arrays.size())
    throw std::logic_error("the number of threads changes the points");
  return 0;
}

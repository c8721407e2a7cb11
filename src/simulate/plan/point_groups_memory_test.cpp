// Geometry in SIMD allocates nothing from the second pulse on. This file counts the allocations of its whole program.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "simulate/plan/point_groups.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

// NOLINTBEGIN(cppcoreguidelines-no-malloc): nothing else is left to an operator new

namespace {

std::atomic<std::size_t> allocations = 0;

void* allocate(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
  if (void* const memory = std::aligned_alloc(step, (size / step + 1) * step)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

// NOLINTEND(cppcoreguidelines-no-malloc)

namespace sarsim::simulate {
namespace {

TEST(FastEchoes, AllocateNothingFromTheSecondPulseOn) {
  scene::Scene scene = one_target_scene();
  scene.targets[0].traits.edit().reflectivity = scene::Target::Reflectivity::directional;
  scene.targets[0].traits.edit().position_stddev_m = {1, 2, 3};
  scene.targets[0].traits.edit().rcs_stddev_m2 = 0.1;
  scene.targets[0].traits.edit().azimuth_stddev = core::Angle::from_deg(3);
  scene.targets[0].traits.edit().gain = scene::Target::Gain::user;
  scene.targets[0].traits.edit().gain_db.part[0] = lines({{0.0, 0.0}, {180.0, -20.0}});
  scene.targets.resize(1003, scene.targets[0]);
  scene.surfaces.push_back({});
  scene::Antenna& antenna = scene.radars[0].transmit_antenna;
  antenna.pattern = scene::Antenna::Pattern::user;
  antenna.gain_db.part = {lines({{0.0, 0.0}, {180.0, -20.0}}), lines({{0.0, 0.0}, {180.0, -20.0}})};
  const ResolvedScene resolved = resolve(scene);
  const Link radar = resolve_radar(scene, resolved, 0);
  const PointGroups groups = group_points(resolved, radar);
  PulseGeometry geometry(resolved, radar);
  radar::EchoBatch echoes;
  const std::size_t before = allocations;
  fast_echoes(groups, geometry, echoes);
  EXPECT_GT(allocations, before);
  const std::size_t first_pulse = allocations;
  for (std::int64_t pulse = 1; pulse < 20; ++pulse) {
    geometry.set_pulse(pulse);
    fast_echoes(groups, geometry, echoes);
  }
  EXPECT_EQ(allocations, first_pulse);
}

}  // namespace
}  // namespace sarsim::simulate

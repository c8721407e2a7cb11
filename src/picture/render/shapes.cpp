#include "picture/render/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sarsim::picture {

namespace {

constexpr double sky_part = 0.45;  // of the light that a plane gets whichever way it faces

core::Vec3 unit(const core::Vec3& v) {
  const double length = core::norm(v);
  return length > 0.0 ? (1.0 / length) * v : core::Vec3{};
}

using Triangle = std::array<std::uint32_t, 3>;

// The normal of a triangle, to the side from which its corners turn counter-clockwise.
core::Vec3 normal_of(const Mesh& mesh, const Triangle& triangle) {
  const core::Vec3& a = mesh.points_world_m[triangle[0]];
  return unit(core::cross(mesh.points_world_m[triangle[1]] - a, mesh.points_world_m[triangle[2]] - a));
}

// Solids of one metre from nose to tail: x to the nose, y to the left, z up. Corners turn counter-clockwise from
// outside.
struct Solid {
  std::vector<core::Vec3> points;
  std::vector<Triangle> triangles;

  // A point on both sides of the middle, the left one first.
  void add_pair(double x, double y, double z) {
    points.push_back({x, y, z});
    points.push_back({x, -y, z});
  }
  // A plate of four corners that is seen from both sides, and lit as from above.
  void add_plate(const std::array<core::Vec3, 4>& corners) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), corners.begin(), corners.end());
    const bool turned = core::cross(corners[1] - corners[0], corners[2] - corners[0]).z < 0.0;
    const std::uint32_t second = first + (turned ? 3 : 1);
    const std::uint32_t fourth = first + (turned ? 1 : 3);
    triangles.push_back({first, second, first + 2});
    triangles.push_back({first, first + 2, fourth});
  }
  void add_box(const core::Vec3& low, const core::Vec3& high) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (int i = 0; i < 8; ++i)
      points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    for (const auto& [a, b, c, d] : std::initializer_list<std::array<std::uint32_t, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      triangles.push_back({first + a, first + b, first + c});
      triangles.push_back({first + a, first + c, first + d});
    }
  }
};

// A body with wings swept back, tail planes and a fin.
Solid aircraft() {
  Solid solid;
  solid.points = {{0.5, 0.0, 0.0},   {-0.5, 0.0, 0.02}, {0.2, 0.05, 0.0},
                  {0.2, -0.05, 0.0}, {0.1, 0.0, 0.06},  {0.1, 0.0, -0.05}};
  solid.triangles = {{0, 2, 4}, {0, 4, 3}, {0, 3, 5}, {0, 5, 2}, {1, 4, 2}, {1, 3, 4}, {1, 5, 3}, {1, 2, 5}};
  for (const double side : {1.0, -1.0}) {
    solid.add_plate(
        {{{0.18, side * 0.03, 0.0}, {-0.14, side * 0.48, 0.02}, {-0.22, side * 0.48, 0.02}, {-0.1, side * 0.03, 0.0}}});
    solid.add_plate({{{-0.36, side * 0.01, 0.02},
                      {-0.47, side * 0.18, 0.03},
                      {-0.52, side * 0.18, 0.03},
                      {-0.5, side * 0.01, 0.02}}});
  }
  solid.add_plate({{{-0.34, 0.0, 0.02}, {-0.47, 0.0, 0.19}, {-0.53, 0.0, 0.19}, {-0.5, 0.0, 0.02}}});
  return solid;
}

// A box with two panels across its way.
Solid satellite() {
  Solid solid;
  solid.add_box({-0.18, -0.11, -0.11}, {0.18, 0.11, 0.11});
  for (const double side : {1.0, -1.0}) {
    solid.add_box({-0.01, side > 0.0 ? 0.11 : -0.17, -0.01}, {0.01, side > 0.0 ? 0.17 : -0.11, 0.01});
    solid.add_plate(
        {{{-0.12, side * 0.17, 0.0}, {0.12, side * 0.17, 0.0}, {0.12, side * 0.5, 0.0}, {-0.12, side * 0.5, 0.0}}});
  }
  return solid;
}

// A hull with a pointed bow and a house on it: a ship, or a car.
Solid vehicle() {
  Solid solid;
  solid.add_pair(0.25, 0.16, 0.12);
  solid.add_pair(-0.5, 0.16, 0.12);
  solid.add_pair(0.2, 0.11, 0.0);
  solid.add_pair(-0.45, 0.11, 0.0);
  solid.points.push_back({0.5, 0.0, 0.13});
  solid.points.push_back({0.4, 0.0, 0.0});
  solid.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 8}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {2, 6, 7},
                     {2, 7, 3}, {0, 8, 9}, {0, 9, 4}, {1, 5, 9}, {1, 9, 8}, {4, 9, 5}, {4, 5, 7}, {4, 7, 6}};
  solid.add_box({-0.35, -0.09, 0.12}, {-0.05, 0.09, 0.26});
  return solid;
}

Solid solid_of(Symbol symbol) {
  switch (symbol) {
    case Symbol::aircraft: return aircraft();
    case Symbol::satellite: return satellite();
    case Symbol::vehicle: break;
  }
  return vehicle();
}

}  // namespace

core::Vec3 hill_light() { return unit({-1.0, 1.0, std::sqrt(2.0)}); }

raster::Rgb shaded(raster::Rgb colour, const core::Vec3& normal_world, const core::Vec3& towards_light_world) {
  const double light = sky_part + (1.0 - sky_part) * std::max(0.0, core::dot(normal_world, towards_light_world));
  const auto part = [&](std::uint8_t value) { return static_cast<std::uint8_t>(std::lround(light * value)); };
  return {part(colour.red), part(colour.green), part(colour.blue)};
}

raster::Rgb shaded(raster::Rgb colour, const core::Vec3& normal_world) {
  return shaded(colour, normal_world, hill_light());
}

Mesh height_field_mesh(const HeightField& field, raster::Rgb colour) {
  const std::size_t columns = field.columns;
  const std::size_t rows = columns > 0 ? field.heights_m.size() / columns : 0;
  if (columns < 2 || rows < 2 || rows * columns != field.heights_m.size())
    throw std::invalid_argument("a height field has at least two rows of at least two heights, all of one length");
  Mesh mesh;
  mesh.points_world_m.reserve(rows * columns);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const core::Vec3 place{static_cast<double>(column) * field.step_x_m, static_cast<double>(row) * field.step_y_m,
                             static_cast<double>(field.heights_m[row * columns + column])};
      mesh.points_world_m.push_back(field.origin_world_m + place);
    }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const Triangle triangle{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                            static_cast<std::uint32_t>(c)};
    const auto known = [&](std::uint32_t i) { return std::isfinite(mesh.points_world_m[i].z); };
    if (!std::ranges::all_of(triangle, known)) return;
    const core::Vec3 normal = normal_of(mesh, triangle);
    mesh.triangles.push_back(triangle);
    mesh.colours.push_back(shaded(colour, normal.z < 0.0 ? -normal : normal));
  };
  mesh.triangles.reserve(2 * (rows - 1) * (columns - 1));
  mesh.colours.reserve(mesh.triangles.capacity());
  for (std::size_t row = 0; row + 1 < rows; ++row)
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const std::size_t at = row * columns + column;
      add(at, at + 1, at + columns + 1);
      add(at, at + columns + 1, at + columns);
    }
  return mesh;
}

Mesh symbol_mesh(Symbol symbol, const core::Vec3& at_world_m, const core::Mat3& world_from_symbol, double length_m,
                 raster::Rgb colour) {
  const Solid solid = solid_of(symbol);
  Mesh mesh;
  for (const core::Vec3& point : solid.points)
    mesh.points_world_m.push_back(at_world_m + length_m * (world_from_symbol * point));
  mesh.triangles = solid.triangles;
  for (const Triangle& triangle : mesh.triangles) mesh.colours.push_back(shaded(colour, normal_of(mesh, triangle)));
  return mesh;
}

}  // namespace sarsim::picture

#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/maths/vector.hpp"
#include "picture/render/viewpoint.hpp"

namespace sarsim::picture {

/// A point of a mesh as it is seen: pixels to the right and down from the picture's upper left corner, and nearness
/// (see Viewpoint). One that is behind the viewer has an x that is not a number.
struct Corner {
  float x = 0.0F;
  float y = 0.0F;
  float nearness = 0.0F;
  float unused = 0.0F;  ///< Four floats are stored, and loaded, at once.
};

/// Where points are seen.
/// @param corners  as many as points
void project_points(const Viewpoint& view, std::span<const core::Vec3> points_world_m, std::span<Corner> corners);

/// What is nearest at the pixels of a part of the picture: the nearness in the upper half, in an order of whole
/// numbers, and in the lower half the number of the triangle, where the lower number counts as nearer. The nearest is
/// therefore the same in whichever order triangles are drawn.
struct KeyRows {
  std::span<std::int64_t> keys;  ///< `width` for each row.
  int first_column = 0;
  int width = 0;
  int first_row = 0;
  int rows = 0;
};

/// The key of a pixel on which nothing was drawn: farther than everything.
inline constexpr std::int64_t empty_key = INT64_MIN;

/// The number of the triangle that a key holds.
[[nodiscard]] constexpr std::uint32_t triangle_of(std::int64_t key) { return ~static_cast<std::uint32_t>(key); }
/// The nearness that a key holds.
[[nodiscard]] inline float nearness_of(std::int64_t key) {
  const auto ordered = static_cast<std::int32_t>(key >> 32);
  return std::bit_cast<float>(ordered ^ ((ordered >> 31) & 0x7FFFFFFF));
}

/// The first pixel whose middle is not before a place. (std::ceil is a call where there is no instruction for it.)
[[nodiscard]] constexpr int first_pixel(float place_px) {
  const float from_middle = place_px - 0.5F;
  const int whole = static_cast<int>(from_middle);
  return whole + (static_cast<float>(whole) < from_middle ? 1 : 0);
}

/// Draws a triangle with a number: at each pixel whose middle it covers the key that is nearer stays. Pixels whose
/// middle lies on an edge belong to the triangle on its right, or below; where triangles share an edge each pixel
/// belongs to one of them. Corners are finite and at most `guard_px` outside the picture.
void fill_triangle(const KeyRows& rows, const std::array<Corner, 3>& corners, std::uint32_t number);

/// The same for many, which are numbered from `first_number`. Those that reach behind the viewer, or farther than
/// `guard_px` from the picture, are not drawn: their places in `triangles` are put into `odd`.
/// @param corners  of the mesh, to which `triangles` refer
void fill_triangles(const KeyRows& rows, std::span<const Corner> corners,
                    std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t first_number,
                    std::vector<std::uint32_t>& odd);

/// The nearer of two keys at each pixel, into the first.
void keep_nearer(std::span<std::int64_t> keys, std::span<const std::int64_t> others);

/// Triangles that reach farther from the picture are cut before they are drawn, since floats are too coarse for them.
inline constexpr float guard_px = 16384.0F;

}  // namespace sarsim::picture

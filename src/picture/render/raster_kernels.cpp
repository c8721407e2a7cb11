#include "picture/render/raster_kernels.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "core/report/expect.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "picture/render/raster_kernels.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sarsim::picture::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// No sum of products is fused: every instruction set makes the same picture.

using DoubleTag = hn::CappedTag<double, 8>;
using DoubleVec = hn::Vec<DoubleTag>;
using FloatTag = hn::Rebind<float, DoubleTag>;

HWY_INLINE DoubleVec dot(const core::Vec3& row, DoubleVec x, DoubleVec y, DoubleVec z) {
  const DoubleTag d;
  const DoubleVec xy = hn::Add(hn::Mul(hn::Set(d, row.x), x), hn::Mul(hn::Set(d, row.y), y));
  return hn::Add(xy, hn::Mul(hn::Set(d, row.z), z));
}

// As many points as a vector has lanes.
HWY_INLINE void project_lanes(const Viewpoint& view, const double* points, float* corners) {
  const DoubleTag d;
  const FloatTag df;
  DoubleVec x;
  DoubleVec y;
  DoubleVec z;
  hn::LoadInterleaved3(d, points, x, y, z);
  x = hn::Sub(x, hn::Set(d, view.focus_world_m.x));
  y = hn::Sub(y, hn::Set(d, view.focus_world_m.y));
  z = hn::Sub(z, hn::Set(d, view.focus_world_m.z));
  const auto& axes = view.picture_from_world.row;
  const DoubleVec right = dot(axes[0], x, y, z);
  const DoubleVec up = dot(axes[1], x, y, z);
  const DoubleVec towards = dot(axes[2], x, y, z);
  const DoubleVec part = hn::Sub(hn::Set(d, 1.0), hn::Mul(towards, hn::Set(d, view.inverse_viewer_m)));
  const DoubleVec scale = hn::Div(hn::Set(d, view.pixels_per_m), part);
  const auto seen = hn::Gt(part, hn::Set(d, nearest_seen_part));
  const DoubleVec at_x = hn::Add(hn::Set(d, 0.5 * view.width_px), hn::Mul(scale, right));
  const DoubleVec at_y = hn::Sub(hn::Set(d, 0.5 * view.height_px), hn::Mul(scale, up));
  const auto nowhere = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
  hn::StoreInterleaved4(hn::DemoteTo(df, hn::IfThenElse(seen, at_x, nowhere)), hn::DemoteTo(df, at_y),
                        hn::DemoteTo(df, hn::Mul(scale, towards)), hn::Zero(df), df, corners);
}

void project_on_target(const Viewpoint& view, const double* points, std::size_t count, float* corners) {
  const std::size_t lanes = hn::Lanes(DoubleTag());
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) project_lanes(view, points + 3 * i, corners + 4 * i);
  if (i == count) return;
  double rest[3 * 8] = {};
  float there[4 * 8];
  std::copy_n(points + 3 * i, 3 * (count - i), rest);
  project_lanes(view, rest, there);
  std::copy_n(there, 4 * (count - i), corners + 4 * i);
}

HWY_INLINE std::int64_t key_of(float nearness, std::uint32_t number) {
  const auto bits = std::bit_cast<std::int32_t>(nearness);
  const std::int32_t ordered = bits ^ ((bits >> 31) & 0x7FFFFFFF);
  return static_cast<std::int64_t>((static_cast<std::uint64_t>(static_cast<std::uint32_t>(ordered)) << 32) |
                                   static_cast<std::uint32_t>(~number));
}

// Nearness on the plane of a triangle: it grows by `per_x` and `per_y` a pixel from its value at the corner `from`,
// and stays between those of the corners, however the plane of a thin triangle is rounded.
struct Plane {
  Corner from;
  float per_x = 0.0F;
  float per_y = 0.0F;
  float least = 0.0F;
  float most = 0.0F;
};

// Keys of pixels first to last - 1 of a row.
HWY_INLINE void fill_span(std::int64_t* row, int first, int last, const Plane& plane, float row_nearness,
                          std::uint32_t number) {
  const hn::CappedTag<std::int64_t, 8> d64;
  const hn::Rebind<std::int32_t, decltype(d64)> d32;
  const hn::Rebind<float, decltype(d64)> df;
  const int lanes = static_cast<int>(hn::Lanes(d64));
  const auto low = hn::Set(d64, static_cast<std::int64_t>(static_cast<std::uint32_t>(~number)));
  int x = first;
  for (; x + lanes <= last; x += lanes) {
    const auto middle = hn::Add(hn::ConvertTo(df, hn::Iota(d32, x)), hn::Set(df, 0.5F));
    const auto along = hn::Mul(hn::Sub(middle, hn::Set(df, plane.from.x)), hn::Set(df, plane.per_x));
    const auto within =
        hn::Min(hn::Max(hn::Add(hn::Set(df, row_nearness), along), hn::Set(df, plane.least)), hn::Set(df, plane.most));
    const auto bits = hn::BitCast(d32, hn::Add(within, hn::Zero(df)));  // There is one 0, not two.
    const auto ordered = hn::Xor(bits, hn::And(hn::ShiftRight<31>(bits), hn::Set(d32, 0x7FFFFFFF)));
    const auto keys = hn::Or(hn::ShiftLeft<32>(hn::PromoteTo(d64, ordered)), low);
    const auto before = hn::LoadU(d64, row + x);
    hn::StoreU(hn::IfThenElse(hn::Gt(keys, before), keys, before), d64, row + x);
  }
  for (; x < last; ++x) {
    const float along = (static_cast<float>(x) + 0.5F - plane.from.x) * plane.per_x;
    const float within = std::min(std::max(row_nearness + along, plane.least), plane.most);
    row[x] = std::max(row[x], key_of(within + 0.0F, number));
  }
}

// Where an edge crosses rows. The upper end comes first, so that triangles that share it cross at the same places.
struct Edge {
  Corner top;
  float slope = 0.0F;

  Edge(const Corner& upper, const Corner& lower)
      : top(upper), slope(lower.y > upper.y ? (lower.x - upper.x) / (lower.y - upper.y) : 0.0F) {}
  [[nodiscard]] float at(float y) const { return top.x + (y - top.y) * slope; }
};

// Without a branch: which comes first is a matter of chance, and a wrong guess takes longer than a small triangle.
HWY_INLINE void order(const Corner*& upper, const Corner*& lower) {
  const Corner* const first = lower->y < upper->y ? lower : upper;
  lower = lower->y < upper->y ? upper : lower;
  upper = first;
}

HWY_INLINE void fill(const KeyRows& rows, const Corner* of_a, const Corner* of_b, const Corner* of_c,
                     std::uint32_t number) {
  order(of_a, of_b);
  order(of_a, of_c);
  order(of_b, of_c);
  const Corner a = *of_a;
  const Corner b = *of_b;
  const Corner c = *of_c;
  const int first_row = std::max(first_pixel(a.y), rows.first_row);
  const int last_row = std::min(first_pixel(c.y), rows.first_row + rows.rows);
  if (first_row >= last_row) return;
  const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0.0F) return;
  const float over = 1.0F / area;
  const Plane plane{a, ((b.nearness - a.nearness) * (c.y - a.y) - (c.nearness - a.nearness) * (b.y - a.y)) * over,
                    ((b.x - a.x) * (c.nearness - a.nearness) - (c.x - a.x) * (b.nearness - a.nearness)) * over,
                    std::min(a.nearness, std::min(b.nearness, c.nearness)),
                    std::max(a.nearness, std::max(b.nearness, c.nearness))};
  const Edge whole(a, c);
  const Edge upper(a, b);
  const Edge lower(b, c);
  const bool turns_right = area > 0.0F;  // the corner in the middle lies right of the long edge
  for (int row = first_row; row < last_row; ++row) {
    const float y = static_cast<float>(row) + 0.5F;
    const float on_long = whole.at(y);
    const float on_short = y < b.y ? upper.at(y) : lower.at(y);
    const int first = std::max(first_pixel(turns_right ? on_long : on_short), rows.first_column);
    const int last = std::min(first_pixel(turns_right ? on_short : on_long), rows.first_column + rows.width);
    if (first >= last) continue;
    std::int64_t* const keys =
        rows.keys.data() + static_cast<std::ptrdiff_t>(row - rows.first_row) * rows.width - rows.first_column;
    fill_span(keys, first, last, plane, a.nearness + (y - a.y) * plane.per_y, number);
  }
}

void fill_one_on_target(const KeyRows& rows, const std::array<Corner, 3>& c, std::uint32_t number) {
  fill(rows, &c[0], &c[1], &c[2], number);
}

void fill_many_on_target(const KeyRows& rows, const Corner* corners,
                         std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t first_number,
                         std::vector<std::uint32_t>& odd) {
  const float right = static_cast<float>(rows.first_column + rows.width) + guard_px;
  const float bottom = static_cast<float>(rows.first_row + rows.rows) + guard_px;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Corner* const a = corners + triangles[i][0];
    const Corner* const b = corners + triangles[i][1];
    const Corner* const c = corners + triangles[i][2];
    const float min_x = std::min(a->x, std::min(b->x, c->x));
    const float max_x = std::max(a->x, std::max(b->x, c->x));
    const float min_y = std::min(a->y, std::min(b->y, c->y));
    const float max_y = std::max(a->y, std::max(b->y, c->y));
    const float sum = a->x + b->x + c->x;  // not a number where one of them is not
    if (!(min_x > -guard_px && max_x < right && min_y > -guard_px && max_y < bottom && sum == sum))
      odd.push_back(i);
    else if (first_pixel(min_x) < first_pixel(max_x))
      fill(rows, a, b, c, first_number + i);
  }
}

void keep_nearer_on_target(std::int64_t* keys, const std::int64_t* others, std::size_t count) {
  const hn::CappedTag<std::int64_t, 8> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto one = hn::LoadU(d, keys + i);
    const auto other = hn::LoadU(d, others + i);
    hn::StoreU(hn::IfThenElse(hn::Gt(other, one), other, one), d, keys + i);
  }
  for (; i < count; ++i) keys[i] = std::max(keys[i], others[i]);
}

}  // namespace sarsim::picture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::picture {

HWY_EXPORT(project_on_target);
HWY_EXPORT(fill_one_on_target);
HWY_EXPORT(fill_many_on_target);
HWY_EXPORT(keep_nearer_on_target);

static_assert(sizeof(core::Vec3) == 3 * sizeof(double));
static_assert(sizeof(Corner) == 4 * sizeof(float));

void project_points(const Viewpoint& view, std::span<const core::Vec3> points_world_m, std::span<Corner> corners) {
  CORE_EXPECT(corners.size() == points_world_m.size());
  if (points_world_m.empty()) return;
  HWY_DYNAMIC_DISPATCH(project_on_target)
  (view, &points_world_m.front().x, points_world_m.size(), &corners.front().x);
}

void fill_triangle(const KeyRows& rows, const std::array<Corner, 3>& corners, std::uint32_t number) {
  HWY_DYNAMIC_DISPATCH(fill_one_on_target)(rows, corners, number);
}

void fill_triangles(const KeyRows& rows, std::span<const Corner> corners,
                    std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t first_number,
                    std::vector<std::uint32_t>& odd) {
  HWY_DYNAMIC_DISPATCH(fill_many_on_target)(rows, corners.data(), triangles, first_number, odd);
}

void keep_nearer(std::span<std::int64_t> keys, std::span<const std::int64_t> others) {
  CORE_EXPECT(keys.size() == others.size());
  HWY_DYNAMIC_DISPATCH(keep_nearer_on_target)(keys.data(), others.data(), keys.size());
}

}  // namespace sarsim::picture

#endif

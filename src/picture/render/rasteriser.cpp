#include "picture/render/rasteriser.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "core/task/parallel.hpp"
#include "picture/render/cut_triangle.hpp"

namespace sarsim::picture {

namespace {

constexpr double max_pixels_a_side = 32767.0;
constexpr double seen_through_px = 2.0;  // a mark so far behind a surface lies on it
constexpr std::size_t points_at_once = 1U << 16U;
constexpr std::size_t chunk_triangles = 16384;
constexpr std::size_t max_threads = 16;
constexpr std::size_t max_samples = std::size_t{1} << 24U;  // with more than one for a pixel: 128 MB a thread
constexpr std::size_t samples_a_thread = 1U << 18U;         // fewer are coloured sooner than a thread starts
constexpr int band_rows = 32;                               // an even number

int whole_pixels(double size_px) { return static_cast<int>(std::clamp(std::round(size_px), 1.0, max_pixels_a_side)); }

// How far behind a surface of a nearness something may be and still lie on it: two pixels of depth at its scale.
float seen_through(const Viewpoint& view, double nearness_px) {
  const double scale_part = 1.0 + nearness_px * view.inverse_viewer_m / view.pixels_per_m;
  return static_cast<float>(seen_through_px * scale_part * scale_part);
}

struct Bounds {
  float left, right, top, bottom;
};

inline Bounds bounds_of(const Corner& a, const Corner& b, const Corner& c) {
  return {std::min(a.x, std::min(b.x, c.x)), std::max(a.x, std::max(b.x, c.x)), std::min(a.y, std::min(b.y, c.y)),
          std::max(a.y, std::max(b.y, c.y))};
}

inline bool behind_viewer(const Corner& corner) { return std::isnan(corner.x); }

std::size_t place_of(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

// Red, green, blue and opacity of samples, added up.
struct Sum {
  unsigned alpha = 0;
  unsigned red = 0;
  unsigned green = 0;
  unsigned blue = 0;

  void add(std::uint32_t argb) {
    alpha += argb >> 24U;
    red += (argb >> 16U) & 255U;
    green += (argb >> 8U) & 255U;
    blue += argb & 255U;
  }
  [[nodiscard]] std::uint32_t mean(unsigned count) const {
    const auto part = [&](unsigned sum) { return (sum + count / 2) / count; };
    return (part(alpha) << 24U) | (part(red) << 16U) | (part(green) << 8U) | part(blue);
  }
};

std::uint32_t opaque(raster::Rgb rgb) {
  return 0xFF000000U | (std::uint32_t{rgb.red} << 16U) | (std::uint32_t{rgb.green} << 8U) | rgb.blue;
}

// A colour laid over another one.
std::uint32_t laid_over(std::uint32_t below, raster::Rgb rgb, unsigned opacity) {
  const auto mix = [&](unsigned shift, unsigned above) {
    const unsigned there = (below >> shift) & 255U;
    return ((above * opacity + there * (255U - opacity) + 127U) / 255U) << shift;
  };
  return mix(24U, 255U) | mix(16U, rgb.red) | mix(8U, rgb.green) | mix(0U, rgb.blue);
}

raster::Rgb colour_of(const Mesh& mesh, std::size_t triangle) {
  return mesh.colours.size() == mesh.triangles.size() ? mesh.colours[triangle] : mesh.colours.front();
}

bool is_finite(const core::Vec3& v) { return std::isfinite(v.x + v.y + v.z); }

// True where nothing of a triangle is in the part that is drawn, as far as it is easily said.
bool out_of_sight(const Corner& a, const Corner& b, const Corner& c, const KeyRows& rows) {
  const int behind = behind_viewer(a) + behind_viewer(b) + behind_viewer(c);
  if (behind != 0) return behind == 3;
  const Bounds bounds = bounds_of(a, b, c);
  return bounds.right < static_cast<float>(rows.first_column) ||
         bounds.left > static_cast<float>(rows.first_column + rows.width) ||
         bounds.bottom < static_cast<float>(rows.first_row) ||
         bounds.top > static_cast<float>(rows.first_row + rows.rows);
}

// What is not seen of a pixel whose nearest key is known.
void keep(std::int64_t key, float samples, std::size_t at, Rendering& out) {
  out.nearness[at] = key == empty_key ? nothing_near : nearness_of(key) / samples;
  out.triangle[at] = key == empty_key ? no_triangle : triangle_of(key);
}

// A mesh that cannot be drawn is left out, rather than read beyond its ends.
bool drawable(const Mesh& mesh) {
  if (mesh.triangles.empty() || mesh.opacity == 0) return false;
  if (mesh.colours.size() != 1 && mesh.colours.size() != mesh.triangles.size()) return false;
  const std::size_t points = mesh.points_world_m.size();
  return std::ranges::all_of(mesh.triangles, [&](const auto& t) { return std::max({t[0], t[1], t[2]}) < points; });
}

}  // namespace

void Rasteriser::place_meshes(const MeshList& meshes) {
  places_.clear();
  chunks_.clear();
  std::size_t corner = 0;
  std::size_t triangle = 0;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const Mesh& mesh = *meshes[m];
    places_.push_back({corner, static_cast<std::uint32_t>(triangle), chunks_.size(), 0, {}});
    if (!drawable(mesh)) continue;
    corner += mesh.points_world_m.size();
    triangle += mesh.triangles.size();
    for (std::size_t first = 0; first < mesh.triangles.size(); first += chunk_triangles)
      chunks_.push_back({m, first, std::min(chunk_triangles, mesh.triangles.size() - first)});
    places_.back().chunks = chunks_.size() - places_.back().first_chunk;
  }
  corners_.resize(corner);
}

void Rasteriser::project(const MeshList& meshes, const Viewpoint& view, unsigned threads) {
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const std::vector<core::Vec3>& points = meshes[m]->points_world_m;
    if (places_[m].chunks == 0) continue;
    const std::span corners(corners_.data() + places_[m].first_corner, points.size());
    core::parallel_ranges(points.size(), points_at_once, {threads, nullptr}, [&](std::size_t begin, std::size_t end) {
      project_points(view, std::span(points).subspan(begin, end - begin), corners.subspan(begin, end - begin));
    });
  }
}

void Rasteriser::draw_chunk(const Mesh& mesh, const Chunk& chunk, const Viewpoint& view, const KeyRows& rows,
                            std::vector<std::uint32_t>& odd) const {
  const MeshPlace& place = places_[chunk.mesh];
  const std::span corners(corners_.data() + place.first_corner, mesh.points_world_m.size());
  const auto number = place.first_triangle + static_cast<std::uint32_t>(chunk.first);
  odd.clear();
  fill_triangles(rows, corners, std::span(mesh.triangles).subspan(chunk.first, chunk.count), number, odd);
  for (const std::uint32_t i : odd) {
    const auto& [a, b, c] = mesh.triangles[chunk.first + i];
    if (out_of_sight(corners[a], corners[b], corners[c], rows)) continue;
    const std::array points{mesh.points_world_m[a], mesh.points_world_m[b], mesh.points_world_m[c]};
    if (!std::ranges::all_of(points, is_finite)) continue;
    for (const std::array<Corner, 3>& part : cut_triangle(view, points)) fill_triangle(rows, part, number + i);
  }
}

// The least part of the picture that holds some corners; the whole of it where one is behind the viewer.
Rasteriser::Part Rasteriser::part_of(std::span<const Corner> corners, int width, int height, int samples) {
  Bounds bounds{HUGE_VALF, -HUGE_VALF, HUGE_VALF, -HUGE_VALF};
  for (const Corner& corner : corners) {
    if (behind_viewer(corner)) return {0, 0, samples * width, samples * height};
    bounds.left = std::min(bounds.left, corner.x);
    bounds.right = std::max(bounds.right, corner.x);
    bounds.top = std::min(bounds.top, corner.y);
    bounds.bottom = std::max(bounds.bottom, corner.y);
  }
  const auto whole = [&](float place, int most) {
    return static_cast<int>(
        std::clamp(std::floor(place / static_cast<float>(samples)), 0.0F, static_cast<float>(most)));
  };
  const int left = whole(bounds.left, width);
  const int top = whole(bounds.top, height);
  const int right = std::min(width, whole(bounds.right, width) + 1);
  const int bottom = std::min(height, whole(bounds.bottom, height) + 1);
  if (!(bounds.left <= bounds.right) || bounds.right < 0.0F || bounds.bottom < 0.0F) return {};
  return {samples * left, samples * top, samples * (right - left), samples * (bottom - top)};
}

Rasteriser::Part Rasteriser::common(const Part& a, const Part& b) {
  const int left = std::max(a.left, b.left);
  const int top = std::max(a.top, b.top);
  return {left, top, std::max(0, std::min(a.left + a.width, b.left + b.width) - left),
          std::max(0, std::min(a.top + a.height, b.top + b.height) - top)};
}

Rasteriser::Part Rasteriser::around(const Part& a, const Part& b) {
  if (a.empty() || b.empty()) return a.empty() ? b : a;
  const int left = std::min(a.left, b.left);
  const int top = std::min(a.top, b.top);
  return {left, top, std::max(a.left + a.width, b.left + b.width) - left,
          std::max(a.top + a.height, b.top + b.height) - top};
}

// Each thread draws into a picture of its own, which needs no locks; as the nearest key wins it does not matter which
// thread drew what.
void Rasteriser::draw_solids(const MeshList& meshes, const Viewpoint& view, unsigned threads) {
  const std::size_t samples = place_of(0, part_.height, part_.width);
  keys_.resize(threads);
  std::atomic<std::size_t> next{0};
  core::parallel_ranges(threads, 1, {threads, nullptr}, [&](std::size_t thread, std::size_t) {
    keys_[thread].assign(samples, empty_key);
    const KeyRows rows{keys_[thread], part_.left, part_.width, part_.top, part_.height};
    std::vector<std::uint32_t> odd;
    for (std::size_t i = next++; i < chunks_.size(); i = next++)
      if (const Mesh& mesh = *meshes[chunks_[i].mesh]; mesh.opacity == 255)
        draw_chunk(mesh, chunks_[i], view, rows, odd);
  });
}

std::size_t Rasteriser::mesh_of(std::int64_t key) const {
  const auto after = std::ranges::upper_bound(places_, triangle_of(key), {}, &MeshPlace::first_triangle);
  return static_cast<std::size_t>(after - places_.begin()) - 1;
}

std::span<const std::int64_t> Rasteriser::solid_keys(const Band& band) const {
  return std::span(keys_.front())
      .subspan(place_of(0, band.first_row, part_.width), place_of(0, band.rows, part_.width));
}

void Rasteriser::colour_solids(const MeshList& meshes, Band& band) const {
  const std::span<const std::int64_t> keys = solid_keys(band);
  band.argb.assign(keys.size(), 0);
  std::int64_t last = empty_key;
  std::uint32_t colour = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::int64_t key = keys[i];
    if (key == empty_key) continue;
    if (last == empty_key || triangle_of(key) != triangle_of(last)) {
      const std::size_t m = mesh_of(key);
      colour = opaque(colour_of(*meshes[m], triangle_of(key) - places_[m].first_triangle));
      last = key;
    }
    band.argb[i] = colour;
  }
}

void Rasteriser::lay_veil(const Mesh& mesh, std::size_t number, const Viewpoint& view, Band& band) const {
  const MeshPlace& place = places_[number];
  const Part here = common(place.part, {part_.left, part_.top + band.first_row, part_.width, band.rows});
  if (here.empty()) return;
  const std::span<const std::int64_t> solid = solid_keys(band);
  band.veil.assign(place_of(0, here.height, here.width), empty_key);
  const KeyRows rows{band.veil, here.left, here.width, here.top, here.height};
  for (const Chunk& chunk : std::span(chunks_).subspan(place.first_chunk, place.chunks))
    draw_chunk(mesh, chunk, view, rows, band.odd);
  for (int y = 0; y < here.height; ++y)
    for (int x = 0; x < here.width; ++x) {
      const std::int64_t key = band.veil[place_of(x, y, here.width)];
      if (key == empty_key) continue;
      const std::size_t at =
          place_of(here.left - part_.left + x, here.top - part_.top - band.first_row + y, part_.width);
      const float nearness = nearness_of(key);
      if (solid[at] != empty_key && nearness < nearness_of(solid[at]) - seen_through(view, nearness)) continue;
      const raster::Rgb colour = colour_of(mesh, triangle_of(key) - place.first_triangle);
      band.argb[at] = laid_over(band.argb[at], colour, mesh.opacity);
    }
}

void Rasteriser::finish_band(const MeshList& meshes, const Viewpoint& view, int samples, Band& band, Rendering& out) {
  const std::size_t first = place_of(0, band.first_row, part_.width);
  const std::size_t count = place_of(0, band.rows, part_.width);
  for (std::size_t thread = 1; thread < keys_.size(); ++thread)
    keep_nearer(std::span(keys_.front()).subspan(first, count), std::span(keys_[thread]).subspan(first, count));
  colour_solids(meshes, band);
  for (std::size_t m = 0; m < meshes.size(); ++m)
    if (meshes[m]->opacity < 255) lay_veil(*meshes[m], m, view, band);
  samples == 1 ? store_samples(band, out) : store(band, samples, out);
}

void Rasteriser::store(const Band& band, int samples, Rendering& out) const {
  const std::span<const std::int64_t> keys = solid_keys(band);
  const auto side = static_cast<unsigned>(samples);
  for (int y = 0; y < band.rows / samples; ++y)
    for (int x = 0; x < out.width; ++x) {
      Sum sum;
      std::int64_t nearest = empty_key;
      for (int sy = y * samples; sy < (y + 1) * samples; ++sy)
        for (int sx = x * samples; sx < (x + 1) * samples; ++sx) {
          const std::size_t at = place_of(sx, sy, part_.width);
          sum.add(band.argb[at]);
          nearest = std::max(nearest, keys[at]);
        }
      const std::size_t to = place_of(x, band.first_row / samples + y, out.width);
      out.argb[to] = sum.mean(side * side);
      keep(nearest, static_cast<float>(samples), to, out);
    }
}

void Rasteriser::store_samples(const Band& band, Rendering& out) const {
  const std::span<const std::int64_t> keys = solid_keys(band);
  const std::size_t first = place_of(0, band.first_row, out.width);
  std::ranges::copy(band.argb, out.argb.begin() + static_cast<std::ptrdiff_t>(first));
  for (std::size_t i = 0; i < keys.size(); ++i) keep(keys[i], 1.0F, first + i, out);
}

// Projects what is to be drawn with so many samples to each side of a pixel; the view that it is drawn with.
Viewpoint Rasteriser::prepare(const MeshList& meshes, const Viewpoint& view, unsigned threads, int samples) {
  Viewpoint finer = view;
  finer.pixels_per_m *= samples;
  finer.width_px *= samples;
  finer.height_px *= samples;
  project(meshes, finer, threads);
  part_ = {};
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (places_[m].chunks == 0) continue;
    const std::span corners(corners_.data() + places_[m].first_corner, meshes[m]->points_world_m.size());
    places_[m].part = part_of(corners, whole_pixels(view.width_px), whole_pixels(view.height_px), samples);
    part_ = around(part_, places_[m].part);
  }
  return finer;
}

void Rasteriser::render(const MeshList& meshes, const Viewpoint& view, const RenderControl& control, Rendering& out) {
  place_meshes(meshes);
  const auto useful = std::clamp<std::size_t>(corners_.size() / chunk_triangles, 1, max_threads);
  unsigned threads = std::clamp(control.threads, 1U, static_cast<unsigned>(useful));
  int samples = std::clamp(control.samples, 1, 2);
  Viewpoint finer = prepare(meshes, view, threads, samples);
  if (samples > 1 && place_of(0, part_.height, part_.width) > max_samples)
    finer = prepare(meshes, view, threads, samples = 1);
  // Each thread has a picture of its own; together they are to have no more than four large ones.
  const std::size_t pictures = 4 * max_samples / std::max<std::size_t>(1, place_of(0, part_.height, part_.width));
  threads = std::min(threads, static_cast<unsigned>(std::clamp<std::size_t>(pictures, 1, max_threads)));
  make_room(samples, out);
  draw_solids(meshes, finer, threads);
  const std::size_t drawn = place_of(0, part_.height, part_.width);
  const auto painters = static_cast<unsigned>(std::clamp<std::size_t>(drawn / samples_a_thread, 1, max_threads));
  const auto bands = static_cast<std::size_t>((part_.height + band_rows - 1) / band_rows);
  core::parallel_ranges(bands, 1, {std::min(control.threads, painters), nullptr}, [&](std::size_t number, std::size_t) {
    bands_.lend([&](Band& band) {
      band.first_row = static_cast<int>(number) * band_rows;
      band.rows = std::min(band_rows, part_.height - band.first_row);
      finish_band(meshes, finer, samples, band, out);
    });
  });
}

void Rasteriser::make_room(int samples, Rendering& out) const {
  out.left = part_.left / samples;
  out.top = part_.top / samples;
  out.width = part_.width / samples;
  out.height = part_.height / samples;
  const std::size_t pixels = place_of(0, out.height, out.width);
  out.argb.resize(pixels);
  out.nearness.resize(pixels);
  out.triangle.resize(pixels);
  out.first_triangle.clear();
  for (const MeshPlace& place : places_) out.first_triangle.push_back(place.first_triangle);
}

namespace {

// The place of a pixel in the lists of a rendering; nothing outside of it.
std::optional<std::size_t> pixel_at(const Rendering& rendering, double x_px, double y_px) {
  const double x = std::floor(x_px) - rendering.left;
  const double y = std::floor(y_px) - rendering.top;
  if (!(x >= 0.0 && y >= 0.0 && x < rendering.width && y < rendering.height)) return std::nullopt;
  return place_of(static_cast<int>(x), static_cast<int>(y), rendering.width);
}

}  // namespace

bool is_hidden(const Rendering& rendering, const Viewpoint& view, double x_px, double y_px, double nearness_px) {
  const auto at = pixel_at(rendering, x_px, y_px);
  if (!at || rendering.nearness[*at] == nothing_near) return false;
  return static_cast<float>(nearness_px) < rendering.nearness[*at] - seen_through(view, nearness_px);
}

std::optional<SeenTriangle> triangle_at(const Rendering& rendering, double x_px, double y_px) {
  const auto at = pixel_at(rendering, x_px, y_px);
  if (!at || rendering.triangle[*at] == no_triangle) return std::nullopt;
  const std::uint32_t number = rendering.triangle[*at];
  const auto after = std::ranges::upper_bound(rendering.first_triangle, number);
  const auto mesh = static_cast<std::size_t>(after - rendering.first_triangle.begin()) - 1;
  return SeenTriangle{mesh, number - rendering.first_triangle[mesh]};
}

}  // namespace sarsim::picture

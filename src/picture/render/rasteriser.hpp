#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/task/worker_pool.hpp"
#include "picture/render/mesh.hpp"
#include "picture/render/raster_kernels.hpp"
#include "picture/render/viewpoint.hpp"

namespace sarsim::picture {

/// Meshes as they are seen, in that part of the picture where they are: one value for each pixel, rows from above.
struct Rendering {
  int left = 0;  ///< Where the part begins, in pixels of the picture.
  int top = 0;
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> argb;  ///< 0xAARRGGBB with colours already multiplied by their opacity; 0: nothing there.
  std::vector<float> nearness;      ///< Of the nearest opaque triangle (see Viewpoint); `nothing_near` where none is.
  std::vector<std::uint32_t> triangle;        ///< Its number over all meshes; `no_triangle` where none is.
  std::vector<std::uint32_t> first_triangle;  ///< Of each mesh.

  [[nodiscard]] bool empty() const { return width == 0 || height == 0; }
};
/// Where there is no triangle.
inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();
/// Where there is nothing near.
inline constexpr float nothing_near = -std::numeric_limits<float>::infinity();

/// How a picture is made.
struct RenderControl {
  unsigned threads = 1;  ///< Changes nothing in the picture.
  /// For each side of a pixel: 2 makes edges smooth and takes four times as long. 1 is taken where 2 would need more
  /// than 128 MB.
  int samples = 1;
};

/// Draws meshes by depth: at every pixel what is nearest is seen, and veils that are not behind it lie over it, in the
/// order of their meshes. The picture is the same for any number of threads and any instruction set. Keeps its room
/// from picture to picture. A point that is not a finite number takes its triangles with it.
///
/// 1 million triangles in a picture of a megapixel take 19 ms on two cores with AVX-512, 33 ms on one.
class Rasteriser {
 public:
  /// Draws what is seen in a picture of the size of the view, rounded to whole pixels and at most 32 767 to a side.
  void render(const MeshList& meshes, const Viewpoint& view, const RenderControl& control, Rendering& out);

 private:
  // A part of the picture, in samples.
  struct Part {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;

    [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
  };
  struct MeshPlace {
    std::size_t first_corner = 0;
    std::uint32_t first_triangle = 0;
    std::size_t first_chunk = 0;
    std::size_t chunks = 0;  // none: it cannot be drawn
    Part part;               // where it is seen
  };
  // Triangles that one thread draws at once.
  struct Chunk {
    std::size_t mesh = 0;
    std::size_t first = 0;  // within the mesh
    std::size_t count = 0;
  };
  // Some rows of samples, while they are coloured.
  struct Band {
    int first_row = 0;
    int rows = 0;
    std::vector<std::uint32_t> argb;
    std::vector<std::int64_t> veil;  // keys
    std::vector<std::uint32_t> odd;
  };

  [[nodiscard]] Viewpoint prepare(const MeshList& meshes, const Viewpoint& view, unsigned threads, int samples);
  void place_meshes(const MeshList& meshes);
  void make_room(int samples, Rendering& out) const;
  void project(const MeshList& meshes, const Viewpoint& view, unsigned threads);
  [[nodiscard]] static Part part_of(std::span<const Corner> corners, int width, int height, int samples);
  [[nodiscard]] static Part common(const Part& a, const Part& b);
  [[nodiscard]] static Part around(const Part& a, const Part& b);
  void draw_solids(const MeshList& meshes, const Viewpoint& view, unsigned threads);
  void draw_chunk(const Mesh& mesh, const Chunk& chunk, const Viewpoint& view, const KeyRows& rows,
                  std::vector<std::uint32_t>& odd) const;
  void finish_band(const MeshList& meshes, const Viewpoint& view, int samples, Band& band, Rendering& out);
  void colour_solids(const MeshList& meshes, Band& band) const;
  void lay_veil(const Mesh& mesh, std::size_t number, const Viewpoint& view, Band& band) const;
  void store(const Band& band, int samples, Rendering& out) const;
  void store_samples(const Band& band, Rendering& out) const;
  [[nodiscard]] std::size_t mesh_of(std::int64_t key) const;
  [[nodiscard]] std::span<const std::int64_t> solid_keys(const Band& band) const;

  std::vector<MeshPlace> places_;
  std::vector<Corner> corners_;
  std::vector<Chunk> chunks_;
  Part part_;  // what is drawn
  // What each thread drew of the opaque meshes: keys of all samples of the part. The nearest of them come into the
  // first.
  std::vector<std::vector<std::int64_t>> keys_;
  core::WorkerPool<Band> bands_{[] { return std::make_unique<Band>(); }};
};

/// Whether something at a place of the picture, in pixels, is behind what was rendered there. Where nothing was, and
/// outside the picture, it is not. What lies on a triangle within two pixels of depth is seen.
[[nodiscard]] bool is_hidden(const Rendering& rendering, const Viewpoint& view, double x_px, double y_px,
                             double nearness_px);

/// A triangle of a mesh.
struct SeenTriangle {
  std::size_t mesh = 0;      ///< Its number in the list.
  std::size_t triangle = 0;  ///< Within the mesh.
};
/// The opaque triangle that is seen at a place of the picture, in pixels; nothing where none is.
[[nodiscard]] std::optional<SeenTriangle> triangle_at(const Rendering& rendering, double x_px, double y_px);

}  // namespace sarsim::picture

#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "core/task/progress.hpp"
#include "core/task/stop.hpp"
#include "picture/image/overview_cache.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::picture {

/// What a cell of an overview holds of the magnitudes of its samples.
enum class OverviewKind { peak, mean };

/// What an overview holds and where it is kept.
struct OverviewOptions {
  OverviewKind kind = OverviewKind::peak;
  std::size_t max_cells = std::size_t{8} << 20;  ///< Of the finest level: 4 bytes each, a third more for the others.
  /// Where it is kept between runs; not where there is none. See overview_cache.hpp.
  std::optional<OverviewCache> cache = std::nullopt;
  /// Whether the plane is what the cache's identity says, asked before anything is kept.
  std::function<bool()> still_the_same = nullptr;
};

/// Cells of one level: cell (i, k) stands for the samples of rows [i 2^row_log2, (i + 1) 2^row_log2) and columns
/// [k 2^col_log2, (k + 1) 2^col_log2).
struct OverviewLevel {
  unsigned row_log2 = 0;
  unsigned col_log2 = 0;
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// How much of an overview is there.
enum class OverviewState {
  building,  ///< From some rows of the plane only; finer with every call.
  complete,  ///< Every sample has been looked at.
  stopped,   ///< Ended early, because reading failed or it was asked to.
};

/// A pyramid of the peak (or mean) magnitudes of a plane in cells of 2^k samples a side, built on a thread of its own.
///
/// The finest level has at most `max_cells`; the longer side of a plane is thinned out first, so that rows and columns
/// have steps of their own. A first pass looks at single rows, far apart at first, so that something of the whole plane
/// can be shown within moments; a second one looks at everything. Memory: 4 bytes for each cell, and some MB while it
/// is being built. Functions may be called from any thread.
class Overview {
 public:
  /// Begins at once, with the rows that are there now. A plane without samples is complete.
  Overview(std::shared_ptr<const raster::Raster> plane, const OverviewOptions& options = {});
  Overview(const Overview&) = delete;
  Overview& operator=(const Overview&) = delete;
  /// Ends the work; waits for the read that is under way.
  ~Overview();

  /// How much of it is there now.
  [[nodiscard]] OverviewState state() const;
  /// Cell rows of the finest level that are exact, of all.
  [[nodiscard]] core::Progress progress() const;
  /// What made the work end early; empty where nothing did.
  [[nodiscard]] std::string failure() const;
  /// Whether it came from the cache.
  [[nodiscard]] bool from_cache() const;
  /// Waits until it is complete or ended; throws Interrupted where asked to stop.
  void wait(const core::StopFlag* stop = nullptr) const;
  /// Ends the work early; what is there stays.
  void stop() { stop_.request(); }

  /// The finest level.
  [[nodiscard]] const OverviewLevel& base() const { return base_; }
  /// Cells of steps 2^row_log2 and 2^col_log2, none finer than the base, from cell row row0 and cell column col0 on:
  /// peaks (means) over cells of the base. Before it is complete, cell rows that have not been looked at are those of
  /// the nearest one that has among the 63 before them, otherwise 0. std::out_of_range for cells that are not there,
  /// std::invalid_argument where `out` has not rows * cols places.
  void read(unsigned row_log2, unsigned col_log2, std::size_t row0, std::size_t rows, std::size_t col0,
            std::size_t cols, std::span<float> out) const;
  /// The level with the same steps.
  [[nodiscard]] OverviewLevel level(unsigned row_log2, unsigned col_log2) const;

 private:
  struct Level {
    OverviewLevel shape;
    std::vector<float> cells;
  };

  void work();
  void sample_rows();
  void refine();
  void reduce_row(std::size_t cell_row, std::size_t count, std::vector<float>& row) const;
  void publish(std::size_t cell_row, const std::vector<float>& row, std::uint8_t known);
  void make_levels();
  [[nodiscard]] std::string cache_words() const;
  [[nodiscard]] bool load();
  void store() const;
  [[nodiscard]] std::size_t shown_row(std::size_t cell_row) const;
  void add_cells(const Level& source, unsigned row_log2, unsigned col_log2, std::size_t row, std::size_t col0,
                 std::span<float> out) const;

  std::shared_ptr<const raster::Raster> plane_;
  std::size_t plane_rows_;
  OverviewOptions options_;
  OverviewLevel base_;
  std::vector<Level> levels_;        // The base first; the others once it is complete.
  std::vector<std::uint8_t> known_;  // Of each row of the base: 0 nothing, 1 some samples, 2 all of them.
  std::size_t exact_rows_ = 0;
  OverviewState state_ = OverviewState::building;
  std::string failure_;
  bool from_cache_ = false;
  mutable std::mutex lock_;  // For everything above.
  mutable std::condition_variable ended_;
  core::StopFlag stop_;
  std::thread thread_;
};

/// Peaks (or means) of the magnitudes of cells that begin at (row0, col0), row_bin x col_bin samples each, straight
/// from a plane: what an overview is made of, for steps finer than its own. Cells may reach beyond the plane. Reads
/// some MB at a time; throws Interrupted.
void reduce_plane(const raster::Raster& plane, OverviewKind kind, std::size_t row0, std::size_t rows,
                  std::size_t row_bin, std::size_t col0, std::size_t cols, std::size_t col_bin, std::span<float> out,
                  const core::StopFlag* stop = nullptr);

}  // namespace sarsim::picture

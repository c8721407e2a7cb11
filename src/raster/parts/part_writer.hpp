#pragma once

#include <cstdint>
#include <vector>

#include "core/hash/checksum.hpp"
#include "core/os/journal_file.hpp"
#include "raster/parts/journal.hpp"
#include "raster/table/placed_rows.hpp"

namespace sarsim::raster {

/// How often rows are brought to the disk and vouched for.
struct JournalPace {
  double seconds = 1.0;  ///< From one entry to the next, at least; 0: every block of rows.
  /// The most that bringing to the disk may cost, as a share of the whole time: where it is slow, entries are rarer.
  double max_share = 0.003;
};

/// Writes the rows that a part makes, and vouches in its journal for those that are safe: an entry is written when the
/// rows it speaks of are on the disk, and the entry is brought there, too. One thread at a time.
class PartWriter {
 public:
  /// Keeps references to the files.
  /// @param rows     the shared file, or the part's own, which is continued at its end
  /// @param journal  to be continued at its end
  /// @param places   of the rows in the shared file; a row size of 0: in the part's own, one after the other
  PartWriter(PlacedRows& rows, core::JournalFile& journal, const RowPlaces& places, const JournalPace& pace);

  /// Writes rows to the file; now and then vouches for what there is.
  void take(const EncodedRows& block);
  /// Brings everything to the disk and vouches for it.
  void settle();
  /// Claims made so far.
  [[nodiscard]] const std::vector<Claim>& claims() const { return claims_; }
  /// Time spent on bringing rows and journal to the disk.
  [[nodiscard]] double settling_s() const { return settling_s_; }

 private:
  struct Pending {
    Claim claim;
    core::Checksum sum;
  };

  PlacedRows& rows_;
  core::JournalFile& journal_;
  RowPlaces places_;
  JournalPace pace_;
  std::uint64_t rows_end_ = 0;
  std::vector<Pending> pending_;
  std::vector<Claim> claims_;
  double settled_at_s_ = 0.0;
  double next_settling_s_ = 0.0;
  double settling_s_ = 0.0;
};

}  // namespace sarsim::raster

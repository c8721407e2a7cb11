#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "raster/parts/join_parts.hpp"
#include "raster/parts/part_writer.hpp"

namespace sarsim::raster {

/// A share of a recording that one process makes on its own.
struct PartTask {
  std::filesystem::path output;  ///< What the parts become together.
  std::string name;              ///< Of the part's files: "part-3-of-8".
  std::string words;             ///< Of the part in messages: "3/8".
  RowRange range;
  bool dealt = false;   ///< Rows come as a leader deals them, who has made sure of them; `range` is empty.
  bool apart = false;   ///< Rows go to a file of the part's own, to be joined by somebody else.
  bool resume = false;  ///< Go on where an earlier process ended; otherwise nothing may be there.
  bool anew = false;    ///< Forget what an earlier process made of this very part.
  Identity identity;
  StoredProduct product;
  JournalPace pace;
};

/// What `PartRun::finish` found.
struct PartOutcome {
  std::size_t rows_there = 0;    ///< Of the whole recording, that are vouched for.
  bool elsewhere = false;        ///< Another part has completed the recording meanwhile.
  std::optional<Joined> joined;  ///< This part was the last: the recording has its name.
};

/// A part at work: its files in the folder OUTPUT.parts, its locks, what is left to do. docs/formats/parts.md.
///
/// Several may be at work in one folder, on one machine or on many, as long as their ranges do not meet. Nothing is
/// lost when one ends abruptly: what its journal vouches for is found by the next one that resumes.
class PartRun {
 public:
  /// Enters the folder, which is made where it is missing; reads and verifies what is there.
  /// @throws core::RetryableError where another process makes it, or a part that its range meets
  /// @throws core::InvalidRequest where the part cannot be made here: it was begun and `resume` is not set, its range
  /// meets
  ///         another part, what is there belongs to another run or is damaged
  PartRun(PartTask task, const core::WorkControl& control);
  PartRun(const PartRun&) = delete;
  PartRun& operator=(const PartRun&) = delete;
  ~PartRun() = default;

  /// Ranges that are still to be made, in order.
  [[nodiscard]] const std::vector<RowRange>& missing() const { return missing_; }
  /// Rows whose journal vouched for bytes that are not there; they are missing again.
  [[nodiscard]] std::size_t rejected_rows() const { return rejected_rows_; }
  [[nodiscard]] PartWriter& writer() { return *writer_; }
  /// Vouches for everything and, where the recording is whole and nothing is `apart`, completes it. What others vouch
  /// for is read once and held against their checksums.
  /// @throws core::InvalidRequest where it is not what they say; std::runtime_error where the part's own files have
  /// gone, though
  ///         the recording is not complete
  [[nodiscard]] PartOutcome finish(bool replace, const RunControl& control);

 private:
  void enter();
  void choose_name();
  void forget_own(std::vector<Journal>& journals) const;
  void expect_same_run(const std::vector<Journal>& journals) const;
  void expect_free(const Journal& journal);
  void begin_journal();
  void begin_rows(bool anew);
  void verify(const core::WorkControl& control);
  void expect_complete() const;
  void take_out(const Journal& journal, const std::vector<Claim>& bad);

  [[nodiscard]] std::filesystem::path journal_path() const { return folder_ / (task_.name + ".journal"); }
  [[nodiscard]] const Journal* own() const;

  PartTask task_;
  std::filesystem::path folder_;
  RowStore store_ = RowStore::placed;
  RowPlaces places_;
  std::vector<Journal> journals_;  // All that concern the part's rows.
  std::vector<Claim> checked_;     // Of these, what was found to be there.
  core::JournalFile journal_;      // The part's own, locked.
  PlacedRows rows_;
  std::vector<RowRange> missing_;
  std::size_t rejected_rows_ = 0;
  std::optional<PartWriter> writer_;
};

}  // namespace sarsim::raster

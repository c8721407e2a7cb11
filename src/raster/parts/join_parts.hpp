#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/os/raw_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "raster/parts/journal.hpp"
#include "raster/parts/stored_product.hpp"
#include "raster/table/encode_rows.hpp"

namespace sarsim::raster {

/// The folder beside an output in which its parts come together; where the output is a link, beside what it means, so
/// that both are on one disk.
[[nodiscard]] std::filesystem::path parts_folder_of(const std::filesystem::path& output);

/// The receipt beside an output, by which a later run knows that it is whole.
[[nodiscard]] std::filesystem::path receipt_of(const std::filesystem::path& output);

/// The file of a folder that all parts share, with the rows at their places; and the one with what joining needs.
[[nodiscard]] std::filesystem::path shared_rows_of(const std::filesystem::path& folder);
[[nodiscard]] std::filesystem::path product_file_of(const std::filesystem::path& folder);

/// Locks the door of a folder of parts (its file `lock`), which whoever changes the folder as a whole must hold.
/// Creates the folder if it is missing. Waits for the lock; the folder may vanish meanwhile, since whoever completes
/// the recording removes it.
[[nodiscard]] core::RawFile open_door(const std::filesystem::path& folder);

/// Whether a name in such a folder is that of an unfinished result of a join.
[[nodiscard]] bool is_left_by_join(const std::string& name);

/// All journals of a folder, by name. @throws core::InvalidRequest with everything that is damaged
[[nodiscard]] std::vector<Journal> read_journals(const std::filesystem::path& folder);

/// Removes what parts have left in a folder, and the folder where it is empty then; the description of the recording
/// last, by which the rest is known where the process is killed meanwhile.
void remove_parts(const std::filesystem::path& folder) noexcept;

/// Removes what killed joins have left in a folder, and the folder itself if it has no parts. Its door must be held.
void remove_joins(const std::filesystem::path& folder) noexcept;

/// Rows of a range for which no journal vouches, in order.
[[nodiscard]] std::vector<RowRange> missing_rows(RowRange range, std::span<const Journal> journals);

/// What keeps journals from being joined: rows that are missing, rows that two vouch for, other identities.
[[nodiscard]] core::Problems join_problems(const std::vector<Journal>& journals, std::size_t rows);

/// Errors if a description does not belong to a journal's run, judged by everything that determines the bytes of both.
/// Whether several journals belong to one run is checked by `join_problems`.
/// @param file  of the description
[[nodiscard]] core::Problems product_problems(const StoredProduct& product, const std::filesystem::path& file,
                                              const Journal& journal);

/// Whether the bytes that a claim speaks of are what it says.
/// @param places  of rows that stand at their places
[[nodiscard]] bool holds(const Journal& journal, const Claim& claim, const RowPlaces& places);

/// What is joined, and into what.
struct JoinTask {
  std::filesystem::path output;
  StoredProduct product;
  std::vector<Journal> journals;  ///< Without `join_problems`.
  bool replace = false;
  /// Of rows that stand at their places already: those that need not be read and held against their checksums, because
  /// the caller has written them or done so.
  std::vector<Claim> checked;
};

/// What the whole turned out to be.
struct Joined {
  RunReport report;  ///< `seconds`: of computing, of all parts together.
};

/// Makes a recording's file of its parts, byte for byte the file of a single run, and gives it its name; beside it a
/// receipt ".journal" by which a later `--resume` knows it. The parts stay where they are, but for the shared file,
/// which becomes the output where all rows stand in it.
/// Where it fails, the parts are all that is left.
/// @throws core::InvalidRequest where rows are not what their journal says, and where the output is there but no file
Joined join_parts(const JoinTask& task, const RunControl& control);

/// A finished recording's receipt.
struct Receipt {
  Identity identity;
  RunReport report;
};

/// Whether a recording is there that was finished, with its receipt, and was not changed since.
[[nodiscard]] bool is_finished(const std::filesystem::path& output);

/// The receipt of a finished recording; nothing where there is none or where the file was changed since.
[[nodiscard]] std::optional<Receipt> read_receipt(const std::filesystem::path& output, const StoredProduct& product);

}  // namespace sarsim::raster

#include "workflow/record/side_files.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "core/os/journal_file.hpp"
#include "core/os/output_file.hpp"
#include "raster/parts/join_parts.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// Whose whole first line is that of a journal, with its checksum.
bool is_journal(const fs::path& file) {
  const std::string signature = core::sealed_line(raster::journal_signature);
  return core::beginning_of(file, signature.size()) == signature;
}

core::Problems problems_of_receipt(const fs::path& receipt) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(receipt, ignored);
  if (!fs::exists(status) || (fs::is_regular_file(status) && is_journal(receipt))) return {};
  return {core::error("the file name of the recording's receipt is taken by something else")
              .found(receipt.string())
              .hint("move that away, or give the recording another name or folder")};
}

// Whoever makes parts in a folder opens its file `lock` before anything else; a copy of it may hold journals alone.
bool holds_parts(const fs::path& folder) {
  std::error_code failure;
  if (fs::is_regular_file(fs::symlink_status(folder / "lock", failure))) return true;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
    if (entry->path().extension() == ".journal" && entry->is_regular_file(failure) && is_journal(entry->path()))
      return true;
  return false;
}

// Whether a process that was joining parts, and was killed, left everything that is there.
bool holds_joins_alone(const fs::path& folder) {
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
    if (!raster::is_left_by_join(entry->path().filename().string())) return false;
  return !failure;
}

core::Problems problems_of_parts_folder(const fs::path& folder) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(folder, ignored);
  if (!fs::exists(status)) return {};
  const std::string hint = "move it away, or give the recording another name or folder";
  if (!fs::is_directory(status))
    return {core::error("the folder for the recording's parts has the name of something that is not a folder")
                .found(folder.string())
                .hint(hint)};
  if (holds_joins_alone(folder) || holds_parts(folder)) return {};
  return {core::error("the folder for the recording's parts holds files that are not parts")
              .found(folder.string())
              .hint(hint)};
}

// One name for a file, whatever links lead to it; none for what takes several outputs.
fs::path identity_of_file(const fs::path& path) {
  std::error_code ignored;
  const fs::path end = fs::absolute(core::end_of_links(path));
  const fs::file_status status = fs::status(end, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) return {};
  const fs::path canonical = fs::weakly_canonical(end, ignored);
  return ignored ? end.lexically_normal() : canonical;
}

}  // namespace

std::vector<fs::path> side_files_of(const fs::path& output) {
  return {raster::receipt_of(output), raster::parts_folder_of(output)};
}

core::Problems problems_of_side_files(const fs::path& output) {
  core::Problems problems = problems_of_receipt(raster::receipt_of(output));
  core::append(problems, problems_of_parts_folder(raster::parts_folder_of(output)));
  return problems;
}

core::Problems problems_of_same_files(const std::vector<fs::path>& paths) {
  core::Problems problems;
  std::map<fs::path, fs::path> taken;
  for (const fs::path& path : paths) {
    const fs::path identity = identity_of_file(path);
    if (identity.empty()) continue;
    const auto [earlier, is_new] = taken.emplace(identity, path);
    if (is_new) continue;
    problems.push_back(core::error(fmt::format("this output and '{}' are one file", earlier->second.string()))
                           .found(path.string())
                           .hint("give each of them a name of its own"));
  }
  return problems;
}

}  // namespace sarsim::workflow

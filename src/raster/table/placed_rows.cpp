#include "raster/table/placed_rows.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/os/file_identity.hpp"
#include "core/os/output_file.hpp"

namespace sarsim::raster {

namespace {

// Number of a file or folder in its file system; 0 where there is none.
std::uint64_t number_of(const std::filesystem::path& path) {
  const std::optional<core::FileIdentity> identity = core::identity_of(path);
  return identity ? identity->number : 0;
}

}  // namespace

PlacedRows::PlacedRows(std::filesystem::path path, const RowPlaces& places, core::RawFile::Mode mode)
    : path_(std::move(path)), places_(places), mode_(mode) {
  if (places_.piece_bytes == 0) {
    file_ = core::RawFile(path_, mode);
    return;
  }
  if (mode_ != core::RawFile::Mode::read) std::filesystem::create_directories(places_.file_of(path_, 0).parent_path());
  folder_ = number_of(path_);
}

core::RawFile& PlacedRows::piece(std::uint64_t number) const {
  if (open_ == number) return file_;
  file_ = core::RawFile();
  open_ = UINT64_MAX;
  file_ = core::RawFile(places_.file_of(path_, number), mode_);
  // Not with room on the disk: file systems write into that many times slower.
  if (mode_ != core::RawFile::Mode::read && file_.size() < places_.piece_bytes) file_.resize(places_.piece_bytes);
  open_ = number;
  return file_;
}

void PlacedRows::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  if (places_.piece_bytes == 0) return file_.write_at(offset, bytes);
  while (!bytes.empty()) {
    const std::uint64_t number = offset / places_.piece_bytes;
    const std::uint64_t begin = offset % places_.piece_bytes;
    const auto part = bytes.first(std::min<std::uint64_t>(bytes.size(), places_.piece_bytes - begin));
    piece(number).write_at(begin, part);
    unsafe_.insert(number);
    bytes = bytes.subspan(part.size());
    offset += part.size();
  }
}

bool PlacedRows::read_at(std::uint64_t offset, std::span<std::byte> bytes) const {
  if (places_.piece_bytes == 0) return file_.read_at(offset, bytes);
  while (!bytes.empty()) {
    const std::uint64_t number = offset / places_.piece_bytes;
    const std::uint64_t begin = offset % places_.piece_bytes;
    const auto part = bytes.first(std::min<std::uint64_t>(bytes.size(), places_.piece_bytes - begin));
    std::error_code missing;
    if (open_ != number && !std::filesystem::exists(places_.file_of(path_, number), missing)) return false;
    if (!piece(number).read_at(begin, part)) return false;
    bytes = bytes.subspan(part.size());
    offset += part.size();
  }
  return true;
}

void PlacedRows::sync() {
  if (places_.piece_bytes == 0) return file_.sync();
  for (const std::uint64_t number : unsafe_) piece(number).sync();
  if (!unsafe_.empty()) core::sync_folder_of(places_.file_of(path_, 0));
  unsafe_.clear();
}

bool PlacedRows::still_there() const {
  return places_.piece_bytes == 0 ? file_.still_there() : folder_ != 0 && number_of(path_) == folder_;
}

}  // namespace sarsim::raster

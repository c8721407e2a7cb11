#include "workflow/input/input_list.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "core/os/output_file.hpp"
#include "raster/format/envi.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// Of a regular file or a folder: nothing is lost of what is neither.
std::optional<core::FileIdentity> id_of(const fs::path& path, bool& folder) {
  const std::optional<core::FileStatus> status = core::file_status(path);
  if (!status || !(status->folder || status->regular)) return std::nullopt;
  folder = status->folder;
  return status->identity;
}

// What is read together with a file: its header, or the other file of a pair.
std::vector<fs::path> companions_of(const fs::path& file) {
  std::vector<fs::path> files;
  const raster::Format* const format = raster::row_from_path(file);
  // A scene, its recording and an image of it have one name before their endings: the header is the image's alone.
  const fs::path header = raster::envi_header_of(file);
  std::error_code none;
  const auto is_file = [&](const fs::path& image) { return fs::equivalent(image, file, none); };
  if (std::ranges::any_of(raster::images_of_header(header), is_file)) files.push_back(header);
  if (format != nullptr && format->in_files != nullptr) {
    std::vector<fs::path> pair = raster::files_of(format, file);
    std::ranges::move(pair, std::back_inserter(files));
  }
  return files;
}

// Looks for what an output would take out of a folder.
class FolderSearch {
 public:
  // @param place  of the output
  FolderSearch(core::FileIdentity output, const fs::path& place) : output_(output), place_(place) {}

  // Whether the file, or what is in the folder, is the output, or is in it by a link.
  bool finds_in(const fs::path& folder) {
    std::error_code failure;
    for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
      bool is_folder = false;
      const auto id = id_of(entry->path(), is_folder);
      if (!id) continue;
      if (*id == output_) return true;
      std::error_code none;
      if (entry->is_symlink(none) && is_below(file_place(entry->path()), place_)) return true;
      if (is_folder && met_.insert(*id).second && finds_in(entry->path())) return true;
    }
    return false;
  }

 private:
  core::FileIdentity output_;
  const fs::path& place_;
  std::set<core::FileIdentity> met_;  // Links may lead around in circles.
};

core::Problem harm(const fs::path& output, std::string message) {
  return core::error(std::move(message)).found(output.string());
}

// A scene's includes and data files; recording and script of an image.
std::vector<fs::path> files_behind(const fs::path& file) {
  if (holds_script(file.string())) return sources_of_script(file.string());
  const std::string path = file.string();
  constexpr std::size_t longest_header = std::size_t{1} << 20U;
  const fs::path header_file = raster::envi_header_of(path);
  const raster::EnviReading reading =
      raster::read_envi_header(core::beginning_of(header_file, longest_header), header_file.string());
  std::vector<fs::path> files;
  if (!reading.header) return files;
  for (const char* const name : {"source", "script"}) {
    const std::string value = reading.header->field(name).value_or("");
    if (value.empty()) continue;
    files.emplace_back(value);
    files.push_back(file.parent_path() / value);
  }
  return files;
}

}  // namespace

fs::path file_place(const fs::path& path) {
  std::error_code failure;
  fs::path place = path.has_filename() ? path : path.parent_path();
  place = fs::weakly_canonical(fs::absolute(core::end_of_links(place)), failure);
  return failure ? fs::absolute(path).lexically_normal() : place;
}

bool is_below(const fs::path& place, const fs::path& folder) {
  return std::ranges::mismatch(folder, place).in1 == folder.end();
}

InputList InputList::named(std::vector<fs::path> files) {
  InputList list;
  list.add(files);
  list.to_follow_ = std::move(files);
  return list;
}

void InputList::add(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    if (file.empty()) continue;
    add_one(file);
    for (const fs::path& companion : companions_of(file)) add_one(companion);
  }
}

void InputList::add(const InputList& other) {
  entries_.insert(entries_.end(), other.entries_.begin(), other.entries_.end());
  to_follow_.insert(to_follow_.end(), other.to_follow_.begin(), other.to_follow_.end());
}

void InputList::add_one(const fs::path& file) const {
  bool folder = false;
  const auto id = id_of(file, folder);
  if (!id || std::ranges::find(entries_, *id, &Entry::identity) != entries_.end()) return;
  entries_.push_back({file_place(file), *id, folder});
}

void InputList::follow() const {
  std::set<fs::path> followed;
  while (!to_follow_.empty()) {
    const fs::path file = std::move(to_follow_.back());
    to_follow_.pop_back();
    std::error_code none;
    if (!fs::is_regular_file(file, none) || !followed.insert(file_place(file)).second) continue;
    for (fs::path& behind : files_behind(file)) {
      add_one(behind);
      for (const fs::path& companion : companions_of(behind)) add_one(companion);
      to_follow_.push_back(std::move(behind));
    }
  }
}

std::optional<core::Problem> InputList::harm_to_known(const fs::path& output) const {
  bool to_folder = false;
  const auto id = id_of(output, to_folder);
  const fs::path place = file_place(output);
  for (const Entry& entry : entries_) {
    const char* const what = entry.folder ? "folder" : "file";
    if (id && *id == entry.identity)
      return harm(output, fmt::format("the output would replace the {} that it is made from", what));
    if (entry.folder && is_below(place, entry.place))
      return harm(output, fmt::format("the output lies in the folder '{}' that it is made from", entry.place.string()));
    if (to_folder && is_below(entry.place, place))
      return harm(output, fmt::format("the output would replace a folder with the {} that it is made from", what));
    if (id && entry.folder && FolderSearch(*id, place).finds_in(entry.place))
      return harm(output, fmt::format("the output would replace a part of the folder '{}' that it is made from",
                                      entry.place.string()));
  }
  return std::nullopt;
}

std::optional<core::Problem> InputList::harm_of(const fs::path& output, bool replaces) const {
  auto found = harm_to_known(output);
  std::error_code none;
  if (found || to_follow_.empty() || !replaces || !fs::exists(output, none)) return found;
  follow();
  return harm_to_known(output);
}

}  // namespace sarsim::workflow

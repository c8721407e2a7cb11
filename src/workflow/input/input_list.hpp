#pragma once

#include <sys/types.h>

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "core/report/problem.hpp"

namespace sarsim::workflow {

/// Everything that a command reads, against which each of its outputs is compared: one list, made in one place.
///
/// To each file belongs what is read with it: the header of an image, the other file of a SigMF recording; to a folder
/// everything in it. Files that a command only names (`named`) are followed: a scene to what it includes and to its
/// data files, an image to the recording and the script of its header. Files are compared by what they are (device and
/// number), not by what they are called: links of both kinds, another case, relative paths and "..".
///
/// What follows of a scene is read where an output stands in the way, and once. Not for several threads.
class InputList {
 public:
  InputList() = default;
  /// Files that are all that is read, such as `SceneInput::sources`.
  InputList(const std::vector<std::filesystem::path>& files) { add(files); }  // NOLINT: a list is what it lists
  InputList(std::initializer_list<std::filesystem::path> files) { add(std::vector<std::filesystem::path>(files)); }
  /// Files that a command line names, whether or not they are there, with all that is read because of them.
  [[nodiscard]] static InputList named(std::vector<std::filesystem::path> files);

  /// Adds files that are all that is read.
  void add(const std::vector<std::filesystem::path>& files);
  /// Adds all of another list.
  void add(const InputList& other);

  /// What would be lost of the files if the output replaced what is there, or were made where it is to be; nothing
  /// where nothing would.
  /// @param replaces  a file that exists is replaced; else what follows of a scene need not be read: nothing is lost
  [[nodiscard]] std::optional<core::Problem> harm_of(const std::filesystem::path& output, bool replaces) const;

 private:
  using Identity = std::pair<dev_t, ino_t>;

  struct Entry {
    std::filesystem::path place;  // Behind all links.
    Identity identity;
    bool folder = false;
  };

  void add_one(const std::filesystem::path& file) const;
  void follow() const;
  [[nodiscard]] std::optional<core::Problem> harm_to_known(const std::filesystem::path& output) const;

  mutable std::vector<Entry> entries_;
  mutable std::vector<std::filesystem::path> to_follow_;
};

/// The place that a path leads to, through all links, also where nothing is there.
[[nodiscard]] std::filesystem::path file_place(const std::filesystem::path& path);

/// Whether a place is a folder or stands below it; both as `file_place` gives them.
[[nodiscard]] bool is_below(const std::filesystem::path& place, const std::filesystem::path& folder);

}  // namespace sarsim::workflow

#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "core/os/file_identity.hpp"
#include "core/report/problem.hpp"

namespace sarsim::workflow {

/// Everything that a command reads, against which each of its outputs is compared: one list, made in one place.
///
/// Each file includes what is read with it: the header of an image, the other file of a SigMF recording; a folder
/// includes everything in it. Files that a command only names (`named`) are followed: a scene to its included files and
/// data files, an image to the recording and the script in its header. Files are compared by device and inode, not by
/// name: symbolic and hard links, another case, relative paths and ".." make no difference.
///
/// Scenes are followed only when an output meets an existing file, and once. Not for several threads.
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

  /// The error if making the output would replace one of the files, or change a folder that is read; nothing if not.
  /// @param replaces  an existing file is replaced; otherwise scenes need not be followed: nothing is lost
  [[nodiscard]] std::optional<core::Problem> harm_of(const std::filesystem::path& output, bool replaces) const;

 private:
  using Identity = core::FileIdentity;

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

/// The path through all links, also if there is no file.
[[nodiscard]] std::filesystem::path file_place(const std::filesystem::path& path);

/// Whether a path is a folder or is below it; both as returned by `file_place`.
[[nodiscard]] bool is_below(const std::filesystem::path& place, const std::filesystem::path& folder);

}  // namespace sarsim::workflow

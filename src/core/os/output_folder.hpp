#pragma once

#include <filesystem>
#include <functional>

#include "core/os/temporary_files.hpp"

namespace sarsim::core {

/// Whether a folder that stands under the name of an output may be replaced.
using FolderTest = std::function<bool(const std::filesystem::path& folder)>;

/// A folder of files that appears under its name only when it is complete: what OutputFile is for one file.
///
/// It is made beside its place as ".NAME.partial-PID-N" and filled by whoever has `working_path`; `commit` brings all
/// of it to the disk and gives it its name. Without `replace` an existing folder is refused and stays. With it, a
/// folder for which `ours` holds is exchanged for the new one in one step where the file system can (otherwise in two,
/// between which the name is free), and then removed; any other folder, and whatever is no folder, is refused. A link
/// stays a link: the folder that it leads to is replaced. Destroyed before `commit`, nothing stays behind; nor where a
/// second signal ends the process. Failures are std::system_error that names the action and the folder.
class OutputFolder {
 public:
  /// Begins a folder that will be called `path`.
  OutputFolder(std::filesystem::path path, bool replace, FolderTest ours);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();

  /// Where its files are made until `commit`.
  [[nodiscard]] const std::filesystem::path& working_path() const { return working_path_; }
  /// Brings it to the disk and gives it its name.
  void commit();

 private:
  std::filesystem::path path_;
  bool replace_;
  FolderTest ours_;
  std::filesystem::path working_path_;
  TemporaryName temporary_;
};

/// Brings the files of a folder, of those in it and their names to the disk.
void sync_folder(const std::filesystem::path& folder);

/// Gives a complete folder, which is on the disk already, the name of an output: what `OutputFolder::commit` does last.
/// Both must be on one file system.
/// @throws std::system_error; the complete folder then keeps its name
void publish_folder(const std::filesystem::path& complete, const std::filesystem::path& output, bool replace,
                    const FolderTest& ours);

}  // namespace sarsim::core

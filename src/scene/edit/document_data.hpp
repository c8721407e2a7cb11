#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/edit/document.hpp"

namespace sarsim::scene {

/// A data file that has to be written so that a script means what its document shows.
struct DataFileWrite {
  std::string name;            ///< As the script gives it.
  std::filesystem::path path;  ///< Where it is looked for beside that script.
  std::string text;
  bool replaces = false;  ///< Another file stands there now.
};

/// The data files that the script of a document, saved as `script`, would miss or find with other points, in the order
/// of their names: those of edited functions and included files (`Document::pending_data`), as far as the scene still
/// speaks of them, and, where the script goes to another folder, those that were found from the old one, byte by byte.
/// Files that cannot be read now, and those of other folders (absolute names), are left out unless they were edited.
/// Reads the disk.
[[nodiscard]] std::vector<DataFileWrite> data_to_write(const Document& document, const std::filesystem::path& script);

/// A scene that means what the document shows, to be written anywhere, in the document's language: every function with
/// its points, every cloud with the whole path of its file, and nothing included.
/// The text itself where it speaks of no data file, or holds mistakes for its reader to report.
[[nodiscard]] std::string self_contained_script(const Document& document);

/// Writes each completely or not at all, making folders that do not exist.
/// @throws std::runtime_error naming the file; those before it are written then
void write_data(const std::vector<DataFileWrite>& files);

}  // namespace sarsim::scene

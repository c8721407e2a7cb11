#pragma once

#include <atomic>
#include <filesystem>
#include <string>

namespace sarsim::core {

/// The name of a file, or of a folder of files, that means nothing until it is complete, for as long as it is not: a
/// process that is ended at once removes all of them first (`remove_temporary_files`). Take the name before the file is
/// made.
class TemporaryName {
 public:
  TemporaryName() = default;
  /// Takes the name of a file that is about to be made.
  explicit TemporaryName(const std::filesystem::path& path);
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  TemporaryName(TemporaryName&& other) noexcept;
  TemporaryName& operator=(TemporaryName&& other) noexcept;
  ~TemporaryName() { forget(); }

  /// The file is complete or gone.
  void forget() noexcept;

 private:
  std::string* name_ = nullptr;
  std::atomic<std::string*>* slot_ = nullptr;  // None where the list was full.
};

/// A list of such names.
struct TemporaryNames;

/// The list that names go into.
[[nodiscard]] TemporaryNames& temporary_names() noexcept;

/// Names go into another list from now on. A module that is loaded has its own copy of this code, and of the list: it
/// has to take the program's, which is the one that a signal handler there knows.
void use_temporary_names(TemporaryNames& list) noexcept;

/// Removes a file, or a folder with everything in it: links themselves and not what they lead to. May be called by a
/// signal handler. What cannot be removed stays.
void remove_folder(const std::filesystem::path& folder) noexcept;

/// Removes the files and folders whose names are known to be temporary, at most 256 at a time. May be called by a
/// signal handler, on any thread; the process has to end then.
void remove_temporary_files() noexcept;

}  // namespace sarsim::core

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace sarsim::core {

/// A file without a name, which goes with the process, for what does not fit into memory. Failures are
/// std::system_error and name the folder. May be read and written by many threads at once, each in its own place.
class ScratchFile {
 public:
  /// @param folder  empty: the system's folder for temporary files
  explicit ScratchFile(std::filesystem::path folder);
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile();

  /// Takes the room on the disk.
  void reserve(std::uint64_t bytes) const;
  /// Reads a part of what was asked for, at least a byte, at most a few megabytes.
  [[nodiscard]] std::size_t read_some(std::uint64_t offset, std::span<std::byte> bytes) const;
  /// Writes a part, as `read_some` reads one.
  [[nodiscard]] std::size_t write_some(std::uint64_t offset, std::span<const std::byte> bytes) const;

 private:
  [[noreturn]] void fail(int error, const char* what) const;

  std::filesystem::path folder_;
  int descriptor_ = -1;
};

}  // namespace sarsim::core

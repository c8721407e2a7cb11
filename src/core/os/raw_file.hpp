#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace sarsim::core {

/// An open file whose bytes are read and written by their place. Unlike OutputFile it is there under its name from the
/// beginning: for what several processes, or one after the other, work on. Only regular files; links are followed for
/// reading alone, and what is written has no other name (hard link). Anything else is InvalidRequest when it is opened;
/// every failure is a std::system_error that names the action and the file. Moved-from and default ones are closed.
class RawFile {
 public:
  /// What is done with the file, and whether it has to be there.
  enum class Mode {
    read,
    write,      ///< Read and write; made where it is missing.
    write_new,  ///< The same; refused where it exists.
    append,     ///< Only adds at the end (`append`); made where it is missing.
  };

  RawFile() = default;
  /// Opens a file.
  RawFile(std::filesystem::path path, Mode mode);
  RawFile(RawFile&& other) noexcept;
  RawFile& operator=(RawFile&& other) noexcept;
  ~RawFile();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Bytes of the file now.
  [[nodiscard]] std::uint64_t size() const;
  /// Writes at a place; what lies before it and was never written reads as zeros.
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);
  /// Writes at the end, wherever that is by then; Mode::append.
  void append(std::span<const std::byte> bytes);
  /// Reads what stands at a place; false where the file ends before.
  [[nodiscard]] bool read_at(std::uint64_t offset, std::span<std::byte> bytes) const;
  /// Makes the file at least so long, with room on the disk where the file system can promise it.
  void allocate(std::uint64_t bytes);
  /// Cuts the file off there, or makes it longer with zeros.
  void resize(std::uint64_t bytes);
  /// Returns when everything written is on the disk.
  void sync();

  /// Takes the file for this process until it is closed, however it ends; false where another one has it. On file
  /// systems without locks everybody succeeds.
  [[nodiscard]] bool try_lock();
  /// The same, waiting for the other.
  void lock();
  /// Whether the path still leads to this very file.
  [[nodiscard]] bool still_there() const;
  /// Removes the name, so that it cannot be found any more.
  void unlink() noexcept;

 private:
  friend RawFile replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

  [[noreturn]] void fail(const char* action) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Writes a whole file with OutputFile, replacing the one that was there; InvalidRequest where the name is that of a
/// link or of something else that is not a regular file.
/// @returns the file, locked since before it had its name
RawFile replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace sarsim::core

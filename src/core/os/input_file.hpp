#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "core/report/problem.hpp"

namespace sarsim::core {

/// A regular file opened for reading at any place. May be read from many threads at once.
class InputFile {
 public:
  /// A problem where there is no such file, it may not be read, or it is not a regular file.
  static std::variant<InputFile, Problem> open(const std::filesystem::path& path);
  InputFile(InputFile&& other) noexcept
      : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}
  InputFile& operator=(InputFile&&) = delete;
  ~InputFile();

  /// Reads bytes from a place; fewer than asked for only at the end of the file. std::system_error where the disk
  /// fails.
  std::size_t read_at(std::uint64_t offset, std::span<std::byte> bytes) const;
  /// Reads exactly so many bytes; std::runtime_error where the file has become shorter.
  void read_all_at(std::uint64_t offset, std::span<std::byte> bytes) const;

  /// Bytes of the file when it was opened.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Bytes of the file now; std::system_error where the disk fails.
  [[nodiscard]] std::uint64_t current_size() const;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  InputFile(std::filesystem::path path, int descriptor, std::uint64_t size)
      : path_(std::move(path)), descriptor_(descriptor), size_(size) {}

  std::filesystem::path path_;
  int descriptor_;
  std::uint64_t size_;
};

/// The first `most` bytes of a regular file, or fewer. Empty if there is no file, if it is not a regular one (opening
/// it might block) or if it cannot be read.
[[nodiscard]] std::string beginning_of(const std::filesystem::path& path, std::size_t most);

}  // namespace sarsim::core

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <system_error>

namespace sarsim::core {

/// A file or pipe that is read from its beginning to its end; the wait for a pipe can be given up.
class SequentialFile {
 public:
  /// @param ask  called before each piece and now and then while waiting; may throw
  SequentialFile(const std::filesystem::path& path, std::function<void()> ask);
  SequentialFile(const SequentialFile&) = delete;
  SequentialFile& operator=(const SequentialFile&) = delete;
  ~SequentialFile();

  /// Bytes that were read; 0 at the end, and where there is a `failure`.
  std::size_t read(std::span<char> bytes);
  /// Why it cannot be read; no error where it can.
  [[nodiscard]] std::error_code failure() const { return {failure_, std::generic_category()}; }

 private:
  // Waits a little for more; false where nothing more can come.
  [[nodiscard]] bool waits() const;

  std::function<void()> ask_;
  int descriptor_;
  int failure_ = 0;
  bool begun_ = false;
};

}  // namespace sarsim::core

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sarsim::picture {

/// What identifies the content of a file: its full path, its size and when it was last changed. Nothing where it cannot
/// be asked for.
[[nodiscard]] std::optional<std::string> file_identity(const std::filesystem::path& path);

/// Numbers that are kept between runs in files of one folder, each under a key. Nothing here throws for the disk's
/// sake: what cannot be kept is not kept, and a file that is damaged, cut off, of another key or of another program is
/// as none.
class OverviewCache {
 public:
  /// @param folder      made where it does not exist; only files that end in ".overview" are ever touched
  /// @param identity    of the file, see `file_identity`, and of how it is read
  /// @param max_bytes  of all files together; the oldest go first
  OverviewCache(std::filesystem::path folder, std::string identity, std::uint64_t max_bytes = std::uint64_t{512} << 20);

  /// The `count` numbers that were stored under the identity and these words; nothing where they were not.
  [[nodiscard]] std::optional<std::vector<float>> load(const std::string& words, std::size_t count) const;
  /// Stores numbers, and removes the oldest files where all together are too large.
  void store(const std::string& words, const std::vector<float>& numbers) const;

  [[nodiscard]] const std::string& identity() const { return identity_; }
  /// The file of a key, whether it is there or not.
  [[nodiscard]] std::filesystem::path file_of(const std::string& words) const;

 private:
  void remove_oldest() const;

  std::filesystem::path folder_;
  std::string identity_;
  std::uint64_t max_bytes_;
};

}  // namespace sarsim::picture

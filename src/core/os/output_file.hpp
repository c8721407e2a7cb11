#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "core/os/temporary_files.hpp"

namespace sarsim::core {

/// A file that appears under its name only when it is complete.
///
/// A regular file is written beside its place as ".NAME.partial-PID-N" (created exclusively), brought to the disk and
/// given its name by `commit`. Without `replace` an existing file is refused at construction and never overwritten
/// later either, even if it appeared meanwhile. With `replace` the new file takes the permissions of the old one.
/// A symbolic link stays a link: the file that it points to is replaced. Devices, pipes and sockets are written
/// directly; block devices are refused. Destroyed before `commit`, nothing stays behind;
/// nor where a second signal ends the process (`remove_temporary_files`).
///
/// Partial writes and interrupted calls are continued. Every failure is a std::system_error whose what() names the
/// action and the file; after a failed write `commit` refuses. One thread at a time.
class OutputFile {
 public:
  /// Begins a file that will be called `path`; std::system_error where it exists and is not to be replaced.
  OutputFile(std::filesystem::path path, bool replace);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Appends the bytes after everything that `write` has written so far.
  void write(std::span<const std::byte> bytes);
  /// Writes the bytes at a place; the file grows with zeros where needed. Does not move the end that `write` uses.
  /// Fails on a pipe.
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);
  /// Reads back what stands at a place; zeros beyond the end and from devices.
  void read_at(std::uint64_t offset, std::span<std::byte> bytes) const;
  /// Makes the file so long, with zeros; no effect on devices and pipes.
  void resize(std::uint64_t size);
  /// Brings the content to the disk. Nothing may be written afterwards, and of `commit` only the change of names is
  /// left: files that mean nothing without each other are all secured before the first gets its name.
  void secure();
  /// Gives the file its name, once it is secured.
  void commit();

  /// The name that the caller gave.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Where the bytes are until `commit`: the temporary name, or the device itself.
  [[nodiscard]] const std::filesystem::path& working_path() const { return working_path_; }
  /// False for pipes, whose bytes can only be written in order.
  [[nodiscard]] bool seekable() const { return seekable_; }

 private:
  [[noreturn]] void fail(int error, const char* action) const;
  void open_directly();
  void create_temporary(unsigned mode);
  void synchronise();
  void publish();
  void discard() noexcept;

  std::filesystem::path path_;
  std::filesystem::path target_;  // The file whose content is made: the end of a chain of links.
  std::filesystem::path working_path_;
  TemporaryName temporary_;
  int descriptor_ = -1;
  bool replace_ = false;
  bool direct_ = false;
  bool seekable_ = true;
  bool failed_ = false;
  bool secured_ = false;
  bool committed_ = false;
};

/// Follows links to the file they mean, which need not exist. A path that leads nowhere else is returned as it is.
/// @throws std::system_error where links lead in a circle
[[nodiscard]] std::filesystem::path end_of_links(const std::filesystem::path& path);

/// A name beside a file or folder for what is not complete yet: ".NAME.partial-PID-N", another one at each call.
[[nodiscard]] std::filesystem::path temporary_name(const std::filesystem::path& target);

/// Makes changes of names in a file's folder last over a loss of power, where the file system can.
void sync_folder_of(const std::filesystem::path& path) noexcept;

/// Gives a complete file, which is on the disk already, the name of an output: what `OutputFile::commit` does last.
/// Both must be on one file system. The same rules for existing files, links and permissions; devices and pipes are
/// refused.
/// @throws std::system_error; the complete file then keeps its name
void publish_file(const std::filesystem::path& complete, const std::filesystem::path& output, bool replace);

}  // namespace sarsim::core

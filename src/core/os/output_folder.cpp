#include "core/os/output_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <future>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/os/output_file.hpp"

namespace sarsim::core {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail_on_folder(int error, const char* action, const fs::path& path) {
  throw std::system_error(error, std::generic_category(), fmt::format("cannot {} {}", action, path.string()));
}

// Without the slash that a shell puts behind the name of a folder.
fs::path plain_name(const fs::path& path) { return path.has_filename() ? path : path.parent_path(); }

// Whether something is to be replaced; throws where it must not be.
bool expect_replaceable(const fs::path& target, const fs::path& path, bool replace, const FolderTest& ours) {
  std::error_code failure;
  const fs::file_status status = fs::status(target, failure);
  if (status.type() == fs::file_type::not_found) return false;
  if (!fs::is_directory(status)) fail_on_folder(ENOTDIR, "create", path);
  if (!replace) fail_on_folder(EEXIST, "create", path);
  if (!ours(target)) fail_on_folder(ENOTEMPTY, "replace", path);
  return true;
}

void sync_one(const fs::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | flags);
  if (descriptor < 0) fail_on_folder(errno, "complete", path);
  int error = 0;
  while ((error = ::fsync(descriptor) == 0 ? 0 : errno) == EINTR) continue;
  ::close(descriptor);
  if (error != 0 && error != EINVAL && error != ENOTSUP) fail_on_folder(error, "complete", path);
}

// File systems bring to the disk together what is asked for at the same time, which takes as long as one file.
void sync_together(const std::vector<fs::path>& files) {
  constexpr std::size_t max_threads = 16;
  constexpr std::size_t files_worth_a_thread = 4;
  const std::size_t count = std::clamp<std::size_t>(files.size() / files_worth_a_thread, 1, max_threads);
  std::vector<std::future<void>> workers;
  for (std::size_t worker = 0; worker < count; ++worker)
    workers.push_back(std::async(std::launch::async, [&files, worker, count] {
      for (std::size_t i = worker; i < files.size(); i += count) sync_one(files[i], 0);
    }));
  for (std::future<void>& done : workers) done.wait();
  for (std::future<void>& done : workers) done.get();
}

}  // namespace

OutputFolder::OutputFolder(fs::path path, bool replace, FolderTest ours)
    : path_(plain_name(path)), replace_(replace), ours_(std::move(ours)) {
  constexpr int max_attempts = 1000;  // A killed process of the same number may have left some names behind.
  if (path_.empty()) fail_on_folder(ENOENT, "create", path_);
  const fs::path target = end_of_links(path_);
  expect_replaceable(target, path_, replace_, ours_);
  for (int i = 0; i < max_attempts; ++i) {
    working_path_ = temporary_name(target);
    temporary_ = TemporaryName(working_path_);
    std::error_code failure;
    if (fs::create_directory(working_path_, failure)) return;
    if (!failure || failure == std::errc::file_exists) continue;
    temporary_.forget();
    working_path_.clear();
    fail_on_folder(failure.value(), "create", path_);
  }
  working_path_.clear();
  fail_on_folder(EEXIST, "create", path_);
}

OutputFolder::~OutputFolder() {
  if (!working_path_.empty()) remove_folder(working_path_);
}

void OutputFolder::commit() {
  sync_folder(working_path_);
  publish_folder(working_path_, path_, replace_, ours_);
  temporary_.forget();
  working_path_.clear();
}

void sync_folder(const fs::path& folder) {
  std::vector<fs::path> files;
  std::vector<fs::path> folders{folder};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    (fs::is_directory(entry.symlink_status()) ? folders : files).push_back(entry.path());
  sync_together(files);
  for (const fs::path& inner : folders) sync_one(inner, O_DIRECTORY);
}

void publish_folder(const fs::path& complete, const fs::path& output, bool replace, const FolderTest& ours) {
  const fs::path name = plain_name(output);
  const fs::path target = end_of_links(name);
  const auto rename = [&](const fs::path& from, const fs::path& to, unsigned flags) {
    return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags) == 0 ? 0 : errno;
  };
  if (!expect_replaceable(target, name, replace, ours)) {
    // A folder takes the place of an empty folder only, and never that of a file, where this flag is not known.
    int error = rename(complete, target, RENAME_NOREPLACE);
    if (error == ENOSYS || error == EINVAL) error = rename(complete, target, 0);
    if (error != 0) fail_on_folder(error, "complete", name);
    sync_folder_of(target);
    return;
  }
  fs::path old = complete;
  int error = rename(complete, target, RENAME_EXCHANGE);
  if (error == ENOSYS || error == EINVAL) {
    old = temporary_name(target);
    error = rename(target, old, 0);
    if (error == 0 && (error = rename(complete, target, 0)) != 0) rename(old, target, 0);
  }
  if (error != 0) fail_on_folder(error, "complete", name);
  sync_folder_of(target);
  remove_folder(old);
}

}  // namespace sarsim::core

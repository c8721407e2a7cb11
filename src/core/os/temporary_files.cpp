#include "core/os/temporary_files.hpp"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

namespace sarsim::core {

struct TemporaryNames {
  static constexpr std::size_t most = 256;
  std::array<std::atomic<std::string*>, most> slots{};
};

namespace {

// A signal handler reaches nothing but global state, and may use lock-free atomics only.
constinit TemporaryNames own_names;
constinit std::atomic<TemporaryNames*> names_in_use{&own_names};
static_assert(std::atomic<std::string*>::is_always_lock_free && std::atomic<TemporaryNames*>::is_always_lock_free,
              "a signal handler may use lock-free atomics only");

// As the system lays out the entries of a folder: name and kind follow the size of the entry.
constexpr std::size_t entry_size_at = 16;
constexpr std::size_t entry_name_at = 19;
constexpr int deepest_folder = 8;

void remove_entry(int folder, const char* name, int depth) noexcept;

// Only with calls that a signal handler may make. Entries are removed while they are listed, which may hide others from
// the list, so it is read until nothing is left of what can be removed.
void empty_folder(int folder, int depth) noexcept {
  alignas(8) std::array<char, 4096> entries;
  for (bool any = true; any;) {
    any = false;
    ::lseek(folder, 0, SEEK_SET);
    for (long got = 0; (got = ::syscall(SYS_getdents64, folder, entries.data(), entries.size())) > 0;)
      for (long at = 0; at < got;) {
        const char* const entry = entries.data() + at;
        unsigned short size = 0;
        std::memcpy(&size, entry + entry_size_at, sizeof size);
        at += size;
        const char* const name = entry + entry_name_at;
        if (std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0) continue;
        remove_entry(folder, name, depth);
        any = any || ::faccessat(folder, name, F_OK, AT_SYMLINK_NOFOLLOW) != 0;
      }
  }
}

void remove_entry(int folder, const char* name, int depth) noexcept {
  if (::unlinkat(folder, name, 0) == 0 || (errno != EISDIR && errno != EPERM) || depth == 0) return;
  const int inner = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (inner < 0) return;
  empty_folder(inner, depth - 1);
  ::close(inner);
  ::unlinkat(folder, name, AT_REMOVEDIR);
}

}  // namespace

TemporaryNames& temporary_names() noexcept { return *names_in_use.load(); }

void use_temporary_names(TemporaryNames& list) noexcept { names_in_use.store(&list); }

TemporaryName::TemporaryName(const std::filesystem::path& path) : name_(new std::string(path.string())) {
  for (std::atomic<std::string*>& slot : temporary_names().slots) {
    std::string* empty = nullptr;
    if (!slot.compare_exchange_strong(empty, name_)) continue;
    slot_ = &slot;
    return;
  }
  // More files at a time than slots: this one would stay behind.
}

TemporaryName::TemporaryName(TemporaryName&& other) noexcept
    : name_(std::exchange(other.name_, nullptr)), slot_(other.slot_) {}

TemporaryName& TemporaryName::operator=(TemporaryName&& other) noexcept {
  if (this == &other) return *this;
  forget();
  name_ = std::exchange(other.name_, nullptr);
  slot_ = other.slot_;
  return *this;
}

void TemporaryName::forget() noexcept {
  if (name_ == nullptr) return;
  std::string* own = std::exchange(name_, nullptr);
  // A handler that has taken the name may be reading it: it is left to the end of the process.
  if (slot_ != nullptr && !slot_->compare_exchange_strong(own, nullptr)) return;
  delete own;
}

void remove_folder(const std::filesystem::path& folder) noexcept {
  remove_entry(AT_FDCWD, folder.c_str(), deepest_folder);
}

void remove_temporary_files() noexcept {
  for (std::atomic<std::string*>& slot : temporary_names().slots)
    if (const std::string* name = slot.exchange(nullptr); name != nullptr)
      remove_entry(AT_FDCWD, name->c_str(), deepest_folder);
}

}  // namespace sarsim::core

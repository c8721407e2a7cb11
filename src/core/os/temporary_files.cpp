#include "core/os/temporary_files.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
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

void remove_temporary_files() noexcept {
  for (std::atomic<std::string*>& slot : temporary_names().slots)
    if (const std::string* name = slot.exchange(nullptr); name != nullptr) ::unlink(name->c_str());
}

}  // namespace sarsim::core

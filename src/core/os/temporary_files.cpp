#include "core/os/temporary_files.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <utility>

namespace sarsim::core {

namespace {

// A signal handler reaches nothing but global state, and may use lock-free atomics only.
constexpr std::size_t most_names = 256;
std::array<std::atomic<std::string*>, most_names> names{};
static_assert(std::atomic<std::string*>::is_always_lock_free, "a signal handler may use lock-free atomics only");

}  // namespace

TemporaryName::TemporaryName(const std::filesystem::path& path) : name_(new std::string(path.string())) {
  for (slot_ = 0; slot_ < most_names; ++slot_) {
    std::string* empty = nullptr;
    if (names[slot_].compare_exchange_strong(empty, name_)) return;
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
  if (slot_ < most_names && !names[slot_].compare_exchange_strong(own, nullptr)) return;
  delete own;
}

void remove_temporary_files() noexcept {
  for (std::atomic<std::string*>& slot : names)
    if (const std::string* name = slot.exchange(nullptr); name != nullptr) ::unlink(name->c_str());
}

}  // namespace sarsim::core

#pragma once

#include <atomic>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

namespace sarsim::scene {

/// What `Shared` holds where nothing else is said.
template <class Value>
Value empty_value() {
  return Value{};
}

/// Whether nobody can tell two values apart: 0 and -0, which are equal, are not identical. Values that are more than
/// plain numbers need a function of their own where they hold numbers.
template <class Value>
bool identical(const Value& a, const Value& b) {
  if constexpr (std::is_trivially_copyable_v<Value>)
    return std::memcmp(&a, &b, sizeof a) == 0;
  else
    return a == b;
}

/// A value that copies share until one of them is changed; takes as little room as a pointer, for objects of which
/// there may be millions with the same value. Equal where the values are equal. Copies may be used by several threads,
/// each by one at a time.
/// @tparam initial  the value of a new one, which takes no further memory
template <class Value, Value (*initial)() = empty_value<Value>>
class Shared {
 public:
  Shared() = default;
  Shared(Value value) : held_(new Held{std::move(value)}) {}
  Shared(const char* text) requires std::same_as<Value, std::string> : Shared(std::string(text)) {}
  Shared(const Shared& other) noexcept : held_(other.held_) {
    if (held_ != nullptr) held_->users.fetch_add(1, std::memory_order_relaxed);
  }
  Shared(Shared&& other) noexcept : held_(std::exchange(other.held_, nullptr)) {}
  Shared& operator=(Shared other) noexcept {
    std::swap(held_, other.held_);
    return *this;
  }
  ~Shared() {
    if (held_ != nullptr && held_->users.fetch_sub(1, std::memory_order_acq_rel) == 1) delete held_;
  }

  const Value& operator*() const { return held_ != nullptr ? held_->value : initial_value(); }
  const Value* operator->() const { return &**this; }

  /// The value, to be changed: the copies keep theirs.
  Value& edit() {
    if (held_ == nullptr || held_->users.load(std::memory_order_acquire) != 1) *this = Shared(**this);
    return held_->value;
  }

  /// Takes the value of another, or the initial one, in place of its own where they are identical.
  void share(const Shared& other) {
    if (held_ == other.held_ || held_ == nullptr) return;
    if (identical(held_->value, initial_value()))
      *this = Shared();
    else if (identical(held_->value, *other))
      *this = other;
  }

  friend bool operator==(const Shared& a, const Shared& b) { return a.held_ == b.held_ || *a == *b; }

 private:
  struct Held {
    Value value;
    std::atomic<std::size_t> users = 1;
  };

  static const Value& initial_value() {
    static const Value made = initial();
    return made;
  }

  Held* held_ = nullptr;
};

/// Whether a type is a `Shared`.
template <class Type>
inline constexpr bool is_shared = false;
template <class Value, Value (*initial)()>
inline constexpr bool is_shared<Shared<Value, initial>> = true;

}  // namespace sarsim::scene

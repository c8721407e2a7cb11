#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "scene/model/object.hpp"

namespace sarsim::scene {

/// An object as a step of editing remembers it, or none. Takes no more memory than its kind needs (AnyObject has room
/// for the largest) and is shared by copies: histories hold millions. Cannot be changed, only replaced.
class SharedObject {
 public:
  SharedObject() = default;
  SharedObject(std::nullopt_t) {}
  /// Keeps an object.
  SharedObject(AnyObject object) {
    std::visit([this](auto& any) { keep(std::move(any)); }, object);
  }
  template <class Object>
  requires std::constructible_from<AnyObject, Object> &&
      (!std::same_as<std::remove_cvref_t<Object>, AnyObject>)SharedObject(Object&& object) {
    keep(std::remove_cvref_t<Object>(std::forward<Object>(object)));
  }

  [[nodiscard]] bool has_value() const { return kept_.index() != 0; }
  explicit operator bool() const { return has_value(); }

  /// The object, or null where there is none or one of another kind.
  template <class Object>
  [[nodiscard]] const Object* get_if() const {
    const auto* const kept = std::get_if<std::shared_ptr<const Object>>(&kept_);
    return kept != nullptr ? kept->get() : nullptr;
  }

  /// Calls `function` with the object as its own type; std::logic_error where there is none.
  template <class Function>
  decltype(auto) visit(Function&& function) const {
    using Result = decltype(function(std::declval<const Platform&>()));
    return std::visit(
        [&](const auto& kept) -> Result {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(kept)>, std::monostate>)
            throw std::logic_error("there is no object");
          else
            return function(*kept);
        },
        kept_);
  }

  /// The object by value; std::logic_error where there is none.
  [[nodiscard]] AnyObject operator*() const {
    return visit([](const auto& object) { return AnyObject(object); });
  }

  friend bool operator==(const SharedObject& a, const SharedObject& b) {
    return std::visit(
        []<class A, class B>(const A& first, const B& second) {
          if constexpr (!std::is_same_v<A, B>)
            return false;
          else if constexpr (std::is_same_v<A, std::monostate>)
            return true;
          else
            return *first == *second;
        },
        a.kept_, b.kept_);
  }

 private:
  template <class Object>
  void keep(Object object) {
    kept_ = std::make_shared<const Object>(std::move(object));
  }

  decltype(detail::kept_of_kinds(kinds)) kept_;
};

}  // namespace sarsim::scene

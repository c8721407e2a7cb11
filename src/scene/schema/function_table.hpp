#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "scene/model/object.hpp"
#include "scene/schema/field_spec.hpp"

/// What the editor of user-defined functions knows of each. Internal to function_model.
namespace sarsim::scene::function_tables {

/// What the editor knows of one function besides its block of the script language.
struct FunctionKind {
  std::string_view title;  ///< "Trajectory"; the object's name follows.
  const FunctionBlock& block;
  std::string_view x_name;
  std::array<std::string_view, 3> part_names;
  Quantity x_quantity = Quantity::number;
  Quantity y_quantity = Quantity::number;
  std::array<double, 2> x_range{};
  std::array<double, 2> y_range{};
  std::array<double, 2> x_limits{};
  std::array<double, 2> y_limits{};
};

/// The function of a field; std::invalid_argument where the object has no such function.
[[nodiscard]] const FunctionKind& function_kind(const AnyObject& object, std::string_view field);

/// The unit of y in a scene, where the script's may be another.
[[nodiscard]] std::string_view y_unit(const FunctionKind& kind, std::size_t part);

/// A function inside an object; std::invalid_argument where the object has no such function.
[[nodiscard]] FunctionRef function_in(AnyObject& object, std::string_view field);
[[nodiscard]] ConstFunctionRef function_in(const AnyObject& object, std::string_view field);

}  // namespace sarsim::scene::function_tables

#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "scene/schema/unit_dimension.hpp"

/// The functions and constants of expressions.
namespace sarsim::scene {

/// A function, as data.
struct Function {
  /// What its arguments measure, and what its value does.
  enum class Rule {
    of_angle,  ///< One angle, or a pure number, which is in radians; the value is a pure number.
    to_angle,  ///< Of arguments of one kind; the value is an angle.
    root,      ///< Of one argument; the value has half of its powers.
    like,      ///< Of arguments of one kind; the value is of that kind.
    pure,      ///< Of a pure number, whose value is one as well.
    pure_to_angle,
  };

  std::string_view name;
  Rule rule;
  std::size_t least;  ///< Number of arguments.
  std::size_t most;
  double (*apply)(double a, double b);  ///< Of one argument, or of the value of all before and the next; angles in deg.
  double (*of_radians)(double a);       ///< Of a pure number, for `of_angle`.
  std::string_view domain;              ///< For which arguments there is a value: "an argument of 0 or more".
};

/// A number with a name.
struct Constant {
  std::string_view name;
  double value;
  Dimension dimension;
};

/// All that expressions may use, in the order of their names in messages.
[[nodiscard]] std::span<const Function> functions();
/// The same.
[[nodiscard]] std::span<const Constant> constants();
/// Null where there is none of that name.
[[nodiscard]] const Function* function_named(std::string_view name);
/// The same.
[[nodiscard]] const Constant* constant_named(std::string_view name);

}  // namespace sarsim::scene

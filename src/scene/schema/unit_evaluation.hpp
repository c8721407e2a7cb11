#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "scene/schema/expression.hpp"

/// Reading and computing of expressions; their grammar and rules are in expression.hpp.
namespace sarsim::scene {

/// The value of an expression, or why it has none.
struct Evaluated {
  std::optional<Measured> measured;
  ExpressionFault fault;  ///< Where there is no value.
  std::size_t begin = 0;  ///< Bytes of the text that are not blank at its ends.
  std::size_t end = 0;
  bool literal = false;  ///< One number, alone or with units.
  std::string hint;      ///< What to write instead where the dimension is not the wanted one; may be empty.
};

/// Evaluates an expression, whatever it measures.
[[nodiscard]] Evaluated evaluated(std::string_view text, const LetNames& names);

}  // namespace sarsim::scene

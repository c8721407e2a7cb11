#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/schema/function_block.hpp"
#include "scene/schema/quantity.hpp"
#include "scene/schema/table_text.hpp"

/// Columns of the tables of functions by the names that a line of names gives them.
namespace sarsim::scene {

/// The quantity of an axis; numbers in tables are in its base unit unless a heading names another.
[[nodiscard]] Quantity quantity_of(const FunctionAxis& axis);

/// Which of the axes of a block the columns of a table may be, in the order without names: 0 is x, 1 the first value.
/// Two columns of an antenna are x and a gain that both cuts have, two of a pulse I and Q, or x and I.
[[nodiscard]] std::vector<std::size_t> usual_columns(const FunctionBlock& block, std::size_t columns);

/// What names say of the columns of a table.
struct NamedColumns {
  std::vector<std::size_t> places;  ///< Of each column, where it would be without names.
  std::vector<std::string> units;   ///< Of each column, in brackets or behind the name ("t_ms"); "" for none.
  std::optional<bool> pulse_has_x;  ///< Of two columns of a pulse: whether the first is x; nothing where no name tells.
  /// Why the names do not suit.
  struct Fault {
    std::string message, found, expected, hint;
  };
  std::optional<Fault> fault;
};

/// Puts the columns of a table into the order of their names. Names that mean nothing here leave the columns where they
/// are; one that means something else, two of one meaning, or some known ones in other places beside unknown ones are a
/// fault, because nothing tells then what the numbers are.
/// @param usual  as `usual_columns`
[[nodiscard]] NamedColumns named_columns(const FunctionBlock& block, const std::vector<ColumnHeading>& headings,
                                         const std::vector<std::size_t>& usual);

}  // namespace sarsim::scene

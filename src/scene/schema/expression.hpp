#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/quantity.hpp"
#include "scene/schema/unit_dimension.hpp"

/// Values written as expressions with units: "100 MHz", "15 km * sin(azimuth)".
///
///   sum      = product {("+" | "-") product}          product = signed {("*" | "/") signed}
///   signed   = ("+" | "-") signed | raised            raised  = factor ["^" signed]
///   factor   = number [unit ["^" signed]] | unit | name | "pi" | "c" | function "(" sum {"," sum} ")" | "(" sum ")"
///
/// A unit directly behind a number binds closest: "15 km / 2 s" divides by two seconds. Functions: sqrt sin cos tan
/// asin acos atan atan2 abs min max log10. Levels (dBm, dBW, dBsm) stand directly behind a number, whose sign is
/// theirs:
/// "-30 dBm" is 1e-6 W.
namespace sarsim::scene {

/// Why an expression has no value.
struct ExpressionFault {
  std::size_t begin = 0;  ///< What is to blame: bytes `begin` to below `end` of the text as it was given.
  std::size_t end = 0;
  std::string message;
  std::string expected = {};  ///< What would have been right; may be empty.
  std::string hint = {};      ///< How to mend it; may be empty.
  bool follows = false;       ///< Only because a name of [let] has no value, which `LetNames::resolve` has reported.
};

/// The value of an expression in the units in which quantities are held: m, s, deg, K, W, V, dB and their products.
struct Measured {
  double value = 0.0;
  Dimension dimension;
};

/// What is wrong with one entry of [let].
struct NameFault {
  std::string name;
  bool of_name = false;  ///< The name itself is refused, and the range is one of it; otherwise of the expression.
  ExpressionFault fault;
};

/// The names of [let] and their values.
class LetNames {
 public:
  /// Gives a name a number or an expression, which may use other names, whatever their order. A name that is defined
  /// again has its last value only. Values of expressions, and faults, are there after `resolve`.
  void define(std::string name, double value);
  void define(std::string name, const Measured& value);
  void define(std::string name, std::string expression);

  /// Computes all values; takes time in proportion to the length of all expressions.
  /// @return what is wrong, in the order of the definitions: names that are no identifiers (letters, digits
  ///         and underscores) or are units, constants or functions, expressions without a value, names that depend on
  ///         themselves. A name whose expression uses one without a value has none either, and no fault of its own
  [[nodiscard]] std::vector<NameFault> resolve();

  /// The value of a name; null where it is not defined or has none.
  [[nodiscard]] const Measured* find(std::string_view name) const;
  /// Whether there is such a name, with a value or without.
  [[nodiscard]] bool contains(std::string_view name) const { return places_.contains(name); }
  /// All names that may be used, in alphabetical order; views of this object.
  [[nodiscard]] std::vector<std::string_view> all() const;

 private:
  struct Entry {
    std::string name;
    std::string expression;
    bool computed = false;  // from the expression
    std::optional<Measured> value;
    std::optional<ExpressionFault> fault;
    bool of_name = false;
  };

  void add(Entry entry);
  void compute(Entry& entry) const;
  void resolve_from(std::size_t first, std::vector<std::size_t>& positions);

  std::vector<Entry> entries_;
  std::map<std::string, std::size_t, std::less<>> places_;  // of names that are not refused
};

/// The value of a text for a field, or why there is none.
struct QuantityResult {
  std::optional<double> value;  ///< In the unit in which the quantity is held.
  std::optional<ExpressionFault> fault;
  bool literal = false;  ///< One number, alone or with units ("240 m/s"): no name, no function, no operation.
  bool bare = false;     ///< A number without a unit, which counts in the base unit.
  std::optional<Measured> other = {};  ///< The value, if its dimension is not that of the field.
};

/// Evaluates the text of a field. One number with one unit is read exactly as `read_quantity` reads it, larger
/// expressions by the arithmetic of doubles. A pure number counts in the base unit of the quantity; any other
/// dimension than the quantity's is a fault, and so is a value that is not finite or, of a count, not whole.
/// Parentheses may be nested 100 deep. Takes time in proportion to the length.
/// @param names  resolved
[[nodiscard]] QuantityResult evaluate(std::string_view text, Quantity quantity, const LetNames& names);

/// The text with the most readable unit, as `quantity_text`, that `evaluate` and `read_quantity` turn back into exactly
/// `value`, the sign of a zero included.
/// @param value  finite, and whole for a count
[[nodiscard]] std::string exact_quantity_text(double value, Quantity quantity);

}  // namespace sarsim::scene

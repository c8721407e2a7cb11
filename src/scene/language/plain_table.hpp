#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/field_spec.hpp"

/// The tables of fields without the types of their objects, and with what format 2 has beside them: what the
/// explanations, the schema and the reference page of format 2 are made from.
namespace sarsim::scene::language {

/// One field.
struct PlainField {
  FieldSpec spec;                          ///< `when.field` is a position in `PlainTable::fields`.
  std::optional<FieldValue> initial = {};  ///< Nothing: a function, or a field that has no default.
  std::string shorthand = {};  ///< Of a choice: key of the field whose value may stand for that of the choice.
  std::vector<std::string> labels = {};     ///< In the forms of the workbench.
  std::vector<std::string> set_names = {};  ///< For `--set`: "Radar1.pulse_width".
  std::string_view command = {};            ///< Of the 1998 language, without `$`.
  std::string_view in_script = {};          ///< What the 1998 language says instead, where it has no such field.
};

/// The fields of one kind of object, or of [options].
struct PlainTable {
  std::string_view header;   ///< In format 2: "recording".
  std::string_view meaning;  ///< In a sentence.
  std::string_view command;  ///< Of the 1998 language, without `$`.
  bool is_list = true;       ///< There may be many; of [options] there is one.
  std::vector<PlainField> fields;
  bool is_entry = false;  ///< An entry of a list: the word of a choice stands behind its key, without `type`.

  /// "[[radar]]", "[options]".
  [[nodiscard]] std::string header_line() const;
};

/// The first value of an alternative that the table of fields has elsewhere or not at all. Such an alternative is
/// written as its word alone, unless fields depend on it.
inline constexpr int first_added_value = 100;

/// All tables, in the order in which people see the kinds; targets hold what a cloud of points has.
[[nodiscard]] const std::vector<PlainTable>& plain_tables();

/// The fields of the elements of a list.
[[nodiscard]] const PlainTable& element_table(ListKind kind);

/// The table of a header; null where there is none.
[[nodiscard]] const PlainTable* plain_table(std::string_view header);

}  // namespace sarsim::scene::language

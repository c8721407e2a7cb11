#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/toml/document.hpp"
#include "scene/edit/text_change.hpp"
#include "scene/language/scene_writer.hpp"

/// Single values of a text of format 2, changed so that as much as possible stays as it was typed.
namespace sarsim::scene::format_2 {

/// Of several things that the writer says, that of one key; null where there is none.
[[nodiscard]] const Said* find_typed(const std::vector<Said>& said, std::string_view key);

/// Whether two say the same; null says nothing.
[[nodiscard]] bool says_same(const Said* a, const Said* b);

/// Whether what is typed for the key `type` of a table is what the writer would say before the change. Where it is not
/// ("line" for a path of two points), the keys of the table are not the writer's.
/// @param typed  a string with its quotes
[[nodiscard]] bool is_type_of(std::string_view typed, const Said* before);

/// A value that was typed, once it says something else. Of inline tables and arrays only the inner values that differ
/// are replaced, where they can be told apart.
/// @param typed   with its quotes or brackets
/// @param before  what the writer says of what is typed; may be null
[[nodiscard]] std::string value_after(std::string_view typed, const Said* before, const Said& after);

/// What becomes of one row of an array.
struct RowChange {
  bool removed = false;
  std::optional<std::string> text = {};  ///< Its new text; nothing: as it was typed.
};

/// The changes of an array's rows, in the text that holds it. At least one row must stay. A row that is removed takes
/// its comma along and, where it has its lines for itself, these with the comments beside and directly above it.
/// @param rows  one for each row of the array
[[nodiscard]] TextChanges change_rows(std::string_view text, const core::toml::Value& array,
                                      const std::vector<RowChange>& rows);

/// A change that puts a text in place of a stretch, without what both begin and end with.
void replace_stretch(TextChanges& changes, std::string_view text, core::toml::Span at, std::string_view with);

}  // namespace sarsim::scene::format_2

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/toml/document.hpp"
#include "scene/edit/splice_places.hpp"
#include "scene/edit/text_change.hpp"
#include "scene/language/object_text.hpp"
#include "scene/language/scene_writer.hpp"

/// Where the objects of a text of format 2 stand, and how the text of one of them is changed.
namespace sarsim::scene::format_2 {

/// The tables that make an object, or several: those of a list of positions.
struct ObjectTable {
  std::size_t first = 0;                            ///< In `Document::tables`.
  std::size_t last = 0;                             ///< Behind those below it.
  std::optional<core::toml::Value> positions = {};  ///< The array of a list.
  core::toml::Span positions_key = {};
  std::size_t objects = 1;    ///< Its rows.
  std::size_t preceding = 0;  ///< Objects of its kind that stand before it in the text.
};

/// A text of format 2 with the objects that itself holds; those of included files come before them in a scene.
struct ObjectTables {
  core::toml::Document document;
  std::array<std::vector<ObjectTable>, kind_count> of;  ///< In the order of the text.
  std::optional<ObjectTable> options;
  std::optional<ObjectTable> world;
  std::optional<ObjectTable> atmosphere;

  [[nodiscard]] const std::vector<ObjectTable>& operator[](ObjectKind kind) const {
    return of[static_cast<std::size_t>(kind)];
  }
};

/// Takes a text apart, in time linear in it.
[[nodiscard]] ObjectTables find_tables(std::string_view text);

/// Where they stand after changes within values that leave keys, tables and the number of rows as they were. Quick
/// where taking the text apart again is not.
/// @param changes  in the order of the text
[[nodiscard]] ObjectTables after_changes(ObjectTables tables, const TextChanges& changes);

/// The table of an object; null where the text has none.
/// @param index  among the objects of its kind in the text
[[nodiscard]] const ObjectTable* table_with(const ObjectTables& tables, ObjectKind kind, std::size_t index);

/// The values of an array.
[[nodiscard]] std::vector<core::toml::Value> rows_of(std::string_view text, const core::toml::Value& array);

/// From the header of an object to behind the last line of its tables, comment lines directly below it included.
[[nodiscard]] TextStretch stretch_of(std::string_view text, const ObjectTables& tables, const ObjectTable& table);

/// Where the comment lines directly above the header of an object begin, or its line.
[[nodiscard]] std::size_t lead_of(std::string_view text, const ObjectTables& tables, const ObjectTable& table);

/// The changes that make an object's tables say something else. Keys whose value the writer would write alike before
/// and after stay as they are, the others are changed where they stand: a value is replaced, a key at its default again
/// goes with its line, a new one comes behind the last of its table. A table that has its keys in lines of their own
/// and cannot keep them is replaced as a whole.
/// @param header  the path of the object's tables: "radar"
[[nodiscard]] TextChanges change_tables(std::string_view text, const ObjectTables& tables, const ObjectTable& table,
                                        const std::string& header, const std::vector<Said>& before,
                                        const std::vector<Said>& after);

/// Whether a table would have no keys left.
[[nodiscard]] bool would_be_empty(std::string_view text, const ObjectTables& tables, const ObjectTable& table,
                                  const std::vector<Said>& before, const std::vector<Said>& after);

/// The text with the line ends of another one.
[[nodiscard]] std::string with_ends_of(std::string_view text, std::string lines);

}  // namespace sarsim::scene::format_2

namespace sarsim::scene {

/// Where the objects of a text of format 2 stand: from their header to the end of the last line below it; the row of an
/// object in a list of positions. Objects of included files are not there.
[[nodiscard]] CommandPlaces find_objects(std::string_view text, const format_2::ObjectTables& tables);
/// The same after changes within values (format_2::after_changes).
[[nodiscard]] CommandPlaces after_changes(CommandPlaces places, const TextChanges& changes);

}  // namespace sarsim::scene

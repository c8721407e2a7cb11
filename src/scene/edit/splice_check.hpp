#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/edit/splice_tables.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::scene::format_2 {

/// A row of a list of positions.
struct ChangedRow {
  std::size_t object = 0;  ///< Among those that the table makes.
  TextStretch at;
};

/// Tables whose text an edit changes, and the objects that they then make.
struct ChangedTable {
  ObjectKind kind = ObjectKind::platform;
  const ObjectTable* table = nullptr;
  std::size_t first = 0;  ///< In the list of the scene after the edit.
  std::size_t count = 0;
  /// Where nothing but these rows is changed: of 100 000 one, for instance. Nothing: all of the table may be.
  std::optional<std::vector<ChangedRow>> rows = {};
};

/// Whether changed tables say what they should. Reads them alone, with the names and included files of the text: what a
/// change does within a table means nothing to the others.
/// @param changes  of the text, all within the changed tables
/// @param changed  by kind, then in the order of the scene
/// @param after    the scene after the edit
/// @param file     of the text
[[nodiscard]] bool tables_say(std::string_view text, const ObjectTables& tables, const TextChanges& changes,
                              const std::vector<ChangedTable>& changed, const Scene& after, const std::string& file,
                              const DataFileLoader& loader);

}  // namespace sarsim::scene::format_2

#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/edit/splice_tables.hpp"
#include "scene/model/scene.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::scene {

/// A file of format 2 that a scene includes.
struct IncludedText {
  std::string name;  ///< As a loader takes it.
  std::string text;
  format_2::ObjectTables tables;
};

/// How many objects of each kind.
using ObjectCounts = std::array<std::size_t, kind_count>;

/// All that a text of format 2 includes, in the order in which a scene adds up their objects; those of the text itself
/// come last. Nothing for a text in JSON, and files in JSON have no tables that could be changed.
/// @param file  of the text
[[nodiscard]] std::vector<IncludedText> included_texts(std::string_view text, const std::string& file,
                                                       const DataFileLoader& loader);

/// The objects that the tables of a text make.
[[nodiscard]] ObjectCounts counts_of(const format_2::ObjectTables& tables);

/// Finds some texts by their names, and everything else as before.
[[nodiscard]] DataFileLoader with_texts(DataFileLoader loader, std::map<std::string, std::string> texts);

}  // namespace sarsim::scene

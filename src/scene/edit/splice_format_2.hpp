#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/edit/edit.hpp"
#include "scene/edit/included_texts.hpp"
#include "scene/edit/splice_tables.hpp"
#include "scene/edit/text_change.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::scene {

/// An edit carried over into a text of format 2.
struct Format2Splice {
  TextChanges changes;
  std::string text;                                  ///< After the changes.
  std::map<std::string, TextChanges> included = {};  ///< Of files that the text includes, by their names.
  bool rows_alone = false;  ///< Only rows of lists are others: `after_changes` tells where everything stands.
};

/// What an edit of a scene does to its text of format 2: changes the values that differ where they stand and leaves
/// every other byte as it was typed.
///
/// Of a changed object only the keys that the writer would write otherwise are touched (splice_tables.hpp); an
/// expression that is overwritten becomes the number. A field that was typed into (`Edit::typed`) is written as it was
/// typed, or goes with its line. With a removed object go the comment lines directly above its
/// header. A new one comes behind the object before it in its list, or at the end of the text, before [options]. Of
/// targets in a list of positions one that only moves has its row replaced; where others of its values change, the
/// table is split. An object of an included file is changed in that file; new ones come into the text itself. The new
/// text is read again: where it does not say what it should the changed objects, and if need be the whole text, are
/// written anew.
///
/// @param tables    of the text
/// @param included  what the text includes
/// @param before    the scene that the text says
/// @param file      of the text, for the files that it includes
/// @throws std::logic_error where the edit does not fit the scene
[[nodiscard]] Format2Splice splice_format_2(std::string_view text, const format_2::ObjectTables& tables,
                                            const std::vector<IncludedText>& included, const Scene& before,
                                            const Edit& edit, const std::string& file, const DataFileLoader& loader);

}  // namespace sarsim::scene

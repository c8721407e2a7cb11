#pragma once

#include <string>
#include <string_view>

#include "scene/edit/edit.hpp"
#include "scene/edit/text_change.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::scene {

/// An edit carried over into a text of format 2.
struct Format2Splice {
  TextChanges changes;
  std::string text;  ///< After the changes.
};

/// What an edit of a scene does to its text of format 2: changes the values that differ where they stand and leaves
/// every other byte as it was typed.
///
/// Of a changed object only the keys that the writer would write otherwise are touched (splice_tables.hpp); an
/// expression that is overwritten becomes the number. With a removed object go the comment lines directly above its
/// header. A new one comes behind the object before it in its list, or at the end of the text, before [options]. Of
/// targets in a list of positions one that only moves has its row replaced; where others of its values change, the
/// table is split. The new text is read again: where it does not say what it should (objects may stand in files that
/// the text includes) the changed objects, and if need be the whole text, are written anew.
///
/// @param before  the scene that the text says
/// @param file    of the text, for the files that it includes
/// @throws std::logic_error where the edit does not fit the scene
[[nodiscard]] Format2Splice splice_format_2(std::string_view text, const Scene& before, const Edit& edit,
                                            const std::string& file, const DataFileLoader& loader);

}  // namespace sarsim::scene

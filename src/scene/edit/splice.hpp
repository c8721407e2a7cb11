#pragma once

#include <string>
#include <string_view>

#include "scene/edit/edit.hpp"
#include "scene/edit/splice_places.hpp"
#include "scene/edit/text_change.hpp"
#include "scene/script/data_file.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::scene {

/// An edit carried over into the text of a script.
struct Splice {
  TextChanges changes;
  std::string text;      ///< After the changes.
  CommandPlaces places;  ///< Where the commands stand in it.
};

/// What an edit of a scene does to its script: changes the commands of the objects that it touches and leaves every
/// other byte as it was typed.
///
/// Of a changed command only the values that differ are replaced where its layout allows that (splice_command.hpp).
/// With a removed one go the comment lines directly above it. A new one comes behind the object before it in its list,
/// or where the writer would begin such a list. Several `$OPTIONS` become one. Takes time linear in the places and the
/// edit, plus copying the text and reading the touched commands.
///
/// @param places  of the text (`find_commands`)
/// @param loader  for functions whose data are in a file
/// @throws std::logic_error where the edit does not fit the places
[[nodiscard]] Splice splice(std::string_view text, const CommandPlaces& places, const Edit& edit,
                            const DataFileLoader& loader);

/// The edit with its new objects and options as a text says them (`as_script_says`); in place.
void settle_values(Edit& edit, const DataFileLoader& loader, Language language = Language::script);

}  // namespace sarsim::scene

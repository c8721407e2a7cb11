#pragma once

#include "scene/model/object.hpp"
#include "scene/script/data_file.hpp"
#include "scene/script/reader.hpp"

/// What of an object's values a script can say, from the table of fields alone.
namespace sarsim::scene {

/// Replaces the bytes of names and file names that no text holds by '_': line ends and other controls; in format 2 also
/// tabs and what is not UTF-8.
void make_names_sayable(AnyObject& object, Language language = Language::script);

/// What a script makes of an object: the object itself, as a rule, without what cannot be said in a script: members
/// that its choices make meaningless, control characters in names, the sign of a zero. Functions with a data file have
/// the points of that file. What only format 2 can say is left out where the text is a script. An object that cannot be
/// written without errors keeps all but the control characters.
[[nodiscard]] AnyObject as_script_says(const AnyObject& object, const DataFileLoader& loader,
                                       Language language = Language::script);
[[nodiscard]] RunOptions as_script_says(const RunOptions& options);

}  // namespace sarsim::scene

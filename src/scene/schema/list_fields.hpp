#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/fields.hpp"

/// Lists of an object as forms show them: legs, waypoints, oscillations. Each entry is a row, each field that an entry
/// can have a column. All functions throw std::invalid_argument for a field that is not a list of the object, and
/// std::out_of_range for an entry that the list does not have.
namespace sarsim::scene {

/// The fields of an entry.
[[nodiscard]] const std::vector<Field>& entry_fields(const Field& list);

/// How many entries a list has.
[[nodiscard]] std::size_t entry_count(const AnyObject& object, const Field& list);

/// The value of a field of an entry, as `field_text` has it; nothing where the field means nothing for the entry: the
/// bank of a straight leg.
[[nodiscard]] std::optional<std::string> entry_text(const AnyObject& object, const Field& list, std::size_t entry,
                                                    std::string_view id);

/// Sets a field of an entry from what was typed, as `set_field` does.
/// @returns empty, or why not, in words; the object is then unchanged
[[nodiscard]] std::string set_entry(AnyObject& object, const Field& list, std::size_t entry, std::string_view id,
                                    std::string_view text, const LetNames* names = nullptr);

/// Puts in an entry that makes sense where it stands: a waypoint half way between its neighbours or straight on behind
/// the last one, 1 km of straight leg, an oscillation of 0.1 m at 1 Hz.
/// @param at  its position, up to the number of entries
void add_entry(AnyObject& object, const Field& list, std::size_t at);

/// Takes an entry out.
void remove_entry(AnyObject& object, const Field& list, std::size_t entry);

/// Takes an entry out and puts it in again so that it has the position `to`.
void move_entry(AnyObject& object, const Field& list, std::size_t entry, std::size_t to);

}  // namespace sarsim::scene

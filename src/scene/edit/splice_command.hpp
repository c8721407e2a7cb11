#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/edit/splice_places.hpp"
#include "scene/edit/text_change.hpp"
#include "scene/model/object.hpp"
#include "scene/script/reader.hpp"

/// Single commands of a script: writing, reading and changing them.
namespace sarsim::scene {

/// The command of an object in the writer's layout (scene/script/writer.hpp), without blank lines behind it. Bytes that
/// no script holds (line ends and other controls in names) are written as '_'; a number that is none is written as a
/// word that the reader refuses.
[[nodiscard]] std::string command_text(const AnyObject& object);
/// The same for options; empty where they have their initial values.
[[nodiscard]] std::string command_text(const RunOptions& options);

/// The scene that a text of one command gives.
[[nodiscard]] ScriptReading read_command_text(std::string_view command, const DataFileLoader& loader);

/// The only object of a scene without another, or nothing.
[[nodiscard]] std::optional<AnyObject> only_object(const Scene& scene);

/// One way to change a command: what to do to the text and how the command ends up.
///
/// @param text     the whole script
/// @param at       the command in it
/// @param before   the writer's text of what the command says
/// @param after    the writer's text of what it is to say
/// @param is_right whether a command text says that
/// @returns the changes, within `at`: single values where the command has the writer's order of values, else lines of
/// it where the layout allows that, else all of the command. Comments beside and between unchanged values stay in the
/// first two cases.
template <class IsRight>
[[nodiscard]] TextChanges change_command(std::string_view text, TextStretch at, std::string_view before,
                                         std::string_view after, IsRight is_right);

namespace detail {

[[nodiscard]] TextChanges change_values(std::string_view command, std::string_view before, std::string_view after);
[[nodiscard]] TextChanges change_lines(std::string_view command, std::string_view before, std::string_view after,
                                       std::string_view line_end);
[[nodiscard]] std::string with_line_ends(std::string_view text, std::string_view line_end);

}  // namespace detail

template <class IsRight>
TextChanges change_command(std::string_view text, TextStretch at, std::string_view before, std::string_view after,
                           IsRight is_right) {
  const std::string_view command = text.substr(at.begin, at.end - at.begin);
  const std::string_view line_end = line_end_of(text);
  // What is new may be in a data file.
  if (before == after && is_right(command)) return {};
  TextChanges changes = detail::change_values(command, before, after);
  if (changes.empty() || !is_right(apply_changes(command, changes)))
    changes = detail::change_lines(command, before, after, line_end);
  if (changes.empty() || !is_right(apply_changes(command, changes))) {
    std::string whole = detail::with_line_ends(after, line_end);
    const bool open_end = at.end == text.size() && !command.ends_with(line_end.back());
    if (open_end) whole.resize(whole.size() - line_end.size());
    changes = {{0, std::string(command), std::move(whole)}};
  }
  for (TextChange& change : changes) change.at += at.begin;
  return changes;
}

}  // namespace sarsim::scene

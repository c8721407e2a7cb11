#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sarsim::scene {

/// One stretch of a text put in place of another.
struct TextChange {
  std::size_t at = 0;  ///< Offset in the text before, in bytes.
  std::string before;
  std::string after;

  friend bool operator==(const TextChange&, const TextChange&) = default;
};

/// Changes of one text that are made together, ascending and without overlap; every `at` counts in the text before any
/// of them.
using TextChanges = std::vector<TextChange>;

/// The text after the changes; `revert_changes` takes it back. Takes time linear in the text.
/// @throws std::logic_error where the text is not the one that the changes were made for
[[nodiscard]] std::string apply_changes(std::string_view text, const TextChanges& changes);
[[nodiscard]] std::string revert_changes(std::string_view text, const TextChanges& changes);

/// What two sets of changes, one after the other, come to; stretches that touch become one, those that change nothing
/// are left out.
[[nodiscard]] TextChanges composed(const TextChanges& first, const TextChanges& second);

/// The change that leads from one text to another: what stands between their common beginning and their common end.
[[nodiscard]] TextChanges text_difference(std::string_view from, std::string_view to);

}  // namespace sarsim::scene

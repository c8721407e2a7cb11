#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/language/guide_headings.hpp"

/// Searches for words in the descriptions of fields and in the headings of the documentation.
namespace sarsim::scene::language {

/// Searchable texts of one field.
struct SearchText {
  std::string name;     ///< "radar.noise_temperature"
  std::string aliases;  ///< Synonyms and alternatives, separated by blanks.
  std::string meaning;
};

/// The texts in which every word of a search begins a word, best first: names before aliases before meanings; equals
/// keep their order.
/// @param search  words, separated by blanks, underscores or hyphens; ignoring case
[[nodiscard]] std::vector<std::size_t> best_matches(std::string_view search, const std::vector<SearchText>& texts);

/// The headings of the documentation in which every word of a search begins a word, in the order of the documentation.
[[nodiscard]] std::vector<GuideHeading> headings_with(std::string_view search);

}  // namespace sarsim::scene::language

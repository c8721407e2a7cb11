#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/toml/document.hpp"
#include "scene/model/scene.hpp"

/// What may be typed at a place of a text of format 2, all of it from the tables of fields.
namespace sarsim::scene::language {

/// A name of [let] with its value as typed.
struct LetText {
  std::string name;
  std::string value;
};

/// What a text can refer to.
struct KnownNames {
  std::vector<std::string> platforms;
  std::vector<std::string> radars;
  std::vector<LetText> let;
};

/// The names of a scene, and those of [let] of its text, which need not be valid.
[[nodiscard]] KnownNames known_names(const Scene& scene, std::string_view text);

/// One thing that may be typed.
struct Completion {
  std::string word;      ///< What is compared with what was typed: "radar".
  std::string shown;     ///< "[[radar]]".
  std::string inserted;  ///< In place of what stands there: "[[radar]]", "width = ".
  std::string meaning;   ///< In a few words.
};

/// All that may be typed at a place and begins like what stands there.
struct Completions {
  core::toml::Span replaced;  ///< Bytes of the text that give way.
  std::string typed;          ///< Those before the place.
  std::vector<Completion> offered;
  bool unasked = false;  ///< Worth showing to who has not asked: a choice has to be made, or a word has begun.
};

/// What may be typed at a place.
/// @param text    may begin with the header of the object around the place, and end behind it
/// @param offset  of the byte behind the place
[[nodiscard]] Completions completions_at(std::string_view text, std::size_t offset, const KnownNames& names);

}  // namespace sarsim::scene::language

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/script/reader.hpp"

namespace sarsim::scene {

/// A commented scene to begin with: complete in itself, and it says what to look at. Most are examples.
struct StartingScene {
  std::string_view purpose;   ///< One word: "isar".
  std::string_view meaning;   ///< "an image of a ship that turns (inverse synthetic aperture)"
  std::string_view stem;      ///< The name of its file, and of what it records, before the ending.
  std::string_view format_2;  ///< Its text.
  std::string_view script;    ///< The same in the language of 1998; empty where it cannot say it.
};

/// All of them, the simplest first.
[[nodiscard]] std::span<const StartingScene> starting_scenes();

/// The text of a scene that is called otherwise: its recordings, and the commands in its comments, have the new name.
/// @param stem  without folder and ending
[[nodiscard]] std::string text_named(const StartingScene& scene, Language language, std::string_view stem);

}  // namespace sarsim::scene

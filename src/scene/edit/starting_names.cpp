#include <cctype>

#include "scene/edit/starting_scenes.hpp"

namespace sarsim::scene {

namespace {

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

}  // namespace

std::string text_named(const StartingScene& scene, std::string_view stem) {
  std::string text;
  std::size_t done = 0;
  for (std::size_t at = scene.text.find(scene.stem); at != std::string_view::npos;
       at = scene.text.find(scene.stem, at + 1)) {
    const std::size_t end = at + scene.stem.size();
    const bool whole =
        (at == 0 || !is_of_name(scene.text[at - 1])) && (end == scene.text.size() || !is_of_name(scene.text[end]));
    if (!whole) continue;
    text.append(scene.text.substr(done, at - done)).append(stem);
    done = end;
  }
  return text.append(scene.text.substr(done));
}

}  // namespace sarsim::scene

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "core/text/json.hpp"
#include "scene/edit/starting_scenes.hpp"

namespace sarsim::scene {

namespace {

bool is_letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

bool is_of_name(char c) { return is_letter_or_digit(c) || c == '_'; }

// Whether the name of a scene, with these texts around it, begins that of a file of its own: "sar_r.toml",
// "search_radar-ppi.img", "spotlight_strip.h5". It may be a word of a sentence too ("spotlight: ..."), or begin the
// name of another scene ("sar_r_1998.scr").
bool names_own_file(std::string_view before, std::string_view after) {
  if (!before.empty() && is_of_name(before.back())) return false;
  if (after.size() < 2 || std::string_view("._-").find(after.front()) == std::string_view::npos) return false;
  if (!is_letter_or_digit(after[1])) return false;
  if (after.front() != '_') return true;
  const auto end_of_stem = std::ranges::find_if_not(after, is_of_name);
  const std::string_view suffix = after.substr(static_cast<std::size_t>(end_of_stem - after.begin()));
  return !suffix.starts_with(".scr") && !suffix.starts_with(".toml");
}

// A name as it stands within the quotes of format 2. Those of files may hold anything.
std::string in_format_2(std::string_view name) {
  std::string text;
  for (const char c : core::valid_utf8(name)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F)
      text += fmt::format("\\u{:04X}", byte);
    else
      text += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  }
  return text;
}

}  // namespace

std::string text_named(const StartingScene& scene, Language language, std::string_view stem) {
  const bool script = language == Language::script;
  const std::string_view original = script ? scene.script : scene.format_2;
  const std::string name = script ? std::string(stem) : in_format_2(stem);
  std::string text;
  std::size_t done = 0;
  for (std::size_t at = original.find(scene.stem); at != std::string_view::npos;
       at = original.find(scene.stem, at + 1)) {
    const std::size_t end = at + scene.stem.size();
    if (!names_own_file(original.substr(0, at), original.substr(end))) continue;
    text.append(original.substr(done, at - done)).append(name);
    done = end;
  }
  return text.append(original.substr(done));
}

}  // namespace sarsim::scene

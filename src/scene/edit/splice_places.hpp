#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/model/kinds.hpp"
#include "scene/model/scene.hpp"
#include "scene/script/tokens.hpp"

namespace sarsim::scene {

/// A part of a text, in bytes.
struct TextStretch {
  std::size_t begin = 0;
  std::size_t end = 0;

  friend bool operator==(const TextStretch&, const TextStretch&) = default;
};

/// A token of a script with the bytes that it takes, its quotes or `$` included.
struct PlacedToken {
  script::Token token;
  TextStretch at;
};

/// The tokens of a script, the end left out.
[[nodiscard]] std::vector<PlacedToken> placed_tokens(std::string_view text);

/// Where the commands of a script stand. A command begins with its `$` and ends with the line of its last value, or
/// where the next command begins on that line.
struct CommandPlaces {
  /// For each kind of object, in the order of the objects; `$OPTIONS` come last.
  std::array<std::vector<TextStretch>, kind_count + 1> of;

  static constexpr std::size_t options = kind_count;
  [[nodiscard]] std::vector<TextStretch>& operator[](ObjectKind kind) { return of[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] const std::vector<TextStretch>& operator[](ObjectKind kind) const {
    return of[static_cast<std::size_t>(kind)];
  }
  /// True where there are as many commands of each kind as the scene has objects.
  [[nodiscard]] bool fits(const Scene& scene) const;

  friend bool operator==(const CommandPlaces&, const CommandPlaces&) = default;
};

/// Finds the commands of a script, in time linear in it.
[[nodiscard]] CommandPlaces find_commands(std::string_view text);

/// The line ends that a text uses: "\n", "\r\n" or "\r".
[[nodiscard]] std::string_view line_end_of(std::string_view text);

/// Where the line of a byte begins.
[[nodiscard]] std::size_t line_begin(std::string_view text, std::size_t at);
/// Behind the line end that follows a byte; the size of the text where none does.
[[nodiscard]] std::size_t behind_line(std::string_view text, std::size_t at);
/// True where only blanks stand between the beginning of the line and a byte.
[[nodiscard]] bool is_first_on_line(std::string_view text, std::size_t at);
/// True where the line before the one that begins at `at` is blank, or there is none.
[[nodiscard]] bool blank_line_before(std::string_view text, std::size_t at);

/// Where the comment lines directly above a command begin, without a blank line between; they are taken to be about it.
/// The beginning of its line where there are none, or where they are the first lines of the text and so about all of
/// it; `begin` itself where something else stands on its line before it.
[[nodiscard]] std::size_t lead_begin(std::string_view text, std::size_t begin);

}  // namespace sarsim::scene

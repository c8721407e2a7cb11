#include "scene/edit/splice_command.hpp"

#include <algorithm>

#include "scene/edit/script_values.hpp"
#include "scene/model/object.hpp"
#include "scene/schema/grammar.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene {

namespace {

std::string taken(script::ScriptLines& lines) {
  std::string text = lines.take();
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

std::size_t size_of(const Scene& scene) {
  std::size_t size = 0;
  for (const ObjectKind kind : all_object_kinds) size += count_of(scene, kind);
  return size;
}

std::string_view part(std::string_view text, TextStretch at) { return text.substr(at.begin, at.end - at.begin); }

// Three texts of a command by tokens: as it stands, as the writer would have written it, as the writer would now.
struct Aligned {
  std::string_view command;
  std::string_view before;
  std::string_view after;
  std::vector<PlacedToken> stands = placed_tokens(command);
  std::vector<PlacedToken> was = placed_tokens(before);
  std::vector<PlacedToken> becomes = placed_tokens(after);

  [[nodiscard]] bool same(std::size_t i, std::size_t j) const {
    return part(before, was[i].at) == part(after, becomes[j].at);
  }
};

bool alone_on_line(std::string_view text, const std::vector<PlacedToken>& tokens, std::size_t i) {
  return is_first_on_line(text, tokens[i].at.begin) &&
         (i + 1 == tokens.size() || is_first_on_line(text, tokens[i + 1].at.begin));
}

TextStretch to_end_of_line(std::string_view text, std::size_t begin) {
  return {begin, std::min(text.find_first_of("\r\n", begin), text.size())};
}

// A comment beside a keyword explains that keyword and goes with it.
bool takes_comment(const Aligned& texts, std::size_t i) {
  return script::is_keyword(part(texts.before, texts.was[i].at)) &&
         script::is_keyword(part(texts.after, texts.becomes[i].at)) && alone_on_line(texts.command, texts.stands, i) &&
         alone_on_line(texts.after, texts.becomes, i);
}

// Widens or narrows the blanks before a comment, so that it stays in its column after `growth` bytes before it.
void keep_column(TextChanges& changes, std::string_view command, std::size_t at, std::size_t old_size,
                 std::size_t new_size) {
  const std::size_t comment = std::min(command.find_first_not_of(' ', at), command.size());
  if (new_size == old_size || comment == at || comment == command.size() || command[comment] != '!') return;
  const std::size_t blanks = comment - at + old_size;
  changes.push_back({at, std::string(comment - at, ' '), std::string(blanks > new_size ? blanks - new_size : 1, ' ')});
}

// How many tokens at the beginning and at the end of a command stay when lines between them are replaced.
struct Kept {
  std::size_t head = 0;
  std::size_t tail = 0;
};

// Where token i begins its line; the end of a text that ends with a line counts as the beginning of one.
bool begins_line(std::string_view text, const std::vector<PlacedToken>& tokens, std::size_t i) {
  return i == tokens.size() ? is_first_on_line(text, text.size()) : is_first_on_line(text, tokens[i].at.begin);
}

Kept kept_tokens(const Aligned& texts) {
  const std::size_t shared = std::min(texts.was.size(), texts.becomes.size());
  Kept kept;
  while (kept.head < shared && texts.same(kept.head, kept.head)) ++kept.head;
  while (kept.tail < shared - kept.head &&
         texts.same(texts.was.size() - 1 - kept.tail, texts.becomes.size() - 1 - kept.tail))
    ++kept.tail;
  const auto begin_lines = [&](std::size_t i, std::size_t j) {
    return begins_line(texts.command, texts.stands, i) && begins_line(texts.after, texts.becomes, j);
  };
  while (kept.head > 0 && !begin_lines(kept.head, kept.head)) --kept.head;
  while (kept.tail > 0 && !begin_lines(texts.stands.size() - kept.tail, texts.becomes.size() - kept.tail)) --kept.tail;
  return kept;
}

std::size_t line_of(std::string_view text, const std::vector<PlacedToken>& tokens, std::size_t i) {
  return i == tokens.size() ? text.size() : line_begin(text, tokens[i].at.begin);
}

}  // namespace

std::string command_text(const AnyObject& object) {
  AnyObject writable = object;
  make_names_sayable(writable);
  script::ScriptLines lines;
  std::visit([&](const auto& any) { script::write_command(lines, any); }, writable);
  return taken(lines);
}

std::string command_text(const RunOptions& options) {
  script::ScriptLines lines;
  script::write_command(lines, options);
  return taken(lines);
}

ScriptReading read_command_text(std::string_view command, const DataFileLoader& loader) {
  return read_script(command, "", loader);
}

std::optional<AnyObject> only_object(const Scene& scene) {
  if (size_of(scene) != 1) return std::nullopt;
  for (const ObjectKind kind : all_object_kinds)
    if (count_of(scene, kind) == 1) return object_of(scene, {kind, 0});
  return std::nullopt;
}

namespace detail {

TextChanges change_values(std::string_view command, std::string_view before, std::string_view after) {
  const Aligned texts{command, before, after};
  if (texts.stands.size() != texts.was.size() || texts.was.size() != texts.becomes.size()) return {};
  TextChanges changes;
  std::size_t old_size = 0;  // of what changed on this line
  std::size_t new_size = 0;
  for (std::size_t i = 0; i < texts.stands.size(); ++i) {
    const TextStretch at = texts.stands[i].at;
    if (is_first_on_line(command, at.begin)) old_size = new_size = 0;
    if (!texts.same(i, i)) {
      const std::string_view value = part(after, texts.becomes[i].at);
      if (takes_comment(texts, i)) {
        changes.push_back({at.begin, std::string(part(command, to_end_of_line(command, at.begin))),
                           std::string(part(after, to_end_of_line(after, texts.becomes[i].at.begin)))});
        continue;
      }
      changes.push_back({at.begin, std::string(part(command, at)), std::string(value)});
      old_size += at.end - at.begin;
      new_size += value.size();
    }
    keep_column(changes, command, at.end, old_size, new_size);
  }
  return changes;
}

TextChanges change_lines(std::string_view command, std::string_view before, std::string_view after,
                         std::string_view line_end) {
  const Aligned texts{command, before, after};
  if (texts.stands.size() != texts.was.size()) return {};
  const Kept kept = kept_tokens(texts);
  if (kept.head == 0) return {};
  const std::size_t behind = texts.stands.size() - kept.tail;
  const std::size_t begin = line_of(command, texts.stands, kept.head);
  // Comment lines above the first value that stays are left to it.
  const std::size_t end = behind > kept.head ? behind_line(command, texts.stands[behind - 1].at.end) : begin;
  // An addition at the very end could not be told from what comes behind the command.
  if (begin == end && end == command.size()) return {};
  const std::size_t new_begin = line_of(after, texts.becomes, kept.head);
  const std::size_t new_end = line_of(after, texts.becomes, texts.becomes.size() - kept.tail);
  return {{begin, std::string(command.substr(begin, end - begin)),
           with_line_ends(after.substr(new_begin, new_end - new_begin), line_end)}};
}

std::string with_line_ends(std::string_view text, std::string_view line_end) {
  std::string result;
  for (const char c : text) {
    if (c == '\n')
      result += line_end;
    else
      result += c;
  }
  return result;
}

}  // namespace detail

}  // namespace sarsim::scene

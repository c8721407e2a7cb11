#include "scene/edit/splice_places.hpp"

#include <algorithm>

#include "scene/model/object.hpp"
#include "scene/schema/grammar.hpp"

namespace sarsim::scene {

namespace {

constexpr char end_of_file_mark = 0x1A;

bool ends_line(char c) { return c == '\n' || c == '\r'; }

// Gives each token of a text to `visit`, with its place.
template <class Visit>
void visit_tokens(std::string_view text, Visit visit) {
  using script::TokenKind;
  script::Tokens tokens(text);
  const char line_end = line_end_of(text).back();
  std::size_t previous_end = 0;
  for (script::Token token = tokens.take(); token.kind != TokenKind::end; token = tokens.take()) {
    TextStretch at;
    at.begin = static_cast<std::size_t>(token.text.data() - text.data());
    at.end = at.begin + token.text.size();
    if (token.kind == TokenKind::quoted) {
      --at.begin;
      if (!token.open_quote) ++at.end;
    } else if (token.kind == TokenKind::command) {
      // The word may stand apart from its `$`, and that may be repeated.
      for (std::size_t i = at.begin; i > previous_end; --i) {
        const char c = text[i - 1];
        if (c == line_end || (c != '$' && !script::is_separator(c))) break;
        if (c == '$') at.begin = i - 1;
      }
    }
    previous_end = at.end;
    visit(token, at);
  }
}

// The list of CommandPlaces that a command word belongs to; its size for an unknown word.
std::size_t slot_of(std::string_view word) {
  static constexpr auto slots = [] {
    std::array<std::size_t, script::command_words.size()> made{};
    made.fill(CommandPlaces::options);
    for_each_kind([&](const auto& kind) {
      made[static_cast<std::size_t>(std::ranges::find(script::command_words, kind.command) -
                                    script::command_words.begin())] = static_cast<std::size_t>(kind.kind);
    });
    return made;
  }();
  for (std::size_t i = 0; i < slots.size(); ++i)
    if (script::command_matches(word, script::command_words[i])) return slots[i];
  return slots.size();
}

// The command being passed over.
struct OpenCommand {
  std::size_t slot = CommandPlaces{}.of.size();
  TextStretch at;  // up to its last token so far
  bool has_values = false;
};

// A command without any value makes no object.
void close(CommandPlaces& places, const OpenCommand& command, std::string_view text, std::size_t limit) {
  if (command.slot >= places.of.size()) return;
  if (!command.has_values && command.slot != CommandPlaces::options) return;
  const std::size_t line = text.find(line_end_of(text).back(), command.at.end);
  places.of[command.slot].push_back({command.at.begin, std::min(limit, line == text.npos ? limit : line + 1)});
}

}  // namespace

bool CommandPlaces::fits(const Scene& scene) const {
  return std::ranges::all_of(all_object_kinds,
                             [&](ObjectKind kind) { return (*this)[kind].size() == count_of(scene, kind); });
}

std::vector<PlacedToken> placed_tokens(std::string_view text) {
  std::vector<PlacedToken> tokens;
  visit_tokens(text, [&](const script::Token& token, TextStretch at) { tokens.push_back({token, at}); });
  return tokens;
}

CommandPlaces find_commands(std::string_view text) {
  CommandPlaces places;
  OpenCommand open;
  visit_tokens(text, [&](const script::Token& token, TextStretch at) {
    if (token.kind != script::TokenKind::command) {
      open.at.end = at.end;
      open.has_values = true;
      return;
    }
    close(places, open, text, at.begin);
    open = {slot_of(token.text), at, false};
  });
  close(places, open, text, text.find_last_not_of(end_of_file_mark) + 1);
  return places;
}

std::string_view line_end_of(std::string_view text) {
  const std::size_t line_feed = text.find('\n');
  if (line_feed != std::string_view::npos) return line_feed > 0 && text[line_feed - 1] == '\r' ? "\r\n" : "\n";
  return text.find('\r') != std::string_view::npos ? "\r" : "\n";
}

std::size_t line_begin(std::string_view text, std::size_t at) {
  while (at > 0 && !ends_line(text[at - 1])) --at;
  return at;
}

std::size_t behind_line(std::string_view text, std::size_t at) {
  const std::size_t end = text.find_first_of("\r\n", at);
  if (end == std::string_view::npos) return text.size();
  return text.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
}

bool is_first_on_line(std::string_view text, std::size_t at) {
  while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t')) --at;
  return at == 0 || ends_line(text[at - 1]);
}

bool blank_line_before(std::string_view text, std::size_t at) {
  if (at == 0) return true;
  std::size_t line_end = at - 1;
  if (line_end > 0 && text[line_end] == '\n' && text[line_end - 1] == '\r') --line_end;
  return is_first_on_line(text, line_end);
}

std::size_t lead_begin(std::string_view text, std::size_t begin) {
  if (!is_first_on_line(text, begin)) return begin;
  const std::size_t own_line = line_begin(text, begin);
  std::size_t lead = own_line;
  while (lead > 0) {
    std::size_t line_end = lead - 1;
    if (line_end > 0 && text[line_end] == '\n' && text[line_end - 1] == '\r') --line_end;
    const std::size_t above = line_begin(text, line_end);
    const std::size_t first = text.find_first_not_of(" \t", above);
    if (first >= line_end || text[first] != '!') break;
    lead = above;
  }
  return lead == 0 ? own_line : lead;
}

}  // namespace sarsim::scene

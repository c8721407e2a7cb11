#include "scene/script/reader.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>

#include "core/text/number_text.hpp"
#include "scene/model/object.hpp"
#include "scene/schema/grammar.hpp"
#include "scene/script/foreign_text.hpp"
#include "scene/script/make_room.hpp"
#include "scene/script/pieces.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::scene {

namespace {

using namespace script;

// More problems than this help nobody.
constexpr std::size_t problem_limit = 1000;

using CommandReader = void (*)(Reading&, const Token&, Scene&);

// In the order of `command_words`, which decides what a shortened word means.
constexpr std::array<CommandReader, command_words.size()> command_readers{
    read_target, read_platform, read_radar, read_simulation, read_surface, read_geometry, read_cloud, read_options};

constexpr std::size_t options_command = command_words.size() - 1;
static_assert(command_words[options_command] == "OPTIONS");

void read_unknown(Reading& reading, const Token& command) {
  Reporter reporter(reading.log, reading.file, {});
  if (command.text.empty()) {
    reporter.warning(command, "", {"a '$' without a command is ignored"});
  } else {
    const std::string near = core::nearest_word(command.text.substr(0, longest_shown), command_words);
    reporter.error(command, "",
                   {"unknown command", "$" + shown(command.text),
                    "$PLATFORM, $TARGET, $SURFACE, $CLOUD, $RADAR, $SIMULATION, $GEOMETRY or $OPTIONS",
                    near.empty() ? "" : "did you mean $" + near + "?"});
  }
  reading.tokens.skip_values();
}

// Number of a command in `command_words`; their count for one that is unknown.
std::size_t command_number(const Token& command) {
  return static_cast<std::size_t>(
      std::ranges::find_if(command_words, [&](auto word) { return command_matches(command.text, word); }) -
      command_words.begin());
}

void pass_over_beginning(Reading& reading) {
  Reporter reporter(reading.log, reading.file, {});
  const Token first = reading.tokens.peek();
  if (first.is_value())
    reporter.warning(first, "",
                     {"text before the first command is ignored", shown(first.text), "a command, as $PLATFORM",
                      "a comment begins with '!'"});
  reading.tokens.skip_values();
  if (reading.tokens.peek().kind == TokenKind::end)
    reporter.warning(reading.tokens.peek(), "", {"the script holds no command", "", "commands, as $PLATFORM"});
}

// Whether the next token is a command of this piece that is still to be read.
bool command_follows(const Reading& reading, const Piece& piece) {
  const Token& next = reading.tokens.peek();
  return next.kind == TokenKind::command && next.line < piece.end_line && !reading.log.full();
}

// Reads a piece into a scene, behind what that holds. Goes on for as long as `wanted` approves of the next command.
template <class Wanted>
bool read_piece(Reading& reading, Scene& scene, const Piece& piece, const Wanted& wanted) {
  if (piece.begin == 0) pass_over_beginning(reading);
  while (command_follows(reading, piece)) {
    const std::size_t number = command_number(reading.tokens.peek());
    if (!wanted(number)) return false;
    const Token command = reading.tokens.take();
    if (number < command_readers.size())
      command_readers[number](reading, command, scene);
    else
      read_unknown(reading, command);
  }
  return true;
}

// What a piece says by itself.
struct PieceReading {
  Scene scene;
  ProblemLog log{problem_limit};
  FieldPlaces places;
  bool complete = false;  // else only the scene it adds to can tell what it means
};

template <class Object>
void append(std::vector<Object>& list, std::vector<Object>&& more, double share) {
  make_room(list, more.size(), share);
  std::ranges::move(more, std::back_inserter(list));
}

// Pieces enough that threads end at about the same time, none of them so short that joining it would cost more.
std::size_t fair_piece_bytes(std::size_t script_bytes, std::size_t most) {
  constexpr std::size_t fair_pieces = 16;
  constexpr std::size_t shortest = std::size_t{1} << 16;
  return std::min(most, std::max(script_bytes / fair_pieces, shortest));
}

// Reads a script in pieces: on several threads each by itself, then joined in their order. The outcome is that of
// reading them one after the other, into one scene.
class PiecewiseReader {
 public:
  PiecewiseReader(std::string_view file, const DataFileLoader& loader, const Tokens& whole, ReadControl control)
      : file_(file),
        loader_(loader),
        whole_(whole),
        control_(control),
        pieces_(cut(whole, fair_piece_bytes(whole.text().size(), control.piece_bytes), control.work)),
        joined_{whole, ProblemLog(problem_limit), {}, file, loader} {}

  ScriptReading read() {
    if (pieces_.size() == 1)
      join_in_place(pieces_.front());
    else
      core::ordered_parallel<PieceReading>(
          pieces_.size(), control_.work.threads, [this] { return [this](std::size_t i) { return read_alone(i); }; },
          [this](std::size_t i, PieceReading&& piece) { join(i, std::move(piece)); }, control_.work.stop);
    return {std::move(scene_), joined_.log.take(), std::move(joined_.places)};
  }

 private:
  [[nodiscard]] Tokens tokens_of(const Piece& piece) const {
    return piece.begin == 0 ? whole_ : whole_.from_line(piece.begin, piece.first_line);
  }

  [[nodiscard]] PieceReading read_alone(std::size_t number) const {
    PieceReading result;
    if (enough_.load(std::memory_order_relaxed)) return result;
    const Piece& piece = pieces_[number];
    Reading reading{tokens_of(piece), ProblemLog(problem_limit), {}, file_, loader_};
    // An option that is not given leaves the one given before.
    const auto wanted = [](std::size_t command) { return command != options_command; };
    result.complete = read_piece(reading, result.scene, piece, wanted);
    result.log = std::move(reading.log);
    result.places = std::move(reading.places);
    return result;
  }

  void join_in_place(const Piece& piece) {
    joined_.tokens = tokens_of(piece);
    read_piece(joined_, scene_, piece, [](std::size_t) { return true; });
  }

  void join(std::size_t number, PieceReading&& reading) {
    if (joined_.log.full()) return;
    const Piece& piece = pieces_[number];
    // Where reading ends within the piece depends on what was found before it.
    if (!reading.complete || joined_.log.full_with(reading.log)) {
      join_in_place(piece);
      enough_.store(joined_.log.full(), std::memory_order_relaxed);
      return;
    }
    const auto objects_before = [this](std::string_view word) {
      const auto kind = kind_called(word);
      return kind ? count_of(scene_, *kind) : 0;
    };
    const double share = static_cast<double>(piece.end) / static_cast<double>(whole_.text().size());
    joined_.log.append(std::move(reading.log), objects_before);
    joined_.places.append(reading.places, objects_before, share);
    for_each_kind([&](const auto& kind) { append(scene_.*kind.list, std::move(reading.scene.*kind.list), share); });
  }

  std::string_view file_;
  const DataFileLoader& loader_;
  const Tokens& whole_;
  ReadControl control_;
  std::vector<Piece> pieces_;
  Reading joined_;
  Scene scene_;
  std::atomic<bool> enough_{false};
};

}  // namespace

namespace {

// The first place where editors show a new line and the language has none, so that a comment hides commands.
std::size_t find_hidden_line(std::string_view text) {
  const bool feeds = text.find('\n') != std::string_view::npos;
  for (const std::string_view mark : {"\xE2\x80\xA8", "\xE2\x80\xA9", "\r"}) {
    if (mark == "\r" && !feeds) continue;  // Then it ends lines.
    for (std::size_t at = text.find(mark); at != std::string_view::npos;) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const std::size_t feed = text.rfind('\n', at);
      const std::string_view before = text.substr(feed + 1, at - (feed + 1));  // npos + 1 is 0.
      if (before.find('!') != std::string_view::npos && text.substr(at, end - at).find('$') != std::string_view::npos)
        return at;
      at = text.find(mark, end);
    }
  }
  return std::string_view::npos;
}

void warn_of_hidden_line(std::string_view text, const std::string& file_name, core::Problems& problems) {
  const std::size_t at = find_hidden_line(text);
  if (at == std::string_view::npos) return;
  ProblemLog log(problem_limit);
  Reporter(log, file_name, {})
      .warning(token_at(text, at), "",
               {"the comment hides commands: its line does not end where it seems to",
                text[at] == '\r' ? "a carriage return" : "a line separator of Unicode (U+2028 or U+2029)",
                "a line feed", "save the script with line ends of one kind, LF or CR LF"});
  core::append(problems, log.take());
}

// Whether a text has a command, known or not: a '$' with a word.
bool has_command(const Tokens& text) {
  Tokens tokens = text;
  for (tokens.skip_values(); tokens.peek().kind == TokenKind::command; tokens.skip_values())
    if (!tokens.take().text.empty()) return true;
  return false;
}

// Comments alone are a script that describes nothing, as the writer makes of a scene without objects. A draft may still
// be empty, or hold its first words only.
bool may_be_begun(std::string_view text, const ReadControl& control) {
  if (text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size())).starts_with('!')) return true;
  if (!control.draft) return false;
  const std::string kind = guess_of_content(text);
  return kind.empty() || kind == "an empty file";
}

}  // namespace

ScriptReading read_script(std::string_view text, const std::string& file_name, const DataFileLoader& loader,
                          const ReadControl& control) {
  const Tokens whole(text);
  const std::size_t control_byte = find_control_byte(text, control.work);
  ScriptReading result;
  const bool is_text = control_byte == std::string_view::npos;
  if (is_text ? !has_command(whole) && !may_be_begun(text, control) : is_known_format(text)) {
    result.problems.push_back(no_scene(text, file_name));
    return result;
  }
  if (is_text) {
    result = PiecewiseReader(file_name, loader, whole, control).read();
    warn_of_hidden_line(text, file_name, result.problems);
    return result;
  }
  ProblemLog log(problem_limit);
  const bool wide = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  Reporter(log, file_name, {})
      .error(
          token_at(text, control_byte), "",
          {"not a text file", "", "a script as text", wide ? "it looks like UTF-16: save it as UTF-8 or ASCII" : ""});
  result.problems = log.take();
  return result;
}

void locate(core::Problems& problems, const FieldPlaces& places) {
  for (core::Problem& problem : problems)
    if (problem.place.line == 0 && !problem.subject.kind.empty()) problem.place = places.find(problem.subject);
}

}  // namespace sarsim::scene

#include "script/reader.hpp"

#include <array>

#include "base/number_text.hpp"
#include "script/read_commands.hpp"
#include "script/scene_grammar.hpp"

namespace sarsim {

namespace {

using namespace script;

// More problems than this help nobody.
constexpr std::size_t problem_limit = 1000;

using CommandReader = void (*)(Reading&, const Token&, Scene&);

// In the order of `command_words`, which decides what a shortened word means.
constexpr std::array<CommandReader, command_words.size()> command_readers{
    read_target, read_platform, read_radar, read_simulation, read_surface, read_geometry, read_options};

void read_unknown(Reading& reading, const Token& command) {
  Reporter reporter(reading.log, reading.file, {});
  if (command.text.empty()) {
    reporter.warning(command, "", {"a '$' without a command is ignored"});
  } else {
    const std::string_view near = nearest_word(command.text.substr(0, longest_shown), command_words);
    reporter.error(command, "",
                   {"unknown command", "$" + shown(command.text),
                    "$PLATFORM, $TARGET, $SURFACE, $RADAR, $SIMULATION, $GEOMETRY or $OPTIONS",
                    near.empty() ? "" : "did you mean $" + std::string(near) + "?"});
  }
  reading.tokens.skip_values();
}

void read_command(Reading& reading, const Token& command, Scene& scene) {
  for (std::size_t i = 0; i < command_words.size(); ++i)
    if (command_matches(command.text, command_words[i])) return command_readers[i](reading, command, scene);
  read_unknown(reading, command);
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

}  // namespace

ScriptReading read_script(std::string_view text, const std::string& file_name, const DataFileLoader& loader) {
  ScriptReading result;
  const std::size_t control = find_control_byte(text);
  if (control != std::string_view::npos) {
    ProblemLog log(problem_limit);
    const bool wide = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
    Reporter(log, file_name, {})
        .error(
            token_at(text, control), "",
            {"not a text file", "", "a script as text", wide ? "it looks like UTF-16: save it as UTF-8 or ASCII" : ""});
    result.problems = log.take();
    return result;
  }
  Reading reading{Tokens(text), ProblemLog(problem_limit), {}, file_name, loader};
  pass_over_beginning(reading);
  while (reading.tokens.peek().kind == TokenKind::command && !reading.log.full()) {
    const Token command = reading.tokens.take();
    read_command(reading, command, result.scene);
  }
  result.problems = reading.log.take();
  result.places = std::move(reading.places);
  return result;
}

void locate(Problems& problems, const FieldPlaces& places) {
  for (Problem& problem : problems)
    if (problem.place.line == 0 && !problem.subject.kind.empty()) problem.place = places.find(problem.subject);
}

}  // namespace sarsim

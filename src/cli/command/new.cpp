#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <span>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/shown_name.hpp"
#include "cli/shell/options.hpp"
#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/shell_word.hpp"
#include "scene/edit/starting_scenes.hpp"
#include "workflow/convert/convert_scene.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::cli {

namespace {

struct NewArguments {
  std::string purpose;
  std::string output;
  std::optional<scene::Language> language;
  bool force = false;
};

std::string_view ending_of(scene::Language language) { return language == scene::Language::script ? ".scr" : ".toml"; }

std::string purposes() {
  std::string text;
  for (const scene::StartingScene& scene : scene::starting_scenes())
    text += fmt::format("{:<18} {}\n", scene.purpose, scene.meaning);
  return text;
}

// A purpose of which one word is the beginning of what was typed, or begins with it: "sar", "stripmap" for "sar-strip".
std::string purpose_with_part(const std::vector<std::string>& purposes, const std::string& typed) {
  constexpr std::size_t shortest = 3;
  const std::string small = core::lower_case(typed);
  for (const std::string& purpose : purposes)
    for (std::size_t begin = 0; begin < purpose.size() && small.size() >= shortest;) {
      const std::size_t end = std::min(purpose.find('-', begin), purpose.size());
      const std::string part = purpose.substr(begin, end - begin);
      if (part.size() >= shortest && (small.starts_with(part) || part.starts_with(small))) return purpose;
      begin = end + 1;
    }
  return {};
}

const scene::StartingScene& chosen(const std::string& purpose) {
  std::vector<std::string> words;
  for (const scene::StartingScene& scene : scene::starting_scenes()) {
    if (core::equal_ignoring_case(scene.purpose, purpose)) return scene;
    words.emplace_back(scene.purpose);
  }
  const std::string part = purpose_with_part(words, purpose);
  const std::string nearest = part.empty() ? core::nearest_word(purpose, words) : part;
  throw core::InvalidRequest(fmt::format("there is no example scene for '{}'", purpose),
                             nearest.empty() ? fmt::format("choose one of {}", fmt::join(words, ", "))
                                             : fmt::format("did you mean '{}'?", nearest));
}

// What was asked for, or what the name of the file says, or format 2.
scene::Language language_of(const NewArguments& arguments) {
  const auto of_name = workflow::language_of_name(arguments.output);
  const scene::Language language = arguments.language.value_or(of_name.value_or(scene::Language::format_2));
  if (of_name && *of_name != language)
    throw core::InvalidRequest(fmt::format("'{}' is a name for the other language", arguments.output),
                               fmt::format("end it with {}, or leave out --language", ending_of(language)));
  return language;
}

// A script as it is named in a command: no option, whatever its name begins with.
std::string command_word(const std::filesystem::path& path) {
  const std::string name = path.string();
  return core::shell_word(name.starts_with('-') ? "./" + name : name);
}

ExitStatus write_scene(const NewArguments& arguments, Streams& streams) {
  if (arguments.purpose.empty()) {
    write_out(streams, purposes());
    return exit_done;
  }
  const scene::StartingScene& scene = chosen(arguments.purpose);
  const scene::Language language = language_of(arguments);
  if (language == scene::Language::script && scene.script.empty())
    throw core::InvalidRequest(fmt::format("the language of 1998 cannot say the scene for '{}'", scene.purpose),
                               "leave out --language, and end the name with .toml");
  const std::filesystem::path path =
      arguments.output.empty() ? fmt::format("{}{}", scene.stem, ending_of(language)) : arguments.output;
  workflow::expect_free_outputs({path}, {{}, arguments.force, "-o"});
  const std::string text = scene::text_named(scene, language, path.stem().string());
  core::OutputFile file(path, arguments.force);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
  const std::string word = shown_name(command_word(path));
  write_err(streams,
            fmt::format("{}: {}\n    sarsim check {}    what it asks for\n    sarsim run {}      its recordings\n",
                        shown_name(path.string()), scene.meaning, word, word));
  return exit_done;
}

}  // namespace

Action add_new(CLI::App& app) {
  auto arguments = std::make_shared<NewArguments>();
  std::string words;
  for (const scene::StartingScene& scene : scene::starting_scenes())
    words += fmt::format("{}{}", words.empty() ? "" : "|", scene.purpose);
  add_text(app, "purpose", arguments->purpose, words, "which example; without it, a list of them");
  add_text(app, "-o,--out", arguments->output, "FILE", "scene to write (default: the name of the example)");
  add_choice<scene::Language>(app, "--language", arguments->language,
                              {{"toml", scene::Language::format_2}, {"scr", scene::Language::script}},
                              "format 2 or the language of 1998 (default: as FILE ends; toml where it says neither)");
  app.add_flag("--force", arguments->force, "replace the file where it exists");
  add_examples(app, {{"sarsim new", "which scenes there are"},
                     {"sarsim new sar-strip -o mine.toml", "an aircraft that maps 24 points, to be changed"},
                     {"sarsim check mine.toml", "what it asks for"},
                     {"sarsim new sar-strip -o mine.scr", "the same in the language of 1998"}});
  return [arguments](Streams& streams) { return write_scene(*arguments, streams); };
}

}  // namespace sarsim::cli

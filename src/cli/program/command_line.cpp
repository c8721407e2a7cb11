#include "cli/program/command_line.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/signals.hpp"
#include "core/build/build.hpp"
#include "core/build/version.hpp"
#include "core/os/isolated.hpp"
#include "core/os/standard_streams.hpp"
#include "core/report/retryable.hpp"
#include "core/task/deferred_signal.hpp"
#include "core/text/json.hpp"
#include "core/text/number_text.hpp"
#include "picture/facts/version_text.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/options/trade_options.hpp"
#include "workflow/record/team.hpp"

namespace sarsim::cli {

namespace {

std::string about(const std::string& program) {
  return picture::version_text(program, core::this_build(), {{"CLI11", CLI11_VERSION}}) + "\n";
}

// The application with its commands. Their options are added to the one that is called alone: there are hundreds.
struct Program {
  struct Command {
    CLI::App* app;
    std::function<Action(CLI::App&)> add_options;
  };

  CLI::App app{"Simulates the echoes that a radar receives: from a scene to complex baseband samples.", "sarsim"};
  std::vector<Command> commands;
  std::vector<Action> actions_of_others;  // Keep the options that completion lists.
  bool begun = false;                     // A command was understood and is carried out.

  Program() {
    prepare();
    add("run", "simulate all or some of a scene's outputs", [](CLI::App& command) { return add_run(command); });
    add("new", "write a commented example scene", add_new);
    add("sweep", "run variations of a scene: ranges of values, seeds", add_sweep);
    add("check", "check scenes for errors and likely mistakes", add_check);
    add("explain", "explain a field of a scene: meaning, unit, range, default", add_explain);
    add("info", "describe a scene or a file of samples", add_info);
    add("geometry", "tabulate the geometry pulse by pulse: positions, delays, amplitudes, speeds", add_geometry);
    add("motion", "export the motion of a platform, for other programs or for focusing", add_motion);
    add("plot", "plot echoes, spectra, antenna patterns and paths of a scene or a file of samples", add_plot);
    add("merge", "merge recordings made in parts", add_merge);
    add("convert", "convert files of samples between formats", add_convert);
    add("focus", "form a SAR image from a recording or a scene", add_focus);
    add("measure", "measure a scene's targets in a focused image against expected values", add_measure);
    add("doppler", "form range-Doppler maps and detect moving targets in each coherent interval", add_doppler);
    add("search", "form the PPI display of a rotating antenna and detect targets", add_search);
    add("profiles", "form synthetic range profiles from stepped-frequency bursts", add_profiles);
    add("isar", "form inverse SAR (ISAR) images of a rotating target", add_isar);
    add("format", "rewrite a scene in the standard layout (its own comments are not kept)", add_format_command);
    add("verify", "self-test against closed-form results, the thesis and a reference engine", add_verify);
    add("completion", "print a completion script for a shell", [this](CLI::App& command) {
      for (const Command& other : commands)
        if (other.app != &command) actions_of_others.push_back(other.add_options(*other.app));
      return add_completion(command, app);
    });
    add_examples(app, {{"sarsim scene.toml", "the same as sarsim run scene.toml"},
                       {"sarsim check scene.toml", "before computing anything"},
                       {"sarsim help run", "options and examples of a command, as sarsim run --help"}});
  }
  // For processes that run together.
  explicit Program(workflow::Team& team) {
    app.name("sarsim-mpi");
    app.description("Runs sarsim run across the processes of an MPI job.");
    prepare();
    add("run", "simulate all or some of a scene's outputs",
        [&team](CLI::App& command) { return add_run(command, &team); });
    add_examples(app, {{"mpirun -n 8 sarsim-mpi run scene.toml", "eight processes, each with its share of the cores"}});
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void prepare() {
    app.set_help_flag("-h,--help", "this help");
    app.set_version_flag("--version", "", "version, build, libraries and licence");
    app.get_formatter()->column_width(34);
    app.allow_extras();
    app.require_subcommand(0, 1);  // A word behind a command is no other command: "new isar".
  }

  void add(const char* name, const char* description, std::function<Action(CLI::App&)> add_options) {
    CLI::App* command = app.add_subcommand(name, description);
    command->set_help_flag("-h,--help", "this help");
    command->allow_extras();
    commands.push_back({command, std::move(add_options)});
  }

  [[nodiscard]] std::vector<std::string> command_names() const {
    std::vector<std::string> names;
    for (const Command& command : commands) names.push_back(command.app->get_name());
    return names;
  }
};

bool looks_like_scene(const std::string& word) {
  if (word.empty() || word.front() == '-') return false;
  const std::filesystem::path path(word);
  std::error_code ignored;
  return workflow::language_of_name(path) || path.has_parent_path() || std::filesystem::is_regular_file(path, ignored);
}

// Puts "run" in front where the first word is no command but a script follows, as the original compiler was called.
void supply_run(std::vector<std::string>& words, const std::vector<std::string>& commands) {
  if (words.empty() || std::ranges::find(commands, words.front()) != commands.end()) return;
  const bool option_first = words.front().starts_with("-");
  const bool scene = option_first ? std::ranges::any_of(words, looks_like_scene) : looks_like_scene(words.front());
  if (scene) words.insert(words.begin(), "run");
}

// "help run" is "run --help". A word that is no command is left alone, to be refused as one.
void turn_help(std::vector<std::string>& words, const std::vector<std::string>& commands) {
  if (words.empty() || words.front() != "help") return;
  words.erase(words.begin());
  words.resize(std::min<std::size_t>(words.size(), 1));
  if (words.empty() || std::ranges::find(commands, words.front()) != commands.end()) words.emplace_back("--help");
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// Whether two words have the same letters in another order.
bool are_mixed_up(std::string a, std::string b) {
  std::ranges::sort(a);
  std::ranges::sort(b);
  return a == b;
}

// The word that was meant, or nothing: of a short word most letters have to be right.
std::string_view meant_word(std::string_view word, const std::vector<std::string>& known) {
  const auto bare = [](std::string_view text) {
    return text.substr(std::min(text.find_first_not_of('-'), text.size()));
  };
  std::vector<std::string_view> names;
  for (const std::string& name : known) names.push_back(bare(name));
  const std::string nearest = core::nearest_word(bare(word), names);
  const std::size_t most = std::max<std::size_t>(1, bare(word).size() / 2);
  const bool near = core::edit_distance(bare(word), nearest) <= most || are_mixed_up(std::string(bare(word)), nearest);
  if (nearest.empty() || !near) return {};
  return known[static_cast<std::size_t>(std::ranges::find(names, nearest) - names.begin())];
}

// "--range 10 20" and "--range 10:20" mean the same in every command.
void adapt_intervals(const CLI::App& command, std::vector<std::string>& words) {
  const auto is_number = [](const std::string& word) { return core::parse_number(word).has_value(); };
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    const CLI::Option* option = words[i].starts_with("--") ? command.get_option_no_throw(words[i]) : nullptr;
    if (option == nullptr) continue;
    const auto next = words.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const std::size_t colon = next->find(':');
    if (option->get_type_name() == "FIRST:LAST" && i + 2 < words.size() && is_number(*next) &&
        is_number(words[i + 2])) {
      *next += ":" + words[i + 2];
      words.erase(next + 1);
    } else if (option->get_expected_min() == 2 && colon != std::string::npos && is_number(next->substr(0, colon)) &&
               is_number(next->substr(colon + 1))) {
      words.insert(next + 1, next->substr(colon + 1));
      words[i + 1].resize(colon);
    }
  }
}

// What to do about a word that belongs nowhere, where that can be told better than by words that are near.
std::string other_way(const CLI::App* command, const std::string& word, const std::string& name) {
  const std::string_view known = workflow::other_way_than_word(command != nullptr ? command->get_name() : "", name);
  if (!known.empty()) return std::string(known);
  std::error_code ignored;
  if (command == nullptr)
    return std::filesystem::is_regular_file(word + ".toml", ignored) ? fmt::format("did you mean '{}.toml'?", word)
                                                                     : "";
  const std::string ending = std::filesystem::path(word).extension().string();
  if (word.starts_with("-") || ending.empty()) return {};
  if (command->get_option_no_throw("--out") != nullptr) return fmt::format("did you mean --out {}?", word);
  if (command->get_option_no_throw("--csv") != nullptr && ending == ".csv")
    return fmt::format("--csv writes to standard output: add > {}", word);
  return {};
}

// What stands on the command line and belongs nowhere.
void expect_no_extras(const Program& program, const CLI::App* command) {
  const CLI::App& app = command != nullptr ? *command : program.app;
  std::vector<std::string> extras = app.remaining();
  // Behind "--" nothing is an option; the mark itself is kept as if it were a word.
  std::erase(extras, "--");
  if (extras.empty()) return;
  const std::string& word = extras.front();
  const bool option = word.starts_with("-");
  const std::string name = word.substr(0, word.find('='));
  const std::vector<std::string> known = option ? option_names(app) : program.command_names();
  const std::string_view nearest = option || command == nullptr ? meant_word(name, known) : std::string_view();
  const std::string where = command != nullptr ? command->get_name() + ": " : std::string();
  const char* what = option ? "unknown option" : command == nullptr ? "unknown command" : "unexpected argument";
  const std::string other = other_way(command, word, name);
  throw core::InvalidRequest(
      fmt::format("{}{} '{}'", where, what, name),
      !other.empty()    ? other
      : nearest.empty() ? fmt::format("see sarsim {}--help", command != nullptr ? command->get_name() + " " : "")
                        : fmt::format("did you mean '{}'?", nearest));
}

ExitStatus dispatch(Program& program, std::vector<std::string> words, Streams& streams) {
  turn_help(words, program.command_names());
  supply_run(words, program.command_names());
  const auto chosen = std::ranges::find_if(program.commands, [&](const Program::Command& entry) {
    return !words.empty() && entry.app->get_name() == words.front();
  });
  CLI::App* command = chosen == program.commands.end() ? nullptr : chosen->app;
  const Action action = command != nullptr ? chosen->add_options(*command) : nullptr;
  if (command != nullptr) adapt_intervals(*command, words);
  try {
    std::ranges::reverse(words);  // As CLI11 takes them.
    program.app.parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    write_out(streams, command != nullptr ? command->help("sarsim") : program.app.help());
    return exit_done;
  } catch (const CLI::CallForVersion&) {
    write_out(streams, about(program.app.get_name()));
    return exit_done;
  } catch (const CLI::ParseError& error) {
    expect_no_extras(program, command);
    const std::string where = command != nullptr ? command->get_name() + ": " : std::string();
    throw core::InvalidRequest(where + error.what(),
                               fmt::format("see sarsim {}--help", command != nullptr ? command->get_name() + " " : ""));
  }
  expect_no_extras(program, command);
  if (command == nullptr) {
    write_out(streams, program.app.help());
    return exit_done;
  }
  program.begun = true;
  return action(streams);
}

// What to do about a failure of the system; empty where nothing helps.
std::string remedy(const std::error_code& failure) {
  if (failure == std::errc::no_space_on_device || failure == std::errc::file_too_large)
    return "free some space or write elsewhere; existing files are untouched";
  if (failure == std::errc::permission_denied || failure == std::errc::operation_not_permitted ||
      failure == std::errc::read_only_file_system || failure == std::errc::not_a_directory ||
      failure == std::errc::no_such_file_or_directory || failure == std::errc::is_a_directory ||
      failure == std::errc::file_exists)
    return "write into a folder that can be written, with another --out or output name";
  if (failure == std::errc::filename_too_long) return "give the output a shorter name";
  if (core::is_retryable(failure)) return "temporary failure: try again later";
  return {};
}

bool asks_for_json(const std::vector<std::string>& words) {
  return std::find(words.begin(), std::ranges::find(words, "--"), "--json") != std::ranges::find(words, "--");
}

// What a command that was to answer in JSON answers where it has not begun to.
void write_failure(Streams& streams, const char* status, const core::Problems& problems) {
  if (streams.written) return;
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("status", status).key("problems");
  write_json(json, problems);
  json.end_object();
  streams.out << json.text() << std::flush;
}

int guarded(Program& program, std::vector<std::string> words, Streams& streams) {
  const bool json = asks_for_json(words);
  const auto fail = [&](ExitStatus status, const std::string& text, const std::string& hint = {}) {
    write_err(streams, "sarsim: error: " + text + "\n");
    if (!hint.empty()) write_err(streams, "    " + hint + "\n");
    if (json) write_failure(streams, word_of(status), {core::error(text).hint(hint)});
    return status;
  };
  try {
    const ExitStatus status = dispatch(program, std::move(words), streams);
    flush_out(streams);
    return status;
  } catch (const core::InvalidRequest& error) {
    print_problems(streams, error.problems);
    const ExitStatus status = status_of(error);
    if (json) write_failure(streams, word_of(status), error.problems);
    return status;
  } catch (const OutputClosed&) {
    return exit_failed;
  } catch (const core::Interrupted& interrupted) {
    const int number = received_signal();
    const auto* kept = dynamic_cast<const core::DeferredSignal*>(&interrupted);
    write_err(streams,
              fmt::format("sarsim: interrupted; {}\n",
                          kept == nullptr ? "no partial output was left behind"
                                          : "finished work is kept in " + kept->kept_in + "; continue with --resume"));
    if (json) write_failure(streams, "interrupted", {});
    return 128 + (number != 0 ? number : SIGINT);
  } catch (const std::bad_alloc&) {
    return fail(exit_failed, "not enough memory", "record less at once, or with fewer --threads");
  } catch (const std::system_error& error) {
    // No thread could be made: with a limit of its own on memory that does not pass.
    const std::uint64_t limit_bytes = core::own_memory_limit_bytes();
    if (error.code() == std::errc::resource_unavailable_try_again && limit_bytes > 0)
      return fail(
          exit_failed,
          fmt::format("not enough memory for another thread: this process is limited to {} MB", limit_bytes >> 20U),
          "use fewer threads (--threads 1), or raise the limit (ulimit -v)");
    return fail(status_of(error.code()), error.what(), remedy(error.code()));
  } catch (const std::exception& error) {
    return fail(exit_failed, error.what());
  }
}

Streams streams_of_process(const core::StopFlag& stop) {
  return {std::cout, std::cerr, core::errors_are_on_terminal(), &stop, false, core::output_is_terminal()};
}

}  // namespace

int run_command_line(int argc, const char* const* argv, Streams streams) {
  Program program;
  const int status = guarded(program, std::vector<std::string>(argv + std::min(1, argc), argv + argc), streams);
  streams.err.flush();
  return status;
}

int main_program(int argc, const char* const* argv) {
  core::reserve_standard_streams();
  const core::StopFlag& stop = handle_signals();
  return run_command_line(argc, argv, streams_of_process(stop));
}

int team_program(int argc, const char* const* argv, workflow::Team* team) {
  core::reserve_standard_streams();
  if (team == nullptr) {
    std::cerr << "sarsim-mpi: error: this program was not started by MPI\n"
                 "    start it as mpirun -n P sarsim-mpi run SCENE, or use sarsim run SCENE\n";
    return exit_bad_input;
  }
  const core::StopFlag& stop = handle_signals(ProcessGroup::team);
  const std::vector<std::string> words(argv + std::min(1, argc), argv + argc);
  Program program(*team);
  Streams own = streams_of_process(stop);
  std::ostringstream unread;
  std::ostringstream messages;
  Streams others{unread, messages, false, &stop};
  const int status = guarded(program, words, team->leads() ? own : others);
  if (status == exit_done) return status;
  // Words that one of them does not understand are understood by none.
  if (!program.begun) static_cast<void>(team->agree(workflow::StepEnd::failed));
  const bool tells = !team->leads() && (!team->failure_is_known() || team->speaks()) && received_signal() == 0;
  if (tells) std::cerr << team->name() + ": " + messages.str() << std::flush;
  return status;
}

}  // namespace sarsim::cli

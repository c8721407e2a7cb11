#include <memory>
#include <ostream>
#include <span>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/scene_options.hpp"
#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "workflow/convert/convert_scene.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::cli {

namespace {

struct FormatArguments {
  std::string scene;
  std::string output;
  workflow::SceneOverrides overrides;
  bool in_place = false;
  bool all = false;
  bool upgrade = false;
  bool force = false;
};

void write_file(const std::string& path, bool replace, const std::string& text) {
  core::OutputFile file(path, replace);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
}

ExitStatus format_scene(const FormatArguments& arguments, Streams& streams) {
  const workflow::SceneInput input = workflow::read_scene(
      arguments.scene, arguments.overrides, workflow::CheckLevel::files, {core::thread_count(0), streams.stop});
  workflow::expect_usable(input);
  if (arguments.in_place && input.json)
    throw core::InvalidRequest("--in-place: '" + arguments.scene + "' is JSON, which Sarsim reads but does not write",
                               "write TOML into another file: -o scene.toml");
  if (!arguments.output.empty())
    workflow::expect_free_outputs({arguments.output}, {input.sources, arguments.force, "-o"});
  print_problems(streams, input.problems);
  const bool format_2 = arguments.upgrade || input.language == scene::Language::format_2;
  if (arguments.all && !format_2)
    throw core::InvalidRequest("--all is for format 2: a script in the language of 1998 always contains every field",
                               "add --upgrade, which writes format 2");
  const std::string text =
      workflow::scene_text(input, format_2 ? scene::Language::format_2 : scene::Language::script, arguments.all);
  if (arguments.in_place)
    write_file(arguments.scene, true, text);
  else if (!arguments.output.empty())
    write_file(arguments.output, arguments.force, text);
  else
    write_data(streams, text);
  return exit_done;
}

}  // namespace

Action add_format_command(CLI::App& app) {
  auto arguments = std::make_shared<FormatArguments>();
  add_text(app, "scene", arguments->scene, "SCENE", "scene to rewrite")->required();
  auto* output =
      add_text(app, "-o,--out,--output", arguments->output, "FILE", "file to write (default: standard output)");
  auto* in_place = app.add_flag("--in-place", arguments->in_place, "replace the script itself, all or nothing");
  app.add_flag("--all", arguments->all, "format 2: every field that is at its default too, as a comment");
  app.add_flag("--upgrade", arguments->upgrade, "write format 2, whichever language the script is in");
  app.add_flag("--force", arguments->force, "replace the output file where it exists");
  output->excludes(in_place);
  add_scene_overrides(app, arguments->overrides);
  add_examples(app, {{"sarsim format old.scr", "the script as understood, on standard output"},
                     {"sarsim format old.scr -o new.scr", "into another file"},
                     {"sarsim format scene.toml --targets points.csv --set seed=2 -o more.toml",
                      "with other values and more targets"},
                     {"sarsim format old.scr --in-place", "instead of the old text; its own comments are lost"}});
  return [arguments](Streams& streams) { return format_scene(*arguments, streams); };
}

}  // namespace sarsim::cli

#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/shown_name.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/watch.hpp"
#include "core/build/version.hpp"
#include "core/text/json.hpp"
#include "workflow/record/merge.hpp"

namespace sarsim::cli {

namespace {

struct MergeArguments {
  workflow::MergeRequest request;
  std::string output;
  std::optional<std::int64_t> threads;
  bool json = false;
  bool quiet = false;
};

std::string merge_json(const workflow::MergeReport& report) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).key("products").begin_array();
  if (!report.done_before) cli::write_json(json, report.recording);
  json.end_array().end_object();
  return json.text();
}

ExitStatus run_merge(const MergeArguments& arguments, Streams& streams) {
  workflow::MergeRequest request = arguments.request;
  request.output = arguments.output;
  request.threads = static_cast<unsigned>(arguments.threads.value_or(0));
  Watch watch(streams, arguments.quiet);
  const workflow::MergeReport report = workflow::merge(request, watch.observer());
  watch.close();
  if (!arguments.quiet && report.done_before)
    write_err(streams, fmt::format("{}: complete already, and its parts are gone: nothing to do\n",
                                   shown_name(report.recording.file)));
  if (!arguments.quiet && !report.done_before) {
    workflow::RecordingReport shown = report.recording;
    shown.file = shown_name(shown.file);
    write_err(streams, report_text(shown));
  }
  if (arguments.json) write_out(streams, merge_json(report));
  return exit_done;
}

}  // namespace

Action add_merge(CLI::App& app) {
  auto arguments = std::make_shared<MergeArguments>();
  app.add_option("folders", arguments->request.folders, "folders containing the parts of one recording (NAME.parts)")
      ->required()
      ->type_name("FOLDER");
  add_text(app, "-o,--out,--output", arguments->output, "FILE",
           "file to write (default: NAME beside the first folder)");
  add_integer(app, "--threads", arguments->threads, 0, 4096, "threads; 0 for one per core (default)");
  app.add_flag("--force", arguments->request.force, "replace the output where it exists");
  app.add_flag("--remove", arguments->request.remove, "remove the parts once they are merged");
  app.add_flag("--json", arguments->json, "a report as JSON on standard output");
  app.add_flag("--quiet", arguments->quiet, "only errors on standard error");
  add_examples(app, {{"sarsim merge out/sim.bin.parts", "parts that were copied into one folder become out/sim.bin"},
                     {"sarsim merge a/sim.bin.parts b/sim.bin.parts -o sim.bin", "from the folders of two machines"}});
  return [arguments](Streams& streams) { return run_merge(*arguments, streams); };
}

}  // namespace sarsim::cli

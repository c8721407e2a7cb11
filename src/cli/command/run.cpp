#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/part_options.hpp"
#include "cli/command/part_report.hpp"
#include "cli/shell/engine_options.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/scene_options.hpp"
#include "cli/shell/watch.hpp"
#include "core/build/version.hpp"
#include "core/text/json.hpp"
#include "core/text/number_text.hpp"
#include "workflow/record/record.hpp"

namespace sarsim::cli {

namespace {

struct RunArguments {
  workflow::RecordRequest request;
  std::string folder = ".";
  std::optional<std::int64_t> threads;
  std::optional<simulate::Engine> engine;
  bool quiet = false;
  bool json = false;
};

workflow::RecordRequest request_of(const RunArguments& arguments, workflow::Team* team) {
  workflow::RecordRequest request = arguments.request;
  request.folder = arguments.folder;
  request.threads = static_cast<unsigned>(arguments.threads.value_or(0));
  request.engine = arguments.engine.value_or(simulate::Engine::automatic);
  request.team = team;
  return request;
}

// Prints what a run comes to: for people as it goes on, as JSON at its end, whatever that is.
class RunPrinter {
 public:
  RunPrinter(const RunArguments& arguments, Streams& streams)
      : arguments_(arguments), streams_(streams), watch_(streams, arguments.quiet) {
    json_.begin_object().member("sarsim", core::program_version).member("script", arguments.request.script);
    json_.key("products").begin_array();
  }

  [[nodiscard]] core::Observer observer() { return watch_.observer(); }

  [[nodiscard]] workflow::RecordEvents events() {
    workflow::RecordEvents events;
    events.found = [this](const core::Problems& problems) { found_ = problems; };
    events.made = [this](const workflow::ProductReport& product) { print(product); };
    events.rejected = [this](const std::filesystem::path& file, std::size_t rows) {
      watch_.close();
      write_err(streams_,
                fmt::format("{}: {} pulses do not match the journal and are recomputed\n", file.string(), rows));
    };
    events.kept = [this](const std::filesystem::path& file, const std::filesystem::path& folder) {
      watch_.close();
      write_err(streams_, fmt::format("{}: finished work is kept in {}; continue with --resume\n", file.string(),
                                      folder.string()));
    };
    return events;
  }

  /// Leaves errors alone where only they are wanted.
  [[nodiscard]] core::Problems shown(core::Problems problems) const {
    if (arguments_.quiet && core::has_errors(problems))
      std::erase_if(problems, [](const core::Problem& p) { return p.severity != core::Severity::error; });
    return problems;
  }

  /// Ends the report of a run that was refused; errors that were found say why, where there are any.
  void finish_refused(const core::InvalidRequest& refused) {
    finish(word_of(status_of(refused)), core::has_errors(found_) ? shown(found_) : refused.problems);
  }
  void finish(const char* status) { finish(status, found_); }

 private:
  void finish(const char* status, const core::Problems& problems) {
    watch_.close();
    if (!arguments_.json) return;
    json_.end_array().member("status", status).key("problems");
    cli::write_json(json_, problems);
    json_.end_object();
    write_out(streams_, json_.text());
    flush_out(streams_);
  }

  void print(const workflow::ProductReport& product) {
    watch_.close();
    if (product.part) cli::write_json(json_, *product.part);
    if (product.recording) cli::write_json(json_, *product.recording);
    if (product.table) cli::write_json(json_, *product.table);
    if (arguments_.quiet) return;
    if (product.part) write_err(streams_, part_text(*product.part));
    if (product.recording) write_err(streams_, report_text(*product.recording));
    if (product.table)
      write_err(streams_, fmt::format("{}: geometry table of {}, {}\n", product.path.string(), product.table->radar,
                                      core::bytes_text(product.table->bytes)));
  }

  const RunArguments& arguments_;
  Streams& streams_;
  Watch watch_;
  core::Problems found_;
  core::JsonWriter json_;
};

ExitStatus run(const RunArguments& arguments, Streams& streams, workflow::Team* team) {
  RunPrinter printer(arguments, streams);
  try {
    static_cast<void>(workflow::record(request_of(arguments, team), printer.observer(), printer.events()));
  } catch (core::InvalidRequest& error) {
    error.problems = printer.shown(std::move(error.problems));
    printer.finish_refused(error);
    throw;
  } catch (const core::Interrupted&) {
    printer.finish("interrupted");
    throw;
  } catch (const std::system_error& error) {
    printer.finish(word_of(status_of(error.code())));
    throw;
  } catch (const std::exception&) {
    printer.finish(word_of(exit_failed));
    throw;
  }
  printer.finish(word_of(exit_done));
  return exit_done;
}

void add_run_options(CLI::App& app, RunArguments& a) {
  add_text(app, "-o,--out", a.folder, "DIR|FILE",
           "folder for the outputs, created if missing (default: the current one); or the file of a single recording, "
           "whose extension sets the format");
  add_format(app, "--format", a.request.overrides.format, "format of all recordings, with its extension");
  add_engine(app, a.engine, "engine that sums the echoes (default: auto, the faster one); all stay within --tolerance");
  add_text(app, "--simd", a.request.simd, "LEVEL",
           "instruction set to use (avx512, avx2, sse4, ...), for the same bytes on other processors");
  add_integer(app, "--threads", a.threads, 0, 4096, "threads; 0 for one per core (default); never changes a byte");
  add_scene_overrides(app, a.request.overrides);
  app.add_flag("--force", a.request.force, "replace files that exist");
  app.add_flag("--keep-paths", a.request.keep_paths, "keep the folders of output names");
  app.add_flag("--double", a.request.doubles, "in HDF5, NPY, Zarr and SigMF: volts in double precision (complex128)");
  app.add_flag("--quantise,--counts", a.request.counts,
               "in HDF5, NPY, Zarr and SigMF: counts of the A/D converter instead of volts");
  app.add_flag("--header", a.request.header, "a header line in CSV");
  app.add_flag("--json", a.json, "a report as JSON on standard output");
  app.add_flag("--strict", a.request.strict, "warnings end the run before it begins (status 2)");
  app.add_flag("--quiet", a.quiet, "only errors on standard error");
  app.add_flag("--discard", a.request.discard, "compute and encode everything, write nothing");
  add_part_options(app, a.request.part);
}

}  // namespace

Action add_run(CLI::App& app, workflow::Team* team) {
  auto arguments = std::make_shared<RunArguments>();
  add_text(app, "scene", arguments->request.script, "SCENE", "scene to simulate")->required();
  app.add_option("products", arguments->request.products,
                 "which products: numbers of simulations from 1, or output names (default: all)")
      ->type_name("NUMBER|NAME");
  add_run_options(app, *arguments);
  add_examples(app,
               {{"sarsim run sar_r.toml", "all outputs of the scene"},
                {"sarsim run sar_r.toml 2 --out results", "its second recording, into another folder"},
                {"sarsim run sar_r.toml 1 --out echoes.npy", "its first recording, as this file"},
                {"sarsim run sar_r.toml --format hdf5 --force", "volts as HDF5, replacing older files"},
                {"sarsim run old.scr --profile classic", "as the program of 1998 computed it"},
                {"sarsim run sar_r.toml --part 3/8", "the third of eight shares, on any machine that sees the folder"},
                {"sarsim run sar_r.toml --resume", "with a journal; the same command continues an interrupted run"}});
  return [arguments, team](Streams& streams) { return run(*arguments, streams, team); };
}

}  // namespace sarsim::cli

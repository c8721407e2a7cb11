#include "cli/command/sweep_arguments.hpp"

#include "cli/shell/engine_options.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/request_options.hpp"
#include "workflow/sweep/sweep_options.hpp"

namespace sarsim::cli {

void add_sweep_arguments(CLI::App& app, SweepArguments& a) {
  workflow::SweepRequest& request = a.words.request;
  add_text(app, "scene", a.scene, "SCENE", "scene to vary")->required();
  app.add_option("products", request.products,
                 "which products: numbers of simulations from 1, or output names (default: all)")
      ->type_name("NUMBER|NAME");
  add_table_options(app, workflow::common_sweep_options(), a.words);
  app.add_option("--let", a.let, "a name of [let] and its values, as for --set: speed=200,250,300m/s; repeat")
      ->type_name("NAME=VALUES")
      ->allow_extra_args(false);
  add_format(app, "--format", request.overrides.format, "format of all recordings, with its extension");
  add_engine(app, a.engine, "engine that sums the echoes, as for run");
  add_text(app, "--simd", a.simd, "LEVEL", "instruction set to use, as for run");
  app.add_flag("--fields", a.fields, "print the fields that can be set, with their values, and end");
  app.add_flag("--dry-run", a.dry_run, "check every variation, print what would run, and end");
  app.add_flag("--commands", a.commands, "with --dry-run: print a 'sarsim run' command for each variation instead");
  app.add_flag("--json", a.json, "the table as JSON on standard output, too");
  app.add_flag("--quiet", a.quiet, "only errors on standard error");
}

}  // namespace sarsim::cli

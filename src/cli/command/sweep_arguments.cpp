#include "cli/command/sweep_arguments.hpp"

#include <fmt/format.h>

#include "cli/shell/context.hpp"
#include "cli/shell/engine_options.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/scene_options.hpp"
#include "workflow/sweep/sweep_axes.hpp"

namespace sarsim::cli {

void add_sweep_arguments(CLI::App& app, SweepArguments& a) {
  add_text(app, "scene", a.scene, "SCENE", "scene to vary")->required();
  app.add_option("products", a.products,
                 "which products: numbers of simulations from 1, or output names (default: all)")
      ->type_name("NUMBER|NAME");
  app.add_option(
         "--set", a.values.settings,
         "a field and its values: x, a,b,c, start:step:end, first..last, or random ones as normal(1, 0.2); repeat for "
         "combinations")
      ->type_name("FIELD=VALUES")
      ->allow_extra_args(false);
  app.add_option("--let", a.let, "a name of [let] and its values, as for --set: speed=200,250,300m/s; repeat")
      ->type_name("NAME=VALUES")
      ->allow_extra_args(false);
  add_text(app, "--values", a.table_of_values, "CSV",
           "table of values: a column for each field, a line for each variation");
  app.add_flag("--zip", a.values.paired, "pair all values instead of combining them");
  add_integer(app, "--draws", a.draws, 1, workflow::most_variations, "how many random values are drawn");
  app.add_flag("--fields", a.fields, "print the fields that can be set, with their values, and end");
  app.add_flag("--dry-run", a.dry_run, "check every variation, print what would run, and end");
  app.add_flag("--commands", a.commands, "with --dry-run: print a 'sarsim run' command for each variation instead");
  app.add_flag("--focus", a.follow_up.focus, "focus each recording to an image, NAME.img");
  app.add_flag("--measure", a.follow_up.measure, "measure each image against theory: columns of the table");
  app.add_flag("--search", a.follow_up.search, "make a picture and detections of each recording: columns of the table");
  app.add_flag("--profiles", a.follow_up.profiles, "make range profiles of each recording: columns of the table");
  app.add_option("--with", a.follow_up.with, "options of --focus, --search or --profiles, in quotes")
      ->type_name("OPTIONS");
  add_text(app, "-o,--out", a.folder, "DIR", "folder for all files; made when missing (default: the current one)");
  add_text(app, "--table", a.table, "NAME", "name of the tables and the journal (default: sweep)");
  add_integer(app, "--jobs", a.jobs, 0, 4096, "variations at a time; 0 for as many as there are threads (default)");
  add_integer(app, "--threads", a.threads, 0, 4096, "threads of all of them; 0 for one per core (default)");
  add_text(app, "--part", a.part, "K/N", "only every Nth variation, from the Kth: a share for one machine of N");
  app.add_flag("--resume", a.resume, "leave out what an earlier run completed");
  add_format(app, "--format", a.overrides.format, "format of all recordings, with its extension");
  add_engine(app, a.engine, "how echoes are added up, as for run");
  add_text(app, "--simd", a.simd, "LEVEL", "instruction set to use, as for run");
  add_run_choices(app, a.overrides);
  app.add_flag("--force", a.force, "replace files that exist");
  app.add_flag("--counts", a.counts, "converter counts instead of volts in HDF5, NPY, Zarr and SigMF");
  app.add_flag("--header", a.header, "a header line in CSV");
  app.add_flag("--discard", a.discard, "write the tables alone, no recordings");
  app.add_flag("--json", a.json, "the table as JSON on standard output, too");
  app.add_flag("--strict", a.strict, "warnings end the sweep before it begins (status 2)");
  app.add_flag("--quiet", a.quiet, "only errors on standard error");
}

}  // namespace sarsim::cli

#include <functional>
#include <memory>
#include <span>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/scene_options.hpp"
#include "core/os/output_file.hpp"
#include "simulate/run/geometry_table.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/recording_options.hpp"
#include "workflow/record/geometry.hpp"

namespace sarsim::cli {

namespace {

struct GeometryArguments {
  workflow::GeometryRequest request;
  std::optional<std::int64_t> columns;
  std::string output;
  bool csv = false;
  bool force = false;
};

void write_tables(const GeometryArguments& arguments, const workflow::GeometryTables& geometry,
                  const std::function<void(std::string_view)>& write, const core::StopFlag* stop) {
  for (std::size_t i = 0; i < geometry.tables.size(); ++i) {
    if (i > 0) write("\n");
    arguments.csv ? simulate::write_geometry_csv(geometry.scene, geometry.tables[i], write, stop)
                  : simulate::write_geometry_text(geometry.scene, geometry.tables[i], write, stop);
  }
}

ExitStatus print_geometry(GeometryArguments arguments, Streams& streams) {
  if (arguments.columns) arguments.request.columns = static_cast<int>(*arguments.columns);
  const workflow::GeometryTables geometry =
      workflow::geometry_tables(arguments.request, {core::thread_count(0), streams.stop});
  print_problems(streams, geometry.remarks);
  if (arguments.output.empty()) {
    const auto write = [&](std::string_view piece) { write_data(streams, piece); };
    write_tables(arguments, geometry, write, streams.stop);
    return exit_done;
  }
  workflow::expect_free_outputs({arguments.output}, {geometry.sources, arguments.force, "-o"});
  core::OutputFile file(arguments.output, arguments.force);
  const auto write = [&](std::string_view piece) { file.write(std::as_bytes(std::span(piece))); };
  write_tables(arguments, geometry, write, streams.stop);
  file.commit();
  return exit_done;
}

}  // namespace

Action add_geometry(CLI::App& app) {
  auto arguments = std::make_shared<GeometryArguments>();
  add_text(app, "input", arguments->request.input.path, "SCENE|DATA", "script, or a recording, whose pulses are shown")
      ->required();
  add_table_options(app, workflow::script_file_option(), arguments->request.input);
  auto* numbers =
      app.add_option("numbers", arguments->request.numbers, "which tables of the script, from 1 (default: all)")
          ->type_name("NUMBER");
  add_table_options(app, workflow::geometry_choice_options(), arguments->request);
  numbers->excludes(app.get_option("--radar"));
  add_integer(app, "--columns", arguments->columns, 0, 255, "sum of column bits, see docs/formats/geometry-table.md");
  app.add_flag("--csv", arguments->csv, "comma-separated values, all columns, exact numbers");
  add_text(app, "-o,--out,--output", arguments->output, "FILE", "file to write (default: standard output)");
  app.add_flag("--force", arguments->force, "replace the output file where it exists");
  add_scene_overrides(app, arguments->request.input.overrides);
  add_examples(app, {{"sarsim geometry scene.toml", "the geometry tables of the scene"},
                     {"sarsim geometry sar_r.toml --radar Radar1 --start 0 --end 0.1", "any other pulses"},
                     {"sarsim geometry scene.toml 1 --csv -o table.csv", "for other programs"},
                     {"sarsim geometry sar_r.h5 --no-targets --csv -o track.csv",
                      "the track and attitude of a recording, pulse by pulse"}});
  return [arguments](Streams& streams) { return print_geometry(*arguments, streams); };
}

}  // namespace sarsim::cli

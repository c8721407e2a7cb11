#include <memory>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/doppler_report.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/watch.hpp"
#include "workflow/search/search.hpp"
#include "workflow/search/search_options.hpp"
#include "workflow/search/search_report.hpp"

namespace sarsim::cli {

namespace {

std::string picture_text(const workflow::SearchReport& report) {
  if (!report.picture) return {};
  const signal::PpiGrid& grid = report.picture->grid;
  return fmt::format("{}, {} x {} pixels of {:.4g} m, ", counted(report.picture->scans, "turn"), grid.rows,
                     grid.columns, grid.pixel_m);
}

ExitStatus run_search(const RequestArguments& arguments, Streams& streams) {
  Watch watch(streams, arguments.quiet);
  const workflow::SearchReport report =
      workflow::search(workflow::search_request(arguments.input, arguments.given()), watch.observer());
  watch.close();
  print_report(streams, arguments, report, picture_text(report), workflow::json_of(report));
  return exit_done;
}

}  // namespace

Action add_search(CLI::App& app) {
  auto arguments = std::make_shared<RequestArguments>();
  add_request_arguments(app, workflow::search_option_table().options(), *arguments);
  add_examples(app, {{"sarsim search search_radar.toml", "a picture, search_radar-ppi.img, and a table of detections"},
                     {"sarsim search sim1.h5 --scan 2 --pixel 25 --out turn2.npy", "the second turn, in larger pixels"},
                     {"sarsim search scene.toml --canceller three --interval 8", "what moves"},
                     {"sarsim search scene.toml --no-map --cfar os --json", "detections alone"}});
  return [arguments](Streams& streams) { return run_search(*arguments, streams); };
}

}  // namespace sarsim::cli

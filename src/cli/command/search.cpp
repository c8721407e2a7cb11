#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/doppler_options.hpp"
#include "cli/command/doppler_report.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/watch.hpp"
#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "raster/table/formats.hpp"
#include "workflow/search/search.hpp"
#include "workflow/search/search_checks.hpp"
#include "workflow/search/search_picture.hpp"

namespace sarsim::cli {

namespace {

struct PpiArguments {
  SearchArguments search;
  std::optional<double> pixel_m;
  std::optional<double> extent_m;
  std::optional<double> height_m;
  std::optional<std::int64_t> scan;
};

workflow::PictureArguments picture_arguments(const PpiArguments& a) {
  return {a.pixel_m, a.extent_m, a.height_m,
          a.scan ? std::optional(static_cast<std::size_t>(*a.scan) - 1) : std::nullopt};
}

std::string picture_text(const workflow::SearchReport& report) {
  if (!report.picture) return {};
  const signal::PpiGrid& grid = report.picture->grid;
  return fmt::format("{}, {} x {} pixels of {:.4g} m, ", counted(report.picture->scans, "turn"), grid.rows,
                     grid.columns, grid.pixel_m);
}

void write_picture(core::JsonWriter& json, const workflow::SearchReport& report) {
  if (!report.picture) return;
  const signal::PpiGrid& grid = report.picture->grid;
  json.member("rows", grid.rows).member("columns", grid.columns).member("scans", report.picture->scans);
  json.member("x_first_m", grid.first_x_m).member("x_step_m", grid.pixel_m);
  json.member("y_first_m", grid.first_y_m).member("y_step_m", -grid.pixel_m);
}

ExitStatus run_search(const PpiArguments& arguments, Streams& streams) {
  Watch watch(streams, arguments.search.quiet);
  const workflow::SearchReport report =
      workflow::search({pulse_request(arguments.search), picture_arguments(arguments)}, watch.observer());
  watch.close();
  print_report(streams, arguments.search, report, picture_text(report),
               [&report](core::JsonWriter& json) { write_picture(json, report); });
  return exit_done;
}

}  // namespace

Action add_search(CLI::App& app) {
  auto arguments = std::make_shared<PpiArguments>();
  add_search_arguments(app, arguments->search,
                       fmt::format("picture to write: ENVI (.img, default), or {}", raster::image_extensions()),
                       "while the beam turns by half its width, at most 64");
  add_real(app, "--pixel", arguments->pixel_m, "M",
           "side of a pixel (default: a range sample, or a thousandth of --extent)");
  add_real(app, "--extent", arguments->extent_m, "M",
           "how far the picture reaches from the radar (default: as far as was recorded)");
  add_real(app, "--height", arguments->height_m, "M", "world z of the plane that is shown (default: 0)");
  add_integer(app, "--scan", arguments->scan, 1, std::int64_t{1} << 32,
              "one turn of the antenna, from 1 (default: the largest of all turns in each pixel)");
  add_examples(app, {{"sarsim search search_radar.scr", "a picture, search_radar-ppi.img, and a table of detections"},
                     {"sarsim search sim1.h5 --scan 2 --pixel 25 --out turn2.npy", "the second turn, in larger pixels"},
                     {"sarsim search scene.scr --canceller three --interval 8", "what moves"},
                     {"sarsim search scene.scr --no-map --cfar os --json", "detections alone"}});
  return [arguments](Streams& streams) { return run_search(*arguments, streams); };
}

}  // namespace sarsim::cli

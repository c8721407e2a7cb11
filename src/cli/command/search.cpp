#include <fmt/format.h>

#include "cli/command/doppler_report.hpp"
#include "cli/command/product_command.hpp"
#include "cli/shell/report.hpp"

namespace sarsim::cli {

namespace {

std::string picture_text(const workflow::SearchReport& report) {
  if (!report.picture) return {};
  const signal::PpiGrid& grid = report.picture->grid;
  return fmt::format("{}, {} x {} pixels of {:.4g} m, ", counted(report.picture->scans, "turn"), grid.rows,
                     grid.columns, grid.pixel_m);
}

ProductText text_of_search(const workflow::SearchReport& report, const workflow::SearchRequest& /*request*/) {
  return {text_of_pulses(report, picture_text(report))};
}

}  // namespace

Action add_search(CLI::App& app) {
  return add_product(
      app, workflow::search_product,
      {{"sarsim search search_radar.toml", "a picture, search_radar-ppi.img, and a table of detections"},
       {"sarsim search sim1.h5 --scan 2 --pixel 25 --out turn2.npy", "the second turn, in larger pixels"},
       {"sarsim search scene.toml --canceller three --interval 8", "what moves"},
       {"sarsim search scene.toml --no-map --cfar os --json", "detections alone"}},
      text_of_search);
}

}  // namespace sarsim::cli

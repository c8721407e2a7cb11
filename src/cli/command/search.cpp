#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/doppler_work.hpp"
#include "cli/command/image_writer.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "raster/table/formats.hpp"
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

// One run of the command.
class SearchRun {
 public:
  SearchRun(const PpiArguments& arguments, Streams& streams)
      : arguments_(arguments), streams_(streams), work_(arguments.search, streams, "-ppi") {}

  ExitStatus run() {
    work_.open(workflow::dwell_pulses, [&](const workflow::PulseRows& rows) {
      expect_turns(rows);
      expect_picture();
      if (arguments_.search.no_map) return 0.0;
      const signal::PpiGrid grid = workflow::picture_grid(rows, picture_arguments(arguments_));
      return sizeof(float) * static_cast<double>(grid.rows) * static_cast<double>(grid.columns);
    });
    std::optional<workflow::SearchPicture> picture;
    if (!arguments_.search.no_map) picture.emplace(work_.rows(), picture_arguments(arguments_));
    work_.detect(
        [this](const workflow::SearchInterval& i, const workflow::SearchDetection& d) { return place_of(i, d); },
        [&](const workflow::SearchInterval& interval) {
          if (picture) picture->take(interval);
        });
    if (picture) write(*picture);
    report(picture);
    return exit_done;
  }

 private:
  [[nodiscard]] GroundPlace place_of(const workflow::SearchInterval& interval,
                                     const workflow::SearchDetection& detection) const {
    const core::Vec3& radar_m = interval.radar_world_m;
    const double ground_m = workflow::ground_range_m(detection.range_m, radar_m.z - arguments_.height_m.value_or(0.0));
    return {radar_m.x + ground_m * std::sin(detection.azimuth_rad),
            radar_m.y + ground_m * std::cos(detection.azimuth_rad)};
  }

  // Without a picture nothing asks for these. Heights place detections, too.
  void expect_picture() const {
    if (!arguments_.search.no_map) return;
    const std::pair<const char*, bool> given[] = {{"--pixel", arguments_.pixel_m.has_value()},
                                                  {"--extent", arguments_.extent_m.has_value()},
                                                  {"--scan", arguments_.scan.has_value()}};
    for (const auto& [option, there] : given)
      if (there) throw core::Refused(fmt::format("{} is for the picture", option), "leave it out, or --no-map");
  }

  // Before anything is computed: a rotating antenna says how often it turns, others are followed from pulse to pulse.
  void expect_turns(const workflow::PulseRows& rows) const {
    if (!arguments_.scan) return;
    const radar::Beam& beam = rows.plan->radar.beam;
    if (beam.kind != radar::Beam::Kind::rotating) return expect_turns(workflow::turns_of_beam(rows));
    const radar::Repetition& repetition = rows.plan->radar.repetition;
    const radar::PulseRange& pulses = rows.plan->pulses;
    const double time_s = repetition.send_time_s(pulses.last) - repetition.send_time_s(pulses.first);
    expect_turns(std::floor(std::abs(beam.rate_rad_per_s) * time_s / (2.0 * core::pi) + 1e-9) + 1.0);
  }

  void expect_turns(double turns) const {
    if (!arguments_.scan || static_cast<double>(*arguments_.scan) <= turns) return;
    throw core::Refused(fmt::format("--scan {}: the antenna turns less often", *arguments_.scan),
                        fmt::format("it makes {:.0f}, begun ones counted", turns));
  }

  void write(workflow::SearchPicture& picture) const {
    picture.finish();
    expect_turns(static_cast<double>(picture.scans()));
    const signal::PpiGrid& grid = picture.picture().grid();
    const std::vector<float>& values = picture.picture().values();
    const double largest = static_cast<double>(*std::ranges::max_element(values));
    ImageWriter image(work_.output(), content_of_image(grid), arguments_.search.force, largest);
    std::vector<std::complex<float>> row(grid.columns);
    for (std::size_t r = 0; r < grid.rows; ++r) {
      if (streams_.stop != nullptr && streams_.stop->requested()) throw core::Interrupted();
      for (std::size_t c = 0; c < grid.columns; ++c) row[c] = values[r * grid.columns + c];
      image.append(row);
    }
    image.finish();
  }

  [[nodiscard]] ImageContent content_of_image(const signal::PpiGrid& grid) const {
    const auto number = [](double value) { return fmt::format("{}", value); };
    ImageContent content;
    content.header.lines = grid.rows;
    content.header.samples = grid.columns;
    content.header.pixel = raster::EnviHeader::Pixel::real_float;
    content.header.description =
        fmt::format("Plan position indicator by sarsim {}: lines from north to south, samples from west to east",
                    core::program_version);
    content.header.fields = {{"map", "ppi"},
                             {"x first m", number(grid.first_x_m)},
                             {"x step m", number(grid.pixel_m)},
                             {"y first m", number(grid.first_y_m)},
                             {"y step m", number(-grid.pixel_m)},
                             {"height m", number(arguments_.height_m.value_or(0.0))},
                             {"scan", arguments_.scan ? fmt::format("{}", *arguments_.scan) : std::string("all")}};
    std::ranges::move(work_.origin_fields(), std::back_inserter(content.header.fields));
    content.product.radar = work_.plan().radar.name;
    content.product.column_range_m = [grid](std::size_t column) { return grid.x_m(column); };
    content.product.sample_rate_hz = 1.0 / work_.plan().raw_grid.interval_s;
    content.product.options = work_.plan().scene->options;
    content.product.engine = "search";
    return content;
  }

  void report(const std::optional<workflow::SearchPicture>& picture) {
    std::string text;
    if (picture) {
      const signal::PpiGrid& grid = picture->picture().grid();
      text = fmt::format("{}, {} x {} pixels of {:.4g} m, ", counted(picture->scans(), "turn"), grid.rows, grid.columns,
                         grid.pixel_m);
    }
    work_.report(text, [&](core::JsonWriter& json) {
      if (!picture) return;
      const signal::PpiGrid& grid = picture->picture().grid();
      json.member("rows", grid.rows).member("columns", grid.columns).member("scans", picture->scans());
      json.member("x_first_m", grid.first_x_m).member("x_step_m", grid.pixel_m);
      json.member("y_first_m", grid.first_y_m).member("y_step_m", -grid.pixel_m);
    });
  }

  const PpiArguments& arguments_;
  Streams& streams_;
  PulseWork work_;
};

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
  return [arguments](Streams& streams) { return SearchRun(*arguments, streams).run(); };
}

}  // namespace sarsim::cli

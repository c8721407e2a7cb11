#include "workflow/search/search.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"
#include "workflow/image/image_writer.hpp"
#include "workflow/search/pulse_pipeline.hpp"
#include "workflow/search/search_checks.hpp"

namespace sarsim::workflow {

namespace {

// Without a picture nothing asks for these. Heights place detections, too.
void expect_picture(const SearchRequest& request) {
  if (request.image) return;
  const std::pair<const char*, bool> given[] = {{"--pixel", request.picture.pixel_m.has_value()},
                                                {"--extent", request.picture.extent_m.has_value()},
                                                {"--scan", request.picture.scan.has_value()}};
  for (const auto& [option, there] : given)
    if (there) throw core::InvalidRequest(fmt::format("{} is for the picture", option), "leave it out, or --no-map");
}

void expect_turn(const SearchRequest& request, double turns) {
  if (!request.picture.scan || static_cast<double>(*request.picture.scan + 1) <= turns) return;
  throw core::InvalidRequest(fmt::format("--scan {}: fewer turns are recorded", *request.picture.scan + 1),
                             fmt::format("{:.0f} turns, counting partial ones", turns));
}

double bytes_of_picture(const SearchRequest& request, const PulseRows& rows) {
  if (!request.image) return 0.0;
  const signal::PpiGrid grid = picture_grid(rows, request.picture);
  return sizeof(float) * static_cast<double>(grid.rows) * static_cast<double>(grid.columns);
}

ImageContent content_of_picture(const PulsePipeline& work, const PictureArguments& picture,
                                const signal::PpiGrid& grid) {
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
                           {"height m", number(picture.height_m.value_or(0.0))},
                           {"scan", picture.scan ? fmt::format("{}", *picture.scan + 1) : std::string("all")}};
  std::ranges::move(work.origin_fields(), std::back_inserter(content.header.fields));
  content.product.radar = work.acquisition().link.name;
  content.product.image.rows = "y_m";
  content.product.image.row_m = [grid](std::size_t row) { return grid.y_m(row); };
  content.product.image.columns = "x_m";
  content.product.column_range_m = [grid](std::size_t column) { return grid.x_m(column); };
  content.product.sample_rate_hz = 1.0 / work.acquisition().reception.raw_grid.interval_s;
  content.product.options = work.acquisition().scene->options;
  content.product.engine = "search";
  return content;
}

// @param[out] kept  the picture, where it is not written
PictureReport write_picture(const SearchPicture& picture, const PulsePipeline& work, const SearchRequest& request,
                            const core::StopFlag* stop, std::optional<InMemoryImage>& kept) {
  const signal::PpiGrid& grid = picture.picture().grid();
  const std::vector<float>& values = picture.picture().values();
  const double largest = static_cast<double>(*std::ranges::max_element(values));
  ImageContent content = content_of_picture(work, request.picture, grid);
  ImageWriter image = work.keeps_image() ? ImageWriter(std::move(content))
                                         : ImageWriter(work.output(), std::move(content), request.replace, largest);
  std::vector<std::complex<float>> row(grid.columns);
  for (std::size_t r = 0; r < grid.rows; ++r) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    for (std::size_t c = 0; c < grid.columns; ++c) row[c] = values[r * grid.columns + c];
    image.append(row);
  }
  image.finish();
  if (work.keeps_image()) kept = std::move(image).kept();
  return {grid, picture.scans()};
}

}  // namespace

SearchReport search(const SearchRequest& request, const core::Observer& observer) {
  PulsePipeline work(request, observer, "-ppi");
  work.open(dwell_pulses, [&](const PulseRows& rows) {
    if (request.picture.scan) expect_turn(request, turns_to_come(rows));
    expect_picture(request);
    return bytes_of_picture(request, rows);
  });
  std::optional<SearchPicture> picture;
  if (request.image) picture.emplace(work.rows(), request.picture);
  const double height_m = request.picture.height_m.value_or(0.0);
  work.detect([height_m](const SearchInterval& i, const SearchDetection& d) { return place_of(i, d, height_m); },
              [&](const SearchInterval& interval) {
                if (picture) picture->take(interval);
              });
  SearchReport report;
  std::optional<InMemoryImage> kept;
  if (picture) {
    picture->finish();
    expect_turn(request, static_cast<double>(picture->scans()));
    report.picture = write_picture(*picture, work, request, observer.stop, kept);
  }
  static_cast<PulseReport&>(report) = work.report();
  report.kept = std::move(kept);
  return report;
}

}  // namespace sarsim::workflow

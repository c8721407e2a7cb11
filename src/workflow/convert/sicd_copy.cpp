#include "workflow/convert/sicd_copy.hpp"

#include <algorithm>
#include <complex>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "raster/format/envi.hpp"
#include "raster/sicd/sicd_writer.hpp"
#include "scene/model/world_frame.hpp"
#include "workflow/convert/copied_image.hpp"
#include "workflow/focus/image_collection.hpp"
#include "workflow/image/image_script.hpp"
#include "workflow/image/sicd_image.hpp"
#include "workflow/input/earth_place.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/override_words.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

struct CopiedImage {
  std::shared_ptr<const raster::Raster> file;
  raster::EnviHeader header;
  signal::FocusedImage image;
  ImageOrigin origin;
};

CopiedImage opened_image(const ConvertRequest& request, const core::Observer& observer) {
  CopiedImage opened;
  const raster::RasterHints hints = hints_for(request.input, {}, {}, observer);
  opened.file = open_samples(request.input, hints, observer).file;
  auto header = header_beside(request.input, *opened.file);
  if (!header || !header->field("image plane"))
    throw core::InvalidRequest(fmt::format("'{}' is not a focused image, and a SICD file is one", request.input),
                               "name an image of sarsim focus, in ENVI, NPY or HDF5; or focus into .nitf");
  if (is_of_magnitudes(*header))
    throw core::InvalidRequest(fmt::format("'{}' holds magnitudes, and a SICD file has phases", request.input),
                               "name the complex image beside it");
  opened.header = *std::move(header);
  read_header(opened.header, request.input, opened.image, opened.origin);
  return opened;
}

// The recording that the image was made from, for its plan and its track.
FocusInput recorded(const CopiedImage& opened, const ConvertRequest& request, const core::Observer& observer,
                    const core::WorkControl& control) {
  WayBack way = way_back(opened.header, opened.origin, request.input, request.sample.script, observer.stop);
  observer.remarks(way.problems);
  RecordingArguments arguments;
  arguments.path = way.source;
  arguments.script = way.script;
  arguments.simulation = request.simulation.value_or(static_cast<std::int64_t>(opened.origin.simulation) + 1);
  arguments.overrides = overrides_from_words(opened.origin.settings);
  return open_focus_input(arguments, control);
}

void copy_rows(const CopiedImage& opened, raster::SicdWriter& writer, const core::StopFlag* stop) {
  std::vector<std::complex<float>> row(opened.file->columns());
  for (std::size_t r = 0; r < opened.file->rows(); ++r) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    opened.file->read_window({r, 1, 0, row.size(), 1, 1}, row);
    writer.append(row);
  }
  writer.finish();
}

}  // namespace

ConvertReport convert_to_sicd(const ConvertRequest& request, const core::Observer& observer) {
  if (request.to || request.counts || request.header)
    throw core::InvalidRequest("--to, --counts and --header are for files of samples, and a SICD file is an image",
                               "leave them out");
  const core::WorkControl control = observer.control(core::thread_count(0));
  const CopiedImage opened = opened_image(request, observer);
  OutputCare care{{request.input}, request.force, "OUT"};
  expect_free_outputs({request.output}, care);
  const FocusInput input = recorded(opened, request, observer, control);
  care.sources.add(input.sources);
  expect_free_outputs({request.output}, care);
  const EarthPlace place = earth_place(input.world, request.anchor, "SICD");
  const ImageMaking making{opened.image, opened.origin.options, opened.origin.algorithm == "back-projection"};
  ImageOrigin origin = opened.origin;
  origin.radar = input.acquisition->link.name;
  const raster::EnviHeader header = header_of_copy(opened.header, request.input, request.output, false);
  const SicdImage sicd = sicd_of(opened.image, origin, collection_of(input, making, place, control), header,
                                 fs::path(request.output).stem().string());
  raster::SicdWriter writer(request.output, sicd.description, sicd.backwards, request.force);
  copy_rows(opened, writer, observer.stop);
  ConvertReport report;
  report.files = {request.output};
  report.rows = sicd.description.rows;
  report.columns = sicd.description.columns;
  report.remarks = place.remarks;
  return report;
}

}  // namespace sarsim::workflow

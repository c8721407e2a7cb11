#include <memory>
#include <string>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/scene_options.hpp"
#include "cli/shell/watch.hpp"
#include "core/report/invalid_request.hpp"
#include "workflow/convert/convert.hpp"
#include "workflow/convert/convert_options.hpp"
#include "workflow/convert/convert_scene.hpp"
#include "workflow/convert/references.hpp"
#include "workflow/exchange/export_options.hpp"
#include "workflow/input/earth_place.hpp"
#include "workflow/input/override_words.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::cli {

namespace {

struct ConvertArguments {
  workflow::ConvertRequest samples;
  std::string references;
  std::string anchor;
  workflow::SceneOverrides overrides;
  workflow::ExportRequest exchange;
};

// The options that only files of the standards CPHD and CRSD have.
void expect_no_exchange_options(const ConvertArguments& arguments) {
  const std::pair<const char*, bool> given[] = {{"--encoding", arguments.exchange.encoding.has_value()},
                                                {"--reference-point", arguments.exchange.reference.has_value()}};
  for (const auto& [option, there] : given)
    if (there)
      throw core::InvalidRequest(fmt::format("{} is for CPHD and CRSD files", option),
                                 "leave it out, or give OUT the extension .cphd or .crsd");
}

ExitStatus export_recording(const ConvertArguments& arguments, Streams& streams) {
  const workflow::ConvertRequest& samples = arguments.samples;
  if (samples.to || samples.counts || samples.header || samples.sample.format || samples.sample.columns ||
      samples.sample.bits || samples.sample.lsb_v)
    throw core::InvalidRequest(
        fmt::format("'{}' is made from a recording and its scene: only --script and --simulation apply",
                    samples.output),
        "leave out --to, --counts, --header, --from, --columns, --bits and --lsb");
  workflow::ExportRequest request = arguments.exchange;
  request.input = {samples.input, samples.sample.script, samples.simulation, arguments.overrides};
  request.input.dataset = samples.sample.dataset;
  request.output = samples.output;
  if (!arguments.anchor.empty()) request.anchor = workflow::anchor_from_text(arguments.anchor, "--anchor");
  request.force = samples.force;
  Watch watch(streams, false);
  workflow::export_recording(request, watch.observer());
  return exit_done;
}

// Either OUT or --references, which writes no samples.
void expect_one_output(const ConvertArguments& arguments) {
  const workflow::ConvertRequest& request = arguments.samples;
  if (arguments.references.empty()) {
    if (request.output.empty())
      throw core::InvalidRequest("OUT is missing: no output file is given",
                                 "name the new file, or references to this one with --references");
    return;
  }
  if (!request.output.empty())
    throw core::InvalidRequest(
        fmt::format("--references writes no samples, but '{}' was to be written", request.output),
        "leave it out; references to a new file are made when it is there");
  if (request.to || request.counts || request.header)
    throw core::InvalidRequest("--references leaves the samples unchanged: --to, --counts and --header have no effect",
                               "leave them out");
  if (workflow::holds_script(request.input))
    throw core::InvalidRequest(fmt::format("--references: '{}' is a scene, not a file of samples", request.input),
                               "name the file that the scene wrote, in HDF5 or NPY");
}

ExitStatus write_references(const ConvertArguments& arguments, Streams& streams) {
  const workflow::ConvertRequest& request = arguments.samples;
  Watch watch(streams, false);
  workflow::write_references({request.input, arguments.references, request.sample, request.force}, watch.observer());
  return exit_done;
}

ExitStatus run_convert(const ConvertArguments& arguments, Streams& streams) {
  const workflow::ConvertRequest& request = arguments.samples;
  expect_one_output(arguments);
  if (!arguments.references.empty()) return write_references(arguments, streams);
  if (workflow::is_exchange_file(request.output)) return export_recording(arguments, streams);
  expect_no_exchange_options(arguments);
  if (workflow::holds_script(request.input)) {
    print_problems(streams, workflow::convert_scene({request.input, request.output, arguments.overrides, request.force},
                                                    {core::thread_count(0), streams.stop}));
    return exit_done;
  }
  if (!workflow::words_of_overrides(arguments.overrides).empty())
    throw core::InvalidRequest("a file of samples has no fields that could be set",
                               "give a scene and an OUT that ends with .toml or .scr, or leave --set and its like out");
  Watch watch(streams, false);
  core::Observer observer = watch.observer();
  observer.progress = {};  // A copy is soon done.
  workflow::ConvertRequest placed = request;
  if (!arguments.anchor.empty()) placed.anchor = workflow::anchor_from_text(arguments.anchor, "--anchor");
  print_problems(streams, workflow::convert(placed, observer).remarks);
  return exit_done;
}

}  // namespace

Action add_convert(CLI::App& app) {
  auto arguments = std::make_shared<ConvertArguments>();
  workflow::ConvertRequest* const request = &arguments->samples;
  add_text(app, "input", request->input, "IN", "file of samples, or a scene")->required();
  add_text(app, "output", request->output, "OUT", "file to write");
  add_table_options(app, workflow::sample_option_table(), request->sample);
  add_scene_overrides(app, arguments->overrides);
  add_integer(app, "--simulation", request->simulation, 1, 1'000'000,
              "which simulation of the script wrote the file (default: the one that names it)");
  add_table_options(app, workflow::convert_option_table(), *request);
  add_text(app, "--anchor", arguments->anchor, "LAT,LON,HEIGHT[,HEADING]",
           "SICD, CPHD and CRSD of a flat scene: where its origin is on the Earth (degrees, m above the ellipsoid), "
           "and the heading of +y");
  add_text(app, "--references", arguments->references, "JSON",
           "instead of OUT: byte offsets of the arrays of IN, as JSON for Zarr readers (fsspec, xarray)");
  add_table_options(app, workflow::exchange_option_table(), arguments->exchange);
  add_examples(app,
               {{"sarsim convert sim1.h5 sim1.csv", "volts to counts, with the bits and LSB of the file"},
                {"sarsim convert sim1.bin sim1.npy --script scene.scr", "shape, bits and LSB from the script"},
                {"sarsim convert sim1.asc sim1.h5 --lsb 1e-9", "counts to volts"},
                {"sarsim convert sim1.h5 sim1.zarr", "a folder of files, for object stores and xarray"},
                {"sarsim convert sim1.h5 sim1.sigmf-meta", "for software-radio programs"},
                {"sarsim convert sim1.h5 --references sim1.json", "to open the same bytes as Zarr"},
                {"sarsim convert sar_r.img copy.npy", "an image, with its header copy.hdr"},
                {"sarsim convert sar_r.img sar_r.nitf --anchor -33.9,18.4,120", "an image as SICD"},
                {"sarsim convert flight.toml flight.cphd --anchor -33.9,18.4,0", "simulate into the standard CPHD"},
                {"sarsim convert old.scr new.toml", "a scene from the language of 1998 into format 2, or back"}});
  return [arguments](Streams& streams) { return run_convert(*arguments, streams); };
}

}  // namespace sarsim::cli

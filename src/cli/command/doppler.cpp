#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/doppler_report.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/watch.hpp"
#include "workflow/search/doppler.hpp"
#include "workflow/search/search_options.hpp"
#include "workflow/search/search_report.hpp"

namespace sarsim::cli {

namespace {

std::string maps_text(const workflow::DopplerReport& report) {
  const std::string ranges =
      fmt::format("{} ranges {:.1f} to {:.1f} m, ", report.columns, report.range_first_m, report.range_last_m);
  if (!report.doppler()) return ranges;
  return fmt::format("{} frequencies {:.4g} Hz ({:.4g} m/s) apart x ", report.rows, report.doppler_step_hz,
                     std::abs(report.speed_step_mps)) +
         ranges;
}

ExitStatus run_doppler(const RequestArguments& arguments, Streams& streams) {
  Watch watch(streams, arguments.quiet);
  const workflow::DopplerReport report =
      workflow::doppler(workflow::doppler_request(arguments.input, arguments.given()), watch.observer());
  watch.close();
  print_report(streams, arguments, report, maps_text(report), workflow::json_of(report));
  return exit_done;
}

}  // namespace

Action add_doppler(CLI::App& app) {
  auto arguments = std::make_shared<RequestArguments>();
  add_request_arguments(app, workflow::doppler_option_table().options(), *arguments);
  add_examples(app, {{"sarsim doppler mti.toml --canceller two", "moving targets: mti-doppler.img and its detections"},
                     {"sarsim doppler sim1.h5 --interval 128 --step 64 --window hamming", "overlapping intervals"},
                     {"sarsim doppler sim1.bin --script scene.toml --out maps.npy", "a file without its script"},
                     {"sarsim doppler mti.toml --cfar os --train 12:2 --pfa 1e-5", "another detector"}});
  return [arguments](Streams& streams) { return run_doppler(*arguments, streams); };
}

}  // namespace sarsim::cli
